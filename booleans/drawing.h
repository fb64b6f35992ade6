/// \file
/// The steps that turn the segments of one sheet into its subdivision.
#pragma once

#include "booleans/sheet.h"

namespace quoin::booleans {

/// What is drawn on one sheet.
struct Outline {
  struct Segment {
    std::uint32_t a, b, line;
    std::uint32_t face;  // touched face that has it as a boundary, none for a contact
    int change;          // coverage left minus right
  };
  /// A face begins to cover, or ends, where an element is crossed from right to left.
  struct Change {
    std::uint32_t element, face;
    int by;
  };
  struct Split {
    std::uint32_t segment;
    std::uint32_t vertex;  // table id, or local_bit | index of a new point
  };
  std::uint32_t plane = none;
  std::vector<Segment> segments;  // once splits are found: distinct {a, b}, their changes in `changes`
  std::vector<Change> changes;    // element = segment index, in order
  std::vector<std::uint32_t> points;
  std::vector<Split> splits;
  std::vector<exact::Point> new_points;

  void clear(std::uint32_t new_plane);
  /// Enters the new points into the table.
  void name_points(VertexTable& vertices);
};

/// Draws one sheet after the other, each with the memory of those before.
class Drawing {
 public:
  Drawing(const TouchedFaces& touched, const VertexTable& vertices, const PlaneTable& planes)
      : touched_(touched), vertices_(vertices), planes_(planes) {}

  void begin(std::uint32_t plane) {
    outline_.clear(plane);
    frame_ = Frame(planes_[plane]);
  }
  void begin(Outline outline) {
    outline_ = std::move(outline);
    frame_ = Frame(planes_[outline_.plane]);
  }
  void add_face(std::uint32_t face);
  void add_segment(const SheetSegment& s);
  void add_point(std::uint32_t vertex) { outline_.points.push_back(vertex); }

  /// Finds where segments cross, touch and overlap. New points stay in the outline until they get names.
  void find_splits();
  Outline& outline() { return outline_; }
  /// Adds the subdivision to the lists. Precondition: all points have names.
  void draw(SheetLists& lists);

 private:
  using Segment = Outline::Segment;
  using Change = Outline::Change;
  using Split = Outline::Split;
  struct Piece {
    std::uint32_t a, b, line, segment;
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

  void make_pieces();
  void make_elements();
  void collect_vertices();
  void sort_around_vertices();
  void trace_loops();
  void find_components();
  void nest_components();
  void cover_facets();
  void write(SheetLists& lists);
  bool element_lower(std::uint32_t e, std::uint32_t f) const;
  int above(std::uint32_t vertex, std::uint32_t e) const;
  /// +1 when the vertex lies on the left of the half-edge, 0 on its line, -1 on the right.
  int left_of(std::uint32_t h, std::uint32_t vertex) const {
    return h & 1 ? -above(vertex, h / 2) : above(vertex, h / 2);
  }
  std::uint32_t origin(std::uint32_t h) const { return h & 1 ? elements_[h / 2].b : elements_[h / 2].a; }
  std::uint32_t half_edges() const { return static_cast<std::uint32_t>(2 * elements_.size()); }

  const TouchedFaces& touched_;
  const VertexTable& vertices_;
  const PlaneTable& planes_;

  Frame frame_;
  Outline outline_;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> change_start_;
  std::vector<Sheet::Element> elements_;
  std::vector<Change> changes_;                  // by element
  std::vector<int> direction_;                   // per element, Frame::direction of its line
  std::vector<std::uint32_t> vertex_ids_;        // the sheet's vertices in frame order
  std::vector<std::uint32_t> rank_of_;           // per table vertex, none between sheets
  std::vector<std::uint32_t> rank_;              // per half-edge: index of its origin in vertex_ids_
  std::vector<std::uint32_t> first_out_;         // per vertex: start in out_
  std::vector<std::uint32_t> out_;               // half-edges by origin, counter-clockwise from "straight down"
  std::vector<std::uint32_t> clockwise_, loop_;  // per half-edge
  std::uint32_t loop_count_ = 0;
  std::vector<std::uint32_t> component_;  // per vertex
  std::vector<std::uint32_t> leftmost_;   // per component: index of its first vertex
  std::vector<std::uint32_t> outward_;    // per component: its outward loop
  std::vector<std::uint32_t> facet_of_loop_;
  std::vector<std::uint32_t> facet_of_component_;  // the facet around each component
  std::uint32_t facet_total_ = 0;                  // facet 0 is the unbounded one
  struct Cover {
    std::uint32_t face;
    int times;
  };
  std::vector<Cover> covers_;                           // all facets' lists of covering faces
  std::vector<std::array<std::uint32_t, 2>> cover_of_;  // per facet: range of covers_
  std::vector<std::uint32_t> at_, start_, sides_, stack_, name_;
};

}  // namespace quoin::booleans
