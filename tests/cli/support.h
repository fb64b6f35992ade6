/// \file
/// What the tests of all commands ask of a run of the program.
#pragma once

#include <regex>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace quoin::cli_test {

using Words = std::vector<std::string>;
using Json = nlohmann::json;

/// The members that describe a solid.
inline const std::vector<std::string> info_keys = {"vertices",    "edges",         "faces",    "triangles", "shells",
                                                   "genus",       "closed",        "manifold", "bounded",   "volume",
                                                   "area_approx", "volume_approx", "box",      "step"};

inline void expect_keys(const Json& object, const std::vector<std::string>& keys) {
  for (const auto& key : keys) EXPECT_TRUE(object.contains(key)) << key << " is missing in " << object;
}

/// One sentence on stderr, `quoin: ... [code]`, nothing else there.
inline void expect_sentence(const Outcome& run, const std::string& code) {
  EXPECT_TRUE(std::regex_match(run.err, std::regex("quoin: [^\n]+ \\[" + code + "\\]\n"))) << run.err;
}

/// A refusal: exit code, sentence on stderr, error object on stdout.
inline void expect_error(const Outcome& run, int exit_code, const std::string& code, const std::string& file = "") {
  EXPECT_EQ(run.code, exit_code) << run.err;
  expect_sentence(run, code);
  const Json object = run.json();
  ASSERT_TRUE(object.contains("error")) << object;
  EXPECT_EQ(object.size(), object.contains("findings") ? 2U : 1U);
  const Json& error = object["error"];
  expect_keys(error, {"code", "message", "file", "where"});
  EXPECT_EQ(error["code"], code);
  EXPECT_EQ(error["file"], file);
  EXPECT_NE(error["message"], "");
}

/// Two cubes as one OFF file, the second one inside out.
inline std::string one_body_inside_out() {
  const std::string faces = "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
  const std::string turned = "4 9 11 10 8\n4 14 15 13 12\n4 12 13 9 8\n4 11 15 14 10\n4 10 14 12 8\n4 13 15 11 9\n";
  const auto points = [](const std::string& text) { return text.substr(10, text.find("4 0 2 3 1") - 10); };
  return "OFF\n16 12 0\n" + points(cube("0", "2")) + points(cube("3.5", "4")) + faces + turned;
}

}  // namespace quoin::cli_test
