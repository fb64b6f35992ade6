/// \file
/// The lattice that carries mesh vertices, and the ways between it and model units.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "exact/geometry.h"
#include "exact/rational.h"
#include "quoin/result.h"

namespace quoin::grid {

/// A default lattice fits its box within |coordinate| <= fitting_bound, which leaves a factor 8 to exact::world.
inline constexpr std::int32_t fitting_bound = 1 << 26;

/// Model coordinate = origin + step * integer. Precondition everywhere: step > 0. Model units.
struct Lattice {
  exact::Rational step = 1;
  std::array<exact::Rational, 3> origin = {0, 0, 0};
  friend bool operator==(const Lattice&, const Lattice&) = default;
};

/// The default lattice for a box in model units: the smallest power-of-two step at which the box, in grid steps from
/// the origin, fits |i| <= fitting_bound in every direction; never below 2^-1074, where every double is a grid
/// coordinate, and 1 for the box {0}.
/// The origin is 0, unless the step forced by the distance from 0 would be more than 2^10 times the one that the box's
/// size alone needs: then it is, in every direction, a multiple of the step nearest to the centre. A single point has
/// no size and keeps the origin 0.
/// Precondition: low <= high in every direction. Errors: "non-finite"; "out-of-range" (a coordinate beyond 2^1020: the
/// world could not be written as doubles).
Result<Lattice> fitting_lattice(const std::array<double, 3>& low, const std::array<double, 3>& high);

/// The exact k-th coordinate in model units.
exact::Rational model_coordinate(const Lattice& lattice, const exact::Point& point, int k);
exact::Rational model_coordinate(const Lattice& lattice, std::int32_t grid_coordinate, int k);

/// A lattice in machine integers: model coordinate = 2^exponent (offset[k] + factor i) / denominator, exactly.
/// |offset| + 2^31 factor <= 2^53 and denominator <= 2^53 is odd, so that numerator and denominator of a grid point are
/// doubles; |exponent| <= 700, so that no scaling under- or overflows.
struct Affine {
  std::array<std::int64_t, 3> offset;
  std::int64_t factor, denominator;
  int exponent;
};
/// Nothing when the lattice's numbers are too long for it.
std::optional<Affine> affine(const Lattice& lattice);

/// Correctly rounded (ties to even, never -0) model coordinates of points on one lattice.
class Rounder {
 public:
  /// The lattice must outlive it.
  explicit Rounder(const Lattice& lattice);
  explicit Rounder(Lattice&&) = delete;
  double to_double(const exact::Point& point, int k) const;
  double to_double(std::int32_t grid_coordinate, int k) const;
  float to_float(const exact::Point& point, int k) const;
  float to_float(std::int32_t grid_coordinate, int k) const;
  /// Whether doubles hold the model coordinates of all grid points exactly.
  bool is_exact() const { return affine_ && affine_->denominator == 1; }

 private:
  const Lattice& lattice_;
  std::optional<Affine> affine_;
  double scale_ = 0;                    // 2^exponent
  std::array<double, 3> scaling_ = {};  // the step where coordinate k only scales by a power of two, else 0
};

/// A plane given in model units (a x + b y + c z + d = 0), as a reduced plane in grid steps with the same positive
/// side; nothing when the normal is zero or the reduced coefficients exceed the bounds of exact::Plane.
std::optional<exact::Plane> grid_plane(const Lattice& lattice, const std::array<exact::Rational, 4>& model_plane);

}  // namespace quoin::grid
