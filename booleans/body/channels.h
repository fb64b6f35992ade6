/// \file
/// Channels: numbers that vary over faces, as texture coordinates and colours do.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "booleans/body/labels.h"
#include "exact/rational.h"
#include "grid/grid.h"

namespace quoin::booleans {

/// An affine map of positions, exact: row k is (a, b, c, d) of a x + b y + c z + d.
using PositionMap = std::array<std::array<exact::Rational, 4>, 3>;
/// `first`, then `second`.
PositionMap composed(const PositionMap& first, const PositionMap& second);
bool is_identity(const PositionMap& map);
/// Grid steps to model units, and back.
PositionMap to_model(const grid::Lattice& lattice);
PositionMap to_steps(const grid::Lattice& lattice);

/// What the faces of an origin carry besides labels: on each surface every channel is an affine function of the
/// position, the one that has given values in the corners of a triangle, the seed. It counts on the seed's plane, and
/// is carried to places beside it along the axis in which that plane's normal is longest.
struct Channels {
  struct Seed {
    std::array<exact::GridPoint, 3> corners = {};
    int axis = 2;
    std::int64_t area = 0;  // twice that of the projection along the axis, of its sign

    friend bool operator==(const Seed&, const Seed&) = default;
  };
  std::uint32_t count = 0;
  grid::Array<Seed> seeds;     // by surface
  grid::Array<double> values;  // of corner i of seed s: values[(3 s + i) count] and the following
  PositionMap to_seeds = {};   // model units to the steps in which seeds are

  friend bool operator==(const Channels&, const Channels&) = default;

  std::span<const double> corner_values(std::uint32_t surface, std::size_t corner) const {
    return std::span(values).subspan((3 * std::size_t{surface} + corner) * count, count);
  }
  /// The values at a place in seeds' steps, each correctly rounded.
  void at(std::uint32_t surface, const std::array<exact::Rational, 3>& place, std::span<double> out) const;
  void at(std::uint32_t surface, const exact::GridPoint& place, std::span<double> out) const;
};

/// The seed of a triangle; nothing where it has no area.
std::optional<Channels::Seed> seed_of(const std::array<exact::GridPoint, 3>& corners);

/// Channels as they enter: `values` of channel c in a corner of a polygon at [corner * count + c].
struct ChannelInput {
  std::uint32_t count = 0;
  std::span<const double> values;
  std::span<const exact::GridPoint> points;  // of the input, snapped
  std::span<const std::uint32_t> starts;     // of polygons; empty for triangles
  std::span<const std::uint32_t> corners;
  grid::Lattice lattice = {};
  /// How far a function may be off, as a part of the range of its channel.
  double tolerance = 0;
};

/// Gives an origin its channels, and its surfaces: triangles that are joined over edges of two, lie on one plane, have
/// one label, and whose channels are one function but for the tolerance. `sources`: the polygon of each triangle.
/// Returns a polygon whose channels are no affine function of the position, if there is one; the origin is not changed
/// then.
std::optional<std::uint32_t> add_channels(const ChannelInput& input, std::span<const exact::GridPoint> points,
                                          std::span<const std::array<std::uint32_t, 3>> triangles,
                                          std::span<const std::uint32_t> sources, Origin& origin);

/// The origins of what a map carries: channels go with it. `back`: from where faces go to where they came from, model
/// units.
std::shared_ptr<const Origins> carried(const std::shared_ptr<const Origins>& origins, const PositionMap& back);

}  // namespace quoin::booleans
