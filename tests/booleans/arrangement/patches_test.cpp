#include "booleans/arrangement/patches.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "booleans/body/locate.h"
#include "grid/lists/partition.h"
#include "tests/booleans/stages.h"

namespace quoin::booleans::testing {
namespace {

/// "patch n of operand o: its faces, by their own numbers", then the crowded edges.
std::vector<std::string> text_of(const Operands& operands, const Patches& patches) {
  std::vector<std::string> text(patches.operand_of.size());
  for (std::uint32_t i = 0; i < text.size(); ++i)
    text[i] = "patch " + std::to_string(patches.first.value + i) + " of operand " +
              std::to_string(patches.operand_of[i].value) + ":";
  for (const OperandChunk& c : operands.chunks)
    for (const FaceId f : Ids<FaceId>(c.begin, c.end))
      if (const NodeId n = patches.of[f]; n != none)
        text[n.value - patches.first.value] += " " + std::to_string(operands.own(f).face);
  for (const OperandId o : operands.ids())
    for (const CrowdedEdge& e : patches.crowded[o])
      text.push_back("crowded " + std::to_string(e.from) + " -> " + std::to_string(e.to) + " of face " +
                     std::to_string(operands.own(e.face).face));
  return text;
}

// The faces of each cube that the other does not meet hang together at a corner: one patch each, behind the facets.
TEST(Patches, OneForTheRestOfACube) {
  const std::vector<Body> bodies{box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})};
  const Arrangement a = arranged(bodies);
  EXPECT_EQ(text_of(a.operands, a.patches()), (std::vector<std::string>{
                                                  "patch 12 of operand 0: 0 1 4 5 8 9",
                                                  "patch 13 of operand 1: 2 3 6 7 10 11",
                                              }));
}

/// The patches of one body of which nothing is touched.
std::vector<std::string> untouched(const Body& body, bool clean) {
  const Operands operands({&body}, clean);
  Names names;
  const Touched touched = collect_touched(operands, {}, names);
  return text_of(operands, glue(operands, touched, draw_sheets(touched, {}, names)));
}

// Tetrahedra that share an edge: clean ones are glued over vertices. Of a mesh that is to be resolved only edges of two
// faces glue, and the edge of four is crowded, once for each face.
TEST(Patches, TetrahedraThatShareAnEdge) {
  const std::vector<Body> parts{*tetrahedron({{{0, 0, 0}, {0, 0, 2}, {2, 0, 0}, {0, 2, 0}}}),
                                *tetrahedron({{{0, 0, 0}, {0, 0, 2}, {-2, 0, 0}, {0, -2, 0}}})};
  const Body body = merged(parts);
  EXPECT_EQ(untouched(body, true), (std::vector<std::string>{"patch 0 of operand 0: 0 1 2 3 4 5 6 7"}));
  EXPECT_EQ(untouched(body, false), (std::vector<std::string>{
                                        "patch 0 of operand 0: 0 1 2 3",
                                        "patch 1 of operand 0: 4 5 6 7",
                                        "crowded 1 -> 0 of face 0",
                                        "crowded 0 -> 1 of face 1",
                                        "crowded 1 -> 0 of face 4",
                                        "crowded 0 -> 1 of face 5",
                                    }));
}

/// What the patches of clean operands have to be: faces are in one patch when they share a vertex, or are both far. The
/// far patch is there even where touched faces reach so far that it has no face.
void expect_glued(const Arrangement& a) {
  std::set<NodeId> seen;
  for (const OperandId o : a.operands.ids()) {
    const Body& body = a.operands[o];
    const auto far_face = static_cast<std::uint32_t>(body.face_count());
    grid::Partition together(body.face_count() + 1);
    std::vector<std::uint32_t> face_at(body.vertex_count(), none), untouched;
    bool any_far = false;
    for (const OperandChunk& c : a.operands.chunks_of(o)) {
      any_far = any_far || c.far;
      for (const FaceId f : Ids<FaceId>(c.begin, c.end)) {
        ASSERT_EQ(a.patches().of[f] == none, a.touched.is_touched(f));
        if (a.touched.is_touched(f)) continue;
        const std::uint32_t own = a.operands.own(o, f);
        untouched.push_back(own);
        if (c.far) together.unite(own, far_face);
        for (const std::uint32_t v : body.corners_of(own)) {
          if (face_at[v] == none) face_at[v] = own;
          together.unite(own, face_at[v]);
        }
      }
    }

    std::map<std::uint32_t, NodeId> patch_of;  // by root
    if (any_far) patch_of[together.find(far_face)] = a.patches().far[o];
    for (const std::uint32_t f : untouched) {
      const NodeId n = a.patches().of[a.operands.face(o, f)];
      ASSERT_EQ(a.patches().operand(n), o);
      ASSERT_EQ(patch_of.try_emplace(together.find(f), n).first->second, n);
    }
    for (const auto& [root, n] : patch_of) ASSERT_TRUE(seen.insert(n).second);
    ASSERT_EQ(a.patches().far[o] != none, any_far);
  }
  ASSERT_EQ(seen.size(), a.patches().operand_of.size());
}

/// Of what is near a patch each other operand has all or nothing; near a far one, as at infinity.
void expect_labels(const Arrangement& a) {
  std::map<std::pair<NodeId, OperandId>, int> inside;
  a.for_untouched([&](FaceId f, NodeId n) {
    const OwnFace own = a.operands.own(f);
    const Body& body = a.operands[own.operand];
    const exact::Point p = body.point(body.corners_of(own.face)[0]);
    const std::array<exact::Rational, 3> at{exact::coordinate(p, 0), exact::coordinate(p, 1), exact::coordinate(p, 2)};
    for (const OperandId o : a.operands.ids()) {
      if (o == own.operand) continue;
      const int here = locate(a.operands[o], at);
      ASSERT_NE(here, 0);
      ASSERT_EQ(inside.try_emplace({n, o}, here).first->second, here);
      if (a.patches().far[own.operand] == n) {
        ASSERT_EQ(here, a.operands[o].full_at_infinity ? 1 : -1);
      }
    }
  });
}

// Chunks of one face, so that some are far; shells of one operand, within and beside the others.
TEST(Patches, HangTogetherOverVerticesAndLookAtOneRegion) {
  std::size_t patches = 0, far = 0;
  for_families(0x9A7C, 12, [&](Solids& solids, Random& random) {
    grid::Thresholds thresholds = grid::thresholds();
    if (random.one_in(2)) {
      thresholds.chunk = 1;
      thresholds.few_operands = 8;
    }
    const WithThresholds with_thresholds(thresholds);
    const Body first = solids.next(), second = solids.next();
    std::vector<Body> bodies{odd(first, second), solids.next(), solids.next()};
    if (random.one_in(3)) bodies[2] = complement(bodies[2]);
    const Arrangement a = arranged(bodies);
    ASSERT_NO_FATAL_FAILURE(expect_glued(a));
    ASSERT_NO_FATAL_FAILURE(expect_labels(a));
    patches += a.patches().operand_of.size();
    for (const NodeId n : a.patches().far) far += n != none;
  });
  EXPECT_GT(patches, 12u);
  EXPECT_GT(far, 0u);
}

/// Of a mesh that is to be resolved: over edges of exactly two faces that run both ways; all other edges are crowded.
TEST(Patches, OfRandomMeshesAreGluedOverEdgesOfTwoFaces) {
  std::size_t crowded = 0;
  for_families(0x9A7D, 12, [&](Solids& solids, Random& random) {
    const std::vector<Body> parts{solids.raw(), solids.raw(), solids.raw()};
    const Body body = merged(parts);
    const Operands operands({&body}, false);
    Names names;
    FacePairs pairs;
    for (std::uint32_t n = 0; n < 3; ++n) {
      const auto f = static_cast<std::uint32_t>(random.below(body.face_count() - 1));
      pairs.push_back({FaceId(f), FaceId(f + 1)});
    }
    const Touched touched = collect_touched(operands, pairs, names);
    const Patches patches = glue(operands, touched, draw_sheets(touched, {}, names));

    std::map<std::array<std::uint32_t, 2>, std::vector<std::pair<std::uint32_t, bool>>> at;  // faces by edge
    for (std::uint32_t f = 0; f < body.face_count(); ++f)
      body.for_edges(f, [&](std::uint32_t u, std::uint32_t v) {
        at[{std::min(u, v), std::max(u, v)}].emplace_back(f, u < v);
      });
    grid::Partition together(body.face_count());
    std::set<std::array<std::uint32_t, 3>> expected, found;
    for (const auto& [edge, faces] : at) {
      const bool plain = faces.size() == 2 && faces[0].second != faces[1].second;
      for (const auto& [f, forward] : faces) {
        if (touched.is_touched(f)) continue;
        if (!plain) expected.insert({f, edge[forward ? 0 : 1], edge[forward ? 1 : 0]});
        if (plain && !touched.is_touched(faces[0].first) && !touched.is_touched(faces[1].first))
          together.unite(faces[0].first, faces[1].first);
      }
    }
    for (const CrowdedEdge& e : patches.crowded[OperandId(0)]) found.insert({e.face.value, e.from, e.to});
    ASSERT_EQ(found, expected);
    crowded += found.size();

    std::map<std::uint32_t, NodeId> patch_of;
    std::set<NodeId> seen;
    for (std::uint32_t f = 0; f < body.face_count(); ++f) {
      ASSERT_EQ(patches.of[f] == none, touched.is_touched(f));
      if (patches.of[f] == none) continue;
      ASSERT_EQ(patch_of.try_emplace(together.find(f), patches.of[f]).first->second, patches.of[f]);
    }
    for (const auto& [root, n] : patch_of) ASSERT_TRUE(seen.insert(n).second);
    ASSERT_EQ(seen.size(), patches.operand_of.size());
  });
  EXPECT_GT(crowded, 20u);
}

}  // namespace
}  // namespace quoin::booleans::testing
