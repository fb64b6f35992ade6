#include "rounding/shapes/circle.h"

#include <cassert>
#include <map>

#include "grid/lists/loops.h"
#include "rounding/numbers/enclosure.h"

namespace quoin::rounding {
namespace {

/// The point at an angle from 0 to 45 degrees.
PlanePoint octant_point(const Rational& degrees, const Integer& precision) {
  if (degrees == 0) return {1, 0};
  Rational error;
  const Rational t =
      best_approximation([&](unsigned bits) { return enclosed_tangent(degrees / 2, bits); }, precision, error);
  return {(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)};
}

/// The point at any angle, mirrored from that of an angle from 0 to 45 degrees.
template <class Octant>
PlanePoint mirrored(const Rational& degrees, Octant&& octant) {
  const Rational a = degrees - 360 * Rational(floor_of((degrees + 180) / 360));  // -180 <= a < 180

  if (a < 0 && a > -180) {
    const PlanePoint p = mirrored(-a, octant);
    return {p[0], -p[1]};
  }
  const Rational b = magnitude(a);
  if (b > 90) {
    const PlanePoint p = mirrored(180 - b, octant);
    return {-p[0], p[1]};
  }
  if (b > 45) {
    const PlanePoint p = mirrored(90 - b, octant);
    return {p[1], p[0]};
  }
  return octant(b);
}

}  // namespace

PlanePoint circle_point(const Rational& degrees, const Integer& precision) {
  return mirrored(degrees, [&](const Rational& b) { return octant_point(b, precision); });
}

namespace {

/// Of the polygon in the circle of radius 1, so that its area is that of the circle.
Rational scale_to_equal_area(const Outline& p) {
  const Rational area = doubled_area(p) / 2;
  const Enclosure pi = enclosed_pi(64);
  return best_approximation(root_above((pi.low + pi.high) / 2 / area), Integer(1) << 24);
}

/// The polygon of the tangents in these points of the unit circle: those in a and b meet in (a + b) / (1 + a . b).
Outline of_tangents(const Outline& touching) {
  Outline p;
  grid::for_loop_edges(touching, [&](const PlanePoint& a, const PlanePoint& b) {
    const Rational divisor = 1 + a[0] * b[0] + a[1] * b[1];
    p.push_back({(a[0] + b[0]) / divisor, (a[1] + b[1]) / divisor});
  });
  return p;
}

}  // namespace

Outline circle_polygon(std::uint32_t sides, const Rational& radius, Fit fit) {
  assert(sides >= 3 && radius > 0);
  std::map<Rational, PlanePoint> known;
  const auto octant = [&](const Rational& b) {
    const auto [at, fresh] = known.try_emplace(b);
    if (fresh) at->second = octant_point(b, circle_precision());
    return at->second;
  };
  Outline p;
  for (std::uint32_t i = 0; i < sides; ++i) p.push_back(mirrored(Rational(360) * i / sides, octant));

  Rational scale = radius;
  if (fit == Fit::equal_area) scale *= scale_to_equal_area(p);
  if (fit == Fit::circumscribed) p = of_tangents(p);
  for (PlanePoint& v : p) v = {v[0] * scale, v[1] * scale};
  return p;
}

}  // namespace quoin::rounding
