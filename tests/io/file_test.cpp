#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "tests/io/io_support.h"

namespace quoin::io {
namespace {

namespace fs = std::filesystem;

/// A directory of its own for each test, removed behind it.
class File : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "quoin_io_XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    directory_ = pattern;
  }
  void TearDown() override { fs::remove_all(directory_); }

  std::string path(const std::string& name) const { return (directory_ / name).string(); }
  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory_), fs::directory_iterator()));
  }

  fs::path directory_;
};

std::string read_code(const std::string& path) {
  const Result<std::string> read = read_file(path);
  return read ? "" : to_string(read.error().code);
}

std::string write_code(const std::string& path, std::string_view bytes) {
  const Result<void> written = write_file(path, bytes);
  return written ? "" : to_string(written.error().code);
}

TEST_F(File, WritesAndReadsWholeFiles) {
  std::string bytes("a\0b\r\n", 5);
  bytes.append(300000, '\xff');
  for (const std::string& content : {bytes, std::string(), std::string("x")}) {
    ASSERT_EQ(write_code(path("a"), content), "");
    const Result<std::string> read = read_file(path("a"));
    ASSERT_TRUE(read);
    EXPECT_EQ(read.value(), content);
  }
  ASSERT_EQ(write_code(path("b"), "second output"), "");
  EXPECT_EQ(read_file(path("b")).value(), "second output");
  EXPECT_EQ(entries(), 2U);
}

TEST_F(File, TellsMissingFromUnreadable) {
  EXPECT_EQ(read_code(path("none")), "missing-file");
  EXPECT_EQ(read_code(path("none/below")), "missing-file");
  EXPECT_EQ(read_code(directory_.string()), "unreadable");
  const Result<std::string> read = read_file(path("none"));
  EXPECT_EQ(read.error().file, path("none"));
}

TEST_F(File, FailedWritesLeaveNothing) {
  EXPECT_EQ(write_code(path("none/below"), "x"), "unwritable");
  EXPECT_EQ(write_code(directory_.string(), "x"), "unwritable");
  EXPECT_EQ(write_code(path(std::string(300, 'n')), "x"), "unwritable");
  EXPECT_EQ(write_code("", "x"), "unwritable");
  EXPECT_EQ(entries(), 0U);
}

TEST_F(File, LongNamesAndPermissions) {
  const mode_t before = ::umask(027);
  EXPECT_EQ(write_code(path(std::string(255, 'n')), "x"), "");
  ::umask(before);
  struct stat status;
  ASSERT_EQ(::stat(path(std::string(255, 'n')).c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST_F(File, LinksStayLinks) {
  ASSERT_EQ(write_code(path("target"), "old"), "");
  fs::create_symlink("target", path("link"));
  ASSERT_EQ(write_code(path("link"), "new"), "");
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(read_file(path("target")).value(), "new");
}

// A link to what does not exist yet, through another link.
TEST_F(File, LinksToNothingAreFollowed) {
  fs::create_directory(directory_ / "below");
  fs::create_symlink("below/second", path("first"));
  fs::create_symlink("target", directory_ / "below" / "second");
  ASSERT_EQ(write_code(path("first"), "new"), "");
  EXPECT_TRUE(fs::is_symlink(path("first")));
  EXPECT_TRUE(fs::is_symlink(directory_ / "below" / "second"));
  EXPECT_EQ(read_file((directory_ / "below" / "target").string()).value(), "new");
}

TEST_F(File, HardLinksStayOneFile) {
  ASSERT_EQ(write_code(path("a"), "a long old text"), "");
  fs::create_hard_link(path("a"), path("b"));
  ASSERT_EQ(write_code(path("a"), "new"), "");
  EXPECT_TRUE(fs::equivalent(path("a"), path("b")));
  EXPECT_EQ(read_file(path("b")).value(), "new");
  ASSERT_EQ(write_code(path("b"), std::string(100000, 'x')), "");
  EXPECT_EQ(read_file(path("a")).value(), std::string(100000, 'x'));
  EXPECT_EQ(entries(), 2U);
}

TEST_F(File, PermissionsAndOwnerStay) {
  ASSERT_EQ(write_code(path("a"), "old"), "");
  const bool may_give_away = ::chown(path("a").c_str(), 12345, 54321) == 0;
  ASSERT_EQ(::chmod(path("a").c_str(), 04751), 0);
  ASSERT_EQ(write_code(path("a"), "new"), "");
  struct stat status;
  ASSERT_EQ(::stat(path("a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777U, 04751U);
  if (may_give_away) {
    EXPECT_EQ(status.st_uid, 12345U);
    EXPECT_EQ(status.st_gid, 54321U);
  }
  EXPECT_EQ(read_file(path("a")).value(), "new");
  EXPECT_EQ(entries(), 1U);
}

/// As somebody else: 0 unless the process may not become that.
int as_nobody(const std::string& path) {
  if (::geteuid() == 0 && ::setuid(65534) != 0) return 0;
  return write_code(path, "new") == "" ? 7 : 8;
}

// The folder belongs to others, the file may be written by all; and a file that nobody may write to.
TEST_F(File, PermissionsOfTheFileCount) {
  ASSERT_EQ(write_code(path("open"), "old"), "");
  ASSERT_EQ(write_code(path("closed"), "old"), "");
  ASSERT_EQ(::chmod(path("open").c_str(), 0666), 0);
  ASSERT_EQ(::chmod(path("closed").c_str(), 0444), 0);
  ASSERT_EQ(::chmod(directory_.c_str(), 0555), 0);
  EXPECT_EXIT(::_exit(as_nobody(path("open"))), ::testing::ExitedWithCode(7), "");
  ASSERT_EQ(::chmod(directory_.c_str(), 0777), 0);
  EXPECT_EXIT(::_exit(as_nobody(path("closed"))), ::testing::ExitedWithCode(8), "");
  EXPECT_EQ(read_file(path("open")).value(), "new");
  EXPECT_EQ(read_file(path("closed")).value(), "old");
  EXPECT_EQ(entries(), 2U);
}

TEST_F(File, NoByteZeroEndsAName) {
  ASSERT_EQ(write_code(path("a"), "old"), "");
  const std::string longer = path("a") + std::string("\0.off", 5);
  EXPECT_EQ(read_code(longer), "missing-file");
  EXPECT_EQ(write_code(longer, "new"), "unwritable");
  EXPECT_EQ(read_file(path("a")).value(), "old");
}

TEST_F(File, BytesAreLimited) {
  ASSERT_EQ(write_code(path("a"), "1234"), "");
  Limits limits;
  limits.bytes = 4;
  EXPECT_EQ(read_file(path("a"), limits).value(), "1234");
  limits.bytes = 3;
  const Result<std::string> read = read_file(path("a"), limits);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::too_large);
  EXPECT_EQ(read.error().message, "the file has more bytes than the limit \"bytes\" allows: 3");
  EXPECT_EQ(read.error().file, path("a"));
  limits.stream_bytes = 1000000;
  const Result<std::string> stream = read_file("/dev/urandom", limits);
  ASSERT_FALSE(stream);
  EXPECT_EQ(stream.error().message, "the file has more bytes than the limit \"stream-bytes\" allows: 1000000");
}

// A binary STL without facets is 84 zeros and less than the 50 bytes of a facet; a stream of more is not read on.
TEST_F(File, AStreamOfZerosIsNotReadToItsEnd) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const auto read_through = [&](const std::string& bytes) {
    std::thread writer([&] {
      const int number = ::open(path("pipe").c_str(), O_WRONLY);
      for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t put = ::write(number, bytes.data() + at, std::min<std::size_t>(bytes.size() - at, 100));
        if (put < 0) break;
        at += static_cast<std::size_t>(put);
      }
      ::close(number);
    });
    Result<std::string> read = read_file(path("pipe"));
    writer.join();
    return read;
  };
  const auto ignored = std::signal(SIGPIPE, SIG_IGN);
  for (const std::size_t zeros : {0u, 84u, 133u}) {
    const std::string bytes(zeros, '\0');
    EXPECT_EQ(read_through(bytes).value(), bytes);
    EXPECT_EQ(read_through(bytes + "x" + std::string(1000, '\0')).value(), bytes + "x" + std::string(1000, '\0'));
  }
  for (const std::size_t zeros : {134u, 1000000u}) {
    const Result<std::string> read = read_through(std::string(zeros, '\0'));
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::unknown_format);
    EXPECT_EQ(read.error().file, path("pipe"));
  }
  (void)std::signal(SIGPIPE, ignored);

  Limits limits;
  limits.stream_bytes = UINT64_MAX;
  EXPECT_EQ(read_file("/dev/zero", limits).error().code, ErrorCode::unknown_format);
  ASSERT_EQ(write_code(path("zeros"), std::string(1000, '\0')), "");
  EXPECT_EQ(read_file(path("zeros")).value(), std::string(1000, '\0'));
}

TEST_F(File, PipesAreWrittenThrough) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const int reader = ::open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  EXPECT_EQ(write_code(path("pipe"), "through"), "");
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
  std::string got(100, '?');
  const ssize_t size = ::read(reader, got.data(), got.size());
  ::close(reader);
  ASSERT_EQ(size, 7);
  EXPECT_EQ(got.substr(0, 7), "through");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(File, StandardStreams) {
  ASSERT_EQ(write_code(path("in"), "from standard input"), "");
  const int out = ::dup(STDOUT_FILENO);
  const int in = ::dup(STDIN_FILENO);
  ASSERT_NE(std::freopen(path("in").c_str(), "r", stdin), nullptr);
  std::fflush(stdout);
  std::FILE* sink = std::fopen(path("out").c_str(), "w");
  ASSERT_NE(sink, nullptr);
  ASSERT_GE(::dup2(::fileno(sink), STDOUT_FILENO), 0);
  const Result<std::string> read = read_file("-");
  const std::string code = write_code("-", "to standard output");
  ASSERT_GE(::dup2(out, STDOUT_FILENO), 0);
  if (in >= 0) ::dup2(in, STDIN_FILENO);
  std::fclose(sink);
  ASSERT_TRUE(read);
  EXPECT_EQ(read.value(), "from standard input");
  EXPECT_EQ(code, "");
  EXPECT_EQ(read_file(path("out")).value(), "to standard output");
}

TEST_F(File, ThreadsWriteTheirOwnFiles) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([this, i] {
      for (int round = 0; round < 20; ++round) {
        EXPECT_EQ(write_code(path("t" + std::to_string(i)), std::string(1000, static_cast<char>('a' + i))), "");
        EXPECT_EQ(write_code(path("shared"), std::string(1000, static_cast<char>('a' + i))), "");
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(entries(), 5U);
  const std::string shared = read_file(path("shared")).value();
  EXPECT_EQ(shared, std::string(1000, shared[0]));
}

TEST_F(File, ACancelledWriteLeavesTheOldFile) {
  ASSERT_EQ(write_code(path("a"), "old"), "");
  const Cancel cancel = true;
  const Result<void> written = write_file(path("a"), "new", &cancel);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::cancelled);
  EXPECT_EQ(entries(), 1U);
  EXPECT_EQ(read_file(path("a")).value(), "old");
}

// A pipe that nobody empties holds 64 kB: the write waits, until a signal asks whether it was cancelled.
TEST_F(File, AWriteThatWaitsIsCancelledByASignal) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const int reader = ::open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  ASSERT_GE(reader, 0);
  static Cancel cancel;
  cancel = false;
  struct sigaction action = {}, before = {};
  action.sa_handler = [](int) { cancel = true; };
  ASSERT_EQ(::sigaction(SIGUSR1, &action, &before), 0);

  std::atomic<bool> ended = false;
  Result<void> written;
  std::thread writer([&] {
    written = write_file(path("pipe"), std::string(std::size_t{1} << 20, 'x'), &cancel);
    ended = true;
  });
  while (!ended) {
    ::pthread_kill(writer.native_handle(), SIGUSR1);
    std::this_thread::yield();
  }
  writer.join();
  ::sigaction(SIGUSR1, &before, nullptr);
  ::close(reader);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::cancelled);
}

[[noreturn]] void write_on_a_full_disk(const std::string& path) {
  (void)std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit = {4096, 4096};
  (void)::setrlimit(RLIMIT_FSIZE, &limit);
  ::_exit(write_code(path, std::string(100000, 'x')) == "unwritable" ? 7 : 8);
}

TEST_F(File, AFullDiskLeavesTheOldFileOfTwoNames) {
  ASSERT_EQ(write_code(path("a"), "old"), "");
  fs::create_hard_link(path("a"), path("b"));
  EXPECT_EXIT(write_on_a_full_disk(path("a")), ::testing::ExitedWithCode(7), "");
  EXPECT_EQ(entries(), 2U);
  EXPECT_EQ(read_file(path("b")).value(), "old");
}

TEST_F(File, AFullDiskLeavesTheOldFile) {
  ASSERT_EQ(write_code(path("a"), "old"), "");
  EXPECT_EXIT(write_on_a_full_disk(path("a")), ::testing::ExitedWithCode(7), "");
  EXPECT_EQ(entries(), 1U);
  EXPECT_EQ(read_file(path("a")).value(), "old");
}

}  // namespace
}  // namespace quoin::io
