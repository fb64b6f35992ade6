#include "tests/cli/support.h"

namespace quoin::cli_test {
namespace {

TEST_F(CliTest, InterruptedRunLeavesNothingBehind) {
  for (const int signal : {SIGINT, SIGTERM}) {
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

}  // namespace
}  // namespace quoin::cli_test
