/// \file
/// Planes whose numbers are longer than any fixed width of the engine.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "quoin/quoin.h"

namespace quoin::api_test {

using Text4 = std::array<std::string, 4>;

/// The planes of an octahedron: normals of 40 digits that are not quite its own.
inline std::vector<Text4> planes_of_long_numbers() {
  const std::string third = "0.5773502691896257645091487805019574556476";
  std::vector<Text4> planes;
  for (std::size_t i = 0; i < 8; ++i) {
    Text4 plane{third + "1", third + "2", third + "3", "-1"};
    for (std::size_t k = 0; k < 3; ++k)
      if ((i >> k & 1) != 0) plane[k] = "-" + plane[k];
    planes.push_back(plane);
  }
  return planes;
}

}  // namespace quoin::api_test
