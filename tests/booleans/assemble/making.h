/// \file
/// Results in the making, step by step, and what their vertices are.
#pragma once

#include <vector>

#include "booleans/assemble/making.h"
#include "tests/booleans/stages.h"

namespace quoin::booleans::testing {

/// A result that shares the lists of `host` (none: of no operand), its copies not yet made.
struct Made {
  Arrangement a;
  Selection selection;
  Making m;

  /// The bodies must outlive it.
  Made(std::span<const Body> bodies, const Expression& e, OperandId host = none)
      : a(arranged(bodies)), selection(select(a, find_cells(a), e)), m(a, selection, host) {}
  Made(const Made&) = delete;
  Made& operator=(const Made&) = delete;
};

/// Numbers for points: equal ones for equal points, whoever has them.
class PointNumbers {
 public:
  std::uint32_t of(const Body& body, std::uint32_t v) { return table_.id(body, v).value; }
  /// Of what has a name in a body in the making.
  std::uint32_t of(const Body& body, ResultName name) {
    return name.is_derived() ? table_.id(body.points[name.index()]).value
                             : table_.id(body.grid_points[name.index()]).value;
  }
  /// Of a vertex of the arrangement's table.
  std::uint32_t of(const Arrangement& a, VertexId v) { return table_.id(a.names.vertices.point(v)).value; }

 private:
  VertexTable table_;
};

}  // namespace quoin::booleans::testing
