/// \file
/// Small vectors and the scan conversion of triangles, for quoin-render.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace quoin::examples {

using Vector = std::array<double, 3>;

inline Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector operator*(double s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Vector& a) { return std::sqrt(dot(a, a)); }
/// The zero vector stays zero.
inline Vector normalized(const Vector& a) {
  const double size = length(a);
  return size > 0 ? (1 / size) * a : a;
}

/// Three perpendicular unit vectors; `toward` is the one that was given.
struct Frame {
  Vector right, up, toward;
};

/// `up` is as close to z as it can be.
inline Frame frame_toward(const Vector& direction) {
  const Vector toward = normalized(direction);
  const Vector helper = std::abs(toward[2]) > 0.999 ? Vector{0, 1, 0} : Vector{0, 0, 1};
  const Vector right = normalized(cross(helper, toward));
  return {right, cross(toward, right), toward};
}

/// A position on the picture: x to the right, y down, sample (i, j) has its centre at (i + 0.5, j + 0.5).
struct ScreenPoint {
  double x, y;
};

/// The first sample whose centre is right of (below) `coordinate`, within 0 .. size.
inline int first_sample(double coordinate, int size) {
  return static_cast<int>(std::clamp(coordinate + 0.5, 0.0, static_cast<double>(size)));
}

/// The x at which a segment meets the height y. The same for both directions of the segment, so that neighbours
/// neither overlap nor leave a gap.
inline double crossing(ScreenPoint a, ScreenPoint b, double y) {
  if (b.y < a.y) std::swap(a, b);
  return a.x + (y - a.y) * ((b.x - a.x) / (b.y - a.y));
}

/// Twice the area of a triangle on the screen, positive when its front (counter-clockwise in the model) faces us.
inline double front_area(const std::array<ScreenPoint, 3>& p) {
  return (p[2].x - p[0].x) * (p[1].y - p[0].y) - (p[1].x - p[0].x) * (p[2].y - p[0].y);
}

/// Calls `plot(x, y, weights)` for every sample centre within a triangle of either orientation; `weights` are the
/// three barycentric coordinates on the screen, each in [0, 1].
template <class Plot>
void scan_triangle(const std::array<ScreenPoint, 3>& p, int width, int height, Plot&& plot) {
  const double area = -front_area(p);
  if (area == 0) return;
  // The weights of corners 1 and 2 grow by these per sample to the right and down.
  const double right1 = (p[2].y - p[0].y) / area, down1 = (p[0].x - p[2].x) / area;
  const double right2 = (p[0].y - p[1].y) / area, down2 = (p[1].x - p[0].x) / area;
  const int y_end = first_sample(std::max({p[0].y, p[1].y, p[2].y}), height);
  for (int y = first_sample(std::min({p[0].y, p[1].y, p[2].y}), height); y < y_end; ++y) {
    const double yc = y + 0.5, dy = yc - p[0].y;
    double low = width, high = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const ScreenPoint &a = p[i], &b = p[(i + 1) % 3];
      if ((a.y <= yc) == (b.y <= yc)) continue;
      const double x = crossing(a, b, yc);
      low = std::min(low, x);
      high = std::max(high, x);
    }
    const int x_end = first_sample(high, width);
    for (int x = first_sample(low, width); x < x_end; ++x) {
      const double dx = x + 0.5 - p[0].x;
      const double w1 = std::clamp(dx * right1 + dy * down1, 0.0, 1.0);
      const double w2 = std::clamp(dx * right2 + dy * down2, 0.0, 1 - w1);
      plot(x, y, std::array<double, 3>{1 - w1 - w2, w1, w2});
    }
  }
}

}  // namespace quoin::examples
