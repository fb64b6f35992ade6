/// \file
/// Moved primitives on a grid, for single solids and for models.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "api/access.h"
#include "rounding/motions/realize.h"
#include "rounding/reconstruction/reconstruct.h"

namespace quoin {

/// A shape or half-space in model units under a motion.
struct Placed {
  const rounding::Shape* shape = nullptr;
  std::optional<rounding::WidePlane> half_space = {};
  const rounding::RealizedMotion* motion = nullptr;
};

struct PlacedBodies {
  std::vector<rounding::Reconstructed> primitives;
  MotionReport report;
};

/// Errors: those of rounding::reconstruct; `where` begins with "primitive I".
Result<PlacedBodies> place(const std::vector<Placed>& primitives, const grid::Lattice& lattice, Rounding rounding,
                           const Options& run);

/// The bound of what the report's motions displace, and the same rounded up; model units.
void report_displacement(MotionReport& report, exact::Rational displacement);

/// The boundary of a bounded solid as a shape.
std::shared_ptr<const rounding::Shape> shape_of(const Solid& solid);

}  // namespace quoin
