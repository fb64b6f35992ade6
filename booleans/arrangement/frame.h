/// \file
/// A plane's own view of its points.
#pragma once

#include "booleans/arrangement/names.h"

namespace quoin::booleans {

/// Points projected along the largest component of a plane's normal, with the two other axes ordered so that
/// counter-clockwise seen from the normal stays counter-clockwise.
class Frame {
 public:
  Frame() = default;
  explicit Frame(const exact::Plane& plane) {
    const std::size_t k = exact::longest_component(plane.n);
    u_ = static_cast<int>((k + 1) % 3);
    v_ = static_cast<int>((k + 2) % 3);
    if (plane.n[k] < 0) std::swap(u_, v_);
  }
  int u() const { return u_; }
  int v() const { return v_; }

  /// Order of vertices by (u, v): "left of, or below".
  int compare(const VertexTable& vertices, VertexId a, VertexId b) const {
    if (const int c = vertices.compare_along(u_, a, b)) return c;
    return vertices.compare_along(v_, a, b);
  }
  /// +1 when n_plane x n_line runs forward in that order, -1 when it runs backward. Precondition: not parallel.
  int direction(const exact::Plane& plane, const exact::Plane& line) const {
    if (const int c = exact::cross_sign(plane, line, u_)) return c;
    return exact::cross_sign(plane, line, v_);
  }

 private:
  int u_ = 0, v_ = 1;
};

}  // namespace quoin::booleans
