/// \file
/// The arrangement of n operands: the facets their touched faces are cut into, the patches of untouched faces, and how
/// all of them hang together in space. docs/arrangement.md states the invariants.
#pragma once

#include "booleans/sheet.h"

namespace quoin::booleans {

/// Union-find over 0 .. n - 1; the root is the smallest member, so results do not depend on the order of unions.
class Partition {
 public:
  explicit Partition(std::size_t n) { reset(n); }
  /// Begins again.
  void reset(std::size_t n) {
    parent_.resize(n);
    for (std::uint32_t i = 0; i < n; ++i) parent_[i] = i;
  }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    if (i < j)
      parent_[j] = i;
    else
      parent_[i] = j;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// One facet or untouched face at one edge. The edge runs from its smaller to its larger vertex id.
struct Use {
  std::uint32_t low, high;  // table ids of the edge's ends
  std::uint32_t facet;      // facets of sheets first, then patches
  std::uint32_t plane;      // plane id
  std::uint32_t line;       // another plane through the edge, none when unknown (patches)
  std::uint32_t element;    // index over all sheets' elements, none for patches
  bool left;                // the facet lies left of low -> high, seen from the canonical normal
  bool turned;              // patches: the outward normal is opposite to the canonical one
};

struct Arrangement {
  Operands operands;
  VertexTable vertices;
  PlaneTable planes;
  TouchedFaces touched;
  Sheets sheets;
  std::vector<std::uint32_t> facet_base;    // first facet of each sheet, plus the total
  std::vector<std::uint32_t> element_base;  // first element of each sheet, plus the total
  /// Untouched faces: global face id -> facet_base.back() + patch, none for touched faces.
  std::vector<std::uint32_t> patch_of;
  std::vector<std::uint32_t> patch_operand;
  /// Per operand: the node of the untouched faces of far chunks, and of those that hang together with them; none
  /// without any. In front of it (of an operand that is full at infinity: behind it) all is as at infinity.
  std::vector<std::uint32_t> far_patch;
  std::vector<Use> uses;  // sorted by (low, high)

  explicit Arrangement(std::vector<const Body*> bodies) : operands(std::move(bodies)) {}
  std::uint32_t facet_count() const { return facet_base.back(); }
  std::uint32_t node_count() const { return facet_count() + static_cast<std::uint32_t>(patch_operand.size()); }
};

/// How untouched faces of one operand hang together.
enum class Glue {
  /// Over vertices. Right for clean bodies: an untouched vertex lies on no foreign surface, so all its untouched faces
  /// have the same foreign labels, and their own labels are 0 in front and 1 behind.
  vertices,
  /// Over edges of exactly two faces. For bodies that are not known to be clean.
  edges,
};

/// Fills patches and uses. Precondition: sheets are drawn.
void connect(Arrangement& a, Glue glue);

/// Per facet and patch: +1 kept with the outside in front (canonical normal; for patches their own outward normal),
/// -1 kept with the outside behind, 0 dropped.
struct Selection {
  std::vector<std::int8_t> kept;
  std::vector<std::uint8_t> kept_at;  // per element: how many kept facets meet at it, at most 255
  bool full_at_infinity = false;
  bool consistent = true;  // false: the surfaces of an operand do not bound a solid (trusted wrongly)
};

struct Expression;

/// Labels both sides of every facet and selects the boundary of the expression.
Selection select(const Arrangement& a, const Expression& expression);

}  // namespace quoin::booleans
