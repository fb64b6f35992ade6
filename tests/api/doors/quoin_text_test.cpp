// What a .quoin text may say, and what is refused.
#include <gtest/gtest.h>

#include <set>

#include "tests/api/doors/quoin_damage.h"
#include "tests/api/solids.h"

namespace quoin::api_test {
namespace {

TEST(QuoinText, ValidTextsAreAccepted) {
  for (const std::string& text : damage::valid_texts()) {
    const auto solid = Solid::from_quoin(text);
    ASSERT_TRUE(solid) << solid.error().message << ", " << solid.error().where << "\n" << text;
    EXPECT_EQ(solid.value().to_quoin(), text);
    EXPECT_TRUE(Solid::from_quoin(text, Trust::embedded));
    EXPECT_EQ(damage::broken_law(text).value_or(""), "") << text;
    EXPECT_EQ(damage::closed(damage::opened(text)), text);
  }
}

// The law of the door, under changes of the structure that leave most of it as it was.
TEST(QuoinText, WhatIsAcceptedIsRight) {
  auto random = random_engine();
  const std::vector<std::string> texts = damage::valid_texts();
  std::size_t accepted = 0, changed = 0, crossing = 0;
  for (int round = 0; round < 1500; ++round) {
    const std::string& text = texts[random() % texts.size()];
    damage::Document document = damage::opened(text);
    const int changes = 1 + static_cast<int>(random() % 2);
    for (int i = 0; i < changes; ++i) {
      const auto number = [&] { return static_cast<std::uint32_t>(random() % 1000); };
      const std::uint32_t kind = number(), a = number(), b = number(), c = number();
      damage::damage(document, kind, a, b, c);
    }
    const std::string damaged = damage::closed(document);
    if (damaged == text) continue;
    ++changed;
    EXPECT_EQ(damage::broken_law(damaged).value_or(""), "") << damaged;
    if (const auto read = Solid::from_quoin(damaged); read) {
      ++accepted;
    } else if (read.error().message.starts_with("the solid is not valid")) {
      ++crossing;
      EXPECT_NE(read.error().where, "faces") << read.error().message << "\n" << damaged;
    }
    if (const auto trusted = Solid::from_quoin(damaged, Trust::embedded)) {
      EXPECT_FALSE(trusted.value().to_quoin().empty());
    }
  }
  std::cout << changed << " changed, " << accepted << " accepted\n";
  EXPECT_GT(changed, 1000u);
  EXPECT_GT(crossing, 10u);
}

/// The fault of a text, as "message, where".
std::string fault_of(const std::string& text) {
  const auto solid = Solid::from_quoin(text);
  return solid ? "" : solid.error().message + ", " + solid.error().where;
}
damage::Document cube() { return damage::opened(damage::block({0, 0, 0}, {4, 4, 4}).to_quoin()); }

TEST(QuoinText, ASlitAlongAnEdgeOfItsFace) {
  damage::Document d = cube();
  d.faces[0].push_back({0, 1});
  EXPECT_EQ(fault_of(damage::closed(d)), "the edge between the vertices 0 and 1 occurs twice in one direction, face 0");
  d = cube();
  d.faces[0] = {{0, 1, 0, 1, 3, 2}};
  EXPECT_EQ(fault_of(damage::closed(d)), "the edge between the vertices 0 and 1 occurs twice in one direction, face 0");
  EXPECT_FALSE(Solid::from_quoin(damage::closed(d), Trust::embedded));
}

// Two cubes side by side: what is on the plane of a face need not be in it, though another face is around.
TEST(QuoinText, ASlitOrAPointOutsideOfItsFace) {
  const Solid two = damage::block({0, 0, 0}, {1, 1, 1}) + damage::block({3, 0, 0}, {4, 1, 1});
  const auto with = [&](const std::vector<std::uint32_t>& loop) {
    damage::Document d = damage::opened(two.to_quoin());
    const std::array<std::string, 4> top{"0", "0", "1", "-1"};
    const auto face = std::find(d.numbers.planes.begin(), d.numbers.planes.end(), top) - d.numbers.planes.begin();
    const auto& first = d.faces[static_cast<std::size_t>(face)][0];
    EXPECT_EQ(std::count(first.begin(), first.end(), loop[0]), 0);
    d.faces[static_cast<std::size_t>(face)].push_back(loop);
    return fault_of(damage::closed(d));
  };
  // 9 and 13 are corners of the other cube's top.
  const std::string sentence =
      "the solid is not valid: faces cross, overlap, touch without a common vertex, or fall into several pieces at "
      "(3, 0, 1) grid steps, face 6";
  EXPECT_EQ(with({9, 13}), sentence);
  EXPECT_EQ(with({9}), sentence);
}

TEST(QuoinText, APointOnTheLoopOfItsFace) {
  damage::Document d = cube();
  d.faces[0].push_back({3});
  EXPECT_EQ(fault_of(damage::closed(d)), "vertex 3 is a point inside the face and occurs in it again, face 0");
}

TEST(QuoinText, AVertexWithoutNeed) {
  damage::Document d = cube();
  // One inside a straight edge, in all faces there, is read and not written again.
  damage::damage(d, 19, 0, 0, 0);
  EXPECT_EQ(Solid::from_quoin(damage::closed(d)).value().to_quoin(), damage::closed(cube()));
  d = cube();
  d.numbers.vertices.push_back({"5", "5", "5", "1"});
  EXPECT_EQ(fault_of(damage::closed(d)), "no edge ends in the vertex, vertex 8");
}

TEST(QuoinText, AFaceCutInTwo) {
  damage::Document d = cube();
  damage::damage(d, 21, 0, 0, 0);
  EXPECT_EQ(fault_of(damage::closed(d)),
            "all faces at the edge between the vertices 0 and 3 lie on one plane: it is no edge, face 1");
}

TEST(QuoinText, TheEndOfTheWorldBelongsToIt) {
  constexpr int end = 536'870'912;
  const std::string text = damage::block({-end, -end, -end}, {end, end, end}).to_quoin();
  EXPECT_EQ(fault_of(text), "");
  EXPECT_EQ(Solid::from_quoin(text).value().to_quoin(), text);
  for (const std::size_t v : {0u, 7u}) {
    damage::Document d = damage::opened(text);
    d.numbers.vertices[v][1] = v == 0 ? "-536870913" : "536870913";
    EXPECT_EQ(fault_of(damage::closed(d)),
              "the vertex lies outside the world of +-2^29 grid steps, vertex " + std::to_string(v));
  }
}

/// 10^exponent + more, as a decimal.
std::string decimal(int exponent, int more) {
  exact::Integer v = more;
  v += pow(exact::Integer(10), static_cast<unsigned>(exponent));
  return v.str();
}

// The tetrahedron that the plane a (x + y + z) = d cuts off, its numbers around the ends of machine words.
TEST(QuoinText, NumbersOfAllLengths) {
  for (int exponent = 9; exponent <= 26; ++exponent)
    for (const int more : {-1, 0, 1, 7}) {
      const std::string d = decimal(exponent, more);
      std::string a = decimal(exponent - 8, 1);
      while (gcd(exact::Integer(a), exact::Integer(d)) != 1) a = exact::Integer(exact::Integer(a) + 1).str();
      const std::string text = "quoin 1\ngrid 1 0 0 0\ninfinity empty\nvertices 4\n0 0 0\n0 0 " + d + " " + a + "\n0 " +
                               d + " 0 " + a + "\n" + d + " 0 0 " + a +
                               "\nfaces 4\n-1 0 0 0 1\n0 1 2\n0 -1 0 0 1\n0 3 1\n" + "0 0 -1 0 1\n0 2 3\n" + a + " " +
                               a + " " + a + " -" + d + " 1\n1 3 2\nend\n";
      EXPECT_EQ(fault_of(text), "") << text;
      EXPECT_EQ(Solid::from_quoin(text).value().to_quoin(), text);
    }
}

// Order is the writer's duty: what is out of order is read, and written again in canonical order.
TEST(QuoinText, OutOfOrder) {
  const std::string text = damage::closed(cube());
  for (const auto& [kind, a, b, c] :
       std::vector<std::array<std::uint32_t, 4>>{{9, 0, 2, 3}, {2, 0, 0, 1}, {10, 2, 3, 0}}) {
    damage::Document d = cube();
    damage::damage(d, kind, a, b, c);
    EXPECT_NE(damage::closed(d), text);
    EXPECT_EQ(fault_of(damage::closed(d)), "");
    EXPECT_EQ(Solid::from_quoin(damage::closed(d)).value().to_quoin(), text);
  }
}

}  // namespace
}  // namespace quoin::api_test
