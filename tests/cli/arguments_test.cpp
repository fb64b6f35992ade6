// Words that any command may be given.
#include <sstream>

#include "quoin/format.h"
#include "tests/cli/support.h"

namespace quoin::cli_test {
namespace {

constexpr std::array<const char*, 11> all_commands = {
    "union", "intersection", "difference", "symmetric-difference", "complement", "split", "move", "eval",
    "info",  "check",        "convert"};

TEST_F(CliTest, VersionAndHelp) {
  const Outcome version = run({"--version"});
  EXPECT_EQ(version.code, 0);
  for (const char* word : {"quoin ", "commit ", "compiler ", "format "}) {
    EXPECT_NE(version.out.find(word), std::string::npos) << word;
  }
  expect_keys(run({"--version", "--json"}).json(), {"version", "commit", "compiler", "format_version"});
  EXPECT_EQ(run({"union", "--version"}).out, version.out);
  const Outcome help = run({"--help"});
  EXPECT_EQ(help.code, 0);
  for (const char* command : all_commands) {
    EXPECT_NE(help.out.find(command), std::string::npos) << command;
    const Outcome one = run({command, "--help"});
    EXPECT_EQ(one.code, 0) << command;
    EXPECT_NE(one.out.find("Examples:"), std::string::npos) << command;
  }
}

TEST_F(CliTest, HelpLinesHave120Columns) {
  std::vector<Words> calls = {{"--help"}};
  for (const char* command : all_commands) calls.push_back({command, "--help"});
  for (const Words& call : calls) {
    std::istringstream lines(run(call).out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120u) << line;
  }
}

TEST_F(CliTest, HelpSaysWhereTrustChangesNothing) {
  for (const char* command : all_commands) {
    const bool proves = std::string(command) == "eval" || std::string(command) == "check";
    const std::string help = run({command, "--help"}).out;
    EXPECT_EQ(help.find("Changes nothing here") != std::string::npos, proves) << command;
    EXPECT_EQ(help.find("Skip the proof") == std::string::npos, proves) << command;
  }
}

TEST_F(CliTest, HelpAndErrorsListTheFormats) {
  const std::string help = run({"--help"}).out, one = run({"convert", "--help"}).out;
  const std::string refused = run({"info", "a.off", "--format", "dwg"}).err;
  for (const FormatInfo& info : formats()) {
    EXPECT_NE(help.find(std::string(info.extension)), std::string::npos) << info.name;
    EXPECT_NE(one.find(std::string(info.name)), std::string::npos) << info.name;
    EXPECT_NE(refused.find(std::string(info.name)), std::string::npos) << info.name;
  }
}

TEST_F(CliTest, WrongArgumentsAreExitCodeTwo) {
  const std::vector<Words> wrong = {{},
                                    {"unite", "a.off", "b.off", "-o", "out.stl"},
                                    {"eval", "a.off"},
                                    {"union", "a.off", "-o", "out.stl"},
                                    {"union", "a.off", "b.off"},
                                    {"info"},
                                    {"info", "a.off", "b.off"},
                                    {"info", "a.off", "--bogus"},
                                    {"info", "a.off", "--threads", "-1"},
                                    {"info", "a.off", "--threads", "many"},
                                    {"info", "a.off", "--step", "0"},
                                    {"info", "a.off", "--step", "-1"},
                                    {"info", "a.off", "--step", "wide"},
                                    {"info", "a.off", "--format", "dwg"},
                                    {"convert", "a.off", "-o", "out.stl", "--output-topology", "other"},
                                    {"convert", "a.off", "-o", "out.stl", "-o", "two.stl"},
                                    {"split", "a.off", "--plane", "1,0,0,0", "-o", "out.stl"},
                                    {"split", "a.off", "--plane", "1,0,0,0", "-o", "out.stl", "out.stl"},
                                    {"split", "a.off", "-o", "one.stl", "two.stl"}};
  for (const auto& words : wrong) {
    const Outcome plain = run(words);
    EXPECT_EQ(plain.code, 2) << testing::PrintToString(words) << plain.err;
    EXPECT_EQ(plain.out, "");
    expect_sentence(plain, "usage");
    Words with_json = words;
    with_json.push_back("--json");
    expect_error(run(with_json), 2, "usage");
  }
  EXPECT_EQ(names(), (std::set<std::string>{"a.off", "b.off"}));
}

TEST_F(CliTest, StreamsThatCannotWorkAreUsageErrors) {
  expect_error(run({"info", "-", "--json"}, cube("0", "1")), 2, "usage");
  expect_error(run({"union", "-", "-", "-o", "out.stl", "--format", "off", "--json"}), 2, "usage");
  expect_error(run({"convert", "a.off", "-o", "-", "--format", "off", "--json"}), 2, "usage");
  const Words twice = {"split", "a.off", "--plane", "1,0,0,0", "-o", "-", "-", "--format", "off"};
  EXPECT_EQ(run(twice).code, 2);
}

TEST_F(CliTest, OptionsMayStandAnywhere) {
  const Outcome first = run({"--json", "union", "-o", "out.stl", "a.off", "b.off"});
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(first.json()["volume"], "15/8");
  const Outcome between = run({"union", "a.off", "-o", "out.stl", "b.off", "--json"});
  ASSERT_EQ(between.code, 0) << between.err;
  EXPECT_EQ(between.json()["volume"], "15/8");
}

TEST_F(CliTest, FileMayBeCalledLikeACommandOrAnOption) {
  put("union", cube("0", "1"));
  put("--json", cube("0", "1"));
  EXPECT_EQ(run({"union", "union", "a.off", "-o", "out.quoin", "--format", "off"}).code, 0);
  EXPECT_EQ(run({"check", "--quiet", "--format", "off", "--", "--json"}).code, 0);
}

}  // namespace
}  // namespace quoin::cli_test
