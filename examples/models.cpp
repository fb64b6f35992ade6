#include "examples/models.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

namespace quoin::examples {
namespace {

using Index = std::uint32_t;
constexpr double two_pi = 2 * std::numbers::pi;

Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point operator*(double s, const Point& a) { return {s * a[0], s * a[1], s * a[2]}; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point unit_vector(const Point& a) { return (1 / std::sqrt(dot(a, a))) * a; }

Index add_point(Mesh& mesh, const Point& p) {
  const auto index = static_cast<Index>(mesh.points.size() / 3);
  mesh.points.insert(mesh.points.end(), p.begin(), p.end());
  return index;
}

void add_triangle(Mesh& mesh, Index a, Index b, Index c) { mesh.triangles.insert(mesh.triangles.end(), {a, b, c}); }

void add_quad(Mesh& mesh, Index a, Index b, Index c, Index d) {
  add_triangle(mesh, a, b, c);
  add_triangle(mesh, a, c, d);
}

// Rings of `n` consecutive points run counter-clockwise seen from above; `upper` lies above `lower`.
void add_band(Mesh& mesh, Index lower, Index upper, Index n) {
  for (Index i = 0; i < n; ++i) {
    const Index j = i + 1 == n ? 0 : i + 1;
    add_quad(mesh, lower + i, lower + j, upper + j, upper + i);
  }
}

void add_upper_cap(Mesh& mesh, Index apex, Index ring, Index n) {
  for (Index i = 0; i < n; ++i) add_triangle(mesh, apex, ring + i, ring + (i + 1 == n ? 0 : i + 1));
}

void add_lower_cap(Mesh& mesh, Index apex, Index ring, Index n) {
  for (Index i = 0; i < n; ++i) add_triangle(mesh, apex, ring + (i + 1 == n ? 0 : i + 1), ring + i);
}

// A ring about `center` in the plane of the unit vectors u and v, counter-clockwise seen from u x v.
Index add_ring(Mesh& mesh, const Point& center, const Point& u, const Point& v, double radius, Index n) {
  const auto first = static_cast<Index>(mesh.points.size() / 3);
  for (Index i = 0; i < n; ++i) {
    const double angle = two_pi * i / n;
    add_point(mesh, center + radius * std::cos(angle) * u + radius * std::sin(angle) * v);
  }
  return first;
}

void reserve(Mesh& mesh, std::size_t points, std::size_t triangles) {
  mesh.points.reserve(3 * points);
  mesh.triangles.reserve(3 * triangles);
}

std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;

double unit_double(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

// A value in [-1, 1] for each point of the integer lattice.
double lattice_value(std::int64_t i, std::int64_t j, std::int64_t k, std::uint64_t seed) {
  std::uint64_t h = mixed(seed + golden);
  for (const std::int64_t c : {i, j, k}) h = mixed(h ^ (static_cast<std::uint64_t>(c) * golden));
  return 2 * unit_double(h) - 1;
}

// Smooth noise in [-1, 1]: lattice values blended by cubics.
double value_noise(const Point& p, std::uint64_t seed) {
  std::array<std::int64_t, 3> cell{};
  Point t{};
  for (std::size_t a = 0; a < 3; ++a) {
    const double floor = std::floor(p[a]);
    const double f = p[a] - floor;
    cell[a] = static_cast<std::int64_t>(floor);
    t[a] = f * f * (3 - 2 * f);
  }
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const int x = corner & 1, y = (corner >> 1) & 1, z = corner >> 2;
    const double weight = (x ? t[0] : 1 - t[0]) * (y ? t[1] : 1 - t[1]) * (z ? t[2] : 1 - t[2]);
    sum += weight * lattice_value(cell[0] + x, cell[1] + y, cell[2] + z, seed);
  }
  return sum;
}

// The vertices and faces of an icosahedron; faces are counter-clockwise from outside.
struct Icosahedron {
  std::array<Point, 12> vertices;
  std::array<std::array<Index, 3>, 20> faces;
};

Icosahedron icosahedron() {
  // A pole, five vertices at height 1/sqrt(5), five below turned by 36 degrees, a pole.
  Icosahedron solid{};
  const double height = 1 / std::sqrt(5.0), width = 2 / std::sqrt(5.0);
  solid.vertices[0] = {0, 0, 1};
  solid.vertices[11] = {0, 0, -1};
  for (Index i = 0; i < 5; ++i) {
    const double a = two_pi * i / 5, b = two_pi * (i + 0.5) / 5;
    solid.vertices[1 + i] = {width * std::cos(a), width * std::sin(a), height};
    solid.vertices[6 + i] = {width * std::cos(b), width * std::sin(b), -height};
    const Index j = (i + 1) % 5;
    solid.faces[i] = {0, 1 + i, 1 + j};
    solid.faces[5 + i] = {6 + i, 1 + j, 1 + i};
    solid.faces[10 + i] = {6 + i, 6 + j, 1 + j};
    solid.faces[15 + i] = {11, 6 + j, 6 + i};
  }
  return solid;
}

// Divides the icosahedron's faces, sharing the points of edges and corners.
class GeodesicBuilder {
 public:
  explicit GeodesicBuilder(Index frequency) : n_(frequency), solid_(icosahedron()) {
    const std::size_t squares = std::size_t{n_} * n_;
    reserve(mesh_, 10 * squares + 2, 20 * squares);
    for (const Point& vertex : solid_.vertices) add_point(mesh_, vertex);
    for (auto& row : edge_start_) row.fill(0);
    for (const auto& face : solid_.faces) {
      for (std::size_t i = 0; i < 3; ++i) add_edge(face[i], face[(i + 1) % 3]);
    }
    for (const auto& face : solid_.faces) add_face(face);
  }

  /// Unit sphere about the origin.
  Mesh take() { return std::move(mesh_); }

 private:
  void add_edge(Index a, Index b) {
    if (a > b) return;  // The neighbour across the edge names it the other way round.
    edge_start_[a][b] = static_cast<Index>(mesh_.points.size() / 3);
    for (Index i = 1; i < n_; ++i) {
      const double t = static_cast<double>(i) / n_;
      add_point(mesh_, unit_vector((1 - t) * solid_.vertices[a] + t * solid_.vertices[b]));
    }
  }

  // The point `step` steps from vertex a towards vertex b.
  Index on_edge(Index a, Index b, Index step) const {
    if (step == 0) return a;
    if (step == n_) return b;
    return a < b ? edge_start_[a][b] + step - 1 : edge_start_[b][a] + (n_ - step) - 1;
  }

  // Row r of a face: r steps from corner 0, with r + 1 points from the edge 0-1 to the edge 0-2.
  void add_face(const std::array<Index, 3>& face) {
    std::vector<Index> above{face[0]}, row;
    for (Index r = 1; r <= n_; ++r) {
      row.clear();
      for (Index i = 0; i <= r; ++i) row.push_back(face_point(face, r, i));
      for (Index i = 0; i < r; ++i) {
        add_triangle(mesh_, above[i], row[i], row[i + 1]);
        if (i + 1 < r) add_triangle(mesh_, above[i], row[i + 1], above[i + 1]);
      }
      above.swap(row);
    }
  }

  Index face_point(const std::array<Index, 3>& face, Index r, Index i) {
    if (i == 0) return on_edge(face[0], face[1], r);
    if (i == r) return on_edge(face[0], face[2], r);
    if (r == n_) return on_edge(face[1], face[2], i);
    const double n = n_;
    return add_point(mesh_, unit_vector(((n_ - r) / n) * solid_.vertices[face[0]] +
                                        ((r - i) / n) * solid_.vertices[face[1]] + (i / n) * solid_.vertices[face[2]]));
  }

  Index n_;
  Icosahedron solid_;
  std::array<std::array<Index, 12>, 12> edge_start_{};
  Mesh mesh_;
};

void place(Mesh& mesh, const Point& center, double radius) {
  for (std::size_t i = 0; i < mesh.points.size(); ++i) mesh.points[i] = center[i % 3] + radius * mesh.points[i];
}

// The square holes along z of one level, skipping those within larger ones; size in cells.
void add_holes(std::vector<std::array<std::uint32_t, 3>>& holes, std::uint32_t x, std::uint32_t y, std::uint32_t size) {
  const std::uint32_t third = size / 3;
  if (third == 0) return;
  holes.push_back({x + third, y + third, third});
  for (std::uint32_t i = 0; i < 3; ++i) {
    for (std::uint32_t j = 0; j < 3; ++j) {
      if (i != 1 || j != 1) add_holes(holes, x + i * third, y + j * third, third);
    }
  }
}

std::uint32_t power_of_three(unsigned level) {
  std::uint32_t size = 1;
  for (unsigned i = 0; i < level; ++i) size *= 3;
  return size;
}

// Whether a cell survives: at no level are two of its base-3 digits 1.
bool sponge_cell(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
  for (; i != 0 || j != 0 || k != 0; i /= 3, j /= 3, k /= 3) {
    if ((i % 3 == 1) + (j % 3 == 1) + (k % 3 == 1) >= 2) return false;
  }
  return true;
}

Mesh unit_cube_at(double x, double y, double z) { return box({x, y, z}, {x + 1, y + 1, z + 1}); }

}  // namespace

std::uint64_t Random::next() { return mixed(state_ += golden); }

double Random::unit() { return unit_double(next()); }

double Random::between(double low, double high) { return low + unit() * (high - low); }

Point Random::direction() {
  for (;;) {
    const double x = between(-1, 1), y = between(-1, 1), z = between(-1, 1);
    const double square = x * x + y * y + z * z;
    if (square <= 1 && square > 1e-4) return unit_vector({x, y, z});
  }
}

Mesh box(const Point& low, const Point& high) {
  Mesh mesh;
  reserve(mesh, 8, 12);
  for (int corner = 0; corner < 8; ++corner) {
    add_point(mesh, {corner & 1 ? high[0] : low[0], corner & 2 ? high[1] : low[1], corner & 4 ? high[2] : low[2]});
  }
  add_quad(mesh, 0, 2, 3, 1);
  add_quad(mesh, 4, 5, 7, 6);
  add_quad(mesh, 0, 1, 5, 4);
  add_quad(mesh, 2, 6, 7, 3);
  add_quad(mesh, 0, 4, 6, 2);
  add_quad(mesh, 1, 3, 7, 5);
  return mesh;
}

Mesh sphere(const Point& center, double radius, std::size_t target_triangles) {
  const double target = static_cast<double>(std::max<std::size_t>(target_triangles, 8));
  // With n latitudes and m longitudes there are 2 m (n - 1) triangles; m = 2 n makes them nearly square.
  const auto n = static_cast<Index>(std::max(2.0, std::round((1 + std::sqrt(1 + target)) / 2)));
  const auto m = static_cast<Index>(std::max(3.0, std::round(target / (2.0 * (n - 1)))));
  Mesh mesh;
  reserve(mesh, std::size_t{m} * (n - 1) + 2, 2 * std::size_t{m} * (n - 1));
  const Index south = add_point(mesh, center - Point{0, 0, radius});
  for (Index i = 1; i < n; ++i) {
    const double angle = std::numbers::pi * i / n;
    add_ring(mesh, center - Point{0, 0, radius * std::cos(angle)}, {1, 0, 0}, {0, 1, 0}, radius * std::sin(angle), m);
  }
  const Index north = add_point(mesh, center + Point{0, 0, radius});
  add_lower_cap(mesh, south, 1, m);
  for (Index i = 0; i + 2 < n; ++i) add_band(mesh, 1 + i * m, 1 + (i + 1) * m, m);
  add_upper_cap(mesh, north, 1 + (n - 2) * m, m);
  return mesh;
}

Mesh geodesic_sphere(const Point& center, double radius, std::uint32_t frequency) {
  Mesh mesh = GeodesicBuilder(std::max<Index>(frequency, 1)).take();
  place(mesh, center, radius);
  return mesh;
}

Mesh icosphere(const Point& center, double radius, unsigned level) {
  assert(level <= 12);
  return geodesic_sphere(center, radius, 1u << level);
}

Mesh bumpy_sphere(const Point& center, double radius, std::size_t target_triangles, std::uint64_t seed) {
  const double frequency = std::round(std::sqrt(static_cast<double>(target_triangles) / 20));
  Mesh mesh = GeodesicBuilder(static_cast<Index>(std::max(1.0, frequency))).take();
  const Point shift{17.25, 23.5, 31.75};
  for (std::size_t i = 0; i < mesh.points.size(); i += 3) {
    const Point d{mesh.points[i], mesh.points[i + 1], mesh.points[i + 2]};
    const double noise = 0.07 * value_noise(3 * d + shift, seed) + 0.05 * value_noise(8 * d + shift, seed ^ golden) +
                         0.025 * value_noise(20 * d + shift, seed + golden);
    for (std::size_t a = 0; a < 3; ++a) mesh.points[i + a] = (1 + noise) * d[a];
  }
  place(mesh, center, radius);
  return mesh;
}

Mesh torus(const Point& center, double radius, double tube, std::uint32_t along, std::uint32_t around) {
  assert(along >= 3 && around >= 3 && tube < radius);
  Mesh mesh;
  reserve(mesh, std::size_t{along} * around, 2 * std::size_t{along} * around);
  for (Index i = 0; i < along; ++i) {
    const double angle = two_pi * i / along;
    const Point out{std::cos(angle), std::sin(angle), 0};
    add_ring(mesh, center + radius * out, {0, 0, 1}, out, tube, around);
  }
  for (Index i = 0; i < along; ++i) add_band(mesh, i * around, (i + 1 == along ? 0 : i + 1) * around, around);
  return mesh;
}

Mesh torus_cut(const Point& center, double radius, double tube, double angle, std::uint32_t along,
               std::uint32_t around) {
  assert(along >= 1 && around >= 3 && tube < radius && angle > 0 && angle < two_pi);
  Mesh mesh;
  reserve(mesh, (std::size_t{along} + 1) * around + 2, 2 * (std::size_t{along} + 1) * around);
  Point out{};
  for (Index i = 0; i <= along; ++i) {
    out = {std::cos(angle * i / along), std::sin(angle * i / along), 0};
    add_ring(mesh, center + radius * out, {0, 0, 1}, out, tube, around);
  }
  for (Index i = 0; i < along; ++i) add_band(mesh, i * around, (i + 1) * around, around);
  add_lower_cap(mesh, add_point(mesh, center + Point{radius, 0, 0}), 0, around);
  add_upper_cap(mesh, add_point(mesh, center + radius * out), along * around, around);
  return mesh;
}

Mesh torus_knot(const Point& center, const Knot& knot, std::uint32_t along, std::uint32_t around) {
  assert(along >= 3 && around >= 3 && knot.minor < knot.radius);
  Mesh mesh;
  reserve(mesh, std::size_t{along} * around, 2 * std::size_t{along} * around);
  for (Index i = 0; i < along; ++i) {
    const double t = two_pi * i / along;
    const double u = knot.p * t, v = knot.q * t;
    const Point out{std::cos(u), std::sin(u), 0}, turn{-std::sin(u), std::cos(u), 0}, up{0, 0, 1};
    // The torus's normal and the curve's direction are perpendicular: the curve lies on the torus.
    const Point normal = std::cos(v) * out + std::sin(v) * up;
    const Point position = center + knot.radius * out + knot.minor * normal;
    const Point direction = unit_vector(knot.p * (knot.radius + knot.minor * std::cos(v)) * turn +
                                        knot.q * knot.minor * (std::cos(v) * up - std::sin(v) * out));
    add_ring(mesh, position, normal, cross(direction, normal), knot.tube, around);
  }
  for (Index i = 0; i < along; ++i) add_band(mesh, i * around, (i + 1 == along ? 0 : i + 1) * around, around);
  return mesh;
}

Mesh cylinder(const Point& from, const Point& to, double radius, std::uint32_t sides) {
  assert(sides >= 3);
  const Point axis = unit_vector(to - from);
  // Any vector far from the axis will do; x for the axis z makes the first corner lie at +x.
  const Point helper = std::abs(axis[0]) < 0.7 ? Point{1, 0, 0} : Point{0, 1, 0};
  const Point u = unit_vector(helper - dot(helper, axis) * axis);
  const Point v = cross(axis, u);
  Mesh mesh;
  reserve(mesh, 2 * std::size_t{sides} + 2, 4 * std::size_t{sides});
  const Index lower = add_ring(mesh, from, u, v, radius, sides);
  const Index upper = add_ring(mesh, to, u, v, radius, sides);
  add_band(mesh, lower, upper, sides);
  add_lower_cap(mesh, add_point(mesh, from), lower, sides);
  add_upper_cap(mesh, add_point(mesh, to), upper, sides);
  return mesh;
}

Mesh gear(const Gear& gear) {
  assert(gear.teeth >= 3 && gear.steps >= 8 && gear.root < gear.tip && gear.low < gear.high);
  const Index n = gear.teeth * gear.steps;
  Mesh mesh;
  reserve(mesh, 2 * std::size_t{n} + 2, 4 * std::size_t{n});
  for (const double z : {gear.low, gear.high}) {
    for (Index i = 0; i < n; ++i) {
      // From 0 in the middle of a gap to 1 in the middle of the tooth and back.
      const double phase = static_cast<double>(i % gear.steps) / gear.steps;
      const double rise = std::clamp((1 - std::abs(2 * phase - 1) - 0.36) / 0.26, 0.0, 1.0);
      const double radius = gear.root + (gear.tip - gear.root) * std::sin(rise * std::numbers::pi / 2);
      const double angle = two_pi * i / n;
      add_point(mesh, {radius * std::cos(angle), radius * std::sin(angle), z});
    }
  }
  add_band(mesh, 0, n, n);
  add_lower_cap(mesh, add_point(mesh, {0, 0, gear.low}), 0, n);
  add_upper_cap(mesh, add_point(mesh, {0, 0, gear.high}), n, n);
  return mesh;
}

Mesh diagonal_strip(std::size_t skinny_triangles, double length) {
  const auto quads = static_cast<Index>(std::max<std::size_t>(skinny_triangles / 4, 2));
  const Point across{0.1 * length, -0.1 * length, 0}, along{length, length, 0.1 * length};
  const Point thickness{0, 0, 0.02 * length};
  Mesh mesh;
  reserve(mesh, 4 * (std::size_t{quads} + 1), 6 * std::size_t{quads} + 4);
  // Four rails of quads + 1 points: near low, near high, far low, far high. The far end waves against the near end,
  // so that the rulings turn and no two skinny triangles share a plane.
  for (const double end : {0.0, 1.0}) {
    for (const double side : {0.0, 1.0}) {
      for (Index i = 0; i <= quads; ++i) {
        const double s = static_cast<double>(i) / quads;
        const double wave = 0.01 * length * std::sin(two_pi * (2 * s + 0.25 * end));
        add_point(mesh, s * across + end * along + side * thickness + Point{0, 0, wave});
      }
    }
  }
  const Index rail = quads + 1;
  const Index near_low = 0, near_high = rail, far_low = 2 * rail, far_high = 3 * rail;
  for (Index i = 0; i < quads; ++i) {
    add_quad(mesh, near_high + i, near_high + i + 1, far_high + i + 1, far_high + i);
    // Split along the same diagonal as the upper side, which keeps the two sides parallel.
    add_triangle(mesh, near_low + i, far_low + i + 1, near_low + i + 1);
    add_triangle(mesh, near_low + i, far_low + i, far_low + i + 1);
    add_quad(mesh, near_low + i, near_low + i + 1, near_high + i + 1, near_high + i);
    add_quad(mesh, far_low + i, far_high + i, far_high + i + 1, far_low + i + 1);
  }
  add_quad(mesh, near_low, near_high, far_high, far_low);
  add_quad(mesh, near_low + quads, far_low + quads, far_high + quads, near_high + quads);
  return mesh;
}

std::vector<Mesh> needles(std::size_t count, const Point& center, double half_length, double radius,
                          std::uint32_t sides, std::uint64_t seed) {
  Random random(seed);
  std::vector<Mesh> parts;
  for (std::size_t i = 0; i < count; ++i) {
    const Point reach = half_length * random.direction();
    parts.push_back(cylinder(center - reach, center + reach, radius, sides));
  }
  return parts;
}

std::vector<Mesh> menger_cells(unsigned level) {
  assert(level <= 4);
  const std::uint32_t size = power_of_three(level);
  std::vector<Mesh> parts;
  for (std::uint32_t k = 0; k < size; ++k) {
    for (std::uint32_t j = 0; j < size; ++j) {
      for (std::uint32_t i = 0; i < size; ++i) {
        if (sponge_cell(i, j, k)) parts.push_back(unit_cube_at(i, j, k));
      }
    }
  }
  return parts;
}

std::vector<Mesh> menger_holes(unsigned level) {
  assert(level <= 4);
  const std::uint32_t size = power_of_three(level);
  std::vector<std::array<std::uint32_t, 3>> holes;
  add_holes(holes, 0, 0, size);
  std::vector<Mesh> parts;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const auto& [x, y, width] : holes) {
      Point low{}, high{};
      low[axis] = -1.0;
      high[axis] = size + 1.0;
      low[(axis + 1) % 3] = x;
      high[(axis + 1) % 3] = x + width;
      low[(axis + 2) % 3] = y;
      high[(axis + 2) % 3] = y + width;
      parts.push_back(box(low, high));
    }
  }
  return parts;
}

std::vector<Mesh> cube_grid(std::uint32_t n, double pitch) {
  std::vector<Mesh> parts;
  for (std::uint32_t k = 0; k < n; ++k) {
    for (std::uint32_t j = 0; j < n; ++j) {
      for (std::uint32_t i = 0; i < n; ++i) parts.push_back(unit_cube_at(pitch * i, pitch * j, pitch * k));
    }
  }
  return parts;
}

std::vector<Mesh> drills(std::uint32_t columns, std::uint32_t rows, std::uint32_t sides) {
  std::vector<Mesh> parts;
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      parts.push_back(cylinder({i + 0.5, j + 0.5, -0.5}, {i + 0.5, j + 0.5, 1.5}, 0.3, sides));
    }
  }
  return parts;
}

std::vector<Mesh> sphere_cloud(std::size_t count, std::size_t triangles, std::uint64_t seed) {
  Random random(seed);
  const double mean = 0.6 / std::cbrt(static_cast<double>(std::max<std::size_t>(count, 1)));
  std::vector<Mesh> parts;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.unit(), y = random.unit(), z = random.unit();
    parts.push_back(sphere({x, y, z}, mean * random.between(0.7, 1.3), triangles));
  }
  return parts;
}

Mesh joined(const std::vector<Mesh>& parts) {
  Mesh mesh;
  for (const Mesh& part : parts) {
    const auto base = static_cast<Index>(mesh.points.size() / 3);
    mesh.points.insert(mesh.points.end(), part.points.begin(), part.points.end());
    for (const Index index : part.triangles) mesh.triangles.push_back(base + index);
  }
  return mesh;
}

}  // namespace quoin::examples
