/// \file
/// quoin-render: a picture of a mesh without a display.
///
/// Every sample of the picture finds its nearest triangle by a z-buffer; light then comes from many directions, each
/// with its own depth map, which gives soft shadows, ambient occlusion and a shadow on the floor.

#include <png.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "examples/mesh_file.h"
#include "examples/raster.h"

namespace quoin::examples {
namespace {

constexpr int supersampling = 2;
constexpr double radians = std::numbers::pi / 180;
constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t floor_id = nothing - 1;

struct Request {
  std::string input, output;
  int width = 1200, height = 900;
  double azimuth = 35, elevation = 25;
  double crease = 30;
  Vector color{0.17, 0.36, 0.55};
};

/// A mesh with what shading needs: a normal for each corner of each triangle.
struct Model {
  std::vector<Vector> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<float, 3>> corner_normals;
  Vector center{};
  double radius = 1, lowest = 0;
};

std::array<float, 3> narrow(const Vector& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}
Vector widen(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

/// Averages the normals of the triangles around each point that lie within the crease angle, weighted by area.
void add_corner_normals(Model& model, double crease) {
  // Averaging compares each pair around a point; where very many meet, a corner keeps its triangle's own normal.
  constexpr std::uint32_t most_around_point = 64;
  const double limit = std::cos(crease * radians);
  std::vector<Vector> areas, normals;
  std::vector<std::uint32_t> start(model.points.size() + 1, 0);
  for (const auto& t : model.triangles) {
    const Vector& a = model.points[t[0]];
    areas.push_back(cross(model.points[t[1]] - a, model.points[t[2]] - a));
    normals.push_back(normalized(areas.back()));
    for (const std::uint32_t v : t) ++start[v + 1];
  }
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  std::vector<std::uint32_t> around(3 * model.triangles.size()), fill(start.begin(), start.end() - 1);
  for (std::uint32_t f = 0; f < model.triangles.size(); ++f) {
    for (const std::uint32_t v : model.triangles[f]) around[fill[v]++] = f;
  }
  model.corner_normals.resize(3 * model.triangles.size());
  for (std::size_t f = 0; f < model.triangles.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = model.triangles[f][i];
      Vector sum = areas[f];
      if (start[v + 1] - start[v] <= most_around_point) {
        for (std::uint32_t k = start[v]; k < start[v + 1]; ++k) {
          if (around[k] != f && dot(normals[f], normals[around[k]]) > limit) sum = sum + areas[around[k]];
        }
      }
      model.corner_normals[3 * f + i] = narrow(normalized(sum));
    }
  }
}

Model make_model(const Mesh& mesh, double crease) {
  Model model;
  Vector low{}, high{};
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < mesh.points.size(); i += 3) {
    model.points.push_back({mesh.points[i], mesh.points[i + 1], mesh.points[i + 2]});
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], mesh.points[i + a]);
      high[a] = std::max(high[a], mesh.points[i + a]);
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    model.triangles.push_back({mesh.triangles[t], mesh.triangles[t + 1], mesh.triangles[t + 2]});
  }
  model.center = 0.5 * (low + high);
  double radius = 0;
  for (const Vector& p : model.points) radius = std::max(radius, length(p - model.center));
  if (radius > 0) model.radius = radius;
  model.lowest = low[2];
  add_corner_normals(model, crease);
  return model;
}

/// A perspective camera that looks at the model's centre and fits the model into the picture.
class Camera {
 public:
  Camera(const Model& model, const Request& request, int width, int height)
      : frame_(frame_toward(direction(request.azimuth, request.elevation))) {
    eye_ = model.center + 5.5 * model.radius * frame_.toward;
    double left = 1e300, right = -1e300, top = 1e300, bottom = -1e300;
    for (const Vector& p : model.points) {
      const ScreenPoint s = project(p);
      left = std::min(left, s.x);
      right = std::max(right, s.x);
      top = std::min(top, s.y);
      bottom = std::max(bottom, s.y);
    }
    constexpr double used = 0.80;
    zoom_ = used * std::min(width / std::max(right - left, 1e-9), height / std::max(bottom - top, 1e-9));
    shift_ = {0.5 * width - 0.5 * zoom_ * (left + right), 0.5 * height - 0.5 * zoom_ * (top + bottom)};
  }

  /// From the model to the camera; x turned by `azimuth` degrees about z and raised by `elevation`.
  static Vector direction(double azimuth, double elevation) {
    const double a = (azimuth - 90) * radians, e = elevation * radians;
    return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
  }

  double distance(const Vector& p) const { return dot(eye_ - p, frame_.toward); }
  ScreenPoint project(const Vector& p) const {
    const Vector d = p - eye_;
    const double scale = zoom_ / distance(p);
    return {shift_.x + scale * dot(d, frame_.right), shift_.y - scale * dot(d, frame_.up)};
  }
  /// The direction in which the eye sees a sample.
  Vector ray(int x, int y) const {
    const double u = (x + 0.5 - shift_.x) / zoom_, v = (shift_.y - y - 0.5) / zoom_;
    return u * frame_.right + v * frame_.up - frame_.toward;
  }
  const Vector& eye() const { return eye_; }
  const Frame& frame() const { return frame_; }

 private:
  Frame frame_;
  Vector eye_{};
  double zoom_ = 1;
  ScreenPoint shift_{0, 0};
};

/// What each sample of the picture shows, and the light it receives.
struct Samples {
  int width = 0, height = 0;
  std::vector<std::uint32_t> id;
  std::vector<std::array<float, 3>> position, normal;
  std::vector<float> key, sky;
};

void find_visible(const Model& model, const Camera& camera, Samples& samples) {
  const std::size_t count = static_cast<std::size_t>(samples.width) * static_cast<std::size_t>(samples.height);
  samples.id.assign(count, nothing);
  samples.position.resize(count);
  samples.normal.resize(count);
  std::vector<float> nearness(count, 0);
  std::vector<ScreenPoint> screen;
  std::vector<double> inverse;
  for (const Vector& p : model.points) {
    screen.push_back(camera.project(p));
    inverse.push_back(1 / camera.distance(p));
  }
  for (std::uint32_t f = 0; f < model.triangles.size(); ++f) {
    const auto& t = model.triangles[f];
    const auto plot = [&](int x, int y, std::array<double, 3> w) {
      const std::size_t at =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(samples.width) + static_cast<std::size_t>(x);
      for (std::size_t i = 0; i < 3; ++i) w[i] *= inverse[t[i]];
      const double sum = w[0] + w[1] + w[2];
      if (static_cast<float>(sum) <= nearness[at]) return;
      nearness[at] = static_cast<float>(sum);
      Vector position{}, normal{};
      for (std::size_t i = 0; i < 3; ++i) {
        position = position + (w[i] / sum) * model.points[t[i]];
        normal = normal + (w[i] / sum) * widen(model.corner_normals[3 * std::size_t{f} + i]);
      }
      samples.id[at] = f;
      samples.position[at] = narrow(position);
      samples.normal[at] = narrow(normalized(normal));
    };
    scan_triangle({screen[t[0]], screen[t[1]], screen[t[2]]}, samples.width, samples.height, plot);
  }
}

/// Lays a floor under the model where the eye sees nothing else, as far as the model's shadow may reach.
void add_floor(const Model& model, const Camera& camera, Samples& samples) {
  const double height = model.lowest - 0.002 * model.radius;
  std::size_t at = 0;
  for (int y = 0; y < samples.height; ++y) {
    for (int x = 0; x < samples.width; ++x, ++at) {
      if (samples.id[at] != nothing) continue;
      const Vector ray = camera.ray(x, y);
      if (ray[2] >= 0 || camera.eye()[2] <= height) continue;
      const Vector p = camera.eye() + ((height - camera.eye()[2]) / ray[2]) * ray;
      if (length(p - model.center) > 6 * model.radius) continue;
      samples.id[at] = floor_id;
      samples.position[at] = narrow(p);
      samples.normal[at] = {0, 0, 1};
    }
  }
}

/// A direction towards light and how strongly it counts as key light and as light of the sky.
struct Light {
  Vector direction;
  double key, sky;
};

/// Directions spread evenly over a cap about `axis`, from the axis down to the cosine `lowest`.
std::vector<Vector> spread_directions(const Vector& axis, double lowest, int count) {
  const Frame frame = frame_toward(axis);
  std::vector<Vector> directions;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (1 - lowest) * (i + 0.5) / count;
    const double r = std::sqrt(std::max(0.0, 1 - z * z));
    const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    directions.push_back(r * std::cos(angle) * frame.right + r * std::sin(angle) * frame.up + z * frame.toward);
  }
  return directions;
}

std::vector<Light> make_lights(const Camera& camera) {
  const Frame& frame = camera.frame();
  // The key light stands to the left of the camera, always above the floor.
  Vector key = frame.toward - 0.75 * frame.right + 0.55 * frame.up;
  key[2] = std::max(key[2], 0.55);
  constexpr int key_count = 32, sky_count = 112;
  std::vector<Light> lights;
  for (const Vector& d : spread_directions(key, std::cos(9 * radians), key_count)) {
    lights.push_back({d, 1.0 / key_count, 0});
  }
  for (const Vector& d : spread_directions({0, 0, 1}, -1, sky_count)) {
    // Each direction stands for 4 pi / count of the sphere; a surface under an even sky receives 1.
    lights.push_back({d, 0, (0.62 + 0.38 * d[2]) * 4.0 / sky_count});
  }
  return lights;
}

/// The heights towards a light that the model reaches, on a square map of the model's bounding sphere.
class DepthMap {
 public:
  DepthMap(const Model& model, const Light& light)
      : frame_(frame_toward(light.direction)), center_(model.center), scale_(0.5 * size / (1.01 * model.radius)) {
    heights_.assign(static_cast<std::size_t>(size) * size, -std::numeric_limits<float>::infinity());
    std::vector<ScreenPoint> screen;
    std::vector<double> height;
    for (const Vector& p : model.points) {
      screen.push_back(project(p));
      height.push_back(dot(p - center_, frame_.toward));
    }
    for (const auto& t : model.triangles) {
      const std::array<ScreenPoint, 3> corners{screen[t[0]], screen[t[1]], screen[t[2]]};
      if (front_area(corners) <= 0) continue;  // What a light meets first faces it.
      scan_triangle(corners, size, size, [&](int x, int y, const std::array<double, 3>& w) {
        float& slot = heights_[static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x)];
        const double h = w[0] * height[t[0]] + w[1] * height[t[1]] + w[2] * height[t[2]];
        slot = std::max(slot, static_cast<float>(h));
      });
    }
  }

  /// `jitter` moves the look-up by so many cells: it turns the steps of the map into fine grain.
  bool in_shadow(const Vector& p, double bias, const ScreenPoint& jitter) const {
    ScreenPoint s = project(p);
    s = {s.x + jitter.x, s.y + jitter.y};
    if (!(s.x >= 0 && s.y >= 0 && s.x < size && s.y < size)) return false;
    const float height = heights_[static_cast<std::size_t>(s.y) * size + static_cast<std::size_t>(s.x)];
    return height > dot(p - center_, frame_.toward) + bias;
  }

 private:
  static constexpr int size = 640;
  ScreenPoint project(const Vector& p) const {
    const Vector d = p - center_;
    return {0.5 * size + scale_ * dot(d, frame_.right), 0.5 * size - scale_ * dot(d, frame_.up)};
  }

  Frame frame_;
  Vector center_;
  double scale_;
  std::vector<float> heights_;
};

/// Two even numbers in [-1, 1] from a sample and a light.
ScreenPoint grain(std::size_t sample, std::size_t light) {
  std::uint64_t h = (sample + 0x9e3779b97f4a7c15u * (light + 1)) * 0xbf58476d1ce4e5b9u;
  h = (h ^ (h >> 29)) * 0x94d049bb133111ebu;
  return {static_cast<double>(h >> 48) / 32768 - 1, static_cast<double>((h >> 32) & 65535u) / 32768 - 1};
}

/// The sample whose light serves for this one: on the floor one of four is enough.
std::size_t lit_by(const Samples& samples, std::size_t at) {
  if (samples.id[at] != floor_id) return at;
  const auto width = static_cast<std::size_t>(samples.width);
  const std::size_t x = at % width & ~std::size_t{1}, y = at / width & ~std::size_t{1};
  return samples.id[y * width + x] == floor_id ? y * width + x : at;
}

/// Adds the light number `index` to the samples listed.
void add_light(const Model& model, const Light& light, std::size_t index, const Samples& samples,
               const std::vector<std::size_t>& lit, std::vector<float>& key, std::vector<float>& sky) {
  const DepthMap map(model, light);
  const double bias = 0.005 * model.radius;
  for (const std::size_t at : lit) {
    const Vector normal = widen(samples.normal[at]);
    const double cosine = dot(normal, light.direction);
    if (cosine <= 0) continue;
    const ScreenPoint g = grain(at, index);
    const double cells = samples.id[at] == floor_id ? (light.key > 0 ? 6 : 20) : 1.2;
    if (map.in_shadow(widen(samples.position[at]) + bias * normal, bias, {cells * g.x, cells * g.y})) continue;
    key[at] += static_cast<float>(light.key * cosine);
    sky[at] += static_cast<float>(light.sky * cosine);
  }
}

void add_lights(const Model& model, const Camera& camera, Samples& samples) {
  // A fixed number of sums, so that the picture does not depend on the machine's number of processors.
  constexpr std::size_t groups = 4;
  const std::vector<Light> lights = make_lights(camera);
  std::array<std::vector<float>, groups> key, sky;
  std::vector<std::size_t> lit;
  for (std::size_t at = 0; at < samples.id.size(); ++at) {
    if (samples.id[at] != nothing && lit_by(samples, at) == at) lit.push_back(at);
  }
  std::vector<std::thread> threads;
  for (std::size_t g = 0; g < groups; ++g) {
    threads.emplace_back([&, g] {
      key[g].assign(samples.id.size(), 0);
      sky[g].assign(samples.id.size(), 0);
      for (std::size_t i = g; i < lights.size(); i += groups) {
        add_light(model, lights[i], i, samples, lit, key[g], sky[g]);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  samples.key.assign(samples.id.size(), 0);
  samples.sky.assign(samples.id.size(), 0);
  for (std::size_t g = 0; g < groups; ++g) {
    for (std::size_t at = 0; at < samples.id.size(); ++at) {
      const std::size_t from = lit_by(samples, at);
      samples.key[at] += key[g][from];
      samples.sky[at] += sky[g][from];
    }
  }
}

/// Marks samples beside a crease, a step in depth or the outline: 0 none .. 1 a full line.
std::vector<float> find_lines(const Model& model, const Samples& samples, double crease) {
  std::vector<float> lines(samples.id.size(), 0);
  const double limit = std::cos(0.8 * crease * radians), step = 0.006 * model.radius;
  const auto compare = [&](std::size_t a, std::size_t b) {
    const bool a_model = samples.id[a] < floor_id, b_model = samples.id[b] < floor_id;
    float strength = 0;
    if (a_model != b_model) {
      strength = 1.0f;
    } else if (a_model) {
      const Vector na = widen(samples.normal[a]), nb = widen(samples.normal[b]);
      const Vector gap = widen(samples.position[b]) - widen(samples.position[a]);
      if (dot(na, nb) < limit) strength = 0.6f;
      if (std::abs(dot(na, gap)) > step && std::abs(dot(nb, gap)) > step) strength = 1.0f;
    }
    if (a_model) lines[a] = std::max(lines[a], strength);
    if (b_model) lines[b] = std::max(lines[b], strength);
  };
  const auto width = static_cast<std::size_t>(samples.width), height = static_cast<std::size_t>(samples.height);
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      if (x + 1 < width) compare(y * width + x, y * width + x + 1);
      if (y + 1 < height) compare(y * width + x, (y + 1) * width + x);
    }
  }
  return lines;
}

Vector mix(const Vector& a, const Vector& b, double t) { return (1 - t) * a + t * b; }
Vector times(const Vector& a, const Vector& b) { return {a[0] * b[0], a[1] * b[1], a[2] * b[2]}; }

/// Linear light of the background: bright behind the model, slightly cooler towards the corners.
Vector background(double x, double y) {
  const double r = std::min(1.0, std::hypot((x - 0.5) * 1.1, (y - 0.45) * 1.1) / 0.75);
  return mix({0.97, 0.975, 0.98}, {0.70, 0.745, 0.80}, r * r);
}

Vector shade_model(const Vector& color, const Camera& camera, const Vector& position, const Vector& normal, double key,
                   double sky) {
  const Frame& frame = camera.frame();
  const Vector eye = normalized(camera.eye() - position);
  const Vector fill = normalized(frame.toward + 1.2 * frame.right - 0.1 * frame.up);
  const double fill_light = std::max(0.0, dot(normal, fill)) * std::min(1.0, sky * 1.3);
  const Vector half = normalized(eye + normalized(frame.toward - 0.75 * frame.right + 0.55 * frame.up));
  const double gloss = std::pow(std::max(0.0, dot(normal, half)), 40.0) * std::min(1.0, 1.5 * key);
  const double rim = std::pow(1 - std::clamp(dot(normal, eye), 0.0, 1.0), 4.0) * std::min(1.0, sky);
  const Vector light = 1.25 * key * Vector{1.0, 0.96, 0.90} + 0.62 * sky * Vector{0.93, 0.97, 1.05} +
                       0.16 * fill_light * Vector{0.85, 0.95, 1.1};
  return times(color, light) + (0.16 * gloss + 0.10 * rim) * Vector{1, 1, 1};
}

Vector shade_sample(const Request& request, const Camera& camera, const Samples& samples, std::size_t at, float line) {
  const auto width = static_cast<std::size_t>(samples.width);
  const Vector back =
      background(static_cast<double>(at % width) / samples.width, static_cast<double>(at / width) / samples.height);
  if (samples.id[at] == nothing) return back;
  if (samples.id[at] == floor_id) {
    // Without the model the floor receives this much; the ratio darkens the background.
    const Vector key = normalized(camera.frame().toward - 0.75 * camera.frame().right + 0.55 * camera.frame().up);
    const double open = 0.45 * std::max(key[2], 0.3) + 0.85;
    const double ratio = std::clamp((0.45 * samples.key[at] + samples.sky[at]) / open, 0.0, 1.0);
    return (0.22 + 0.78 * ratio) * back;
  }
  const Vector normal = widen(samples.normal[at]);
  const Vector lit =
      shade_model(request.color, camera, widen(samples.position[at]), normal, samples.key[at], samples.sky[at]);
  return (1 - 0.5 * line) * lit;
}

std::uint8_t display_byte(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  const double s = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * s));
}

std::vector<std::uint8_t> resolve(const Request& request, const Model& model, const Camera& camera,
                                  const Samples& samples) {
  const std::vector<float> lines = find_lines(model, samples, request.crease);
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < request.height; ++y) {
    for (int x = 0; x < request.width; ++x) {
      Vector sum{};
      for (int s = 0; s < supersampling * supersampling; ++s) {
        const int sx = x * supersampling + s % supersampling, sy = y * supersampling + s / supersampling;
        const auto at =
            static_cast<std::size_t>(sy) * static_cast<std::size_t>(samples.width) + static_cast<std::size_t>(sx);
        const Vector c = shade_sample(request, camera, samples, at, lines[at]);
        for (std::size_t a = 0; a < 3; ++a) sum[a] += std::min(c[a], 1.0);
      }
      for (const double c : sum) pixels.push_back(display_byte(c / (supersampling * supersampling)));
    }
  }
  return pixels;
}

std::vector<std::uint8_t> render(const Mesh& mesh, const Request& request) {
  const Model model = make_model(mesh, request.crease);
  Samples samples;
  samples.width = supersampling * request.width;
  samples.height = supersampling * request.height;
  const Camera camera(model, request, samples.width, samples.height);
  find_visible(model, camera, samples);
  add_floor(model, camera, samples);
  add_lights(model, camera, samples);
  return resolve(request, model, camera, samples);
}

bool write_png(const Request& request, const std::vector<std::uint8_t>& pixels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(request.width);
  image.height = static_cast<png_uint_32>(request.height);
  image.format = PNG_FORMAT_RGB;
  return png_image_write_to_file(&image, request.output.c_str(), 0, pixels.data(), 0, nullptr) != 0;
}

template <class Number>
bool parse(std::string_view text, Number& value, Number low, Number high) {
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc{} && result.ptr == text.data() + text.size() && value >= low && value <= high;
}

bool parse_color(std::string_view text, Vector& color) {
  std::uint32_t value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (text.size() != 6 || result.ec != std::errc{} || result.ptr != text.data() + 6) return false;
  for (std::size_t a = 0; a < 3; ++a) color[a] = std::pow(((value >> (16 - 8 * a)) & 255u) / 255.0, 2.2);
  return true;
}

bool parse_option(const std::vector<std::string_view>& words, std::size_t& i, Request& request) {
  const std::string_view name = words[i];
  const auto value = [&]() { return i + 1 < words.size() ? words[++i] : std::string_view{}; };
  if (name == "-o") return !(request.output = value()).empty();
  if (name == "--width") return parse(value(), request.width, 16, 8192);
  if (name == "--height") return parse(value(), request.height, 16, 8192);
  if (name == "--crease") return parse(value(), request.crease, 0.0, 180.0);
  if (name == "--color") return parse_color(value(), request.color);
  if (name == "--view") {
    return parse(value(), request.azimuth, -360.0, 360.0) && parse(value(), request.elevation, -90.0, 90.0);
  }
  if (name.empty() || name[0] == '-' || !request.input.empty()) return false;
  request.input = name;
  return true;
}

constexpr const char* usage =
    "quoin-render FILE.off|FILE.stl -o OUT.png [options]\n"
    "  --width N --height N          pixels, 1200 x 900\n"
    "  --view AZIMUTH ELEVATION      degrees, 35 25; azimuth 0 looks along +y\n"
    "  --crease ANGLE                degrees below which edges look smooth, 30\n"
    "  --color RRGGBB                of the model\n";

int run(const std::vector<std::string_view>& words) {
  if (words.size() == 1 && words[0] == "--help") {
    std::cout << usage;
    return 0;
  }
  Request request;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (parse_option(words, i, request)) continue;
    std::cerr << "quoin-render: wrong argument near '" << words[std::min(i, words.size() - 1)] << "'\n";
    return 2;
  }
  if (request.input.empty() || request.output.empty()) {
    std::cerr << usage;
    return 2;
  }
  const Result<Mesh> mesh = read_mesh_file(request.input);
  if (!mesh || mesh.value().triangles.empty()) {
    std::cerr << "quoin-render: " << request.input << ": "
              << (mesh ? std::string("The mesh is empty.") : mesh.error().message) << '\n';
    return 1;
  }
  if (write_png(request, render(mesh.value(), request))) return 0;
  std::cerr << "quoin-render: " << request.output << ": The file cannot be written.\n";
  return 1;
}

}  // namespace
}  // namespace quoin::examples

int main(int argc, char** argv) { return quoin::examples::run(std::vector<std::string_view>(argv + 1, argv + argc)); }
