/// \file
/// Random solids that coincide, touch and nearly miss each other, random expressions over them, and the second way to
/// evaluate those.
///
/// Every random case has a generator of its own, made of the run's seed (QUOIN_SEED, else 1; printed), the test's salt
/// and the case's number: any case can be repeated alone.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <stdexcept>
#include <string>

#include "booleans/body/canonical.h"
#include "booleans/body/fault.h"
#include "booleans/body/measure.h"
#include "booleans/boolean.h"
#include "tests/booleans/shapes.h"

namespace quoin::booleans::testing {

inline std::uint64_t seed() {
  static const std::uint64_t value = [] {
    const char* text = std::getenv("QUOIN_SEED");
    const std::uint64_t s = text != nullptr ? std::strtoull(text, nullptr, 10) : 1;
    std::printf("QUOIN_SEED=%llu\n", static_cast<unsigned long long>(s));
    return s;
  }();
  return value;
}

/// How many cases a law is shown on: QUOIN_CASES, or what suits a test run.
inline std::uint64_t case_count(std::uint64_t usual) {
  const char* text = std::getenv("QUOIN_CASES");
  return text != nullptr ? std::strtoull(text, nullptr, 10) : usual;
}

/// Are the thresholds those of users, so that a test may ask which way was taken?
inline bool usual_thresholds() { return std::getenv("QUOIN_THRESHOLDS") == nullptr; }

/// splitmix64: the same numbers with every standard library.
class Random {
 public:
  Random(std::uint64_t salt, std::uint64_t number) : state_(seed()) {
    state_ = next() ^ salt;
    state_ = next() ^ number;
  }
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  std::uint64_t below(std::uint64_t n) { return next() % n; }
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(high - low + 1)));
  }
  bool one_in(std::uint64_t n) { return below(n) == 0; }
  Vector vector(std::int64_t low, std::int64_t high) {
    return {between(low, high), between(low, high), between(low, high)};
  }

 private:
  std::uint64_t state_;
};

/// The case's address, for SCOPED_TRACE.
inline std::string case_name(std::uint64_t number) {
  return "QUOIN_SEED=" + std::to_string(seed()) + ", case " + std::to_string(number);
}

/// The value, which must be without fault.
inline Body sound(Result<Body> result) {
  if (!result) throw std::runtime_error(to_string(result.error().code) + ": " + result.error().message);
  Body body = std::move(result).value();
  if (const auto message = fault(body)) throw std::runtime_error("a result has a fault: " + *message);
  return body;
}
inline Body evaluated(std::span<const Body> operands, const Expression& expression) {
  std::vector<const Body*> pointers;
  for (const Body& b : operands) pointers.push_back(&b);
  return sound(evaluate(pointers, expression));
}
inline Body combined(Rule rule, std::initializer_list<const Body*> operands, std::uint32_t negated_from = none) {
  const std::vector<const Body*> pointers(operands);
  return sound(evaluate(pointers, Expression::flat(rule, static_cast<std::uint32_t>(pointers.size()), negated_from)));
}
inline Body any(const Body& a, const Body& b) { return combined(Rule::any, {&a, &b}); }
inline Body all(const Body& a, const Body& b) { return combined(Rule::all, {&a, &b}); }
inline Body minus(const Body& a, const Body& b) { return combined(Rule::all, {&a, &b}, 1); }
inline Body odd(const Body& a, const Body& b) { return combined(Rule::odd, {&a, &b}); }

/// Equal point sets.
inline bool same(const Body& a, const Body& b) { return canonical(a) == canonical(b); }
inline bool empty(const Body& a) { return a.face_count() == 0 && !a.full_at_infinity; }

/// The worlds that random solids come from.
enum class Family {
  tiny,     // coordinates 0 .. 2: nearly everything coincides
  lattice,  // coordinates 0 .. 4
  skew,     // coordinates -6 .. 6, no axis-parallel faces to speak of
  far,      // the lattice in a corner of the world
  world,    // from one end of the world to the other, with slivers of one step
  spheres,  // dented spheres of some dozens of faces, and blocks among them
};
inline constexpr std::array<Family, 6> families{Family::tiny, Family::lattice, Family::skew,
                                                Family::far,  Family::world,   Family::spheres};
inline const char* name_of(Family f) {
  static constexpr std::array<const char*, 6> names{"tiny", "lattice", "skew", "far", "world", "spheres"};
  return names[static_cast<std::size_t>(f)];
}

/// Random solids of one family; those of one generator share their lattice, so they coincide.
class Solids {
 public:
  Solids(Random& random, Family family) : random_(random), family_(family) {
    const std::int64_t w = exact::world;
    if (family == Family::far)
      for (auto& x : origin_) x = random.one_in(2) ? w - 4 : -w;
    static constexpr std::int64_t e = exact::world;
    static constexpr std::array<std::array<std::int64_t, 5>, 4> scales{
        {{-e, -e / 2, 0, e / 2, e}, {-e, -e + 1, 0, e - 1, e}, {-e, -1, 0, 1, e}, {-e, -e / 3, 7, e / 3 + 1, e - 2}}};
    for (auto& scale : scale_) scale = scales[random.below(scales.size())];
  }

  /// A raw mesh.
  Body raw() {
    for (;;)
      if (auto body = placed()) return *body;
  }
  /// A raw mesh, or one time in four a Boolean of two.
  Body next() {
    if (!random_.one_in(4)) return raw();
    const Body a = raw(), b = raw();
    switch (random_.below(3)) {
      case 0:
        return any(a, b);
      case 1:
        return all(a, b);
      default:
        return minus(a, b);
    }
  }

 private:
  std::optional<Body> placed() {
    switch (family_) {
      case Family::tiny:
        return shape(0, 2);
      case Family::lattice:
        return shape(0, 4);
      case Family::skew:
        return skew();
      case Family::far: {
        const auto body = shape(0, 4);
        return body ? moved(*body, origin_) : std::nullopt;
      }
      case Family::world:
        return spread();
      case Family::spheres:
        return random_.one_in(3) ? hewn() : dented();
    }
    return std::nullopt;
  }

  std::optional<Body> axis_box(std::int64_t low, std::int64_t high) {
    Vector p{}, q{};
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = random_.between(low, high - 1);
      q[k] = random_.between(p[k] + 1, high);
    }
    return box(p, q);
  }
  std::optional<Body> any_tetrahedron(std::int64_t low, std::int64_t high) {
    std::array<Vector, 4> p;
    for (Vector& v : p) v = random_.vector(low, high);
    return tetrahedron(p);
  }
  std::optional<Body> any_l(std::int64_t high) {
    const std::int64_t x = random_.between(1, high - 1), y = random_.between(1, high - 1);
    const Body l =
        l_shape({x, y}, {random_.between(x + 1, high), random_.between(y + 1, high)}, 0, random_.between(1, high));

    // One of the 48 symmetries of the cube, moved back to where it came from.
    std::array<Vector, 3> columns{};
    Vector origin{};
    const std::size_t turn = random_.below(3), swap = random_.below(2);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = swap == 1 && i < 2 ? (1 - i + turn) % 3 : (i + turn) % 3;
      const bool mirrored = random_.one_in(2);
      columns[i][k] = mirrored ? -1 : 1;
      if (mirrored) origin[k] = high;
    }
    return mapped(l, origin, columns);
  }

  std::optional<Body> shape(std::int64_t low, std::int64_t high) {
    const std::int64_t step = high > 2 ? 2 : 1;
    switch (random_.below(8)) {
      case 0:
        return any_tetrahedron(low, high);
      case 1:
      case 2:
        return axis_box(low, high);
      case 3:
        return fitting(prism(random_.vector(low, high), random_.vector(low, high), random_.vector(low, high),
                             random_.vector(-step, step)),
                       low, high);
      case 4:
        return fitting(block(random_.vector(low, high), random_.vector(-step, step), random_.vector(-step, step),
                             random_.vector(-step, step)),
                       low, high);
      case 5:
        return fitting(octahedron(random_.vector(low, high), random_.vector(-step, step), random_.vector(-step, step),
                                  random_.vector(-step, step)),
                       low, high);
      case 6: {  // the regular one: its edges lie in the planes of the lattice
        const std::int64_t r = random_.between(1, step);
        return fitting(octahedron(random_.vector(low, high), {r, 0, 0}, {0, r, 0}, {0, 0, r}), low, high);
      }
      default:
        return any_l(high);
    }
  }
  static std::optional<Body> fitting(std::optional<Body> body, std::int64_t low, std::int64_t high) {
    if (body)
      for (const exact::GridPoint& p : body->grid_points)
        for (std::int32_t x : p.c)
          if (x < low || x > high) return std::nullopt;
    return body;
  }

  std::optional<Body> skew() {
    switch (random_.below(4)) {
      case 0:
        return any_tetrahedron(-6, 6);
      case 1:
        return block(random_.vector(-4, 4), random_.vector(-3, 3), random_.vector(-3, 3), random_.vector(-3, 3));
      case 2:
        return octahedron(random_.vector(-3, 3), random_.vector(-4, 4), random_.vector(-4, 4), random_.vector(-4, 4));
      default:
        return prism(random_.vector(-6, 6), random_.vector(-6, 6), random_.vector(-6, 6), random_.vector(-4, 4));
    }
  }

  /// The lattice 0 .. 4 stretched over the world: boxes and tetrahedra unevenly, all else evenly.
  std::optional<Body> spread() {
    if (random_.one_in(3)) {
      const auto body = shape(0, 4);
      const std::int64_t w = exact::world;
      return body ? scaled(*body, w / 2, {-w, -w, -w}) : std::nullopt;
    }

    const auto point = [&](const exact::GridPoint& p) {
      Vector v{};
      for (std::size_t k = 0; k < 3; ++k) v[k] = scale_[k][static_cast<std::size_t>(p.c[k])];
      return v;
    };
    if (random_.one_in(2)) {
      const Body b = *axis_box(0, 4);
      return box(point(b.grid_points[0]), point(b.grid_points[b.grid_points.size() - 1]));
    }

    const auto body = any_tetrahedron(0, 4);
    if (!body) return std::nullopt;
    const std::array<Vector, 4> p{point(body->grid_points[0]), point(body->grid_points[1]), point(body->grid_points[2]),
                                  point(body->grid_points[3])};
    return tetrahedron(p);
  }

  std::optional<Body> dented() {
    const auto rings = static_cast<std::uint32_t>(random_.between(3, 7));
    const auto segments = static_cast<std::uint32_t>(random_.between(3, 9));
    const double size = static_cast<double>(random_.between(200, 1000)),
                 dent = static_cast<double>(random_.between(0, 6)) / 10;
    return sphere(random_.vector(-400, 400), rings, segments, [&](std::uint32_t, std::uint32_t) {
      return size * (1 - dent * static_cast<double>(random_.below(1000)) / 1000);
    });
  }
  std::optional<Body> hewn() {
    return block(random_.vector(-600, 600), random_.vector(-700, 700), random_.vector(-700, 700),
                 random_.vector(-700, 700));
  }

  Random& random_;
  Family family_;
  Vector origin_{};
  std::array<std::array<std::int64_t, 5>, 3> scale_;
};

inline void grow_expression(Random& random, Expression& expression, std::uint32_t operands, std::uint32_t parent,
                            int depth) {
  const bool negated = random.one_in(4);
  if (depth == 0 || (parent != none && random.one_in(3))) {
    expression.add({Rule::operand, negated, static_cast<std::uint32_t>(random.below(operands)), parent});
    return;
  }
  static constexpr std::array<Rule, 3> rules{Rule::any, Rule::all, Rule::odd};
  const std::uint32_t self = expression.add({rules[random.below(3)], negated, 0, parent});
  const std::uint64_t children = 2 + random.below(2);
  for (std::uint64_t i = 0; i < children; ++i) grow_expression(random, expression, operands, self, depth - 1);
}
/// A random tree whose leaves may repeat.
inline Expression random_expression(Random& random, std::size_t operands, int depth) {
  Expression e;
  grow_expression(random, e, static_cast<std::uint32_t>(operands), none, depth);
  return e;
}

/// The second way: the tree's value when operand i is true where `inside` says so.
template <class Inside>
bool holds(const Expression& e, Inside&& inside, std::uint32_t node = 0) {
  const auto& n = e.nodes[node];
  if (n.rule == Rule::operand) return bool(inside(n.operand)) != n.negated;
  std::size_t children = 0, trues = 0;
  for (std::uint32_t c = node + 1; c < e.nodes.size(); ++c) {
    if (e.nodes[c].parent != node) continue;
    ++children;
    trues += holds(e, inside, c);
  }
  const bool value = n.rule == Rule::any ? trues > 0 : n.rule == Rule::all ? trues == children : trues % 2 == 1;
  return value != n.negated;
}

/// The second way: the tree one operation of two bodies after another.
inline Body pairwise(const Expression& e, std::span<const Body> operands, std::uint32_t node = 0) {
  const auto& n = e.nodes[node];
  std::optional<Body> value;
  if (n.rule == Rule::operand) value = operands[n.operand];
  for (std::uint32_t c = node + 1; c < e.nodes.size(); ++c) {
    if (e.nodes[c].parent != node) continue;
    const Body next = pairwise(e, operands, c);
    value = value ? combined(n.rule, {&*value, &next}) : next;
  }
  return n.negated ? complement(*value) : *value;
}

}  // namespace quoin::booleans::testing
