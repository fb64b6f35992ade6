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

TEST_F(CliTest, EvalSaysWhatImportDidToMeshes) {
  put("two.off", one_body_inside_out());
  put("third.off", cube("0", "0.3333333333333333"));
  put("model.json", R"({"quoin-model": 1, "model": {"union": [{"mesh": {"file": "two.off"}},
    {"translate": {"by": [1, 0, 0], "of": {"mesh": {"file": "two.off"}}}}, {"mesh": {"file": "third.off"}}]}})");
  const Words words = {"eval", "model.json", "-o", "out.quoin"};
  const auto with = [&](const char* option) {
    Words more = words;
    more.push_back(option);
    return run(more);
  };
  const std::string warning =
      "quoin: warning: 1 shell is inside out and bounds nothing of the solid: dropped "
      "(./two.off, shell at (3.5, 3.5, 3.5))\n";

  // A file that is named twice is said once.
  const Outcome plain = run(words);
  EXPECT_EQ(plain.code, 0) << plain.err;
  EXPECT_EQ(plain.err, warning);
  EXPECT_NE(plain.out.find("\nlargest snap "), std::string::npos) << plain.out;
  EXPECT_EQ(with("--quiet").err, "");

  const Outcome r = with("--json");
  EXPECT_EQ(r.err, warning);
  const Json import = r.json()["import"];
  ASSERT_EQ(import.size(), 2U);
  EXPECT_EQ(import[0]["file"], "./two.off");
  EXPECT_EQ(import[0]["dropped_shells"], 1);
  EXPECT_EQ(import[0]["dropped_where"], "shell at (3.5, 3.5, 3.5)");
  EXPECT_EQ(import[1]["file"], "./third.off");
  EXPECT_EQ(import[1]["dropped_shells"], 0);
  EXPECT_GT(import[1]["max_snap"].get<double>(), 0);
  EXPECT_EQ(r.json()["max_snap"], import[1]["max_snap"]);
  // The same as the mesh alone, on a grid of its own.
  const Json alone = run({"info", "two.off", "--json"}).json()["import"][0];
  for (const auto& [key, value] : alone.items()) {
    if (key == "objects") continue;  // of files that are operands
    EXPECT_EQ(key == "file" ? Json("two.off") : import[0][key], value);
  }
}

// A mesh of two cubes that overlap.
TEST_F(CliTest, EvalProvesMeshesInAnyCase) {
  const auto points = [](const std::string& text) { return text.substr(10, text.find("4 0 2 3 1") - 10); };
  put("two.off", "OFF\n16 12 0\n" + points(cube("0", "2")) + points(cube("1", "3")) +
                     "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n" +
                     "4 8 10 11 9\n4 12 13 15 14\n4 8 9 13 12\n4 10 14 15 11\n4 8 12 14 10\n4 9 11 15 13\n");
  put("model.json", R"({"quoin-model": 1, "model": {"mesh": {"file": "two.off"}}})");
  for (const Words& words : std::vector<Words>{{"eval", "model.json", "-o", "out.quoin"},
                                               {"eval", "model.json", "-o", "out.quoin", "--trust"}}) {
    const Outcome r = run(words);
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_NE(r.out.find("./two.off: resolved crossings "), std::string::npos) << r.out;
    EXPECT_EQ(run({"info", "out.quoin", "--json"}).json()["volume"], "15");
  }
}

TEST_F(CliTest, EvalOfAModelWithoutMeshesImportsNothing) {
  put("box.json", R"({"quoin-model": 1, "model": {"block": {"size": [1, 2, 3]}}})");
  EXPECT_EQ(run({"eval", "box.json", "-o", "out.off"}).out.find("snap"), std::string::npos);
  const Json object = run({"eval", "box.json", "-o", "out.off", "--json"}).json();
  EXPECT_EQ(object["import"], Json::array());
  EXPECT_EQ(object["max_snap"], 0);
}

// A cube without one of its faces.
TEST_F(CliTest, EvalCuresTheMeshesOfAModel) {
  std::string text = cube("0", "2");
  text.replace(text.find("8 6 0"), 5, "8 5 0");
  put("open.off", text.substr(0, text.rfind("4 1 3 7 5")));
  put("model.json", R"({"quoin-model": 1, "model": {"union": [{"mesh": {"file": "a.off"}},
    {"translate": {"by": [9, 0, 0], "of": {"mesh": {"file": "open.off"}}}}]}})");
  const Outcome refused = run({"eval", "model.json", "-o", "out.quoin", "--json"});
  expect_error(refused, 1, "open-boundary", "./open.off");
  ASSERT_EQ(refused.json()["findings"].size(), 1U);
  EXPECT_EQ(refused.json()["findings"][0]["cure"], "caps");

  const Words words{"eval", "model.json", "-o", "out.quoin", "--repair", "caps"};
  const Outcome plain = run(words);
  EXPECT_EQ(plain.code, 0) << plain.err;
  EXPECT_EQ(plain.err,
            "quoin: ./open.off: repaired: 1 planar hole closed, at most 2.828427124746193 across (near (2, 0, 0))\n");
  Words more = words;
  more.push_back("--json");
  const Json import = run(more).json()["import"];
  ASSERT_EQ(import.size(), 2U);
  EXPECT_EQ(import[0]["repairs"].size(), 0U);
  // As for a mesh that is an operand.
  EXPECT_EQ(import[1]["repairs"],
            run({"info", "open.off", "--repair", "caps", "--json"}).json()["import"][0]["repairs"]);
  expect_error(run({"eval", "model.json", "-o", "out.quoin", "--repair", "magic", "--json"}), 2, "usage");
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
