#include "booleans/questions/moments.h"

#include <gtest/gtest.h>

#include "booleans/body/measure.h"
#include "tests/booleans/questions/places.h"

namespace quoin::booleans::testing {
namespace {

/// All ten.
std::array<Rational, 10> ten(const Moments& m) {
  return {m.volume,    m.first[0],  m.first[1],  m.first[2],  m.second[0],
          m.second[1], m.second[2], m.second[3], m.second[4], m.second[5]};
}
std::array<Rational, 10> ten(const Body& body) { return ten(moments(Index(body))); }
std::array<Rational, 10> sum(const std::array<Rational, 10>& a, const std::array<Rational, 10>& b, int sign = 1) {
  std::array<Rational, 10> r;
  for (std::size_t i = 0; i < 10; ++i) r[i] = a[i] + sign * b[i];
  return r;
}

// The integrals of a box are products of integrals of powers over its sides.
TEST(Moments, OfABox) {
  const std::array<std::int64_t, 3> low{-1, 2, 3}, high{4, 6, 9};
  const auto power = [&](std::size_t axis, int n) {
    const Rational a = low[axis], b = high[axis];
    return n == 0 ? Rational(b - a) : n == 1 ? Rational((b * b - a * a) / 2) : Rational((b * b * b - a * a * a) / 3);
  };
  const auto product = [&](int x, int y, int z) { return Rational(power(0, x) * power(1, y) * power(2, z)); };
  const std::array<Rational, 10> expected{product(0, 0, 0), product(1, 0, 0), product(0, 1, 0), product(0, 0, 1),
                                          product(2, 0, 0), product(0, 2, 0), product(0, 0, 2), product(0, 1, 1),
                                          product(1, 0, 1), product(1, 1, 0)};
  EXPECT_EQ(ten(box(low, high)), expected);
}

// Of a simplex with corners p: volume V, first moments V s / 4, second ones V (s s' + sum of p p') / 20.
TEST(Moments, OfTetrahedra) {
  for (std::uint64_t number = 0; number < case_count(60); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x303, number);
    std::array<Vector, 4> p;
    const std::int64_t reach = random.one_in(2) ? 9 : exact::world;
    for (Vector& v : p) v = random.vector(-reach, reach);
    const auto body = tetrahedron(p);
    if (!body) continue;
    const Rational v = volume(*body);
    std::array<Rational, 10> expected{v};
    const auto s = [&](std::size_t k) { return Rational(p[0][k] + p[1][k] + p[2][k] + p[3][k]); };
    for (std::size_t k = 0; k < 3; ++k) expected[1 + k] = v * s(k) / 4;
    for (std::size_t m = 0; m < 6; ++m) {
      const auto [i, j] = axes_of_moment(m);
      Rational products = s(i) * s(j);
      for (const Vector& q : p) products += Rational(q[i]) * q[j];
      expected[4 + m] = v * products / 20;
    }
    ASSERT_EQ(ten(*body), expected);
  }
}

TEST(Moments, ObeyInclusionAndExclusion) {
  for (const Family family : families)
    for (std::uint64_t number = 0; number < case_count(25); ++number) {
      SCOPED_TRACE(std::string(name_of(family)) + " " + case_name(number));
      Random random(0x304, number);
      Solids solids(random, family);
      const Body a = solids.next(), b = solids.next();
      const Body common = all(a, b);
      ASSERT_EQ(sum(ten(any(a, b)), ten(common)), sum(ten(a), ten(b)));
      ASSERT_EQ(sum(ten(minus(a, b)), ten(common)), ten(a));
      ASSERT_EQ(sum(ten(complement(a)), ten(a)), (std::array<Rational, 10>{}));
      ASSERT_EQ(moments(Index(a)).volume, volume(a));
    }
}

TEST(Moments, AreaIsBetweenItsBounds) {
  const Interval cube = area(Index(box({0, 0, 0}, {3, 4, 5})));
  EXPECT_LE(cube.low, 94);
  EXPECT_GE(cube.high, 94);
  EXPECT_LT(cube.high - cube.low, 1e-11);
  EXPECT_LT(area(Index(Body())).high, 1e-300);

  // Faces x + y + z = c of a cut box: right isosceles triangles and one of area 3^(1/2) / 2 c^2.
  const Interval corner = area(Index(half_space_body({{3, 3, 3}, -7}, {{0, 0, 0}}, {{9, 9, 9}})));
  const double c = 7. / 3, expected = 1.5 * c * c + std::sqrt(3.) / 2 * c * c;
  EXPECT_LE(corner.low, expected * (1 + 1e-15));
  EXPECT_GE(corner.high, expected * (1 - 1e-15));
  EXPECT_LT(corner.high - corner.low, 1e-12);

  for (std::uint64_t number = 0; number < case_count(40); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x305, number);
    Solids solids(random, families[number % families.size()]);
    const Body body = odd(solids.next(), solids.next());
    const Interval bounds = area(Index(body));
    const double about = approximate_area(body);
    EXPECT_LE(bounds.low, about * (1 + 1e-9));
    EXPECT_GE(bounds.high, about * (1 - 1e-9));
    EXPECT_LE(bounds.high - bounds.low, about * 1e-6);
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
