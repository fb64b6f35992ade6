/// \file
/// Laws of cures, on triangles of few points, closed blocks that were damaged, and both together: what is accepted with
/// all cures is a valid solid, and the same bytes for any order of the triangles.
///
/// The first byte chooses cures and what to begin with; each four that follow are a triangle or a damage.
#include <algorithm>
#include <span>

#include "fuzz/law.h"
#include "quoin/quoin.h"
#include "tests/api/doors/damaged_meshes.h"

namespace quoin::fuzz {
namespace {

constexpr std::size_t most_steps = 24;

/// Points of a lattice of 4 x 4 x 4, some of them moved by a little.
std::uint32_t add_point(Mesh& mesh, std::uint8_t byte) {
  const double shift = byte >= 0xC0 ? 0x1p-8 : 0;
  return damaged::add_vertex(mesh, {(byte & 3) + shift, static_cast<double>(byte >> 2 & 3), (byte >> 4 & 3) - shift});
}

void change(Mesh& mesh, std::span<const std::uint8_t> step) {
  const std::size_t count = damaged::size_of(mesh);
  const std::size_t t = count == 0 ? 0 : (step[1] + 256U * step[2]) % count;
  const double size = static_cast<double>(step[3] % 16) / 1024;
  const std::size_t what = count == 0 ? 7 : step[0] % 8;
  switch (what) {
    case 0:
      return damaged::put_on_edge(mesh, t, {size, 0, 0});
    case 1:
      return damaged::tear_off(mesh, t, {0, size, size});
    case 2:
      return damaged::remove_triangle(mesh, t);
    case 3:
      return damaged::turn_over(mesh, t);
    case 4:
      return damaged::double_triangle(mesh, t);
    case 5:
      return damaged::add_flap(mesh, t);
    case 6:
      return damaged::put_on_edge(mesh, t);
    default:
      damaged::add_triangle(mesh, add_point(mesh, step[1]), add_point(mesh, step[2]), add_point(mesh, step[3]));
  }
}

Repair chosen(std::uint8_t byte) {
  Repair repair;
  repair.all = (byte & 3) == 0;
  repair.duplicates = (byte & 4) != 0;
  repair.caps = (byte & 8) != 0;
  repair.invert_shells = (byte & 16) != 0;
  if ((byte & 3) == 1) repair.weld = "1/64";
  if ((byte & 3) == 2) repair.t_junctions = "1/64";
  if ((byte & 3) == 3) repair.caps_size = "3";
  if ((byte & 32) != 0) repair.orient = (byte & 16) != 0 ? Orient::solid : Orient::nested;
  return repair;
}

void run(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return;
  std::mt19937_64 random(bytes[0]);
  Mesh mesh;
  if ((bytes[0] & 64) != 0) mesh = damaged::bumpy_block(2, random);
  for (std::size_t i = 1; i + 4 <= bytes.size() && i < 4 * most_steps; i += 4) change(mesh, bytes.subspan(i, 4));

  ImportOptions options;
  options.grid = Grid::with_step("1/65536").value();
  options.repair = chosen(bytes[0]);
  const auto solid = Solid::from_triangles(mesh.points, mesh.triangles, options);
  if (solid) {
    const auto again = Solid::from_quoin(solid.value().to_quoin());
    require(again.has_value() && again.value() == solid.value(), "what is cured is a valid solid");
  }
  for (int order = 0; order < 2; ++order) {
    damaged::shuffle(mesh, random);
    const auto other = Solid::from_triangles(mesh.points, mesh.triangles, options);
    require(solid.has_value() == other.has_value(), "the order of triangles does not decide");
    if (solid) require(solid.value().to_quoin() == other.value().to_quoin(), "the order of triangles changes nothing");
  }
}

}  // namespace
}  // namespace quoin::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  quoin::fuzz::run({data, size});
  return 0;
}
