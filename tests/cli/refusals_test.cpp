// What is refused leaves files and standard output as they were.
#include "tests/cli/support.h"

namespace quoin::cli_test {
namespace {

TEST_F(CliTest, RefusedInputLeavesNothingBehind) {
  put("out.stl", "precious");
  put("broken.off", cube("0", "1").substr(0, 40));
  put("part.xyz", "no one knows");
  const auto before = names();
  expect_error(run({"union", "a.off", "missing.stl", "-o", "out.stl", "--json"}), 1, "missing-file", "missing.stl");
  expect_error(run({"union", "a.off", "part.xyz", "-o", "out.stl", "--json"}), 1, "unknown-format", "part.xyz");
  const Outcome broken = run({"union", "a.off", "broken.off", "-o", "out.stl", "--json"});
  EXPECT_EQ(broken.code, 1);
  EXPECT_EQ(broken.json()["error"]["file"], "broken.off");
  EXPECT_EQ(names(), before);
  EXPECT_EQ(get("out.stl"), "precious");
}

TEST_F(CliTest, OutputThatCannotBeWrittenIsRefused) {
  const auto before = names();
  expect_error(run({"convert", "a.off", "-o", "nowhere/out.stl", "--json"}), 1, "unwritable", "nowhere/out.stl");
  expect_error(run({"convert", "a.off", "-o", "out.xyz", "--json"}), 1, "unknown-format", "out.xyz");
  EXPECT_EQ(names(), before);
}

TEST_F(CliTest, HalfWrittenOutputNeverAppears) {
  const auto before = names();
  // A binary STL of two cubes' union needs more than 1024 bytes.
  const Outcome r = run({"union", "a.off", "b.off", "-o", "out.stl", "--json"}, "", 1024);
  expect_error(r, 1, "unwritable", "out.stl");
  EXPECT_EQ(names(), before);
}

TEST_F(CliTest, ErrorsWithoutJsonKeepStdoutEmpty) {
  const Outcome r = run({"info", "missing.stl"});
  EXPECT_EQ(r.code, 1);
  EXPECT_EQ(r.out, "");
  expect_sentence(r, "missing-file");
  EXPECT_NE(r.err.find("(missing.stl"), std::string::npos) << r.err;
}

TEST_F(CliTest, FileNamesThatAreNotTextStayPrintable) {
  expect_error(run({"info", "no\xff\n.stl", "--json"}), 1, "missing-file", "no\xEF\xBF\xBD\n.stl");
}

}  // namespace
}  // namespace quoin::cli_test
