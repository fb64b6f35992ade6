#include "bench/hard_shapes.h"

#include <cmath>
#include <cstdint>
#include <string>

#include "bench/combine.h"
#include "examples/models.h"

namespace quoin::bench {
namespace {

using examples::Point;

const double pi = std::acos(-1.0);

Point operator+(const Point& p, const Point& q) { return {p[0] + q[0], p[1] + q[1], p[2] + q[2]}; }
Point operator*(double f, const Point& p) { return {f * p[0], f * p[1], f * p[2]}; }
Point cross(const Point& p, const Point& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
Point unit(const Point& p) { return 1 / std::hypot(p[0], p[1], p[2]) * p; }

std::uint32_t add(Mesh& mesh, const Point& p) {
  mesh.points.insert(mesh.points.end(), p.begin(), p.end());
  return static_cast<std::uint32_t>(mesh.points.size() / 3 - 1);
}
void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
}

/// A pyramid over a regular polygon about `center`, which also is a corner of the base's triangles.
Mesh pyramid(const Point& apex, const Point& center, double radius, std::size_t sides) {
  Mesh mesh;
  const Point axis = unit(center + -1.0 * apex),
              x = unit(cross(axis, std::abs(axis[0]) < 0.5 ? Point{1, 0, 0} : Point{0, 1, 0})), y = cross(axis, x);
  const std::uint32_t top = add(mesh, apex), middle = add(mesh, center);
  for (std::size_t i = 0; i < sides; ++i) {
    const double angle = 2 * pi * double(i) / double(sides);
    add(mesh, center + radius * (std::cos(angle) * x + std::sin(angle) * y));
  }
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t a = 2 + i, b = 2 + (i + 1) % static_cast<std::uint32_t>(sides);
    add_triangle(mesh, top, b, a);
    add_triangle(mesh, middle, a, b);
  }
  return mesh;
}

/// A prism along z over a polygon, counter-clockwise; the caps are fans from the corner `hub`, or from (0, 0) if none.
Mesh prism(const std::vector<std::array<double, 2>>& polygon, double low, double high, bool fan_from_corner) {
  Mesh mesh;
  const auto n = static_cast<std::uint32_t>(polygon.size());
  for (const double z : {low, high})
    for (const auto& [x, y] : polygon) add(mesh, {x, y, z});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    add_triangle(mesh, i, j, n + j);
    add_triangle(mesh, i, n + j, n + i);
  }

  if (fan_from_corner) {
    for (std::uint32_t i = 1; i + 1 < n; ++i) {
      add_triangle(mesh, 0, i + 1, i);
      add_triangle(mesh, n, n + i, n + i + 1);
    }
    return mesh;
  }
  const std::uint32_t bottom = add(mesh, {0, 0, low}), top = add(mesh, {0, 0, high});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    add_triangle(mesh, bottom, j, i);
    add_triangle(mesh, top, n + i, n + j);
  }
  return mesh;
}

/// Corners at alternating radii, the first at `turn` (radians).
std::vector<std::array<double, 2>> around(std::size_t corners, double turn, double outer, double inner) {
  std::vector<std::array<double, 2>> polygon;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = turn + 2 * pi * double(i) / double(corners), radius = i % 2 == 0 ? outer : inner;
    polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return polygon;
}

void append(Mesh& all, const Mesh& mesh) {
  const auto base = static_cast<std::uint32_t>(all.points.size() / 3);
  all.points.insert(all.points.end(), mesh.points.begin(), mesh.points.end());
  for (const std::uint32_t v : mesh.triangles) all.triangles.push_back(base + v);
}

Solid imported(const Mesh& mesh, const Grid& grid, const Options& run) {
  ImportOptions options;
  options.grid = grid;
  options.run = run;
  return must(Solid::from_triangles(mesh.points, mesh.triangles, options));
}

/// The i-th of n points spread evenly over the unit sphere.
Point on_sphere(std::size_t i, std::size_t n) {
  const double golden = pi * (3 - std::sqrt(5.0)), z = 1 - (2 * double(i) + 1) / double(n), r = std::sqrt(1 - z * z),
               angle = golden * double(i);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

/// The coordinates as decimals.
Text3 text(const Point& p) { return {std::to_string(p[0]), std::to_string(p[1]), std::to_string(p[2])}; }

}  // namespace

std::vector<Mesh> pyramids_with_one_apex(std::size_t n) {
  std::vector<Mesh> all;
  const double radius = 0.8 / std::sqrt(double(n));
  for (std::size_t i = 0; i < n; ++i) all.push_back(pyramid({0, 0, 0}, on_sphere(i, n), radius, 6));
  return all;
}

std::vector<Mesh> cones_with_one_apex(std::size_t n) {
  return {pyramid({0, 0, 0}, {0, 0, 1}, 1, n), pyramid({0, 0, 0}, {0.3, 0.2, 1}, 1, n)};
}

std::vector<Mesh> crossing_cones(std::size_t n) {
  return {pyramid({0, 0, 0}, {0, 0, 1}, 1, n), pyramid({0.3, 0.1, 0.05}, {0.3, 0.1, 1.1}, 1, n)};
}

std::vector<Mesh> wedges_at_one_edge(std::size_t n) {
  std::vector<Mesh> all;
  for (std::size_t i = 0; i < n; ++i) {
    const double from = 2 * pi * double(i) / double(n), to = from + pi / double(n);
    all.push_back(prism({{0, 0}, {std::cos(from), std::sin(from)}, {std::cos(to), std::sin(to)}}, 0, 1, true));
  }
  return all;
}

std::vector<Mesh> slivers(std::size_t n) {
  std::vector<Mesh> layers(2);
  const double width = 0.4 / double(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double at = double(i) / double(n);
    for (const bool second : {false, true}) {
      Mesh& mesh = layers[second];
      const double z = second ? 0.002 : 0, mirror = second ? -1 : 1;
      const auto point = [&](double along, double across, double up) {
        return add(mesh, {along + across, mirror * (along - across), z + up});
      };
      const std::uint32_t a = point(0, at, 0), b = point(1, at, 0), c = point(1, at + width, 0),
                          d = point(0.5, at + width / 2, 0.001);
      const auto face = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
        second ? add_triangle(mesh, p, r, q) : add_triangle(mesh, p, q, r);
      };
      face(a, b, c);
      face(a, d, b);
      face(b, d, c);
      face(c, d, a);
    }
  }
  return layers;
}

std::vector<Mesh> prism_caps(std::size_t n) {
  return {prism(around(n, 0, 1, 1), 0, 1, true), prism(around(n, pi / double(n), 0.9, 0.9), 0, 1, true)};
}

std::vector<Mesh> stacked_duplicates(std::size_t n) {
  return std::vector<Mesh>(n, examples::icosphere({0, 0, 0}, 1, 1));
}

std::vector<Mesh> star_polygons(std::size_t n) {
  return {prism(around(2 * n, 0, 1, 0.5), 0, 1, false),
          prism(around(2 * n, pi / double(n), 1, 0.5), 0.25, 1.25, false)};
}

std::vector<Mesh> nested_boxes(std::size_t n) {
  std::vector<Mesh> all;
  for (std::size_t i = 0; i < n; ++i) {
    const double size = double(n - i) / double(n);
    all.push_back(examples::box({-size, -size, -size}, {size, size, size}));
  }
  return all;
}

std::vector<Mesh> boxes_in_a_row(std::size_t n) {
  std::vector<Mesh> all;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = double(i), size = i % 2 == 0 ? 0.5 : 0.4;
    all.push_back(examples::box({x - 0.6, -size, -size}, {x + 0.6, size, size}));
  }
  return all;
}

std::vector<Mesh> sphere_and_spheres(std::size_t n) {
  std::vector<Mesh> all{examples::icosphere({0, 0, 0}, 1, 3)};
  for (std::size_t i = 0; i < n; ++i) all.push_back(examples::icosphere(on_sphere(i, n), 1 / std::sqrt(double(n)), 0));
  return all;
}

Solid mesh_of_duplicates(std::size_t n, const Grid& grid, const Options& run) {
  Mesh one, all;
  for (const Point& p : {Point{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) add(one, p);
  one.triangles = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  for (std::size_t i = 0; i < n; ++i) append(all, one);
  return imported(all, grid, run);
}

Solid mesh_of_needles(std::size_t n, const Grid& grid, const Options& run) {
  Mesh all;
  for (const Mesh& needle : examples::needles(n, {0, 0, 0}, 1, 0.01, 3, 5)) append(all, needle);
  return imported(all, grid, run);
}

Solid mesh_of_bars(std::size_t n, const Grid& grid, const Options& run) {
  Mesh all;
  const double end = 2 * double(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double at = 2 * double(i);
    append(all, examples::box({at, -1, 0}, {at + 1, end, 1}));
    append(all, examples::box({-1, at, 0.25}, {end, at + 1, 1.25}));
  }
  return imported(all, grid, run);
}

Solid swept_star(std::size_t n, const Grid& grid, const Options& run) {
  Model::Outline outline;
  for (const auto& [x, y] : around(n, 0, 1, 0.5)) outline.push_back({std::to_string(x), std::to_string(y)});
  ModelOptions options;
  options.grid = grid;
  options.run = run;
  return must(evaluate(Model::extrusion({{outline}}, {"0", "0", "1"}), options));
}

Solid two_solids_in_turn(std::size_t n, const Grid& grid, const Options& run) {
  const Expression a = imported(examples::box({0, 0, 0}, {2, 2, 2}), grid, {}),
                   b = imported(examples::box({1, 1, 1}, {3, 3, 3}), grid, {});
  Expression all = a;
  for (std::size_t i = 1; i < n; ++i) all = i % 2 == 1 ? all - b : all + a;
  return must(evaluate(all, run));
}

Solid common_of_half_spaces(std::size_t n, const Grid& grid, const Options& run) {
  std::vector<Expression> all{imported(examples::box({-2, -2, -2}, {2, 2, 2}), grid, {})};
  for (std::size_t i = 0; i < n; ++i) {
    const Text3 normal = text(on_sphere(i, n));
    all.push_back(HalfSpace{{normal[0], normal[1], normal[2], "-1"}});
  }
  return must(evaluate(Expression::intersect(all), run));
}

Solid hull_of_points(std::size_t n, const Grid& grid, const Options& run) {
  std::vector<Text3> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back(text(on_sphere(i, n)));
  ModelOptions options;
  options.grid = grid;
  options.run = run;
  return must(evaluate(Model::hull(points), options));
}

}  // namespace quoin::bench
