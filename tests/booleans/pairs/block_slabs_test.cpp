#include "booleans/pairs/block_slabs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "booleans/pairs/foreign_pairs.h"
#include "booleans/pairs/triangle_pair.h"
#include "tests/booleans/support.h"
#include "tests/grid/with_thresholds.h"

namespace quoin::booleans::testing {
namespace {

/// Every pair of blocks is compared by slabs and along their line.
grid::Thresholds slabs_for_all() {
  grid::Thresholds t = grid::thresholds();
  t.crowded_blocks = t.crowded_slabs = 0;
  return t;
}

/// Two planes with the line of direction `line` in common; their normals have components 0 and +-1 only, so a slab
/// around triangles in one of them has no thickness.
struct Frame {
  Vector line, in_a, in_b;
};
constexpr std::array<Frame, 4> frames{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                       {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}},
                                       {{1, 0, 1}, {0, 1, 0}, {1, 0, -1}},
                                       {{1, -1, 0}, {1, 1, 0}, {0, 0, 1}}}};

bool in_world(const Vector& p) {
  return std::all_of(p.begin(), p.end(), [](std::int64_t x) { return x >= -exact::world && x <= exact::world; });
}

/// A triangle in the plane of `line` and `across` that meets the line from the grid point tip * line on, in direction
/// `way`: the tip lies inside an edge from one end of the world to the other.
std::array<Vector, 3> strip(Random& random, const Vector& line, const Vector& across, std::int64_t tip,
                            std::int64_t way) {
  for (;;) {
    const std::int64_t along = random.between(-(1 << 21), 1 << 21), off = random.between(1 << 17, 1 << 21);
    const std::int64_t above = random.between(1, 1 << 12), below = random.between(1, 1 << 12);
    const Vector p = (tip + above * along) * line + (above * off) * across;
    const Vector q = (tip - below * along) * line - (below * off) * across;
    const Vector r = p + (way * (std::int64_t{1} << 27)) * line;
    if (in_world(p) && in_world(q) && in_world(r)) return {p, q, r};
  }
}

/// Eight strips with tips one step apart from each other.
Body strips(Random& random, const Vector& line, const Vector& across, std::int64_t first_tip, std::int64_t way) {
  std::vector<Vector> points;
  std::vector<Triangle> triangles;
  for (std::int64_t i = 0; i < BoxBlock::width; ++i) {
    const auto corner = static_cast<std::uint32_t>(points.size());
    for (const Vector& p : strip(random, line, across, first_tip + i, way)) points.push_back(p);
    triangles.push_back({corner, corner + 1, corner + 2});
  }
  return *mesh(points, triangles);
}

/// The faces of two bodies as two blocks of a tree.
struct Blocks {
  Blocks(const Body& a, const Body& b) : tree(items(a, b), BoxTree::Order::by_group) {
    for (const std::uint32_t id : tree.ids()) faces.push_back({id < BoxBlock::width ? &a : &b, id % BoxBlock::width});
  }

  static Array<BoxTree::Item> items(const Body& a, const Body& b) {
    Array<BoxTree::Item> r;
    for (const Body* body : {&a, &b})
      for (std::uint32_t t = 0; t < BoxBlock::width; ++t) {
        Box box;
        for (const exact::GridPoint& p : triangle(*body, t)) box.add(p);
        r.push_back({box, static_cast<std::uint32_t>(r.size()), body == &a ? 0u : 1u});
      }
    return r;
  }
  GridTriangle triangle_at(std::uint32_t i) const { return triangle(*faces[i].body, faces[i].face); }

  BoxTree tree;
  Array<SearchedFace> faces;
};

// A crossing's place is computed with rounding, so strips that touch in one point may seem a little apart. They never
// are told apart, and those one step further always are.
TEST(BlockSlabs, StripsThatTouchAtTheirTipsAreNotApart) {
  const grid::testing::WithThresholds thresholds(slabs_for_all());
  for (std::uint64_t number = 0; number < case_count(100); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x51AB5, number);
    const Frame& frame = frames[number % frames.size()];
    const std::int64_t tip = random.between(-exact::world / 2, exact::world / 2);
    // Strip i of a ends where strip i of b begins.
    const Body a = strips(random, frame.line, frame.in_a, tip, -1), b = strips(random, frame.line, frame.in_b, tip, 1);

    const Blocks blocks(a, b);
    BlockSlabs slabs(blocks.faces, blocks.tree);
    slabs.need(0);
    slabs.need(1);
    const LanePairs apart = slabs.apart(0, 1);
    std::size_t touching = 0;
    for (std::uint32_t i = 0; i < BoxBlock::width; ++i)
      for (std::uint32_t j = 0; j < BoxBlock::width; ++j) {
        const bool touch = meet(blocks.triangle_at(i), blocks.triangle_at(BoxBlock::width + j));
        EXPECT_EQ((apart >> (BoxBlock::width * i + j) & 1) != 0, !touch) << i << ", " << j;
        touching += touch;
      }
    EXPECT_EQ(touching, BoxBlock::width * (BoxBlock::width + 1) / 2);
  }
}

TEST(BlockSlabs, NoPairOfStripsThatTouchIsLost) {
  const grid::testing::WithThresholds thresholds(slabs_for_all());
  for (std::uint64_t number = 0; number < case_count(100); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x51AB6, number);
    const Frame& frame = frames[number % frames.size()];
    const std::int64_t tip = random.between(-exact::world / 2, exact::world / 2);
    const Body a = strips(random, frame.line, frame.in_a, tip, -1), b = strips(random, frame.line, frame.in_b, tip, 1);

    const Operands operands({&a, &b});
    std::set<FacePair> expected;
    for (std::uint32_t i = 0; i < BoxBlock::width; ++i)
      for (std::uint32_t j = 0; j < BoxBlock::width; ++j)
        if (meet(triangle(a, i), triangle(b, j))) expected.insert({FaceId{i}, FaceId{BoxBlock::width + j}});
    const auto found = foreign_pairs(operands);
    EXPECT_EQ(std::set<FacePair>(found.begin(), found.end()), expected);
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
