#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "booleans/assemble/assemble.h"
#include "tests/booleans/assemble/making.h"

namespace quoin::booleans::testing {
namespace {

Box cube(std::int32_t low, std::int32_t high) { return {{low, low, low}, {high, high, high}}; }

// Faces that follow each other, near each other and few, are one chunk.
TEST(Host, KeptChunks) {
  const WithThresholds usual{grid::Thresholds{}};
  Array<Chunk> chunks;
  keep_chunk(chunks, 0, 10, cube(0, 2));
  keep_chunk(chunks, 10, 10, cube(0, 9));  // no face
  keep_chunk(chunks, 10, 32, cube(2, 4));  // touches the one before
  keep_chunk(chunks, 32, 33, cube(2, 3));  // one more than a chunk has
  keep_chunk(chunks, 34, 35, cube(2, 3));  // a face is left out
  keep_chunk(chunks, 35, 36, cube(7, 8));  // far from the one before

  Array<std::array<std::uint32_t, 2>> faces;
  for (const Chunk& c : chunks) faces.push_back({c.begin, c.end});
  EXPECT_EQ(faces, (Array<std::array<std::uint32_t, 2>>{{0, 32}, {32, 33}, {34, 35}, {35, 36}}));
  EXPECT_EQ(chunks[0].box.low, cube(0, 4).low);
  EXPECT_EQ(chunks[0].box.high, cube(0, 4).high);
}

// A body that lists some of 5 triangles and 25 corners, some of which are gone, and some vertices.
TEST(Host, WasteOfPatchedBodies) {
  const WithThresholds usual{grid::Thresholds{}};
  const auto waste_of = [](std::uint32_t live, std::size_t gone_corners, int vertices) {
    Body body;
    for (int i = 0; i < 5; ++i) body.triangles.push_back({0, 1, 2});
    for (std::uint32_t i = 0; i < 25; ++i) body.polygons.corners.push_back(i);
    for (int i = 0; i < vertices; ++i) body.grid_points.push_back({{i, 0, 0}});
    body.chunks = {{0, live, Box{}}};
    body.gone_corners = gone_corners;
    return waste(body);
  };
  EXPECT_EQ(waste_of(5, 0, 3), Waste::little);
  EXPECT_EQ(waste_of(4, 0, 3), Waste::little) << "one face gone for four";
  EXPECT_EQ(waste_of(3, 0, 3), Waste::much);
  EXPECT_EQ(waste_of(5, 20, 3), Waste::little) << "of 40 corners half are gone";
  EXPECT_EQ(waste_of(5, 21, 3), Waste::loops);
  EXPECT_EQ(waste_of(5, 10, 20), Waste::little) << "20 vertices with 30 corners";
  EXPECT_EQ(waste_of(5, 10, 21), Waste::much);
}

// Loops that are gone leave the lists; all else keeps its numbers.
TEST(Host, DroppedLoops) {
  Body body;
  body.triangles.push_back({0, 1, 2});
  for (std::uint32_t i = 0; i < 4; ++i) {
    body.polygons.add_loop(Array<std::uint32_t>{10 * i, 10 * i + 1, 10 * i + 2});
    if (i == 2) body.polygons.add_loop(Array<std::uint32_t>{25, 26, 27, 28});
    body.polygons.end_face();
    body.planes.push_back({{1, 0, 0}, i});
  }
  body.is_packed = false;
  body.chunks = {{0, 1, Box{}}, {2, 4, Box{}}};  // polygons 1 and 2
  body.gone_corners = 6;

  drop_gone_loops(body);
  EXPECT_EQ(body.gone_corners, 0u);
  EXPECT_EQ(body.planes.size(), 4u);
  const Array<std::uint32_t> corners(body.polygons.corners.begin(), body.polygons.corners.end());
  EXPECT_EQ(corners, (Array<std::uint32_t>{10, 11, 12, 20, 21, 22, 25, 26, 27, 28}));
  for (std::uint32_t p = 0; p < 4; ++p) EXPECT_EQ(body.polygons.loop_count(p), (std::array{0u, 1u, 2u, 0u})[p]);
  EXPECT_EQ(body.polygons.loop(body.polygons.face_start[2])[0], 20u);
}

// A large ball and a small block at its surface, or far from it: a host keeps what is far, as it is.
TEST(Host, IsALargeOperandThatStays) {
  const WithThresholds usual{grid::Thresholds{}};
  const Body ball = *sphere({0, 0, 0}, 24, 48, [](std::uint32_t, std::uint32_t) { return 1e4; });
  const Body near = box({-500, -500, 9500}, {500, 500, 10500}), far = box({50000, 0, 0}, {50001, 1, 1});
  const auto host = [](const Array<Body>& bodies, const Expression& e) {
    const Arrangement a = arranged(bodies);
    return find_host(a, select(a, find_cells(a), e));
  };
  for (const Rule rule : {Rule::any, Rule::odd}) {
    EXPECT_EQ(host({ball, near}, Expression::flat(rule, 2)), OperandId(0));
    EXPECT_EQ(host({near, ball}, Expression::flat(rule, 2)), OperandId(1));
    EXPECT_EQ(host({far, ball}, Expression::flat(rule, 2)), OperandId(1));
  }
  EXPECT_EQ(host({ball, near}, Expression::flat(Rule::all, 2, 1)), OperandId(0)) << "less the block";
  EXPECT_EQ(host({complement(ball), near}, Expression::flat(Rule::any, 2)), OperandId(0)) << "full at infinity";

  EXPECT_EQ(host({ball, near}, Expression::flat(Rule::all, 2)), OperandId(none)) << "nothing far stays";
  EXPECT_EQ(host({near, ball}, Expression::flat(Rule::any, 2, 1)), OperandId(none)) << "it stays turned round";
  EXPECT_EQ(host({ball, *moved(ball, {5000, 0, 0})}, Expression::flat(Rule::any, 2)), OperandId(none)) << "too much";
  EXPECT_EQ(host({near, near}, Expression::flat(Rule::any, 2)), OperandId(none)) << "nothing is far";
}

/// An operand of so many times the faces of the others is a host, if a single face of it is far; nothing is ever
/// packed.
grid::Thresholds with_host(std::size_t host) {
  grid::Thresholds t = grid::thresholds();
  t.chunk = 1;
  t.few_operands = 64;
  t.host = host;
  t.live_per_gone = 0;
  return t;
}

/// Boxes of chunks hold their faces, and what no chunk has is counted.
void expect_consistent(const Body& patched) {
  std::size_t corners = 0;
  for (const Chunk& c : patched.chunks)
    for (std::uint32_t f = c.begin; f < c.end; ++f) {
      Box all = c.box;
      all.add(face_box(patched, f));
      EXPECT_EQ(all.low, c.box.low);
      EXPECT_EQ(all.high, c.box.high);
      corners += f < patched.triangles.size() ? 0 : patched.corner_count(f);
    }
  EXPECT_EQ(corners + patched.gone_corners, patched.polygons.corners.size());
}

// Chains whose results share lists wherever they can, against chains whose results share none: loops, holes and derived
// points come and go.
TEST(Host, ResultsThatShareListsAreThoseThatShareNone) {
  std::size_t patched = 0;
  for_families(0x4057, 12, [&](Solids& solids, Random& random) {
    const grid::Thresholds sharing = with_host(0), copying = with_host(1 << 30);
    Body shared = solids.next(), copied = shared;
    for (int step = 0; step < 5; ++step) {
      const Body tool = random.one_in(3) ? odd(solids.raw(), solids.raw()) : solids.raw(), before = shared;
      const Canonical form = canonical(before);
      const std::uint64_t way = random.below(4);
      const auto next = [&](const Body& body, const grid::Thresholds& t) {
        const WithThresholds set(t);
        return way == 0 ? any(body, tool) : way == 1 ? minus(body, tool) : way == 2 ? odd(body, tool) : odd(tool, body);
      };
      shared = next(shared, sharing);
      copied = next(copied, copying);

      ASSERT_TRUE(canonical(shared) == canonical(copied));
      EXPECT_TRUE(canonical(before) == form) << "who lends sees nothing of it";
      if (shared.is_packed) continue;
      ++patched;
      expect_consistent(shared);
    }
  });
  if (exact::checked) {
    EXPECT_GT(patched, 20 * case_count(12));
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
