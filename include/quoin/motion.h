/// \file
/// Motions that compose exactly, and moved solids.
///
/// Numbers are text: a decimal ("-1.25e-3") or a rational ("1/3"), read exactly. Lengths are in model units, angles in
/// degrees, right-handed.
#pragma once

#include "quoin/export.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "quoin/options.h"
#include "quoin/result.h"
#include "quoin/solid.h"

namespace quoin {

using Text3 = std::array<std::string, 3>;

/// How planes are rounded after a motion (docs/motions.md).
enum class Rounding {
  best,                // a function of the moved plane alone; the closest direction of the next three
  naive,               // every coefficient to the nearest integer
  continued_fraction,  // ratios by continued fractions
  lattice,             // direction by lattice reduction
  face_local,          // least movement of the faces' own vertices
  vertices,            // no planes: every vertex to the nearest grid point
};

/// What a motion amounts to.
struct MotionInfo {
  /// The rotation carried out, as integers w, x, y, z; nothing when the motion mirrors or scales.
  std::optional<std::array<std::string, 4>> quaternion;
  /// The exact linear part carried out (rows) and the translation after it, model units.
  std::array<Text3, 3> linear;
  Text3 shift;
  /// An upper bound of the sum of the differences between the stated angles and those carried out, degrees.
  double angle_error = 0;
};

/// A motion: rotations, translations, mirror images and scalings in a row, composed exactly. Angles about one axis that
/// follow each other are added as they were stated, so 360 rotations by 1 degree are the identity, as is a motion
/// followed by its inverse. An immutable value. `where` of "bad-number" is the number: "axis, y", "row 2, x".
class QUOIN_API Motion {
 public:
  /// The identity.
  Motion();
  ~Motion();
  Motion(const Motion&);
  Motion& operator=(const Motion&);

  /// About an axis through the origin. Where tan(angle / 2) / |axis| is irrational the closest fraction replaces it,
  /// with an error of the angle below 2^-86 degrees. Errors: "bad-number", "bad-axis" (no direction).
  static Result<Motion> rotation(const Text3& axis, std::string_view degrees);
  /// Errors: "bad-number".
  static Result<Motion> translation(const Text3& by);
  /// By a rational rotation: w + x i + y j + z k turns by 2 atan(|(x, y, z)| / w) about (x, y, z).
  /// Errors: "bad-number", "bad-axis" (all are 0).
  static Result<Motion> quaternion(const std::array<std::string, 4>& wxyz);
  /// By the rotation that a matrix is (rows), or else by the nearest rational one; `deviation` receives the largest
  /// difference of two entries. Errors: "bad-number", "not-a-rotation" (m m^T differs from 1 by more than 1e-6, or the
  /// determinant is negative).
  static Result<Motion> matrix(const std::array<Text3, 3>& rows, double* deviation = nullptr);
  /// The mirror image in the plane through the origin with this normal. Errors: "bad-number", "bad-axis".
  static Result<Motion> mirror(const Text3& normal);
  /// From the origin, by positive factors along x, y and z. Errors: "bad-number", "bad-factor".
  static Result<Motion> scaling(const Text3& by);

  /// This, then `next`.
  Motion then(const Motion& next) const;
  Motion inverse() const;
  MotionInfo info() const;
  /// Of what was stated, in lowest terms.
  friend QUOIN_API bool operator==(const Motion& a, const Motion& b);

 private:
  friend struct Access;
  struct Data;
  explicit Motion(std::shared_ptr<const Data> data);
  std::shared_ptr<const Data> data_;  // nullptr: the identity
};

/// What rounding did to moved primitives.
struct MotionReport {
  /// An upper bound of the distance of any point of a primitive's surface from where the stated motion has it: what
  /// rotations by approximated angles and what rounding add. Exact, "p/q" in model units. Half-spaces do not count.
  std::string displacement_bound = "0";
  /// The same, rounded up.
  double displacement = 0;
  /// An upper bound of the differences between stated and realized angles; the largest of all primitives; degrees.
  double angle_error = 0;
  /// Primitives placed; those whose faces stayed flat (plane by plane); those rounded vertex by vertex.
  std::uint64_t primitives = 0, by_planes = 0, by_vertices = 0;
  /// Distinct planes of the former, those that needed no rounding, and those rounded face_local for a condition.
  std::uint64_t planes = 0, exact_planes = 0, face_local_planes = 0;
  /// Of primitives rounded vertex by vertex, as in ImportReport.
  std::uint64_t merged_points = 0, zero_area_triangles = 0, resolved_crossings = 0;
  /// Primitives that are about as thin as a grid step, so that rounding their vertices left nothing of them; the number
  /// of the first of them, "primitive I" from 0, or "".
  std::uint64_t vanished_primitives = 0;
  std::string vanished_where = {};
};

struct MoveOptions {
  Rounding rounding = Rounding::best;
  Options run = {};
};

/// A solid moved on its own grid. Where every moved plane is one of the grid's, exactly; else plane by plane if every
/// vertex lies on three planes and every edge on two faces, so that flat faces stay flat, else vertex by vertex.
/// Errors: "out-of-range" (naming the step that would do), "inconsistent-motion" (no rounding keeps the shape; naming
/// the vertex and the face), "cancelled".
QUOIN_API Result<Solid> moved(const Solid& solid, const Motion& motion, const MoveOptions& options = {},
                              MotionReport* report = nullptr);

}  // namespace quoin
