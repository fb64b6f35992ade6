#include "booleans/pairs/foreign_pairs.h"

#include <gtest/gtest.h>

#include <set>

#include "booleans/pairs/triangle_pair.h"
#include "tests/booleans/pairs/in_parts.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

/// Triangles in fans around a few hubs: neighbours share a plane nearly or fully, boxes overlap everywhere.
Body fans(Random& random, std::int64_t size, std::uint32_t count) {
  Body body;
  const auto point = [&] {
    exact::GridPoint p;
    for (auto& x : p.c) x = static_cast<std::int32_t>(random.between(-size, size));
    body.grid_points.push_back(p);
    return static_cast<std::uint32_t>(body.grid_points.size() - 1);
  };
  while (body.triangles.size() < count) {
    const std::uint32_t hub = point(), steps = 1 + static_cast<std::uint32_t>(random.below(40));
    const exact::GridPoint from = body.grid_points[point()], to = body.grid_points[point()];
    std::uint32_t last = none;
    for (std::uint32_t i = 0; i <= steps; ++i) {
      exact::GridPoint p;
      for (std::size_t k = 0; k < 3; ++k)
        p.c[k] = static_cast<std::int32_t>(from[k] + (std::int64_t{to[k]} - from[k]) * i / steps);
      body.grid_points.push_back(p);
      const auto v = static_cast<std::uint32_t>(body.grid_points.size() - 1);
      if (last != none && exact::plane_through(body.grid_points[hub], body.grid_points[last], p))
        body.triangles.push_back({hub, last, v});
      last = v;
    }
  }
  return body;
}

// Boxes, cells, slabs and bundles against all pairs, of which those may be missing that meet in common parts.
TEST(ForeignPairs, AreThoseThatMeet) {
  std::size_t meeting = 0;
  for (std::uint64_t number = 0; number < case_count(60); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xFA45, number);
    const std::int64_t size = random.one_in(2) ? 50 : random.one_in(2) ? 100000 : exact::world;
    std::vector<Body> bodies(2 + random.below(2) * random.below(10));
    std::vector<const Body*> list;
    for (Body& b : bodies) {
      b = fans(random, size, 300 / static_cast<std::uint32_t>(bodies.size()));
      list.push_back(&b);
    }
    const Operands operands(list);
    std::set<FacePair> expected;
    for (std::uint32_t i = 0; i < operands.face_count(); ++i)
      for (std::uint32_t j = i + 1; j < operands.face_count(); ++j) {
        const OwnFace f = operands.own(FaceId(i)), g = operands.own(FaceId(j));
        if (f.operand == g.operand) continue;
        if (meet(triangle(operands[f.operand], f.face), triangle(operands[g.operand], g.face)))
          expected.insert({FaceId(i), FaceId(j)});
      }
    const auto found = foreign_pairs(operands);
    expect_all_but_parts(found, expected, [&](FaceId f) {
      const OwnFace own = operands.own(f);
      return triangle(operands[own.operand], own.face);
    });
    const auto others =
        std::count_if(found.begin(), found.end(), [&](const FacePair& p) { return !expected.contains(p); });
    EXPECT_LE(others, operands.face_count());
    meeting += expected.size();
  }
  EXPECT_GT(meeting, 10 * case_count(60));
}

}  // namespace
}  // namespace quoin::booleans::testing
