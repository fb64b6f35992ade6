/// \file
/// How much a door takes in before it refuses ("too-large"): input from strangers meets these before it meets memory.
#pragma once

#include "quoin/export.h"

#include <cstdint>
#include <limits>

namespace quoin {

/// The most of each that is taken. The defaults are far beyond usual work; docs/doors.md has the table.
struct Limits {
  /// Of one file. A regular file is judged by its size, before it is read.
  std::uint64_t bytes = std::uint64_t{1} << 31;
  /// Of what states no size: pipes and devices, which need not have an end.
  std::uint64_t stream_bytes = std::uint64_t{1} << 27;
  /// Points and polygons of one mesh, from a file or from arrays.
  std::uint64_t vertices = 150'000'000, faces = 50'000'000;
  /// Nodes of a model as they are reached: a part that is used under two motions counts twice.
  std::uint64_t nodes = 100'000;
  /// Faces of all primitives of a model as they are placed.
  std::uint64_t model_faces = 4'000'000;
  /// Faces that the counts of one primitive ask for: `sides` or `planes`, the product with its bands for a sphere, with
  /// its minor sides for a torus.
  std::uint64_t sides = 65'000;
  /// Digits of one number of a model.
  std::uint64_t digits = 4'000;
  /// Nodes within each other in a model's text. Readers recurse: more than the default is not taken whatever is asked.
  std::uint64_t depth = 500;

  /// All that memory and the other bounds of docs/errors.md leave.
  static Limits none() {
    constexpr std::uint64_t any = std::numeric_limits<std::uint64_t>::max();
    return {any, any, any, any, any, any, any, any, any};
  }
};

}  // namespace quoin
