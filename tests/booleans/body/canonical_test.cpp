#include "booleans/body/canonical.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

/// The same faces as a body of other numbers: vertices, faces, loops and corners in another order.
Body shuffled(const Body& body, Random& random) {
  Boundary boundary = canonical(body);
  const auto order = [&](std::size_t n) {
    std::vector<std::uint32_t> r(n);
    for (std::uint32_t i = 0; i < n; ++i) r[i] = i;
    for (std::size_t i = n; i > 1; --i) std::swap(r[i - 1], r[random.below(i)]);
    return r;
  };

  Boundary r;
  r.full_at_infinity = boundary.full_at_infinity;
  const auto place = order(boundary.vertices.size());
  r.vertices.resize(place.size());
  for (std::size_t v = 0; v < place.size(); ++v) r.vertices[place[v]] = boundary.vertices[v];
  for (const std::uint32_t f : order(boundary.face_count())) {
    r.planes.push_back(boundary.planes[f]);
    for (const std::uint32_t l : order(boundary.faces.loop_count(f))) {
      const auto loop = boundary.faces.loop(boundary.faces.face_start[f] + l);
      const std::size_t start = random.below(loop.size());
      for (std::size_t i = 0; i < loop.size(); ++i) r.faces.corners.push_back(place[loop[(start + i) % loop.size()]]);
      r.faces.end_loop();
    }
    r.faces.end_face();
  }
  return body_of(r);
}

// A form does not depend on the numbers of a body, and is its own.
TEST(Canonical, DoesNotDependOnOrder) {
  for (std::uint64_t number = 0; number < case_count(150); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xCA0, number);
    Solids solids(random, families[number % families.size()]);
    const Body body = odd(solids.next(), solids.next());
    const Canonical form = canonical(body);
    EXPECT_TRUE(canonical(shuffled(body, random)) == form);
    EXPECT_TRUE(canonical(body_of(form)) == form);
    const CanonicalCounts counts = canonical_counts(body);
    EXPECT_EQ(counts.vertices, form.vertices.size());
    EXPECT_EQ(counts.edges, edge_count(form));
    EXPECT_EQ(counts.faces, form.face_count());
  }
}

/// The second way to vertices and edges: the directions in which the tangent cone is invariant at a vertex are those of
/// all planes at it, as faces of one plane on both sides are one face here.
TEST(Canonical, VerticesLieOnThreePlanes) {
  for (std::uint64_t number = 0; number < case_count(100); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xCA1, number);
    Solids solids(random, families[number % families.size()]);
    const Canonical form = canonical(odd(solids.next(), solids.next()));

    std::vector<std::vector<std::uint32_t>> faces_at(form.vertices.size());
    std::map<std::array<std::uint32_t, 2>, std::vector<std::uint32_t>> faces_along;
    for (std::uint32_t f = 0; f < form.face_count(); ++f) {
      for (const std::uint32_t v : form.faces.corners_of(f)) faces_at[v].push_back(f);
      form.faces.for_edges(f, [&](std::uint32_t u, std::uint32_t v) {
        faces_along[{std::min(u, v), std::max(u, v)}].push_back(f);
      });
    }
    const auto& planes = form.planes;
    for (const auto& faces : faces_at) {
      bool three = false;
      for (std::size_t i = 0; i < faces.size() && !three; ++i)
        for (std::size_t j = i + 1; j < faces.size() && !three; ++j)
          for (std::size_t k = j + 1; k < faces.size() && !three; ++k)
            three = exact::turn(planes[faces[i]], planes[faces[j]], planes[faces[k]]) != 0;
      EXPECT_TRUE(three);
    }
    for (const auto& [edge, faces] : faces_along) {
      EXPECT_EQ(faces.size() % 2, 0u);
      EXPECT_FALSE(exact::parallel(planes[faces.front()], planes[faces.back()]) && faces.size() == 2);
    }
    EXPECT_EQ(edge_count(form), faces_along.size());
  }
}

TEST(Canonical, AFlatFanIsOneFace) {
  const std::array<std::array<std::int64_t, 2>, 5> pentagon{{{0, 0}, {4, 0}, {6, 3}, {3, 6}, {0, 4}}};
  const Canonical form = canonical(extruded(pentagon, 0, 2));
  EXPECT_EQ(form.face_count(), 7u);
  EXPECT_EQ(form.vertices.size(), 10u);
  EXPECT_EQ(edge_count(form), 15u);
}

// Two holes that touch in the least corner of both: their loop passes it twice, and begins with its smaller half-edge
// there.
TEST(Canonical, ALoopThatPassesItsLeastVertexTwice) {
  const auto hole = [](std::int64_t low, std::int64_t high) {
    return *prism({0, 0, 0}, {3, low, 0}, {3, high, 0}, {0, 0, 1});
  };
  const Body plate = minus(minus(box({-2, -4, 0}, {6, 4, 1}), hole(1, 2)), hole(-2, -1));
  const Canonical form = canonical(plate);
  std::size_t pinched = 0;
  for (std::size_t f = 0; f < form.face_count(); ++f) {
    if (form.planes[f].n[2] == 0) continue;
    ASSERT_EQ(form.faces.loop_count(f), 2u);
    const auto loop = form.faces.loop(form.faces.face_start[f] + 1);
    ASSERT_EQ(loop.size(), 6u);
    EXPECT_EQ(loop[0], loop[3]);
    EXPECT_LT(loop[1], loop[4]);
    ++pinched;
  }
  EXPECT_EQ(pinched, 2u);

  Random random(0xCA2, 0);
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(canonical(shuffled(plate, random)) == form);
}

// Two square holes that touch in a corner are one loop: going round it one stays on the boundary of the face.
TEST(Canonical, HolesThatTouchAreOneLoop) {
  const Body plate = minus(minus(box({0, 0, 0}, {6, 6, 1}), box({1, 1, 0}, {3, 3, 1})), box({3, 3, 0}, {5, 5, 1}));
  const Canonical form = canonical(plate);
  std::size_t pinched = 0;
  for (std::size_t f = 0; f < form.face_count(); ++f) {
    if (form.planes[f].n[2] == 0) continue;
    ASSERT_EQ(form.faces.loop_count(f), 2u);
    EXPECT_EQ(form.faces.loop(form.faces.face_start[f] + 1).size(), 8u);
    ++pinched;
  }
  EXPECT_EQ(pinched, 2u);
}

}  // namespace
}  // namespace quoin::booleans::testing
