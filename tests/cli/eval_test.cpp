#include "tests/cli/support.h"

namespace quoin::cli_test {
namespace {

TEST_F(CliTest, EvalOfAModel) {
  put("model.json", R"({"quoin-model": 1, "step": "1/1000", "parameters": {"w": 2},
 "model": {"difference": [{"block": {"size": ["w", 1, 1]}},
                          {"rotate": {"axis": "z", "angle": 45, "of": {"mesh": {"file": "b.off"}}}}]}})");
  const Outcome r = run({"eval", "model.json", "-o", "out.quoin", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.json()["step"], "1/1000");
  EXPECT_EQ(r.json()["rounding"]["primitives"], 2);
  EXPECT_TRUE(r.json().contains("displacement_bound"));
  ASSERT_EQ(run({"eval", "-", "--set", "w=3", "--set", "w=4", "-o", "wide.quoin"}, get("model.json")).code, 0);
  put("box.json", R"({"quoin-model": 1, "model": {"block": {"size": ["w", "h", 1]}}})");
  const Outcome set = run({"eval", "-", "--set", "w=3", "--set", "h=1/2", "-o", "box.off", "--json"}, get("box.json"));
  ASSERT_EQ(set.code, 0) << set.err;
  EXPECT_EQ(set.json()["volume"], "3/2");
  expect_error(run({"eval", "box.json", "-o", "out.off", "--json"}), 1, "bad-parameter", "box.json");
  expect_error(run({"eval", "box.json", "--set", "w", "-o", "out.off", "--json"}), 2, "usage");
  put("bad.json", "{\"quoin-model\": 1,\n \"model\": {\"cube\": 1}}");
  const Outcome bad = run({"eval", "bad.json", "-o", "out.off", "--json"});
  expect_error(bad, 1, "bad-model", "bad.json");
  EXPECT_EQ(bad.json()["error"]["where"], "line 2, column 11");
  expect_error(run({"eval", "none.json", "-o", "out.off", "--json"}), 1, "missing-file", "none.json");
}

// A plate of a thousandth of a step, beside a block.
TEST_F(CliTest, APrimitiveThatVanishesIsSaid) {
  put("thin.json", R"({"quoin-model": 1, "model": {"rotate": {"axis": "y", "angle": 30, "of": {"union": [
    {"block": {"size": [10, 20, 1]}}, {"block": {"size": [10, 20, "1/1000"]}}]}}}})");
  const Words words{"eval", "thin.json", "-o", "out.quoin", "--step", "1", "--rounding", "vertices"};
  const Outcome plain = run(words);
  EXPECT_EQ(plain.code, 0) << plain.err;
  EXPECT_EQ(plain.err,
            "quoin: warning: 1 primitive is about as thin as a grid step, so that rounding vertices leaves nothing: "
            "dropped (thin.json, primitive 1)\n");
  Words more = words;
  more.push_back("--json");
  const auto rounding = run(more).json()["rounding"];
  EXPECT_EQ(rounding["vanished_primitives"], 1);
  EXPECT_EQ(rounding["vanished_where"], "primitive 1");
}

}  // namespace
}  // namespace quoin::cli_test
