/// \file
/// Arrays of numbers that a caller keeps: passed on without a copy, in the types that meshes come in.
#pragma once

#include "quoin/export.h"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>

namespace quoin {

/// A view of doubles or floats; of anything that converts to a span of them. Floats are taken exactly.
class Coordinates {
 public:
  using Values = std::variant<std::span<const double>, std::span<const float>>;

  /// None.
  Coordinates() = default;
  template <std::convertible_to<std::span<const double>> Array>
  Coordinates(const Array& values) : values_(std::span<const double>(values)) {}  // NOLINT: implicit by design
  template <std::convertible_to<std::span<const float>> Array>
  Coordinates(const Array& values) : values_(std::span<const float>(values)) {}  // NOLINT: implicit by design

  const Values& values() const { return values_; }
  std::size_t size() const {
    return std::visit([](const auto& list) { return list.size(); }, values_);
  }

 private:
  Values values_;
};

/// A view of unsigned or signed 32-bit integers. A negative one is an index of nothing ("bad-index").
class Indices {
 public:
  using Values = std::variant<std::span<const std::uint32_t>, std::span<const std::int32_t>>;

  /// None.
  Indices() = default;
  template <std::convertible_to<std::span<const std::uint32_t>> Array>
  Indices(const Array& values) : values_(std::span<const std::uint32_t>(values)) {}  // NOLINT: implicit by design
  template <std::convertible_to<std::span<const std::int32_t>> Array>
  Indices(const Array& values) : values_(std::span<const std::int32_t>(values)) {}  // NOLINT: implicit by design

  const Values& values() const { return values_; }
  std::size_t size() const {
    return std::visit([](const auto& list) { return list.size(); }, values_);
  }

 private:
  Values values_;
};

}  // namespace quoin
