#include "booleans/questions/moments.h"

#include <algorithm>
#include <cmath>

namespace quoin::booleans {
namespace {

using exact::Integer;
using exact::Rational;

/// A numerator for each moment, the volume's first.
template <class T>
using Ten = std::array<T, 10>;

/// A cone from the origin over a triangle (p, q, r) with the determinant D has the volume D / 6, the first moments
/// D s / 24 and the second ones D (s s' + p p' + q q' + r r') / 120, where s = p + q + r.
Moments moments_of(const Ten<Rational>& cones) {
  Moments m{cones[0] / 6};
  for (std::size_t k = 0; k < 3; ++k) m.first[k] = cones[1 + k] / 24;
  for (std::size_t k = 0; k < 6; ++k) m.second[k] = cones[4 + k] / 120;
  return m;
}

/// Determinants of grid points are below 2^90, s below 2^31, s s' + .. at most 12 2^58: 2^32 triangles stay below
/// 2^185.
using Wide = exact::Int<192>;

void add_cone(Wide& sum, exact::int128 determinant, std::int64_t factor) {
  sum = exact::narrow<Wide::bits>(sum + exact::Int<91>(determinant) * exact::Int<64>(factor));
}

Ten<Rational> cones_of_triangles(const Body& body) {
  Ten<Wide> sum;
  sum.fill(Wide(0));
  for (const auto& t : body.triangles) {
    const auto &p = body.grid_points[t[0]], &q = body.grid_points[t[1]], &r = body.grid_points[t[2]];
    const auto minor = [&](int i, int j) { return std::int64_t{q[i]} * r[j] - std::int64_t{q[j]} * r[i]; };
    const exact::int128 determinant =
        exact::int128(p[0]) * minor(1, 2) + exact::int128(p[1]) * minor(2, 0) + exact::int128(p[2]) * minor(0, 1);
    const auto s = [&](std::size_t k) { return std::int64_t{p.c[k]} + q.c[k] + r.c[k]; };

    add_cone(sum[0], determinant, 1);
    for (std::size_t k = 0; k < 3; ++k) add_cone(sum[1 + k], determinant, s(k));
    for (std::size_t m = 0; m < 6; ++m) {
      const auto [i, j] = axes_of_moment(m);
      const auto product = [i = i, j = j](const exact::GridPoint& v) { return std::int64_t{v.c[i]} * v.c[j]; };
      add_cone(sum[4 + m], determinant, s(i) * s(j) + product(p) + product(q) + product(r));
    }
  }

  Ten<Rational> r;
  for (std::size_t i = 0; i < r.size(); ++i) r[i] = exact::to_integer(sum[i]);
  return r;
}

/// Unreduced fractions over one denominator.
struct Fractions {
  Ten<Integer> n;
  Integer d;
};

Fractions sum_of(const Fractions& a, const Fractions& b) {
  const Integer common = gcd(a.d, b.d), of_a = b.d / common, of_b = a.d / common;
  Fractions r{{}, a.d * of_a};
  for (std::size_t i = 0; i < r.n.size(); ++i) r.n[i] = a.n[i] * of_a + b.n[i] * of_b;
  return r;
}

/// Sums pairwise, so that long numbers meet long numbers.
class PairwiseSum {
 public:
  void add(Fractions f) {
    for (std::size_t count = count_++; count % 2 == 1; count /= 2) {
      f = sum_of(levels_.back(), f);
      levels_.pop_back();
    }
    levels_.push_back(std::move(f));
  }
  Fractions total() {
    Fractions r{{}, 1};
    for (; !levels_.empty(); levels_.pop_back()) r = sum_of(levels_.back(), r);
    return r;
  }

 private:
  std::vector<Fractions> levels_;
  std::size_t count_ = 0;
};

/// The cone over the triangle of a polygon's edge (u, v) and the point (0, 0, -d / n_k) where axis k meets its plane:
/// with signs these triangles make the polygon. All coordinates over e = n_k w_u w_v.
Fractions cone_of_edge(const exact::Plane& plane, std::size_t k, const exact::Point& u, const exact::Point& v) {
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  const Integer n = plane.n[k], d = exact::to_integer(plane.d), wu = exact::to_integer(u.w),
                wv = exact::to_integer(v.w);
  std::array<Integer, 3> a, b, c{0, 0, 0};
  for (std::size_t m = 0; m < 3; ++m) {
    a[m] = n * wv * exact::to_integer(u.x[m]);
    b[m] = n * wu * exact::to_integer(v.x[m]);
  }
  c[k] = -d * wu * wv;
  const Integer e = n * wu * wv, determinant = -d * exact::to_integer(u.x[i] * v.x[j] - u.x[j] * v.x[i]);
  const auto s = [&](std::size_t m) -> Integer { return a[m] + b[m] + c[m]; };

  Fractions r{{}, e * e * e};
  r.n[0] = determinant * e * e;
  for (std::size_t m = 0; m < 3; ++m) r.n[1 + m] = determinant * s(m) * e;
  for (std::size_t m = 0; m < 6; ++m) {
    const auto [x, y] = axes_of_moment(m);
    r.n[4 + m] = determinant * (s(x) * s(y) + a[x] * a[y] + b[x] * b[y] + c[x] * c[y]);
  }
  return r;
}

Fractions cones_of_polygons(const Body& body) {
  PairwiseSum sum;
  for (std::size_t p = 0; p < body.polygon_count(); ++p) {
    const exact::Plane& plane = body.planes[p];
    if (plane.d == 0) continue;
    const std::size_t k = exact::longest_component(plane.n);
    PairwiseSum of_face;
    body.polygons.for_edges(p, [&](std::uint32_t from, std::uint32_t to) {
      of_face.add(cone_of_edge(plane, k, body.point(from), body.point(to)));
    });
    sum.add(of_face.total());
  }
  return sum.total();
}

Interval square_root(const Interval& x) {
  return Interval::around(std::sqrt(std::max(x.low, 0.0)), std::sqrt(std::max(x.high, 0.0)));
}

Interval corner_coordinate(const Body& body, std::uint32_t v, std::size_t k) {
  const double x = body.approximation(v)[k];
  return body.is_grid(v) ? Interval(x) : Interval::around(x);
}

/// Of a face by its projection along the axis in which its normal is longest.
Interval face_area(const Body& body, std::uint32_t face) {
  const exact::Plane plane = body.sign_plane(face);
  const auto n = [&](std::size_t k) { return Interval::around(std::fabs(static_cast<double>(plane.n[k]))); };
  const Interval length = square_root(n(0) * n(0) + n(1) * n(1) + n(2) * n(2));
  if (face < body.triangles.size()) return length * 0.5;

  const std::size_t k = exact::longest_component(plane.n), i = (k + 1) % 3, j = (k + 2) % 3;
  const std::uint32_t first = body.corners_of(face).front();
  const auto offset = [&](std::uint32_t v, std::size_t axis) {
    return corner_coordinate(body, v, axis) - corner_coordinate(body, first, axis);
  };
  Interval twice = 0;
  body.for_edges(face, [&](std::uint32_t u, std::uint32_t v) {
    if (u != first && v != first) twice = twice + offset(u, i) * offset(v, j) - offset(u, j) * offset(v, i);
  });
  if (plane.n[k] < 0) twice = -twice;
  return Interval(std::max(twice.low, 0.0), twice.high) * 0.5 * length / n(k);
}

}  // namespace

Moments moments(const Index& index) {
  Ten<Rational> cones = cones_of_triangles(index.body());
  const Fractions polygons = cones_of_polygons(index.body());
  for (std::size_t i = 0; i < cones.size(); ++i) cones[i] += Rational(polygons.n[i], polygons.d);
  return moments_of(cones);
}

Interval area(const Index& index) {
  constexpr std::size_t stretch = std::size_t{1} << 10;
  const std::size_t count = index.body().face_count();
  std::vector<Interval> parts(count / stretch + 1, Interval(0));
  grid::in_stretches(count, stretch, [&](std::size_t s, std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
      parts[s] = parts[s] + face_area(index.body(), static_cast<std::uint32_t>(f));
  });

  Interval sum = 0;
  for (const Interval& part : parts) sum = sum + part;
  return Interval(std::max(sum.low, 0.0), sum.high);
}

}  // namespace quoin::booleans
