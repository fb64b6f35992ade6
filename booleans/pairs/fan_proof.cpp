#include "booleans/pairs/fan_proof.h"

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>
#include <utility>

#include "booleans/pairs/box_tree.h"
#include "booleans/pairs/triangle_pair.h"
#include "exact/predicates.h"
#include "grid/lists/loops.h"
#include "grid/lists/thresholds.h"

namespace quoin::booleans {
namespace {

using Edge = std::array<std::uint32_t, 2>;

/// Triangles around one vertex that meet each other as they should.
struct Fan {
  std::uint32_t hub;
  Array<std::uint32_t> triangles;
  exact::Plane plane;               // not reduced
  bool flat;                        // all lie on the plane; else the hub lies above the outer edges
  exact::int128 low = 0, high = 0;  // the least and the greatest value of the plane at the outer edges
};

exact::Plane plane_of(const Body& mesh, std::uint32_t t) { return mesh.sign_plane(t); }

/// The edge of a triangle that faces its corner.
Edge outer_edge(const Body& mesh, std::uint32_t t, std::uint32_t corner) {
  const auto& c = mesh.triangles[t];
  const std::size_t k = c[0] == corner ? 0 : c[1] == corner ? 1 : 2;
  return {c[(k + 1) % 3], c[(k + 2) % 3]};
}

/// Is a fan of this size worth a look at all triangles?
bool is_large(std::size_t fan, const Body& mesh) {
  return fan >= 2 && fan * fan > grid::thresholds().large_fan * mesh.triangles.size();
}

/// The triangles around every vertex that has many of them.
Array<Fan> crowded_stars(const Body& mesh) {
  Array<std::uint32_t> count(mesh.grid_points.size());
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t) ++count[v];

  Array<Fan> stars;
  Array<std::uint32_t>& star_at = count;
  for (std::uint32_t v = 0; v < count.size(); ++v) {
    const bool large = is_large(count[v], mesh);
    star_at[v] = large ? static_cast<std::uint32_t>(stars.size()) : none;
    if (large) stars.push_back({v, {}, {}, false});
  }
  if (stars.empty()) return stars;

  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t])
      if (star_at[v] != none) stars[star_at[v]].triangles.push_back(t);
  return stars;
}

bool is_on(const exact::Plane& plane, const Body& mesh, std::uint32_t t) {
  for (const std::uint32_t v : mesh.triangles[t])
    if (exact::side(plane, mesh.grid_points[v]) != 0) return false;
  return exact::dot_sign(plane, plane_of(mesh, t)) > 0;
}

/// The part of a star on the oriented plane that most of it lies on, if one does. By Boyer and Moore's vote.
Fan flat_part(const Body& mesh, const Fan& star) {
  Fan r{star.hub, {}, {}, true};
  std::size_t votes = 0;
  for (const std::uint32_t t : star.triangles) {
    if (votes == 0) r.plane = plane_of(mesh, t);
    votes += is_on(r.plane, mesh, t) ? 1 : std::size_t(-1);
  }
  for (const std::uint32_t t : star.triangles)
    if (is_on(r.plane, mesh, t)) r.triangles.push_back(t);
  return r;
}

/// A triangle of a flat fan as it is seen from its hub: differences are at most 2^30, products 2^60.
struct Sector {
  using Direction = std::array<std::int64_t, 2>;

  Direction from, to;  // counter-clockwise, less than half a turn
  Edge ends;

  bool is_upper() const { return from[1] > 0 || (from[1] == 0 && from[0] > 0); }
};
std::int64_t cross(const Sector::Direction& a, const Sector::Direction& b) { return a[0] * b[1] - a[1] * b[0]; }

Array<Sector> sectors(const Body& mesh, const Fan& fan) {
  const std::size_t k = exact::longest_component(fan.plane.n);
  std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
  if (fan.plane.n[k] < 0) std::swap(u, v);
  const auto direction = [&](std::uint32_t to) {
    const auto &p = mesh.grid_points[fan.hub].c, &q = mesh.grid_points[to].c;
    return Sector::Direction{std::int64_t{q[u]} - p[u], std::int64_t{q[v]} - p[v]};
  };

  Array<Sector> r;
  for (const std::uint32_t t : fan.triangles) {
    const Edge e = outer_edge(mesh, t, fan.hub);
    r.push_back({direction(e[0]), direction(e[1]), e});
  }
  std::sort(r.begin(), r.end(), [](const Sector& a, const Sector& b) {
    if (a.is_upper() != b.is_upper()) return a.is_upper();
    return cross(a.from, b.from) > 0;
  });
  return r;
}

/// Do the triangles of a flat fan meet in common edges only? Each ends before the next begins, or where it does.
bool is_embedded(const Body& mesh, const Fan& flat) {
  const Array<Sector> around = sectors(mesh, flat);
  for (std::size_t i = 0; around.size() > 1 && i < around.size(); ++i) {
    const Sector &s = around[i], &next = around[grid::next_in_loop(i, around.size())];
    const std::int64_t after_begin = cross(s.from, next.from), before_end = cross(next.from, s.to);
    if (after_begin >= 0 && before_end > 0) return false;
    const bool at_end = before_end == 0 && after_begin > 0;
    if (at_end && s.ends[1] != next.ends[0]) return false;
  }
  return true;
}

/// The star above a plane through three of its outer corners, if the hub lies higher than all outer edges.
std::optional<Fan> cone(const Body& mesh, const Fan& star) {
  const auto outer = [&](std::size_t i) -> const exact::GridPoint& {
    return mesh.grid_points[outer_edge(mesh, star.triangles[i], star.hub)[0]];
  };
  const std::size_t n = star.triangles.size();
  const exact::GridPoint& hub = mesh.grid_points[star.hub];
  Fan r = star;
  r.plane = exact::spanned_plane(outer(0), outer(n / 3), outer(2 * n / 3));
  if (exact::side(r.plane, hub) < 0) r.plane = r.plane.opposite();

  for (const std::uint32_t t : star.triangles)
    for (const std::uint32_t v : outer_edge(mesh, t, star.hub)) {
      const exact::int128 value = exact::value(r.plane, mesh.grid_points[v]);
      r.low = std::min(r.low, value);
      r.high = std::max(r.high, value);
    }
  if (exact::value(r.plane, hub) <= r.high) return std::nullopt;
  return r;
}

/// All fans worth a look; flat ones first, as the others ask that they are proved, then by size.
Array<Fan> large_fans(const Body& mesh, const Array<Star>& star_of) {
  Array<Fan> fans;
  for (const Fan& star : crowded_stars(mesh)) {
    if (Fan flat = flat_part(mesh, star); is_large(flat.triangles.size(), mesh) && is_embedded(mesh, flat))
      fans.push_back(std::move(flat));
    if (star_of[star.hub] != Star::embedded) continue;
    if (auto fan = cone(mesh, star)) fans.push_back(std::move(*fan));
  }
  std::sort(fans.begin(), fans.end(), [](const Fan& a, const Fan& b) {
    return std::tuple(b.flat, b.triangles.size(), a.hub) < std::tuple(a.flat, a.triangles.size(), b.hub);
  });
  return fans;
}

/// A flat fan to be compared with other triangles.
class FlatSide {
 public:
  FlatSide(const Body& mesh, const Fan& fan) : mesh_(mesh), fan_(fan), box_(mesh.grid_points[fan.hub]) {
    for (const std::uint32_t t : fan.triangles) {
      const Edge e = outer_edge(mesh, t, fan.hub);
      edges_.push_back(e);
      for (const std::uint32_t v : e) {
        vertices_.push_back(v);
        box_.add(mesh.grid_points[v]);
      }
    }
    std::sort(edges_.begin(), edges_.end());
    std::sort(vertices_.begin(), vertices_.end());
  }

  /// Does one look at the plane prove that all triangles of the fan meet t as they should? t is none of them.
  bool meets_properly(std::uint32_t t) const {
    const auto& c = mesh_.triangles[t];
    WideBox box(mesh_.grid_points[c[0]]);
    box.add(mesh_.grid_points[c[1]]);
    box.add(mesh_.grid_points[c[2]]);
    if (!box.meets(box_)) return true;

    std::array<std::uint32_t, 3> on_plane{};
    std::size_t count = 0;
    bool above = false, below = false;
    for (const std::uint32_t v : c) {
      const int side = exact::side(fan_.plane, mesh_.grid_points[v]);
      above = above || side > 0;
      below = below || side < 0;
      if (side == 0) on_plane[count++] = v;
    }
    if (above && below) return false;
    switch (count) {
      case 0:
        return true;
      case 1:
        return has_corner(on_plane[0]);
      case 2:
        return has_edge(on_plane[0], on_plane[1]);
      default:
        return false;
    }
  }

 private:
  bool has_corner(std::uint32_t v) const {
    return v == fan_.hub || std::binary_search(vertices_.begin(), vertices_.end(), v);
  }
  bool has_edge(std::uint32_t u, std::uint32_t v) const {
    if (u == fan_.hub) return has_corner(v);
    if (v == fan_.hub) return has_corner(u);
    return std::binary_search(edges_.begin(), edges_.end(), Edge{u, v}) ||
           std::binary_search(edges_.begin(), edges_.end(), Edge{v, u});
  }

  const Body& mesh_;
  const Fan& fan_;
  WideBox box_;
  Array<Edge> edges_;              // those that face the hub
  Array<std::uint32_t> vertices_;  // without the hub
};

/// A triangle with the values of a plane at its corners.
struct Leveled {
  std::array<exact::GridPoint, 3> corner;
  std::array<exact::int128, 3> value;

  Leveled(const Body& mesh, const exact::Plane& plane, std::uint32_t t) {
    for (std::size_t i = 0; i < 3; ++i) {
      corner[i] = mesh.grid_points[mesh.triangles[t][i]];
      value[i] = exact::value(plane, corner[i]);
    }
  }
  exact::int128 greatest() const { return std::max({value[0], value[1], value[2]}); }

  /// Holds what lies between two levels. Values are below 2^93 and coordinates differ by at most 2^30.
  Box between(exact::int128 low, exact::int128 high) const {
    Box box;
    for (std::size_t i = 0; i < 3; ++i) {
      if (low <= value[i] && value[i] <= high) box.add(corner[i]);
      for (const exact::int128 level : {low, high}) add_crossing(i, grid::next_in_loop(i, std::size_t{3}), level, box);
    }
    return box;
  }

 private:
  /// Where an edge passes a level.
  void add_crossing(std::size_t i, std::size_t j, exact::int128 level, Box& box) const {
    if ((value[i] < level) == (value[j] < level)) return;
    const exact::int128 length = value[j] - value[i], part = level - value[i];
    exact::GridPoint lower{}, upper{};
    for (std::size_t k = 0; k < 3; ++k) {
      const exact::int128 along = (std::int64_t{corner[j].c[k]} - corner[i].c[k]) * part;
      // Truncated; a step more on either side holds the quotient.
      const auto step = static_cast<std::int32_t>(along / length);
      lower.c[k] = corner[i].c[k] + step - 1;
      upper.c[k] = corner[i].c[k] + step + 1;
    }
    box.add(lower);
    box.add(upper);
  }
};

/// Do all triangles of a cone meet all others as they should? What lies higher than its outer edges somewhere is not
/// looked at: false. The others meet the cone between the levels of these edges only, where little is left of either.
bool is_proper(const Body& mesh, const Fan& cone, const Array<std::uint8_t>& own_or_proved) {
  constexpr std::uint32_t own = 0, other = 1;
  Array<BoxTree::Item> items;
  Box all;
  for (const std::uint32_t t : cone.triangles) {
    items.push_back({Leveled(mesh, cone.plane, t).between(cone.low, cone.high), t, own});
    all.add(face_box(mesh, t));
  }

  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (own_or_proved[t] || !face_box(mesh, t).meets(all)) continue;
    const Leveled triangle(mesh, cone.plane, t);
    if (triangle.greatest() < cone.low) continue;
    if (triangle.greatest() > cone.high) return false;
    items.push_back({triangle.between(cone.low, cone.high), t, other});
  }

  bool proper = true;
  BoxTree(items).pairs([&](std::uint32_t s, std::uint32_t t) { proper = proper && !meet_out_of_place(mesh, s, t); },
                       BoxTree::Pairs::foreign);
  return proper;
}

bool is_proper_flat(const Body& mesh, const Fan& flat, const Array<std::uint8_t>& own_or_proved) {
  const FlatSide side(mesh, flat);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (!own_or_proved[t] && !side.meets_properly(t)) return false;
  return true;
}

}  // namespace

Array<std::uint8_t> proved_in_fans(const Body& mesh, const Array<Star>& star_of) {
  const Array<Fan> fans = large_fans(mesh, star_of);
  if (fans.empty()) return {};

  Array<std::uint8_t> proved(mesh.triangles.size());
  for (const Fan& fan : fans) {
    Array<std::uint8_t> own_or_proved = proved;
    for (const std::uint32_t t : fan.triangles) own_or_proved[t] = 1;

    if (fan.flat ? is_proper_flat(mesh, fan, own_or_proved) : is_proper(mesh, fan, own_or_proved))
      for (const std::uint32_t own : fan.triangles) proved[own] = 1;
  }
  return proved;
}

}  // namespace quoin::booleans
