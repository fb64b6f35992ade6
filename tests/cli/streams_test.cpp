// What the program says agrees with what is on disk, whatever happens to the standard streams.
#include "tests/cli/support.h"

namespace quoin::cli_test {
namespace {

class Streams : public CliTest {
 protected:
  /// Runs a line of shell in the folder; "$q" is the program.
  int shell(const std::string& line) {
    ::setenv("q", program_path().c_str(), 1);
    const int status = std::system(("cd '" + folder().string() + "' && " + line).c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
};

TEST_F(Streams, AFullOutputAfterTheFileIsWritten) {
  for (const char* json : {"", " --json"}) {
    std::filesystem::remove(folder() / "out.off");
    EXPECT_EQ(shell(std::string("\"$q\" union a.off b.off -o out.off") + json + " > /dev/full 2> err"), 1);
    EXPECT_EQ(get("err"),
              "quoin: cannot write to standard output: No space left on device, but this is written: out.off "
              "[unwritable]\n");
    EXPECT_NE(get("out.off"), "");
  }
}

TEST_F(Streams, ClosedOutput) {
  EXPECT_EQ(shell("\"$q\" union a.off b.off -o out.off >&- 2> err"), 1);
  EXPECT_NE(get("err").find("Bad file descriptor, but this is written: out.off [unwritable]"), std::string::npos);
  EXPECT_EQ(shell("\"$q\" union a.off b.off -o out2.off --quiet >&- 2> err"), 0);
  EXPECT_EQ(get("err"), "");
  EXPECT_EQ(get("out.off"), get("out2.off"));
  EXPECT_EQ(shell("\"$q\" info a.off >&- 2> err"), 1);
  EXPECT_NE(get("err").find("Bad file descriptor [unwritable]"), std::string::npos);
}

// The next file would get the number of a closed stream: messages must not go there.
TEST_F(Streams, ClosedStreamsAreNotWrittenInto) {
  put("two.off", one_body_inside_out());
  ASSERT_EQ(run({"convert", "two.off", "-o", "plain.off"}).code, 0);
  EXPECT_EQ(shell("\"$q\" convert two.off -o out.off <&- >&- 2>&-"), 1);
  EXPECT_EQ(get("out.off"), get("plain.off"));
  EXPECT_EQ(shell("\"$q\" info - --format off <&- > out 2> err"), 1);
  EXPECT_NE(get("err").find("[unreadable]"), std::string::npos) << get("err");
}

TEST_F(Streams, TheSecondFileOfASplitFails) {
  std::filesystem::create_directory(folder() / "below.off.d");
  std::filesystem::create_symlink("nowhere/below.off", folder() / "below.off");
  const Outcome r = run({"split", "a.off", "--plane", "0,0,2,-1", "-o", "above.off", "below.off", "--json"});
  expect_error(r, 1, "unwritable", "below.off");
  EXPECT_EQ(r.json()["error"]["written"], Json({"above.off"}));
  EXPECT_NE(r.err.find(", but this is written: above.off"), std::string::npos) << r.err;
  EXPECT_TRUE(names().count("above.off"));
}

}  // namespace
}  // namespace quoin::cli_test
