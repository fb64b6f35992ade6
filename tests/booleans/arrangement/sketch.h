/// \file
/// Sketches on one plane: what a sheet is drawn from, made by hand instead of by solids.
#pragma once

#include "booleans/arrangement/outline.h"
#include "booleans/arrangement/sheets.h"
#include "exact/rational.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {

/// Faces, segments and points on a plane. Its points are given by two coordinates, counter-clockwise as seen from the
/// canonical normal.
class Sketch {
 public:
  using Place = std::array<std::int64_t, 2>;
  using RationalPlace = std::array<exact::Rational, 2>;
  using Loop = std::vector<Place>;

  /// The plane z = 0, or the one at `origin` that u and v span (v and u, if those see the canonical normal).
  Sketch() : Sketch({0, 0, 0}, {1, 0, 0}, {0, 1, 0}) {}
  Sketch(const Vector& origin, const Vector& u, const Vector& v) : origin_(origin), u_(u), v_(v) {
    exact::Plane p = *exact::plane_through(grid(origin), grid(origin + u), grid(origin + v));
    if (!exact::is_canonical(p)) {
      std::swap(u_, v_);
      p = p.opposite();
    }
    plane = names.planes.id(p);
  }

  VertexId vertex(const Place& p) { return names.vertices.id(grid(at(p))); }

  void add_segment(const Place& p, const Place& q) {
    contacts.segments.push_back({plane, vertex(p), vertex(q), line(p, q)});
  }
  void add_point(const Place& p) { contacts.points.push_back({plane, vertex(p)}); }
  /// The face that loops as seen from the canonical normal have on their left, which looks along that or the other way.
  TouchedId add_face(const std::vector<Loop>& loops, bool along, const Loop& isolated = {}) {
    TouchedFace face{};
    face.operand = touched.faces.next_id().value;
    face.plane = plane;
    face.along = along;
    face.edges_begin = static_cast<std::uint32_t>(touched.edges.size());
    face.isolated_begin = static_cast<std::uint32_t>(touched.isolated.size());

    for (const Loop& loop : loops)
      grid::for_loop_edges(loop, [&](const Place& p, const Place& q) {
        touched.edges.push_back({vertex(along ? p : q), vertex(along ? q : p), line(p, q)});
      });
    for (const Place& p : isolated) touched.isolated.push_back(vertex(p));

    face.edges_end = static_cast<std::uint32_t>(touched.edges.size());
    face.isolated_end = static_cast<std::uint32_t>(touched.isolated.size());
    return touched.faces.add(face);
  }

  /// All of that as an outline whose points have names.
  Outline outline() {
    Outline outline;
    OutlineMaker maker(touched, names, plane, outline);
    for (const TouchedId t : Ids<TouchedId>(touched.faces.size())) maker.add_face(t);
    for (const ContactSegment& s : contacts.segments) maker.add_segment(s);
    for (const ContactPoint& p : contacts.points) maker.add_point(p.vertex);
    maker.find_splits();
    outline.name_points(names.vertices);
    return outline;
  }
  /// And as a sheet. Precondition: there is a face.
  Sheets sheets() { return draw_sheets(touched, contacts, names); }

  /// Where a vertex is: p - origin = x u + y v.
  RationalPlace place(VertexId vertex) const {
    const exact::Point point = names.vertices.point(vertex);
    std::array<exact::Rational, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = exact::coordinate(point, static_cast<int>(k)) - origin_[k];

    // Two coordinates tell, if u and v differ there.
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const exact::Rational det = exact::Rational(u_[i]) * v_[j] - exact::Rational(u_[j]) * v_[i];
      if (det == 0) continue;
      return {exact::Rational((p[i] * v_[j] - p[j] * v_[i]) / det),
              exact::Rational((p[j] * u_[i] - p[i] * u_[j]) / det)};
    }
    return {};
  }

  Names names;
  PlaneId plane;
  Touched touched;
  Contacts contacts;

 private:
  static exact::GridPoint grid(const Vector& p) {
    return {{static_cast<std::int32_t>(p[0]), static_cast<std::int32_t>(p[1]), static_cast<std::int32_t>(p[2])}};
  }
  Vector at(const Place& p) const { return origin_ + p[0] * u_ + p[1] * v_; }
  PlaneId line(const Place& p, const Place& q) {
    return names.planes.id(exact::upright_plane(grid(at(p)), grid(at(q)), names.planes[plane]));
  }

  Vector origin_, u_, v_;
};

inline std::string text_of(const Sketch::RationalPlace& p) {
  return "(" + exact::to_string(p[0]) + ", " + exact::to_string(p[1]) + ")";
}

/// A sketch on one of some planes: upright, steep, with a normal whose longest component is negative, far away.
inline Sketch any_sketch(Random& random) {
  static constexpr std::int64_t w = exact::world;
  static constexpr std::array<std::array<Vector, 3>, 6> planes{{
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
      {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}},
      {{{5, 0, 0}, {0, 0, 1}, {0, 1, 0}}},
      {{{0, 0, 0}, {1, -1, 0}, {0, 1, -1}}},
      {{{3 - w, 0, w - 1}, {3, 1, 0}, {0, 0, -1}}},  // normal (1, -3, 0)
      {{{w - 900, 9 - w, w - 9}, {7, 2, -3}, {-1, 4, -5}}},
  }};
  const auto& p = planes[random.below(planes.size())];
  return Sketch(p[0], p[1], p[2]);
}

/// The numbers that the coordinates of places are taken from, in order, with room for one more at either end.
inline std::vector<std::int64_t> any_scale(Random& random) {
  std::vector<std::int64_t> scale;
  const std::int64_t size = random.one_in(2) ? 4 : random.one_in(2) ? 12 : 90;
  for (std::int64_t i = 0; i <= size; ++i) scale.push_back(i);
  return scale;
}
/// Those of slivers from one end of the world to the other, on the plane z = 0.
inline std::vector<std::int64_t> far_scale() {
  static constexpr std::int64_t w = exact::world;
  return {-w + 1, -w + 2, -1, 0, 1, w - 2, w - 1};
}
inline Sketch::Place any_place(Random& random, const std::vector<std::int64_t>& scale) {
  return {scale[random.below(scale.size())], scale[random.below(scale.size())]};
}

}  // namespace quoin::booleans::testing
