// Small input that asks for much is refused, and named is what would let it in.
#include "tests/cli/support.h"

namespace quoin::cli_test {
namespace {

std::string model(const std::string& node) { return "{\"quoin-model\": 1, \"model\": " + node + "}"; }

TEST_F(CliTest, WhatIsTooLargeNamesTheLimit) {
  put("ball.json", model(R"({"sphere": {"radius": 1, "sides": 1000000}})"));
  put("dots.json", model(R"({"tangent-sphere": {"radius": 1, "planes": 65536}})"));
  put("long.json", model("{\"block\": {\"size\": [" + std::string(1000000, '7') + ", 1, 1]}}"));
  const auto before = names();
  for (const auto& [file, limit] : {std::array{"ball.json", "\"sides\" allows: 65000"},
                                    {"dots.json", "\"sides\" allows: 65000"},
                                    {"long.json", "\"digits\" allows: 4000"}}) {
    const Outcome r = run({"eval", file, "-o", "out.off", "--json"});
    expect_error(r, 1, "too-large", file);
    EXPECT_NE(r.err.find(limit), std::string::npos) << r.err;
  }
  EXPECT_EQ(names(), before);
}

TEST_F(CliTest, ADeviceWithoutEndIsRefused) {
  const Outcome r = run({"info", "/dev/urandom", "--format", "stl", "--limits", "stream-bytes=10000000", "--json"});
  expect_error(r, 1, "too-large", "/dev/urandom");
  EXPECT_NE(r.err.find("\"stream-bytes\" allows: 10000000"), std::string::npos) << r.err;
  // Zeros are not read until a limit is met.
  expect_error(run({"info", "/dev/zero", "--format", "stl", "--limits", "none", "--json"}), 1, "unknown-format",
               "/dev/zero");
}

// A file of a terabyte that takes no room is judged by its size.
TEST_F(CliTest, AFileIsJudgedByItsSize) {
  put("sparse.off", cube("0", "1"));
  std::filesystem::resize_file(folder() / "sparse.off", std::uintmax_t{1} << 40);
  expect_error(run({"info", "sparse.off", "--json"}), 1, "too-large", "sparse.off");
}

TEST_F(CliTest, LimitsAreSet) {
  put("ball.json", model(R"({"sphere": {"radius": 1, "sides": 8}})"));
  const auto eval = [&](const std::string& limits) {
    return run({"eval", "ball.json", "-o", "out.off", "--limits", limits, "--json"});
  };
  expect_error(eval("sides=31"), 1, "too-large", "ball.json");
  for (const char* limits : {"sides=32", "none", "sides=none", "bytes=1000,sides=31,sides=32"})
    EXPECT_EQ(eval(limits).json()["faces"], 32) << limits;
  for (const char* limits : {"", "sides", "sides=", "sides=-1", "sides=1.5", "corners=3", "sides=3,", "none,sides=3"})
    expect_error(eval(limits), 2, "usage");
  expect_error(run({"info", "a.off", "--limits", "vertices=7", "--json"}), 1, "too-large", "a.off");
  EXPECT_EQ(run({"--limits", "vertices=8", "info", "a.off"}).code, 0);
}

TEST_F(CliTest, ModelsNameFilesOfTheirFolderOnly) {
  std::filesystem::create_directories(folder() / "home" / "below");
  put("home/below/in.off", cube("0", "2"));
  std::filesystem::create_symlink("../a.off", folder() / "home" / "link.off");
  std::filesystem::create_symlink("below/in.off", folder() / "home" / "near.off");
  const auto eval = [&](const std::string& file, const Words& more = {}) {
    put("home/model.json", model("{\"mesh\": {\"file\": \"" + file + "\"}}"));
    Words words = {"eval", "home/model.json", "-o", "out.off", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  };
  for (const char* file : {"below/in.off", "./below/in.off", "near.off"})
    EXPECT_EQ(eval(file).json()["volume"], "8") << file;

  const std::string absolute = (folder() / "a.off").string();
  for (const std::string& file :
       {std::string("../a.off"), std::string("below/../../a.off"), absolute, std::string("link.off")}) {
    const Outcome r = eval(file);
    expect_error(r, 1, "bad-model", "home/model.json");
    EXPECT_EQ(r.json()["error"]["where"], "line 1, column " + std::to_string(48 + file.size()));
    EXPECT_EQ(eval(file, {"--any-path"}).json()["volume"], "1") << file;
  }
  expect_error(eval("below/in.off\\u0000.stl"), 1, "bad-model", "home/model.json");
  expect_error(eval("below/in.off\\u0000.stl", {"--any-path"}), 1, "bad-model", "home/model.json");
  expect_error(eval("none.off"), 1, "missing-file", "home/none.off");
}

}  // namespace
}  // namespace quoin::cli_test
