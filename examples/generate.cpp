/// \file
/// quoin-generate: writes the models of examples/models.h as files.

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "examples/mesh_file.h"
#include "examples/models.h"

namespace quoin::examples {
namespace {

struct Request {
  std::string kind, output;
  std::size_t size = 0;
  std::uint64_t seed = 1;
  Point offset{0, 0, 0}, scale{1, 1, 1};
  std::size_t axis = 2;
  std::size_t part = 0;  // 0: all; parts are counted from 1.
  bool together = false;
  std::optional<Knot> knot;
};

struct Kind {
  const char* name;
  std::size_t default_size;
  const char* meaning;
  std::function<std::vector<Mesh>(const Request&)> make;
};

std::uint32_t index32(std::size_t value) { return static_cast<std::uint32_t>(std::min<std::size_t>(value, 1u << 30)); }

// Segments along and around a tube of about `triangles` triangles that is `slenderness` times as long as thick.
std::array<std::uint32_t, 2> tube_segments(std::size_t triangles, double slenderness) {
  const double quads = static_cast<double>(triangles) / 2;
  const double around = std::max(3.0, std::round(std::sqrt(quads / slenderness)));
  return {static_cast<std::uint32_t>(std::max(3.0, std::round(quads / around))), static_cast<std::uint32_t>(around)};
}

std::uint32_t ceiling_root(std::size_t n) {
  auto root = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(n)));
  while (std::uint64_t{root} * root < n) ++root;
  return root;
}

Mesh knot_of(const Request& r) {
  const Knot knot = r.knot.value_or(Knot{2, 3, 0.65, 0.25, 0.1});
  const auto [along, around] = tube_segments(r.size, (knot.p * knot.radius + knot.q * knot.minor) / knot.tube);
  return torus_knot({0, 0, 0}, knot, along, around);
}

Mesh gear_of(const Request& r) {
  Gear wheel;
  wheel.steps = index32(std::max<std::size_t>(r.size / (4 * wheel.teeth), 8));
  return gear(wheel);
}

Mesh torus_of(const Request& r) {
  const auto [along, around] = tube_segments(r.size, 0.75 / 0.25);
  return torus({0, 0, 0}, 0.75, 0.25, along, around);
}

Mesh torus_cut_of(const Request& r) {
  const auto [along, around] = tube_segments(r.size, 0.75 * 0.75 / 0.25);
  return torus_cut({0, 0, 0}, 0.75, 0.25, 4.5, along, around);
}

std::uint32_t geodesic_frequency(std::size_t triangles) {
  return index32(static_cast<std::size_t>(std::max(1.0, std::round(std::sqrt(static_cast<double>(triangles) / 20)))));
}

std::vector<Mesh> plate_drills(const Request& r) {
  const std::uint32_t n = ceiling_root(r.size);
  std::vector<Mesh> parts = drills(n, n, 32);
  parts.resize(std::min(parts.size(), r.size));
  return parts;
}

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {"box", 12, "cube -1 .. 1",
       [](const Request&) {
         return std::vector<Mesh>{box({-1, -1, -1}, {1, 1, 1})};
       }},
      {"sphere", 20000, "latitudes and longitudes; size: triangles",
       [](const Request& r) {
         return std::vector<Mesh>{sphere({0, 0, 0}, 1, r.size)};
       }},
      {"icosphere", 1280, "divided icosahedron; size: triangles, nearest 20 n^2",
       [](const Request& r) {
         return std::vector<Mesh>{geodesic_sphere({0, 0, 0}, 1, geodesic_frequency(r.size))};
       }},
      {"bumpy", 200000, "icosphere with noise of the seed; size: triangles",
       [](const Request& r) {
         return std::vector<Mesh>{bumpy_sphere({0, 0, 0}, 1, r.size, r.seed)};
       }},
      {"torus", 20000, "radii 0.75 and 0.25; size: triangles",
       [](const Request& r) { return std::vector<Mesh>{torus_of(r)}; }},
      {"torus-cut", 20000, "the torus up to 4.5 rad, capped; size: triangles",
       [](const Request& r) { return std::vector<Mesh>{torus_cut_of(r)}; }},
      {"knot", 20000, "torus knot, see --knot; size: triangles",
       [](const Request& r) { return std::vector<Mesh>{knot_of(r)}; }},
      {"cylinder", 256, "radius 1, height -1 .. 1; size: triangles",
       [](const Request& r) {
         return std::vector<Mesh>{cylinder({0, 0, -1}, {0, 0, 1}, 1, std::max(index32(r.size / 4), 3u))};
       }},
      {"gear", 2304, "spur gear of 24 teeth, radius 1, height -0.25 .. 0.25; size: triangles",
       [](const Request& r) { return std::vector<Mesh>{gear_of(r)}; }},
      {"strip", 10000, "slab of long thin diagonal triangles; size: their number",
       [](const Request& r) { return std::vector<Mesh>{diagonal_strip(r.size, 1)}; }},
      {"plate", 100, "box (0, 0, 0) .. (n, n, 1) for the drills; size: n^2",
       [](const Request& r) {
         const double n = ceiling_root(r.size);
         return std::vector<Mesh>{box({0, 0, 0}, {n, n, 1})};
       }},
      {"drills", 100, "set: cylinders through the plate; size: their number", plate_drills},
      {"cubes", 3, "set: n^3 touching unit cubes; size: n",
       [](const Request& r) { return cube_grid(index32(r.size), 1); }},
      {"spheres", 100, "set: overlapping spheres of 320 triangles; size: their number",
       [](const Request& r) { return sphere_cloud(r.size, 320, r.seed); }},
      {"needles", 50, "set: long prisms through the origin; size: their number",
       [](const Request& r) {
         return needles(r.size, {0, 0, 0}, 1, 0.005, 5, r.seed);
       }},
      {"menger-cells", 2, "set: unit cubes of the sponge of size 3^level; size: level, at most 4",
       [](const Request& r) { return menger_cells(std::min(index32(r.size), 4u)); }},
      {"menger-holes", 2, "set: prisms to subtract from a cube of size 3^level; size: level, at most 4",
       [](const Request& r) { return menger_holes(std::min(index32(r.size), 4u)); }},
  };
  return all;
}

void print_usage(std::FILE* out) {
  std::fputs(
      "quoin-generate KIND -o FILE.off|FILE.stl [options]\n"
      "  --size N             how large, see below\n"
      "  --seed S             for kinds with random numbers\n"
      "  --scale S | X,Y,Z    multiplies coordinates; positive\n"
      "  --axis x|y|z         turns the model's z axis there\n"
      "  --offset X Y Z       added last\n"
      "  --knot P,Q,R,M,T     windings about the axis and through the hole, radii of torus, its tube, and the knot\n"
      "  --part I             of a set: only part I, counted from 1\n"
      "  --together           of a set: all parts in one file\n"
      "A set writes FILE_0001.off, FILE_0002.off, ...\n"
      "Kinds (and default size):\n",
      out);
  for (const Kind& kind : kinds()) {
    std::fprintf(out, "  %-14s %-8zu %s\n", kind.name, kind.default_size, kind.meaning);
  }
}

bool parse(std::string_view text, double& value) {
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc{} && result.ptr == text.data() + text.size() && std::isfinite(value);
}

bool parse(std::string_view text, std::uint64_t& value) {
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc{} && result.ptr == text.data() + text.size();
}

bool parse_list(std::string_view text, std::vector<double>& values) {
  for (;;) {
    const std::size_t comma = text.find(',');
    if (!parse(text.substr(0, comma), values.emplace_back())) return false;
    if (comma == std::string_view::npos) return true;
    text.remove_prefix(comma + 1);
  }
}

bool parse_scale(std::string_view text, Point& scale) {
  std::vector<double> values;
  if (!parse_list(text, values) || (values.size() != 1 && values.size() != 3)) return false;
  for (std::size_t a = 0; a < 3; ++a) scale[a] = values[values.size() == 1 ? 0 : a];
  return std::all_of(scale.begin(), scale.end(), [](double s) { return s > 0; });
}

bool parse_knot(std::string_view text, std::optional<Knot>& knot) {
  std::vector<double> v;
  if (!parse_list(text, v) || v.size() != 5) return false;
  if (!std::all_of(v.begin(), v.end(), [](double s) { return s > 0; })) return false;
  if (v[0] < 1 || v[0] > 1000 || v[1] < 1 || v[1] > 1000 || v[3] >= v[2]) return false;
  knot = Knot{static_cast<std::uint32_t>(v[0]), static_cast<std::uint32_t>(v[1]), v[2], v[3], v[4]};
  return true;
}

bool parse_axis(std::string_view text, std::size_t& axis) {
  axis = text == "x" ? 0 : text == "y" ? 1 : 2;
  return text == "x" || text == "y" || text == "z";
}

bool parse_option(const std::vector<std::string_view>& words, std::size_t& i, Request& request) {
  const std::string_view name = words[i];
  const auto value = [&]() { return i + 1 < words.size() ? words[++i] : std::string_view{}; };
  std::uint64_t number = 0;
  if (name == "-o") return !(request.output = value()).empty();
  if (name == "--together") return request.together = true;
  if (name == "--seed") return parse(value(), request.seed);
  if (name == "--scale") return parse_scale(value(), request.scale);
  if (name == "--axis") return parse_axis(value(), request.axis);
  if (name == "--knot") return parse_knot(value(), request.knot);
  if (name == "--offset") {
    return std::all_of(request.offset.begin(), request.offset.end(), [&](double& c) { return parse(value(), c); });
  }
  if (name == "--size" && parse(value(), number) && number > 0) {
    request.size = number;
    return true;
  }
  if (name == "--part" && parse(value(), number) && number > 0) {
    request.part = number;
    return true;
  }
  if (name.empty() || name[0] == '-' || !request.kind.empty()) return false;
  request.kind = name;
  return true;
}

void place(Mesh& mesh, const Request& request) {
  for (std::size_t i = 0; i < mesh.points.size(); i += 3) {
    const Point p{mesh.points[i], mesh.points[i + 1], mesh.points[i + 2]};
    for (std::size_t a = 0; a < 3; ++a) {
      // A cyclic exchange of coordinates that takes z to the axis asked for; it keeps the orientation.
      const std::size_t to = (a + request.axis + 1) % 3;
      mesh.points[i + to] = p[a] * request.scale[to] + request.offset[to];
    }
  }
}

std::string numbered(const std::string& path, std::size_t part) {
  const std::size_t dot = path.find_last_of('.');
  std::array<char, 24> number{};
  std::snprintf(number.data(), number.size(), "_%04zu", part);
  return path.substr(0, dot) + number.data() + (dot == std::string::npos ? "" : path.substr(dot));
}

int write(const std::string& path, Mesh mesh, const Request& request) {
  place(mesh, request);
  const Result<void> written = write_mesh_file(path, mesh);
  if (written) return 0;
  std::cerr << "quoin-generate: " << path << ": " << written.error().message << '\n';
  return 1;
}

int generate(const Kind& kind, const Request& request) {
  std::vector<Mesh> parts = kind.make(request);
  if (request.part > parts.size()) {
    std::cerr << "quoin-generate: there are only " << parts.size() << " parts\n";
    return 1;
  }
  if (request.part > 0) return write(request.output, std::move(parts[request.part - 1]), request);
  if (request.together) return write(request.output, joined(parts), request);
  const bool set = std::string_view(kind.meaning).substr(0, 4) == "set:";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string path = set ? numbered(request.output, i + 1) : request.output;
    if (const int code = write(path, std::move(parts[i]), request); code != 0) return code;
  }
  return 0;
}

int run(const std::vector<std::string_view>& words) {
  if (words.size() == 1 && words[0] == "--help") {
    print_usage(stdout);
    return 0;
  }
  Request request;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (parse_option(words, i, request)) continue;
    std::cerr << "quoin-generate: wrong argument near '" << words[std::min(i, words.size() - 1)] << "'\n";
    return 2;
  }
  const auto kind = std::find_if(kinds().begin(), kinds().end(), [&](const Kind& k) { return k.name == request.kind; });
  if (kind == kinds().end() || request.output.empty()) {
    print_usage(stderr);
    return 2;
  }
  if (request.size == 0) request.size = kind->default_size;
  return generate(*kind, request);
}

}  // namespace
}  // namespace quoin::examples

int main(int argc, char** argv) { return quoin::examples::run(std::vector<std::string_view>(argv + 1, argv + argc)); }
