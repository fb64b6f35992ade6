#include "rounding/planes/plane_rounding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <span>
#include <vector>

#include "rounding/motions/realize.h"
#include "tests/rounding/planes/planes.h"

namespace quoin::rounding::testing {
namespace {

// Example 4.2: bounds 3 and 9. Opposite planes have opposite results (S06).
TEST(PlaneRoundingTest, TheBooksExample) {
  const PlaneRounder r(3, 9);
  const WidePlane p = wide_plane({Rational(32, 10), Rational(45, 10), Rational(123, 10)}, 30);
  EXPECT_EQ(rounded(r, p, Method::naive), plane(1, 1, 3, 7));
  const WidePlane q = wide_plane({Rational(-32, 10), Rational(-45, 10), Rational(-123, 10)}, -30);
  EXPECT_EQ(rounded(r, q, Method::naive), plane(-1, -1, -3, -7));
}

// A normal that would vanish is reported, not returned (S07). The other methods keep directions; here the offset does
// not fit at any.
TEST(PlaneRoundingTest, VanishingNormals) {
  const PlaneRounder r(3, 9);
  for (const Method method : global_methods) {
    EXPECT_EQ(r.round(plane(1, 1, 1, 100), method), std::nullopt);
    EXPECT_EQ(r.round(plane(-1, -1, -1, 100), method), std::nullopt);
  }
  // Just on the other side: 9/70 of it is (1.29, 1.29, 1.41, 9).
  EXPECT_EQ(rounded(r, plane(10, 10, 11, 70), Method::naive), plane(1, 1, 1, 9));
}

/// The convex box or the like between three pairs of opposite planes: at each of the 4 corners of the opposite side, is
/// the plane's value negative? Counts the violations of these 24 conditions.
int violations(const std::array<WidePlane, 6>& planes) {
  int count = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    const std::size_t pair = i / 2;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const WidePlane& a = planes[i ^ 1];
      const WidePlane& b = planes[(pair + 1) % 3 * 2 + corner % 2];
      const WidePlane& c = planes[(pair + 2) % 3 * 2 + corner / 2];
      const auto row = [](const WidePlane& p) { return Vector{p.n[0], p.n[1], p.n[2]}; };
      const Matrix m{row(a), row(b), row(c)};
      const bool inside = determinant(m) != 0 && value(planes[i], inverse({m, {0, 0, 0}})({-a.d, -b.d, -c.d})) < 0;
      count += inside ? 0 : 1;
    }
  }
  return count;
}
std::array<WidePlane, 6> box(const Rational& x, const Rational& y, const Rational& z) {
  return {wide_plane({-1, 0, 0}, 0), wide_plane({1, 0, 0}, -x), wide_plane({0, -1, 0}, 0),
          wide_plane({0, 1, 0}, -y), wide_plane({0, 0, -1}, 0), wide_plane({0, 0, 1}, -z)};
}
std::array<WidePlane, 6> moved_box(std::array<WidePlane, 6> planes, const Motion& motion) {
  for (WidePlane& p : planes) p = moved(p, inverse(realize(motion).map));
  return planes;
}
std::array<WidePlane, 6> naively(std::array<WidePlane, 6> planes, const Integer& limit) {
  const PlaneRounder r(limit, limit * limit);
  for (WidePlane& p : planes) p = rounded(r, p, Method::naive);
  return planes;
}

// 24 conditions tell whether a rounded box is still one.
TEST(PlaneRoundingTest, RoundedBox) {
  EXPECT_EQ(violations(box(3, 2, 1)), 0);
  const auto turned = moved_box(box(3, 2, 1), Motion::turn(quaternion(2, 0, 0, 1)));
  const std::array exact_planes{plane(-3, -4, 0, 0),  plane(3, 4, 0, -15), plane(4, -3, 0, 0),
                                plane(-4, 3, 0, -10), plane(0, 0, -1, 0),  plane(0, 0, 1, -1)};
  EXPECT_EQ(turned, exact_planes);
  EXPECT_EQ(violations(turned), 0);
  EXPECT_EQ(naively(turned, 15), exact_planes);
  const std::array coarse{plane(-2, -3, 0, 0), plane(2, 2, 0, -9), plane(3, -2, 0, 0),
                          plane(-3, 2, 0, -8), plane(0, 0, -1, 0), plane(0, 0, 1, -1)};
  EXPECT_EQ(naively(turned, 3), coarse);
  EXPECT_EQ(violations(coarse), 0);
}

// A thin plate: top and bottom fall together for small bounds.
TEST(PlaneRoundingTest, RoundedPlate) {
  const Motion motion = Motion::turn(quaternion(3, 0, 0, 1)).then(Motion::turn(quaternion(5, 2, 0, 0)));
  const auto plate = moved_box(box(3, 3, Rational(1, 100)), motion);
  EXPECT_EQ(violations(plate), 0);
  for (const int limit : {3, 5, 15}) {
    const auto r = naively(plate, limit);
    EXPECT_EQ(violations(r), 8) << limit;
    EXPECT_EQ(r[4], r[5].opposite()) << limit;
  }
  EXPECT_EQ(naively(plate, 15)[4], plane(0, 14, -15, 0));
  EXPECT_EQ(naively(plate, 15)[5], plane(0, -14, 15, 0));
  EXPECT_EQ(naively(plate, 127)[4], plane(0, 20, -21, 0));
  EXPECT_EQ(naively(plate, 127)[5], plane(0, -121, 127, -2));
  EXPECT_EQ(violations(naively(plate, 127)), 0);
  EXPECT_EQ(naively(plate, 1023)[5], plane(0, -974, 1023, -14));
}

// R1: what fits stays.
TEST(PlaneRoundingTest, PlanesThatFitStay) {
  std::mt19937_64 random = generator(351);
  for (const unsigned bits : all_bits) {
    const PlaneRounder r = rounder(bits);
    const Integer limit = power_of_2(bits) - 1;
    for (int i = 0; i < 60; ++i) {
      Vector n;
      for (Rational& x : n) x = biased_integer(random, bits) % (limit + 1);
      if (n == Vector{0, 0, 0}) continue;
      const Integer d = biased_integer(random, 2 * bits) % (limit * limit + 1);
      const WidePlane p = wide_plane(n, i == 0 ? Rational(limit * limit) : Rational(d));
      ASSERT_TRUE(r.fits(p));
      for (const Method method : global_methods) ASSERT_EQ(rounded(r, p, method), p);
      const std::vector<Vector> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
      const auto near = r.round_near(p, points);
      ASSERT_TRUE(near.has_value());
      ASSERT_EQ(wide(*near), p);
    }
  }
  EXPECT_TRUE(PlaneRounder(3, 9).fits(plane(3, -3, 3, -9)));
  EXPECT_FALSE(PlaneRounder(3, 9).fits(plane(3, -4, 3, 0)));
  EXPECT_FALSE(PlaneRounder(3, 9).fits(plane(1, 0, 0, 10)));
  // The bounds of the ladder.
  const Integer limit = exact::coefficient_limit;
  EXPECT_TRUE(PlaneRounder().fits(plane(limit, -limit, 1, limit * limit)));
  EXPECT_FALSE(PlaneRounder().fits(plane(limit + 1, 1, 1, 0)));
  EXPECT_FALSE(PlaneRounder().fits(plane(1, 1, 1, -limit * limit - 1)));
}

// R2, and that results are within the bounds, in lowest terms, and on the plane's side.
TEST(PlaneRoundingTest, OppositePlanesStayOpposite) {
  std::mt19937_64 random = generator(352);
  for (const unsigned bits : all_bits) {
    const PlaneRounder r = rounder(bits);
    int rounded_ones = 0;
    for (int i = 0; i < 40; ++i) {
      const WidePlane p = random_large_plane(random, bits);
      for (const Method method : global_methods) {
        const auto a = r.round(p, method), b = r.round(p.opposite(), method);
        ASSERT_EQ(a.has_value(), b.has_value());
        // A rounder that remembers other planes says the same as a new one.
        ASSERT_EQ(rounder(bits).round(p, method), a);
        if (!a) continue;
        ++rounded_ones;
        ASSERT_EQ(*a, b->opposite());
        ASSERT_TRUE(r.fits(wide(*a)));
        ASSERT_EQ(gcd(content(normal(*a)), offset(*a)), 1);
        ASSERT_GT(dot_of(normal(*a), p.n), 0);
        // Rounding once more changes nothing.
        ASSERT_EQ(r.round(wide(*a), method), a);
      }
    }
    ASSERT_GT(rounded_ones, 20) << bits;
  }
}

// R3: parallel planes stay parallel, also beside one that fits.
TEST(PlaneRoundingTest, ParallelPlanesStayParallel) {
  std::mt19937_64 random = generator(353);
  for (const unsigned bits : all_bits) {
    const PlaneRounder r = rounder(bits);
    const Integer limit = power_of_2(bits) - 1;
    for (int i = 0; i < 20; ++i) {
      Vector n = random_direction(random, 3);
      if (below(random, 2) == 0)
        for (Rational& x : n) x = biased_integer(random, below(random, 2) == 0 ? bits : bits + 30) + 1;
      if (n == Vector{0, 0, 0}) continue;
      for (const Method method : {Method::best, Method::lattice}) {
        std::optional<Normal> common;
        for (int j = 0; j < 4; ++j) {
          // Distances up to the bound and beyond.
          const Rational d = magnitude(n[0] + n[1] + n[2]) * random_rational(random, 2 * bits) / (j + 1);
          const auto p = r.round(wide_plane(n, d), method);
          if (!p) continue;
          if (!common) common = direction(normal(*p));
          ASSERT_EQ(direction(normal(*p)), *common);
        }
        const auto at_origin = r.round(wide_plane(n, 0), method);
        ASSERT_TRUE(at_origin.has_value());
        if (common) {
          ASSERT_EQ(direction(normal(*at_origin)), *common);
        }
        ASSERT_EQ(offset(*at_origin), 0);
        // It keeps the direction when that fits.
        const Normal exact = direction(wide_plane(n, 0).n);
        if (abs(exact[0]) <= limit && abs(exact[1]) <= limit && abs(exact[2]) <= limit) {
          ASSERT_EQ(direction(normal(*at_origin)), exact);
        }
      }
    }
  }
}

// Numbers of some thousand digits go by their first ones.
TEST(PlaneRoundingTest, LongDirectionsRoundAsTheirFirstDigits) {
  std::mt19937_64 random = generator(360);
  for (const unsigned bits : {8u, 24u, 62u})
    for (int i = 0; i < 10; ++i) {
      Normal short_one, long_one;
      for (std::size_t k = 0; k < 3; ++k) {
        short_one[k] = (Integer(random()) << 36) + Integer(random() >> 28);
        if (below(random, 2) == 0) short_one[k] = -short_one[k];
        long_one[k] = Integer(short_one[k] << 4000) + between(random, -1000, 1000);
      }
      const auto through_origin = [](const Normal& n) { return wide_plane({n[0], n[1], n[2]}, 0); };
      for (const Method method : {Method::best, Method::lattice}) {
        const WidePlane expected = rounded(rounder(bits), through_origin(short_one), method);
        EXPECT_EQ(rounded(rounder(bits), through_origin(long_one), method), expected) << bits << ' ' << i;
      }
    }
}

TEST(PlaneRoundingTest, BestIsTheClosestDirection) {
  std::mt19937_64 random = generator(354);
  int with_offset = 0;
  for (const unsigned bits : all_bits) {
    const PlaneRounder r = rounder(bits);
    for (int i = 0; i < 60; ++i) {
      const WidePlane p = random_large_plane(random, bits), through_origin = wide_plane({p.n[0], p.n[1], p.n[2]}, 0);
      const Rational best = squared_sine(rounded(r, through_origin, Method::best).n, p.n);
      ASSERT_LE(best, squared_sine(rounded(r, through_origin, Method::naive).n, p.n)) << bits;
      ASSERT_LE(best, squared_sine(rounded(r, through_origin, Method::lattice).n, p.n)) << bits;
      const auto fraction = r.round(through_origin, Method::continued_fraction);
      ASSERT_TRUE(fraction.has_value());
      ASSERT_LE(best, squared_sine(normal(*fraction), p.n)) << bits;
      if (const auto q = r.round(p, Method::best)) {
        ++with_offset;
        ASSERT_EQ(squared_sine(normal(*q), p.n), best);
      }
    }
  }
  EXPECT_GT(with_offset, 200);
}

// Second way: of all directions within a small bound, none is much closer. By squared sines the worst of all planes
// with numbers up to 47 is 5.15 times the least, (17, 17, 32, 0) for L = 12.
TEST(PlaneRoundingTest, BestAgainstTheSearch) {
  std::mt19937_64 random = generator(355);
  int optimal = 0, count = 0;
  for (int limit = 1; limit <= 12; ++limit) {
    const PlaneRounder r(limit, limit * limit);
    for (int i = 0; i < 12; ++i) {
      const WidePlane any = random_plane(random, 5 + static_cast<unsigned>(below(random, 40)));
      const WidePlane p = wide_plane({any.n[0], any.n[1], any.n[2]}, 0);
      // Of (1, 2, 0) and its multiples the largest will do.
      Rational least = 2;
      for (int a = -limit; a <= limit; ++a)
        for (int b = -limit; b <= limit; ++b)
          for (int c = -limit; c <= limit; ++c) {
            const Normal n{a, b, c};
            if (std::max({std::abs(a), std::abs(b), std::abs(c)}) * 2 <= limit || dot_of(n, p.n) <= 0) continue;
            least = std::min(least, squared_sine(n, p.n));
          }
      for (const Method method : {Method::best, Method::lattice}) {
        const Rational found = squared_sine(rounded(r, p, method).n, p.n);
        ASSERT_GE(found, least);
        ASSERT_LE(found, 8 * least) << limit << ": " << p.n[0] << ' ' << p.n[1] << ' ' << p.n[2];
        optimal += found == least ? 1 : 0;
        ++count;
      }
    }
  }
  // Nearly always it is the closest.
  EXPECT_GT(optimal * 10, count * 9);
}

// Directions get as close as lattices allow: sin^2 of about L^-3, against L^-2 for the naive method. Directions near
// one of small numbers do worse, so this is for most, not all.
TEST(PlaneRoundingTest, LatticeBeatsTheNaiveOrder) {
  std::mt19937_64 random = generator(356);
  for (const unsigned bits : {16u, 32u, 48u, 62u}) {
    const PlaneRounder r = rounder(bits);
    for (const Method method : {Method::best, Method::lattice}) {
      int close = 0;
      for (int i = 0; i < 40; ++i) {
        Vector n;
        for (Rational& x : n) x = Integer(random()) * Integer(random()) + 1;
        const WidePlane p = wide_plane(n, 0);
        close += squared_sine(rounded(r, p, method).n, p.n) <= Rational(16, power_of_2(3 * bits)) ? 1 : 0;
      }
      EXPECT_GE(close, 28) << bits;
    }
  }
}

// The new plane's value at the point of the old one that is nearest to the origin, for a normal in lowest terms: at
// most 1/2.
TEST(PlaneRoundingTest, OffsetsAreNearest) {
  std::mt19937_64 random = generator(357);
  for (const unsigned bits : all_bits) {
    const PlaneRounder r = rounder(bits);
    const Integer limit = power_of_2(bits) - 1;
    int count = 0;
    for (int i = 0; i < 60; ++i) {
      const WidePlane p = random_large_plane(random, bits);
      const Vector nearest = Rational(-p.d, dot_of(p.n, p.n)) * Vector{p.n[0], p.n[1], p.n[2]};
      ASSERT_EQ(value(p, nearest), 0);
      for (const Method method : {Method::best, Method::lattice}) {
        const auto q = r.round(p, method);
        const Normal d = direction(rounded(r, wide_plane({p.n[0], p.n[1], p.n[2]}, 0), method).n);
        // The offset that belongs to the direction: nothing just where it exceeds its bound.
        const Rational wanted = -dot({d[0], d[1], d[2]}, nearest);
        ASSERT_EQ(q.has_value(), magnitude(wanted) <= limit * limit);
        if (!q) continue;
        ++count;
        const Integer multiple = content(normal(*q));
        const Rational error = value(wide(*q), nearest) / multiple;
        ASSERT_EQ(Rational(offset(*q), multiple) - wanted, error);
        ASSERT_LE(magnitude(error), Rational(1, 2));
        // As well as a fraction can whose denominator leaves room for the direction and for the offset.
        const Integer most_coefficient = limit / std::max({Integer(abs(d[0])), Integer(abs(d[1])), Integer(abs(d[2]))});
        const Integer room =
            wanted == 0 ? most_coefficient : std::min(most_coefficient, floor_of(limit * limit / magnitude(wanted)));
        ASSERT_LE(multiple, room);
        ASSERT_LE(magnitude(error), Rational(1, 2 * room));
        ASSERT_LE(magnitude(error), magnitude(naive_approximation(wanted, room) - wanted));
      }
    }
    ASSERT_GT(count, 15) << bits;
  }
}

TEST(PlaneRoundingTest, OffsetsBeyondTheBoundGiveNothing) {
  for (const unsigned bits : all_bits) {
    const PlaneRounder r = rounder(bits);
    const Integer limit = power_of_2(bits) - 1, most = limit * limit;
    EXPECT_EQ(rounded(r, plane(1, 0, 0, most), Method::best), plane(1, 0, 0, most));
    for (const Method method : global_methods) {
      EXPECT_EQ(r.round(plane(1, 0, 0, 4 * most), method), std::nullopt) << bits;
      EXPECT_EQ(r.round(plane(0, -1, 0, -4 * most), method), std::nullopt) << bits;
      EXPECT_EQ(r.round(plane(power_of_2(100), 1, 1, power_of_2(130) * most), method), std::nullopt) << bits;
    }
    for (const Method method : {Method::best, Method::lattice}) {
      EXPECT_EQ(r.round(plane(0, 0, 1, most + 1), method), std::nullopt) << bits;
      // An offset of just the bound, and one of a unit less with a fraction.
      EXPECT_EQ(rounded(r, wide_plane({0, 0, 1}, most - Rational(1, power_of_2(200))), method), plane(0, 0, 1, most));
    }
  }
}

TEST(PlaneRoundingTest, SquaredDisplacementIsTheLargest) {
  const Plane p{{1, 2, 2}, -3};
  const std::vector<Vector> points{{1, 1, 0}, {4, 1, 0}, {0, 0, 0}, {Rational(1, 2), 0, 0}};
  EXPECT_EQ(squared_displacement(p, points), 1);
  EXPECT_EQ(squared_displacement(p, std::span(points).first(1)), 0);
  EXPECT_EQ(squared_displacement(p.opposite(), std::span(points).last(1)), Rational(25, 36));
  EXPECT_EQ(squared_sine({1, 0, 0}, {0, 5, 0}), 1);
  EXPECT_EQ(squared_sine({1, 0, 0}, {7, 0, 0}), 0);
  EXPECT_EQ(squared_sine({1, 0, 0}, {3, 4, 0}), Rational(16, 25));
  EXPECT_EQ(squared_sine({1, 1, 0}, {0, 1, 1}), Rational(3, 4));
}

}  // namespace
}  // namespace quoin::rounding::testing
