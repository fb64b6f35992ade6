#include <array>
#include <cmath>
#include <utility>

#include "examples/models.h"
#include "tests/corpus/folder.h"

namespace quoin::corpus {
namespace {

using examples::Point;

/// On binary grids meshes hardly move, 1/1000 merges points and makes triangles nothing.
constexpr std::array steps{"", " --step 1/16777216", " --step 1/1000"};

Mesh scaled(Mesh mesh, const Point& by) {
  for (std::size_t i = 0; i < mesh.points.size(); ++i) mesh.points[i] *= by[i % 3];
  return mesh;
}

/// Rotated by 7 degrees about (1, 2, 3).
Mesh turned(Mesh mesh) {
  const double length = std::sqrt(14.0), angle = 7 * std::acos(-1.0) / 180, c = std::cos(angle), s = std::sin(angle);
  const Point n{1 / length, 2 / length, 3 / length};
  for (std::size_t i = 0; i < mesh.points.size(); i += 3) {
    const Point p{mesh.points[i], mesh.points[i + 1], mesh.points[i + 2]};
    const double along = (p[0] * n[0] + p[1] * n[1] + p[2] * n[2]) * (1 - c);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
      mesh.points[i + k] = p[k] * c + (n[u] * p[v] - n[v] * p[u]) * s + n[k] * along;
    }
  }
  return mesh;
}

/// The mirror image in x = 1/2, a little higher.
Mesh mirrored(Mesh mesh) {
  for (std::size_t i = 0; i < mesh.points.size(); i += 3) {
    mesh.points[i] = 1 - mesh.points[i];
    mesh.points[i + 2] += 0.003;
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) std::swap(mesh.triangles[i], mesh.triangles[i + 1]);
  return mesh;
}

/// Two meshes of about one size under all operations, on all grids.
void add_pair(Folder& folder, const std::string& name, const Mesh& first, const Mesh& second) {
  const std::string files = folder.mesh(name + "-a.off", first) + " " + folder.mesh(name + "-b.off", second);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::string id = name + "-" + std::to_string(i);
    folder.operation(id + "-union", "union " + files + steps[i]);
    folder.operation(id + "-intersection", "intersection " + files + steps[i]);
    folder.operation(id + "-difference", "difference " + files + steps[i]);
    folder.operation(id + "-odd", "symmetric-difference " + files + steps[i]);
  }
}

void add_pairs(Folder& folder) {
  const auto ball = [](double x, std::uint32_t frequency) {
    return examples::geodesic_sphere({x, 0, 0}, 1, frequency);
  };
  add_pair(folder, "spheres", ball(0, 12), ball(0.5, 12));
  add_pair(folder, "same_sphere", ball(0, 8), ball(0, 8));
  add_pair(folder, "bumpy", examples::bumpy_sphere({0, 0, 0}, 1, 3000, 1),
           examples::bumpy_sphere({0, 0, 0}, 1, 3000, 2));
  add_pair(folder, "tori", examples::torus({0, 0, 0}, 0.75, 0.25, 48, 24),
           examples::torus_cut({0.5, 0, 0}, 0.75, 0.25, 4.5, 40, 24));
  examples::Gear gear;
  add_pair(folder, "gears", examples::gear(gear), turned(examples::gear(gear)));
  add_pair(folder, "strips", examples::diagonal_strip(300, 1), mirrored(examples::diagonal_strip(300, 1)));
  add_pair(folder, "cylinders", examples::cylinder({0, 0, -1}, {0, 0, 1}, 1, 96),
           examples::cylinder({0, 0, -1}, {0, 0, 1.5}, 0.5, 60));
}

/// Meshes of 20,000 triangles.
void add_large(Folder& folder) {
  const Mesh knot = examples::torus_knot({0, 0, 0}, {2, 9, 26, 11.5, 4}, 640, 16);
  const std::string a = folder.mesh("knot-a.off", knot), b = folder.mesh("knot-b.stl", turned(knot));
  folder.operation("large-knot", "union " + a + " " + b + " --step 1/65536");
  folder.operation("large-knot-cut",
                   "split @large-knot.quoin --plane 1,2,3,1/2 -o @large-knot-above.quoin"
                   " @large-knot-below.quoin");
  folder.operation("large-knot-moved", "move " + a + " --rotate 3,1,2 33 --translate 1 -1/3 0");

  const std::string bumpy = folder.mesh("bumpy-large-a.off", examples::bumpy_sphere({0, 0, 0}, 1, 20000, 1)) + " " +
                            folder.mesh("bumpy-large-b.stl", examples::bumpy_sphere({0, 0, 0}, 1, 20000, 2));
  folder.operation("large-bumpy", "union " + bumpy);
  folder.operation("large-bumpy-odd", "symmetric-difference " + bumpy + " --step 1/100000");

  const std::string strips = folder.mesh("strip-large-a.off", examples::diagonal_strip(1500, 1)) + " " +
                             folder.mesh("strip-large-b.off", mirrored(examples::diagonal_strip(1500, 1)));
  folder.operation("large-strips", "union " + strips + " --step 1/16777216");
}

/// The part that the demo makes: an ellipsoid minus a knot, a bore and drills, intersected with a gear.
void add_housing(Folder& folder) {
  const std::string body = folder.mesh("body.off", scaled(examples::sphere({0, 0, 0}, 1, 12000), {42, 42, 26}));
  const std::string knot =
      folder.mesh("housing-knot.off", examples::torus_knot({0, 0, 0}, {2, 9, 26, 11.5, 4}, 480, 12));
  examples::Gear gear;
  gear.steps = 20;
  const std::string wheel = folder.mesh("housing-gear.off", scaled(examples::gear(gear), {42, 42, 54}));
  std::vector<Mesh> drills{examples::cylinder({0, 0, -30}, {0, 0, 30}, 11, 100)};
  for (int i = 0; i < 9; ++i) {
    const double angle = 40 * i * std::acos(-1.0) / 180, x = 28 * std::cos(angle), y = 28 * std::sin(angle);
    drills.push_back(examples::cylinder({x, y, -30}, {x, y, 30}, 2.5, 60));
  }

  const std::string whole = folder.operation("housing-body", "convert " + body + " --step 1/1000");
  const std::string carved = folder.operation("housing-carved", "difference " + whole + " " + knot);
  const std::string common = folder.operation("housing-common", "intersection " + whole + " " + knot);
  folder.operation("housing-again", "union " + carved + " " + common);
  const std::string drilled =
      folder.operation("housing-drilled", "difference " + carved + " " + folder.meshes("housing-drill", drills));
  const std::string part = folder.operation("housing-part", "intersection " + drilled + " " + wheel);
  folder.operation("housing-moved", "move " + part + " --rotate 1,2,3 7");
  folder.operation("housing-both", "union " + part + " @housing-moved.quoin");
  folder.operation("housing-outside", "complement " + part);
  folder.operation("housing-rest", "intersection @housing-outside.quoin " + body);
}

/// Small changes of a large host, one after another, with a branch.
void add_host(Folder& folder) {
  examples::Random random(7);
  std::string host =
      folder.operation("host-000", "convert " + folder.mesh("host.off", examples::geodesic_sphere({0, 0, 0}, 1, 32)) +
                                       " --step 1/65536");
  for (std::size_t i = 1; i <= 16; ++i) {
    const Point c = random.direction();
    const double r = random.between(0.02, 0.12);
    const Mesh tool = i % 3 == 0 ? examples::box({c[0] - r, c[1] - r, c[2] - r}, {c[0] + r, c[1] + r, c[2] + r})
                                 : examples::icosphere(c, r, 2);
    const std::string file = folder.mesh("host-tool-" + numbered(i) + ".off", tool);
    const std::string id = "host-" + numbered(i);
    if (i % 5 == 0) folder.operation(id + "-branch", "symmetric-difference " + host + " " + file);
    if (i % 7 == 0) folder.operation(id + "-inside", "intersection " + host + " " + file);
    host = folder.operation(id, (i % 4 == 0 ? "union " : "difference ") + host + " " + file);
  }
  folder.operation("host-outside", "complement " + host);
  folder.operation("host-cut", "split " + host + " --plane 1,0,0,0 -o @host-above.quoin @host-below.quoin");
  folder.operation("host-whole", "union @host-above.quoin @host-below.quoin");
}

/// Many operands of one operation, and the same parts as components of one mesh.
void add_many(Folder& folder, const std::string& name, const std::vector<Mesh>& parts, const std::string& options) {
  const std::string files = folder.meshes(name, parts);
  folder.operation("many-" + name + "-union", "union " + files + options);
  folder.operation("many-" + name + "-odd", "symmetric-difference " + files + options);
  folder.operation("many-" + name + "-joined",
                   "convert " + folder.mesh(name + "-joined.off", examples::joined(parts)) + options);
}

/// Many tools out of one plate, as operands and as one mesh.
void add_plate(Folder& folder, const std::string& name, const Mesh& plate, const std::vector<Mesh>& tools) {
  const std::string file = folder.mesh(name + "-plate.off", plate), step = " --step 1/65536";
  folder.operation("many-" + name, "difference " + file + " " + folder.meshes(name + "-tool", tools) + step);
  const std::string together = folder.mesh(name + "-tools.off", examples::joined(tools));
  folder.operation("many-" + name + "-together", "difference " + file + " " + together + step);
  folder.operation("many-" + name + "-common", "intersection " + file + " " + together + step);
}

void add_sets(Folder& folder) {
  add_many(folder, "cubes", examples::cube_grid(4, 1.0), " --step 1/65536");
  add_many(folder, "overlapping_cubes", examples::cube_grid(3, 0.75), "");
  add_many(folder, "cloud", examples::sphere_cloud(24, 320, 3), " --step 1/16777216");
  add_many(folder, "needles", examples::needles(16, {0, 0, 0}, 1, 0.01, 3, 5), " --step 1/16777216");
  add_many(folder, "menger_cells", examples::menger_cells(1), "");
  folder.operation("many-sponge", "convert " + folder.mesh("sponge.off", examples::joined(examples::menger_cells(2))));

  const double third = 9;
  add_plate(folder, "menger", examples::box({0, 0, 0}, {third, third, third}), examples::menger_holes(2));
  add_plate(folder, "drilled", examples::box({0, 0, 0}, {6, 6, 1}), examples::drills(6, 6, 64));
  add_plate(folder, "sieve", examples::box({0, 0, 0}, {14, 14, 1}), examples::drills(14, 14, 12));
}

/// Surfaces that cross themselves, alone and as operands.
void add_crossings(Folder& folder) {
  const std::string ball = folder.mesh("crossing-ball.off", examples::geodesic_sphere({1, 0.3, 0.2}, 1, 10));
  examples::Gear gear;
  const Mesh wheel = examples::gear(gear);
  const std::vector<std::pair<std::string, Mesh>> meshes{
      {"knot", examples::torus_knot({0, 0, 0}, {2, 3, 1, 0.4, 0.45}, 120, 12)},
      {"fat_knot", examples::torus_knot({0, 0, 0}, {3, 7, 1, 0.5, 0.3}, 280, 9)},
      {"gears", examples::joined({wheel, turned(wheel)})},
      {"spheres", examples::joined(examples::sphere_cloud(12, 320, 9))},
      {"drills", examples::joined({examples::cylinder({-1, 0, 0}, {1, 0, 0}, 0.3, 40),
                                   examples::cylinder({0, -1, 0}, {0, 1, 0}, 0.3, 40),
                                   examples::cylinder({0, 0, -1}, {0, 0, 1}, 0.3, 40)})},
      {"twice", examples::joined({wheel, wheel})},
  };
  for (const auto& [name, mesh] : meshes) {
    const std::string file = folder.mesh("crossing-" + name + ".off", mesh), id = "crossing-" + name;
    const std::string solid = folder.operation(id, "convert " + file);
    folder.operation(id + "-coarse", "convert " + file + " --step 1/100");
    folder.operation(id + "-union", "union " + file + " " + ball);
    folder.operation(id + "-difference", "difference " + ball + " " + solid);
  }
}

}  // namespace

void add_meshes(Folder& folder) {
  add_pairs(folder);
  add_large(folder);
  add_housing(folder);
  add_host(folder);
  add_sets(folder);
  add_crossings(folder);
}

}  // namespace quoin::corpus
