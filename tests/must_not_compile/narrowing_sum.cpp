// Law: a sum is never assigned to a type that may not hold it.
#include "exact/ladder.h"

using quoin::exact::Coefficient;
using quoin::exact::Int;

int sum_sign(const Coefficient& a, const Coefficient& b) {
#ifdef CONTROL
  const Int<Coefficient::bits + 1> sum = a + b;
#else
  const Coefficient sum = a + b;
#endif
  return sum.sign();
}
