// What is trusted wrongly gives an answer or an error, never a crash.
#include <gtest/gtest.h>

#include <optional>
#include <utility>
#include <vector>

#include "booleans/body/body.h"
#include "quoin/quoin.h"
#include "tests/api/solids.h"
#include "tests/booleans/support.h"

namespace quoin::api_test {
namespace {

using booleans::testing::case_count;
using booleans::testing::case_name;
using booleans::testing::Random;

/// A mesh as it is, taken for embedded; nothing where its volume already gives it away.
std::optional<Solid> trusted(const booleans::Body& mesh) {
  std::vector<double> points;
  for (const auto& p : mesh.grid_points)
    for (const std::int32_t x : p.c) points.push_back(x);
  std::vector<std::uint32_t> triangles;
  for (const auto& t : mesh.triangles) triangles.insert(triangles.end(), t.begin(), t.end());
  ImportOptions options;
  options.grid = Grid();
  options.trust = Trust::embedded;
  auto solid = Solid::from_triangles(points, triangles, options);
  if (solid) return std::move(solid).value();
  EXPECT_EQ(solid.error().code, ErrorCode::inside_out);
  return std::nullopt;
}

/// Asks everything that takes no other solid.
void ask(const Solid& solid) {
  const Info info = solid.info();
  EXPECT_GE(info.triangles + 1, 1u);
  EXPECT_FALSE(solid.to_quoin().empty());
  if (solid.is_bounded()) {
    EXPECT_TRUE(solid.to_triangles());
  }
  (void)solid.classify({0.5, 0.5, 0.5});
}

/// The value, or nothing: an operand that crosses itself may be found out.
std::optional<Solid> found(Result<Solid> result) {
  if (result) return std::move(result).value();
  EXPECT_EQ(result.error().code, ErrorCode::inconsistent);
  return std::nullopt;
}

// Flat patches folded over themselves under a cone, some of them doubled or turned inside out.
TEST(Trust, FoldedSheets) {
  std::size_t answers = 0, refusals = 0;
  for (std::uint64_t number = 0; number < case_count(60); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x7205, number);
    const auto between = [&](std::int64_t low, std::int64_t high) { return random.between(low, high); };
    const auto n = static_cast<std::uint32_t>(random.between(1, 6));
    const auto mesh = booleans::testing::folded_sheet(between, n, random.between(2, 8));
    if (!mesh) continue;

    const std::optional<Solid> folded = trusted(*mesh);
    if (!folded) continue;

    const std::vector<Solid> solids{*folded, box({0, 0, 0}, {3, 3, 3}), box({-1, 2, 0}, {9, 4, 1})};
    ask(solids[0]);
    const std::vector<Solid> first{solids[0], solids[1]};
    for (auto& result : {found(unite(first)), found(intersect(solids)), found(difference(solids[1], {solids[0]})),
                         found(difference(solids[0], {solids[2]})), found(symmetric_difference(solids))}) {
      (result ? answers : refusals) += 1;
      if (result) ask(*result);
    }
  }
  EXPECT_GT(answers, 0u);
  EXPECT_GT(refusals, 0u);
}

}  // namespace
}  // namespace quoin::api_test
