#include "exact/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "tests/exact/support.h"

namespace quoin::exact::testing {
namespace {

constexpr std::int64_t limit = coefficient_limit;
using Vector = std::array<Rational, 3>;

Vector normal(const Plane& p) {
  return {Rational(to_integer(int128(p.n[0]))), Rational(to_integer(int128(p.n[1]))),
          Rational(to_integer(int128(p.n[2])))};
}
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

int expected_side(const Plane& p, const Point& u) { return sign_of(rational_value(p, coordinates(u))); }
int expected_turn(const Plane& p, const Plane& q, const Plane& r) {
  return sign_of(dot(normal(p), cross(normal(q), normal(r))));
}
int expected_orientation(const Plane& p, const Point& a, const Point& b, const Point& c) {
  const Vector o = coordinates(a);
  return sign_of(dot(normal(p), cross(minus(coordinates(b), o), minus(coordinates(c), o))));
}

Plane random_plane(std::mt19937_64& random, std::int64_t divisor = 1) {
  for (;;) {
    Plane p{{biased_coefficient(random), biased_coefficient(random), biased_coefficient(random)},
            std::clamp(biased<Offset::bits>(random).low(), -offset_limit, offset_limit) / divisor};
    for (std::int64_t& c : p.n) c /= divisor;
    if (p.n != std::array<std::int64_t, 3>{}) return p;
  }
}

/// A small combination of three planes, its offset moved by `shift`: passes close by their meeting, or through it.
Plane pencil_plane(std::mt19937_64& random, const std::array<Plane, 3>& p, std::int64_t shift) {
  Plane r{{0, 0, 0}, shift};
  for (const Plane& q : p) {
    const std::int64_t f = between(random, -4, 4);
    for (std::size_t k = 0; k < 3; ++k) r.n[k] += f * q.n[k];
    r.d += f * q.d;
  }
  return r.n == std::array<std::int64_t, 3>{} ? p[0] : r;
}

const Plane z0{{0, 0, 1}, 0};
/// The line a x + b y + c = 0 of the plane z = 0.
Plane line(std::int64_t a, std::int64_t b, std::int64_t c) { return {{a, b, 0}, c}; }
Point cut(const Plane& l, const Plane& m) { return meet(l, m, z0).value(); }

void check_side(const Plane& p, const Point& u) {
  const int expected = expected_side(p, u);
  const int filtered = side_filter(approximation(p), u.approximation);
  ASSERT_TRUE(filtered == expected || filtered == 2) << "the filter guessed";
  ASSERT_EQ(side_exact(p, u), expected);
  int answer = 2;
  ASSERT_EQ(rung_of([&] { answer = side(p, u); }), filtered == 2 ? Rung::fixed_width : Rung::filter);
  ASSERT_EQ(answer, expected);
  ASSERT_EQ(side(p.opposite(), u), -expected);  // P1
}

TEST(PredicatesTest, SideAgreesWithRationalsAlsoNearZero) {
  std::mt19937_64 random = generator(400);
  int undecided = 0, decided = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::array<Plane, 3> p{random_plane(random, 16), random_plane(random, 16), random_plane(random, 16)};
    const auto u = meet(p[0], p[1], p[2]);
    if (!u) continue;
    for (const Plane& q : p) {
      ASSERT_EQ(side(q, *u), 0);  // P1
      ASSERT_EQ(side_filter(approximation(q), u->approximation), 2);
    }
    for (const std::int64_t shift : {0, 1, -1, 1000}) check_side(pencil_plane(random, p, shift), *u);
    const Plane far = random_plane(random);
    check_side(far, *u);
    (side_filter(approximation(far), u->approximation) == 2 ? undecided : decided) += 1;
  }
  EXPECT_GT(decided, 10 * undecided);  // a filter that always gives up would fail here
}

TEST(PredicatesTest, SideFilterDecidesAsSoonAsTheBoundAllows) {
  // The value is 1 and its terms are 2^k and 1 - 2^k: 8 u (2^(k+1) - 1) is below 1 up to k = 49.
  for (int k = 0; k <= 61; ++k) {
    const std::int64_t c = std::int64_t{1} << k;
    const Plane p{{c, 0, 0}, -int128(c) + 1};
    const Point one = point({{1, 1, 1}});
    const Rung rung = rung_of([&] { EXPECT_EQ(side(p, one), 1); });
    EXPECT_EQ(rung, k <= 49 ? Rung::filter : Rung::fixed_width) << k;
  }
}

TEST(PredicatesTest, SideOfGridPointsNeedsNoFilter) {
  std::mt19937_64 random = generator(401);
  for (int i = 0; i < 5000; ++i) {
    GridPoint g{};
    for (auto& c : g.c) c = static_cast<std::int32_t>(between(random, -world, world));
    Plane p = random_plane(random);
    if (i % 2 == 0) p.d = -(value({p.n, 0}, g)) + between(random, -1, 1);
    const int expected = expected_side(p, point(g));
    EXPECT_EQ(rung_of([&] { ASSERT_EQ(side(p, g), expected); }), Rung::fixed_width);
    check_side(p, point(g));
  }
}

TEST(PredicatesTest, ComparisonsAgreeWithRationals) {
  std::mt19937_64 random = generator(402);
  for (int i = 0; i < 10000; ++i) {
    const std::array<Plane, 3> p{random_plane(random, 16), random_plane(random, 16), random_plane(random, 16)};
    const auto u = meet(p[0], p[1], p[2]);
    const std::int64_t shift = between(random, -1, 1);
    const auto v = meet(pencil_plane(random, p, 0), pencil_plane(random, p, shift), pencil_plane(random, p, 0));
    if (!u || !v) continue;
    int expected = 0;
    for (int k = 0; k < 3; ++k) {
      const int c = sign_of(Rational(coordinate(*u, k) - coordinate(*v, k)));
      const auto s = static_cast<std::size_t>(k);
      const Rung rung = u->approximation[s] == v->approximation[s] ? Rung::fixed_width : Rung::filter;
      ASSERT_EQ(rung_of([&] { ASSERT_EQ(compare_along(k, *u, *v), c); }), rung);
      ASSERT_EQ(compare_along(k, *v, *u), -c);  // P2
      ASSERT_EQ(compare_along(k, *u, *u), 0);
      if (expected == 0) expected = c;
    }
    ASSERT_EQ(compare_lexicographic(*u, *v), expected);
    ASSERT_EQ(compare_lexicographic(*v, *u), -expected);  // P2
    if (shift == 0) {
      ASSERT_EQ(expected, 0);
    }
  }
}

TEST(PredicatesTest, ComparisonsAreTransitive) {
  std::mt19937_64 random = generator(403);
  std::vector<Point> points;
  while (points.size() < 60) {
    const auto small = [&random] {
      return Plane{{between(random, -2, 2), between(random, -2, 2), between(random, -2, 2)}, between(random, -2, 2)};
    };
    const auto u = meet(small(), small(), small());
    if (u) points.push_back(*u);
  }
  for (const Point& u : points)
    for (const Point& v : points)
      for (const Point& w : points)
        if (compare_lexicographic(u, v) <= 0 && compare_lexicographic(v, w) <= 0) {
          const int c = compare_lexicographic(u, w);
          ASSERT_LE(c, 0);
          if (c == 0) {  // equality is an equivalence relation
            ASSERT_EQ(compare_lexicographic(u, v), 0);
            ASSERT_EQ(compare_lexicographic(v, w), 0);
          }
        }
}

TEST(PredicatesTest, ComparisonSeparatesPointsWithOneApproximation) {
  // x = 1 / L and x = 1 / (L - 1) - so close to 2^-62 that the doubles agree.
  const Point u = cut(line(limit, 0, -1), line(0, 1, 0)), v = cut(line(limit - 1, 0, -1), line(0, 1, 0));
  ASSERT_EQ(u.approximation, v.approximation);
  EXPECT_EQ(rung_of([&] { EXPECT_EQ(compare_along(0, u, v), -1); }), Rung::fixed_width);
  EXPECT_EQ(compare_lexicographic(v, u), 1);
}

void check_turn(const Plane& p, const Plane& q, const Plane& r) {
  const int expected = expected_turn(p, q, r);
  ASSERT_EQ(turn(p, q, r), expected);
  // P3
  ASSERT_EQ(turn(q, p, r), -expected);
  ASSERT_EQ(turn(p, r, q), -expected);
  ASSERT_EQ(turn(q, r, p), expected);
  ASSERT_EQ(turn(p.opposite(), q, r), -expected);
  ASSERT_EQ(turn(p, q.opposite(), r), -expected);
  ASSERT_EQ(turn(p, q, r.opposite()), -expected);
  if (expected == 0) {
    ASSERT_EQ(rung_of([&] { turn(p, q, r); }), Rung::fixed_width);
  }
}

void check_pair_of_planes(const Plane& p, const Plane& q) {
  const Vector c = cross(normal(p), normal(q));
  bool zero = true;
  for (int k = 0; k < 3; ++k) {
    const int expected = sign_of(c[static_cast<std::size_t>(k)]);
    zero = zero && expected == 0;
    ASSERT_EQ(cross_sign(p, q, k), expected);
    ASSERT_EQ(cross_sign(q, p, k), -expected);  // P4
    ASSERT_EQ(cross_sign(p.opposite(), q, k), -expected);
  }
  ASSERT_EQ(parallel(p, q), zero);
  const int d = sign_of(dot(normal(p), normal(q)));
  ASSERT_EQ(dot_sign(p, q), d);
  ASSERT_EQ(dot_sign(q, p), d);
  ASSERT_EQ(dot_sign(p.opposite(), q), -d);
}

TEST(PredicatesTest, NormalsAgreeWithRationals) {
  std::mt19937_64 random = generator(404);
  for (int i = 0; i < 10000; ++i) {
    const std::array<Plane, 3> p{random_plane(random, 16), random_plane(random, 16), random_plane(random, 16)};
    check_turn(p[0], p[1], p[2]);
    Plane q = pencil_plane(random, {p[0], p[1], p[0]}, 0);  // dependent
    check_turn(p[0], p[1], q);
    q.n[below(random, 3)] += between(random, -1, 1);  // nearly
    if (q.n != std::array<std::int64_t, 3>{}) check_turn(p[0], q, p[1]);
    check_pair_of_planes(p[0], p[1]);
    check_pair_of_planes(p[0], pencil_plane(random, {p[0], p[0], p[0]}, 0));
    check_pair_of_planes(random_plane(random), random_plane(random));
  }
}

TEST(PredicatesTest, NormalsAtTheExtremes) {
  std::vector<Plane> corners;
  for (int i = 0; i < 27; ++i)
    if (i != 13) corners.push_back({{(i % 3 - 1) * limit, (i / 3 % 3 - 1) * limit, (i / 9 - 1) * limit}, 0});
  for (const Plane& p : corners)
    for (const Plane& q : corners) {
      check_pair_of_planes(p, q);
      for (const Plane& r : corners) check_turn(p, q, r);
    }
}

TEST(PredicatesTest, TurnTellsItsRung) {
  const Plane x{{1, 0, 0}, 0}, y{{0, 1, 0}, 5}, z{{0, 0, 1}, -7};
  EXPECT_EQ(rung_of([&] { EXPECT_EQ(turn(x, y, z), 1); }), Rung::filter);
  EXPECT_EQ(rung_of([&] { EXPECT_EQ(turn(x, z, y), -1); }), Rung::filter);
  EXPECT_EQ(rung_of([&] { EXPECT_EQ(turn(x, y, x), 0); }), Rung::fixed_width);
  // A unit determinant among products of 2^124.
  const Plane p{{limit, limit - 1, 0}, 0}, q{{limit - 1, limit - 2, 0}, 0};
  EXPECT_EQ(rung_of([&] { EXPECT_EQ(turn(p, q, z), -1); }), Rung::fixed_width);
  // On the plane z = 0 seen from above: n_p x n_q points to +y, n_p x n_r to the left of it.
  EXPECT_EQ(turn(z, x, y), 1);
}

struct SmallPlane {
  int a, b, c, d;
  Plane plane() const { return {{a, b, c}, d}; }
};

int small_determinant(const SmallPlane& p, const SmallPlane& q, const SmallPlane& r) {
  return p.a * (q.b * r.c - q.c * r.b) - p.b * (q.a * r.c - q.c * r.a) + p.c * (q.a * r.b - q.b * r.a);
}

int small_sign(int v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

std::vector<SmallPlane> small_normals() {
  std::vector<SmallPlane> r;
  for (int i = 0; i < 125; ++i)
    if (i != 62) r.push_back({i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2, 0});
  return r;
}

TEST(PredicatesTest, AllSmallNormals) {
  const auto all = small_normals();
  for (const auto& p : all)
    for (const auto& q : all) {
      const Plane pp = p.plane(), qq = q.plane();
      ASSERT_EQ(cross_sign(pp, qq, 0), small_sign(p.b * q.c - p.c * q.b));
      ASSERT_EQ(cross_sign(pp, qq, 1), small_sign(p.c * q.a - p.a * q.c));
      ASSERT_EQ(cross_sign(pp, qq, 2), small_sign(p.a * q.b - p.b * q.a));
      ASSERT_EQ(dot_sign(pp, qq), small_sign(p.a * q.a + p.b * q.b + p.c * q.c));
      for (const auto& r : all) {
        const Plane rr = r.plane();
        const int expected = small_sign(small_determinant(p, q, r));
        int answer = 2;
        // So few bits leave no doubt to the filter, but for zero.
        ASSERT_EQ(rung_of([&] { answer = turn(pp, qq, rr); }), expected == 0 ? Rung::fixed_width : Rung::filter);
        ASSERT_EQ(answer, expected);
      }
    }
}

TEST(PredicatesTest, AllSmallTriplesAgainstAllSmallPlanes) {
  std::vector<SmallPlane> planes;  // the primitive canonical normals
  for (const auto& p : small_normals())
    if (reduced_plane({p.a, p.b, p.c}, 0) == p.plane() && is_canonical(p.plane())) planes.push_back(p);
  ASSERT_EQ(planes.size(), 49U);
  for (std::size_t i = 0; i < planes.size(); ++i) planes[i].d = static_cast<int>(i * 5 % 3) - 1;
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = i + 1; j < planes.size(); ++j)
      for (std::size_t k = j + 1; k < planes.size(); ++k) {
        const SmallPlane &p = planes[i], &q = planes[j], &r = planes[k];
        const int w = small_determinant(p, q, r);
        const auto u = meet(p.plane(), q.plane(), r.plane());
        ASSERT_EQ(u.has_value(), w != 0);
        if (!u) continue;
        const auto with_d = [](SmallPlane s, int column) {
          (column == 0 ? s.a : column == 1 ? s.b : s.c) = -s.d;
          return s;
        };
        std::array<int, 3> x{};
        for (int c = 0; c < 3; ++c)
          x[static_cast<std::size_t>(c)] = small_sign(w) * small_determinant(with_d(p, c), with_d(q, c), with_d(r, c));
        for (const SmallPlane& s : planes)
          for (int d = -1; d <= 1; ++d) {
            const int expected = small_sign(s.a * x[0] + s.b * x[1] + s.c * x[2] + d * std::abs(w));
            const Plane plane{{s.a, s.b, s.c}, d};
            int answer = 2;
            ASSERT_EQ(rung_of([&] { answer = side(plane, *u); }), expected == 0 ? Rung::fixed_width : Rung::filter);
            ASSERT_EQ(answer, expected);
          }
      }
}

void check_orientation(const Plane& p, const Point& a, const Point& b, const Point& c, int expected) {
  const auto ask = [](const Plane& plane, const Point& x, const Point& y, const Point& z) {
    int answer = 2;
    const Rung rung = rung_of([&] { answer = orientation_in_plane(plane, x, y, z); });
    EXPECT_TRUE(rung == Rung::fixed_width || (rung == Rung::filter && answer != 0));
    return answer;
  };
  ASSERT_EQ(ask(p, a, b, c), expected);
  ASSERT_EQ(orientation_in_plane_exact(p, a, b, c), expected);
  // P5
  ASSERT_EQ(ask(p, b, c, a), expected);
  ASSERT_EQ(ask(p, c, a, b), expected);
  ASSERT_EQ(ask(p, b, a, c), -expected);
  ASSERT_EQ(ask(p, a, c, b), -expected);
  ASSERT_EQ(ask(p.opposite(), a, b, c), -expected);
  ASSERT_EQ(ask(p, a, b, b), 0);
  ASSERT_EQ(ask(p, a, b, a), 0);
}

TEST(PredicatesTest, OrientationInPlaneAgreesWithRationals) {
  std::mt19937_64 random = generator(405);
  int filtered = 0, general = 0, flat = 0, nearly_flat = 0;
  for (int i = 0; i < 5000; ++i) {
    const Plane p = random_plane(random, 16), q = random_plane(random, 16);
    const auto a = meet(p, q, random_plane(random)), b = meet(p, q, random_plane(random));
    const auto c = meet(p, random_plane(random), random_plane(random));
    if (!a || !b || !c) continue;
    const int expected = expected_orientation(p, *a, *b, *c);
    check_orientation(p, *a, *b, *c, expected);
    ++general;
    filtered += rung_of([&] { orientation_in_plane(p, *a, *b, *c); }) == Rung::filter;
    // On the common line of p and q, and one unit of the offset beside it.
    const auto on = meet(p, pencil_plane(random, {p, q, q}, 0), random_plane(random));
    if (on && expected_orientation(p, *a, *b, *on) == 0) {
      check_orientation(p, *a, *b, *on, 0);
      ++flat;
    }
    Plane beside = q;
    beside.d += between(random, 0, 1) * 2 - 1;
    const auto near = meet(p, beside, random_plane(random));
    if (near && compare_lexicographic(*a, *b) != 0) {
      const int side_of_near = expected_orientation(p, *a, *b, *near);
      ASSERT_NE(side_of_near, 0);
      check_orientation(p, *a, *b, *near, side_of_near);
      ++nearly_flat;
    }
  }
  EXPECT_GT(general, 2000);
  EXPECT_GT(flat, 1000);
  EXPECT_GT(nearly_flat, 1000);
  EXPECT_GT(2 * filtered, general);
}

TEST(PredicatesTest, OrientationInPlaneOfSmallPlanes) {
  std::mt19937_64 random = generator(406);
  const auto normals = small_normals();
  for (const SmallPlane& s : normals) {
    const Plane p{{s.a, s.b, s.c}, between(random, -2, 2)};
    std::vector<Point> points;
    while (points.size() < 8) {
      const auto cutter = [&] {
        const SmallPlane& n = normals[below(random, normals.size())];
        return Plane{{n.a, n.b, n.c}, between(random, -2, 2)};
      };
      const auto u = meet(p, cutter(), cutter());
      if (u) points.push_back(*u);
    }
    for (const Point& a : points)
      for (const Point& b : points)
        for (const Point& c : points) ASSERT_EQ(orientation_in_plane(p, a, b, c), expected_orientation(p, a, b, c));
  }
}

TEST(PredicatesTest, OrientationInPlaneSeenFromThePositiveSide) {
  const Point o = point({{0, 0, 0}}), x = point({{5, 0, 0}}), y = point({{0, 5, 0}}), z = point({{0, 0, 5}});
  EXPECT_EQ(orientation_in_plane(z0, o, x, y), 1);
  EXPECT_EQ(orientation_in_plane(z0.opposite(), o, x, y), -1);
  EXPECT_EQ(orientation_in_plane({{1, 0, 0}, 0}, o, y, z), 1);
  EXPECT_EQ(orientation_in_plane({{0, 1, 0}, 0}, o, z, x), 1);
  EXPECT_EQ(orientation_in_plane({{1, 1, 1}, -5}, x, y, z), 1);
  // Mesh corners: the filter alone, also far from the origin and for thin triangles.
  const auto at = [](std::int32_t a, std::int32_t b) { return point({{world - a, world - b, 0}}); };
  const Point far = at(0, 0), beside = at(1, 0), above = at(0, 1), thin = at(100, 1);
  EXPECT_EQ(rung_of([&] { EXPECT_EQ(orientation_in_plane(z0, far, beside, above), 1); }), Rung::filter);
  EXPECT_EQ(rung_of([&] { EXPECT_EQ(orientation_in_plane(z0, far, beside, thin), 1); }), Rung::filter);
  EXPECT_EQ(rung_of([&] { EXPECT_EQ(orientation_in_plane(z0, far, beside, at(7, 0)), 0); }), Rung::fixed_width);
}

// Rows (4 L^4, 4 L^4, 4 L^3) with the signs of a 3x3 matrix of determinant 4: 256 L^11, the top of the ladder.
TEST(PredicatesTest, ProjectedDeterminantAtItsBound) {
  const Integer l = limit, top = 4 * l * l * l * l;
  const auto at = [&](int sx, int sy) {
    Point u{};
    u.x = {*to_int<Numerator::bits>(sx * top), *to_int<Numerator::bits>(sy * top), Numerator(0)};
    u.w = *to_int<Denominator::bits>(Integer(4 * l * l * l));
    return u;
  };
  const Integer bound = 256 * pow(l, 11);
  for (int swapped = 0; swapped < 2; ++swapped) {
    const Point a = at(1, 1), b = at(swapped ? 1 : -1, swapped ? -1 : 1), c = at(-1, -1),
                d = at(swapped ? -1 : 1, swapped ? 1 : -1);
    EXPECT_EQ(to_integer(projected_determinant(2, a, b, c)), swapped ? Integer(-bound) : bound);
    EXPECT_EQ(to_integer(projected_determinant(2, a, b, d)), to_integer(projected_determinant(2, b, d, a)));
    EXPECT_EQ(abs(to_integer(projected_determinant(2, d, c, b))), bound);
  }
}

// E01: floating point calls u and v distinct by one pair of lines and equal by the other; all exact answers agree.
TEST(PredicatesTest, E01IncidenceIsSymmetric) {
  const Plane l1 = line(-1, 1, 0), l2 = line(-((1 << 23) + 1), (1 << 23) - 1, 2);
  const Plane l3 = line(1 << 15, 0, -((1 << 15) + 1)), l4 = line(0, 1 << 15, -((1 << 15) + 1));
  const Point u = cut(l1, l2), v = cut(l3, l4);
  EXPECT_EQ(coordinates(u), (Vector{1, 1, 0}));
  EXPECT_EQ(coordinates(v), (Vector{Rational(32769, 32768), Rational(32769, 32768), 0}));
  EXPECT_EQ(side(l3, u), -1);
  EXPECT_EQ(side(l4, u), -1);
  EXPECT_EQ(side(l1, v), 0);
  EXPECT_EQ(side(l2, v), -1);
  EXPECT_EQ(compare_lexicographic(u, v), -1);
  EXPECT_EQ(compare_lexicographic(v, u), 1);
}

// E02: points 8/10^11 apart are distinct, each from each.
TEST(PredicatesTest, E02EqualityIsTransitive) {
  const std::int64_t e11 = 100000000000;
  const Plane axis = line(1, 0, 0);
  const std::array<Point, 3> p{cut(axis, line(0, 1, 0)), cut(axis, line(0, e11, -8)), cut(axis, line(0, e11, -16))};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(compare_lexicographic(p[i], p[j]), i < j ? -1 : i > j ? 1 : 0);
  // The middle one lies on the edge between the others, and on neither end.
  EXPECT_EQ(orientation_in_plane(z0, p[0], p[1], p[2]), 0);
}

TEST(PredicatesTest, E21WorkedExample) {
  const std::array<Plane, 3> p{Plane{{1, 0, 0}, -1}, Plane{{0, 1, 0}, -1}, Plane{{0, 0, -1}, 1}};
  const Plane q{{1, 1, -1}, 0};
  std::array<std::size_t, 3> order{0, 1, 2};
  do {
    const Point u = meet(p[order[0]], p[order[1]], p[order[2]]).value();
    EXPECT_EQ(coordinates(u), (Vector{1, 1, 1}));
    EXPECT_EQ(side(q, u), 1);
    EXPECT_EQ(side(q.opposite(), u), -1);
    EXPECT_EQ(side({{1, 1, -2}, 0}, u), 0);
    EXPECT_TRUE(scaled_value(q, u) == SideValue(1));
  } while (std::next_permutation(order.begin(), order.end()));
}

struct Pappus {
  std::map<int, Plane> lines;
  std::map<int, Point> points;
};

/// Points 1 to 5 fixed, the sixth at (p / q, 1); everything else is constructed from lines.
Pappus pappus(std::int64_t p, std::int64_t q) {
  Pappus r;
  r.lines = {{1, line(0, 1, 0)},
             {2, line(0, 1, -1)},
             {3, line(1, -1, 0)},
             {4, line(1, 0, -1)},
             {5, line(1, -2, -1)},
             {6, line(1, 1, -4)},              // 4, 5
             {7, line(q, 4 * q - p, -4 * q)},  // 5, 6
             {8, line(q, -p, 0)}};             // 1, 6
  const auto at = [&r](int l, int m) { return cut(r.lines.at(l), r.lines.at(m)); };
  r.points = {{1, at(1, 3)}, {2, at(2, 3)}, {3, at(1, 4)}, {4, at(2, 5)}, {5, at(1, 6)},
              {6, at(2, 7)}, {7, at(3, 6)}, {8, at(5, 8)}, {9, at(4, 7)}};
  return r;
}

const std::map<int, std::string> incidences{{1, "135"}, {2, "246"}, {3, "127"}, {4, "239"}, {5, "348"},
                                            {6, "457"}, {7, "569"}, {8, "168"}, {9, "789"}};

TEST(PredicatesTest, E10PappusConfiguration) {
  Pappus c = pappus(0, 1);
  c.lines.emplace(9, line(5, -4, -2));
  const Rational half(1, 2);
  const std::map<int, Vector> expected{{1, {0, 0, 0}}, {2, {1, 1, 0}},     {3, {1, 0, 0}},
                                       {4, {3, 1, 0}}, {5, {4, 0, 0}},     {6, {0, 1, 0}},
                                       {7, {2, 2, 0}}, {8, {0, -half, 0}}, {9, {1, Rational(3, 4), 0}}};
  for (const auto& [i, u] : c.points) EXPECT_EQ(coordinates(u), expected.at(i)) << i;
  int on = 0;
  for (const auto& [l, plane] : c.lines)
    for (const auto& [i, u] : c.points) {
      const bool incident = incidences.at(l).find(static_cast<char>('0' + i)) != std::string::npos;
      EXPECT_EQ(side(plane, u) == 0, incident) << "line " << l << ", point " << i;
      on += incident;
    }
  EXPECT_EQ(on, 27);
}

// The theorem: line 9 is never imposed, and its three points are collinear wherever the sixth point is.
TEST(PredicatesTest, E10PappusTheorem) {
  std::mt19937_64 random = generator(407);
  for (int i = 0; i < 200; ++i) {
    const std::int64_t q = i == 0 ? 10 : between(random, 1, 1 << 20),
                       p = i == 0 ? 1 : between(random, -(1 << 20), 1 << 20);
    if (p == q || p == 3 * q || 4 * q == p) continue;
    const Pappus c = pappus(p, q);
    EXPECT_EQ(coordinate(c.points.at(6), 0), Rational(p, q));
    for (int l = 1; l <= 8; ++l)
      for (const char digit : incidences.at(l)) EXPECT_EQ(side(c.lines.at(l), c.points.at(digit - '0')), 0);
    EXPECT_EQ(orientation_in_plane(z0, c.points.at(7), c.points.at(8), c.points.at(9)), 0);
  }
  // The ninth point moved by 2^-60 is off the line, which only the exact rung sees.
  const Pappus c = pappus(0, 1);
  const std::int64_t e60 = std::int64_t{1} << 60;
  const Point moved = cut(line(e60, 0, -e60 - 1), line(0, 4, -3));
  EXPECT_EQ(rung_of([&] { EXPECT_EQ(side(line(5, -4, -2), moved), 1); }), Rung::fixed_width);
  const Rung rung = rung_of([&] { EXPECT_EQ(orientation_in_plane(z0, c.points.at(8), c.points.at(7), moved), -1); });
  EXPECT_EQ(rung, Rung::fixed_width);
}

// E10b: the configuration needs a root of b^2 + b - 1; every rational b misses by exactly -(b^4 - 2 b^2 + b).
TEST(PredicatesTest, E10bIrrationalConfigurationIsNeverMet) {
  const std::int64_t fibonacci[][2] = {{5, 8}, {8, 13}, {55, 89}, {610, 987}};
  const Rational residuals[] = {Rational(-15, 4096), Rational(40, 28561), Rational(1870, 62742241),
                                Rational(Integer(-229970), Integer("949005240561"))};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::int64_t p = fibonacci[i][0], q = fibonacci[i][1], w = q * q + p * q - p * p;
    const Rational b(p, q), a = b * b, residual = b * b * b * b - 2 * b * b + b;
    EXPECT_EQ(residual, residuals[i]);
    const Plane l2_6 = line(-p * p, -q * q, p * p);  // through (1, 0) and (a, a) / (1 + a)
    const Point p2 = point({{1, 0, 0}}), p6 = cut(line(q * q + p * p, 0, -p * p), line(0, q * q + p * p, -p * p));
    const Point p9 = cut(line(w, 0, -p * q), line(0, w, -(p * q - p * p)));
    EXPECT_EQ(side(l2_6, p2), 0);
    EXPECT_EQ(side(l2_6, p6), 0);
    EXPECT_EQ(coordinate(p9, 0), b / (1 + b - a));
    EXPECT_EQ(rational_value(l2_6, coordinates(p9)) / (q * q), -residual / (1 + b - a));
    EXPECT_EQ(side(l2_6, p9), sign_of(Rational(-residual)));
    EXPECT_NE(side(l2_6, p9), 0);
    EXPECT_NE(orientation_in_plane(z0, p2, p6, p9), 0);
  }
}

// E35: whether two crossings of one edge with planes coincide, and in which order they follow, is the same answer
// through either face, through the edge and through the points.
TEST(PredicatesTest, E35IncidencesAgree) {
  std::mt19937_64 random = generator(408);
  int coincident = 0, ordered = 0;
  for (int i = 0; i < 60000; ++i) {
    const auto small = [&random] {
      for (;;) {
        const Plane p{{between(random, -3, 3), between(random, -3, 3), between(random, -3, 3)}, between(random, -9, 9)};
        if (p.n != std::array<std::int64_t, 3>{}) return p;
      }
    };
    const Plane f1 = small(), f2 = small(), g = small(), h = small();
    const auto u = meet(f1, f2, g), v = meet(f2, h, f1);
    ASSERT_EQ(u.has_value(), turn(f1, f2, g) != 0);
    ASSERT_EQ(v.has_value(), turn(f1, f2, h) != 0);
    if (!u || !v) continue;
    for (const Plane& p : {f1, f2, g}) ASSERT_EQ(side(p, *u), 0);
    for (const Plane& p : {f1, f2, h}) ASSERT_EQ(side(p, *v), 0);
    const bool equal = compare_lexicographic(*u, *v) == 0;
    ASSERT_EQ(side(h, *u) == 0, equal);
    ASSERT_EQ(side(g, *v) == 0, equal);
    (equal ? coincident : ordered) += 1;
    // Along t = n_f1 x n_f2, by coordinates and by sides: before h's crossing lies where h is opposite to its turn.
    int along = 0;
    for (int k = 0; k < 3 && along == 0; ++k) along = compare_along(k, *u, *v) * cross_sign(f1, f2, k);
    ASSERT_EQ(along, side(h, *u) * turn(f1, f2, h));
    ASSERT_EQ(-along, side(g, *v) * turn(f1, f2, g));
    // Within each face: the points and a third one off the edge.
    const auto off = meet(f1, g, h);
    if (off && side(f2, *off) != 0) {
      const int seen = orientation_in_plane(f1, *u, *v, *off);
      ASSERT_EQ(seen == 0, equal);
      // Left of t on f1, seen from outside, is where f2 falls: (n_f1 x t) . n_f2 = -|t|^2.
      if (!equal) {
        ASSERT_EQ(seen, along * side(f2, *off));
      }
    }
  }
  EXPECT_GT(coincident, 100);
  EXPECT_GT(ordered, 10000);
}

// Against rationals, at the ends of the world and beside the plane of three points.
TEST(PredicatesTest, OrientationOfGridPoints) {
  std::mt19937_64 random = generator(430);
  std::map<int, int> seen;
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t size = i % 2 == 0 ? world : 4;
    std::array<GridPoint, 4> p;
    for (GridPoint& q : p)
      for (std::int32_t& x : q.c) x = static_cast<std::int32_t>(between(random, -size, size));
    if (i % 3 == 0)  // on the plane, or a step beside it
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t x = std::int64_t{p[1].c[k]} + p[2].c[k] - p[0].c[k] + (k == 0 ? between(random, -1, 1) : 0);
        p[3].c[k] = static_cast<std::int32_t>(std::clamp(x, -std::int64_t{world}, std::int64_t{world}));
      }
    std::array<Vector, 4> v;
    for (std::size_t j = 0; j < 4; ++j) v[j] = {Rational(p[j].c[0]), Rational(p[j].c[1]), Rational(p[j].c[2])};
    const int expected = sign_of(dot(cross(minus(v[1], v[0]), minus(v[2], v[0])), minus(v[3], v[0])));
    ASSERT_EQ(orientation(p[0], p[1], p[2], p[3]), expected);
    ++seen[expected];
  }
  for (const int s : {-1, 0, 1}) EXPECT_GT(seen[s], 500);
}

}  // namespace
}  // namespace quoin::exact::testing
