/// \file
/// Meshes of a file where it places them: its transforms are composed exactly, and each coordinate is rounded once.
#pragma once

#include <array>

#include "io/mesh.h"
#include "quoin/format.h"
#include "quoin/result.h"
#include "rounding/motions/affine_map.h"

namespace quoin {

/// Millimetres of a unit, exactly. Precondition: not `none`.
rounding::Rational millimeters(Unit unit);

/// The map of all steps together, exactly as the file's doubles state it: quaternions are taken at any length as the
/// rotation along them, angles as the rational rotation of `Motion::rotation`.
/// Errors: "non-finite" (a quaternion of length 0 names no rotation).
Result<rounding::AffineMap> map_of(const io::Placing& placing);

/// The images of doubles under a rational map, correctly rounded to double. Most are decided in double-double
/// arithmetic with a certified error, the others exactly.
class RoundedMap {
 public:
  explicit RoundedMap(const rounding::AffineMap& map);
  std::array<double, 3> operator()(const std::array<double, 3>& p) const;
  /// Coordinate k by rationals alone.
  double exactly(std::size_t k, const std::array<double, 3>& p) const;

 private:
  struct Entry {
    double high, low;  // their sum is the entry, but for 2^-105 of it
  };
  rounding::AffineMap map_;
  std::array<std::array<Entry, 4>, 3> rows_;
  bool is_tame_ = true;  // no entry is near the ends of the range of double
};

/// The mesh under the map; where that mirrors, faces are turned round. The identity keeps every bit.
/// Errors: "bad-syntax" (the map flattens space), "non-finite".
Result<io::PolygonMesh> placed_mesh(io::PolygonMesh mesh, const rounding::AffineMap& map);

}  // namespace quoin
