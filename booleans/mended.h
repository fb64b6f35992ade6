/// \file
/// Rounded meshes that became invalid are mended.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "booleans/body/body.h"
#include "booleans/run.h"
#include "booleans/surface/rounded.h"
#include "grid/grid.h"

namespace quoin::booleans {

/// A clean body on a lattice whose points are numbers of a format.
struct Mended {
  Body body;
  grid::Lattice lattice;
  /// Pairs of triangles that met out of place.
  std::uint64_t crossings = 0;
  /// Distinct points that became one with another one, triangles that lost their area.
  std::uint64_t merged_points = 0, vanished_triangles = 0;
  /// An upper bound of the largest move of a point, model units.
  double most = 0;
};

/// The lattice of numbers for a box in model units, all of whose points around the box the format holds: the finest
/// step, a power of two, with at most 2^24 (float32) or 2^28 (doubles) steps from the origin. The origin is 0 unless a
/// box of doubles lies far from it for its size.
grid::Lattice lattice_of_numbers(const std::array<double, 3>& low, const std::array<double, 3>& high, Floats floats);

/// Where the lattice is taken coarser.
struct Coarsening {
  /// By point: does trouble remain there? Empty: nowhere.
  std::span<const std::uint8_t> troubled;
  /// A point that has a troubled one within 2^level steps, and perhaps one within twice that, goes to a multiple of
  /// 2^level steps; 0: none does. From 30 on all points go to the origin of the lattice if any is troubled.
  int level = 0;
};

/// What triangles carry, by triangle; nothing where `origins` is null.
struct TriangleLabels {
  std::shared_ptr<const Origins> origins = nullptr;
  Array<Provenance> of_triangle = {};
};

/// The points of winding number > 0 of a closed mesh that is snapped to the lattice of numbers for its box.
/// It differs from the mesh at points within `most` of the surface only: on the way of the points to the lattice the
/// surface passes nothing else. Nothing may be left.
/// Errors: "cancelled"; those of grid::import_triangles for a mesh that is not closed.
Result<Mended> mended(std::span<const double> points, std::span<const std::uint32_t> triangles,
                      const TriangleLabels& labels, Floats floats, const Coarsening& coarsening, const Run& run = {});

}  // namespace quoin::booleans
