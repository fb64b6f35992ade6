/// \file
/// Bytes as a small model: few primitives of few planes whose numbers coincide more often than not, motions, Booleans.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "quoin/quoin.h"

namespace quoin::fuzz {

/// A motion as stated, for models and for solids.
struct Step {
  enum class Kind { rotation, translation, turn, transform, mirror, scaling };
  Kind kind = Kind::translation;
  std::array<std::string, 9> numbers = {};  // an axis and an angle; a vector; a quaternion; rows of a matrix; ...

  Text3 vector(std::size_t i = 0) const { return {numbers[i], numbers[i + 1], numbers[i + 2]}; }
  std::array<std::string, 4> four() const { return {numbers[0], numbers[1], numbers[2], numbers[3]}; }
  std::array<Text3, 3> rows() const { return {vector(0), vector(3), vector(6)}; }

  Model operator()(const Model& model) const {
    switch (kind) {
      case Kind::rotation:
        return model.rotated(vector(), numbers[3]);
      case Kind::translation:
        return model.translated(vector());
      case Kind::turn:
        return model.turned(four());
      case Kind::transform:
        return model.transformed(rows());
      case Kind::mirror:
        return model.mirrored(vector());
      default:
        return model.scaled(vector());
    }
  }
  /// Formulas are no numbers: "bad-number".
  Result<Motion> motion() const {
    switch (kind) {
      case Kind::rotation:
        return Motion::rotation(vector(), numbers[3]);
      case Kind::translation:
        return Motion::translation(vector());
      case Kind::turn:
        return Motion::quaternion(four());
      case Kind::transform:
        return Motion::matrix(rows());
      case Kind::mirror:
        return Motion::mirror(vector());
      default:
        return Motion::scaling(vector());
    }
  }
  Step inverse() const {
    Step s = *this;
    const auto each = [&](std::size_t from, std::size_t to, const char* before) {
      for (std::size_t i = from; i < to; ++i) s.numbers[i] = before + ("(" + numbers[i] + ")");
    };
    switch (kind) {
      case Kind::rotation:
        each(3, 4, "-");
        break;
      case Kind::translation:
        each(0, 3, "-");
        break;
      case Kind::turn:
        each(1, 4, "-");
        break;
      case Kind::transform:
        for (std::size_t i = 0; i < 9; ++i) s.numbers[i] = numbers[i % 3 * 3 + i / 3];
        break;
      case Kind::mirror:
        break;
      case Kind::scaling:
        each(0, 3, "1/");
        break;
    }
    return s;
  }
};

struct ModelScript {
  Model model;
  ModelOptions options;
  Step step;       // none of its numbers is a formula, and it has an inverse
  int exact_kind;  // of the exact motion: multiples of 90 degrees, grid steps, mirror images
  std::array<std::string, 3> grid_steps;
  std::uint8_t laws;  // which of them are checked
};

/// Reads any bytes; those that are missing count as 0. In lists in braces they are read in order, which compilers need
/// not do for arguments.
class ModelScriptReader {
 public:
  explicit ModelScriptReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  ModelScript read() {
    const std::uint8_t head = next();
    ModelScript s{};
    s.laws = next();
    // The default, best, twice as often as any other.
    s.options.rounding = static_cast<Rounding>(std::max(0, head % 7 - 1));
    if (head / 7 % 3 == 1) s.options.grid = Grid::with_step(pick(grid_words)).value();
    if (head / 21 % 4 == 1) s.options.parameters = {{"a", pick(sizes)}};
    s.step = step(false);
    s.exact_kind = next();
    for (std::string& n : s.grid_steps) n = std::to_string(next() % 9 - 4);
    s.model = node(0).model.with_parameters({{"a", "3/2"}, {"b", "a / 2"}});
    if (head / 84 == 2) s.model = s.model.with_step(pick(grid_words));
    return s;
  }

 private:
  /// A subtree, and how many primitives it has when nothing is shared.
  struct Part {
    Model model;
    int weight;
  };
  static constexpr int most_weight = 5, most_depth = 4;

  using Words = std::span<const char* const>;
  static constexpr std::array sizes{"1", "2", "3", "1/2", "1", "2", "a", "b", "1/3", "0.7", "4", "a + 1/2"};
  static constexpr std::array places{"0", "1", "-1", "2", "-2", "3", "1/2", "-1/3", "0", "1", "a", "-b", "2/7", "-3"};
  static constexpr std::array degrees{"90",  "180", "-90", "45",   "30", "1",    "60",    "120",
                                      "-45", "270", "1/3", "7/11", "37", "22.5", "89.99", "-180"};
  static constexpr std::array grid_words{"1", "1/2", "1/6", "1/1000", "1/65536", "3", "1/1048576", "0.1", "1e-9"};
  /// What makes an error, or numbers at the end of what can be.
  static constexpr std::array odd{"0",     "-1",     "1e9",         "1e-9",           "c",           "1 +",
                                  "1/0",   "1e30",   "1000000",     "123456789/7",    "1e-30",       "536870911",
                                  "1e399", "1e-399", "2 * (a - b)", "0.333333333333", "99999/100000"};

  std::uint8_t next() { return at_ < bytes_.size() ? bytes_[at_++] : std::uint8_t{0}; }
  std::string pick(Words words) { return words[next() % words.size()]; }
  /// From the words, seldom an odd one or two of them in a formula.
  std::string number(Words words) {
    const std::uint8_t b = next();
    if (b == 255) return pick(odd);
    std::string s = words[b % words.size()];
    return b >= 248 ? s + " + " + pick(words) : s;
  }
  std::string size() { return number(sizes); }
  std::string place() { return number(places); }
  Text3 size3() { return {size(), size(), size()}; }
  Text3 place3() { return {place(), place(), place()}; }
  std::string sides(int least, int most) {
    const std::uint8_t b = next();
    return b == 255 ? pick(odd) : std::to_string(least + b % (most - least + 1));
  }
  Fit fit() { return static_cast<Fit>(next() % 3); }
  /// Small integers, not all 0; the coordinate axes most often.
  template <std::size_t N>
  std::array<int, N> direction() {
    std::array<int, N> v{};
    const std::uint8_t b = next();
    v[b % N] = 1;
    if (b >= 128)
      for (int& x : v) x = next() % 7 - 3;
    if (v == std::array<int, N>{}) v[0] = 1;
    return v;
  }
  template <std::size_t N>
  void set(Step& s, const std::array<int, N>& v) {
    for (std::size_t i = 0; i < N; ++i) s.numbers[i] = std::to_string(v[i]);
  }

  Step step(bool formulas) {
    const auto word = [&](Words words) { return formulas ? number(words) : plain(words); };
    Step s;
    const std::uint8_t b = next();
    switch (b % 8) {
      case 0:
      case 1:
      case 2:
        s.kind = Step::Kind::rotation;
        set(s, direction<3>());
        s.numbers[3] = word(degrees);
        break;
      case 3:
        s.kind = Step::Kind::turn;
        set(s, direction<4>());
        break;
      case 4:
        s.kind = Step::Kind::mirror;
        set(s, direction<3>());
        break;
      case 5:
        s.kind = Step::Kind::scaling;
        for (std::size_t i = 0; i < 3; ++i) s.numbers[i] = word(sizes);
        break;
      case 6:
        if (b >= 128) return matrix();
        [[fallthrough]];
      default:
        for (std::size_t i = 0; i < 3; ++i) s.numbers[i] = word(places);
        break;
    }
    return s;
  }
  /// No formula.
  std::string plain(Words words) {
    std::string s = pick(words);
    return s.find_first_of("abc ") == std::string::npos ? s : "5/4";
  }
  /// Of a small quaternion.
  Step matrix() {
    const auto [w, x, y, z] = direction<4>();
    const std::array<int, 9> m{
        w * w + x * x - y * y - z * z, 2 * (x * y - w * z),           2 * (x * z + w * y),
        2 * (x * y + w * z),           w * w - x * x + y * y - z * z, 2 * (y * z - w * x),
        2 * (x * z - w * y),           2 * (y * z + w * x),           w * w - x * x - y * y + z * z};
    Step s{.kind = Step::Kind::transform};
    const std::string norm = "/" + std::to_string(w * w + x * x + y * y + z * z);
    for (std::size_t i = 0; i < 9; ++i) s.numbers[i] = std::to_string(m[i]) + norm;
    return s;
  }

  /// Those that are Booleans or have many faces weigh more.
  Part primitive() {
    const int kind = next() % 16;
    const bool is_slow = kind == 6 || kind == 9 || kind == 12;
    return {primitive(kind), is_slow ? 3 : kind == 5 || kind == 7 ? 2 : 1};
  }
  Model primitive(int kind) {
    switch (kind) {
      case 0: {
        const Text3 v = size3();
        return Model::wedge(v, size());
      }
      case 1: {
        const Text3 v{sides(3, 8), size(), size()};
        return Model::prism(v[0], v[1], v[2]);
      }
      case 2: {
        const Text3 v{size(), size(), sides(3, 8)};
        return Model::cylinder(v[0], v[1], v[2], fit());
      }
      case 3: {
        const std::array<std::string, 4> v{size(), place(), size(), sides(3, 6)};
        return Model::frustum(v[0], v[1], v[2], v[3], fit());
      }
      case 4: {
        const Text3 v{size(), size(), sides(3, 6)};
        return Model::cone(v[0], v[1], v[2], fit());
      }
      case 5: {
        const std::string radius = size();
        return Model::sphere(radius, sides(2, 3) == "2" ? "4" : "6");
      }
      case 6: {
        const std::string radius = size();
        return Model::tangent_sphere(radius, sides(4, 7));
      }
      case 7: {
        const Text3 v{size() + " + 1", size(), sides(3, 4)};
        return Model::torus(v[0], v[1], "3", v[2]);
      }
      case 8: {
        const auto n = direction<3>();
        return Model::half_space({std::to_string(n[0]), std::to_string(n[1]), std::to_string(n[2]), place()});
      }
      case 9: {
        std::vector<std::array<std::string, 4>> planes;
        for (int k = 0; k < 3; ++k)
          for (const char* sign : {"1", "-1"}) {
            std::array<std::string, 4> plane{"0", "0", "0", "-(" + size() + ")"};
            plane[static_cast<std::size_t>(k)] = sign;
            planes.push_back(plane);
          }
        for (int extra = next() % 2; extra > 0; --extra) {
          const auto n = direction<3>();
          planes.push_back({std::to_string(n[0]), std::to_string(n[1]), std::to_string(n[2]), place()});
        }
        return Model::convex(planes);
      }
      case 10: {
        std::vector<Text3> points;
        for (int n = 4 + next() % 4; n > 0; --n) points.push_back(place3());
        return Model::hull(points);
      }
      case 11:
        return extrusion();
      case 12:
        return solid();
      default:
        return Model::block(size3());
    }
  }
  /// A square with a triangle in it that may touch it or leave it, or any triangle or quadrangle; perhaps two.
  Model extrusion() {
    std::vector<std::vector<Model::Outline>> polygons;
    const std::uint8_t b = next();
    for (int n = 0; n <= b % 2; ++n) {
      auto& polygon = polygons.emplace_back();
      if (b >= 128) {
        polygon.push_back({{"-1", "-1"}, {"4", "-1"}, {"4", "4"}, {"-1", "4"}});
        if (n == 1)
          for (auto& point : polygon.back()) point[0] += "+ 6";
      }
      const std::size_t corners = 3 + (b >> 1 & 1);
      auto& outline = polygon.emplace_back();
      for (std::size_t i = 0; i < corners; ++i) outline.push_back({place(), place()});
    }
    return Model::extrusion(polygons, {place(), place(), size()});
  }
  /// A model evaluated on some grid; one that cannot be is a block.
  Model solid() {
    if (solids_ == 2) return Model::block(size3());
    ++solids_;
    const Model inner = node(most_depth - 1).model.with_parameters({{"a", "2"}, {"b", "1"}});
    ModelOptions options;
    if (next() % 2 == 0) options.grid = Grid::with_step(pick(grid_words)).value();
    options.run.threads = 1;
    const auto done = evaluate(inner, options);
    return done ? Model::solid(done.value()) : Model::block(size3());
  }

  Part node(int depth) {
    const std::uint8_t b = next();
    Part part = made(b, depth);
    for (int motions = b >> 6; motions > 1; --motions) part.model = step(true)(part.model);
    if (parts_.size() < 8) parts_.push_back(part);
    return part;
  }
  Part made(std::uint8_t b, int depth) {
    const bool leaf = depth >= most_depth || b % 8 < 3;
    if (b % 8 == 3 && !parts_.empty()) return parts_[next() % parts_.size()];
    if (leaf || b % 8 == 3) return primitive();
    std::vector<Model> terms;
    int weight = 0;
    for (int count = 1 + (b >> 3 & 1) + (b >> 4 & 1); count >= 0; --count) {
      const Part term = node(depth + 1);
      if (weight + term.weight > most_weight) break;
      terms.push_back(term.model);
      weight += term.weight;
    }
    switch (b % 8 + (b >> 5 & 1) * 8) {
      case 4:
        return {Model::intersect(terms), weight};
      case 5:
      case 13:
        if (terms.empty()) return {Model::unite({}), weight};
        return {Model::difference(terms[0], {terms.begin() + 1, terms.end()}), weight};
      case 6:
        return {Model::symmetric_difference(terms), weight};
      case 12:
        return {Model::complement(Model::unite(terms)), weight};
      case 14:
        return {Model::unite(terms).named("part").with_parameters({{"a", "1"}}), weight};
      default:
        return {Model::unite(terms), weight};
    }
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  int solids_ = 0;
  std::vector<Part> parts_;  // which may be shared
};

inline ModelScript model_script(std::span<const std::uint8_t> bytes) { return ModelScriptReader(bytes).read(); }

}  // namespace quoin::fuzz
