#include "tests/cli/support.h"

namespace quoin::cli_test {
namespace {

TEST_F(CliTest, MoveSaysHowFarAnythingIsFromExact) {
  const Outcome r =
      run({"move", "a.off", "--rotate", "z", "30", "--translate", "1", "-2", "1/3", "-o", "out.quoin", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  const auto json = r.json();
  ASSERT_EQ(json["quaternion"].size(), 4U);
  for (const auto& number : json["quaternion"]) EXPECT_TRUE(number.is_string());
  EXPECT_GT(json["angle_error"].get<double>(), 0);
  EXPECT_LT(json["angle_error"].get<double>(), 1e-24);
  EXPECT_NE(json["displacement_bound"].get<std::string>().find('/'), std::string::npos);
  EXPECT_EQ(json["rounding"]["method"], "best");
  EXPECT_EQ(json["rounding"]["by_planes"], 1);
  EXPECT_EQ(json["faces"], 6);
  EXPECT_EQ(json["vertices"], 8);
  for (const char* key : {"seconds", "cpu_seconds", "peak_rss_bytes", "max_snap", "step", "box"})
    EXPECT_TRUE(json.contains(key)) << key;
}

TEST_F(CliTest, MotionsActInOrderAndCompose) {
  ASSERT_EQ(run({"convert", "a.off", "-o", "a.quoin"}).code, 0);
  // There and back, and a full turn in parts.
  ASSERT_EQ(run({"move", "a.quoin", "--rotate", "1,1,0", "12.5", "--translate", "1", "2", "3", "--translate", "-1",
                 "-2", "-3", "--rotate", "-1,-1,0", "12.5", "-o", "back.quoin"})
                .code,
            0);
  EXPECT_EQ(get("back.quoin"), get("a.quoin"));
  ASSERT_EQ(run({"move", "a.quoin", "--rotate", "z", "350.5", "--rotate", "z", "9.5", "-o", "turn.quoin"}).code, 0);
  EXPECT_EQ(get("turn.quoin"), get("a.quoin"));
  // The order matters.
  ASSERT_EQ(run({"move", "a.quoin", "--rotate", "z", "90", "--translate", "2", "0", "0", "-o", "x.quoin"}).code, 0);
  ASSERT_EQ(run({"move", "a.quoin", "--translate", "2", "0", "0", "--rotate", "z", "90", "-o", "y.quoin"}).code, 0);
  EXPECT_NE(get("x.quoin"), get("y.quoin"));
  const auto x = run({"info", "x.quoin", "--json"}).json()["box"], y = run({"info", "y.quoin", "--json"}).json()["box"];
  EXPECT_EQ(x, (nlohmann::json{{1.0, 0.0, 0.0}, {2.0, 1.0, 1.0}}));
  EXPECT_EQ(y, (nlohmann::json{{-1.0, 2.0, 0.0}, {0.0, 3.0, 1.0}}));
  ASSERT_EQ(run({"move", "a.quoin", "--mirror", "x", "--scale", "2", "-o", "m.quoin"}).code, 0);
  EXPECT_EQ(run({"info", "m.quoin", "--json"}).json()["volume"], "8");
  const auto rough =
      run({"move", "a.quoin", "--rotate", "x", "1", "--rounding", "vertices", "-o", "v.quoin", "--json"});
  EXPECT_EQ(rough.json()["rounding"]["by_vertices"], 1);
}

TEST_F(CliTest, MotionsThatMakeNoSense) {
  expect_error(run({"move", "a.off", "-o", "out.off", "--json"}), 2, "usage");
  expect_error(run({"move", "a.off", "--rotate", "w", "30", "-o", "out.off", "--json"}), 2, "usage");
  expect_error(run({"move", "a.off", "--rotate", "z", "-o", "out.off", "--json"}), 2, "usage");
  expect_error(run({"move", "a.off", "--rotate", "0,0,0", "30", "-o", "out.off", "--json"}), 2, "usage");
  expect_error(run({"move", "a.off", "--translate", "1", "2", "far", "-o", "out.off", "--json"}), 2, "usage");
  expect_error(run({"move", "a.off", "--scale", "-1", "-o", "out.off", "--json"}), 2, "usage");
  expect_error(run({"move", "a.off", "--rotate", "z", "30", "--rounding", "up", "-o", "out.off", "--json"}), 2,
               "usage");
  const Outcome far = run({"move", "a.off", "--translate", "1000", "0", "0", "-o", "out.off", "--json"});
  expect_error(far, 1, "out-of-range");
  EXPECT_EQ(names(), (std::set<std::string>{"a.off", "b.off"}));
}

}  // namespace
}  // namespace quoin::cli_test
