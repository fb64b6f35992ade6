#include <cmath>
#include <numbers>
#include <regex>

#include "tests/cli/support.h"

namespace quoin::cli_test {
namespace {

TEST_F(CliTest, InfoOfACube) {
  const Outcome r = run({"info", "a.off", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  const Json object = r.json();
  expect_keys(object, info_keys);
  EXPECT_EQ(object["vertices"], 8);
  EXPECT_EQ(object["edges"], 12);
  EXPECT_EQ(object["faces"], 6);
  EXPECT_EQ(object["triangles"], 12);
  EXPECT_EQ(object["shells"], 1);
  EXPECT_EQ(object["genus"], 0);
  EXPECT_EQ(object["closed"], true);
  EXPECT_EQ(object["manifold"], true);
  EXPECT_EQ(object["bounded"], true);
  EXPECT_EQ(object["volume"], "1");
  EXPECT_EQ(object["volume_approx"], 1.0);
  EXPECT_EQ(object["area_approx"], 6.0);
  EXPECT_EQ(object["box"], Json::parse("[[0,0,0],[1,1,1]]"));
  EXPECT_TRUE(object["step"].is_string());
}

/// An OFF file of a sphere of 1,104 points, each somewhere between 0.9 and 1.1 from the centre.
std::string noisy_sphere(std::uint32_t seed) {
  constexpr std::uint32_t lines = 23, around = 48, points = 2 + lines * around;
  std::string vertices = "0 0 1\n0 0 -1\n", triangles;
  const auto at = [](std::uint32_t line, std::uint32_t i) { return 2 + line * around + i % around; };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    triangles += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  };
  for (std::uint32_t line = 0; line < lines; ++line)
    for (std::uint32_t i = 0; i < around; ++i) {
      seed = seed * 1664525 + 1013904223;
      const double radius = 0.9 + 0.2 * (seed >> 8) / (1u << 24);
      const double down = std::numbers::pi * (line + 1) / (lines + 1), turn = 2 * std::numbers::pi * i / around;
      for (const double x : {std::sin(down) * std::cos(turn), std::sin(down) * std::sin(turn), std::cos(down)})
        vertices += std::to_string(radius * x) + " ";
      vertices += "\n";

      if (line == 0) add(0, at(0, i), at(0, i + 1));
      if (line + 1 == lines) {
        add(1, at(line, i + 1), at(line, i));
      } else {
        add(at(line, i), at(line + 1, i), at(line + 1, i + 1));
        add(at(line, i), at(line + 1, i + 1), at(line, i + 1));
      }
    }
  return "OFF\n" + std::to_string(points) + " " + std::to_string(2 * lines * around) + " 0\n" + vertices + triangles;
}

TEST_F(CliTest, InfoSaysWhereTheExactVolumeIsLong) {
  put("one.off", noisy_sphere(1));
  put("two.off", noisy_sphere(2));
  ASSERT_EQ(run({"union", "one.off", "two.off", "-o", "both.quoin"}).code, 0);
  const Outcome text = run({"info", "both.quoin"}), json = run({"info", "both.quoin", "--json"});
  ASSERT_EQ(text.code, 0) << text.err;
  EXPECT_TRUE(std::regex_search(text.out, std::regex("volume, exact +long, all digits with --json\n")));
  EXPECT_GT(json.json()["volume"].get<std::string>().size(), 40000u);
}

TEST_F(CliTest, InfoOfTheEmptySolid) {
  put("far.off", cube("5", "6"));
  ASSERT_EQ(run({"intersection", "a.off", "far.off", "-o", "empty.quoin"}).code, 0);
  const Outcome r = run({"info", "empty.quoin", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  const Json object = r.json();
  for (const char* key : {"vertices", "edges", "faces", "triangles", "shells"}) EXPECT_EQ(object[key], 0) << key;
  for (const char* key : {"closed", "manifold", "bounded"}) EXPECT_EQ(object[key], true) << key;
  EXPECT_EQ(object["volume"], "0");
  EXPECT_EQ(object["box"], nullptr);
}

TEST_F(CliTest, InfoPrintsAnAlignedTable) {
  const Outcome r = run({"info", "a.off"});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(std::regex_search(r.out, std::regex("(^|\n)vertices +8\n"))) << r.out;
  EXPECT_TRUE(std::regex_search(r.out, std::regex("\nvolume +1\n"))) << r.out;
  EXPECT_TRUE(std::regex_search(r.out, std::regex("\nvolume, exact +1\n"))) << r.out;
}

TEST_F(CliTest, InfoShortensLongNumbers) {
  // 38 steps of a long denominator.
  put("tiny.off", cube("0", "1e-30"));
  const Words words = {"info", "tiny.off", "--step", "1/3" + std::string(31, '7')};
  const Outcome tiny = run(words);
  ASSERT_EQ(tiny.code, 0) << tiny.err;
  Words with_json = words;
  with_json.push_back("--json");
  const std::string exact = run(with_json).json()["volume"];
  ASSERT_GT(exact.size(), 60U);
  const auto slash = exact.find('/');
  std::smatch found;
  const std::regex rows(
      "\nvolume +([0-9.]+e-[0-9]+)\nvolume, exact +([0-9]+)(\\.\\.\\.)?/([0-9]+)\\.\\.\\. \\(([0-9]+) "
      "digits, all with --json\\)\n");
  ASSERT_TRUE(std::regex_search(tiny.out, found, rows)) << tiny.out;
  EXPECT_NEAR(std::stod(found[1].str()) / 1e-90, 1, 0.1);
  EXPECT_EQ(exact.find(found[2].str()), 0U);
  EXPECT_EQ(exact.find(found[4].str(), slash), slash + 1);
  EXPECT_EQ(std::stoul(found[5].str()), exact.size() - 1);
}

TEST_F(CliTest, StepMakesDecimalsExact) {
  put("decimal.off", cube("0.1", "0.3"));
  const Outcome r = run({"info", "decimal.off", "--step", "1/1000", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.json()["volume"], "1/125");
  EXPECT_EQ(r.json()["step"], "1/1000");
}

}  // namespace
}  // namespace quoin::cli_test
