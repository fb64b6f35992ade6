/// \file
/// The grid that carries the vertices of imported meshes.
#pragma once

#include "quoin/export.h"

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "quoin/result.h"

namespace quoin {

/// The lattice that carries all vertices of imported meshes: point = origin + step * (i, j, k), |i|,|j|,|k| <= 2^29.
/// Step and origin are exact rationals.
class QUOIN_API Grid {
 public:
  /// Step 1, origin 0.
  Grid();
  ~Grid();
  Grid(const Grid&);
  Grid& operator=(const Grid&);
  /// A grid of the given step: "1/1000", "0.001" or "1e-3" model units; positive.
  /// Errors: "bad-number".
  static Result<Grid> with_step(std::string_view step);
  /// A grid of the given step whose origin is (x, y, z), each a rational or decimal in model units. `where` of an error
  /// is "step" or "origin, y".
  static Result<Grid> with_step_and_origin(std::string_view step, const std::array<std::string, 3>& origin);
  /// The default grid for a box in model units: the smallest power-of-two step at which it fits |i| <= 2^26; the
  /// origin is 0 unless the box lies far from it for its size, then a multiple of the step near its centre.
  /// Errors: "non-finite", "out-of-range".
  static Result<Grid> fitting(const std::array<double, 3>& low, const std::array<double, 3>& high);

  /// Model units per grid step, reduced "p/q" (or "p").
  std::string step() const;
  std::array<std::string, 3> origin() const;
  bool operator==(const Grid& other) const;

 private:
  friend struct Access;
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace quoin
