#include "booleans/questions/line.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quoin::booleans {
namespace {

using exact::Integer;
using exact::Rational;

const Interval anything(-HUGE_VAL, HUGE_VAL);

bool holds_zero(const Interval& x) { return x.low <= 0 && x.high >= 0; }
bool is_zero(const Interval& x) { return x.low == 0 && x.high == 0; }

/// The whole numbers around an interval, within the range of boxes: no vertex reaches its ends.
std::int32_t whole_below(double x) { return static_cast<std::int32_t>(std::floor(std::clamp(x, -0x1p30, 0x1p30))); }
std::int32_t whole_above(double x) { return static_cast<std::int32_t>(std::ceil(std::clamp(x, -0x1p30, 0x1p30))); }

}  // namespace

Homogeneous homogeneous(const RationalPoint& p) {
  auto common = exact::over_common_denominator(p);
  return {std::move(common.numerators), std::move(common.denominator)};
}

Homogeneous homogeneous(const exact::Point& p) {
  return {{exact::to_integer(p.x[0]), exact::to_integer(p.x[1]), exact::to_integer(p.x[2])}, exact::to_integer(p.w)};
}

Interval enclosure(const Rational& v) {
  const double x = exact::to_double(v);
  return exact::to_rational(std::isfinite(x) ? x : 0) == v ? Interval(x) : Interval::around(x);
}

ModelFrame::ModelFrame(const grid::Lattice& lattice)
    : lattice_(lattice),
      origin_{booleans::enclosure(lattice.origin[0]), booleans::enclosure(lattice.origin[1]),
              booleans::enclosure(lattice.origin[2])},
      step_(booleans::enclosure(lattice.step)) {}

RationalPoint ModelFrame::point(const RationalPoint& model) const {
  RationalPoint p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = (model[k] - lattice_.origin[k]) / lattice_.step;
  return p;
}

RationalPoint ModelFrame::direction(const RationalPoint& model) const {
  RationalPoint d;
  for (std::size_t k = 0; k < 3; ++k) d[k] = model[k] / lattice_.step;
  return d;
}

IntervalPoint ModelFrame::enclosure(const std::array<double, 3>& model) const {
  IntervalPoint p{anything, anything, anything};
  for (std::size_t k = 0; k < 3; ++k) {
    const Interval from_origin = is_zero(origin_[k]) ? Interval(model[k]) : Interval(model[k]) - origin_[k];
    // Neither overflow nor an interval of unknown ends may hide in a quotient.
    constexpr double most = std::numeric_limits<double>::max() / 2;
    if (!(step_.low > 0) || !(step_.high < most) || !(from_origin.low > -most) || !(from_origin.high < most)) continue;
    const Interval quotient = from_origin / step_;
    if (quotient.low > -most && quotient.high < most) p[k] = quotient;
  }
  return p;
}

QueryPoint::QueryPoint(const RationalPoint& exact)
    : near_{enclosure(exact[0]), enclosure(exact[1]), enclosure(exact[2])}, exact_(homogeneous(exact)) {}

QueryPoint::QueryPoint(const ModelFrame& frame, const std::array<double, 3>& model)
    : frame_(&frame), model_(model), near_(frame.enclosure(model)) {}

const Homogeneous& QueryPoint::exact() const {
  if (!exact_) {
    RationalPoint model;
    for (std::size_t k = 0; k < 3; ++k) model[k] = exact::to_rational(model_[k]);
    exact_ = homogeneous(frame_->point(model));
  }
  return *exact_;
}

RationalPoint QueryPoint::rational() const {
  const Homogeneous& p = exact();
  return {Rational(p.x[0], p.w), Rational(p.x[1], p.w), Rational(p.x[2], p.w)};
}

Line::Line(QueryPoint p, const RationalPoint& d)
    : p_(std::move(p)),
      d_(homogeneous(d)),
      near_d_{enclosure(d[0]), enclosure(d[1]), enclosure(d[2])},
      is_axis_(std::count(d.begin(), d.end(), Rational(0)) == 2) {
  find_tame();
}

Line::Line(QueryPoint p, std::size_t axis, int d)
    : p_(std::move(p)), d_{{0, 0, 0}, 1}, near_d_{0, 0, 0}, is_axis_(true) {
  d_.x[axis] = d;
  near_d_[axis] = d;
  find_tame();
}

void Line::find_tame() {
  const auto is_tame = [](const Interval& x) { return x.low > -0x1p300 && x.high < 0x1p300; };
  is_tame_ =
      std::all_of(near_d_.begin(), near_d_.end(), is_tame) && std::all_of(p_.near().begin(), p_.near().end(), is_tame);
}

Box Line::way(const Box& within) const {
  Box box = within;
  for (std::size_t k = 0; k < 3; ++k) {
    if (d_.x[k] >= 0) box.low[k] = std::max(box.low[k], whole_below(p_.near()[k].low));
    if (d_.x[k] <= 0) box.high[k] = std::min(box.high[k], whole_above(p_.near()[k].high));
  }
  return box;
}

bool Line::may_meet(const Box& box) const {
  // The way along an axis holds nothing else.
  if (is_axis_ || !is_tame_) return true;
  IntervalPoint b{0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) b[k] = Interval(box.low[k], box.high[k]) - p_.near()[k];
  // Seen along each axis: points of the box on both sides of the line, or on it.
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = i < 2 ? i + 1 : 0;
    if (!holds_zero(near_d_[i] * b[j] - near_d_[j] * b[i])) return false;
  }
  return true;
}

}  // namespace quoin::booleans
