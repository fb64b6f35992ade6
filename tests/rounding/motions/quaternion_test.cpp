#include "rounding/motions/quaternion.h"

#include <gtest/gtest.h>

#include <utility>

#include "tests/rounding/motions/stated.h"

namespace quoin::rounding::testing {
namespace {

TEST(QuaternionTest, QuaternionsAreRotations) {
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

TEST(QuaternionTest, ExactRotationRefusesOthers) {
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

TEST(QuaternionTest, NearestRotationOfDecimals) {
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

TEST(QuaternionTest, NearestRotationRefusesOthers) {
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

}  // namespace
}  // namespace quoin::rounding::testing
