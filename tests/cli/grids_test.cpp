#include "tests/cli/support.h"

namespace quoin::cli_test {
namespace {

/// A tetrahedron with long normals on the grid that fits it.
const char* const skew =
    "OFF\n4 4 0\n-.31 -.4 -.3\n.5 -.3 -.2\n.01 .5 -.4\n.1 .2 .5\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

// Each with the grid that fits it.
TEST_F(CliTest, SolidsOfTwoSizesMeet) {
  put("large.off", cube("0", "20"));
  put("small.off", cube("0", "1"));
  put("model.json", R"({"quoin-model": 1, "model": {"difference": [{"mesh": {"file": "large.off"}},
                                                                   {"mesh": {"file": "small.off"}}]}})");
  ASSERT_EQ(run({"convert", "large.off", "-o", "large.quoin"}).code, 0);
  ASSERT_EQ(run({"convert", "small.off", "-o", "small.quoin"}).code, 0);
  for (const Words& words : std::vector<Words>{{"difference", "large.quoin", "small.quoin", "-o", "out.quoin"},
                                               {"difference", "large.off", "small.quoin", "-o", "out.quoin"},
                                               {"difference", "large.quoin", "small.off", "-o", "out.quoin"},
                                               {"eval", "model.json", "-o", "out.quoin"}}) {
    Words json = words;
    json.push_back("--json");
    const Outcome r = run(json);
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(r.json()["volume"], "7999") << words[1];
    EXPECT_EQ(r.json()["max_snap"], 0) << words[1];
  }
}

TEST_F(CliTest, RoundingOfOperandsIsSaid) {
  put("skew.off", skew);
  put("huge.off", cube("0", "1073741824"));
  ASSERT_EQ(run({"convert", "skew.off", "-o", "skew.quoin"}).code, 0);
  ASSERT_EQ(run({"convert", "huge.off", "-o", "huge.quoin"}).code, 0);
  const Outcome r = run({"union", "huge.quoin", "skew.quoin", "-o", "out.quoin", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  const Json import = r.json()["import"];
  EXPECT_EQ(import[0]["max_snap"], 0);
  EXPECT_GT(import[1]["max_snap"].get<double>(), 0);
  EXPECT_LT(import[1]["max_snap"].get<double>(), 1e-15);
  EXPECT_EQ(r.json()["max_snap"], import[1]["max_snap"]);

  // In any order the same bytes.
  ASSERT_EQ(run({"union", "skew.quoin", "huge.quoin", "-o", "turned.quoin"}).code, 0);
  EXPECT_EQ(get("out.quoin"), get("turned.quoin"));
  expect_error(run({"union", "huge.quoin", "skew.quoin", "-o", "none.quoin", "--exact-grid", "--json"}), 1,
               "inexact-grid", "skew.quoin");
}

// The cosine of 90 degrees, in doubles.
TEST_F(CliTest, PlanesOfFloatingPointAreRounded) {
  put("cube.off", cube("0", "1"));
  const Words words{"split", "cube.off", "--plane", "6.123233995736766e-17,0,1,-0.5",
                    "-o",    "a.quoin",  "b.quoin", "--json"};
  const Outcome r = run(words);
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.json()["above"]["volume"], "1/2");
  EXPECT_EQ(r.json()["below"]["volume"], "1/2");
  EXPECT_GT(r.json()["max_snap"].get<double>(), 6.1e-17);
  EXPECT_LT(r.json()["max_snap"].get<double>(), 6.2e-17);
  Words exact = words;
  exact.push_back("--exact-grid");
  expect_error(run(exact), 1, "bad-plane");
}

}  // namespace
}  // namespace quoin::cli_test
