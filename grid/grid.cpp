#include "grid/grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "grid/snap.h"

namespace quoin::grid {

using exact::Integer;
using exact::Rational;

namespace {

Rational power_of_two(long e) {
  const Integer p = Integer(1) << static_cast<unsigned long>(e < 0 ? -e : e);
  return e < 0 ? Rational(Integer(1), p) : Rational(p);
}

/// The smallest e with v <= 2^e. Precondition: v > 0.
long ceil_log2(const Rational& v) {
  const Integer n = numerator(v), d = denominator(v);
  // v < 2^(bits(n) - bits(d) + 1) and v > 2^(bits(n) - bits(d) - 1).
  long e = static_cast<long>(mpz_sizeinbase(n.backend().data(), 2)) -
           static_cast<long>(mpz_sizeinbase(d.backend().data(), 2)) + 1;
  while (v <= power_of_two(e - 1)) --e;
  return e;
}

/// Nearest integer, halves upward.
Integer nearest_integer(const Rational& v) {
  const Rational shifted = v + Rational(1, 2);
  Integer q, r;
  divide_qr(numerator(shifted), denominator(shifted), q, r);
  if (r < 0) --q;
  return q;
}

constexpr int fitting_bits = 26;
static_assert(fitting_bound == 1 << fitting_bits);
constexpr long least_exponent = -1074, far_exponent = 10;

/// Centred lattice of the least step 2^e', e' >= e.
Lattice centred_lattice(const std::array<Rational, 3>& low, const std::array<Rational, 3>& high, long e) {
  for (;; ++e) {
    Lattice lattice;
    lattice.step = power_of_two(e);
    const Rational reach = lattice.step * fitting_bound;
    bool fits = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational centre = (low[k] + high[k]) / 2;
      lattice.origin[k] = nearest_integer(centre / lattice.step) * lattice.step;
      fits = fits && high[k] - lattice.origin[k] <= reach && lattice.origin[k] - low[k] <= reach;
    }
    if (fits) return lattice;
  }
}

int bit_length(std::int64_t v) { return v == 0 ? 0 : 64 - __builtin_clzll(static_cast<std::uint64_t>(v < 0 ? -v : v)); }

template <int Bits>
int bit_length(const exact::Int<Bits>& v) {
  const exact::Leading l = exact::leading(v);
  return l.top == 0 ? 0 : l.exponent + 64;
}

/// Whether v lies exactly between two floats, or where rounding to float overflows.
bool halfway_between_floats(double v, float rounded) {
  if (std::isinf(rounded)) return true;
  const double f = rounded;
  if (f == v) return false;
  const double other = std::nextafterf(rounded, v > f ? HUGE_VALF : -HUGE_VALF);
  return v - f == other - v;  // both differences are exact
}

}  // namespace

Result<Lattice> fitting_lattice(const std::array<double, 3>& low, const std::array<double, 3>& high) {
  double farthest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!std::isfinite(low[k]) || !std::isfinite(high[k])) {
      const bool is_low = !std::isfinite(low[k]);
      return Error{ErrorCode::non_finite,
                   "a box with an infinite or undefined coordinate fits no grid",
                   {},
                   std::string(is_low ? "low" : "high") + " corner " + describe_point((is_low ? low : high).data())};
    }
    assert(low[k] <= high[k]);
    farthest = std::max({farthest, std::fabs(low[k]), std::fabs(high[k])});
  }

  if (farthest > 0x1p1020) {
    const bool is_low = std::any_of(low.begin(), low.end(), [](double x) { return std::fabs(x) > 0x1p1020; });
    return Error{ErrorCode::out_of_range,
                 "coordinates beyond 2^1020 fit no grid; scale the model down",
                 {},
                 std::string(is_low ? "low" : "high") + " corner " + describe_point((is_low ? low : high).data())};
  }

  Lattice lattice;
  if (farthest == 0) return lattice;
  const long distance_exponent = ceil_log2(exact::to_rational(farthest)) - fitting_bits;

  std::array<Rational, 3> l, h;
  Rational size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    l[k] = exact::to_rational(low[k]);
    h[k] = exact::to_rational(high[k]);
    size = std::max<Rational>(size, h[k] - l[k]);
  }
  if (size > 0) {
    const long size_exponent = std::max(ceil_log2(size) - 1 - fitting_bits, least_exponent);
    if (distance_exponent > size_exponent + far_exponent) return centred_lattice(l, h, size_exponent);
  }

  lattice.step = power_of_two(std::max(distance_exponent, least_exponent));
  return lattice;
}

Rational model_coordinate(const Lattice& lattice, const exact::Point& point, int k) {
  return lattice.origin[static_cast<std::size_t>(k)] + lattice.step * exact::coordinate(point, k);
}

Rational model_coordinate(const Lattice& lattice, std::int32_t grid_coordinate, int k) {
  return lattice.origin[static_cast<std::size_t>(k)] + lattice.step * grid_coordinate;
}

namespace {

std::size_t lowest_bit(const Integer& n) { return lsb(n); }
std::size_t lowest_bit(exact::int128 n) {
  const auto low = static_cast<std::uint64_t>(n);
  return static_cast<std::size_t>(low != 0 ? std::countr_zero(low)
                                           : 64 + std::countr_zero(static_cast<std::uint64_t>(n >> 64)));
}

/// Of offsets, then a factor, over one denominator.
template <class Number>
std::optional<Affine> affine(const std::array<Number, 4>& scaled, const Number& common) {
  const auto magnitude = [](const Number& n) -> Number { return n < 0 ? Number(-n) : n; };

  // Twos move into the exponent.
  auto twos = lowest_bit(scaled[3]);
  for (std::size_t k = 0; k < 3; ++k)
    if (scaled[k] != 0) twos = std::min(twos, lowest_bit(magnitude(scaled[k])));
  const auto below = lowest_bit(common);
  const long exponent = static_cast<long>(twos) - static_cast<long>(below);
  const Number limit = Number(1) << 53, d = common >> below, factor = scaled[3] >> twos;
  if (exponent < -700 || exponent > 700 || d > limit || factor > limit) return std::nullopt;

  Affine r{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Number m = magnitude(scaled[k]) >> twos;
    if (m + (factor << 31) > limit) return std::nullopt;
    r.offset[k] = static_cast<std::int64_t>(m) * (scaled[k] < 0 ? -1 : 1);
  }
  r.factor = static_cast<std::int64_t>(factor);
  r.denominator = static_cast<std::int64_t>(d);
  r.exponent = static_cast<int>(exponent);
  return r;
}

}  // namespace

std::optional<Affine> affine(const Lattice& lattice) {
  assert(lattice.step > 0);
  const mpq_t& step = lattice.step.backend().data();
  const bool at_zero =
      std::all_of(lattice.origin.begin(), lattice.origin.end(), [](const Rational& x) { return x.is_zero(); });
  if (at_zero && mpz_fits_slong_p(mpq_numref(step)) && mpz_fits_slong_p(mpq_denref(step)))
    return affine<exact::int128>({0, 0, 0, mpz_get_si(mpq_numref(step))}, mpz_get_si(mpq_denref(step)));

  const auto [scaled, common] =
      exact::over_common_denominator(std::array{lattice.origin[0], lattice.origin[1], lattice.origin[2], lattice.step});
  return affine<Integer>(scaled, common);
}

Rounder::Rounder(const Lattice& lattice) : lattice_(lattice), affine_(affine(lattice)) {
  if (!affine_) return;
  scale_ = std::ldexp(1.0, affine_->exponent);
  const bool power = affine_->denominator == 1 && (affine_->factor & (affine_->factor - 1)) == 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (power && affine_->offset[k] == 0) scaling_[k] = scale_ * static_cast<double>(affine_->factor);
}

// The quotient of two doubles is correctly rounded, and a zero numerator gives +0.
double Rounder::to_double(std::int32_t grid_coordinate, int k) const {
  if (!affine_) return exact::to_double(model_coordinate(lattice_, grid_coordinate, k));
  const std::int64_t n = affine_->offset[static_cast<std::size_t>(k)] + affine_->factor * grid_coordinate;
  return static_cast<double>(n) / static_cast<double>(affine_->denominator) * scale_;
}

double Rounder::to_double(const exact::Point& point, int k) const {
  const auto i = static_cast<std::size_t>(k);
  // Rounding commutes with scaling by a power of two: nothing here is below 2^-188 but 0.
  if (scaling_[i] != 0) return point.approximation[i] * scaling_[i];

  if (affine_) {
    const exact::Numerator& x = point.x[i];
    const exact::Denominator& w = point.w;
    const int length = bit_length(w);
    if (bit_length(affine_->offset[i]) + length < exact::Numerator::bits - 1 &&
        bit_length(affine_->factor) + bit_length(x) < exact::Numerator::bits - 1 &&
        bit_length(affine_->denominator) + length < exact::Denominator::bits) {
      const exact::Int<64> offset(affine_->offset[i]), factor(affine_->factor), denominator(affine_->denominator);
      // Each term is below 2^249, the denominator below 2^188.
      const auto n = exact::narrow<exact::Numerator::bits>(offset * w + factor * x);
      return exact::rounded_quotient(n, exact::narrow<exact::Denominator::bits>(denominator * w)) * scale_;
    }
  }

  return exact::to_double(model_coordinate(lattice_, point, k));
}

// Every point halfway between two floats is a double, so the rounded double lies on the same side of it as the exact
// value, or on it.
float Rounder::to_float(std::int32_t grid_coordinate, int k) const {
  const double v = to_double(grid_coordinate, k);
  const float f = static_cast<float>(v);
  return halfway_between_floats(v, f) ? exact::to_float(model_coordinate(lattice_, grid_coordinate, k)) : f;
}

float Rounder::to_float(const exact::Point& point, int k) const {
  const double v = to_double(point, k);
  const float f = static_cast<float>(v);
  return halfway_between_floats(v, f) ? exact::to_float(model_coordinate(lattice_, point, k)) : f;
}

std::optional<exact::Plane> grid_plane(const Lattice& lattice, const std::array<Rational, 4>& model_plane) {
  std::array<Rational, 4> p;
  p[3] = model_plane[3];
  bool zero = true;
  for (std::size_t k = 0; k < 3; ++k) {
    zero = zero && model_plane[k] == 0;
    p[k] = model_plane[k] * lattice.step;
    p[3] += model_plane[k] * lattice.origin[k];
  }
  if (zero) return std::nullopt;

  const std::array<Integer, 4> n = exact::primitive(p);
  const Integer limit = exact::coefficient_limit, offset_limit = exact::to_integer(exact::offset_limit);

  exact::Plane r{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (abs(n[k]) > limit) return std::nullopt;
    r.n[k] = static_cast<std::int64_t>(n[k]);
  }
  if (abs(n[3]) > offset_limit) return std::nullopt;
  r.d = exact::to_int<exact::Offset::bits>(n[3])->low();
  return r;
}

}  // namespace quoin::grid
