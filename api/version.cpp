#include "quoin/version.h"

#ifndef QUOIN_COMMIT
#define QUOIN_COMMIT "unknown"
#endif

namespace quoin {

const char* commit() { return QUOIN_COMMIT; }

const char* compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "gcc " __VERSION__;
#else
  return "unknown";
#endif
}

int format_version() { return 1; }

}  // namespace quoin
