#include "rounding/reconstruction/conditions.h"

#include <algorithm>
#include <cmath>

#include "booleans/body/fault.h"
#include "booleans/embedding.h"
#include "exact/predicates.h"
#include "exact/rational.h"

namespace quoin::rounding {
namespace {

bool in_world(const exact::Point& p) {
  return std::all_of(p.x.begin(), p.x.end(), [&](const exact::Numerator& x) {
    return abs(exact::to_integer(x)) <= exact::to_integer(p.w) * exact::world;
  });
}

/// A grid point in the form of grid points.
exact::Point in_grid_form(const exact::Point& p) {
  exact::GridPoint g{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = p.approximation[k];
    if (x != std::floor(x) || std::fabs(x) > exact::world) return p;
    g.c[k] = static_cast<std::int32_t>(x);
  }
  const exact::Point q = exact::point(g);
  return exact::compare_lexicographic(p, q) == 0 ? q : p;
}

}  // namespace

std::optional<Violation> meet_vertices(const Trihedral& t, int turn, booleans::Boundary& boundary) {
  for (std::uint32_t v = 0; v < t.faces.size(); ++v) {
    const auto& [f, g, h] = t.faces[v];
    const exact::Plane &p = boundary.planes[f], &q = boundary.planes[g], &r = boundary.planes[h];
    if (exact::turn(p, q, r) != turn * t.sign[v])
      return Violation{Violation::Kind::shape, v, h, "three planes that meet in a vertex would turn round"};

    boundary.vertices.push_back(in_grid_form(*exact::meet(p, q, r)));
    if (!in_world(boundary.vertices.back())) return Violation{Violation::Kind::world, v, booleans::none, {}};
  }
  return std::nullopt;
}

std::optional<Violation> order_violation(const Trihedral& t, const booleans::Boundary& boundary) {
  for (const Trihedral::Order& order : t.orders)
    if (exact::side(boundary.planes[order.face], boundary.vertices[order.from]) != order.side)
      return Violation{Violation::Kind::shape, order.from, order.face,
                       "the vertices of an edge would change their order"};
  return std::nullopt;
}

std::optional<Violation> crossing_violation(const booleans::Body& body) {
  auto fault = booleans::fault(body);
  if (!fault) fault = booleans::embedding_fault(body);
  if (!fault) return std::nullopt;
  return Violation{Violation::Kind::shape, booleans::none, booleans::none, *fault};
}

}  // namespace quoin::rounding
