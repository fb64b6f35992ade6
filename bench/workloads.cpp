#include "bench/workloads.h"

#include "bench/combine.h"
#include "bench/hard_shapes.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "examples/models.h"

namespace quoin::bench {
namespace {

std::uint32_t frequency(std::size_t triangles) {
  return static_cast<std::uint32_t>(std::lround(std::sqrt(double(triangles) / 20)));
}
Mesh sphere(std::size_t triangles, double x) { return examples::geodesic_sphere({x, 0, 0}, 1, frequency(triangles)); }

std::vector<Mesh> spheres(std::size_t n) { return {sphere(n, 0), sphere(n, 0.5)}; }

std::vector<Mesh> local_edit(std::size_t n) { return {sphere(n, 0), examples::geodesic_sphere({1, 0, 0}, 0.03, 7)}; }

std::vector<Mesh> bumpy(std::size_t n) {
  return {examples::bumpy_sphere({0, 0, 0}, 1, n, 1), examples::bumpy_sphere({0, 0, 0}, 1, n, 2)};
}

/// Two spheres in one place, every vertex at a random distance from the centre: nearly all triangles cross others.
std::vector<Mesh> noisy(std::size_t n) {
  std::vector<Mesh> two;
  for (const std::uint64_t seed : {1, 2}) {
    examples::Random random(seed);
    Mesh mesh = sphere(n, 0);
    for (std::size_t i = 0; i < mesh.points.size(); i += 3) {
      const double radius = random.between(0.96, 1.04);
      for (std::size_t k = 0; k < 3; ++k) mesh.points[i + k] *= radius;
    }
    two.push_back(std::move(mesh));
  }
  return two;
}

std::vector<Mesh> cubes(std::size_t n) { return examples::cube_grid(static_cast<std::uint32_t>(n), 1.0); }

std::vector<Mesh> with_first(Mesh first, std::vector<Mesh> rest) {
  rest.insert(rest.begin(), std::move(first));
  return rest;
}

std::vector<Mesh> drilled(std::size_t holes, std::uint32_t sides) {
  const auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(double(holes))));
  return with_first(examples::box({0, 0, 0}, {double(side), double(side), 1}), examples::drills(side, side, sides));
}
std::vector<Mesh> plate(std::size_t holes) { return drilled(holes, 64); }
std::vector<Mesh> drill(std::size_t holes) { return drilled(holes, 24); }

std::vector<Mesh> menger(std::size_t level) {
  const double size = std::pow(3.0, double(level));
  return with_first(examples::box({0, 0, 0}, {size, size, size}), examples::menger_holes(static_cast<unsigned>(level)));
}

std::vector<Mesh> cloud(std::size_t n) { return examples::sphere_cloud(n, 1280, 3); }

std::vector<Mesh> needles(std::size_t n) { return examples::needles(n, {0, 0, 0}, 1, 0.01, 3, 5); }

/// A dome, then small spheres about random points of its surface.
std::vector<Mesh> chain(std::size_t length) {
  examples::Random random(7);
  Mesh dome = examples::geodesic_sphere({0, 0, 0}, 1, 32);
  for (std::size_t i = 2; i < dome.points.size(); i += 3)
    if (dome.points[i] < 0) dome.points[i] *= 0.05;
  std::vector<Mesh> all{std::move(dome)};
  for (std::size_t i = 0; i < length; ++i) {
    examples::Point c = random.direction();
    c[2] = std::abs(c[2]);
    all.push_back(examples::icosphere(c, random.between(0.02, 0.06), 2));
  }
  return all;
}

/// Parts in a row, each a box followed by the drill through it.
std::vector<Mesh> parts(std::size_t n) {
  std::vector<Mesh> all;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = 2 * double(i % 32), y = 2 * double(i / 32);
    all.push_back(examples::box({x, y, 0}, {x + 1, y + 1, 1}));
    all.push_back(examples::cylinder({x + 0.5, y + 0.5, -1}, {x + 0.5, y + 0.5, 2}, 0.3, 32));
  }
  return all;
}

std::vector<Mesh> two_boxes(std::size_t) {
  return {examples::box({0, 0, 0}, {1, 1, 1}), examples::box({0.25, 0.25, 0.25}, {1.5, 1.5, 1.5})};
}
std::vector<Mesh> bored_box(std::size_t sides) {
  return {examples::box({0, 0, 0}, {1, 1, 1}),
          examples::cylinder({0.5, 0.5, -1}, {0.5, 0.5, 2}, 0.3, static_cast<std::uint32_t>(sides))};
}
std::vector<Mesh> two_small_spheres(std::size_t n) { return {sphere(n, 0), sphere(n, 0.7)}; }

/// Rotated by 7 degrees about (1, 2, 3).
Mesh turned(Mesh mesh) {
  const double length = std::sqrt(14.0), angle = 7 * std::acos(-1.0) / 180, c = std::cos(angle), s = std::sin(angle);
  const std::array<double, 3> n{1 / length, 2 / length, 3 / length};
  for (std::size_t i = 0; i < mesh.points.size(); i += 3) {
    const std::array<double, 3> p{mesh.points[i], mesh.points[i + 1], mesh.points[i + 2]};
    const double along = (p[0] * n[0] + p[1] * n[1] + p[2] * n[2]) * (1 - c);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
      mesh.points[i + k] = p[k] * c + (n[u] * p[v] - n[v] * p[u]) * s + n[k] * along;
    }
  }
  return mesh;
}

/// (A - B) u (A n B), where the parts share the surface of B within A; printed as its two operands.
std::vector<Mesh> cut_apart(std::size_t n) {
  const auto around = static_cast<std::uint32_t>(std::lround(std::sqrt(double(n) / 80)));
  ImportOptions options;
  options.grid = must(Grid::with_step("1/65536"));
  const auto import = [&](const Mesh& m) { return must(Solid::from_triangles(m.points, m.triangles, options)); };
  const Expression a = import(examples::box({-60, -60, -30}, {60, 60, 30}));
  const Expression b = import(examples::torus_knot({0, 0, 0}, {2, 9, 26, 11.5, 4}, 40 * around, around));
  return {must(must(evaluate(a - b)).to_triangles()), must(must(evaluate(a & b)).to_triangles())};
}

std::vector<Mesh> against_itself(const Mesh& mesh) { return {mesh, turned(mesh)}; }

std::vector<Mesh> knot(std::size_t n) {
  const auto around = static_cast<std::uint32_t>(std::lround(std::sqrt(double(n) / 80)));
  return against_itself(examples::torus_knot({0, 0, 0}, {2, 9, 26, 11.5, 4}, 40 * around, around));
}

std::vector<Mesh> gear(std::size_t n) {
  examples::Gear gear;
  gear.steps = static_cast<std::uint32_t>(n / (4 * gear.teeth));
  return against_itself(examples::gear(gear));
}

Mesh scaled(Mesh mesh, const std::array<double, 3>& by) {
  for (std::size_t i = 0; i < mesh.points.size(); ++i) mesh.points[i] *= by[i % 3];
  return mesh;
}

/// The part that the demo makes, of a body of n triangles: an ellipsoid minus a torus knot, a bore and nine drills,
/// intersected with a gear.
std::vector<Mesh> housing(std::size_t n) {
  ImportOptions options;
  options.grid = must(Grid::with_step("1/1048576"));
  const auto import = [&](const Mesh& m) { return must(Solid::from_triangles(m.points, m.triangles, options)); };
  const auto drill = [&](double x, double y, double radius, std::uint32_t sides) {
    return import(examples::cylinder({x, y, -30}, {x, y, 30}, radius, sides));
  };
  examples::Gear gear;
  gear.steps = 62;
  Expression part = Expression(import(scaled(sphere(n, 0), {42, 42, 26}))) -
                    import(examples::torus_knot({0, 0, 0}, {2, 9, 26, 11.5, 4}, 2000, 50)) - drill(0, 0, 11, 400);
  for (int i = 0; i < 9; ++i) {
    const double angle = 40 * i * std::acos(-1.0) / 180;
    part = part - drill(28 * std::cos(angle), 28 * std::sin(angle), 2.5, 100);
  }
  return against_itself(must(must(evaluate(part & import(scaled(examples::gear(gear), {42, 42, 54})))).to_triangles()));
}

/// Long thin diagonal triangles, crossed by their mirror image; the boxes of nearly all pairs meet.
std::vector<Mesh> skinny(std::size_t n) {
  const Mesh strip = examples::diagonal_strip(n, 1);
  Mesh other = strip;
  for (std::size_t i = 0; i < other.points.size(); i += 3) {
    other.points[i] = 1 - other.points[i];
    other.points[i + 2] += 0.003;
  }
  for (std::size_t i = 0; i < other.triangles.size(); i += 3) std::swap(other.triangles[i], other.triangles[i + 1]);
  return {strip, other};
}

}  // namespace

const char* name(Operation operation) {
  static constexpr std::array names{"union", "intersection", "difference", "unions",      "differences",
                                    "parts", "nested",       "leaning",    "alternating", "remainders"};
  return names[static_cast<std::size_t>(operation)];
}

const std::vector<Workload>& workloads() {
  using enum Operation;
  static const char* const fine = "1/16777216";
  static const char* const coarse = "1/65536";
  static const std::vector<Workload> all{
      {"spheres-union", "triangles each", 1000000, unite, fine, spheres},
      {"spheres-intersection", "triangles each", 1000000, intersect, fine, spheres},
      {"spheres-difference", "triangles each", 1000000, subtract, fine, spheres},
      {"local-edit", "triangles of the larger", 1000000, subtract, fine, local_edit},
      {"bumpy", "triangles each", 500000, unite, fine, bumpy},
      {"noisy", "triangles each", 100000, unite, fine, noisy},
      {"knot", "triangles each", 200000, unite, coarse, knot},
      {"gear", "triangles each", 6000, unite, fine, gear},
      {"housing", "triangles of the body", 150000, unite, "1/1048576", housing},
      {"cubes", "cubes per edge", 20, unite, coarse, cubes},
      {"cubes-each", "cubes per edge", 20, unite_each, coarse, cubes},
      {"plate", "holes", 10000, subtract, coarse, plate},
      {"drill", "holes", 1024, subtract, coarse, drill},
      {"drill-each", "holes", 1024, subtract_each, coarse, drill},
      {"menger", "level", 4, subtract, coarse, menger},
      {"cloud", "spheres", 1000, unite, fine, cloud},
      {"needles", "prisms", 150, unite, fine, needles},
      {"chain", "operations", 1000, subtract_each, fine, chain},
      {"parts", "boxes with a hole", 1000, unite_differences, coarse, parts},
      {"reunion", "triangles of the knot", 200000, unite, coarse, cut_apart},
      {"boxes", "-", 1, subtract, coarse, two_boxes},
      {"bored-box", "sides", 100, subtract, coarse, bored_box},
      {"balls", "triangles each", 320, unite, fine, two_small_spheres},
      {"skinny", "skinny triangles each", 15000, unite, fine, skinny},
      {"one-apex", "pyramids", 4000, unite, fine, pyramids_with_one_apex},
      {"cones-one-apex", "sides", 4000, unite, fine, cones_with_one_apex},
      {"crossing-cones", "sides", 4000, unite, fine, crossing_cones},
      {"one-edge", "wedges", 4000, unite, fine, wedges_at_one_edge},
      {"slivers", "tetrahedra each", 16000, unite, fine, slivers},
      {"prism-caps", "sides", 16000, subtract, fine, prism_caps},
      {"duplicates", "solids", 2000, unite, fine, stacked_duplicates},
      {"stars", "tips", 16000, intersect, fine, star_polygons},
      {"nested", "boxes", 4000, subtract_nested, fine, nested_boxes},
      {"deep", "boxes", 4000, unite_leaning, "1/1024", boxes_in_a_row},
      {"deep-alternating", "boxes", 4000, alternate, "1/1024", boxes_in_a_row},
      {"repeated", "spheres", 4000, unite_remainders, fine, sphere_and_spheres},
      {"mesh-duplicates", "shells", 4000, unite, fine, nullptr, mesh_of_duplicates},
      {"mesh-needles", "shells", 1000, unite, fine, nullptr, mesh_of_needles},
      {"mesh-bars", "bars across as many", 300, unite, "1/1024", nullptr, mesh_of_bars},
      {"swept-star", "corners", 16000, unite, fine, nullptr, swept_star},
      {"in-turn", "terms", 64000, unite, coarse, nullptr, two_solids_in_turn},
      {"half-spaces", "planes", 4000, intersect, coarse, nullptr, common_of_half_spaces},
      {"hulls", "points", 4000, unite, fine, nullptr, hull_of_points},
  };
  return all;
}

const Workload* find_workload(const std::string& name) {
  for (const Workload& w : workloads())
    if (w.name == name) return &w;
  return nullptr;
}

}  // namespace quoin::bench
