// Law: only canonical() makes a canonical form.
#include <utility>

#include "booleans/body/canonical.h"

using quoin::booleans::Boundary;
using quoin::booleans::Canonical;

std::size_t face_count(Boundary boundary) {
#ifdef CONTROL
  const Canonical form = quoin::booleans::canonical(body_of(boundary));
#else
  const Canonical form{std::move(boundary)};
#endif
  return form.face_count();
}
