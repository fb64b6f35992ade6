/// \file
/// Shells of one mesh that crowd each other.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "booleans/body/stars.h"

namespace quoin::booleans {

/// One surface, connected over edges that all have exactly two faces? Where all stars are fans, triangles that hang
/// together over vertices hang together over such edges. `star_of`: the stars of its vertices.
bool is_simple_surface(const Body& mesh, const Array<Star>& star_of);

/// A mesh as a union: the points where its winding number is > 0 are those of the solids, and those where that of the
/// rest is > 0.
struct CrowdedShells {
  /// Clean bodies, more than Thresholds::group; or none where that is not worth while, and there is no rest then.
  std::vector<Body> solids;
  Body rest;
  /// Pairs of faces of one shell of the solids that met out of place.
  std::uint64_t crossings = 0;
};

/// The shells (grid/shells.h) of a mesh whose winding number is nowhere negative, as solids, where many shells have
/// boxes that meet; one that has a box that meets that of another kind of shell stays with it in the rest. Why that is
/// the same: let w be the sum of the winding numbers of all shells, v that of the rest's. Inside a solid its shell has
/// a number > 0 and, as it lies outside of their boxes, those of the other kind have 0: there w > 0. Outside of all
/// solids w = v. `star_of`: the stars of the mesh's vertices. A cancelled search makes some shells the rest.
CrowdedShells crowded_shells(const Body& mesh, const Array<Star>& star_of, const std::atomic<bool>* cancel = nullptr);

}  // namespace quoin::booleans
