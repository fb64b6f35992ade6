#include "booleans/arrangement/check.h"

#include <cstdio>
#include <cstdlib>
#include <map>

#include "booleans/arrangement/frame.h"
#include "booleans/body/fault.h"

namespace quoin::booleans {
namespace {

void require(bool holds, const char* law) {
  if (holds) return;
  std::fprintf(stderr, "quoin: internal check failed: %s\n", law);
  std::abort();
}

}  // namespace

void check(const Touched& touched, const Names& names) {
  for (const TouchedId t : Ids<TouchedId>(touched.faces.size())) {
    const PlaneId plane = touched.faces[t].plane;
    std::map<VertexId, int> balance;
    for (const BoundaryEdge& e : touched.edges_of(t)) {
      require(!exact::parallel(names.planes[plane], names.planes[e.other]),
              "an edge has two planes that are not parallel");
      for (const VertexId v : {e.from, e.to})
        require(names.side(v, plane) == 0 && names.side(v, e.other) == 0, "an edge lies on both its planes");
      ++balance[e.from];
      --balance[e.to];
    }
    for (const auto& [v, sum] : balance) require(sum == 0, "the boundary of a face is closed");
  }
}

void check(const Sheet& sheet, const Names& names) {
  const Frame frame(names.planes[sheet.plane]);
  const auto on = [&](VertexId v, PlaneId p) { return names.side(v, p) == 0; };
  for (const Sheet::Element& e : sheet.elements) {
    require(on(e.a, sheet.plane) && on(e.b, sheet.plane), "an element lies on its sheet");
    require(on(e.a, e.line) && on(e.b, e.line), "an element lies on its line");
    require(frame.compare(names.vertices, e.a, e.b) < 0, "an element runs forward");
  }

  std::vector<std::uint8_t> reached(sheet.clockwise.size());
  for (std::uint32_t h = 0; h < sheet.clockwise.size(); ++h) {
    const std::uint32_t next = sheet.clockwise[h];
    require(sheet.origin(next) == sheet.origin(h), "turning keeps the origin");
    require(!reached[next], "turning permutes the half-edges");
    reached[next] = 1;
    require(sheet.facet[sheet.clockwise[h ^ 1]] == sheet.facet[h], "a loop has one facet on its left");
  }
  for (const FacetId f : Ids<FacetId>(sheet.facet_count())) require(!sheet.covers(f).empty(), "every facet is covered");
}

void check(const Arrangement& a) {
  if (!a.operands.are_clean) return;  // there an edge also has faces that are glued, not used
  a.uses.for_edges([&](VertexId, std::span<const Use> uses) {
    std::map<OperandId, int> change;
    for (const Use& u : uses) {
      // Passing the facet counter-clockwise goes from its front to its back where it lies right of the edge.
      const int way = u.left() ? -1 : 1;
      a.for_jumps(u.node(), [&](OperandId operand, int by) { change[operand] += way * by; });
    }
    for (const auto& [operand, sum] : change) require(sum == 0, "the labels around an edge close up");
  });
}

void check(const Body& body) {
  const auto message = fault(body, exact::world + 1);
  require(!message, message ? message->c_str() : "");
  std::uint32_t next = 0;
  for (const Chunk& c : body.chunks) {
    require((body.is_packed ? c.begin == next : c.begin >= next) && c.begin < c.end, "chunks follow each other");
    require((c.begin < body.triangles.size()) == (c.end <= body.triangles.size()), "a chunk has faces of one tier");
    for (std::uint32_t f = c.begin; f < c.end; ++f) {
      Box sum = c.box;
      sum.add(face_box(body, f));
      require(sum.low == c.box.low && sum.high == c.box.high, "a chunk's box holds its faces");
    }
    next = c.end;
  }
  require((body.is_packed && body.chunks.empty()) || next <= body.face_count(), "faces of chunks are there");
  require(!body.is_packed || body.chunks.empty() || next == body.face_count(), "chunks hold all faces");
}

}  // namespace quoin::booleans
