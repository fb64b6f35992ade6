/// \file
/// Questions to one solid, many of them, answered exactly.
#pragma once

#include "quoin/export.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "quoin/arrays.h"
#include "quoin/options.h"
#include "quoin/result.h"
#include "quoin/solid.h"

namespace quoin {

/// An exact number.
struct ExactNumber {
  std::string exact;  // "p/q", or "p" where q = 1, in lowest terms
  double rounded;     // to nearest, ties to even
  friend bool operator==(const ExactNumber&, const ExactNumber&) = default;
};

/// A maximal piece that a ray or a segment has in common with the boundary of a solid: a point (begin == end), or a
/// segment that lies in faces or along edges.
struct Contact {
  /// Parameters t: the points are from + t * direction.
  ExactNumber begin, end;
  /// Where the points just before and just behind it lie: boundary where the solid's boundary goes on beyond the end of
  /// the ray or segment. The line crosses the boundary where they differ, else it touches it.
  Location before, behind;
  /// All faces that it meets, their edges and corners included, ascending: numbers of the solid's boundary
  /// (quoin/boundary.h), in canonical order.
  std::vector<std::uint32_t> faces;
  friend bool operator==(const Contact&, const Contact&) = default;
};

/// What a ray or a segment passes.
struct Passage {
  /// Where its first point lies.
  Location start;
  /// In order, disjoint. Between two, before the first and behind the last the line is off the boundary: inside or
  /// outside, as the contacts say; without contacts all of it is where it starts.
  std::vector<Contact> contacts;
  friend bool operator==(const Passage&, const Passage&) = default;
};

/// The point of a solid's boundary that is nearest to another point.
struct Nearest {
  /// Square model units.
  ExactNumber squared_distance;
  /// Of equally near ones the first in order of their exact (x, y, z), model units.
  std::array<ExactNumber, 3> point;
  /// All faces that hold it, ascending.
  std::vector<std::uint32_t> faces;
  /// Where the point lies that was asked about: the distance to the solid is 0 unless it is outside.
  Location where;
  friend bool operator==(const Nearest&, const Nearest&) = default;
};

/// How two solids, as closed sets, meet.
enum class Interference {
  apart,       // no common point
  touching,    // common points of their boundaries alone
  overlapping  // common interior points
};

/// What a solid weighs at density 1, and where, model units.
struct MassProperties {
  /// Integrals over the solid of 1, of x, y, z, and of xx, yy, zz, yz, zx, xy. They are additive: those of A and B add
  /// up to those of their union and their intersection.
  ExactNumber volume;
  std::array<ExactNumber, 3> first;
  std::array<ExactNumber, 6> second;
  /// The centre of mass, and the inertia tensor about it, its components in the order of `second`: the diagonal ones
  /// are those of yy + zz, zz + xx, xx + yy, the others those of -yz, -zx, -xy. Nothing of the empty solid.
  std::optional<std::array<ExactNumber, 3>> centroid;
  std::optional<std::array<ExactNumber, 6>> inertia;
  friend bool operator==(const MassProperties&, const MassProperties&) = default;
};

/// The part of a plane that lies in the interior of a solid, and its boundary: polygons without common interior. Where
/// the solid only touches the plane, with a face, an edge or a corner, there is nothing.
struct Section {
  /// Model units, in order of their exact (x, y, z); only those that must be.
  std::vector<std::array<ExactNumber, 3>> vertices;
  /// Loops of vertices: the one around a polygon first, counter-clockwise seen from above the plane, then its holes,
  /// clockwise. Parts that touch in a vertex alone are polygons of their own; a hole that touches the loop around it is
  /// one loop with it.
  std::vector<std::vector<std::vector<std::uint32_t>>> polygons;
  /// Bounds of the area, square model units; the exact area where the plane is parallel to two axes.
  std::array<double, 2> area_bounds;
  std::optional<ExactNumber> area;
  friend bool operator==(const Section&, const Section&) = default;
};

/// A solid with an index over its boundary. Making one takes about as long as writing the solid; then a question takes
/// microseconds (docs/questions.md). Answers are exact, and a function of the point set alone. An immutable value,
/// cheap to copy and safe to ask from many threads.
class QUOIN_API Questions {
 public:
  /// Three numbers in text, model units: each a decimal or rational, taken exactly as doubles are.
  using Numbers = std::array<std::string, 3>;

  /// `faces`: which boundary's numbers answers name faces by. By label these lead to what a face carries
  /// (Boundary::label), and polygons of sections have corners where labels change; nothing else is different.
  explicit Questions(const Solid& solid, Faces faces = Faces::maximal);
  ~Questions();
  Questions(const Questions&);
  Questions(Questions&&) noexcept;
  Questions& operator=(const Questions&);
  Questions& operator=(Questions&&) noexcept;

  const Solid& solid() const;

  /// Where a point lies. Precondition: finite.
  Location classify(const std::array<double, 3>& point) const;
  /// Where each of many points lies: three coordinates a point. The same for any number of threads.
  /// Errors: "non-finite" (`where` is the number of the point, from 0), "cancelled".
  Result<std::vector<Location>> classify(Coordinates points, const Options& run = {}) const;

  /// From a point in a direction that is not 0, to infinity (t >= 0).
  /// Errors: "non-finite", "bad-axis" (no direction), "bad-number" (of text).
  Result<Passage> ray(const std::array<double, 3>& from, const std::array<double, 3>& direction) const;
  Result<Passage> ray(const Numbers& from, const Numbers& direction) const;
  /// From a point (t = 0) to another one (t = 1). Errors: "non-finite", "bad-axis" (they are equal), "bad-number".
  Result<Passage> segment(const std::array<double, 3>& from, const std::array<double, 3>& to) const;
  Result<Passage> segment(const Numbers& from, const Numbers& to) const;

  /// The boundary's nearest point; nothing where there is no boundary. Precondition: finite.
  std::optional<Nearest> nearest(const std::array<double, 3>& point) const;

  /// Exact: of solids of many derived vertices the numbers are long, and take time (docs/questions.md). Nothing of an
  /// unbounded solid.
  std::optional<MassProperties> mass_properties() const;
  /// Two doubles between which the area of the boundary lies, square model units.
  std::array<double, 2> area_bounds() const;

  /// The section of the boundary plane of a half-space.
  /// Errors: "bad-plane" (no normal, no numbers), "unbounded", "inconsistent" (a solid that was trusted wrongly).
  Result<Section> section(const HalfSpace& half_space) const;

 private:
  friend QUOIN_API Result<Interference> interference(const Questions& a, const Questions& b, const Options& run);
  struct Data;
  std::shared_ptr<const Data> data_;
};

/// Ends with the first faces that cross each other; where faces only touch, or lie on each other, the intersection
/// tells. Solids of two grids are compared on one of the two. Errors: "inexact-grid" (neither fits the other's),
/// "cancelled", "inconsistent" (a solid that was trusted wrongly).
QUOIN_API Result<Interference> interference(const Questions& a, const Questions& b, const Options& run = {});

}  // namespace quoin
