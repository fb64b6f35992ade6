/// \file
/// Outlines: the segments and points that are drawn on one sheet, and where they cross, touch and overlap.
#pragma once

#include "booleans/arrangement/contacts.h"
#include "booleans/arrangement/frame.h"

namespace quoin::booleans {

/// What is drawn on one sheet.
struct Outline {
  struct Segment {
    VertexId a, b;   // a before b in the frame
    PlaneId line;    // another plane through both
    TouchedId face;  // that has it as a boundary, none for a contact
    int change;      // of the face's cover: left minus right
  };
  /// A face begins to cover, or ends, where a segment is crossed from right to left.
  struct Change {
    TouchedId face;
    int by;
  };
  struct Split {
    std::uint32_t segment;
    NewVertex vertex;
  };
  PlaneId plane;
  Frame frame;                    // of that plane
  std::vector<Segment> segments;  // once splits are found: distinct {a, b}
  // Then those of segment i are changes[change_start[i]] .. changes[change_start[i + 1] - 1].
  std::vector<std::uint32_t> change_start;
  std::vector<Change> changes;
  std::vector<VertexId> points;
  std::vector<Split> splits;
  std::vector<exact::Point> new_points;  // where segments cross, NewVertex::own

  std::span<const Change> changes_of(std::uint32_t segment) const {
    return std::span(changes).subspan(change_start[segment], change_start[segment + 1] - change_start[segment]);
  }
  /// Enters the new points into the table.
  void name_points(VertexTable& vertices);
};

/// Makes an outline: what is drawn is added, then the splits are found.
class OutlineMaker {
 public:
  /// Begins an empty outline, in the memory of the one before.
  OutlineMaker(const Touched& touched, const Names& names, PlaneId plane, Outline& outline);

  void add_face(TouchedId face);
  void add_segment(const ContactSegment& s);
  void add_point(VertexId v) { outline_.points.push_back(v); }
  /// Instead of all that: one face of a clean operand, and segments in which faces of others, clean too, meet it, their
  /// ends' places known. Those of one operand meet in common ends only.
  void draw_lone_face(TouchedId face, std::span<const ContactSegment> all, std::span<const std::uint32_t> segments);
  /// Finds where segments cross, touch and overlap. Points where they cross stay in the outline until they get names.
  void find_splits();

 private:
  using Segment = Outline::Segment;

  bool before(VertexId a, VertexId b) const { return outline_.frame.compare(names_.vertices, a, b) < 0; }
  bool strictly_inside(VertexId v, const Segment& s) const { return before(s.a, v) && before(v, s.b); }

  void unite_equal_segments();
  template <class GroupOf, class Visit>
  void close_pairs(std::uint32_t first, GroupOf group_of, Visit visit) const;
  template <class Visit>
  void pairs_at(std::span<const VertexId> hubs, std::uint32_t first, Visit visit) const;
  void split_pair(std::uint32_t s, std::uint32_t t);
  void split_collinear(std::uint32_t s, std::uint32_t t);
  void split_by_point(std::uint32_t s, VertexId v);

  const Touched& touched_;
  const Names& names_;
  Outline& outline_;
};

}  // namespace quoin::booleans
