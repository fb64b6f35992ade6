/// \file
/// Coincident planes of all placements as one class each, and their rounding: the unit of rounding is the plane.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rounding/planes/plane_rounding.h"
#include "rounding/reconstruction/placement.h"

namespace quoin::rounding {

/// A plane in its canonical orientation.
struct PlaneClass {
  WidePlane exact;
  std::size_t level = 0;  // of the method that rounds it: ClassRounder
  exact::Plane rounded{};
  /// Who lies on it; `face` is booleans::none for a half-space.
  struct User {
    std::uint32_t placement, face;
  };
  std::vector<User> users;
};

/// The carried planes of placements.
struct PlaneClasses {
  std::vector<PlaneClass> classes;
  /// By placement and face: the class, and whether the face's plane is its opposite. Empty for placements that do not
  /// go by planes.
  struct FacePlane {
    std::uint32_t of;
    bool turned;
  };
  std::vector<std::vector<FacePlane>> faces;

  PlaneClass& of(std::uint32_t placement, std::uint32_t face) { return classes[faces[placement][face].of]; }
  const PlaneClass& of(std::uint32_t placement, std::uint32_t face) const { return classes[faces[placement][face].of]; }
  /// A half-space has one face, 0.
  exact::Plane rounded(std::uint32_t placement, std::uint32_t face) const;
};
/// Of the placements that `by_planes` names.
PlaneClasses plane_classes(std::span<const Placement> placements, const std::vector<bool>& by_planes);

/// Rounds classes: at level 0 by a given method, at 1 by `best`, at 2 by `face_local`.
class ClassRounder {
 public:
  ClassRounder(std::span<const Placement> placements, Method method, CarriedPoints& points)
      : placements_(placements), methods_{method, Method::best, Method::face_local}, points_(points) {}

  /// By the first method from the class' level on that gives a plane; false where none does.
  bool round(PlaneClass& c);
  /// By a stronger method than before; false where there is none, or the plane fits. Where that gives nothing the plane
  /// stays as it is.
  bool strengthen(PlaneClass& c);

  bool is_exact(const PlaneClass& c) const { return rounder_.fits(c.exact); }
  bool is_face_local(const PlaneClass& c) const { return !is_exact(c) && methods_[c.level] == Method::face_local; }

 private:
  std::optional<exact::Plane> rounded(const PlaneClass& c, Method method);
  std::vector<Vector> points_on(const PlaneClass& c);

  std::span<const Placement> placements_;
  std::array<Method, 3> methods_;
  CarriedPoints& points_;
  PlaneRounder rounder_;
};

}  // namespace quoin::rounding
