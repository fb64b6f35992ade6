#include "booleans/body/simple.h"

#include <algorithm>

#include "exact/predicates.h"
#include "grid/lists/thresholds.h"

namespace quoin::booleans {
namespace {

/// The corners of a loop on a plane.
class FlatLoop {
 public:
  FlatLoop(const exact::Plane& plane, const Body& body, std::span<const std::uint32_t> corners) : plane_(plane) {
    points_.reserve(corners.size());
    for (const std::uint32_t v : corners) points_.push_back(body.point(v));
    axis_[0] = static_cast<int>((exact::longest_component(plane.n) + 1) % 3);
    axis_[1] = (axis_[0] + 1) % 3;
  }

  bool turns_everywhere() const {
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (turn(i) == 0) return false;
    return true;
  }
  /// Edges without a common corner have no common point.
  bool has_separate_edges() const {
    const std::size_t n = points_.size();
    for (std::size_t i = 0; i + 2 < n; ++i)
      for (std::size_t j = i + 2; j < n && j - i < n - 1; ++j)
        if (!are_separate(i, j)) return false;
    return true;
  }
  /// The first corner in the order of the two axes is one of the convex hull.
  bool is_counter_clockwise() const {
    const auto first = std::min_element(points_.begin(), points_.end(), [&](const auto& a, const auto& b) {
      const int c = exact::compare_along(axis_[0], a, b);
      return c != 0 ? c < 0 : exact::compare_along(axis_[1], a, b) < 0;
    });
    return turn(static_cast<std::size_t>(first - points_.begin())) > 0;
  }

 private:
  const exact::Point& after(std::size_t i) const { return points_[grid::next_in_loop(i, points_.size())]; }
  const exact::Point& before(std::size_t i) const { return points_[grid::previous_in_loop(i, points_.size())]; }
  int orientation(const exact::Point& a, const exact::Point& b, const exact::Point& c) const {
    return exact::orientation_in_plane(plane_, a, b, c);
  }
  int turn(std::size_t i) const { return orientation(before(i), points_[i], after(i)); }

  /// The edges that begin in corners i and j.
  bool are_separate(std::size_t i, std::size_t j) const {
    const exact::Point &a = points_[i], &b = after(i), &c = points_[j], &d = after(j);
    return are_apart(a, b, c, d) || are_apart(c, d, a, b) || orientation(a, b, c) * orientation(a, b, d) > 0 ||
           orientation(c, d, a) * orientation(c, d, b) > 0;
  }
  /// Does a plane across an axis separate a, b, before it, from c, d? Approximations that differ tell.
  bool are_apart(const exact::Point& a, const exact::Point& b, const exact::Point& c, const exact::Point& d) const {
    return std::any_of(axis_.begin(), axis_.end(), [&](int axis) {
      const auto x = [axis](const exact::Point& p) { return p.approximation[static_cast<std::size_t>(axis)]; };
      return std::max(x(a), x(b)) < std::min(x(c), x(d));
    });
  }

  const exact::Plane& plane_;
  Array<exact::Point> points_;
  std::array<int, 2> axis_;
};

}  // namespace

bool proved_simple(const Body& body, std::uint32_t face) {
  if (body.corner_count(face) > grid::thresholds().small_face) return false;
  if (face < body.triangles.size()) return true;

  const std::uint32_t p = body.polygon(face);
  if (body.polygons.loop_count(p) != 1) return false;
  const FlatLoop loop(body.planes[p], body, body.polygons.corners_of(p));
  return loop.turns_everywhere() && loop.has_separate_edges() && loop.is_counter_clockwise();
}

}  // namespace quoin::booleans
