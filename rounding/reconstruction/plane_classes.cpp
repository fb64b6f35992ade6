#include "rounding/reconstruction/plane_classes.h"

#include <map>

namespace quoin::rounding {

using booleans::none;

exact::Plane PlaneClasses::rounded(std::uint32_t placement, std::uint32_t face) const {
  const auto& [of, turned] = faces[placement][face];
  return turned ? classes[of].rounded.opposite() : classes[of].rounded;
}

PlaneClasses plane_classes(std::span<const Placement> placements, const std::vector<bool>& by_planes) {
  PlaneClasses result;
  result.faces.resize(placements.size());
  std::map<WidePlane, std::uint32_t> ids;
  const auto add = [&](std::uint32_t i, std::uint32_t face, WidePlane plane) {
    const bool turned = !is_canonical(plane);
    if (turned) plane = plane.opposite();
    const auto [at, fresh] = ids.try_emplace(plane, static_cast<std::uint32_t>(result.classes.size()));
    if (fresh) result.classes.push_back({plane, 0, {}, {}});
    result.classes[at->second].users.push_back({i, face});
    result.faces[i].push_back({at->second, turned});
  };

  for (std::uint32_t i = 0; i < placements.size(); ++i) {
    if (!by_planes[i]) continue;
    const Placement& p = placements[i];
    const IntegerMap back = inverse(IntegerMap(p.to_grid));
    if (!p.shape) {
      add(i, none, moved(*p.half_space, back));
      continue;
    }
    const auto& planes = p.shape->polyhedron.planes;
    for (std::uint32_t f = 0; f < planes.size(); ++f) add(i, f, moved(planes[f], back));
  }
  return result;
}

bool ClassRounder::round(PlaneClass& c) {
  for (; c.level < methods_.size(); ++c.level)
    if (const auto p = rounded(c, methods_[c.level])) {
      c.rounded = *p;
      return true;
    }
  return false;
}

bool ClassRounder::strengthen(PlaneClass& c) {
  const std::size_t last = methods_.size() - 1;
  if (c.level >= last || is_exact(c)) return false;

  // `best` after `best` would change nothing.
  c.level = methods_[c.level] == Method::best ? last : c.level + 1;
  if (!round(c)) c.level = last;
  return true;
}

std::optional<exact::Plane> ClassRounder::rounded(const PlaneClass& c, Method method) {
  if (method != Method::face_local) return rounder_.round(c.exact, method);
  const auto points = points_on(c);
  return points.empty() ? rounder_.round(c.exact, Method::best) : rounder_.round_near(c.exact, points);
}

/// The points of all faces on a plane.
std::vector<Vector> ClassRounder::points_on(const PlaneClass& c) {
  std::vector<Vector> points;
  for (const auto& [i, f] : c.users) {
    if (f == none) continue;
    const std::vector<Vector>& all = points_.of(i);
    placements_[i].shape->polyhedron.faces.for_edges(f,
                                                     [&](std::uint32_t u, std::uint32_t) { points.push_back(all[u]); });
  }
  return points;
}

}  // namespace quoin::rounding
