/// \file
/// From an outline to the subdivision of its sheet.
#pragma once

#include "booleans/arrangement/outline.h"
#include "booleans/arrangement/sheets.h"
#include "grid/lists/partition.h"

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
    std::span<const Sheet::Element> list;    // in the sheet's lists, by (a, b)
    std::vector<std::uint32_t> first_piece;  // element e is pieces[first_piece[e]] .. pieces[first_piece[e + 1] - 1]

    std::uint32_t half_edges() const { return static_cast<std::uint32_t>(2 * list.size()); }
    VertexId origin(std::uint32_t h) const { return h & 1 ? list[h / 2].b : list[h / 2].a; }
  };
  /// The sheet's vertices, numbered as they come.
  struct Vertices {
    std::vector<VertexId> list;
    std::vector<std::uint32_t> origin;  // by half-edge: the number of its origin
    std::vector<std::uint32_t> slots;   // memory of the step: open addressing
  };
  /// Half-edges around each vertex.
  struct Rotation {
    std::span<std::uint32_t> clockwise;  // by half-edge, in the sheet's lists
    std::vector<std::uint32_t> first;    // by vertex: the first one counter-clockwise from "straight down", or none
    std::vector<std::uint32_t> next, around;  // memory of the step

    /// The last one, none of a vertex alone.
    std::uint32_t last(std::uint32_t vertex) const { return first[vertex] == none ? none : clockwise[first[vertex]]; }
    bool has_backward(std::uint32_t vertex) const {
      const std::uint32_t h = last(vertex);
      return h != none && (h & 1);
    }
    /// Chains run forward from half-edge to half-edge, through vertices in which one element ends and one begins.
    bool is_within_chain(std::uint32_t vertex) const {
      const std::uint32_t h = first[vertex];
      return h != none && !(h & 1) && (clockwise[h] & 1) && clockwise[clockwise[h]] == h;
    }
    /// The next one of the chain after one that runs forward, none at its end.
    std::uint32_t onward(std::uint32_t h) const {
      const std::uint32_t g = clockwise[h ^ 1];
      return !(g & 1) && clockwise[g] == (h ^ 1) ? g : none;
    }
    std::uint32_t end_of_chain(std::uint32_t h) const {
      for (std::uint32_t g; (g = onward(h)) != none;) h = g;
      return h;
    }
    /// The half-edges of a vertex, the last one first.
    template <class Visit>
    void visit_around(std::uint32_t vertex, Visit visit) const {
      const std::uint32_t start = first[vertex];
      if (start == none) return;
      for (std::uint32_t h = clockwise[start];; h = clockwise[h]) {
        visit(h);
        if (h == start) return;
      }
    }
    /// The half-edges that have one region on their left.
    template <class Visit>
    void visit_loop(std::uint32_t start, Visit visit) const {
      std::uint32_t h = start;
      do {
        visit(h);
        h = clockwise[h ^ 1];
      } while (h != start);
    }
  };
  /// Connected pieces of the drawing, from left to right.
  struct Components {
    struct Component {
      std::uint32_t leftmost;  // its first vertex in the order of the frame
      std::uint32_t outward;   // a half-edge whose loop looks outward, none of a vertex alone
    };
    std::vector<Component> list;
    grid::Partition together{0};  // memory of the step
    std::vector<char> listed;     // memory of the step
  };
  /// Facet 0 is the unbounded one.
  struct Facets {
    std::vector<std::uint32_t> of;            // by half-edge: the one on its left
    std::vector<std::uint32_t> of_component;  // the one around each component
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

  std::vector<Piece> pieces;  // by (a, b, segment)
  Elements elements;
  Vertices vertices;
  Rotation rotation;
  Components components;
  std::vector<std::uint32_t> below;  // by component: the element below its leftmost vertex, or none
  Facets facets;
  Covers covers;
  std::vector<FacetId> names;  // by facet, none where no face covers
};

/// Adds the subdivision that an outline draws to the lists; sorts the outline's splits. Precondition: all points have
/// names.
void draw(const Names& names, Outline& outline, Drawing& drawing, SheetLists& lists);

}  // namespace quoin::booleans
