/// \file
/// What cures cost: imports of a sound sphere and of one with cracks, with and without asking for cures, in turn: the
/// table of docs/benchmarks.md.
///
/// usage: quoin-imports [TRIANGLES [ROUNDS]] (100000, 5)
/// The cracks go around each hundredth triangle. Entries are CPU seconds of one thread, the least of all rounds, and
/// that over the import of the sound mesh as it is.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "examples/models.h"
#include "quoin/quoin.h"

namespace {

using namespace quoin;

Mesh cracked(Mesh mesh) {
  for (std::size_t t = 0; 3 * t < mesh.triangles.size(); t += 100)
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& corner = mesh.triangles[3 * t + k];
      for (std::size_t i = 0; i < 3; ++i) mesh.points.push_back(mesh.points[3 * corner + i] * (1 + 0x1p-18));
      corner = static_cast<std::uint32_t>(mesh.points.size() / 3 - 1);
    }
  return mesh;
}

struct Way {
  const char* name;
  const Mesh* mesh;
  const char* repair;  // nullptr: none
  double seconds = 0;
};

double seconds_of(const Way& way) {
  ImportOptions options;
  options.run.threads = 1;
  if (way.repair != nullptr) options.repair = Repair::parse(way.repair).value();
  const std::clock_t start = std::clock();
  const auto solid = Solid::from_triangles(way.mesh->points, way.mesh->triangles, options);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t size = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 100000;
  const int rounds = argc > 2 ? std::atoi(argv[2]) : 5;
  const auto frequency = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(size) / 20)));
  const Mesh sound = examples::geodesic_sphere({0, 0, 0}, 1, frequency), torn = cracked(sound);
  std::vector<Way> ways{{"sound", &sound, nullptr},
                        {"sound, `all`", &sound, "all"},
                        {"sound, `weld`", &sound, "weld=1e-6"},
                        {"cracked, refused with its diagnosis", &torn, nullptr},
                        {"cracked, `all`", &torn, "all"}};
  for (int round = 0; round < rounds; ++round)
    for (Way& way : ways) {
      const double seconds = seconds_of(way);
      way.seconds = round == 0 ? seconds : std::min(way.seconds, seconds);
    }
  for (const Way& way : ways)
    std::printf("| %s | %zu | %.3f | %.2f |\n", way.name, way.mesh->triangles.size() / 3, way.seconds,
                way.seconds / ways[0].seconds);
}
