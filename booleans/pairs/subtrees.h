/// \file
/// What tells two subtrees of a box tree apart whose boxes overlap: a plane between them.
#pragma once

#include <deque>
#include <optional>

#include "booleans/pairs/block_slabs.h"

namespace quoin::booleans {

/// How the faces below two nodes meet, as far as one look tells.
enum class Relation {
  unknown,
  apart,    // no pair meets
  in_parts  // pairs meet in common corners and edges, or lie on one plane
};

/// Nodes of a tree over faces. Node x of level l stands for the items from x 8^l to (x + 1) 8^l - 1.
///
/// The boxes of long thin faces, and of all that has a corner in one place, overlap by the square of their number; what
/// is below two nodes does not meet for that. A plane shows it that has the one's faces on its closed positive side and
/// the other's on the negative one: where no corner lies on it no pair meets; where the corners on it are one point, or
/// two, pairs meet in common corners and edges only. (Not if a raw triangle has an edge on it: that may be a diagonal
/// of a flat region, which nobody draws.) The plane is tried exactly in 64 or 128 bits; where to try it says a box
/// around some of each node's faces, oriented as they lie, in doubles: any plane is right, a good one separates. Nodes
/// are looked at when they are first asked about. What does not separate costs little, however many faces there are;
/// what does costs time linear in them.
class Subtrees {
 public:
  /// The faces in the tree's order. Both must outlive it. `are_foreign`: pairs that lie on one plane are of no
  /// interest.
  Subtrees(const Array<SearchedFace>& faces, const BoxTree& tree, bool are_foreign)
      : faces_(faces), tree_(tree), are_foreign_(are_foreign) {}

  /// Precondition: different nodes of that level. `is_crowded`: a plane that tells them apart is looked for, too, which
  /// costs more than hubs and common planes do.
  Relation relation(std::size_t level, std::uint32_t x, std::uint32_t y, bool is_crowded);
  /// The points that faces have in common of which that was said, not distinct.
  const Array<exact::GridPoint>& hubs() const { return hubs_; }

  /// The items below a node.
  std::uint32_t begin(std::size_t level, std::uint32_t x) const { return x << (3 * level); }
  std::uint32_t end(std::size_t level, std::uint32_t x) const {
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(faces_.size(), (std::uint64_t{x} + 1) << (3 * level)));
  }

 private:
  using Vector = std::array<double, 3>;
  /// A box in some orientation, of unit vectors.
  struct OrientedBox {
    Vector centre{}, half{};
    std::array<Vector, 3> axes{};
  };
  struct Node {
    std::uint32_t begin, end;
    // Only where all faces have grid corners, few each:
    std::vector<exact::GridPoint> hubs;    // one point or two, ascending: each face has one of them as a corner
    std::optional<exact::GridPoint> many;  // where there is one hub: another corner of many faces
    std::optional<exact::Plane> plane;     // of all faces
    // Made when needed: around the faces, and around what each hub sees.
    std::optional<OrientedBox> place;
    std::array<std::optional<OrientedBox>, 2> directions;
  };
  /// A plane that may separate: positive where n . p > offset.
  struct Cut {
    Vector normal;
    double offset;
  };

  template <class ForPoints>
  static OrientedBox around(ForPoints for_points);
  static std::optional<Cut> cut_between(const OrientedBox& a, const OrientedBox& b);

  Node& node(std::size_t level, std::uint32_t x);
  void look_at(Node& node) const;
  void find_hubs(Node& node) const;
  void find_second_corner(Node& node) const;
  bool has_grid_corners(std::uint32_t i) const;
  bool has_corner(std::uint32_t i, const exact::GridPoint& p) const;
  template <class Visit>
  void for_corners(std::uint32_t i, Visit&& visit) const;
  template <class Visit>
  void for_points(std::uint32_t i, Visit&& visit) const;
  template <class Visit>
  void for_some_points(const Node& node, Visit&& visit) const;
  const OrientedBox& place(Node& node) const;
  static std::optional<exact::GridPoint> second(const Node& node, const exact::GridPoint& hub);
  const OrientedBox& directions(Node& node, const exact::GridPoint& hub) const;

  bool on_one_plane(const Node& a, const Node& b) const;
  bool apart(const Node& a, const Node& b, const Cut& cut) const;
  bool in_common_parts(Node& a, Node& b, const exact::GridPoint& hub);

  const Array<SearchedFace>& faces_;
  const BoxTree& tree_;
  const bool are_foreign_;
  Array<Array<std::uint32_t>> number_;  // by level and node: into nodes_, none before it is looked at
  std::deque<Node> nodes_;
  Array<exact::GridPoint> hubs_;
};

}  // namespace quoin::booleans
