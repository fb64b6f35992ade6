#include "rounding/motion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>
#include <utility>

#include "rounding/enclosure.h"

namespace quoin::rounding {

Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector operator*(const Rational& s, const Vector& v) { return {s * v[0], s * v[1], s * v[2]}; }
Rational dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

namespace {

Vector times(const Matrix& m, const Vector& v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }

Matrix times(const Matrix& a, const Matrix& b) {
  Matrix r;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) r[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  return r;
}

/// A direction in lowest terms.
Axis direction_of(const Vector& v) { return primitive(whole(v, common_denominator(v))); }

bool points_backward(const Axis& a) { return a[0] < 0 || (a[0] == 0 && (a[1] < 0 || (a[1] == 0 && a[2] < 0))); }

/// In (-180, 180].
Rational reduced_angle(const Rational& degrees) {
  const Rational turns = floor_of((degrees + 180) / 360);
  const Rational r = degrees - turns * 360;
  return r == -180 ? Rational(180) : r;
}

/// Of the quaternion that replaces a matrix.
constexpr unsigned matrix_bits = 62;
/// Of s and w / |axis| at first.
constexpr unsigned angle_bits = 46;
/// What no realized angle differs by from the stated one: at the end of the world that is less than rounding moves.
const Rational angle_tolerance(Integer(1), Integer(1) << 92);  // radians

}  // namespace

Vector AffineMap::operator()(const Vector& p) const { return times(linear, p) + shift; }

AffineMap composed(const AffineMap& first, const AffineMap& second) {
  return {times(second.linear, first.linear), second(first.shift)};
}

Rational determinant(const Matrix& m) { return dot(m[0], cross(m[1], m[2])); }

AffineMap inverse(const AffineMap& map) {
  const Rational d = determinant(map.linear);
  assert(d != 0);
  const std::array columns{cross(map.linear[1], map.linear[2]), cross(map.linear[2], map.linear[0]),
                           cross(map.linear[0], map.linear[1])};
  AffineMap r;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) r.linear[i][j] = columns[j][i] / d;
  r.shift = Rational(-1) * times(r.linear, map.shift);
  return r;
}

IntegerMap::IntegerMap(const AffineMap& map) : divisor(common_denominator(map.shift)) {
  for (const Vector& row : map.linear) divisor = lcm(divisor, common_denominator(row));
  shift = whole(map.shift, divisor);
  for (std::size_t i = 0; i < 3; ++i) linear[i] = whole(map.linear[i], divisor);
}

std::array<Integer, 3> IntegerMap::operator()(const Vector& p, unsigned bits) const {
  const Integer common = common_denominator(p);
  const std::array<Integer, 3> n = whole(p, common);
  std::array<Integer, 3> r;
  for (std::size_t i = 0; i < 3; ++i) {
    const Integer image = linear[i][0] * n[0] + linear[i][1] * n[1] + linear[i][2] * n[2] + shift[i] * common;
    r[i] = nearest_integer(Integer(image << bits), Integer(divisor * common));
  }
  return r;
}

// y = (A x + s) / D, so that x = C (D y - s) / t for the cofactors C of A, transposed and in lowest terms, and C A = t.
IntegerMap inverse(const IntegerMap& map) {
  const auto& a = map.linear;
  std::array<Integer, 9> cofactors;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const auto &p = a[(j + 1) % 3], &q = a[(j + 2) % 3];
      cofactors[3 * i + j] = p[(i + 1) % 3] * q[(i + 2) % 3] - p[(i + 2) % 3] * q[(i + 1) % 3];
    }
  const auto c = primitive(std::move(cofactors));
  Integer t = c[0] * a[0][0] + c[1] * a[1][0] + c[2] * a[2][0];
  assert(t != 0);
  const int sign = t.sign();
  IntegerMap r{AffineMap{}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) r.linear[i][j] = sign * c[3 * i + j] * map.divisor;
    r.shift[i] = -sign * (c[3 * i] * map.shift[0] + c[3 * i + 1] * map.shift[1] + c[3 * i + 2] * map.shift[2]);
  }
  r.divisor = sign * t;
  return r;
}

MapFilter::MapFilter(const AffineMap& map) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector& row = map.linear[i];
    const Integer point_limit = Integer(1) << 30, limit = Integer(1) << 53;
    rows_[i] = {
        {exact::to_double(row[0]), exact::to_double(row[1]), exact::to_double(row[2])},
        exact::to_double(map.shift[i]),
        common_denominator(row) == 1 && denominator(map.shift[i]) == 1 &&
            (magnitude(row[0]) + magnitude(row[1]) + magnitude(row[2])) * point_limit + magnitude(map.shift[i]) <
                limit};
  }
}

// Every term is a product of at most three factors (1 + d), |d| <= u = 2^-53 (two numbers rounded, and their product),
// and passes through at most three sums: six factors in all. So the error is at most ((1 + u)^6 - 1) < 7 u times the
// sum of the terms' sizes, and the computed sum is at most 7 u of itself too small: 2^-50 covers 7 u (1 + 8 u).
// Where a number or product underflows its error is at most 2^-1074, times the other factor.
// An infinite or undefined value has an infinite or undefined error.
MapFilter::Estimate MapFilter::operator()(std::size_t k, const std::array<double, 3>& p, bool in_steps) const {
  const Row& row = rows_[k];
  double value = row.shift, size = std::fabs(row.shift), factors = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const double term = row.linear[i] * p[i];
    value += term;
    size += std::fabs(term);
    factors += std::fabs(row.linear[i]) + std::fabs(p[i]);
  }
  if (in_steps && row.is_whole) return {value, 0};
  return {value, 0x1p-50 * size + 0x1p-1000 * factors};
}

Quaternion quaternion(Integer w, Integer x, Integer y, Integer z) {
  const auto v = primitive(std::array{std::move(w), std::move(x), std::move(y), std::move(z)});
  const Integer& first = *std::find_if(v.begin(), v.end(), [](const Integer& n) { return n != 0; });
  if (first < 0) return {-v[0], -v[1], -v[2], -v[3]};
  return {v[0], v[1], v[2], v[3]};
}

Quaternion composed(const Quaternion& p, const Quaternion& q) {
  return quaternion(q.w * p.w - q.x * p.x - q.y * p.y - q.z * p.z, q.w * p.x + q.x * p.w + q.y * p.z - q.z * p.y,
                    q.w * p.y - q.x * p.z + q.y * p.w + q.z * p.x, q.w * p.z + q.x * p.y - q.y * p.x + q.z * p.w);
}

Matrix matrix(const Quaternion& q) {
  const Integer ww = q.w * q.w, xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const Integer n = ww + xx + yy + zz;
  const auto entry = [&](const Integer& v) { return Rational(v, n); };
  return {
      Vector{entry(ww + xx - yy - zz), entry(2 * (q.x * q.y - q.w * q.z)), entry(2 * (q.x * q.z + q.w * q.y))},
      Vector{entry(2 * (q.x * q.y + q.w * q.z)), entry(ww - xx + yy - zz), entry(2 * (q.y * q.z - q.w * q.x))},
      Vector{entry(2 * (q.x * q.z - q.w * q.y)), entry(2 * (q.y * q.z + q.w * q.x)), entry(ww - xx - yy + zz)},
  };
}

namespace {

using Matrix4 = std::array<std::array<Rational, 4>, 4>;

/// 4 q q^T of the rotation's unit quaternion q, if m is a rotation.
Matrix4 quaternion_products(const Matrix& m) {
  return {
      std::array<Rational, 4>{1 + m[0][0] + m[1][1] + m[2][2], m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]},
      {m[2][1] - m[1][2], 1 + m[0][0] - m[1][1] - m[2][2], m[0][1] + m[1][0], m[0][2] + m[2][0]},
      {m[0][2] - m[2][0], m[0][1] + m[1][0], 1 - m[0][0] + m[1][1] - m[2][2], m[1][2] + m[2][1]},
      {m[1][0] - m[0][1], m[0][2] + m[2][0], m[1][2] + m[2][1], 1 - m[0][0] - m[1][1] + m[2][2]}};
}

/// Each row is proportional to the quaternion: the one of largest diagonal.
const std::array<Rational, 4>& largest_row(const Matrix4& products) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (products[i][i] > products[best][best]) best = i;
  return products[best];
}

Rational largest(const std::array<Rational, 4>& v) {
  Rational r = 0;
  for (const Rational& x : v) r = std::max(r, magnitude(x));
  return r;
}

/// The largest entry of m m^T - 1.
Rational defect(const Matrix& m) {
  Rational r = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) r = std::max(r, magnitude(dot(m[i], m[j]) - (i == j ? 1 : 0)));
  return r;
}

}  // namespace

std::optional<Quaternion> quaternion_along(const std::array<Rational, 4>& v) {
  if (largest(v) == 0) return std::nullopt;
  const std::array<Integer, 4> q = whole(v, common_denominator(v));
  return quaternion(q[0], q[1], q[2], q[3]);
}

std::optional<Quaternion> exact_rotation(const Matrix& m) {
  if (defect(m) != 0 || determinant(m) != 1) return std::nullopt;
  return quaternion_along(largest_row(quaternion_products(m)));
}

std::optional<Quaternion> nearest_rotation(const Matrix& m, Rational& deviation) {
  if (defect(m) > Rational(1, 1000000) || determinant(m) < 0) return std::nullopt;
  deviation = 0;
  if (auto q = exact_rotation(m)) return q;
  // The quaternion is the eigenvector of the largest eigenvalue, about 4, of a symmetric matrix whose other eigenvalues
  // are about 0 (B. K. P. Horn, 1987): each step gains 20 bits.
  const Matrix4 products = quaternion_products(m);
  const Integer unit = Integer(1) << 128;
  std::array<Rational, 4> v = largest_row(products);
  for (int step = 0; step < 8; ++step) {
    std::array<Rational, 4> next{0, 0, 0, 0};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) next[i] += products[i][j] * v[j];
    const Rational size = largest(next);
    for (std::size_t i = 0; i < 4; ++i) v[i] = naive_approximation(next[i] / size, unit);
  }
  for (Rational& x : v) x = nearest_integer(x * ((Integer(1) << matrix_bits) - 1));
  const Quaternion q = *quaternion_along(v);
  const Matrix used = matrix(q);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) deviation = std::max(deviation, magnitude(used[i][j] - m[i][j]));
  return q;
}

namespace {

/// The square of tan(degrees / 2) where it is rational: cosines of rational degrees are rational at multiples of 60 and
/// 90 alone (I. Niven, 1956). Nothing elsewhere. Precondition: 0 < degrees < 180.
std::optional<Rational> rational_squared_tangent(const Rational& degrees) {
  if (degrees == 60) return Rational(1, 3);
  if (degrees == 90) return Rational(1);
  if (degrees == 120) return Rational(3);
  return std::nullopt;
}

std::optional<Rational> rational_root(const Rational& v) {
  const Integer n = sqrt(Integer(numerator(v))), d = sqrt(Integer(denominator(v)));
  if (n * n == numerator(v) && d * d == denominator(v)) return Rational(n, d);
  return std::nullopt;
}

/// tan(degrees / 2) / sqrt(norm). Precondition: 0 < degrees < 180.
Enclosure enclosed_ratio(const Rational& degrees, const Integer& norm, unsigned bits) {
  const bool beyond = degrees > 90;
  const Enclosure t = enclosed_tangent(Rational(beyond ? Rational(180 - degrees) : degrees) / 2, bits);
  const Enclosure root = enclosed_root(norm, bits);
  if (!beyond) return {t.low / root.high, t.high / root.low};
  // A cotangent; far more bits than 180 - degrees needs to differ from 0 come before long.
  if (t.low <= 0) return {0, Rational(Integer(1) << bits)};
  return {1 / (t.high * root.high), 1 / (t.low * root.low)};
}

}  // namespace

ApproximateRotation approximate(const RotationStep& step) {
  const Axis& v = step.axis;
  if (step.degrees == 180) return {quaternion(0, v[0], v[1], v[2]), 0, 0};
  const Integer norm = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  const Rational degrees = magnitude(step.degrees);
  const int sign = step.degrees < 0 ? -1 : 1;
  // ratio = s / w for the quaternion w + s v.
  std::optional<Rational> ratio;
  if (const auto squared = rational_squared_tangent(degrees)) ratio = rational_root(*squared / norm);
  Rational radians = 0;
  if (!ratio) {
    const auto direct = [&](unsigned bits) { return enclosed_ratio(degrees, norm, bits); };
    const auto inverted = [&](unsigned bits) {
      const Enclosure e = direct(bits);
      return Enclosure{1 / e.high, e.low > 0 ? Rational(1 / e.low) : Rational(Integer(1) << bits)};
    };
    unsigned bits = 192;
    while (direct(bits).low < 1 && direct(bits).high > 1) bits *= 2;
    const bool is_small = direct(bits).high <= 1;
    // |2 atan(x) - 2 atan(y)| <= 2 |x - y|, and the same for the inverse.
    const Rational factor = 2 * (is_small ? root_above(norm) : root_above(Rational(Integer(1), norm)));
    const Integer length = is_small ? Integer(sqrt(Integer(norm - 1)) + 1) : Integer(1);
    for (unsigned size = angle_bits; !ratio || radians > angle_tolerance; size += 8) {
      ratio = is_small ? best_approximation(direct, length << size, radians)
                       : best_approximation(inverted, length << size, radians);
      radians *= factor;
    }
    if (!is_small) {
      // An angle closer to 180 than any fraction says: 180 itself.
      if (*ratio == 0) return {quaternion(0, v[0], v[1], v[2]), radians, radians * 180 / enclosed_pi(64).low};
      ratio = 1 / *ratio;
    }
  }
  const Integer s = sign * numerator(*ratio);
  return {quaternion(denominator(*ratio), s * v[0], s * v[1], s * v[2]), radians,
          radians == 0 ? Rational(0) : Rational(radians * 180 / enclosed_pi(64).low)};
}

namespace {

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
  Motion m;
  Axis a = direction_of(axis);
  Rational angle = degrees;
  if (points_backward(a)) {
    for (Integer& x : a) x = -x;
    angle = -angle;
  }
  m.add(RotationStep{a, reduced_angle(angle)});
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
  Axis a = direction_of(normal);
  if (points_backward(a))
    for (Integer& x : a) x = -x;
  Motion m;
  m.add(MirrorStep{a});
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

RealizedMotion realized(const Step& step) {
  RealizedMotion m;
  if (const auto* rotation = std::get_if<RotationStep>(&step)) {
    const ApproximateRotation a = approximate(*rotation);
    m.map = map_of(a.by);
    m.rotation = a.by;
    m.angle_error_degrees = a.error_degrees;
    m.displacement_per_unit = a.error_radians;
  } else if (const auto* turn = std::get_if<TurnStep>(&step)) {
    m.map = map_of(turn->by);
    m.rotation = turn->by;
  } else if (const auto* translation = std::get_if<TranslationStep>(&step)) {
    m.map.shift = translation->by;
    m.reach = root_above(dot(translation->by, translation->by));
  } else if (const auto* mirror = std::get_if<MirrorStep>(&step)) {
    m.map = map_of(*mirror);
    m.rotation.reset();
  } else {
    const auto& scaling = std::get<ScalingStep>(step);
    m.map = map_of(scaling);
    m.rotation.reset();
    m.stretch = std::max({scaling.by[0], scaling.by[1], scaling.by[2]});
  }
  return m;
}

RealizedMotion realized(std::span<const Step> steps) {
  if (steps.empty()) return {};
  if (steps.size() == 1) return realized(steps[0]);
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
