/// \file
/// Runs the program `quoin` as a script does, and makes the files it reads.
#pragma once

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

namespace quoin::cli_test {

/// What a run of the program left.
struct Outcome {
  /// The exit code; -1 if a signal ended it.
  int code = -1;
  std::string out, err;

  /// stdout as one JSON object; fails the test if it is anything else.
  nlohmann::json json() const {
    auto object = nlohmann::json::parse(out, nullptr, false);
    EXPECT_TRUE(object.is_object()) << "stdout: " << out << "\nstderr: " << err;
    return object;
  }
};

/// Path of the program: environment variable QUOIN_CLI, otherwise what the build says.
inline std::string program_path() {
  if (const char* path = std::getenv("QUOIN_CLI")) return path;
#ifdef QUOIN_CLI
  return QUOIN_CLI;
#else
  return "quoin";
#endif
}

inline std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// An OFF file of the axis-parallel cube from (low, low, low) to (high, high, high), as decimals.
inline std::string cube(const std::string& low, const std::string& high) {
  std::string text = "OFF\n8 6 0\n";
  for (int i = 0; i < 8; ++i) {
    const auto at = [&](int bit) { return (i >> bit) & 1 ? high : low; };
    text += at(0) + " " + at(1) + " " + at(2) + "\n";
  }
  return text + "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
}

/// A folder of its own for each test, with two cubes that share an eighth: a.off = [0, 1]^3, b.off = [1/2, 3/2]^3.
class CliTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "quoin-cli-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    base_ = name;
    folder_ = base_ / "work";
    std::filesystem::create_directory(folder_);
    put("a.off", cube("0", "1"));
    put("b.off", cube("0.5", "1.5"));
  }

  void TearDown() override { std::filesystem::remove_all(base_); }

  void put(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  const std::filesystem::path& folder() const { return folder_; }

  std::string get(const std::string& name) const { return contents(folder_ / name); }

  /// Names in the folder.
  std::set<std::string> names() const {
    std::set<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) found.insert(entry.path().filename());
    return found;
  }

  /// Runs the program in the folder with `input` as its stdin; files may not grow beyond `file_limit` bytes unless 0.
  Outcome run(const std::vector<std::string>& words, const std::string& input = "", rlim_t file_limit = 0) {
    const auto in = base_ / "in";
    std::ofstream(in, std::ios::binary) << input;
    const int descriptor = ::open(in.c_str(), O_RDONLY | O_CLOEXEC);
    const pid_t child = start(words, descriptor, file_limit);
    ::close(descriptor);
    return finish(child);
  }

  /// Starts the program with an open descriptor as its stdin.
  pid_t start(const std::vector<std::string>& words, int input, rlim_t file_limit = 0) {
    const std::string program = program_path();
    std::vector<char*> arguments = {const_cast<char*>(program.c_str())};
    for (const auto& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);

    const auto out = base_ / "out", err = base_ / "err";
    const pid_t child = ::fork();
    if (child != 0) return child;

    const auto redirect = [](const std::filesystem::path& path, int target) {
      return ::dup2(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), target) >= 0;
    };
    const rlimit limit = {file_limit, file_limit};
    const bool ready = ::chdir(folder_.c_str()) == 0 && ::dup2(input, STDIN_FILENO) >= 0 &&
                       redirect(out, STDOUT_FILENO) && redirect(err, STDERR_FILENO) &&
                       (file_limit == 0 || ::setrlimit(RLIMIT_FSIZE, &limit) == 0);
    if (ready) ::execvp(program.c_str(), arguments.data());
    ::_exit(127);
  }

  /// Waits for the end.
  Outcome finish(pid_t child) {
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(base_ / "out"), contents(base_ / "err")};
  }

 private:
  std::filesystem::path base_, folder_;
};

}  // namespace quoin::cli_test
