/// \file
/// Rays of an arrangement, by rational numbers.
#pragma once

#include "booleans/classify/shooter.h"
#include "exact/rational.h"
#include "tests/booleans/stages.h"

namespace quoin::booleans::testing {

using exact::Rational;

/// Directed edges: the polygon is on the left, seen from the front of its node.
using Edges = std::vector<std::array<exact::Point, 2>>;
struct Polygon {
  NodeId node;
  Edges edges;
};

/// A shift t that is small enough for all small coordinates.
inline const Rational& small_shift() {
  static const Rational& t = *new Rational(1, exact::Integer(1) << 1500);
  return t;
}

/// The place of a ray's start in (x, z), for a t that is small enough.
inline std::array<Rational, 2> shifted(const RayStart& s) {
  const Rational& t = small_shift();
  const Rational dx(exact::to_integer(s.d[0])), dz(exact::to_integer(s.d[2]));
  return {Rational(exact::coordinate(s.v, 0) + t * dx + t * t * t * t),
          Rational(exact::coordinate(s.v, 2) + t * dz - t * t * t)};
}

/// Is the place in a polygon in (x, z), of directed edges? By the edges above it.
inline bool is_in(const std::array<Rational, 2>& place, const Edges& edges) {
  bool odd = false;
  for (const auto& [p, q] : edges) {
    const Rational px = exact::coordinate(p, 0), qx = exact::coordinate(q, 0);
    if ((px > place[0]) == (qx > place[0])) continue;
    const Rational pz = exact::coordinate(p, 2), qz = exact::coordinate(q, 2);
    odd ^= pz + (qz - pz) / (qx - px) * (place[0] - px) > place[1];
  }
  return odd;
}

/// Every facet and untouched face, in the order of targets everywhere, with its node and edges, spared loops among
/// them.
inline std::vector<Polygon> polygons_of(const Arrangement& a) {
  std::vector<Polygon> all;
  for (const OperandChunk& c : a.operands.chunks)
    for (const FaceId f : Ids<FaceId>(c.begin, c.end)) {
      if (a.touched.is_touched(f)) continue;
      auto& edges = all.emplace_back(Polygon{a.patches().of[f], {}}).edges;
      const Body& body = a.operands[c.operand];
      body.for_edges(a.operands.own(c.operand, f), [&](std::uint32_t u, std::uint32_t v) {
        edges.push_back({body.point(u), body.point(v)});
      });
    }
  for (const NodeId n : Ids<NodeId>(a.sheets.facet_count())) {
    auto& edges = all.emplace_back(Polygon{n, {}}).edges;
    const Sheet& sheet = a.sheets[a.sheets.sheet_of(n)];
    for (std::uint32_t h = 0; h < sheet.half_edges(); ++h)
      if (sheet.facet[h] == a.sheets.facet_of(n))
        edges.push_back({a.names.vertices.point(sheet.origin(h)), a.names.vertices.point(sheet.target(h))});
    for (const SparedFace& s : a.sheets.spared(n)) {
      const Body& body = a.operands[a.touched.faces[s.face].operand];
      for (const std::uint32_t loop : a.touched.spared_of(s.face))
        grid::for_loop_edges(body.polygons.loop(loop), [&](std::uint32_t u, std::uint32_t v) {
          edges.push_back({body.point(u), body.point(v)});
        });
    }
  }
  return all;
}

/// The normal of a polygon towards its front, of any length.
inline std::array<Rational, 3> normal_of(const Edges& edges) {
  std::array<Rational, 3> n;
  for (const auto& [p, q] : edges)
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      n[static_cast<std::size_t>(k)] +=
          exact::coordinate(p, i) * exact::coordinate(q, j) - exact::coordinate(p, j) * exact::coordinate(q, i);
    }
  return n;
}

/// The side on which the ray from s towards -y comes down first; none when it reaches infinity.
inline SideId first_below(const std::vector<Polygon>& polygons, const RayStart& s) {
  const auto place = shifted(s);
  const Rational& t = small_shift();
  const Rational start = exact::coordinate(s.v, 1) + t * Rational(exact::to_integer(s.d[1])) - t * t;
  SideId hit = none;
  Rational highest;
  for (const Polygon& p : polygons) {
    if (!is_in(place, p.edges)) continue;
    const auto n = normal_of(p.edges);
    if (n[1] == 0) continue;
    const exact::Point& on = p.edges[0][0];
    const Rational y =
        exact::coordinate(on, 1) -
        (n[0] * (place[0] - exact::coordinate(on, 0)) + n[2] * (place[1] - exact::coordinate(on, 2))) / n[1];
    if (y >= start || (hit != none && y <= highest)) continue;
    highest = y;
    hit = n[1] > 0 ? front_of(p.node) : back_of(p.node);
  }
  return hit;
}

}  // namespace quoin::booleans::testing
