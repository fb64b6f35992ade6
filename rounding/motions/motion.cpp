#include "rounding/motions/motion.h"

#include <cassert>
#include <optional>
#include <type_traits>
#include <utility>

namespace quoin::rounding {
namespace {

bool points_backward(const Axis& a) { return a[0] < 0 || (a[0] == 0 && (a[1] < 0 || (a[1] == 0 && a[2] < 0))); }

Axis opposite(const Axis& a) { return {-a[0], -a[1], -a[2]}; }

/// In (-180, 180].
Rational reduced_angle(const Rational& degrees) {
  const Rational turns = floor_of((degrees + 180) / 360);
  const Rational r = degrees - turns * 360;
  return r == -180 ? Rational(180) : r;
}

Step inverted(const Step& step) {
  return std::visit(
      [](const auto& s) -> Step {
        using S = std::decay_t<decltype(s)>;
        if constexpr (std::is_same_v<S, RotationStep>) return RotationStep{s.axis, reduced_angle(-s.degrees)};
        if constexpr (std::is_same_v<S, TranslationStep>) return TranslationStep{Rational(-1) * s.by};
        if constexpr (std::is_same_v<S, TurnStep>) return TurnStep{quaternion(s.by.w, -s.by.x, -s.by.y, -s.by.z)};
        if constexpr (std::is_same_v<S, ScalingStep>) return ScalingStep{{1 / s.by[0], 1 / s.by[1], 1 / s.by[2]}};
        return s;
      },
      step);
}

bool is_identity(const Step& step) {
  if (const auto* r = std::get_if<RotationStep>(&step)) return r->degrees == 0;
  if (const auto* t = std::get_if<TranslationStep>(&step)) return t->by == Vector{0, 0, 0};
  if (const auto* t = std::get_if<TurnStep>(&step)) return t->by == Quaternion{};
  if (const auto* s = std::get_if<ScalingStep>(&step)) return s->by == Vector{1, 1, 1};
  return false;
}

/// What two steps that say the same kind of thing are together; nothing for others.
std::optional<Step> joined(const Step& first, const Step& second) {
  if (const auto* a = std::get_if<RotationStep>(&first), *b = std::get_if<RotationStep>(&second);
      a && b && a->axis == b->axis)
    return RotationStep{a->axis, reduced_angle(a->degrees + b->degrees)};
  if (const auto* a = std::get_if<TranslationStep>(&first), *b = std::get_if<TranslationStep>(&second); a && b)
    return TranslationStep{a->by + b->by};
  if (const auto* a = std::get_if<TurnStep>(&first), *b = std::get_if<TurnStep>(&second); a && b)
    return TurnStep{composed(a->by, b->by)};
  // Twice the same mirror image is the identity.
  if (const auto* a = std::get_if<MirrorStep>(&first), *b = std::get_if<MirrorStep>(&second); a && b && *a == *b)
    return TranslationStep{{0, 0, 0}};
  if (const auto* a = std::get_if<ScalingStep>(&first), *b = std::get_if<ScalingStep>(&second); a && b)
    return ScalingStep{{a->by[0] * b->by[0], a->by[1] * b->by[1], a->by[2] * b->by[2]}};
  return std::nullopt;
}

}  // namespace

void Motion::add(Step step) {
  if (is_identity(step)) return;
  if (steps_.empty()) return steps_.push_back(std::move(step));

  auto together = joined(steps_.back(), step);
  if (!together) return steps_.push_back(std::move(step));

  steps_.pop_back();
  // What it leaves may join what comes before no more than the removed step did, unless it vanished.
  if (!is_identity(*together)) steps_.push_back(std::move(*together));
}

Motion Motion::rotation(const Vector& axis, const Rational& degrees) {
  const Axis a = primitive(axis);
  Motion m;
  if (points_backward(a))
    m.add(RotationStep{opposite(a), reduced_angle(-degrees)});
  else
    m.add(RotationStep{a, reduced_angle(degrees)});
  return m;
}

Motion Motion::translation(const Vector& by) {
  Motion m;
  m.add(TranslationStep{by});
  return m;
}

Motion Motion::turn(const Quaternion& by) {
  Motion m;
  m.add(TurnStep{by});
  return m;
}

Motion Motion::mirror(const Vector& normal) {
  const Axis a = primitive(normal);
  Motion m;
  m.add(MirrorStep{points_backward(a) ? opposite(a) : a});
  return m;
}

Motion Motion::scaling(const Vector& by) {
  assert(by[0] > 0 && by[1] > 0 && by[2] > 0);
  Motion m;
  m.add(ScalingStep{by});
  return m;
}

Motion Motion::then(const Motion& next) const {
  Motion m = *this;
  for (const Step& step : next.steps_) m.add(step);
  return m;
}

Motion Motion::inverse() const {
  Motion m;
  for (std::size_t i = steps_.size(); i-- > 0;) m.add(inverted(steps_[i]));
  return m;
}

}  // namespace quoin::rounding
