// The slow second way: results cell by cell and point by point, against code that shares nothing with the engine.
#include <gtest/gtest.h>

#include "booleans/body/locate.h"
#include "booleans/resolve.h"
#include "booleans/surface/triangulated.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;
using RationalPoint = std::array<Rational, 3>;

RationalPoint operator-(const RationalPoint& a, const RationalPoint& b) {
  return {Rational(a[0] - b[0]), Rational(a[1] - b[1]), Rational(a[2] - b[2])};
}
Rational determinant(const RationalPoint& u, const RationalPoint& v, const RationalPoint& w) {
  return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}
int sign(const Rational& v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

/// Winding numbers of a closed triangle soup, by rays in random rational directions.
class Soup {
 public:
  explicit Soup(const Body& body) : at_infinity_(body.full_at_infinity ? 1 : 0) {
    const Triangulated mesh = triangulated(body);
    for (std::size_t n = 0; n < mesh.triangle_count(); ++n) {
      const auto t = mesh.triangle(n);
      std::array<RationalPoint, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        const exact::Point p = body.point(mesh.source[t[i]]);
        for (int k = 0; k < 3; ++k) corners[i][static_cast<std::size_t>(k)] = exact::coordinate(p, k);
      }
      triangles_.push_back(corners);
    }
  }

  /// Nothing on the surface.
  std::optional<int> winding(const RationalPoint& p, Random& random) const {
    for (const auto& t : triangles_)
      if (contains(t, p)) return std::nullopt;
    for (;;) {
      RationalPoint direction;
      for (Rational& x : direction) x = Rational(random.between(-1000, 1000), random.between(1, 1000));
      if (const auto w = along(p, direction)) return w;
    }
  }

  const std::vector<std::array<RationalPoint, 3>>& triangles() const { return triangles_; }

 private:
  /// The closed triangle contains the point: flat with it, and on no edge's outer side.
  static bool contains(const std::array<RationalPoint, 3>& t, const RationalPoint& p) {
    const RationalPoint u = t[1] - t[0], v = t[2] - t[0], w = p - t[0];
    if (determinant(u, v, w) != 0) return false;
    // Any vector off the plane serves as its normal.
    RationalPoint normal{Rational(u[1] * v[2] - u[2] * v[1]), Rational(u[2] * v[0] - u[0] * v[2]),
                         Rational(u[0] * v[1] - u[1] * v[0])};
    for (std::size_t i = 0; i < 3; ++i)
      if (determinant(t[(i + 1) % 3] - t[i], p - t[i], normal) < 0) return false;
    return true;
  }

  /// Nothing when the ray's line touches an edge.
  std::optional<int> along(const RationalPoint& p, const RationalPoint& direction) const {
    int winding = at_infinity_;
    for (const auto& t : triangles_) {
      const std::array<RationalPoint, 3> c{t[0] - p, t[1] - p, t[2] - p};
      std::array<int, 3> s{};
      for (std::size_t i = 0; i < 3; ++i) s[i] = sign(determinant(c[i], c[(i + 1) % 3], direction));
      const bool positive = s[0] > 0 || s[1] > 0 || s[2] > 0, negative = s[0] < 0 || s[1] < 0 || s[2] < 0;
      if (positive && negative) continue;
      if (s[0] == 0 || s[1] == 0 || s[2] == 0) return std::nullopt;
      // The line meets the triangle at p + direction * (height / rate); rate has the sign of s.
      const int height = sign(determinant(c[0], c[1], c[2]));
      if (height == s[0]) winding += s[0];
    }
    return winding;
  }

  std::vector<std::array<RationalPoint, 3>> triangles_;
  int at_infinity_;
};

/// Points at random, and within tiny rational distances of vertices, edges and faces.
std::vector<RationalPoint> samples(const std::vector<Soup>& soups, Random& random) {
  std::vector<RationalPoint> points;
  const auto jitter = [&](RationalPoint p) {
    static constexpr std::array<std::int64_t, 4> divisors{1, 3, 1000, 1'000'000'000'007};
    const std::int64_t divisor = divisors[random.below(divisors.size())];
    for (Rational& x : p) x += Rational(random.between(-1, 1), divisor);
    return p;
  };
  for (const Soup& soup : soups) {
    if (soup.triangles().empty()) continue;
    for (int i = 0; i < 6; ++i) {
      const auto& t = soup.triangles()[random.below(soup.triangles().size())];
      const auto& s = soup.triangles()[random.below(soup.triangles().size())];
      points.push_back(jitter(t[0]));
      // Inside an edge, inside a face, and between two faces.
      const Rational a(random.between(1, 6), 7), b(random.between(1, 6), 7);
      RationalPoint on_edge, on_face, between;
      for (std::size_t k = 0; k < 3; ++k) {
        on_edge[k] = t[0][k] + a * (t[1][k] - t[0][k]);
        on_face[k] = on_edge[k] + b * (t[2][k] - on_edge[k]);
        between[k] = on_face[k] + a * (s[1][k] - on_face[k]);
      }
      points.push_back(jitter(on_edge));
      points.push_back(jitter(on_face));
      points.push_back(between);
      points.push_back(on_face);
    }
  }
  return points;
}

TEST(Cells, PointsOfRandomSolids) {
  for (const Family family : families) {
    for (std::uint64_t i = 0; i < (family == Family::spheres ? 4u : 25u); ++i) {
      SCOPED_TRACE(std::string(name_of(family)) + ", " + case_name(i));
      Random random(100 + static_cast<std::uint64_t>(family), i);
      Solids solids(random, family);
      std::vector<Body> operands;
      for (std::uint64_t n = 2 + random.below(2); n > 0; --n)
        operands.push_back(random.one_in(6) ? complement(solids.next()) : solids.next());
      const Expression e = random_expression(random, operands.size(), 2);
      const Body result = evaluated(operands, e);
      std::vector<Soup> soups;
      for (const Body& b : operands) soups.emplace_back(b);
      soups.emplace_back(result);
      for (const RationalPoint& p : samples(soups, random)) {
        std::vector<bool> inside;
        bool on_an_operand = false;
        for (std::size_t o = 0; o < operands.size(); ++o) {
          const auto w = soups[o].winding(p, random);
          if (w) {
            ASSERT_TRUE(*w == 0 || *w == 1);
          }
          ASSERT_EQ(locate(operands[o], p), w ? 2 * *w - 1 : 0);
          on_an_operand = on_an_operand || !w;
          inside.push_back(w == 1);
        }
        const auto w = soups.back().winding(p, random);
        ASSERT_EQ(locate(result, p), w ? 2 * *w - 1 : 0);
        if (w) {
          ASSERT_TRUE(*w == 0 || *w == 1);
        } else {
          ASSERT_TRUE(on_an_operand);
        }
        if (!on_an_operand) {
          ASSERT_EQ(*w == 1, holds(e, [&](std::uint32_t o) { return inside[o]; }));
        }
      }
    }
  }
}

/// Boxes on a grid of `size` cells a side, and the expression's value in every cell.
TEST(Cells, BoxSoupsCellByCell) {
  constexpr std::int64_t size = 4;
  for (std::uint64_t i = 0; i < 150; ++i) {
    SCOPED_TRACE(case_name(i));
    Random random(110, i);
    std::vector<Body> operands;
    std::vector<std::array<Vector, 2>> corners;
    for (std::uint64_t n = 2 + random.below(6); n > 0; --n) {
      Vector low{}, high{};
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = random.between(0, size - 1);
        high[k] = random.between(low[k] + 1, size);
      }
      operands.push_back(box(low, high));
      corners.push_back({low, high});
    }
    const Expression e = random_expression(random, operands.size(), 3);
    const Body result = evaluated(operands, e);

    // A margin of one cell all round shows what is beyond.
    const auto filled = [&](const Vector& cell) {
      return holds(e, [&](std::uint32_t o) {
        for (std::size_t k = 0; k < 3; ++k)
          if (cell[k] < corners[o][0][k] || cell[k] >= corners[o][1][k]) return false;
        return true;
      });
    };
    const bool outside = filled({-1, -1, -1});
    ASSERT_EQ(result.full_at_infinity, outside);
    std::int64_t squares = 0, cells = 0;
    std::vector<Body> cubes;
    for (std::int64_t x = -1; x <= size; ++x)
      for (std::int64_t y = -1; y <= size; ++y)
        for (std::int64_t z = -1; z <= size; ++z) {
          const Vector cell{x, y, z};
          const bool here = filled(cell);
          ASSERT_EQ(locate(result, {Rational(2 * x + 1, 2), Rational(2 * y + 1, 2), Rational(2 * z + 1, 2)}),
                    here ? 1 : -1);
          cells += here != outside;
          if (here != outside) cubes.push_back(box(cell, cell + Vector{1, 1, 1}));
          for (std::size_t k = 0; k < 3; ++k) {
            Vector next = cell;
            ++next[k];
            squares += next[k] <= size && filled(next) != here;
          }
        }
    EXPECT_EQ(volume(result), Rational(outside ? -cells : cells));
    EXPECT_EQ(approximate_area(result), static_cast<double>(squares));
    // The same set as the union of its cells.
    Body sum;
    if (!cubes.empty()) sum = evaluated(cubes, Expression::flat(Rule::any, static_cast<std::uint32_t>(cubes.size())));
    EXPECT_TRUE(same(outside ? complement(sum) : sum, result));
  }
}

// A grid of cubes grown one by one and taken away one by one.
TEST(Cells, CubeGridOneByOne) {
  constexpr std::int64_t side = 3;
  Body solid;
  std::vector<Vector> order;
  for (std::int64_t x = 0; x < side; ++x)
    for (std::int64_t y = 0; y < side; ++y)
      for (std::int64_t z = 0; z < side; ++z) order.push_back({x, y, z});
  Random random(120, 0);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  const auto cube = [](const Vector& v) { return box(v, v + Vector{1, 1, 1}); };
  std::int64_t count = 0;
  for (const Vector& v : order) {
    solid = any(solid, cube(v));
    ASSERT_EQ(volume(solid), ++count);
  }
  ASSERT_TRUE(same(solid, box({0, 0, 0}, {side, side, side})));
  for (const Vector& v : order) {
    solid = minus(solid, cube(v));
    ASSERT_EQ(volume(solid), --count);
  }
  ASSERT_TRUE(empty(solid));
}

// Flat regions of many edges that cover their plane more than once, against winding numbers by rays; the state of a
// region where a contact begins is a count, not a flag.
TEST(Cells, FoldedSheetsUnderACone) {
  std::size_t many = 0;
  for (std::uint64_t number = 0; number < case_count(40); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xF01D, number);
    const auto n = static_cast<std::uint32_t>(random.between(2, 8));
    const auto mesh = folded_sheet([&](std::int64_t low, std::int64_t high) { return random.between(low, high); }, n,
                                   random.between(2, 12));
    if (!mesh) continue;
    std::uint64_t crossings = 0;
    const Body body = sound(resolve(*mesh, crossings));
    const Soup soup(*mesh);
    for (const RationalPoint& p : samples({soup}, random)) {
      const auto w = soup.winding(p, random);
      if (!w) continue;
      ASSERT_EQ(locate(body, p), *w > 0 ? 1 : -1);
      many += *w > 1;
    }
  }
  EXPECT_GT(many, 0u);
}

}  // namespace
}  // namespace quoin::booleans::testing
