/// \file
/// Bytes as a Boolean expression over small solids whose planes, edges and corners coincide more often than not.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "booleans/classify/expression.h"
#include "tests/booleans/shapes.h"

namespace quoin::fuzz {

struct Script {
  std::vector<booleans::Body> operands;  // raw, bounded, counter-clockwise from outside
  booleans::Expression expression;       // over them; leaves may repeat
};

/// Reads any bytes; those that are missing count as 0.
class ScriptReader {
 public:
  explicit ScriptReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  Script read() {
    scale_and_origin();
    const std::size_t count = 1 + next() % most_operands;
    for (std::size_t i = 0; i < count; ++i) add_operand();
    node(booleans::none, 0);
    return std::move(script_);
  }

 private:
  static constexpr std::size_t most_operands = 5, most_nodes = 14, most_depth = 4;
  static constexpr std::int64_t reach = 4;  // coordinates run from -reach to +reach before scaling

  using Vector = booleans::testing::Vector;

  std::uint8_t next() { return at_ < bytes_.size() ? bytes_[at_++] : std::uint8_t{0}; }

  /// Unit steps mostly; else thousands, steps to the world's ends, or small solids in the world's corners.
  void scale_and_origin() {
    const std::uint8_t b = next();
    const std::int64_t world = exact::world;
    switch (b % 8) {
      case 5:
        scale_ = 1000;
        break;
      case 6:
        scale_ = world / reach;
        break;
      case 7: {
        const auto corner = [&](int bit) { return b >> bit & 1 ? world - reach : reach - world; };
        origin_ = {corner(3), corner(4), corner(5)};
        break;
      }
      default:
        break;
    }
  }

  /// A new coordinate, or one that an earlier operand has along this axis.
  std::int64_t coordinate(std::size_t axis) {
    const std::uint8_t b = next();
    auto& used = used_[axis];
    if (b >= 128 && !used.empty()) return used[b % used.size()];
    const std::int64_t x = b % (2 * reach + 1) - reach;
    used.push_back(x);
    return x;
  }
  Vector point() { return {coordinate(0), coordinate(1), coordinate(2)}; }
  /// Components from -2 to 2.
  Vector direction() {
    const int b = next() % 125;
    return {b % 5 - 2, b / 5 % 5 - 2, b / 25 - 2};
  }

  std::optional<booleans::Body> shape() {
    using namespace booleans::testing;
    switch (next() % 8) {
      case 0: {
        const std::array<Vector, 4> p{point(), point(), point(), point()};
        return tetrahedron(p);
      }
      case 1: {
        const Vector a = point(), b = point(), c = point();
        return prism(a, b, c, direction());
      }
      case 2: {
        const Vector corner = point(), u = direction(), v = direction();
        return block(corner, u, v, direction());
      }
      case 3: {
        const Vector centre = point(), u = direction(), v = direction();
        return octahedron(centre, u, v, direction());
      }
      case 4: {
        const std::uint8_t b = next();
        const std::int64_t inner_x = 1 + (b & 1), inner_y = 1 + (b >> 1 & 1), top = 1 + (b >> 2 & 1);
        const booleans::Body l =
            l_shape({inner_x, inner_y}, {inner_x + 1 + (b >> 3 & 1), inner_y + 1 + (b >> 4 & 1)}, 0, top);
        const auto k = static_cast<std::size_t>(b >> 5) % 3;
        std::array<Vector, 3> columns{};
        for (std::size_t i = 0; i < 3; ++i) columns[i][(i + k) % 3] = 1;
        return mapped(l, point(), columns);
      }
      case 5:
        if (unscaled_.empty()) return std::nullopt;
        {
          const booleans::Body& earlier = unscaled_[next() % unscaled_.size()];
          return moved(earlier, direction());
        }
      default: {
        const Vector p = point(), q = point();
        Vector low, high;
        for (std::size_t k = 0; k < 3; ++k) {
          low[k] = std::min(p[k], q[k]);
          high[k] = std::max(p[k], q[k]);
          if (low[k] == high[k]) return std::nullopt;
        }
        return box(low, high);
      }
    }
  }

  /// What is flat or leaves the world becomes a box, so that every script means something.
  void add_operand() {
    auto unscaled = shape();
    auto body = unscaled ? booleans::testing::scaled(*unscaled, scale_, origin_) : std::nullopt;
    if (!body) {
      unscaled = booleans::testing::box({-1, -1, -1}, {1, 1, 1});
      body = booleans::testing::scaled(*unscaled, scale_, origin_);
    }
    unscaled_.push_back(*unscaled);
    script_.operands.push_back(*body);
  }

  void node(std::uint32_t parent, std::size_t depth) {
    auto& nodes = script_.expression.nodes;
    const std::uint8_t b = next();
    const bool leaf = depth == most_depth || nodes.size() >= most_nodes || (depth > 0 && b % 3 == 0);
    const bool negated = (b >> 6) == 3;
    if (leaf) {
      const auto operand = static_cast<std::uint32_t>(next() % script_.operands.size());
      script_.expression.add({booleans::Rule::operand, negated, operand, parent});
      return;
    }
    static constexpr std::array<booleans::Rule, 3> rules{booleans::Rule::any, booleans::Rule::all, booleans::Rule::odd};
    const auto self = script_.expression.add({rules[b / 3 % 3], negated, 0, parent});
    const int children = 2 + (b >> 4 & 1);
    for (int i = 0; i < children; ++i) node(self, depth + 1);
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  std::int64_t scale_ = 1;
  Vector origin_{};
  std::array<std::vector<std::int64_t>, 3> used_;
  std::vector<booleans::Body> unscaled_;
  Script script_;
};

inline Script script(std::span<const std::uint8_t> bytes) { return ScriptReader(bytes).read(); }

}  // namespace quoin::fuzz
