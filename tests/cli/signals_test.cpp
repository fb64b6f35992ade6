#include "tests/cli/support.h"

namespace quoin::cli_test {
namespace {

TEST_F(CliTest, InterruptedRunLeavesNothingBehind) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU}) {
    const auto before = names();
    std::array<int, 2> pipe = {};
    ASSERT_EQ(::pipe2(pipe.data(), O_CLOEXEC), 0);
    const pid_t child = start({"convert", "-", "-o", "out.stl", "--format", "off", "--json"}, pipe[0]);
    ::close(pipe[0]);
    // More than a pipe holds: once all is written the program is reading, and waits for the rest.
    const std::string text = "OFF\n" + std::string(std::size_t{4} << 20, ' ');
    std::size_t written = 0;
    while (written < text.size()) {
      const auto count = ::write(pipe[1], text.data() + written, text.size() - written);
      ASSERT_GT(count, 0);
      written += static_cast<std::size_t>(count);
    }
    ASSERT_EQ(::kill(child, signal), 0);
    const Outcome r = finish(child);
    ::close(pipe[1]);
    expect_error(r, 130, "cancelled");
    EXPECT_EQ(names(), before);
  }
}

// Signals without end while a file is written: no temporary file stays, and what the program says is what is there.
TEST_F(CliTest, SignalsWhileWritingLeaveNoTemporaryFile) {
  put("ball.json", R"({"quoin-model": 1, "model": {"sphere": {"radius": 1, "sides": 64}}})");
  for (int delay = 0; delay < 40; ++delay) {
    std::filesystem::remove(folder() / "out.stl");
    const auto before = names();
    const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    const pid_t child = start({"eval", "ball.json", "-o", "out.stl", "--quiet"}, nothing);
    ::close(nothing);
    ::usleep(static_cast<useconds_t>(delay) * 10000);
    for (int i = 0; i < 20; ++i) {
      ::kill(child, SIGTERM);
      ::usleep(200);
    }
    const Outcome r = finish(child);
    auto expected = before;
    // -1: the signal came before the handler.
    const bool is_written = r.code == 0 || r.err.find("is written") != std::string::npos;
    if (is_written) expected.insert("out.stl");
    EXPECT_EQ(names(), expected) << r.code << " " << r.err;
    EXPECT_TRUE(r.code == 130 || r.code == -1 || is_written) << r.code << " " << r.err;
  }
}

}  // namespace
}  // namespace quoin::cli_test
