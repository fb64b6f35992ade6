// Law: a Result never turns silently into a number or a flag.
#include "quoin/result.h"

bool succeeded(const quoin::Result<int>& result) {
#ifdef CONTROL
  return static_cast<bool>(result);
#else
  return result;
#endif
}
