// The filters next to zero, where their numbers (exact/filter_bounds.h) must be large enough: a filter with too small a
// number answers +-1 where the exact sign is 0 or the other one.
#include <gtest/gtest.h>

#include "tests/exact/support.h"

namespace quoin::exact::testing {
namespace {

using Normal = std::array<std::int64_t, 3>;

Integer determinant(const Normal& a, const Normal& b, const Normal& c) {
  const auto minor = [&](std::size_t i, std::size_t j) { return Integer(Integer(b[i]) * c[j] - Integer(b[j]) * c[i]); };
  return Integer(minor(1, 2) * a[0] + minor(2, 0) * a[1] + minor(0, 1) * a[2]);
}

// Normals of 62 bits, the third one a rounded combination of the others.
TEST(FilterTest, TurnOfRandomNormalsNextToOnePlane) {
  std::mt19937_64 random = generator(410);
  int undecided = 0;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    std::array<Normal, 3> n{};
    for (std::size_t k = 0; k < 2; ++k)
      for (auto& c : n[k]) c = between(random, -coefficient_limit, coefficient_limit);
    const std::int64_t alpha = between(random, -512, 512), beta = between(random, -511, 511);
    for (std::size_t k = 0; k < 3; ++k)
      n[2][k] = static_cast<std::int64_t>((int128(alpha) * n[0][k] + int128(beta) * n[1][k]) / 1024);
    if (n[2] == Normal{}) continue;

    int answer = 2;
    undecided += rung_of([&] { answer = turn({n[0], 0}, {n[1], 0}, {n[2], 0}); }) == Rung::fixed_width;
    ASSERT_EQ(answer, sign_of(determinant(n[0], n[1], n[2])));
  }
  EXPECT_GT(undecided, count - count / 100);  // that near to zero no double tells
}

}  // namespace
}  // namespace quoin::exact::testing
