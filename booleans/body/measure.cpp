#include "booleans/body/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace quoin::booleans {
namespace {

using exact::Integer;
using exact::Rational;

/// An unreduced fraction, denominator > 0.
struct Fraction {
  Integer n = 0, d = 1;
};

/// Sums fractions pairwise, so that long numbers meet long numbers.
class Sum {
 public:
  void add(Fraction f) {
    std::size_t level = 0;
    for (; level < levels_.size() && full_[level]; ++level) {
      f = combined(levels_[level], f);
      full_[level] = false;
    }
    if (level == levels_.size()) {
      levels_.emplace_back();
      full_.push_back(false);
    }
    levels_[level] = std::move(f);
    full_[level] = true;
  }
  Rational total() const {
    Fraction r;
    for (std::size_t i = 0; i < levels_.size(); ++i)
      if (full_[i]) r = combined(r, levels_[i]);
    return Rational(r.n, r.d);
  }

 private:
  static Fraction combined(const Fraction& a, const Fraction& b) {
    if (a.d == b.d) return {a.n + b.n, a.d};
    return {a.n * b.d + b.n * a.d, a.d * b.d};
  }
  std::vector<Fraction> levels_;
  std::vector<bool> full_;
};

/// Six times the signed volume of the raw triangles: each determinant is at most 6 * 2^87, so 2^32 of them fit.
exact::int128 six_volumes(const Body& body) {
  exact::int128 sum = 0;
  for (const auto& t : body.triangles) {
    const auto &p = body.grid_points[t[0]], &q = body.grid_points[t[1]], &r = body.grid_points[t[2]];
    const auto minor = [&](int i, int j) { return std::int64_t{q[i]} * r[j] - std::int64_t{q[j]} * r[i]; };
    sum += exact::int128(p[0]) * minor(1, 2) + exact::int128(p[1]) * minor(2, 0) + exact::int128(p[2]) * minor(0, 1);
  }
  return sum;
}

/// visit(fraction) for the volumes that the edges of polygons contribute, unreduced.
///
/// A polygon with plane n . x + d = 0 and area A n / |n| spans the cone of volume -d A / (3 |n|) from the origin. Its
/// projection along axis k has the area A_k = A n_k / |n|, so the cone is -d A_k / (3 n_k): no triangulation needed.
template <class Visit>
void for_fractions(const Body& body, Visit&& visit) {
  for (std::size_t p = 0; p < body.polygon_count(); ++p) {
    const exact::Plane& plane = body.planes[p];
    if (plane.d == 0) continue;
    const std::size_t k = exact::longest_component(plane.n), u = (k + 1) % 3, v = (k + 2) % 3;
    const Integer factor = -exact::to_integer(plane.d), divisor = 6 * Integer(plane.n[k]);

    body.polygons.for_edges(p, [&](std::uint32_t from, std::uint32_t to) {
      const exact::Point a = body.point(from), b = body.point(to);
      const Integer cross = exact::to_integer(a.x[u] * b.x[v] - b.x[u] * a.x[v]);
      Fraction f{factor * cross, divisor * exact::to_integer(a.w) * exact::to_integer(b.w)};
      if (f.d < 0) f = {-f.n, -f.d};
      visit(std::move(f));
    });
  }
}

constexpr int fraction_bits = 160;
/// A coordinate in units of 2^-fraction_bits, cut off towards 0.
using Fixed = exact::Int<exact::world_bits + 2 + fraction_bits>;
static_assert(Fixed::words == 3);

/// x / w. Precondition: of a point in the world.
Fixed fixed(const exact::Numerator& x, const exact::Denominator& w) {
  using Scaled = exact::Int<exact::Numerator::bits + fraction_bits>;
  const Scaled scaled = exact::shifted_left(Scaled(x.negative() ? -x : x), fraction_bits);
  std::array<mp_limb_t, Scaled::words> n, q{};
  std::array<mp_limb_t, exact::Denominator::words> d, rest;
  static_assert(sizeof(mp_limb_t) == sizeof(std::uint64_t));
  for (int i = 0; i < Scaled::words; ++i) n[static_cast<std::size_t>(i)] = scaled.limb(i);
  for (int i = 0; i < exact::Denominator::words; ++i) d[static_cast<std::size_t>(i)] = w.limb(i);
  auto words = static_cast<mp_size_t>(d.size());
  while (d[static_cast<std::size_t>(words - 1)] == 0) --words;
  mpn_tdiv_qr(q.data(), rest.data(), 0, n.data(), static_cast<mp_size_t>(n.size()), d.data(), words);

  const auto word = [&](std::size_t i) {
    return exact::shifted_left(Fixed(exact::int128(q[i])), static_cast<int>(64 * i));
  };
  const Fixed size = exact::narrow<Fixed::bits>(word(0) + word(1) + word(2));
  return x.negative() ? -size : size;
}

/// A number that lies within `radius` of `middle`.
struct Enclosure {
  Rational middle, radius;
};

/// The volume of the polygons' cones, as `for_fractions` has it, from coordinates cut off after fraction_bits bits.
///
/// With e = 2^-fraction_bits and coordinates of at most 2^29 the cross product of an edge is off by less than
/// 4 2^29 e + 2 e^2. The polygon's plane has a point of the world, and no component of its normal is longer than n_k,
/// so |d / n_k| <= 3 2^29, and the edge's volume is off by less than (2^31 e) (3 2^29) / 6 = 2^59 e; 2^60 e leaves room
/// for the quotients that are cut off.
Enclosure polygon_volume(const Body& body) {
  std::array<Array<Fixed>, 3> place;
  for (std::size_t k = 0; k < 3; ++k) {
    place[k].reserve(body.points.size());
    for (const exact::Point& p : body.points) place[k].push_back(fixed(p.x[k], p.w));
  }
  const auto coordinate = [&](std::uint32_t v, std::size_t k) {
    return body.is_grid(v) ? exact::shifted_left(Fixed(body.grid_points[v].c[k]), fraction_bits)
                           : place[k][v - body.derived_base()];
  };

  Integer sum = 0;  // six volumes, in units of 2^(-2 fraction_bits)
  std::size_t edges = 0;
  for (std::size_t p = 0; p < body.polygon_count(); ++p) {
    const exact::Plane& plane = body.planes[p];
    if (plane.d == 0) continue;
    const std::size_t k = exact::longest_component(plane.n), u = (k + 1) % 3, v = (k + 2) % 3;

    exact::Int<2 * Fixed::bits + 33> area(0);  // of at most 2^32 edges
    body.polygons.for_edges(p, [&](std::uint32_t a, std::uint32_t b) {
      const auto cross = coordinate(a, u) * coordinate(b, v) - coordinate(b, u) * coordinate(a, v);
      area = exact::narrow<decltype(area)::bits>(area + cross);
      ++edges;
    });
    sum -= exact::to_integer(area) * exact::to_integer(plane.d) / plane.n[k];
  }

  const Integer unit = Integer(1) << (2 * fraction_bits);
  return {Rational(sum, 6 * unit), Rational(Integer(edges), Integer(1) << (fraction_bits - 60))};
}

/// The volumes of raw triangles' cones, together.
Rational raw_volume(const Body& body) { return Rational(exact::to_integer(six_volumes(body)), Integer(6)); }

}  // namespace

Rational volume(const Body& body) {
  if (!body.is_packed) return volume(packed(body));
  Sum sum;
  for_fractions(body, [&](Fraction&& f) { sum.add(std::move(f)); });
  return sum.total() + raw_volume(body);
}

std::size_t volume_bits(const Body& body) {
  if (!body.is_packed) return volume_bits(packed(body));
  // Of tetrahedra from the origin over triangles between vertices each has a multiple of 6 and the denominators of its
  // three vertices as a denominator.
  std::size_t bits = 0;
  for (const exact::Point& p : body.points) bits += static_cast<std::size_t>(64 + exact::leading(p.w).exponent);
  return bits;
}

double rounded_volume(const Body& body, const Rational& scale) {
  if (!body.is_packed) return rounded_volume(packed(body), scale);

  const Enclosure polygons = polygon_volume(body);
  const Rational middle = raw_volume(body) + polygons.middle;
  const double low = exact::to_double((middle - polygons.radius) * scale);
  if (low == exact::to_double((middle + polygons.radius) * scale)) return low;
  return exact::to_double(volume(body) * scale);
}

double approximate_area(const Body& body) {
  if (!body.is_packed) return approximate_area(packed(body));

  const auto twice = [](const std::array<double, 3>& p, const std::array<double, 3>& q,
                        const std::array<double, 3>& r) {
    const double ax = q[0] - p[0], ay = q[1] - p[1], az = q[2] - p[2], bx = r[0] - p[0], by = r[1] - p[1],
                 bz = r[2] - p[2];
    return std::array<double, 3>{ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx};
  };

  double area = 0;
  for (const auto& t : body.triangles) {
    const auto c = twice(body.approximation(t[0]), body.approximation(t[1]), body.approximation(t[2]));
    area += std::sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]) / 2;
  }

  for (std::size_t p = 0; p < body.polygon_count(); ++p) {
    std::array<double, 3> sum{};
    const auto origin = body.approximation(body.polygons.corners_of(p).front());
    body.polygons.for_edges(p, [&](std::uint32_t from, std::uint32_t to) {
      const auto c = twice(origin, body.approximation(from), body.approximation(to));
      for (std::size_t k = 0; k < 3; ++k) sum[k] += c[k];
    });
    area += std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]) / 2;
  }
  return area;
}

namespace {

/// visit(v) for the vertices of all faces, each at least once.
template <class Visit>
void for_used_vertices(const Body& body, Visit&& visit) {
  for (const auto& t : body.triangles)
    for (const std::uint32_t v : t) visit(v);
  for (const std::uint32_t v : body.polygons.corners) visit(v);
}

}  // namespace

std::optional<std::array<std::array<double, 3>, 2>> rounded_box(const Body& body, const grid::Lattice& lattice) {
  if (!body.is_packed) return rounded_box(packed(body), lattice);
  if (body.face_count() == 0) return std::nullopt;

  // In steps first. Rounding is monotone: what is least has the least approximation, and what is least of those that
  // have it, rounded to model units, is the least of all.
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  for_used_vertices(body, [&](std::uint32_t v) {
    const auto p = body.approximation(v);
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  });

  std::array<std::array<double, 3>, 2> box{{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}}};
  const grid::Rounder rounder(lattice);
  const auto rounded = [&](std::uint32_t v, std::size_t k) {
    const int axis = static_cast<int>(k);
    return body.is_grid(v) ? rounder.to_double(body.grid_points[v][axis], axis)
                           : rounder.to_double(body.derived(v), axis);
  };
  for_used_vertices(body, [&](std::uint32_t v) {
    const auto p = body.approximation(v);
    for (std::size_t k = 0; k < 3; ++k) {
      if (p[k] == low[k]) box[0][k] = std::min(box[0][k], rounded(v, k));
      if (p[k] == high[k]) box[1][k] = std::max(box[1][k], rounded(v, k));
    }
  });
  return box;
}

}  // namespace quoin::booleans
