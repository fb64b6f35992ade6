/// \file
/// A vertex of an arrangement, whether it has a name or is known to its operand alone.
#pragma once

#include "booleans/arrangement/arrangement.h"

namespace quoin::booleans {

class AnyVertex {
 public:
  AnyVertex() = default;                             // of nothing
  AnyVertex(VertexId named) : bits_(named.value) {}  // NOLINT: implicit by design
  /// The operand's vertex v: by its name, if it has one.
  AnyVertex(const Names& names, OperandId operand, std::uint32_t v) {
    const VertexId name = names.operands[operand].of(v);
    bits_ = name != none ? std::uint64_t{name.value} : own_bit | std::uint64_t{operand.value} << 32 | v;
  }

  bool is_nothing() const { return bits_ == nothing; }
  bool is_named() const { return (bits_ & own_bit) == 0; }
  /// Precondition: is_named().
  VertexId named() const { return static_cast<std::uint32_t>(bits_); }
  /// Preconditions: not named.
  OperandId operand() const { return static_cast<std::uint32_t>((bits_ & ~own_bit) >> 32); }
  std::uint32_t own() const { return static_cast<std::uint32_t>(bits_); }

  exact::Point point(const Arrangement& a) const {
    return is_named() ? a.names.vertices.point(named()) : a.operands[operand()].point(own());
  }
  std::array<double, 3> approximation(const Arrangement& a) const {
    return is_named() ? a.names.vertices.approximation(named()) : a.operands[operand()].approximation(own());
  }
  bool is_grid(const Arrangement& a) const {
    return is_named() ? a.names.vertices.is_grid(named()) : a.operands[operand()].is_grid(own());
  }
  /// Order of the k-th coordinates.
  int compare_along(const Arrangement& a, int k, AnyVertex other) const {
    const auto i = static_cast<std::size_t>(k);
    return exact::compare_rounded(approximation(a)[i], other.approximation(a)[i], [&] {
      return is_grid(a) && other.is_grid(a) ? 0 : exact::compare_along(k, point(a), other.point(a));
    });
  }

  std::size_t hash() const { return std::hash<std::uint64_t>()(bits_); }
  friend bool operator==(AnyVertex, AnyVertex) = default;
  friend auto operator<=>(AnyVertex, AnyVertex) = default;

 private:
  static constexpr std::uint64_t nothing = ~std::uint64_t{0}, own_bit = std::uint64_t{1} << 63;
  std::uint64_t bits_ = nothing;
};

}  // namespace quoin::booleans
