/// \file
/// The steps that turn the segments of one sheet into its subdivision.
#pragma once

#include "booleans/sheet.h"

namespace quoin::booleans {

/// One sheet in the making.
class Drawing {
 public:
  Drawing(std::uint32_t plane, const TouchedFaces& touched, const VertexTable& vertices, const PlaneTable& planes)
      : plane_(plane), touched_(touched), vertices_(vertices), planes_(planes), frame_(planes[plane]) {}

  void add_face(std::uint32_t face);
  void add_segment(const SheetSegment& s);
  void add_point(std::uint32_t vertex) { points_.push_back(vertex); }

  /// Finds where segments cross, touch and overlap. New points are kept here until `name_points` enters them.
  void find_splits();
  void name_points(VertexTable& vertices);
  Sheet draw();

 private:
  struct Segment {
    std::uint32_t a, b, line;
    std::uint32_t face;  // touched face that has it as a boundary, none for a contact
    int change;          // coverage left minus right
  };
  struct Split {
    std::uint32_t segment;
    std::uint32_t vertex;  // table id, or local_bit | index of a new point
  };
  struct Change {
    std::uint32_t element, face;
    int by;
  };

  struct Lower;

  bool before(std::uint32_t a, std::uint32_t b) const { return frame_.compare(vertices_, a, b) < 0; }
  int side(std::uint32_t v, std::uint32_t line) const {
    return vertices_.side(v, planes_[line], planes_.approximation(line));
  }
  bool strictly_inside(std::uint32_t v, const Segment& s) const { return before(s.a, v) && before(v, s.b); }

  void unite_equal_segments();
  template <class Visit>
  void close_pairs(Visit visit) const;
  void split_pair(std::uint32_t s, std::uint32_t t);
  void split_collinear(std::uint32_t s, std::uint32_t t);
  void split_by_point(std::uint32_t s, std::uint32_t v);

  void make_elements(Sheet& sheet);
  void collect_vertices(const Sheet& sheet);
  void sort_around_vertices(Sheet& sheet);
  void trace_loops(const Sheet& sheet);
  void find_components();
  void nest_components(const Sheet& sheet);
  void cover_facets(Sheet& sheet);
  bool element_lower(const Sheet& sheet, std::uint32_t e, std::uint32_t f) const;
  int above(const Sheet& sheet, std::uint32_t vertex, std::uint32_t e) const;

  const std::uint32_t plane_;
  const TouchedFaces& touched_;
  const VertexTable& vertices_;
  const PlaneTable& planes_;
  const Frame frame_;

  std::vector<Segment> segments_;  // after unite_equal_segments: distinct {a, b}, their changes in segment_changes_
  std::vector<Change> segment_changes_;  // element = segment index
  std::vector<std::uint32_t> points_;
  std::vector<Split> splits_;
  std::vector<exact::Point> new_points_;

  std::vector<Change> changes_;            // by element
  std::vector<int> direction_;             // per element, Frame::direction of its line
  std::vector<std::uint32_t> vertex_ids_;  // the sheet's vertices in frame order
  std::vector<std::uint32_t> rank_;        // per half-edge: index of its origin in vertex_ids_
  std::vector<std::uint32_t> first_out_;   // per vertex: start in out_
  std::vector<std::uint32_t> out_;         // half-edges by origin, counter-clockwise from "straight down"
  std::vector<std::uint32_t> loop_;        // per half-edge
  std::uint32_t loop_count_ = 0;
  std::vector<std::uint32_t> component_;  // per vertex
  std::vector<std::uint32_t> leftmost_;   // per component: index of its first vertex
  std::vector<std::uint32_t> facet_of_loop_;
  std::vector<std::uint32_t> facet_of_component_;  // the facet around each component
  std::uint32_t facet_total_ = 0;                  // facet 0 is the unbounded one
};

}  // namespace quoin::booleans
