/// \file
/// From an outline to the subdivision of its sheet.
#pragma once

#include "booleans/arrangement/outline.h"
#include "booleans/arrangement/sheets.h"
#include "grid/lists/buckets.h"

namespace quoin::booleans {

/// Draws one sheet after the other, each in the memory of those before. Each step makes one of the values below from
/// those above it; half-edge 2e runs from a to b of element e, half-edge 2e + 1 back.
class Subdivider {
 public:
  explicit Subdivider(const Names& names) : names_(names) {}

  /// Adds the subdivision to the lists; sorts the outline's splits. Precondition: all points have names.
  void draw(Outline& outline, SheetLists& lists);

 private:
  /// Segments cut at their splits; equal pieces of overlapping segments are one element.
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
  /// Connected pieces of the drawing.
  struct Components {
    std::vector<std::uint32_t> of;        // by rank
    std::vector<std::uint32_t> leftmost;  // the rank of each one's first vertex
  };
  /// Facet 0 is the unbounded one.
  struct Facets {
    std::vector<std::uint32_t> of_loop, of_component;  // the facet around each component
    std::uint32_t count = 0;
  };
  struct Covers {
    struct Cover {
      TouchedId face;
      int times;
    };
    std::vector<Cover> list;
    std::vector<std::array<std::uint32_t, 2>> of;  // by facet: range of the list
  };

  void make_elements(Outline& outline);
  void order_vertices(const Outline& outline);
  void sort_around_vertices();
  void trace_loops();
  void find_components();
  void nest_components(const Outline& outline);
  void cover_facets();
  void write(SheetLists& lists);

  bool before(const Outline& outline, VertexId a, VertexId b) const {
    return outline.frame.compare(names_.vertices, a, b) < 0;
  }
  /// +1 when the vertex lies above (left of) the element's line, 0 on it, -1 below. Left of n x n_line is where the
  /// line's plane is negative.
  int above(VertexId v, std::uint32_t e) const {
    return -elements_.direction[e] * names_.side(v, elements_.list[e].line);
  }
  /// +1 when the vertex lies on the left of the half-edge, 0 on its line, -1 on the right.
  int left_of(std::uint32_t h, VertexId v) const { return h & 1 ? -above(v, h / 2) : above(v, h / 2); }
  std::uint32_t facet_left_of(std::uint32_t h) const { return facets_.of_loop[loops_.of[h]]; }

  const Names& names_;
  Elements elements_;
  Order order_;
  Rotation rotation_;
  LoopIds loops_;
  Components components_;
  Facets facets_;
  Covers covers_;

  // Memory of single steps.
  struct Piece {
    VertexId a, b;
    PlaneId line;
    std::uint32_t segment;
  };
  struct Lower;
  std::vector<Piece> pieces_;
  ById<VertexId, std::uint32_t> rank_of_;  // none between sheets
  grid::Buckets<> sides_;                  // half-edges by the facet on their left
  std::vector<std::uint32_t> stack_, outward_;
  std::vector<FacetId> names_of_facets_;
};

}  // namespace quoin::booleans
