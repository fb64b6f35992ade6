/// \file
/// The boundary of a solid, ready to be asked.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "booleans/body/body.h"
#include "booleans/pairs/box_tree.h"

namespace quoin::booleans {

/// The faces of the canonical form as exact triangles, and a tree of their boxes. What is asked of it is a function of
/// the point set alone, however the solid is stored; by label, of that and of what its faces carry. Constant once it is
/// made: any number of threads may ask.
class Index {
 public:
  /// `by_label`: the faces are those of the labelled boundary (body/canonical.h). Precondition: a clean body (B1 - B4).
  explicit Index(const Body& body, bool by_label = false);

  /// Vertices and planes that triangles refer to.
  const Body& body() const { return body_; }
  const BoxTree& tree() const { return tree_; }
  /// Holds the boundary, exactly; inverted where there is none.
  const Box& box() const { return box_; }

  std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(face_.size()); }
  /// Body vertices, counter-clockwise from outside; every edge of the mesh has the same two of them in all its
  /// triangles.
  const std::array<std::uint32_t, 3>& corners(std::uint32_t triangle) const { return corners_[triangle]; }
  /// The outward plane, perhaps not reduced: for signs and quotients.
  exact::Plane plane(std::uint32_t triangle) const { return body_.sign_plane(face_[triangle]); }

  /// How answers name the face that a triangle is part of: by its number in the canonical form, or in the
  /// labelled boundary.
  std::uint32_t face_name(std::uint32_t triangle) const { return number_[face_[triangle]]; }
  std::uint32_t face_count() const { return static_cast<std::uint32_t>(number_.size()); }

 private:
  Body body_;
  std::vector<std::uint32_t> number_;  // by face of the body
  Array<std::array<std::uint32_t, 3>> corners_;
  Array<std::uint32_t> face_;  // of the body
  Box box_;
  BoxTree tree_;
};

}  // namespace quoin::booleans
