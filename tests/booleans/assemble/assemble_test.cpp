#include "booleans/assemble/assemble.h"

#include <gtest/gtest.h>

#include "booleans/body/canonical.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

Body large_ball() {
  return *sphere({0, 0, 0}, 40, 60, [](std::uint32_t, std::uint32_t) { return 1e6; });
}

/// A small block or ball near the surface of the large one, sometimes where another has been.
Body small_tool(Random& random) {
  const auto at = [&] {
    const double a = static_cast<double>(random.below(6)), b = static_cast<double>(random.below(3));
    return Vector{std::llround(9.7e5 * std::cos(a) * std::cos(b)), std::llround(9.7e5 * std::sin(a) * std::cos(b)),
                  std::llround(9.7e5 * std::sin(b))};
  };
  for (;;) {
    const Vector centre = at() + random.vector(-20000, 20000), reach = random.vector(20000, 90000);
    if (random.one_in(2)) return box(centre - reach, centre + reach);
    const double radius = static_cast<double>(reach[0]);
    if (const auto ball = sphere(centre, 3, 5, [&](std::uint32_t, std::uint32_t) { return radius; })) return *ball;
  }
}

// Small changes of a large solid share its lists. The second way: all operands in one arrangement, too many for that.
TEST(Assemble, PatchedResultsAreThoseOfOneArrangement) {
  std::size_t patched = 0;
  for (std::uint64_t number = 0; number < case_count(5); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xA55E, number);
    std::vector<Body> operands{large_ball()};
    std::vector<Body> results{operands[0]};
    std::vector<Canonical> forms{canonical(operands[0])};
    Expression e;
    e.add({Rule::operand, false, 0, none});
    for (std::uint32_t i = 1; i <= 14; ++i) {
      operands.push_back(small_tool(random));
      const Rule rule = random.one_in(3) ? Rule::any : random.one_in(4) ? Rule::odd : Rule::all;
      const bool negated = rule == Rule::all;
      Expression next;
      next.add({rule, false, 0, none});
      for (auto node : e.nodes) {
        node.parent = node.parent == none ? 0 : node.parent + 1;
        next.add(node);
      }
      next.add({Rule::operand, negated, i, 0});
      e = next;
      results.push_back(combined(rule, {&results.back(), &operands[i]}, negated ? 1 : none));
      patched += !results.back().is_packed;
      forms.push_back(canonical(results.back()));
      // Another branch from the same solid takes the place behind its lists, or does not get it.
      if (random.one_in(3)) minus(results[i - 1], operands[i]);
      if (i == 9 || i == 14) {
        EXPECT_TRUE(forms.back() == canonical(evaluated(operands, e)));
      }
    }
    for (std::size_t i = 0; i < results.size(); ++i) EXPECT_TRUE(canonical(results[i]) == forms[i]) << i;
    EXPECT_TRUE(canonical(packed(results.back())) == forms.back());
    EXPECT_TRUE(same(complement(complement(results.back())), results.back()));
    EXPECT_EQ(volume(minus(results.back(), operands[1])) + volume(all(results.back(), operands[1])),
              volume(results.back()));
  }
  if (usual_thresholds()) {
    EXPECT_GT(patched, 10 * case_count(5));
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
