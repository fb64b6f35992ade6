/// \file
/// From an outline to the subdivision of its sheet.
#pragma once

#include "booleans/arrangement/outline.h"
#include "booleans/arrangement/sheets.h"
#include "grid/lists/buckets.h"

namespace quoin::booleans {

/// What the steps of `draw` make, one value each, from those above it. They are kept for their memory alone: sheet
/// after sheet is drawn in that of the one before. Half-edge 2e runs from a to b of element e, half-edge 2e + 1 back.
struct Drawing {
  /// A part of a segment between two neighbours of its ends and splits.
  struct Piece {
    VertexId a, b;
    PlaneId line;
    std::uint32_t segment;
  };
  /// Equal pieces of overlapping segments are one element.
  struct Elements {
    std::vector<Sheet::Element> list;
    std::vector<int> direction;  // Frame::direction of its line
    // A face begins to cover, or ends, where element e is crossed from right to left: changes[change_start[e]] ..
    std::vector<std::uint32_t> change_start;
    std::vector<Outline::Change> changes;

    std::uint32_t half_edges() const { return static_cast<std::uint32_t>(2 * list.size()); }
    VertexId origin(std::uint32_t h) const { return h & 1 ? list[h / 2].b : list[h / 2].a; }
  };
  /// The sheet's vertices in the order of the frame; `rank` of each half-edge's origin.
  struct Order {
    std::vector<VertexId> vertices;
    std::vector<std::uint32_t> rank;
    ById<VertexId, std::uint32_t> rank_of;  // of the vertices, none for others
  };
  /// Half-edges around each vertex.
  struct Rotation {
    grid::Buckets<> out;                   // by rank of the origin, counter-clockwise from "straight down"
    std::vector<std::uint32_t> clockwise;  // by half-edge
  };
  struct LoopIds {
    std::vector<std::uint32_t> of;  // by half-edge
    std::uint32_t count = 0;
  };
  /// Connected pieces of the drawing, from left to right.
  struct Components {
    std::vector<std::uint32_t> of;        // by rank
    std::vector<std::uint32_t> leftmost;  // the rank of each one's first vertex
    std::vector<std::uint32_t> outward;   // the loop that looks outward, none of a vertex alone
    std::vector<std::uint32_t> stack;     // memory of the step
  };
  /// Facet 0 is the unbounded one.
  struct Facets {
    std::vector<std::uint32_t> of_loop, of_component;  // the facet around each component
    std::uint32_t count = 0;
  };
  /// The faces that cover each facet, in order.
  struct Covers {
    struct Cover {
      TouchedId face;
      int times;
    };
    std::vector<Cover> list;
    std::vector<std::array<std::uint32_t, 2>> of;  // by facet: range of the list
    std::vector<std::uint32_t> stack;              // memory of the step
  };

  std::vector<Piece> pieces;
  Elements elements;
  Order order;
  Rotation rotation;
  LoopIds loops;
  Components components;
  std::vector<std::uint32_t> below;  // by component: the element below its leftmost vertex, or none
  Facets facets;
  grid::Buckets<> sides;  // half-edges by the facet on their left
  Covers covers;
  std::vector<FacetId> names;  // by facet, none where no face covers
};

/// Adds the subdivision that an outline draws to the lists; sorts the outline's splits. Precondition: all points have
/// names.
void draw(const Names& names, Outline& outline, Drawing& drawing, SheetLists& lists);

}  // namespace quoin::booleans
