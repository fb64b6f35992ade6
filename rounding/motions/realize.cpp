#include "rounding/motions/realize.h"

#include <algorithm>
#include <span>

#include "rounding/motions/approximate_rotation.h"
#include "rounding/numbers/enclosure.h"

namespace quoin::rounding {
namespace {

AffineMap map_of(const Quaternion& q) { return {matrix(q), {0, 0, 0}}; }

AffineMap map_of(const MirrorStep& step) {
  AffineMap map;
  const Axis& n = step.normal;
  const Integer norm = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) map.linear[i][j] -= Rational(2 * n[i] * n[j], norm);
  return map;
}

AffineMap map_of(const ScalingStep& step) {
  AffineMap map;
  for (std::size_t k = 0; k < 3; ++k) map.linear[k][k] = step.by[k];
  return map;
}

RealizedMotion realized(const RotationStep& step) {
  const ApproximateRotation a = approximate(step);
  RealizedMotion m;
  m.map = map_of(a.by);
  m.rotation = a.by;
  m.angle_error_degrees = a.error_degrees;
  m.displacement_per_unit = a.error_radians;
  return m;
}

RealizedMotion realized(const TurnStep& step) {
  RealizedMotion m;
  m.map = map_of(step.by);
  m.rotation = step.by;
  return m;
}

RealizedMotion realized(const TranslationStep& step) {
  RealizedMotion m;
  m.map.shift = step.by;
  m.reach = root_above(dot(step.by, step.by));
  return m;
}

RealizedMotion realized(const MirrorStep& step) {
  RealizedMotion m;
  m.map = map_of(step);
  m.rotation.reset();
  return m;
}

RealizedMotion realized(const ScalingStep& step) {
  RealizedMotion m;
  m.map = map_of(step);
  m.rotation.reset();
  m.stretch = *std::max_element(step.by.begin(), step.by.end());
  return m;
}

RealizedMotion realized(std::span<const Step> steps) {
  if (steps.empty()) return {};
  if (steps.size() == 1) return std::visit([](const auto& step) { return realized(step); }, steps[0]);

  return composed(realized(steps.first(steps.size() / 2)), realized(steps.subspan(steps.size() / 2)));
}

}  // namespace

RealizedMotion composed(const RealizedMotion& a, const RealizedMotion& b) {
  RealizedMotion m;
  m.map = composed(a.map, b.map);
  m.rotation = a.rotation && b.rotation ? std::optional(composed(*a.rotation, *b.rotation)) : std::nullopt;
  m.angle_error_degrees = a.angle_error_degrees + b.angle_error_degrees;

  // What the first displaces the second stretches, and it displaces what the first has made of p.
  m.displacement_per_unit = b.stretch * a.displacement_per_unit + b.displacement_per_unit * a.stretch;
  m.displacement = b.stretch * a.displacement + b.displacement_per_unit * a.reach + b.displacement;

  m.reach = b.stretch * a.reach + b.reach;
  m.stretch = b.stretch * a.stretch;
  return m;
}

RealizedMotion realize(const Motion& motion) { return realized(motion.steps()); }

}  // namespace quoin::rounding
