// Versions of a model as a tree.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/api/solids.h"

namespace quoin {
namespace {

using Index = History::Index;

Model block(const std::string& size) { return Model::block({size, "1", "1"}); }

/// "depth.order name" of the current version.
std::string here(const History& history) {
  const auto& v = history.current();
  return std::to_string(v.index.depth) + "." + std::to_string(v.index.order) + " " + v.name;
}

TEST(History, RootHasDepthZero) {
  const History history(block("1"), "start");
  EXPECT_EQ(here(history), "0.0 start");
  EXPECT_FALSE(history.current().parent);
  EXPECT_EQ(history.versions().size(), 1U);
  EXPECT_EQ(api_test::volume(evaluate(history.current().model).value()), "1");
}

// E33: a child is one deeper than its parent; order counts the versions of one depth from 0.
TEST(History, IndexIsDepthAndOrder) {
  History history(block("1"));
  EXPECT_EQ(history.add(block("2")), (Index{1, 0}));
  EXPECT_EQ(history.add(block("3")), (Index{2, 0}));
  EXPECT_EQ(history.current().parent, (Index{1, 0}));
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(history.add(block("4")), (Index{2, 1}));
  EXPECT_TRUE(history.undo());
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(history.add(block("5")), (Index{1, 1}));
  // Order counts across branches.
  EXPECT_EQ(history.add(block("6")), (Index{2, 2}));
  EXPECT_EQ(history.current().parent, (Index{1, 1}));
  EXPECT_EQ(history.add(block("7")), (Index{3, 0}));
  EXPECT_TRUE(history.go_to(Index{2, 0}));
  EXPECT_EQ(history.add(block("8")), (Index{3, 1}));
  EXPECT_EQ(history.current().parent, (Index{2, 0}));
}

TEST(History, UndoEndsAtTheRoot) {
  History history(block("1"), "root");
  EXPECT_FALSE(history.undo());
  EXPECT_FALSE(history.redo());
  history.add(block("2"), "a");
  EXPECT_FALSE(history.redo());
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(here(history), "0.0 root");
  EXPECT_FALSE(history.undo());
  EXPECT_EQ(here(history), "0.0 root");
  EXPECT_TRUE(history.redo());
  EXPECT_EQ(here(history), "1.0 a");
  EXPECT_FALSE(history.redo());
  EXPECT_EQ(here(history), "1.0 a");
}

TEST(History, RedoGoesToTheBranchLeftLast) {
  History history(block("1"), "root");
  history.add(block("2"), "a");
  history.add(block("3"), "a1");
  history.go_to("root");
  history.add(block("4"), "b");
  history.add(block("5"), "b1");
  // From b: up and down again.
  history.undo();
  history.undo();
  EXPECT_EQ(here(history), "0.0 root");
  EXPECT_TRUE(history.redo());
  EXPECT_EQ(here(history), "1.1 b");
  EXPECT_TRUE(history.redo());
  EXPECT_EQ(here(history), "2.1 b1");
  // From a, made before b, left after it.
  EXPECT_TRUE(history.go_to("a1"));
  history.undo();
  history.undo();
  EXPECT_TRUE(history.redo());
  EXPECT_EQ(here(history), "1.0 a");
  EXPECT_TRUE(history.redo());
  EXPECT_EQ(here(history), "2.0 a1");
  EXPECT_FALSE(history.redo());
}

TEST(History, RedoWithoutAChildLeftGoesToTheOneMadeLast) {
  History history(block("1"), "root");
  history.add(block("2"), "a");
  history.go_to(Index{0, 0});
  history.add(block("3"), "b");
  history.go_to(Index{0, 0});
  EXPECT_TRUE(history.redo());
  EXPECT_EQ(here(history), "1.1 b");
}

TEST(History, GoToByIndexAndName) {
  History history(block("1"), "root");
  history.add(block("2"), "a");
  history.add(block("3"), "twice");
  history.undo();
  history.add(block("4"), "twice");
  EXPECT_TRUE(history.go_to(Index{2, 0}));
  EXPECT_EQ(here(history), "2.0 twice");
  EXPECT_TRUE(history.go_to(Index{0, 0}));
  EXPECT_EQ(here(history), "0.0 root");
  // Of several of one name the last.
  EXPECT_TRUE(history.go_to("twice"));
  EXPECT_EQ(here(history), "2.1 twice");
  EXPECT_TRUE(history.go_to("a"));
  EXPECT_EQ(here(history), "1.0 a");
  // Nowhere: it stays.
  EXPECT_FALSE(history.go_to(Index{2, 2}));
  EXPECT_FALSE(history.go_to(Index{3, 0}));
  EXPECT_FALSE(history.go_to(Index{0, 1}));
  EXPECT_FALSE(history.go_to("b"));
  EXPECT_FALSE(history.go_to("twic"));
  EXPECT_EQ(here(history), "1.0 a");
}

TEST(History, CopiesAreIndependent) {
  History history(block("1"), "root");
  history.add(block("2"), "a");
  History copy = history;
  copy.undo();
  copy.add(block("3"), "b");
  EXPECT_EQ(here(history), "1.0 a");
  EXPECT_EQ(history.versions().size(), 2U);
  EXPECT_EQ(here(copy), "1.1 b");
}

// Random walks against lists of parents: indices, undo, redo, and all versions stay.
TEST(History, RandomWalksLoseNothing) {
  auto random = api_test::random_engine();
  for (int round = 0; round < 20; ++round) {
    History history(block("1"), "0");
    std::vector<std::size_t> parent{0}, depth{0}, order{0}, left{0};
    std::size_t now = 0;
    for (int step = 0; step < 200; ++step) {
      switch (random() % 5) {
        case 0:
        case 1: {
          const std::size_t made = parent.size();
          const auto order_here = static_cast<std::size_t>(std::count(depth.begin(), depth.end(), depth[now] + 1));
          const Index index = history.add(block(std::to_string(made + 1)), std::to_string(made));
          parent.push_back(now);
          depth.push_back(depth[now] + 1);
          order.push_back(order_here);
          left.push_back(0);
          left[now] = made;
          now = made;
          EXPECT_EQ(index, (Index{static_cast<std::uint32_t>(depth[now]), static_cast<std::uint32_t>(order[now])}));
          break;
        }
        case 2:
          EXPECT_EQ(history.undo(), now != 0);
          if (now != 0) {
            left[parent[now]] = now;
            now = parent[now];
          }
          break;
        case 3:
          EXPECT_EQ(history.redo(), left[now] != 0);
          if (left[now] != 0) now = left[now];
          break;
        default:
          now = random() % parent.size();
          EXPECT_TRUE(history.go_to(std::to_string(now)));
      }
      ASSERT_EQ(history.current().name, std::to_string(now));
    }
    ASSERT_EQ(history.versions().size(), parent.size());
    for (std::size_t i = 0; i < parent.size(); ++i) {
      const auto& v = history.versions()[i];
      EXPECT_EQ(v.name, std::to_string(i));
      EXPECT_EQ(v.index, (Index{static_cast<std::uint32_t>(depth[i]), static_cast<std::uint32_t>(order[i])}));
      EXPECT_EQ(v.model.to_json(), block(std::to_string(i + 1)).to_json());
      EXPECT_EQ(v.parent.has_value(), i != 0);
      if (v.parent) {
        EXPECT_EQ(*v.parent, history.versions()[parent[i]].index);
      }
    }
  }
}

}  // namespace
}  // namespace quoin
