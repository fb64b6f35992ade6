// Every call for memory may fail, and every thread: the program ends with a sentence, or succeeds.
#include "tests/cli/support.h"

namespace quoin::cli_test {
namespace {

#ifdef QUOIN_FAULTS

class Faults : public CliTest {
 protected:
  void TearDown() override {
    for (const char* name :
         {"LD_PRELOAD", "QUOIN_FAULT_MEMORY", "QUOIN_FAULT_REST", "QUOIN_FAULT_THREADS", "QUOIN_FAULT_CALLED"})
      ::unsetenv(name);
    CliTest::TearDown();
  }

  /// The outcome with the settings of tests/faults/shim.cpp.
  Outcome run_with(const std::vector<std::pair<std::string, std::string>>& faults, const Words& words) {
    for (const auto& [name, value] : faults) ::setenv(("QUOIN_FAULT_" + name).c_str(), value.c_str(), 1);
    ::setenv("LD_PRELOAD", QUOIN_FAULTS, 1);
    const Outcome r = run(words);
    ::unsetenv("LD_PRELOAD");
    return r;
  }

  struct Fault {
    Words words;
    std::string output;
    bool rest;  // all calls behind it fail, too
  };

  /// The n-th call fails. Is there one?
  bool ends_cleanly(const Fault& fault, std::size_t n, std::size_t& failures) {
    const auto& [words, output, rest] = fault;
    if (!output.empty()) std::filesystem::remove(folder() / output);
    auto expected = names();
    const std::filesystem::path called = folder().parent_path() / "called";
    // Inherited by the program.
    const int told = ::open(called.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const std::string count = std::to_string(n);
    const Outcome r =
        run_with({{"MEMORY", count}, {"REST", rest ? "1" : "0"}, {"CALLED", std::to_string(told)}}, words);
    ::close(told);

    SCOPED_TRACE(words[0] + ", call " + count + ": " + r.err);
    EXPECT_TRUE(r.code == 0 || r.code == 1) << r.code;
    const bool is_written = r.code == 0 || r.err.find("quoin: the output is written, but: ") != std::string::npos;
    if (is_written && !output.empty()) expected.insert(output);
    EXPECT_EQ(names(), expected);
    if (r.code == 1) {
      EXPECT_TRUE(r.err.ends_with(" [out-of-memory]\n"));
      ++failures;
    }
    if (!is_written) {
      EXPECT_EQ(r.json()["error"]["code"], "out-of-memory");
    } else if (r.code == 0) {
      EXPECT_FALSE(r.json().contains("error"));
    }
    return std::filesystem::file_size(called) != 0;
  }

  /// Every `step`-th call fails, until there is no such call; then each of the last ones, behind the answer too.
  void expect_a_clean_end(const Words& words, const std::string& output, bool rest, std::size_t step) {
    const Fault fault{words, output, rest};
    std::size_t failures = 0, n = 1;
    while (ends_cleanly(fault, n, failures) && !HasFailure()) n += step;
    constexpr std::size_t last_ones = 100;
    for (std::size_t i = 1; i < last_ones + step && i < n && !HasFailure(); ++i) ends_cleanly(fault, n - i, failures);
    EXPECT_GT(failures, 300 / step) << words[0];
  }
};

TEST_F(Faults, EveryCallForMemoryMayFail) {
  put("cut.json", R"({"quoin-model": 1, "model": {"difference": [{"block": {"size": [3, 3, 3]}},
    {"rotate": {"axis": "z", "angle": 30, "of": {"cylinder": {"radius": 1, "height": 2, "sides": 5}}}}]}})");
  ASSERT_EQ(run({"convert", "a.off", "-o", "a.quoin"}).code, 0);
  expect_a_clean_end({"union", "a.off", "b.off", "-o", "out.off", "--json"}, "out.off", false, 5);
  expect_a_clean_end({"eval", "cut.json", "-o", "out.stl", "--json"}, "out.stl", false, 29);
  expect_a_clean_end({"difference", "a.quoin", "b.off", "-o", "out.quoin", "--json"}, "out.quoin", false, 13);
  expect_a_clean_end({"move", "a.off", "--rotate", "x", "30", "-o", "out.ply", "--json"}, "out.ply", false, 31);
  expect_a_clean_end({"complement", "a.off", "-o", "out.quoin", "--json"}, "out.quoin", false, 13);
  expect_a_clean_end({"info", "a.quoin", "--json"}, "", false, 13);
  expect_a_clean_end({"check", "b.off", "--json"}, "", false, 13);
  expect_a_clean_end({"union", "a.off", "b.off", "-o", "out.off", "--json"}, "out.off", true, 23);
  expect_a_clean_end({"eval", "cut.json", "-o", "out.stl", "--json"}, "out.stl", true, 101);
}

// Any of these models would take millions of calls, or numbers of millions of digits.
TEST_F(Faults, WhatIsTooLargeIsRefusedBeforeItsWork) {
  const auto model = [](const std::string& node) { return "{\"quoin-model\": 1, \"model\": " + node + "}"; };
  put("ball.json", model(R"({"sphere": {"radius": 1, "sides": 1000000}})"));
  put("dots.json", model(R"({"tangent-sphere": {"radius": 1, "planes": 65536}})"));
  put("long.json", model("{\"block\": {\"size\": [" + std::string(1000000, '7') + ", 1, 1]}}"));
  for (const char* file : {"ball.json", "dots.json", "long.json"})
    expect_error(run_with({{"MEMORY", "2000"}, {"REST", "1"}}, {"eval", file, "-o", "out.off", "--json"}), 1,
                 "too-large", file);
}

TEST_F(Faults, WhereNoThreadStartsTheCallerDoesAll) {
  put("ball.json", R"({"quoin-model": 1, "model": {"sphere": {"radius": "0.7", "sides": 96}}})");
  ASSERT_EQ(run({"eval", "ball.json", "-o", "ball.off"}).code, 0);
  ASSERT_EQ(run({"union", "a.off", "ball.off", "-o", "plain.quoin"}).code, 0);
  for (const char* threads : {"0", "1000000"}) {
    const Outcome r = run_with({{"THREADS", threads}}, {"union", "a.off", "ball.off", "-o", "out.quoin"});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(get("out.quoin"), get("plain.quoin"));
  }
}

#else

TEST(Faults, NeedAPreloadedLibrary) { GTEST_SKIP() << "the program has sanitizers, or the system no preloading"; }

#endif

}  // namespace
}  // namespace quoin::cli_test
