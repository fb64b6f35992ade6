/// \file
/// The topology of a separated boundary.
#pragma once

#include "booleans/surface/triangulated.h"

namespace quoin::booleans {

/// Of a separated mesh: connected components, and the sum of their genera.
struct Shells {
  std::uint64_t count = 0;
  std::int64_t genus = 0;
};
Shells shells(const Triangulated& separated_mesh);

}  // namespace quoin::booleans
