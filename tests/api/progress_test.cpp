#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>

#include "tests/api/fractions.h"
#include "tests/api/solids.h"

namespace quoin::api_test {
namespace {

/// Whether an operation that runs with these options succeeds.
using Operation = std::function<bool(const Options&)>;
using Operations = std::map<std::string, Operation>;

Operations booleans() {
  const Solid a = box({0, 0, 0}, {2, 2, 2}), b = box({1, 1, 1}, {3, 3, 3}), far = box({7, 7, 7}, {8, 8, 8});
  std::vector<Solid> crowd;
  for (int i = 0; i < 20; ++i) crowd.push_back(box({0.0 + i, 0, 0}, {8.0 + i, 8, 8}));
  const HalfSpace half{{"1", "0", "0", "-1"}};

  return {
      {"a union",
       [=](const Options& run) {
         return unite({a, b}, run).has_value();
       }},
      {"the union of one solid", [=](const Options& run) { return unite({a}, run).has_value(); }},
      {"the union of a solid and itself",
       [=](const Options& run) {
         return unite({a, a}, run).has_value();
       }},
      {"the union of empty solids",
       [=](const Options& run) {
         return unite({Solid(), Solid()}, run).has_value();
       }},
      {"a crowded union", [=](const Options& run) { return unite(crowd, run).has_value(); }},
      {"an empty intersection",
       [=](const Options& run) {
         return intersect({a, far}, run).has_value();
       }},
      {"a difference", [=](const Options& run) { return difference(a, {b}, run).has_value(); }},
      {"the difference of a solid and none", [=](const Options& run) { return difference(a, {}, run).has_value(); }},
      {"a symmetric difference",
       [=](const Options& run) {
         return symmetric_difference({a, b}, run).has_value();
       }},
      {"a solid as an expression", [=](const Options& run) { return evaluate(Expression(a), run).has_value(); }},
      {"a complement of a complement", [=](const Options& run) { return evaluate(~~Expression(a), run).has_value(); }},
      {"a part above a plane", [=](const Options& run) { return evaluate(Expression(a) - half, run).has_value(); }},
      {"a split", [=](const Options& run) { return split(a, half, run).has_value(); }},
  };
}

Operations motions() {
  const Solid a = box({0, 0, 0}, {2, 2, 2}, grid_of("1/65536"));
  const std::map<std::string, Solid> solids = {
      {"a box", a}, {"all but a box", ~a}, {"nothing", Solid()}, {"all of space", ~Solid()}};
  const std::map<std::string, Motion> motions = {{"identity", Motion()},
                                                 {"step", Motion::translation({"1", "0", "0"}).value()},
                                                 {"tiny turn", Motion::rotation({"0", "0", "1"}, "1e-300").value()},
                                                 {"turn", Motion::rotation({"1", "2", "3"}, "10").value()}};

  Operations all;
  for (const auto& s : solids)
    for (const auto& m : motions)
      all[s.first + " under the " + m.first] = [solid = s.second, motion = m.second](const Options& run) {
        return moved(solid, motion, {.run = run}).has_value();
      };
  return all;
}

Operations models() {
  const Model block = Model::block({"3", "2", "1"}), solid = Model::solid(box({0, 0, 0}, {2, 2, 2}));
  const std::map<std::string, Model> models = {
      {"nothing", Model()}, {"no terms", Model::unite({})},
      {"a block", block},   {"a turned block", block.rotated({"1", "2", "3"}, "10")},
      {"a solid", solid},   {"a difference", block - solid}};

  Operations all;
  for (const auto& m : models)
    all["the model of " + m.first] = [model = m.second](const Options& run) {
      return evaluate(model, {.run = run}).has_value();
    };
  return all;
}

Operations exports() {
  const Solid a = box({0, 0, 0}, {2, 2, 2});
  return {
      {"triangles", [=](const Options& run) { return a.to_triangles({.run = run}).has_value(); }},
      {"no triangles", [=](const Options& run) { return Solid().to_triangles({.run = run}).has_value(); }},
      {"what is known", [=](const Options& run) { return a.info(run).closed; }},
      {"what is known of nothing", [=](const Options& run) { return Solid().info(run).closed; }},
  };
}

// Whatever way they take: those with nothing to do, too. Imports are in files_test.
TEST(ProgressOf, EveryOperationEndsAtOne) {
  for (const Operations& operations : {booleans(), motions(), models(), exports()})
    for (const auto& [name, operation] : operations)
      for (const unsigned threads : {0u, 2u}) {
        Fractions fractions;
        ASSERT_TRUE(operation({.progress = fractions.record(), .threads = threads})) << name;
        fractions.expect_whole(name);
        EXPECT_TRUE(operation({})) << name;
      }
}

TEST(ProgressOf, OperationsThatFailDoNotSayOne) {
  const Solid a = box({0, 0, 0}, {2, 2, 2});
  const HalfSpace half{{"1", "0", "0", "-1"}}, none{{"0", "0", "0", "1"}};
  const Cancel cancel = true;
  Mesh open = box_mesh({0, 0, 0}, {1, 1, 1});
  open.triangles.resize(open.triangles.size() - 3);

  const Operations operations = {
      {"no operand", [=](const Options& run) { return unite({}, run).has_value(); }},
      {"a plane without a normal", [=](const Options& run) { return split(a, none, run).has_value(); }},
      {"an infinite surface", [=](const Options& run) { return evaluate(~Expression(a) & half, run).has_value(); }},
      {"a size of 0",
       [=](const Options& run) {
         return evaluate(Model::block({"1", "1", "0"}), {.run = run}).has_value();
       }},
      {"a hole", [=](const Options& run) {
         return Solid::from_triangles(open.points, open.triangles, {.run = run}).has_value();
       }}};
  Fractions fractions;
  for (const auto& [name, operation] : operations) {
    EXPECT_FALSE(operation({.progress = fractions.record()})) << name;
    EXPECT_EQ(std::count(fractions.all.begin(), fractions.all.end(), 1), 0) << name;
  }

  for (const std::vector<Solid>& others : {std::vector<Solid>{}, std::vector<Solid>{a}}) {
    const auto result = difference(a, others, {.progress = fractions.record(), .cancel = &cancel});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::cancelled);
    EXPECT_EQ(std::count(fractions.all.begin(), fractions.all.end(), 1), 0);
  }
}

}  // namespace
}  // namespace quoin::api_test
