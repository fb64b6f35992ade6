/// \file
/// The ten lines of the README: two spheres, their difference, its exact volume, a law, and a file.

#include <cmath>
#include <cstdint>
#include <iostream>
#include <numbers>

#include "quoin/quoin.h"

namespace {

/// Points and triangles of a sphere about (x, 0, 0): rings of 2 n points between two poles.
quoin::Mesh sphere(double x, double radius, std::uint32_t n) {
  quoin::Mesh mesh{{x, 0, -radius, x, 0, radius}, {}};
  for (std::uint32_t i = 0; i + 1 < n; ++i) {
    const double latitude = std::numbers::pi * (i + 1) / n;
    const std::uint32_t ring = 2 + 2 * n * i;
    for (std::uint32_t j = 0; j < 2 * n; ++j) {
      const double longitude = std::numbers::pi * j / n;
      mesh.points.push_back(x + radius * std::sin(latitude) * std::cos(longitude));
      mesh.points.push_back(radius * std::sin(latitude) * std::sin(longitude));
      mesh.points.push_back(-radius * std::cos(latitude));
      const std::uint32_t a = ring + j, b = ring + (j + 1) % (2 * n);
      const std::uint32_t above_a = i + 2 < n ? a + 2 * n : 1, above_b = i + 2 < n ? b + 2 * n : 1;
      mesh.triangles.insert(mesh.triangles.end(), {a, b, above_b});
      if (i + 2 < n) mesh.triangles.insert(mesh.triangles.end(), {a, above_b, above_a});
      if (i == 0) mesh.triangles.insert(mesh.triangles.end(), {0, b, a});
    }
  }
  return mesh;
}

}  // namespace

int main() try {
  using quoin::Solid;
  const quoin::Mesh ball = sphere(0, 1, 24), bite = sphere(0.8, 0.6, 24);
  const quoin::Grid grid = quoin::Grid::with_step("1/1000000").value();
  const Solid a = Solid::from_triangles(ball.points, ball.triangles, grid).value();
  const Solid b = Solid::from_triangles(bite.points, bite.triangles, grid).value();
  const Solid part = a - b;
  std::cout << "exact volume: " << part.volume().value_or("unbounded") << '\n';
  const bool law_holds = (part + (a & b)) == a;
  std::cout << "(a - b) + (a & b) == a: " << (law_holds ? "true" : "false") << '\n';
  part.write("part.stl").value();
  return law_holds ? 0 : 1;
} catch (const quoin::Exception& refusal) {
  std::cerr << refusal.what() << '\n';
  return 1;
}
