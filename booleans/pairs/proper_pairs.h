/// \file
/// Proof that two faces of one body meet in common corners and edges only.
#pragma once

#include <array>

#include "booleans/body/body.h"

namespace quoin::booleans {

/// Two proofs, of faces of few corners at least:
/// - one face lies on one closed side of the other's plane, and the other lists all that it has there;
/// - the planes meet in a line, and what the faces have on it ends for one where it begins for the other, or has no
///   more in common than a corner or an edge that both list.
/// The body must outlive it.
class ProperPairs {
 public:
  explicit ProperPairs(const Body& body);

  /// False where neither proof succeeds. Precondition: the faces differ.
  bool proved(std::uint32_t f, std::uint32_t g) const;

 private:
  bool is_small(std::uint32_t face) const;
  bool lists(std::uint32_t face, std::uint32_t v) const;
  bool lists(std::uint32_t face, std::uint32_t u, std::uint32_t v) const;
  bool meets_on_one_side(std::uint32_t f, std::uint32_t g) const;
  bool meet_on_line(std::uint32_t f, std::uint32_t g) const;

  const Body& body_;
  // Of faces that are not small, sorted.
  Array<std::array<std::uint32_t, 2>> corners_;  // (vertex, face)
  Array<std::array<std::uint32_t, 3>> edges_;    // (lower vertex, higher vertex, face)
};

}  // namespace quoin::booleans
