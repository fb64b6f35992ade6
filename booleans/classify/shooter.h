/// \file
/// Rays towards -y, and the first facet that each of them comes down on.
#pragma once

#include "booleans/classify/any_vertex.h"
#include "booleans/classify/sides.h"
#include "booleans/classify/targets.h"
#include "booleans/pairs/box_tree.h"

namespace quoin::booleans {

/// A ray that starts next to the edge from v to w: start.v is v, start.d the direction to w.
struct Ray {
  AnyVertex v, w;
  RayStart start;
};

/// Finds the nearest target in each ray's way.
///
/// Targets are found by their boxes. All targets with the corner v are infinitely near to the rays that start there,
/// though, so where many do, at a *hub*, these are found by the directions in which they are seen from it:
///   - A ray meets them infinitely near to v, at places with x > v_x, seen from v in the dz/dx of the ray's start, but
///     for infinitely little, and in no larger dy/dx.
///   - A target lies in the hull of its corners. So where all of them but v have x > v_x, it is seen within the box of
///     their slopes (dz/dx, dy/dx).
/// Where some corners have not, the target may be seen anywhere; where none has, it is not met.
class Shooter {
 public:
  /// `rays`: all that are to be shot.
  Shooter(const Arrangement& a, std::span<const Ray> rays);

  /// The side on which the ray comes down first; none when it reaches infinity.
  SideId first_hit(const Ray& ray);

 private:
  struct Hit {
    std::uint32_t target = none;
    exact::Plane plane{};  // oriented towards +y
    bool turned = false;   // that is against the target's front
  };
  /// The targets that have the same hubs as corners.
  struct Bundle {
    std::vector<std::uint32_t> hubs;  // ascending
    BoxTree places;
  };
  struct Hash {
    std::size_t operator()(AnyVertex v) const { return v.hash(); }
  };

  void find_hubs(std::span<const Ray> rays);
  std::vector<std::uint32_t> hubs_of(std::uint32_t t) const;
  std::optional<Box> seen_from(AnyVertex hub, std::uint32_t t) const;
  void plant();
  void prepare(std::span<const Ray> rays);

  std::uint32_t hub_at(AnyVertex v) const;
  /// visit(target) for those whose boxes meet the ray's, which the visitor may shrink, but for what has the hub as a
  /// corner.
  template <class Visit>
  void for_places(const Box& ray, std::uint32_t hub, Visit&& visit) const;
  /// Is the target met, and nearer than the hit? Then it is the hit.
  bool hits(std::uint32_t t, const RayStart& s, Hit& hit);

  const Arrangement& a_;
  Targets targets_;
  std::vector<AnyVertex> hubs_;
  std::unordered_map<AnyVertex, std::uint32_t, Hash> number_of_;  // of the hubs
  std::vector<BoxTree> seen_from_;                                // by hub: its targets, boxes of slopes
  std::vector<Bundle> bundles_;                                   // all targets; none where there are few rays
  std::optional<BoxTree> bundle_tree_;
};

}  // namespace quoin::booleans
