// The progress of an operation, recorded.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "quoin/quoin.h"

namespace quoin::api_test {

/// Fractions as they are reported.
struct Fractions {
  std::vector<double> all;
  Progress record() {
    all.clear();
    return [this](double done) { all.push_back(done); };
  }
  /// They never decrease, and 1 is said once, in the end.
  void expect_whole(const std::string& what) const {
    ASSERT_FALSE(all.empty()) << what;
    EXPECT_TRUE(std::is_sorted(all.begin(), all.end())) << what;
    EXPECT_GE(all.front(), 0) << what;
    EXPECT_EQ(all.back(), 1) << what;
    EXPECT_EQ(std::count(all.begin(), all.end(), 1), 1) << what;
  }
};

}  // namespace quoin::api_test
