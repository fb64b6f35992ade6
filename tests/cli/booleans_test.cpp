// union, intersection, difference, symmetric-difference.
#include "tests/cli/support.h"

namespace quoin::cli_test {
namespace {

TEST_F(CliTest, VolumesOfTwoCubesAreExact) {
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"union", "15/8"}, {"intersection", "1/8"}, {"difference", "7/8"}, {"symmetric-difference", "7/4"}};
  for (const auto& [command, volume] : expected) {
    const Outcome r = run({command, "a.off", "b.off", "-o", "out.quoin", "--json"});
    ASSERT_EQ(r.code, 0) << command << ": " << r.err;
    EXPECT_EQ(r.json()["volume"], volume) << command;
    const Outcome again = run({"info", "out.quoin", "--json"});
    ASSERT_EQ(again.code, 0) << command << ": " << again.err;
    EXPECT_EQ(again.json()["volume"], volume) << command;
  }
}

TEST_F(CliTest, DifferenceSubtractsAllOthers) {
  put("c.off", cube("-0.5", "0.5"));
  const Outcome r = run({"difference", "a.off", "b.off", "c.off", "-o", "out.off", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.json()["volume"], "3/4");
}

TEST_F(CliTest, SymmetricDifferenceIsOddParity) {
  const Outcome r = run({"symmetric-difference", "a.off", "a.off", "a.off", "-o", "out.quoin", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.json()["volume"], "1");
}

TEST_F(CliTest, UnionWithItselfIsTheSolid) {
  ASSERT_EQ(run({"union", "a.off", "a.off", "-o", "union.quoin"}).code, 0);
  ASSERT_EQ(run({"convert", "a.off", "-o", "same.quoin"}).code, 0);
  EXPECT_NE(get("same.quoin"), "");
  EXPECT_EQ(get("union.quoin"), get("same.quoin"));
}

TEST_F(CliTest, BooleanJsonHasTheKeysOfTheContract) {
  const Outcome r = run({"union", "a.off", "b.off", "-o", "out.stl", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  const Json object = r.json();
  expect_keys(object, info_keys);
  expect_keys(object, {"seconds", "cpu_seconds", "peak_rss_bytes", "max_snap", "export", "import"});
  const std::vector<std::string> stages = {"read", "build", "boolean", "export", "write", "total"};
  for (const char* clock : {"seconds", "cpu_seconds"}) {
    expect_keys(object[clock], stages);
    for (const auto& stage : stages) EXPECT_GE(object[clock][stage].get<double>(), 0.0) << stage;
  }
  expect_keys(object["export"], {"flipped", "collapsed", "split_edges", "closed"});
  EXPECT_EQ(object["export"]["closed"], true);
  EXPECT_GT(object["peak_rss_bytes"].get<std::uint64_t>(), 0U);
  EXPECT_EQ(object["max_snap"], 0.0);
  ASSERT_EQ(object["import"].size(), 2U);
  EXPECT_EQ(object["import"][1]["file"], "b.off");
  expect_keys(object["import"][1],
              {"max_snap", "merged_points", "zero_area_triangles", "nonplanar_polygons", "resolved_crossings"});
  EXPECT_FALSE(object.contains("statistics"));
}

TEST_F(CliTest, StatsCountTheRungs) {
  const Outcome r = run({"union", "a.off", "b.off", "-o", "out.stl", "--json", "--stats"});
  ASSERT_EQ(r.code, 0) << r.err;
  expect_keys(r.json()["statistics"], {"symbolic", "filter", "fixed_width", "rational"});
}

TEST_F(CliTest, SummaryIsOnStdoutUnlessQuiet) {
  const Outcome loud = run({"union", "a.off", "b.off", "-o", "out.stl"});
  EXPECT_EQ(loud.code, 0) << loud.err;
  EXPECT_NE(loud.out, "");
  EXPECT_EQ(loud.err, "");
  const Outcome quiet = run({"union", "a.off", "b.off", "-o", "out.stl", "--quiet"});
  EXPECT_EQ(quiet.code, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST_F(CliTest, ResultIsTheSameForAnyNumberOfThreads) {
  ASSERT_EQ(run({"union", "a.off", "b.off", "-o", "one.quoin", "--threads", "1"}).code, 0);
  ASSERT_EQ(run({"union", "a.off", "b.off", "-o", "two.quoin", "--threads", "2"}).code, 0);
  EXPECT_EQ(get("one.quoin"), get("two.quoin"));
}

}  // namespace
}  // namespace quoin::cli_test
