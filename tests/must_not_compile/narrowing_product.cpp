// Law: a product is never assigned to a type that may not hold it.
#include "exact/ladder.h"

using quoin::exact::Coefficient;
using quoin::exact::Offset;

int product_sign(const Coefficient& a, const Coefficient& b) {
#ifdef CONTROL
  const Offset product = a * b;
#else
  const Coefficient product = a * b;
#endif
  return product.sign();
}
