#include "exact/geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <vector>

#include "tests/exact/support.h"

namespace quoin::exact::testing {
namespace {

constexpr std::int64_t limit = coefficient_limit;

Rational rational(int128 v) { return Rational(to_integer(v)); }

Rational determinant(const std::array<std::array<Rational, 3>, 3>& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// Cramer's rule in rationals: column k replaced by -d.
std::optional<std::array<Rational, 3>> rational_meet(const std::array<Plane, 3>& planes) {
  std::array<std::array<Rational, 3>, 3> m;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) m[i][k] = rational(planes[i].n[k]);
  const Rational w = determinant(m);
  if (w == 0) return std::nullopt;
  std::array<Rational, 3> r;
  for (std::size_t k = 0; k < 3; ++k) {
    auto replaced = m;
    for (std::size_t i = 0; i < 3; ++i) replaced[i][k] = -rational(planes[i].d);
    r[k] = determinant(replaced) / w;
  }
  return r;
}

/// Whether r is the double nearest to v, the even one of two equally near, and +0 for 0. By comparison with both
/// neighbours, without any rounding code.
bool is_nearest(const Rational& v, double r) {
  if (v == 0) return r == 0 && !std::signbit(r);
  const double infinity = std::numeric_limits<double>::infinity();
  const Rational error = abs(v - to_rational(r));
  for (const double neighbour : {std::nextafter(r, infinity), std::nextafter(r, -infinity)}) {
    const Rational other = abs(v - to_rational(neighbour));
    if (other < error) return false;
    int e = 0;
    if (other == error && std::fmod(std::ldexp(std::frexp(r, &e), 53), 2) != 0) return false;
  }
  return true;
}

Plane random_plane(std::mt19937_64& random) {
  for (;;) {
    const std::array<std::int64_t, 3> n{biased_coefficient(random), biased_coefficient(random),
                                        biased_coefficient(random)};
    if (n[0] == 0 && n[1] == 0 && n[2] == 0) continue;
    int128 d = biased<Offset::bits>(random).low();
    d = std::clamp(d, -offset_limit, offset_limit);
    return reduced_plane(n, d);
  }
}

GridPoint random_grid_point(std::mt19937_64& random, std::int32_t size) {
  GridPoint p{};
  for (auto& c : p.c) {
    c = static_cast<std::int32_t>(between(random, -size, size));
    if (below(random, 4) == 0) c = c < 0 ? -size : size;
  }
  return p;
}

TEST(GeometryTest, ReducedPlaneDividesByThePositiveGcd) {
  EXPECT_EQ(reduced_plane({2, 4, -6}, 8), (Plane{{1, 2, -3}, 4}));
  EXPECT_EQ(reduced_plane({-2, -4, 6}, -8), (Plane{{-1, -2, 3}, -4}));  // the orientation stays
  EXPECT_EQ(reduced_plane({2, 4, -6}, 7), (Plane{{2, 4, -6}, 7}));      // d takes part
  EXPECT_EQ(reduced_plane({0, 0, -5}, 0), (Plane{{0, 0, -1}, 0}));
  EXPECT_EQ(reduced_plane({limit, 0, 0}, offset_limit), (Plane{{1, 0, 0}, limit}));
  EXPECT_EQ(reduced_plane({limit, limit, -limit}, -offset_limit), (Plane{{1, 1, -1}, -limit}));
  EXPECT_EQ(reduced_plane({limit, limit - 1, 0}, offset_limit), (Plane{{limit, limit - 1, 0}, offset_limit}));
}

TEST(GeometryTest, ReducedPlaneIsAFunctionOfTheOrientedPlane) {
  std::mt19937_64 random = generator(300);
  for (int i = 0; i < 20000; ++i) {
    const std::array<std::int64_t, 3> n{between(random, -40, 40), between(random, -40, 40), between(random, -40, 40)};
    if (n == std::array<std::int64_t, 3>{}) continue;
    const int128 d = static_cast<int128>(between(random, -limit, limit)) * between(random, 1, 1 << 20);
    const Plane p = reduced_plane(n, d);
    const std::int64_t f = between(random, 1, std::int64_t{1} << 40);
    ASSERT_EQ(reduced_plane({n[0] * f, n[1] * f, n[2] * f}, d * f), p);
    ASSERT_EQ(reduced_plane({-n[0], -n[1], -n[2]}, -d), p.opposite());
    ASSERT_EQ(hash(reduced_plane({n[0] * f, n[1] * f, n[2] * f}, d * f)), hash(p));
    ASSERT_NE(is_canonical(p), is_canonical(p.opposite()));
    ASSERT_EQ(compare(p, p), 0);
    const Plane q = random_plane(random);
    ASSERT_EQ(compare(p, q), -compare(q, p));
    ASSERT_EQ(compare(p, q) == 0, p == q);
    const Integer g = gcd(gcd(to_integer(p.n[0]), to_integer(p.n[1])), gcd(to_integer(p.n[2]), to_integer(p.d)));
    ASSERT_EQ(g, 1);
  }
}

TEST(GeometryTest, CompareIsLexicographic) {
  const std::vector<Plane> sorted{{{-2, 5, 0}, 0},           {{-1, -3, 9}, 4},       {{-1, 0, 0}, -offset_limit},
                                  {{-1, 0, 0}, 1},           {{-1, 0, 1}, -1},       {{0, 0, 1}, 0},
                                  {{0, 1, 0}, offset_limit}, {{limit, -limit, 0}, 0}};
  for (std::size_t i = 0; i < sorted.size(); ++i)
    for (std::size_t j = 0; j < sorted.size(); ++j)
      ASSERT_EQ(compare(sorted[i], sorted[j]), i < j ? -1 : i > j ? 1 : 0);
}

void check_plane_through(const GridPoint& p, const GridPoint& q, const GridPoint& r) {
  std::array<Rational, 3> e, f;
  for (int k = 0; k < 3; ++k) {
    e[static_cast<std::size_t>(k)] = rational(q[k]) - p[k];
    f[static_cast<std::size_t>(k)] = rational(r[k]) - p[k];
  }
  const std::array<Rational, 3> n{e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
  const auto plane = plane_through(p, q, r);
  ASSERT_EQ(plane.has_value(), n[0] != 0 || n[1] != 0 || n[2] != 0);
  if (!plane) return;
  for (const GridPoint& u : {p, q, r}) {
    ASSERT_TRUE(value(*plane, u) == 0);
    ASSERT_EQ(rational_value(*plane, {rational(u[0]), rational(u[1]), rational(u[2])}), 0);
  }
  // The same direction, not only the same line: a positive multiple.
  Rational dot = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    ASSERT_EQ(rational(plane->n[k]) * n[(k + 1) % 3], rational(plane->n[(k + 1) % 3]) * n[k]);
    ASSERT_LE(std::abs(plane->n[k]), std::int64_t{1} << 61);
    dot += rational(plane->n[k]) * n[k];
  }
  ASSERT_GT(dot, 0);
  ASSERT_TRUE(plane->d < int128(1) << 92 && plane->d > -(int128(1) << 92));
  ASSERT_EQ(*plane_through(q, r, p), *plane);
  ASSERT_EQ(*plane_through(q, p, r), plane->opposite());
}

TEST(GeometryTest, PlaneThroughTheCornersOfTheWorld) {
  std::vector<GridPoint> points;
  for (int i = 0; i < 27; ++i) points.push_back({{(i % 3 - 1) * world, (i / 3 % 3 - 1) * world, (i / 9 - 1) * world}});
  for (const auto& p : points)
    for (const auto& q : points)
      for (const auto& r : points) check_plane_through(p, q, r);
  // A component as long as the world allows, 2^60 (a triangle covers at most half of a square of side 2^30), less 1.
  EXPECT_EQ(*plane_through({{-world, -world, 0}}, {{world, -world + 1, 0}}, {{-world + 1, world, 1}}),
            (Plane{{1, -(1 << 30), (std::int64_t{1} << 60) - 1}, int128(world) * (1 - (1 << 30))}));
  EXPECT_EQ(plane_through({{1, 1, 1}}, {{1, 1, 1}}, {{5, 2, 3}}), std::nullopt);
  EXPECT_EQ(*plane_through({{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}), (Plane{{0, 0, 1}, 0}));  // counter-clockwise from +z
}

TEST(GeometryTest, PlaneThroughRandomPoints) {
  std::mt19937_64 random = generator(301);
  for (int i = 0; i < 5000; ++i) {
    const std::int32_t size = i % 3 == 0 ? world : i % 3 == 1 ? 2 : 1000;
    check_plane_through(random_grid_point(random, size), random_grid_point(random, size),
                        random_grid_point(random, size));
  }
}

TEST(GeometryTest, MeetAgreesWithCramersRuleInRationals) {
  std::mt19937_64 random = generator(302);
  int met = 0;
  for (int i = 0; i < 20000; ++i) {
    std::array<Plane, 3> planes{random_plane(random), random_plane(random), random_plane(random)};
    if (i % 4 == 0) {  // dependent or nearly dependent normals
      for (std::size_t k = 0; k < 3; ++k) {
        planes[0].n[k] /= 2;
        planes[1].n[k] /= 2;
        planes[2].n[k] = planes[0].n[k] + planes[1].n[k];
      }
      planes[2].n[below(random, 3)] += between(random, -1, 1);
    }
    const auto expected = rational_meet(planes);
    const auto u = meet(planes[0], planes[1], planes[2]);
    ASSERT_EQ(u.has_value(), expected.has_value());
    if (!u) continue;
    ++met;
    ASSERT_EQ(u->w.sign(), 1);
    for (int k = 0; k < 3; ++k) {
      const auto s = static_cast<std::size_t>(k);
      ASSERT_EQ(coordinate(*u, k), (*expected)[s]);
      ASSERT_TRUE(is_nearest((*expected)[s], u->approximation[s])) << (*expected)[s];
      ASSERT_EQ(u->approximation[s], to_double((*expected)[s]));
    }
    for (const Plane& p : planes) ASSERT_EQ(scaled_value(p, *u).sign(), 0);
    const Plane p = random_plane(random);
    ASSERT_EQ(Rational(to_integer(scaled_value(p, *u)), to_integer(u->w)), rational_value(p, *expected));
    // Any order and orientation of the planes gives the same numbers.
    const auto v = meet(planes[2].opposite(), planes[0], planes[1].opposite());
    ASSERT_TRUE(v.has_value() && v->x == u->x && v->w == u->w && v->approximation == u->approximation);
  }
  EXPECT_GT(met, 5000);
}

// E06: a 3x3 determinant reaches 4 L^3, its numerators 4 L^4, the 4x4 one 16 L^5.
TEST(GeometryTest, BoundsOfTheLadderAreAttained) {
  const std::array<Plane, 4> p{Plane{{limit, limit, limit}, offset_limit}, Plane{{limit, -limit, limit}, -offset_limit},
                               Plane{{limit, limit, -limit}, -offset_limit},
                               Plane{{limit, -limit, -limit}, offset_limit}};
  const Integer l = limit;
  for (std::size_t skip = 0; skip < 4; ++skip) {
    const Plane &a = p[(skip + 1) % 4], &b = p[(skip + 2) % 4], &c = p[(skip + 3) % 4];
    for (int signs = 0; signs < 8; ++signs) {
      const auto oriented = [signs](const Plane& q, int bit) { return (signs >> bit) & 1 ? q.opposite() : q; };
      const auto u = meet(oriented(a, 0), oriented(b, 1), oriented(c, 2));
      ASSERT_TRUE(u.has_value());
      EXPECT_EQ(to_integer(u->w), 4 * l * l * l);
      for (const Numerator& x : u->x) EXPECT_EQ(abs(to_integer(x)), 4 * l * l * l * l);
      EXPECT_EQ(abs(to_integer(scaled_value(p[skip], *u))), 16 * l * l * l * l * l);
      EXPECT_TRUE(scaled_value(p[skip].opposite(), *u) == -scaled_value(p[skip], *u));
    }
  }
}

void check_quotient(const Integer& numerator, const Integer& denominator) {
  const auto n = to_int<Numerator::bits>(numerator);
  const auto d = to_int<Denominator::bits>(denominator);
  ASSERT_TRUE(n && d && d->sign() > 0);
  const Rational v(numerator, denominator);
  const double r = rounded_quotient(*n, *d), negative = rounded_quotient(-*n, *d);
  ASSERT_TRUE(is_nearest(v, r)) << v << " -> " << r;
  ASSERT_EQ(r, to_double(v));
  ASSERT_EQ(negative, v == 0 ? 0 : -r);
  ASSERT_FALSE(v == 0 && std::signbit(negative));
}

TEST(GeometryTest, RoundedQuotientOfExtremes) {
  const Integer one = 1, l = limit, most_n = 4 * l * l * l * l, most_d = 4 * l * l * l;
  for (const Integer& n :
       {Integer(0), one, Integer(2), Integer(3), most_n, Integer(most_n - 1), Integer((one << 250) - 1),
        Integer(one << 249), Integer((one << 64) - 1), Integer(one << 64), Integer((one << 64) + 1)})
    for (const Integer& d :
         {one, Integer(2), Integer(3), most_d, Integer(most_d - 1), Integer((one << 188) - 1), Integer(one << 187),
          Integer((one << 63) - 1), Integer(one << 63), Integer((one << 64) + 1)})
      check_quotient(n, d);
}

TEST(GeometryTest, RoundedQuotientOfRandomNumbers) {
  std::mt19937_64 random = generator(303);
  for (int i = 0; i < 30000; ++i)
    check_quotient(abs(biased_integer(random, 250)), 1 + abs(biased_integer(random, 188)) % ((Integer(1) << 188) - 1));
}

// Exact integers and dyadic ties keep their rounding when both sides are multiplied by a common factor.
TEST(GeometryTest, RoundedQuotientOfExactAndTiedNumbers) {
  std::mt19937_64 random = generator(304);
  for (int i = 0; i < 20000; ++i) {
    const Integer factor = 1 + abs(biased_integer(random, 120));
    Integer kept = (Integer(1) << 52) + Integer(random() >> 12);
    if (i % 7 == 0) kept = (Integer(1) << 53) - 1 - i % 2;
    const Integer tie = 2 * kept + 1;  // 54 bits
    const unsigned up = static_cast<unsigned>(below(random, 70)), down = static_cast<unsigned>(below(random, 60));
    check_quotient(kept * factor << up, factor);
    check_quotient(kept * factor, factor << down);
    check_quotient(tie * factor << up, factor);
    check_quotient(tie * factor, factor << down);
    check_quotient(Integer(between(random, 0, world)) * factor, factor);
  }
}

// The quotient misses a tie or a double by one part in 2^240: only the remainder tells.
TEST(GeometryTest, RoundedQuotientNearTies) {
  std::mt19937_64 random = generator(305);
  for (int i = 0; i < 20000; ++i) {
    const Integer d =
        (Integer(1) << static_cast<unsigned>(between(random, 100, 187))) + abs(biased_integer(random, 100));
    Integer kept = (Integer(1) << 53) + Integer(random() >> 11);  // 54 bits: doubles and ties
    if (i % 7 == 0) kept = (Integer(1) << 54) - 1 - i % 4;
    for (int e = -2; e <= 2; ++e) check_quotient(kept * d + e, d);
    // The same at the other end: the denominator is what is off by one.
    const Integer n = kept * d;
    for (int e = -1; e <= 1; ++e) check_quotient(n, d + e);
    const unsigned up = static_cast<unsigned>(below(random, 8));
    for (int e = -1; e <= 1; ++e) check_quotient((n << up) + e, d);
  }
}

TEST(GeometryTest, EqualPointsOfDifferentPlanesHaveEqualApproximations) {
  std::mt19937_64 random = generator(306);
  int compared = 0;
  for (int i = 0; i < 5000; ++i) {
    // A pencil through one point: integer combinations of three planes with small coefficients.
    std::array<Plane, 3> p{};
    for (Plane& q : p) {
      q = random_plane(random);
      for (std::int64_t& c : q.n) c /= 16;
      q.d /= 16;
    }
    const auto u = meet(p[0], p[1], p[2]);
    if (!u) continue;
    const auto combination = [&] {
      std::array<std::int64_t, 3> n{};
      int128 d = 0;
      for (const Plane& q : p) {
        const std::int64_t f = between(random, -4, 4);
        for (std::size_t k = 0; k < 3; ++k) n[k] += f * q.n[k];
        d += f * q.d;
      }
      return n == std::array<std::int64_t, 3>{} ? p[0] : reduced_plane(n, d);
    };
    const auto v = meet(combination(), combination(), combination());
    if (!v) continue;
    ++compared;
    ASSERT_EQ(u->approximation, v->approximation);
    for (int k = 0; k < 3; ++k) {
      const auto s = static_cast<std::size_t>(k);
      ASSERT_EQ(coordinate(*u, k), coordinate(*v, k));
      ASSERT_FALSE(u->approximation[s] == 0 && std::signbit(u->approximation[s]));
    }
  }
  EXPECT_GT(compared, 1000);
}

TEST(GeometryTest, GridPointsAreExactInDoubles) {
  std::mt19937_64 random = generator(307);
  for (int i = 0; i < 1000; ++i) {
    const GridPoint g = random_grid_point(random, world);
    const Point u = point(g);
    EXPECT_TRUE(u.w == Denominator(1));
    const Plane p = random_plane(random);
    const Rational expected = rational_value(p, {rational(g[0]), rational(g[1]), rational(g[2])});
    ASSERT_EQ(rational(value(p, g)), expected);
    ASSERT_EQ(Rational(to_integer(scaled_value(p, u))), expected);
    for (int k = 0; k < 3; ++k) {
      ASSERT_EQ(coordinate(u, k), g[k]);
      ASSERT_EQ(u.approximation[static_cast<std::size_t>(k)], g[k]);
    }
    // The same point as a meeting of planes.
    const auto v = meet(Plane{{1, 0, 0}, -g[0]}, Plane{{0, -1, 0}, g[1]}, Plane{{0, 0, 1}, -g[2]});
    ASSERT_TRUE(v.has_value());
    ASSERT_EQ(v->approximation, u.approximation);
  }
}

TEST(GeometryTest, ValueAtTheCornersOfTheWorldFits) {
  const Plane p{{limit, limit, limit}, offset_limit};
  const Rational l = rational(limit);
  EXPECT_EQ(rational(value(p, {{world, world, world}})), 3 * l * world + l * l);
  EXPECT_EQ(rational(value(p.opposite(), {{world, world, world}})), -(3 * l * world + l * l));
}

TEST(GeometryTest, SegmentMeetEqualsTheMeetOfThreePlanes) {
  std::mt19937_64 random = generator(308);
  int crossed = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::int32_t size = i % 2 == 0 ? world : 50;
    const GridPoint u = random_grid_point(random, size), v = random_grid_point(random, size);
    Plane p = random_plane(random);
    // Through the world: the offset follows from a point of it.
    const GridPoint o = random_grid_point(random, size);
    p = reduced_plane(p.n, -(value({p.n, 0}, o)) + between(random, -3, 3));
    const int128 at_u = value(p, u), at_v = value(p, v);
    if (at_u == 0 || at_v == 0 || (at_u < 0) == (at_v < 0)) continue;
    ++crossed;
    const Point m = meet(u, at_u, v, at_v), reversed = meet(v, at_v, u, at_u);
    ASSERT_TRUE(m.x == reversed.x && m.w == reversed.w && m.approximation == reversed.approximation);
    ASSERT_EQ(m.w.sign(), 1);
    ASSERT_EQ(scaled_value(p, m).sign(), 0);
    for (const Numerator& x : m.x) ASSERT_LT(abs(to_integer(x)), Integer(1) << 124);
    // Two planes through u, v and a third point each.
    for (int attempt = 0; attempt < 20; ++attempt) {
      const auto q = plane_through(u, v, random_grid_point(random, size)),
                 r = plane_through(v, u, random_grid_point(random, size));
      if (!q || !r) continue;
      const auto w = meet(p, *q, *r);
      if (!w) continue;
      ASSERT_EQ(w->approximation, m.approximation);
      for (int k = 0; k < 3; ++k) {
        ASSERT_EQ(coordinate(*w, k), coordinate(m, k));
        ASSERT_TRUE(is_nearest(coordinate(m, k), m.approximation[static_cast<std::size_t>(k)]));
        ASSERT_GE(coordinate(m, k), std::min(u[k], v[k]));
        ASSERT_LE(coordinate(m, k), std::max(u[k], v[k]));
      }
      break;
    }
  }
  EXPECT_GT(crossed, 1000);
}

// Opposite corners of the world, the largest normal: every bound of the segment's meet at its extreme.
TEST(GeometryTest, SegmentMeetAtTheCornersOfTheWorld) {
  const GridPoint u{{-world, -world, -world}}, v{{world, world, world}};
  for (const int128 d : {int128(0), int128(limit) * world * 3 - 1, -int128(limit) * world * 3 + 1}) {
    const Plane p{{limit, limit, limit}, d};
    const Point m = meet(u, value(p, u), v, value(p, v));
    EXPECT_EQ(to_integer(m.w), 6 * Integer(limit) * world);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(coordinate(m, k), -rational(d) / rational(limit) / 3);
  }
}

/// How many lines a x + b y + c = 0 there are, their directions, and the points in which two of them meet: all, and
/// those within a square about the origin.
struct GridOfLines {
  std::size_t lines, directions, points, near, around;
  friend bool operator==(const GridOfLines&, const GridOfLines&) = default;
};

GridOfLines grid_of_lines(std::int64_t normal, std::int64_t offset, int near, int around) {
  const auto smaller = [](const Plane& p, const Plane& q) { return compare(p, q) < 0; };
  std::set<Plane, decltype(smaller)> lines(smaller), directions(smaller);
  for (std::int64_t a = -normal; a <= normal; ++a)
    for (std::int64_t b = -normal; b <= normal; ++b)
      for (std::int64_t c = -offset; c <= offset; ++c) {
        if (a == 0 && b == 0) continue;
        const Plane p = reduced_plane({a, b, 0}, c), d = reduced_plane({a, b, 0}, 0);
        lines.insert(is_canonical(p) ? p : p.opposite());
        directions.insert(is_canonical(d) ? d : d.opposite());
      }
  const Plane floor{{0, 0, 1}, 0};
  std::set<std::array<Rational, 2>> points;
  for (auto p = lines.begin(); p != lines.end(); ++p)
    for (auto q = std::next(p); q != lines.end(); ++q)
      if (const auto m = meet(*p, *q, floor)) points.insert({coordinate(*m, 0), coordinate(*m, 1)});
  const auto within = [&](int size) {
    return static_cast<std::size_t>(std::count_if(
        points.begin(), points.end(), [&](const auto& v) { return abs(v[0]) <= size && abs(v[1]) <= size; }));
  };
  return {lines.size(), directions.size(), points.size(), within(near), within(around)};
}

// E05: drawn in the literature, counted here.
TEST(GeometryTest, E05GridsOfLines) {
  EXPECT_EQ(grid_of_lines(2, 2, 1, 4), (GridOfLines{48, 8, 341, 125, 309}));
  EXPECT_EQ(grid_of_lines(2, 8, 1, 4), (GridOfLines{168, 8, 4329, 137, 1729}));
  EXPECT_EQ(grid_of_lines(2, 4, 1, 4), (GridOfLines{88, 8, 1173, 137, 821}));
  EXPECT_EQ(grid_of_lines(3, 9, 1, 4), (GridOfLines{392, 16, 24001, 1233, 12305}));
}

TEST(GeometryTest, TheLongestComponentIsTheFirstOfEquals) {
  EXPECT_EQ(longest_component(std::array<std::int64_t, 3>{1, -3, 2}), 1u);
  EXPECT_EQ(longest_component(std::array<std::int64_t, 3>{-2, 2, 2}), 0u);
  EXPECT_EQ(longest_component(std::array<std::int64_t, 3>{0, 0, -1}), 2u);
  EXPECT_EQ(longest_component(std::array<int, 4>{0, 0, 0, 0}), 0u);
}

}  // namespace
}  // namespace quoin::exact::testing
