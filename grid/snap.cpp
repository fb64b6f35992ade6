#include "grid/snap.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "exact/filter_bounds.h"
#include "exact/ladder.h"
#include "exact/predicates.h"
#include "grid/lists/stretches.h"

namespace quoin::grid {

using exact::GridPoint;
using exact::int128;
using exact::Integer;
using exact::Rational;

namespace {

constexpr double world = exact::world;
/// Adding and subtracting it rounds |v| < 2^51 to the nearest integer, ties to even.
constexpr double rounding_constant = 0x1.8p52;

double nearest(double v) { return (v + rounding_constant) - rounding_constant; }

/// An upper bound of sqrt(squared) steps in model units; positive. With u = 2^-53 the first factor, 1 + 16 u, covers
/// less than 3.6 u: half of a square's and two sums', the root's and the product's rounding. The other, 1 + 8 u, covers
/// two products. Below 2^-1000 the squares may have underflowed, but then the length is below 2^-499; a product that
/// small may have underflowed, too, and is rounded upward instead.
double length_bound(double squared, const Rational& step) {
  const double length = squared < 0x1p-1000 ? 0x1p-499 : std::sqrt(squared) * (1 + 0x1p-49);
  const double bound = length * exact::to_double(step) * (1 + 0x1p-50);
  return bound < 0x1p-1000 ? exact::double_above(exact::to_rational(length) * step) : bound;
}

/// How far points moved.
struct Moves {
  bool fit = true;     // every point has a place
  double worst = 0;    // the largest squared length, steps
  bool moved = false;  // some point did
};

/// Step 2^e and origin 0: scaling is exact (or underflows, far below one half).
Moves snap_scaled(std::span<const double> points, double step, std::span<GridPoint> snapped) {
  const double scale = 1 / step;
  Moves moves;
  for (std::size_t i = 0; i < snapped.size(); ++i) {
    const double* const p = &points[3 * i];
    const double x = p[0] * scale, y = p[1] * scale, z = p[2] * scale;
    const double a = nearest(x), b = nearest(y), c = nearest(z);
    // Also false for values that are not numbers; beyond 2^51 rounding is not to integers, but still monotone.
    if (!(std::fabs(a) <= world && std::fabs(b) <= world && std::fabs(c) <= world)) return {false};
    snapped[i] = {{static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), static_cast<std::int32_t>(c)}};

    const double dx = x - a, dy = y - b, dz = z - c;  // exact
    moves.worst = std::max(moves.worst, dx * dx + dy * dy + dz * dz);
    moves.moved = moves.moved | (a * step != p[0]) | (b * step != p[1]) | (c * step != p[2]);
  }
  return moves;
}

/// Any other lattice.
class Snapper {
 public:
  explicit Snapper(const Lattice& lattice) : lattice_(lattice), affine_(affine(lattice)) {
    const double step = exact::to_double(lattice.step);
    inverse_ = exact::to_double(1 / lattice.step);
    guarded_ = step > 0x1p-900 && step < 0x1p900;
    for (std::size_t k = 0; k < 3; ++k) {
      origin_[k] = exact::to_double(lattice.origin[k]);
      const double o = std::fabs(origin_[k]);
      guarded_ = guarded_ && (lattice.origin[k] == 0 || o > 0x1p-900) && o < 0x1p900;
      slack_[k] = exact::snap_origin * exact::unit_roundoff * o * inverse_ + exact::snap_floor;
    }
  }

  /// The nearest grid coordinate, possibly beyond the world, where it is +-2^30; `distance` is an upper bound of the
  /// move in steps; with `look_closely` it is 0 when there is none. Precondition: v is finite.
  std::int32_t operator()(double v, std::size_t k, bool look_closely, double& distance) const {
    if (guarded_) {
      // With u the unit roundoff, Y = (v - O) / s, o = O (1 + d0), 1 / s rounded (d2), and one rounding each in the
      // difference (d1) and the product (d3, or 2^-1075 of underflow):
      //   y - Y = y (P - 1) / P - d0 O / s with P = (1 + d1)(1 + d2)(1 + d3),
      // at most 3.01 u |y| + u |O / s| + 2^-1074. `bound` is more than that by u |y|, and |f| <= |y|, so that the sum
      // of the two has room for its rounding; 2^-60 covers the terms in u^2. Proved by docs/proofs/snap_filter.g.
      const double y = (v - origin_[k]) * inverse_;
      if (std::fabs(y) < 2 * world) {
        const double bound = exact::snap_bound * exact::unit_roundoff * std::fabs(y) + slack_[k];
        const double m = nearest(y), f = y - m;
        if (std::fabs(f) + bound < 0.5) {  // holds for the exact sum when it holds for the rounded one
          distance = std::fabs(f) + bound;
          // No move makes |f| = |y - Y|.
          if (look_closely && std::fabs(f) <= bound && is_exact(v, k, static_cast<std::int32_t>(m))) distance = 0;
          return static_cast<std::int32_t>(m);
        }

        if (bound < 0.25 && affine_) {
          const auto below = static_cast<std::int32_t>(f < 0 ? m - 1 : m);
          if (const auto order = compare(v, k, 2 * std::int64_t{below} + 1)) {
            distance = 0.5;
            return *order == 0 ? below + (below & 1) : *order < 0 ? below : below + 1;
          }
        }
      }
    }

    return snap_exactly(v, k, distance);
  }

 private:
  /// The sign of (v - O) / s - twice / 2 by 128-bit integers: 2 v denominator 2^-exponent against
  /// 2 offset + twice factor. Nothing when they do not fit.
  std::optional<int> compare(double v, std::size_t k, std::int64_t twice) const {
    int e = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(v, &e), 53));
    int128 left = int128(2 * mantissa) * affine_->denominator;                        // below 2^108
    int128 right = int128(affine_->offset[k]) * 2 + int128(twice) * affine_->factor;  // below 2^56

    const int shift = v == 0 ? 0 : e - 53 - affine_->exponent;
    if (shift > 18 || shift < -70) return std::nullopt;
    if (shift >= 0)
      left *= int128(1) << shift;
    else
      right *= int128(1) << -shift;
    return left < right ? -1 : left > right ? 1 : 0;
  }

  bool is_exact(double v, std::size_t k, std::int32_t i) const {
    if (affine_)
      if (const auto order = compare(v, k, 2 * std::int64_t{i})) return *order == 0;
    return exact::to_rational(v) == lattice_.origin[k] + lattice_.step * i;
  }

  std::int32_t snap_exactly(double v, std::size_t k, double& distance) const {
    const Rational y = (exact::to_rational(v) - lattice_.origin[k]) / lattice_.step;
    distance = 0;
    if (abs(y) > 2 * Rational(exact::world)) return y < 0 ? -2 * exact::world : 2 * exact::world;

    Integer q, r;
    divide_qr(numerator(y), denominator(y), q, r);
    if (r < 0) {
      --q;
      r += denominator(y);
    }
    const int half = Integer(2 * r).compare(denominator(y));
    if (half > 0 || (half == 0 && bit_test(Integer(abs(q)), 0))) ++q;

    const Rational move = abs(y - q);
    if (move != 0) distance = std::nextafter(exact::to_double(move), 1.0);
    return static_cast<std::int32_t>(q);
  }

  Lattice lattice_;
  std::optional<Affine> affine_;
  bool guarded_ = false;
  double inverse_ = 0;
  std::array<double, 3> origin_ = {}, slack_ = {};
};

Moves snap_any(std::span<const double> points, const Snapper& snapper, std::span<GridPoint> snapped) {
  Moves moves;
  for (std::size_t i = 0; i < snapped.size(); ++i) {
    double squared = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double v = points[3 * i + k];
      if (!std::isfinite(v)) return {false};
      double distance = 0;
      const std::int32_t c = snapper(v, k, !moves.moved, distance);
      if (c < -exact::world || c > exact::world) return {false};

      snapped[i].c[k] = c;
      squared += distance * distance;
      moves.moved = moves.moved | (distance != 0);
    }
    moves.worst = std::max(moves.worst, squared);
  }
  return moves;
}

/// Snaps all points stretch by stretch.
template <class Snap>
Moves snap_all(std::span<const double> points, std::span<GridPoint> snapped, Snap snap) {
  const std::size_t length = stretch(std::size_t{1} << 15);
  Array<Moves> parts(snapped.size() / length + 1);
  in_stretches(snapped.size(), length, [&](std::size_t s, std::size_t begin, std::size_t end) {
    parts[s] = snap(points.subspan(3 * begin, 3 * (end - begin)), snapped.subspan(begin, end - begin));
  });
  Moves all;
  for (const Moves& m : parts) all = {all.fit && m.fit, std::max(all.worst, m.worst), all.moved || m.moved};
  return all;
}

bool in_world(const Lattice& lattice, double v, std::size_t k) {
  // The nearest grid coordinate, ties to even, is at most 2^29 exactly up to 2^29 + 1/2.
  const Rational reach = lattice.step * (Rational(exact::world) + Rational(1, 2));
  return abs(Rational(exact::to_rational(v) - lattice.origin[k])) <= reach;
}

/// The least step * 2^j that holds every point.
Rational sufficient_step(std::span<const double> points, const Lattice& lattice) {
  std::array<double, 3> low, high;
  for (std::size_t k = 0; k < 3; ++k) low[k] = high[k] = points[k];
  for (std::size_t i = 0; i < points.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], points[i]);
    high[i % 3] = std::max(high[i % 3], points[i]);
  }
  Lattice wider = lattice;
  for (std::size_t k = 0; k < 3; ++k)
    while (!in_world(wider, low[k], k) || !in_world(wider, high[k], k)) wider.step *= 2;
  return wider.step;
}

/// Why some point has no place.
Error refusal(std::span<const double> points, const Lattice& lattice) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!std::isfinite(points[i])) {
      const std::string vertex = std::to_string(i / 3);
      return {ErrorCode::non_finite,
              "vertex " + vertex + " has an infinite or undefined coordinate",
              {},
              "vertex " + vertex + " " + describe_point(&points[i - i % 3])};
    }

  std::size_t i = 0;
  while (in_world(lattice, points[i], i % 3)) ++i;
  const std::string vertex = std::to_string(i / 3);
  return {ErrorCode::out_of_range,
          "vertex " + vertex + " lies more than 2^29 grid steps from the origin; a step of " +
              exact::to_string(sufficient_step(points, lattice)) + " would do (it is " +
              exact::to_string(lattice.step) + ")",
          {},
          "vertex " + vertex + " " + describe_point(&points[i - i % 3])};
}

}  // namespace

std::string describe_number(double value) {
  std::array<char, 40> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

std::string describe_point(const double* point) {
  return "(" + describe_number(point[0]) + ", " + describe_number(point[1]) + ", " + describe_number(point[2]) + ")";
}

std::string describe_point(const Lattice& lattice, const GridPoint& point) {
  const Rounder rounder(lattice);
  const std::array<double, 3> p{rounder.to_double(point[0], 0), rounder.to_double(point[1], 1),
                                rounder.to_double(point[2], 2)};
  return describe_point(p.data());
}

Result<Snapped> snap(std::span<const double> points, const Lattice& lattice) {
  assert(points.size() % 3 == 0);
  Snapped result;
  result.points.resize(points.size() / 3);

  const auto a = affine(lattice);
  const bool at_zero =
      std::all_of(lattice.origin.begin(), lattice.origin.end(), [](const Rational& x) { return x.is_zero(); });
  const bool scaled = a && a->factor == 1 && a->denominator == 1 && at_zero;
  Moves moves;
  if (scaled) {
    const double step = std::ldexp(1.0, a->exponent);
    moves = snap_all(points, result.points, [&](auto in, auto out) { return snap_scaled(in, step, out); });
    if (moves.moved) result.max_snap = length_bound(moves.worst, lattice.step);
  } else {
    const Snapper snapper(lattice);
    moves = snap_all(points, result.points, [&](auto in, auto out) { return snap_any(in, snapper, out); });
    // One more factor for the step's own rounding.
    if (moves.moved) result.max_snap = length_bound(moves.worst, lattice.step) * (1 + 0x1p-50);
  }

  if (!moves.fit) return refusal(points, lattice);
  return Result<Snapped>(std::move(result));
}

}  // namespace quoin::grid
