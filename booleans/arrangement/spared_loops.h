/// \file
/// Loops of touched polygons that need not be drawn, since all that is foreign lies far from them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "booleans/pairs/operands.h"

namespace quoin::booleans {

/// What is left out of a drawing: loops by their number among those of all polygons of one operand.
///
/// A plate with a thousand holes that gets another one is drawn with the holes near the new one only. Let R be a box
/// around all other operands near the face and around every loop whose box meets it. When the outer loop does not meet
/// R, then
///   - contacts lie in R, and so do the other faces of the sheet that lie within the outer loop;
///   - the face without R is connected: a way through R can go around it;
///   - so one facet, that of the outer loop, holds all loops outside R.
/// A loop is spared when it lies outside R, and all other faces at its vertices lie in far chunks: these are one patch
/// whose labels are known (patches.h), no way to them leads over the loop, and the result has the loop where it has the
/// facet.
class SparedLoops {
 public:
  /// `touched`: the faces of the operand that are drawn, its own numbers, ascending. Linear in the corners of near
  /// faces.
  SparedLoops(const Operands& operands, OperandId operand, std::span<const std::uint32_t> touched);

  bool any() const { return !is_spared_.empty(); }
  /// Of a loop of the operand's polygons.
  bool operator[](std::uint32_t loop) const { return any() && is_spared_[loop]; }
  /// A polygon with loops that may be spared.
  struct Face {
    std::uint32_t polygon, outer_loop;
    Box box;
  };
  /// A polygon that may have spared loops; nullptr for others.
  const Face* find(std::uint32_t polygon) const;

 private:
  void choose(const Operands& operands, OperandId operand, std::uint32_t polygon);
  void keep_shared(const Operands& operands, OperandId operand);

  std::vector<std::uint8_t> is_spared_;  // empty: none
  std::vector<Face> faces_;              // ascending
};

}  // namespace quoin::booleans
