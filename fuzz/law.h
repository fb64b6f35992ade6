/// \file
/// How a target ends when a law is broken.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace quoin::fuzz {

[[noreturn]] inline void fail(const char* law, const std::string& what = "") {
  std::fprintf(stderr, "broken: %s %s\n", law, what.c_str());
  std::abort();
}
inline void require(bool holds, const char* law, const std::string& what = "") {
  if (!holds) fail(law, what);
}

}  // namespace quoin::fuzz
