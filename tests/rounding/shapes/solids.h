/// \file
/// Solids of all kinds as boundaries: dents, holes, cavities, parts that touch.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "booleans/boolean.h"
#include "rounding/shapes/polyhedron.h"
#include "rounding/shapes/primitives.h"
#include "tests/rounding/support.h"

namespace quoin::rounding::testing {

using booleans::Body;
using booleans::Rule;
using grid::Lattice;

inline Vector normal(const WidePlane& p) { return {p.n[0], p.n[1], p.n[2]}; }
inline Polyhedron made(const Result<Polyhedron>& r) {
  EXPECT_TRUE(r.has_value()) << r.error().message;
  return r ? r.value() : Polyhedron{};
}
inline Body combined(Rule rule, const std::vector<Body>& bodies, std::uint32_t negated_from = booleans::none) {
  std::vector<const Body*> operands;
  for (const Body& b : bodies) operands.push_back(&b);
  auto r = booleans::evaluate(
      operands, booleans::Expression::flat(rule, static_cast<std::uint32_t>(bodies.size()), negated_from));
  EXPECT_TRUE(r.has_value());
  return r ? std::move(r).value() : Body{};
}
inline Body box(std::array<std::int32_t, 3> low, std::array<std::int32_t, 3> high) {
  return booleans::box_body({low}, {high});
}

/// A solid's faces one after the other, points found again.
inline void append(Polyhedron& p, const Polyhedron& q) {
  std::vector<std::uint32_t> id;
  for (const Vector& v : q.points) {
    const auto at = std::find(p.points.begin(), p.points.end(), v);
    id.push_back(at != p.points.end() ? static_cast<std::uint32_t>(at - p.points.begin()) : p.add_point(v));
  }

  for (std::uint32_t f = 0; f < q.face_count(); ++f) {
    p.planes.push_back(q.planes[f]);
    p.faces.face_start.push_back(p.faces.face_start.back());
    for (std::uint32_t j = q.faces.face_start[f]; j < q.faces.face_start[f + 1]; ++j) {
      std::vector<std::uint32_t> loop;
      for (const std::uint32_t v : q.faces.loop(j)) loop.push_back(id[v]);
      p.add_loop(loop);
    }
  }
}
inline Polyhedron shifted(Polyhedron p, const Vector& by) {
  const AffineMap back{AffineMap{}.linear, Rational(-1) * by};
  for (Vector& v : p.points) v = v + by;
  for (WidePlane& plane : p.planes) plane = moved(plane, back);
  return p;
}
inline Polyhedron cube() { return made(block({1, 1, 1})); }

inline const std::vector<Body>& bodies() {
  static const std::vector<Body> all{
      box({0, 0, 0}, {3, 2, 1}),
      // A plane that cuts a corner off; an oblique half.
      booleans::half_space_body({{1, 2, 3}, -20}, {{0, 0, 0}}, {{7, 7, 7}}),
      booleans::half_space_body({{7, -11, 5}, 13}, {{-9, -9, -9}}, {{9, 9, 9}}),
      // A hole through it, a dent in a face, a cavity, two parts.
      combined(Rule::all, {box({0, 0, 0}, {9, 9, 9}), box({2, 2, -1}, {4, 5, 10})}, 1),
      combined(Rule::all, {box({0, 0, 0}, {9, 9, 9}), box({2, 2, 5}, {4, 5, 10})}, 1),
      combined(Rule::all, {box({0, 0, 0}, {9, 9, 9}), box({2, 2, 2}, {4, 5, 6})}, 1),
      combined(Rule::any, {box({0, 0, 0}, {1, 1, 1}), box({5, 0, 0}, {6, 2, 1})}),
      // Touching in an edge, in a vertex, in an edge inside a face, in a vertex inside a face.
      combined(Rule::any, {box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1})}),
      combined(Rule::any, {box({0, 0, 0}, {1, 1, 1}), box({1, 1, 1}, {2, 2, 2})}),
      combined(Rule::any,
               {box({-9, -9, -2}, {9, 9, 0}),
                combined(Rule::all, {booleans::half_space_body({{1, 0, -1}, 0}, {{-5, -5, -5}}, {{5, 5, 5}}),
                                     booleans::half_space_body({{-1, 0, -1}, 0}, {{-5, -5, -5}}, {{5, 5, 5}})})}),
      combined(Rule::any,
               {box({-9, -9, -2}, {9, 9, 0}),
                combined(Rule::all, {booleans::half_space_body({{2, 1, -1}, 0}, {{-5, -5, -5}}, {{5, 5, 5}}),
                                     booleans::half_space_body({{-2, 1, -1}, 0}, {{-5, -5, -5}}, {{5, 5, 5}}),
                                     booleans::half_space_body({{0, -1, -1}, 0}, {{-5, -5, -5}}, {{5, 5, 5}})})}),
  };
  return all;
}

}  // namespace quoin::rounding::testing
