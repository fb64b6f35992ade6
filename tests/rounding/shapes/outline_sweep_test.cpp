#include "rounding/shapes/outline_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "tests/rounding/support.h"

namespace quoin::rounding::testing {
namespace {

using Index = std::uint32_t;
using Point = std::array<std::int64_t, 2>;
using Polygon = std::vector<Point>;

int orientation(const Point& a, const Point& b, const Point& c) {
  const std::int64_t turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  return (turn > 0) - (turn < 0);
}

/// The corners of polygons, and what was asked of them.
struct Corners {
  std::vector<Point> at;
  std::vector<Index> starts{0};
  mutable std::size_t comparisons = 0, orientations = 0;

  void add(const Polygon& polygon) {
    at.insert(at.end(), polygon.begin(), polygon.end());
    starts.push_back(static_cast<Index>(at.size()));
  }
  int compare(Index a, Index b) const {
    ++comparisons;
    return (at[a] > at[b]) - (at[a] < at[b]);
  }
  int orientation(Index a, Index b, Index c) const {
    ++orientations;
    return testing::orientation(at[a], at[b], at[c]);
  }
  Index next(Index corner) const {
    const auto end = std::upper_bound(starts.begin(), starts.end(), corner);
    return corner + 1 == *end ? *(end - 1) : corner + 1;
  }
  Nesting nesting() const { return OutlineSweep(*this, starts).run(); }
};

bool is_between(const Point& p, const Point& a, const Point& b) {
  return orientation(a, b, p) == 0 && (p[0] - a[0]) * (p[0] - b[0]) + (p[1] - a[1]) * (p[1] - b[1]) <= 0;
}

/// Do two sides meet, but for neighbours in their common corner? By all their ends.
bool meet(const Corners& c, Index i, Index j) {
  if (c.next(i) == j || c.next(j) == i) return false;
  const Point &a = c.at[i], &b = c.at[c.next(i)], &p = c.at[j], &q = c.at[c.next(j)];
  const bool touch = is_between(p, a, b) || is_between(q, a, b) || is_between(a, p, q) || is_between(b, p, q);
  return touch || (orientation(a, b, p) * orientation(a, b, q) < 0 && orientation(p, q, a) * orientation(p, q, b) < 0);
}

bool has_meeting_side(const Corners& c) {
  for (Index i = 0; i < c.at.size(); ++i)
    for (Index j = 0; j < i; ++j)
      if (meet(c, i, j)) return true;
  return false;
}

/// By a ray to the right. Precondition: the point is on no side.
bool is_inside(const Corners& c, Index polygon, const Point& p) {
  bool inside = false;
  for (Index i = c.starts[polygon]; i < c.starts[polygon + 1]; ++i) {
    const Point &a = c.at[i], &b = c.at[c.next(i)];
    if ((a[1] > p[1]) != (b[1] > p[1])) inside ^= (orientation(a, b, p) > 0) == (b[1] > a[1]);
  }
  return inside;
}

/// The polygon around each that lies in most others itself.
std::vector<Index> around(const Corners& c) {
  const auto count = static_cast<Index>(c.starts.size() - 1);
  std::vector<std::vector<Index>> containers(count);
  for (Index l = 0; l < count; ++l)
    for (Index m = 0; m < count; ++m)
      if (m != l && is_inside(c, m, c.at[c.starts[l]])) containers[l].push_back(m);

  std::vector<Index> result(count, Nesting::none);
  for (Index l = 0; l < count; ++l)
    for (const Index m : containers[l])
      if (result[l] == Nesting::none || containers[m].size() > containers[result[l]].size()) result[l] = m;
  return result;
}

bool has_straight_corner(const Polygon& p) {
  for (std::size_t i = 0; i < p.size(); ++i)
    if (orientation(p[i], p[(i + 1) % p.size()], p[(i + 2) % p.size()]) == 0) return true;
  return false;
}

/// A square, or half of one, or any few points; it begins anywhere and turns either way.
Polygon random_polygon(std::mt19937_64& random) {
  const std::int64_t x = between(random, 0, 24), y = between(random, 0, 24), size = std::int64_t{1} << below(random, 6);
  Polygon p{{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
  if (below(random, 3) == 0) p.erase(p.begin() + static_cast<std::ptrdiff_t>(below(random, 4)));
  if (below(random, 4) == 0) {
    p.resize(3 + below(random, 3));
    for (Point& q : p) q = {x + between(random, 0, 6), y + between(random, 0, 6)};
  }
  std::rotate(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(below(random, p.size())), p.end());
  if (below(random, 2) == 0) std::reverse(p.begin(), p.end());
  return p;
}

TEST(OutlineSweepTest, AgreesWithAllPairsOfSidesAndWithRays) {
  std::mt19937_64 random = generator(612);
  int crossing = 0, nested = 0;
  for (int i = 0; i < 20000; ++i) {
    Corners c;
    for (std::uint64_t n = 1 + below(random, 5); n > 0;) {
      const Polygon p = random_polygon(random);
      if (has_straight_corner(p)) continue;
      c.add(p);
      --n;
    }

    const Nesting nesting = c.nesting();
    ASSERT_EQ(nesting.meeting != Nesting::none, has_meeting_side(c)) << i;
    if (nesting.meeting != Nesting::none) {
      ++crossing;
      bool meets = false;
      for (Index j = 0; j < c.at.size(); ++j) meets = meets || (j != nesting.meeting && meet(c, nesting.meeting, j));
      ASSERT_TRUE(meets) << i;
      continue;
    }
    const std::vector<Index> expected = around(c);
    nested += std::count(expected.begin(), expected.end(), Nesting::none) < static_cast<long>(expected.size());
    ASSERT_EQ(nesting.around, expected) << i;
  }
  EXPECT_GT(crossing, 2000);
  EXPECT_GT(nested, 500);
}

/// A star of n tips: lines across it meet a part of its sides that does not shrink.
Polygon star(std::size_t n, std::int64_t outer, std::int64_t inner) {
  Polygon p;
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const double angle = std::acos(-1.0) * static_cast<double>(i) / static_cast<double>(n);
    const auto radius = static_cast<double>(i % 2 == 0 ? outer : inner);
    p.push_back({std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))});
  }
  return p;
}

TEST(OutlineSweepTest, PredicatesGrowLikeNLogN) {
  for (const std::size_t n : {100u, 1000u, 10000u, 100000u}) {
    Corners c;
    c.add(star(n, 1 << 29, 1 << 28));
    ASSERT_EQ(c.nesting().meeting, Nesting::none);
    EXPECT_LT(c.orientations, c.at.size() * (12 + static_cast<std::size_t>(std::bit_width(c.at.size()))));
    EXPECT_LT(c.comparisons, 2 * c.at.size() * static_cast<std::size_t>(std::bit_width(c.at.size())));

    // As many polygons, side by side and in one another.
    Corners many;
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(n); ++i) {
      const std::int64_t x = 10 * (i / 5), low = i % 5, high = 9 - low;
      many.add({{x + low, low}, {x + high, low}, {x + high, high}, {x + low, high}});
    }
    const Nesting nesting = many.nesting();
    for (Index i = 0; i < n; ++i) ASSERT_EQ(nesting.around[i], i % 5 == 0 ? Nesting::none : i - 1);
    EXPECT_LT(many.orientations, many.at.size() * (12 + static_cast<std::size_t>(std::bit_width(many.at.size()))));
  }
}

}  // namespace
}  // namespace quoin::rounding::testing
