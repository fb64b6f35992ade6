// Small solids for the tests of the public API.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "quoin/quoin.h"

namespace quoin::api_test {

using Corner = std::array<double, 3>;

inline Mesh box_mesh(const Corner& low, const Corner& high) {
  Mesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    for (std::size_t k = 0; k < 3; ++k) mesh.points.push_back((corner >> k & 1) != 0 ? high[k] : low[k]);
  mesh.triangles = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  return mesh;
}

inline Grid grid_of(const std::string& step) { return Grid::with_step(step).value(); }

inline Solid box(const Corner& low, const Corner& high, const Grid& grid = {}) {
  const Mesh mesh = box_mesh(low, high);
  return Solid::from_triangles(mesh.points, mesh.triangles, grid).value();
}

inline Solid tetrahedron(const std::array<Corner, 4>& corners, const Grid& grid = {}) {
  std::vector<double> points;
  for (const auto& c : corners) points.insert(points.end(), c.begin(), c.end());
  const std::array<std::uint32_t, 12> out{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}, in{0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0};
  auto solid = Solid::from_triangles(points, out, grid);
  return solid ? solid.value() : Solid::from_triangles(points, in, grid).value();
}

inline std::string volume(const Solid& solid) { return solid.volume().value_or("unbounded"); }

inline std::mt19937_64 random_engine() {
  const char* text = std::getenv("QUOIN_SEED");
  const std::uint64_t seed = text != nullptr ? std::strtoull(text, nullptr, 10) : 1;
  std::cout << "QUOIN_SEED=" << seed << '\n';
  return std::mt19937_64(seed);
}

/// A tetrahedron with corners in {-size .. size}^3, not flat.
inline Solid random_tetrahedron(std::mt19937_64& random, int size, const Grid& grid = {}) {
  for (;;) {
    std::array<Corner, 4> c;
    for (auto& corner : c)
      for (auto& x : corner) x = static_cast<double>(random() % (2 * static_cast<unsigned>(size) + 1)) - size;

    double det = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      det +=
          (c[1][k] - c[0][k]) * ((c[2][i] - c[0][i]) * (c[3][j] - c[0][j]) - (c[2][j] - c[0][j]) * (c[3][i] - c[0][i]));
    }
    if (det != 0) return tetrahedron(c, grid);
  }
}

}  // namespace quoin::api_test
