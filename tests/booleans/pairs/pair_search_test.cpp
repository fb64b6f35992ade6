#include "booleans/pairs/pair_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "booleans/pairs/triangle_pair.h"
#include "tests/booleans/pairs/in_parts.h"
#include "tests/booleans/support.h"
#include "tests/grid/with_thresholds.h"

namespace quoin::booleans::testing {
namespace {

using grid::testing::WithThresholds;

/// The triangles of some bodies, one group each, and a tree over them. The bodies must outlive it.
struct Searched {
  explicit Searched(const std::vector<Body>& bodies) : tree(items(bodies)) {
    for (const std::uint32_t id : tree.ids()) {
      std::uint32_t body = 0, face = id;
      while (face >= bodies[body].triangles.size()) face -= static_cast<std::uint32_t>(bodies[body++].triangles.size());
      faces.push_back({&bodies[body], face});
    }
  }

  static Array<BoxTree::Item> items(const std::vector<Body>& bodies) {
    Array<BoxTree::Item> r;
    for (std::uint32_t b = 0; b < bodies.size(); ++b)
      for (std::uint32_t t = 0; t < bodies[b].triangles.size(); ++t)
        r.push_back({face_box(bodies[b], t), static_cast<std::uint32_t>(r.size()), b});
    return r;
  }
  bool meet(std::uint32_t i, std::uint32_t j) const {
    return booleans::meet(triangle(*faces[i].body, faces[i].face), triangle(*faces[j].body, faces[j].face));
  }
  bool meet_in_common_parts(const FacePair& p) const {
    const auto at = [&](FaceId id) {
      const auto& [body, face] = faces[std::find(tree.ids().begin(), tree.ids().end(), id.value) - tree.ids().begin()];
      return triangle(*body, face);
    };
    return testing::meet_in_common_parts(at(p[0]), at(p[1]));
  }
  /// Any pairs of places.
  static bool is_skipped(std::uint32_t i, std::uint32_t j) { return (i + j) % 3 == 0; }

  template <class Skip>
  FacePairs found(BoxTree::Pairs pairs, InParts in_parts, Skip skip) const {
    const auto wanted = [&](std::uint32_t i, std::uint32_t j) { return meet(i, j); };
    return PairSearch(faces, tree, in_parts, skip, wanted).run(pairs);
  }
  FacePairs found(BoxTree::Pairs pairs, InParts in_parts) const {
    return found(pairs, in_parts, [](std::uint32_t i, std::uint32_t block) {
      unsigned lanes = 0;
      for (std::uint32_t j = 0; j < BoxBlock::width; ++j)
        lanes |= static_cast<unsigned>(is_skipped(i, BoxBlock::width * block + j)) << j;
      return lanes;
    });
  }
  /// The same, without order.
  FacePairs by_all(BoxTree::Pairs pairs) const {
    FacePairs r;
    for (std::uint32_t i = 0; i < faces.size(); ++i)
      for (std::uint32_t j = i + 1; j < faces.size(); ++j) {
        if (is_skipped(i, j) || (pairs == BoxTree::Pairs::foreign && faces[i].body == faces[j].body)) continue;
        const std::uint32_t a = tree.ids()[i], b = tree.ids()[j];
        if (meet(i, j)) r.push_back({FaceId(std::min(a, b)), FaceId(std::max(a, b))});
      }
    std::sort(r.begin(), r.end());
    return r;
  }

  BoxTree tree;
  Array<SearchedFace> faces;
};

// In one batch or in many, with slabs of all blocks or of none: in one order, and what all pairs say, but for pairs
// that meet in common parts.
TEST(PairSearch, FindsWhatMeetsAndIsNotSkipped) {
  std::size_t meeting = 0;
  for (std::uint64_t number = 0; number < case_count(60); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x9A12, number);
    Solids solids(random, families[number % families.size()]);
    std::vector<Body> bodies;
    for (int i = 0; i < 5; ++i) bodies.push_back(solids.raw());
    const Searched searched(bodies);

    for (const BoxTree::Pairs pairs : {BoxTree::Pairs::all, BoxTree::Pairs::foreign}) {
      const FacePairs expected = searched.by_all(pairs);
      meeting += expected.size();
      for (const int crowded : {0, 64}) {
        FacePairs first;
        for (const std::size_t stretch : {std::size_t{2}, std::size_t{1} << 15}) {
          grid::Thresholds t = grid::thresholds();
          t.stretch = stretch;
          t.crowded_blocks = t.crowded_slabs = t.crowded_nodes = crowded;
          const WithThresholds set(t);
          const FacePairs found = searched.found(pairs, InParts::passed);
          if (first.empty()) first = found;
          EXPECT_EQ(found, first);
        }
        std::sort(first.begin(), first.end());
        if (crowded == 64) {
          EXPECT_EQ(first, expected);
        }
        EXPECT_TRUE(std::includes(expected.begin(), expected.end(), first.begin(), first.end()));
        for (const FacePair& p : expected)
          EXPECT_TRUE(std::binary_search(first.begin(), first.end(), p) || searched.meet_in_common_parts(p));
      }
    }
  }
  EXPECT_GT(meeting, 50 * case_count(60));
}

// Small triangles of several solids on one plane, of which nodes of all levels are passed over: each that meets a
// foreign one has a pair.
TEST(PairSearch, AllThatMeetOnOnePlaneAreNamed) {
  for (std::uint64_t number = 0; number < case_count(200); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x9A13, number);
    std::vector<Body> bodies(2 + random.below(2));
    const std::int64_t size = random.between(20, 60);
    for (Body& body : bodies)
      for (std::uint64_t left = 60 + random.below(120); left > 0; --left) {
        const auto x = static_cast<std::int32_t>(random.between(0, size)),
                   y = static_cast<std::int32_t>(random.between(0, size));
        const auto first = static_cast<std::uint32_t>(body.grid_points.size());
        for (const exact::GridPoint& p : {exact::GridPoint{{x, y, 0}}, {{x + 1, y, 0}}, {{x, y + 1, 0}}})
          body.grid_points.push_back(p);
        body.triangles.push_back({first, first + 1, first + 2});
      }
    const Searched searched(bodies);

    grid::Thresholds t = grid::thresholds();
    t.crowded_blocks = t.crowded_nodes = 0;
    t.stretch = 1;  // blocks are looked at before the next nodes are
    const WithThresholds set(t);
    std::set<std::uint32_t> named;
    for (const FacePair& p : searched.found(BoxTree::Pairs::foreign, InParts::one_each, skip_nothing))
      named.insert({p[0].value, p[1].value});
    for (std::uint32_t i = 0; i < searched.faces.size(); ++i)
      for (std::uint32_t j = i + 1; j < searched.faces.size(); ++j) {
        const bool near = searched.tree.box(i).meets(searched.tree.box(j));
        if (!near || searched.faces[i].body == searched.faces[j].body || !searched.meet(i, j)) continue;
        EXPECT_TRUE(named.contains(searched.tree.ids()[i]) && named.contains(searched.tree.ids()[j]));
      }
  }
}

TEST(PairSearch, FindsNothingAmongNothing) {
  const std::vector<Body> bodies;
  EXPECT_EQ(Searched(bodies).found(BoxTree::Pairs::all, InParts::passed), FacePairs{});
}

}  // namespace
}  // namespace quoin::booleans::testing
