#include "rounding/motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "rounding/enclosure.h"
#include "tests/rounding/support.h"

namespace quoin::rounding::testing {
namespace {

const AffineMap identity;
const Vector x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1}, diagonal{1, 1, 1};

/// What the 600 bits of MPFR leave over, amply.
const Rational epsilon(1, power_of_2(400));

Integer power_of_10(int digits) { return pow(Integer(10), static_cast<unsigned>(digits)); }

Matrix transposed(const Matrix& m) {
  return {Vector{m[0][0], m[1][0], m[2][0]}, Vector{m[0][1], m[1][1], m[2][1]}, Vector{m[0][2], m[1][2], m[2][2]}};
}
Matrix product(const Matrix& a, const Matrix& b) { return composed(AffineMap{b, {0, 0, 0}}, {a, {0, 0, 0}}).linear; }

Rational random_degrees(std::mt19937_64& random) {
  switch (below(random, 5)) {
    case 0:
      return between(random, -24, 24) * 15;
    case 1:
      return Rational(between(random, -2, 2)) * 90 + Rational(between(random, -1, 1), power_of_2(50));
    case 2:
      return Rational(between(random, -36000, 36000), 100);
    default:
      return Rational(biased_integer(random, 70), abs(biased_integer(random, 60)) + 1);
  }
}

Motion random_step(std::mt19937_64& random) {
  switch (below(random, 6)) {
    case 0:
      return Motion::translation(random_vector(random, 20));
    case 1:
      return Motion::turn(random_quaternion(random, 10));
    case 2:
      return Motion::mirror(random_direction(random, 1));
    case 3:
      return Motion::scaling({between(random, 1, 3), Rational(between(random, 1, 3), 2), between(random, 1, 3)});
    default:
      return Motion::rotation(random_direction(random, 1), random_degrees(random));
  }
}
Motion random_motion(std::mt19937_64& random, std::size_t steps) {
  Motion m;
  for (std::size_t i = 0; i < steps; ++i) m = m.then(random_step(random));
  return m;
}

/// The stated rotation, carried out with some 580 bits.
Quaternion fine_rotation(const RotationStep& step) {
  const Axis& v = step.axis;
  if (step.degrees == 180) return quaternion(0, v[0], v[1], v[2]);
  const Integer norm = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  const Rational half = magnitude(step.degrees) / 2;
  const Rational t = true_tangent(half, MPFR_RNDN) / true_root(norm, MPFR_RNDN);
  const Integer s = step.degrees < 0 ? Integer(-numerator(t)) : Integer(numerator(t));
  return quaternion(denominator(t), s * v[0], s * v[1], s * v[2]);
}

/// What a motion states, with some 580 bits.
AffineMap fine_map(const Motion& motion) {
  AffineMap map;
  for (const Step& step : motion.steps()) {
    if (const auto* rotation = std::get_if<RotationStep>(&step)) {
      map = composed(map, {matrix(fine_rotation(*rotation)), {0, 0, 0}});
    } else if (const auto* translation = std::get_if<TranslationStep>(&step)) {
      map = composed(map, {identity.linear, translation->by});
    } else if (const auto* turn = std::get_if<TurnStep>(&step)) {
      map = composed(map, {matrix(turn->by), {0, 0, 0}});
    } else if (const auto* mirror = std::get_if<MirrorStep>(&step)) {
      // p - 2 (p . n) / (n . n) n, column by column.
      const Vector n{mirror->normal[0], mirror->normal[1], mirror->normal[2]};
      Matrix columns;
      for (std::size_t k = 0; k < 3; ++k) columns[k] = identity.linear[k] - (2 * n[k] / dot(n, n)) * n;
      map = composed(map, {transposed(columns), {0, 0, 0}});
    } else {
      const Vector& by = std::get<ScalingStep>(step).by;
      map = composed(map, {{Vector{by[0], 0, 0}, Vector{0, by[1], 0}, Vector{0, 0, by[2]}}, {0, 0, 0}});
    }
  }
  return map;
}

/// The signed difference of the angle 2 atan(t) to `degrees`, rounded towards `direction`.
Rational angle_error(const Rational& t, const Rational& degrees, mpfr_rnd_t direction) {
  return 2 * true_arctangent_degrees(t, direction) - degrees;
}

// Half-angle substitution: t = 1/2 gives (3/5, 4/5).
TEST(MotionTest, HalfAngleGivesThreeFourFive) {
  const Quaternion q = quaternion(2, 0, 0, 1);
  EXPECT_EQ(matrix(q), (Matrix{Vector{Rational(3, 5), Rational(-4, 5), 0}, Vector{Rational(4, 5), Rational(3, 5), 0},
                               Vector{0, 0, 1}}));
  EXPECT_EQ(realize(Motion::turn(q)).map.linear, matrix(q));
}

// The plane x - 1 = 0 turned again and again by (3/5, 4/5): two digits more every three turns.
TEST(MotionTest, RepeatedTurnsOfAPlane) {
  const Motion turn = Motion::turn(quaternion(2, 0, 0, 1));
  const std::array<std::array<int, 4>, 6> rows{{{3, 4, 0, -5},
                                                {-7, 24, 0, -25},
                                                {-117, 44, 0, -125},
                                                {-527, -336, 0, -625},
                                                {-237, -3116, 0, -3125},
                                                {11753, -10296, 0, -15625}}};
  const WidePlane start{{1, 0, 0}, -1};
  WidePlane step_by_step = start;
  Motion all;
  for (const auto& row : rows) {
    const WidePlane expected{{row[0], row[1], row[2]}, row[3]};
    step_by_step = moved(step_by_step, inverse(realize(turn).map));
    EXPECT_EQ(step_by_step, expected);
    // At once: the turns joined to one.
    all = all.then(turn);
    EXPECT_EQ(all.steps().size(), 1u);
    EXPECT_EQ(moved(start, inverse(realize(all).map)), expected);
    // By the inverse motion.
    EXPECT_EQ(moved(start, realize(all.inverse()).map), expected);
  }
}

// The convergents of tan 15, the rotations by about 30 degrees that they give, and how far they are off.
TEST(MotionTest, ConvergentsOfTan15) {
  struct Row {
    Rational t, u, v;
    const char* error;  // degrees, rounded as printed
  };
  const Row rows[] = {
      {Rational(1, 3), Rational(4, 5), Rational(3, 5), "6.87"},
      {Rational(1, 4), Rational(15, 17), Rational(8, 17), "-1.93"},
      {Rational(3, 11), Rational(56, 65), Rational(33, 65), ".510"},
      {Rational(4, 15), Rational(209, 241), Rational(120, 241), "-.137"},
      {Rational(11, 41), Rational(780, 901), Rational(451, 901), ".0367"},
      {Rational(15, 56), Rational(2911, 3361), Rational(1680, 3361), "-.00984"},
      {Rational(41, 153), Rational(10864, 12545), Rational(6273, 12545), ".00264"},
      {Rational(56, 209), Rational(40545, 46817), Rational(23408, 46817), "-.000707"},
      {Rational(153, 571), Rational(151316, 174725), Rational(87363, 174725), ".000189"},
  };
  ContinuedFraction low(enclosed_tangent(15, 192).low), high(enclosed_tangent(15, 192).high);
  for (ContinuedFraction* c : {&low, &high}) {
    ASSERT_TRUE(c->next());
    EXPECT_EQ(c->quotient(), 0);
  }
  const Integer quotients[] = {3, 1, 2, 1, 2, 1, 2, 1, 2};
  std::size_t i = 0;
  for (const Row& row : rows) {
    for (ContinuedFraction* c : {&low, &high}) {
      ASSERT_TRUE(c->next());
      EXPECT_EQ(c->quotient(), quotients[i]);
      EXPECT_EQ(Rational(c->p(), c->q()), row.t);
    }
    ++i;
    const Matrix m = matrix(quaternion(denominator(row.t), 0, 0, numerator(row.t)));
    EXPECT_EQ(m[0][0], row.u);
    EXPECT_EQ(m[1][0], row.v);
    EXPECT_EQ(m[0][1], -row.v);
    const std::string text = row.error;
    Rational half_digit(1, 2);
    for (std::size_t k = text.find('.') + 1; k < text.size(); ++k) half_digit /= 10;
    const Rational printed = *exact::parse_rational(text);
    EXPECT_LE(printed - half_digit, angle_error(row.t, 30, MPFR_RNDD)) << text;
    EXPECT_GE(printed + half_digit, angle_error(row.t, 30, MPFR_RNDU)) << text;
  }
  // What is carried out is one of them, or lies between two.
  const ApproximateRotation r = approximate({{0, 0, 1}, 30});
  const Rational t = enclosed_tangent(15, 400).low;
  EXPECT_EQ(Rational(r.by.z, r.by.w), best_approximation(t, power_of_2(46)));
}

TEST(MotionTest, CertifiedAngleBoundsTheTrueError) {
  std::mt19937_64 random = generator(330);
  std::vector<RotationStep> steps{
      {{0, 0, 1}, 30}, {{0, 0, 1}, 1}, {{1, 0, 0}, 179}, {{1, 1, 0}, 45}, {{0, 1, 0}, Rational(1, power_of_2(20))}};
  for (int i = 0; i < 200; ++i) {
    const Motion m = Motion::rotation(random_direction(random, 3), random_degrees(random));
    if (!m.steps().empty()) steps.push_back(std::get<RotationStep>(m.steps()[0]));
  }
  for (const RotationStep& step : steps) {
    const ApproximateRotation r = approximate(step);
    const Axis& v = step.axis;
    const Integer norm = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    // It turns about the axis, by 2 atan(s |v| / w).
    const std::array<Integer, 3> n{r.by.x, r.by.y, r.by.z};
    const std::size_t k = v[0] != 0 ? 0 : v[1] != 0 ? 1 : 2;
    for (std::size_t j = 0; j < 3; ++j) ASSERT_EQ(n[j] * v[k], n[k] * v[j]);
    const Rational s(n[k], v[k]);
    const int sign = step.degrees < 0 ? -1 : 1;
    Rational least, most;  // of the angle
    if (r.by.w == 0) {
      least = most = 180;
    } else {
      const Rational ratio = s * sign / r.by.w;
      ASSERT_GE(ratio, 0);
      least = 2 * true_arctangent_degrees(ratio * true_root(norm, MPFR_RNDD), MPFR_RNDD);
      most = 2 * true_arctangent_degrees(ratio * true_root(norm, MPFR_RNDU), MPFR_RNDU);
    }
    const Rational stated = magnitude(step.degrees);
    const Rational error = std::max(magnitude(least - stated), magnitude(most - stated));
    const Rational surely =
        least <= stated && stated <= most ? Rational(0) : std::min(magnitude(least - stated), magnitude(most - stated));
    ASSERT_GE(r.error_degrees, surely) << step.degrees;
    // The two units agree.
    ASSERT_GE(r.error_degrees, r.error_radians * 180 / true_pi(MPFR_RNDU));
    ASSERT_LE(r.error_degrees, r.error_radians * 180 / true_pi(MPFR_RNDD) * (1 + Rational(1, power_of_2(40))));
    // The bound says nothing worse than the distance of the tangents does: d tan / d angle = 1 + tan^2 <= 1 + norm.
    ASSERT_LE(r.error_degrees, (error + Rational(1, power_of_2(150))) * (1 + norm) * Rational(101, 100))
        << step.degrees;
    // One unit of 1 / (2 Q), Q = 2^32 - 1, in the tangent, or in the cotangent.
    ASSERT_LE(r.error_radians, root_above(norm) * Rational(1, power_of_2(32) - 1) + Rational(1, power_of_2(150)));
  }
}

TEST(MotionTest, ThirtyDegreesAboutZ) {
  const RealizedMotion r = realize(Motion::rotation(z_axis, 30));
  ASSERT_TRUE(r.rotation.has_value());
  const Rational t(r.rotation->z, r.rotation->w);
  const Rational error = std::max(magnitude(angle_error(t, 30, MPFR_RNDD)), magnitude(angle_error(t, 30, MPFR_RNDU)));
  EXPECT_GT(error, 0);
  EXPECT_GE(r.angle_error_degrees, error);
  EXPECT_LT(r.angle_error_degrees, 2 * error);
  EXPECT_LT(r.angle_error_degrees, Rational(1, power_of_10(17)));
  EXPECT_EQ(r.map.linear, matrix(*r.rotation));
  EXPECT_EQ(r.map.shift, (Vector{0, 0, 0}));
}

TEST(MotionTest, AnglesAddAsStated) {
  Motion m;
  for (int i = 0; i < 360; ++i) {
    EXPECT_EQ(m.steps().size(), i == 0 ? 0u : 1u);
    m = m.then(Motion::rotation(z_axis, 1));
  }
  EXPECT_EQ(m, Motion());
  Motion thirds;
  for (int i = 0; i < 3; ++i) thirds = thirds.then(Motion::rotation({2, 2, 0}, Rational(100, 3)));
  EXPECT_EQ(thirds, Motion::rotation({1, 1, 0}, 100));
  EXPECT_EQ(Motion::rotation(x_axis, 720), Motion());
  EXPECT_EQ(Motion::rotation(x_axis, 190), Motion::rotation(x_axis, -170));
  EXPECT_EQ(Motion::rotation(x_axis, -180), Motion::rotation(x_axis, 180));
  EXPECT_EQ(Motion::rotation(x_axis, 540), Motion::rotation(x_axis, 180));
  EXPECT_NE(Motion::rotation(x_axis, 1), Motion::rotation(x_axis, -1));
}

TEST(MotionTest, OppositeAxesAreOneAxis) {
  std::mt19937_64 random = generator(331);
  for (int i = 0; i < 200; ++i) {
    const Vector axis = random_direction(random, 4);
    const Rational degrees = random_degrees(random), factor(between(random, 1, 9), between(random, 1, 9));
    const Motion m = Motion::rotation(axis, degrees);
    ASSERT_EQ(Motion::rotation(Rational(-1) * axis, -degrees), m);
    ASSERT_EQ(Motion::rotation(factor * axis, degrees + 360), m);
    ASSERT_EQ(Motion::mirror(-factor * axis), Motion::mirror(axis));
    for (const Step& step : m.steps()) {
      const auto& rotation = std::get<RotationStep>(step);
      ASSERT_TRUE(is_canonical(WidePlane{rotation.axis, 0}));
      ASSERT_EQ(gcd(gcd(rotation.axis[0], rotation.axis[1]), rotation.axis[2]), 1);
      ASSERT_GT(rotation.degrees, -180);
      ASSERT_LE(rotation.degrees, 180);
      ASSERT_NE(rotation.degrees, 0);
    }
  }
}

TEST(MotionTest, ApproximationsAreOddInTheAngle) {
  std::mt19937_64 random = generator(332);
  for (int i = 0; i < 100; ++i) {
    const Vector axis = random_direction(random, 3);
    const Motion m = Motion::rotation(axis, random_degrees(random));
    const RealizedMotion there = realize(m), back = realize(m.inverse());
    ASSERT_EQ(composed(*there.rotation, *back.rotation), Quaternion());
    ASSERT_EQ(there.map.linear, transposed(back.map.linear));
    ASSERT_EQ(there.angle_error_degrees, back.angle_error_degrees);
    ASSERT_EQ(there.displacement_per_unit, back.displacement_per_unit);
  }
}

TEST(MotionTest, ExactAngles) {
  const auto exact = [](const Vector& axis, const Rational& degrees, const Matrix& expected) {
    const RealizedMotion r = realize(Motion::rotation(axis, degrees));
    EXPECT_EQ(r.map.linear, expected) << degrees;
    EXPECT_EQ(r.angle_error_degrees, 0) << degrees;
    EXPECT_EQ(r.displacement_per_unit, 0) << degrees;
    EXPECT_EQ(r.displacement, 0) << degrees;
  };
  exact(z_axis, 90, {Vector{0, -1, 0}, Vector{1, 0, 0}, Vector{0, 0, 1}});
  exact(z_axis, -90, {Vector{0, 1, 0}, Vector{-1, 0, 0}, Vector{0, 0, 1}});
  exact(x_axis, 90, {Vector{1, 0, 0}, Vector{0, 0, -1}, Vector{0, 1, 0}});
  exact(y_axis, 90, {Vector{0, 0, 1}, Vector{0, 1, 0}, Vector{-1, 0, 0}});
  exact(x_axis, 180, {Vector{1, 0, 0}, Vector{0, -1, 0}, Vector{0, 0, -1}});
  exact({1, 1, 0}, 180, {Vector{0, 1, 0}, Vector{1, 0, 0}, Vector{0, 0, -1}});
  // x to y to z to x.
  exact(diagonal, 120, {Vector{0, 0, 1}, Vector{1, 0, 0}, Vector{0, 1, 0}});
  exact(diagonal, -120, {Vector{0, 1, 0}, Vector{0, 0, 1}, Vector{1, 0, 0}});
  const Rational a(2, 3), b(-1, 3);
  exact(diagonal, 60, {Vector{a, b, a}, Vector{a, a, b}, Vector{b, a, a}});
  // An axis of rational length: (1, 2, 2) by 90.
  const RealizedMotion r = realize(Motion::rotation({1, 2, 2}, 90));
  EXPECT_EQ(r.angle_error_degrees, 0);
  EXPECT_EQ(*r.rotation, quaternion(3, 1, 2, 2));
  // Those that are not: 60 about z, 90 and 30 about the diagonal.
  for (const Motion& m : {Motion::rotation(z_axis, 60), Motion::rotation(diagonal, 90), Motion::rotation(diagonal, 30)})
    EXPECT_GT(realize(m).angle_error_degrees, 0);
}

TEST(MotionTest, NoAngleIsOffByMoreThanTheTolerance) {
  std::mt19937_64 random = generator(333);
  for (int i = 0; i < 200; ++i) {
    const Motion m = Motion::rotation(random_direction(random, 5), random_degrees(random));
    for (const Step& step : m.steps())
      ASSERT_LE(approximate(std::get<RotationStep>(step)).error_radians, Rational(1, power_of_2(92)));
  }
}

// Angles too small, or too near to 180, for any fraction: carried out as 0 or 180, and the certificate says so.
TEST(MotionTest, AnglesNextTo0And180) {
  for (const unsigned bits : {100u, 300u}) {
    const Rational tiny(1, power_of_2(bits));
    const ApproximateRotation zero = approximate({{0, 1, 0}, tiny}), half = approximate({{0, 1, 0}, 180 - tiny}),
                              back = approximate({{0, 1, 0}, tiny - 180});
    EXPECT_EQ(zero.by, Quaternion());
    EXPECT_EQ(half.by, quaternion(0, 0, 1, 0));
    EXPECT_EQ(back.by, quaternion(0, 0, 1, 0));
    for (const ApproximateRotation& r : {zero, half, back}) {
      EXPECT_GE(r.error_degrees, tiny);
      EXPECT_LE(r.error_degrees, std::max(Rational(2 * tiny), Rational(1, power_of_2(150))));
    }
  }
}

TEST(MotionTest, InversesCancel) {
  std::mt19937_64 random = generator(334);
  for (int i = 0; i < 100; ++i) {
    const Motion m = random_motion(random, below(random, 7));
    ASSERT_EQ(m.then(m.inverse()), Motion());
    ASSERT_EQ(m.inverse().then(m), Motion());
    ASSERT_EQ(m.inverse().inverse(), m);
    ASSERT_EQ(composed(realize(m).map, realize(m.inverse()).map), identity);
    ASSERT_EQ(inverse(realize(m).map), realize(m.inverse()).map);
  }
}

TEST(MotionTest, WordsAreReduced) {
  std::mt19937_64 random = generator(335);
  for (int i = 0; i < 200; ++i) {
    const Motion a = random_motion(random, below(random, 4)), b = random_motion(random, below(random, 4)),
                 c = random_motion(random, below(random, 4));
    ASSERT_EQ(a.then(b).then(c), a.then(b.then(c)));
    ASSERT_EQ(a.then(b).inverse(), b.inverse().then(a.inverse()));
    ASSERT_EQ(a.then(Motion()), a);
    ASSERT_EQ(Motion().then(a), a);
    ASSERT_EQ(a.then(b).then(b.inverse()), a);
  }
  EXPECT_EQ(Motion::translation({0, 0, 0}), Motion());
  EXPECT_EQ(Motion::scaling({1, 1, 1}), Motion());
  EXPECT_EQ(Motion::turn(Quaternion()), Motion());
  EXPECT_EQ(Motion::translation({1, 2, 3}).then(Motion::translation({-1, 0, 1})), Motion::translation({0, 2, 4}));
  EXPECT_EQ(Motion::scaling({2, 3, 4}).then(Motion::scaling({Rational(1, 2), 1, 1})), Motion::scaling({1, 3, 4}));
}

// Where no steps join, the map of the composition is the composition of the maps; so it is for exact steps that join.
TEST(MotionTest, MapsCompose) {
  std::mt19937_64 random = generator(336);
  int whole = 0;
  for (int i = 0; i < 200; ++i) {
    const Motion a = random_motion(random, 1 + below(random, 3)), b = random_motion(random, 1 + below(random, 3));
    const Motion both = a.then(b);
    const bool joined = both.steps().size() != a.steps().size() + b.steps().size();
    // Joined angles are approximated anew; and two mirrors that cancel leave a rotation.
    const auto inexact = [](const Step& step) {
      return std::holds_alternative<RotationStep>(step) || std::holds_alternative<MirrorStep>(step);
    };
    if (joined && (std::ranges::any_of(a.steps(), inexact) || std::ranges::any_of(b.steps(), inexact))) continue;
    whole += joined ? 0 : 1;
    const RealizedMotion first = realize(a), second = realize(b), r = realize(both);
    ASSERT_EQ(r.map, composed(first.map, second.map));
    const Vector p = random_vector(random, 20);
    ASSERT_EQ(r.map(p), second.map(first.map(p)));
    ASSERT_EQ(r.rotation.has_value(), first.rotation.has_value() && second.rotation.has_value());
    if (r.rotation) {
      ASSERT_EQ(*r.rotation, composed(*first.rotation, *second.rotation));
      ASSERT_EQ(matrix(*r.rotation), r.map.linear);
    }
    if (!joined) {
      ASSERT_EQ(r.angle_error_degrees, first.angle_error_degrees + second.angle_error_degrees);
    }
  }
  EXPECT_GT(whole, 50);
}

TEST(MotionTest, MirrorsAndScalings) {
  std::mt19937_64 random = generator(337);
  for (int i = 0; i < 100; ++i) {
    const Vector n = random_direction(random, 5), p = random_vector(random, 20);
    const Motion mirror = Motion::mirror(n);
    ASSERT_EQ(mirror.then(mirror), Motion());
    ASSERT_EQ(mirror.inverse(), mirror);
    const RealizedMotion r = realize(mirror);
    ASSERT_FALSE(r.rotation.has_value());
    ASSERT_EQ(determinant(r.map.linear), -1);
    ASSERT_EQ(composed(r.map, r.map), identity);
    // The image lies across the plane: the middle in it, the way there along the normal.
    const Vector image = r.map(p), way = image - p;
    ASSERT_EQ(dot(image + p, n), 0);
    ASSERT_EQ(dot(way, way) * dot(n, n), dot(way, n) * dot(way, n));
  }
  EXPECT_EQ(realize(Motion::mirror(x_axis)).map.linear, (Matrix{Vector{-1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}));
  const RealizedMotion s = realize(Motion::scaling({2, Rational(1, 3), 1}));
  EXPECT_EQ(s.map({3, 3, 3}), (Vector{6, 1, 3}));
  EXPECT_FALSE(s.rotation.has_value());
  EXPECT_EQ(s.displacement_per_unit, 0);
}

TEST(MotionTest, AffineMaps) {
  std::mt19937_64 random = generator(338);
  for (int i = 0; i < 200; ++i) {
    const AffineMap a{{random_vector(random, 10), random_vector(random, 10), random_vector(random, 10)},
                      random_vector(random, 10)},
        b{{random_vector(random, 10), random_vector(random, 10), random_vector(random, 10)}, random_vector(random, 10)};
    const Vector p = random_vector(random, 10);
    ASSERT_EQ(composed(a, b)(p), b(a(p)));
    ASSERT_EQ(determinant(composed(a, b).linear), determinant(a.linear) * determinant(b.linear));
    if (determinant(a.linear) == 0) continue;
    ASSERT_EQ(composed(a, inverse(a)), identity);
    ASSERT_EQ(composed(inverse(a), a), identity);
  }
  EXPECT_EQ(determinant({Vector{1, 2, 3}, Vector{4, 5, 6}, Vector{7, 8, 10}}), -3);
}

TEST(MotionTest, QuaternionsAreRotations) {
  std::mt19937_64 random = generator(339);
  for (int i = 0; i < 300; ++i) {
    const Quaternion p = random_quaternion(random, 20), q = random_quaternion(random, 20);
    const Matrix m = matrix(p);
    ASSERT_EQ(product(m, transposed(m)), identity.linear);
    ASSERT_EQ(determinant(m), 1);
    ASSERT_EQ(matrix(composed(p, q)), product(matrix(q), m));
    ASSERT_EQ(quaternion(-3 * p.w, -3 * p.x, -3 * p.y, -3 * p.z), p);
    ASSERT_EQ(exact_rotation(m), p);
    ASSERT_EQ(exact_rotation(product(matrix(q), m)), composed(p, q));
    // The axis stays, and one turns right-handed: the turn of u about v leans towards v x u for w > 0.
    const Vector v{p.x, p.y, p.z};
    ASSERT_EQ((AffineMap{m, {0, 0, 0}})(v), v);
    const Rational lean = m[2][1] - m[1][2];
    ASSERT_EQ(sign_of(lean), sign_of(Integer(p.w * p.x)));
  }
}

TEST(MotionTest, ExactRotationRefusesOthers) {
  std::mt19937_64 random = generator(340);
  for (int i = 0; i < 100; ++i) {
    const Matrix m = matrix(random_quaternion(random, 20));
    Matrix other = m;
    for (Vector& row : other) row = Rational(-1) * row;
    EXPECT_FALSE(exact_rotation(other)) << "a point image";
    other = m;
    std::swap(other[0], other[1]);
    EXPECT_FALSE(exact_rotation(other)) << "a mirror image";
    other = m;
    other[0] = other[0] + Rational(1, 7) * other[1];
    EXPECT_FALSE(exact_rotation(other)) << "a shear";
    other = m;
    other[2] = 2 * other[2];
    EXPECT_FALSE(exact_rotation(other)) << "a scaling";
    other = m;
    other[1][2] += Rational(1, power_of_2(200));
    EXPECT_FALSE(exact_rotation(other)) << "nearly";
  }
  EXPECT_FALSE(exact_rotation(Matrix{}));
}

Matrix with_digits(const Matrix& m, int digits) {
  Matrix r;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) r[i][j] = naive_approximation(m[i][j], power_of_10(digits));
  return r;
}
Rational largest_difference(const Matrix& a, const Matrix& b) {
  Rational r = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) r = std::max(r, magnitude(a[i][j] - b[i][j]));
  return r;
}

TEST(MotionTest, NearestRotationOfDecimals) {
  std::mt19937_64 random = generator(341);
  for (int i = 0; i < 60; ++i) {
    const Quaternion stated = random_quaternion(random, 60);
    for (const int digits : {9, 7, 16}) {
      const Matrix m = with_digits(matrix(stated), digits);
      Rational deviation = -1;
      const auto q = nearest_rotation(m, deviation);
      ASSERT_TRUE(q.has_value());
      ASSERT_EQ(deviation, largest_difference(matrix(*q), m));
      // Of both: the digits, and the 62 bits.
      ASSERT_LE(deviation, Rational(2, power_of_10(digits)) + Rational(1, 100000000));
      if (exact_rotation(m)) continue;
      for (const Integer& x : {q->w, q->x, q->y, q->z}) ASSERT_LT(abs(x), power_of_2(62));
      // No rotation next to it is clearly nearer: neighbours a few units of 2^-30 away.
      const auto squares = [&](const Quaternion& u) {
        Rational sum = 0;
        const Matrix a = matrix(u);
        for (std::size_t r = 0; r < 3; ++r) sum += dot(a[r] - m[r], a[r] - m[r]);
        return sum;
      };
      const Integer step = 16;
      for (const auto& u : {quaternion(q->w + step, q->x, q->y, q->z), quaternion(q->w - step, q->x, q->y, q->z),
                            quaternion(q->w, q->x + step, q->y, q->z), quaternion(q->w, q->x - step, q->y, q->z),
                            quaternion(q->w, q->x, q->y + step, q->z), quaternion(q->w, q->x, q->y - step, q->z),
                            quaternion(q->w, q->x, q->y, q->z + step), quaternion(q->w, q->x, q->y, q->z - step)})
        if (largest_difference(matrix(u), matrix(*q)) > Rational(1, power_of_2(30))) {
          ASSERT_GE(squares(u), squares(*q));
        }
    }
    Rational deviation = -1;
    ASSERT_EQ(nearest_rotation(matrix(stated), deviation), stated);
    ASSERT_EQ(deviation, 0);
  }
}

TEST(MotionTest, NearestRotationRefusesOthers) {
  std::mt19937_64 random = generator(342);
  for (int i = 0; i < 60; ++i) {
    const Matrix m = with_digits(matrix(random_quaternion(random, 30)), 9);
    Rational deviation;
    Matrix other = m;
    for (Vector& row : other) row = Rational(1000001, 1000000) * row;
    EXPECT_FALSE(nearest_rotation(other, deviation)) << "scaled";
    other = m;
    other[0] = other[0] + Rational(1, 100000) * other[1];
    EXPECT_FALSE(nearest_rotation(other, deviation)) << "sheared";
    other = m;
    other[1] = Rational(-1) * other[1];
    EXPECT_FALSE(nearest_rotation(other, deviation)) << "mirrored";
    other = m;
    for (Vector& row : other) row = Rational(10000001, 10000000) * row;
    EXPECT_TRUE(nearest_rotation(other, deviation)) << "within the tolerance";
  }
  Rational deviation;
  EXPECT_FALSE(nearest_rotation(Matrix{}, deviation));
}

// A point is carried to where the stated motion has it, up to the certificate.
TEST(MotionTest, DisplacementCertificate) {
  std::mt19937_64 random = generator(343);
  Rational tightest = 0;
  for (int i = 0; i < 60; ++i) {
    const Motion m = random_motion(random, 1 + below(random, 6));
    const RealizedMotion r = realize(m);
    const AffineMap stated = fine_map(m);
    for (int j = 0; j < 5; ++j) {
      const Vector p = j == 0 ? Vector{0, 0, 0} : random_vector(random, 30);
      const Vector e = r.map(p) - stated(p);
      const Rational bound = r.displacement_per_unit * root_above(dot(p, p)) + r.displacement;
      const Rational slack = epsilon * (1 + dot(p, p)) * power_of_10(12);
      ASSERT_LE(dot(e, e), (bound + slack) * (bound + slack)) << i;
      if (bound > 0) tightest = std::max(tightest, Rational(dot(e, e) / (bound * bound)));
    }
  }
  // It is not idle either: some point moves by a good part of it.
  EXPECT_GT(tightest, Rational(1, 16));
}

TEST(MotionTest, InversesInIntegers) {
  std::mt19937_64 random = generator(381);
  for (int i = 0; i < 200; ++i) {
    AffineMap map{{random_vector(random, 30), random_vector(random, 30), random_vector(random, 30)},
                  random_vector(random, 30)};
    if (below(random, 2) == 0) map.linear = matrix(random_quaternion(random, 60));
    if (determinant(map.linear) == 0) continue;
    const IntegerMap back = inverse(IntegerMap(map));
    ASSERT_GT(back.divisor, 0);
    const AffineMap expected = inverse(map);
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(Rational(back.linear[r][c], back.divisor), expected.linear[r][c]);
      ASSERT_EQ(Rational(back.shift[r], back.divisor), expected.shift[r]);
    }
  }
}

TEST(MotionTest, FilteredImagesAreWithinTheirErrors) {
  std::mt19937_64 random = generator(380);
  int exact_ones = 0, narrow = 0;
  for (int i = 0; i < 3000; ++i) {
    const bool in_steps = below(random, 2) == 0;
    AffineMap map;
    // Rotations, integers, and anything from 2^-1100 to 2^1100.
    const auto kind = below(random, 3);
    const Rational size = below(random, 2) == 0 ? Rational(power_of_2(static_cast<unsigned>(below(random, 1100))))
                                                : Rational(1, power_of_2(static_cast<unsigned>(below(random, 1100))));
    if (kind == 0) map = {matrix(random_quaternion(random, 40)), random_vector(random, 29)};
    if (kind > 0)
      for (std::size_t k = 0; k < 3; ++k) {
        for (Rational& x : map.linear[k])
          x = kind == 1 ? Rational(between(random, -3, 3)) : size * random_rational(random);
        map.shift[k] = kind == 1 ? Rational(between(random, -1'000'000, 1'000'000)) : size * random_rational(random);
      }
    Vector p = random_vector(random, 200);
    if (in_steps)
      for (Rational& x : p) x = between(random, -(1 << 30), 1 << 30);
    const std::array doubles{exact::to_double(p[0]), exact::to_double(p[1]), exact::to_double(p[2])};
    const MapFilter filter(map);
    const Vector image = map(p);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [value, error] = filter(k, doubles, in_steps);
      if (!std::isfinite(value) || !std::isfinite(error)) {
        EXPECT_FALSE(std::isfinite(error));
        continue;
      }
      ASSERT_LE(magnitude(exact::to_rational(value) - image[k]), exact::to_rational(error)) << i << ' ' << k;
      exact_ones += error == 0 ? 1 : 0;
      narrow += kind == 0 && in_steps && error < 0x1p-17 ? 1 : 0;
    }
  }
  EXPECT_GT(exact_ones, 500);
  EXPECT_GT(narrow, 500);
}

}  // namespace
}  // namespace quoin::rounding::testing
