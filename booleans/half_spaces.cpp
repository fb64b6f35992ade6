#include "booleans/half_spaces.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <optional>

#include "booleans/body/locate.h"
#include "exact/predicates.h"
#include "exact/rational.h"

namespace quoin::booleans {

using exact::Integer;

namespace {

/// The values of an expression's operands, where they are known.
enum class Truth : std::uint8_t { no, yes, unknown };

constexpr Truth truth(bool v) { return v ? Truth::yes : Truth::no; }

/// The values of all nodes.
std::vector<Truth> values(const Expression& expression, const std::vector<Truth>& operands) {
  const auto& nodes = expression.nodes;
  struct Count {
    std::uint32_t all = 0, yes = 0, unknown = 0;
  };
  std::vector<Count> children(nodes.size());
  std::vector<Truth> result(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const auto& node = nodes[i];
    const Count& c = children[i];
    Truth v = c.unknown > 0 ? Truth::unknown : truth(c.yes % 2 == 1);
    if (node.rule == Rule::operand) v = operands[node.operand];
    if (node.rule == Rule::any) v = c.yes > 0 ? Truth::yes : c.unknown > 0 ? Truth::unknown : Truth::no;
    if (node.rule == Rule::all) v = c.yes + c.unknown < c.all ? Truth::no : c.unknown > 0 ? Truth::unknown : Truth::yes;
    if (node.negated && v != Truth::unknown) v = truth(v == Truth::no);
    result[i] = v;
    if (i == 0) continue;
    Count& up = children[node.parent];
    ++up.all;
    up.yes += v == Truth::yes;
    up.unknown += v == Truth::unknown;
  }
  return result;
}

/// An operand that the value of the root waits for. Precondition: the root is unknown.
std::uint32_t awaited_operand(const Expression& expression, const std::vector<Truth>& value_of) {
  const auto& nodes = expression.nodes;
  std::vector<bool> awaited(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    awaited[i] = value_of[i] == Truth::unknown && (i == 0 || awaited[nodes[i].parent]);
    if (awaited[i] && nodes[i].rule == Rule::operand) return nodes[i].operand;
  }
  return none;
}

using Vector4 = std::array<Integer, 4>;  // (x, y, z, w), w >= 0; w = 0 is a direction

/// A pointed full-dimensional cone in (x, y, z, w): a convex region of space with the directions in which it is
/// unbounded. Constraints have numbers; no two of them are proportional.
struct Cone {
  struct Ray {
    Vector4 v;
    std::vector<std::uint32_t> tight;  // constraints that hold with equality, ascending
  };
  std::vector<Ray> rays;
};

/// The part of the outside of the cube nearest to its face x_axis = sign * half_width. Constraints 0 .. 5.
Cone outside_of_face(std::size_t axis, int sign, std::int32_t half_width) {
  Cone cone;
  for (const bool at_infinity : {false, true})
    for (const int p : {-1, 1})
      for (const int q : {-1, 1}) {
        Cone::Ray ray;
        const Integer size = at_infinity ? 1 : half_width;
        ray.v[axis] = sign * size;
        ray.v[(axis + 1) % 3] = p * size;
        ray.v[(axis + 2) % 3] = q * size;
        ray.v[3] = at_infinity ? 0 : 1;
        ray.tight = {at_infinity ? 1u : 0u, p > 0 ? 2u : 3u, q > 0 ? 4u : 5u};
        cone.rays.push_back(std::move(ray));
      }
  return cone;
}

Integer value_at(const exact::Plane& plane, const Vector4& v) {
  return plane.n[0] * v[0] + plane.n[1] * v[1] + plane.n[2] * v[2] + exact::to_integer(plane.d) * v[3];
}

/// The ray between two neighbouring ones where the plane is zero.
Cone::Ray between(const Cone::Ray& a, const Integer& at_a, const Cone::Ray& b, const Integer& at_b,
                  std::vector<std::uint32_t> tight) {
  Cone::Ray ray;
  ray.tight = std::move(tight);
  const Integer p = abs(at_b), q = abs(at_a);
  Integer content = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    ray.v[k] = a.v[k] * p + b.v[k] * q;
    content = gcd(content, ray.v[k]);
  }
  for (auto& x : ray.v) x /= content;
  return ray;
}

/// The parts where the plane is <= 0 and >= 0; a part without interior has no rays. `id` is the plane's number.
std::array<Cone, 2> divided(const Cone& cone, const exact::Plane& plane, std::uint32_t id) {
  std::vector<Integer> at;
  bool below = false, above = false;
  for (const auto& ray : cone.rays) {
    at.push_back(value_at(plane, ray.v));
    below = below || at.back() < 0;
    above = above || at.back() > 0;
  }
  if (!above) return {cone, Cone{}};
  if (!below) return {Cone{}, cone};
  std::array<Cone, 2> parts;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i] != 0) {
      parts[at[i] < 0 ? 0 : 1].rays.push_back(cone.rays[i]);
      continue;
    }
    for (Cone& part : parts) {
      part.rays.push_back(cone.rays[i]);
      part.rays.back().tight.push_back(id);
    }
  }
  // Two extreme rays of a cone in four dimensions span a face exactly when two independent constraints hold them both.
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i] >= 0) continue;
    for (std::size_t j = 0; j < at.size(); ++j) {
      if (at[j] <= 0) continue;
      const auto &s = cone.rays[i].tight, &t = cone.rays[j].tight;
      std::vector<std::uint32_t> both;
      std::set_intersection(s.begin(), s.end(), t.begin(), t.end(), std::back_inserter(both));
      if (both.size() < 2) continue;
      both.insert(std::upper_bound(both.begin(), both.end(), id), id);
      const Cone::Ray ray = between(cone.rays[i], at[i], cone.rays[j], at[j], std::move(both));
      for (Cone& part : parts) part.rays.push_back(ray);
    }
  }
  for (Cone& part : parts)
    for (auto& ray : part.rays) std::sort(ray.tight.begin(), ray.tight.end());
  return parts;
}

/// The value of the expression where operand i has the value operands[i], in Kleene's three-valued logic: `unknown`
/// may stand for an expression that is constant all the same.
Truth value(const Expression& expression, const std::vector<Truth>& operands) {
  return values(expression, operands)[0];
}

/// The value that the expression has everywhere outside the cube |x|, |y|, |z| <= half_width, but for a set of measure
/// zero; nothing when it takes both values there: then the surface reaches out of the cube or is infinite.
/// Operand i < solids.size() has the value solids[i] there, operand solids.size() + j is the half-space
/// planes[j] <= 0. Exact. Planes are distinct and reduced, and of two opposite ones only one is there.
/// A cancelled search returns some value.
std::optional<bool> value_outside(const Expression& expression, const std::vector<Truth>& solids,
                                  const std::vector<exact::Plane>& planes, std::int32_t half_width,
                                  const std::atomic<bool>* cancel) {
  // Divides the outside by one awaited half-space after the other until the expression is constant in every part.
  struct Part {
    Cone cone;
    std::vector<Truth> operands;
  };
  std::vector<Truth> start = solids;
  start.resize(solids.size() + planes.size(), Truth::unknown);
  std::vector<Part> parts;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int sign : {-1, 1}) parts.push_back({outside_of_face(axis, sign, half_width), start});

  Truth found = Truth::unknown;
  while (!parts.empty()) {
    if (cancel && cancel->load(std::memory_order_relaxed)) return false;
    Part part = std::move(parts.back());
    parts.pop_back();
    const auto value_of = values(expression, part.operands);
    if (value_of[0] != Truth::unknown) {
      if (found != Truth::unknown && found != value_of[0]) return std::nullopt;
      found = value_of[0];
      continue;
    }

    const std::uint32_t operand = awaited_operand(expression, value_of);
    const auto plane = operand - static_cast<std::uint32_t>(solids.size());
    auto halves = divided(part.cone, planes[plane], 6 + plane);
    for (std::size_t side = 0; side < 2; ++side) {
      if (halves[side].rays.empty()) continue;
      Part half{std::move(halves[side]), part.operands};
      half.operands[operand] = truth(side == 0);
      parts.push_back(std::move(half));
    }
  }
  return found == Truth::yes;
}

/// rule(expression, operand), the operand perhaps complemented.
Expression joined(Rule rule, const Expression& expression, std::uint32_t operand, bool negated) {
  Expression result;
  result.nodes.reserve(expression.nodes.size() + 2);
  result.add({rule, false, 0, none});
  for (auto node : expression.nodes) {
    node.parent = node.parent == none ? 0 : node.parent + 1;
    result.add(node);
  }
  result.add({Rule::operand, negated, operand, 0});
  return result;
}

/// Strictly contains the faces of all solids.
std::array<exact::GridPoint, 2> box_around(const std::vector<const Body*>& bodies) {
  Box all;
  for (const Body* body : bodies)
    if (const auto box = bounds(*body)) all.add(*box);
  if (all.low[0] > all.high[0]) all.add(exact::GridPoint{{0, 0, 0}});
  std::array<exact::GridPoint, 2> r{};
  for (std::size_t k = 0; k < 3; ++k) {
    r[0].c[k] = all.low[k] - 1;
    r[1].c[k] = all.high[k] + 1;
  }
  return r;
}

}  // namespace

Result<void> clip_half_spaces(Expression& expression, const std::vector<exact::Plane>& planes,
                              std::vector<const Body*>& operands, std::vector<Body>& storage,
                              const std::atomic<bool>* cancel) {
  std::vector<Truth> far;
  for (const Body* body : operands) far.push_back(body->full_at_infinity ? Truth::yes : Truth::no);
  auto with_unknowns = far;
  with_unknowns.resize(far.size() + planes.size(), Truth::unknown);

  auto box = box_around(operands);
  const bool is_open = value(expression, with_unknowns) == Truth::unknown;
  if (is_open) {
    const auto outside = value_outside(expression, far, planes, exact::world, cancel);
    if (!outside)
      return Error{
          ErrorCode::unbounded,
          "half-spaces leave an infinite surface here, or one that reaches beyond the world of +-2^29 steps of "
          "the grid; intersect with a bounded solid, or choose a coarser grid"};
    constexpr std::int32_t reach = exact::world + 1;
    box = {exact::GridPoint{{-reach, -reach, -reach}}, exact::GridPoint{{reach, reach, reach}}};
    // The clipped half-spaces say nothing outside the box: there the value is set.
    const auto box_operand = static_cast<std::uint32_t>(operands.size() + planes.size());
    expression = joined(*outside ? Rule::any : Rule::all, expression, box_operand, *outside);
  }

  storage.reserve(planes.size() + 1);
  for (const auto& plane : planes) storage.push_back(half_space_body(plane, box[0], box[1]));
  if (is_open) storage.push_back(box_body(box[0], box[1]));
  for (const Body& body : storage) operands.push_back(&body);
  return {};
}

}  // namespace quoin::booleans
