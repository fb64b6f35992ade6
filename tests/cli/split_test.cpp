#include "tests/cli/support.h"

namespace quoin::cli_test {
namespace {

TEST_F(CliTest, SplitTakesNegativeCoefficients) {
  const std::vector<Words> planes = {
      {"--plane", "-1,0,0,1/4"}, {"--plane=-1,0,0,1/4"}, {"--plane", "-.5,0,0,0.125"}, {"--plane", "-4e0,0,0,+1"}};
  for (const auto& plane : planes) {
    Words words = {"split", "a.off"};
    words.insert(words.end(), plane.begin(), plane.end());
    for (const char* word : {"-o", "above.quoin", "below.quoin", "--json"}) words.push_back(word);
    const Outcome r = run(words);
    // x < 1/4 is above.
    ASSERT_EQ(r.code, 0) << plane.back() << ": " << r.err;
    const Json object = r.json();
    expect_keys(object["above"], info_keys);
    expect_keys(object["below"], info_keys);
    expect_keys(object, {"seconds", "cpu_seconds", "peak_rss_bytes", "max_snap"});
    EXPECT_EQ(object["above"]["volume"], "1/4") << plane.back();
    EXPECT_EQ(object["below"]["volume"], "3/4") << plane.back();
  }
}

TEST_F(CliTest, SplitRefusesWhatIsNoPlane) {
  for (const char* plane : {"1,0,0", "1,0,0,0,0", "1,0,x,0", "0,0,0,1", "0/3,-0.0,0e9,1", "1/0,0,0,1", "1,,0,0", ""}) {
    const Outcome r = run({"split", "a.off", "--plane", plane, "-o", "above.stl", "below.stl", "--json"});
    expect_error(r, 2, "usage");
  }
  EXPECT_EQ(names(), (std::set<std::string>{"a.off", "b.off"}));
}

TEST_F(CliTest, SplitIntoOneFileByTwoNamesIsRefused) {
  const std::string precious = cube("0", "3");
  put("old.off", precious);
  const auto path = [&](const std::string& name) { return folder() / name; };
  std::filesystem::create_hard_link(path("old.off"), path("hard.off"));
  std::filesystem::create_symlink("old.off", path("soft.off"));
  std::filesystem::create_symlink("soft.off", path("softer.off"));
  std::filesystem::create_symlink("new.off", path("dangling.off"));
  std::filesystem::create_directory(path("sub"));
  std::filesystem::create_directory_symlink("sub", path("other"));
  const auto before = names();
  const std::vector<std::array<std::string, 2>> pairs = {
      {"new.off", "./new.off"},      {"new.off", path("new.off").string()},
      {"sub/../new.off", "new.off"}, {"sub/new.off", "other/new.off"},
      {"old.off", "hard.off"},       {"hard.off", "softer.off"},
      {"soft.off", "old.off"},       {"dangling.off", "new.off"},
      {"new.off", "./dangling.off"}};
  for (const auto& [above, below] : pairs) {
    const Outcome r = run({"split", "a.off", "--plane", "1,0,0,-1/2", "-o", above, below, "--json"});
    expect_error(r, 2, "usage");
    EXPECT_EQ(names(), before) << above << " " << below;
    EXPECT_EQ(get("old.off"), precious);
    EXPECT_TRUE(std::filesystem::is_empty(path("sub")));
  }
  EXPECT_EQ(run({"split", "a.off", "--plane", "1,0,0,-1/2", "-o", "sub/new.off", "new.off"}).code, 0);
  expect_error(run({"split", "a.off", "--plane", "1,0,0,0", "-o", "no/a.off", "nor/a.off", "--json"}), 1, "unwritable",
               "no/a.off");
}

}  // namespace
}  // namespace quoin::cli_test
