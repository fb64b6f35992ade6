#include "booleans/crowded_shells.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "booleans/pairs/box_tree.h"
#include "booleans/pairs/crowd.h"
#include "booleans/resolve.h"
#include "grid/lists/buckets.h"
#include "grid/lists/partition.h"
#include "grid/lists/stretches.h"
#include "grid/shells.h"

namespace quoin::booleans {
namespace {

/// Takes triangles of a mesh out, with their vertices.
class Excerpts {
 public:
  explicit Excerpts(const Body& mesh) : mesh_(mesh), name_(mesh.grid_points.size(), none) {}

  Body operator()(std::span<const std::uint32_t> triangles) {
    Body body;
    body.is_proved = mesh_.is_proved;
    body.labels.origins = mesh_.labels.origins;
    Array<exact::GridPoint> points;
    Array<std::array<std::uint32_t, 3>> renamed;
    for (const std::uint32_t t : triangles) {
      auto corners = mesh_.triangles[t];
      for (std::uint32_t& v : corners) {
        if (name_[v] == none) {
          name_[v] = static_cast<std::uint32_t>(points.size());
          points.push_back(mesh_.grid_points[v]);
        }
        v = name_[v];
      }
      renamed.push_back(corners);
      if (mesh_.labels) body.labels.triangles.push_back(mesh_.labels.triangles[t]);
    }

    for (const std::uint32_t t : triangles)
      for (const std::uint32_t v : mesh_.triangles[t]) name_[v] = none;
    body.grid_points = std::move(points);
    body.triangles = std::move(renamed);
    return body;
  }

 private:
  const Body& mesh_;
  Array<std::uint32_t> name_;  // of the mesh's vertices in the excerpt; none between two of them
};

bool are_fans(const Array<Star>& star_of) {
  return std::find(star_of.begin(), star_of.end(), Star::other) == star_of.end();
}

/// What hangs together over vertices, by the smallest of them.
grid::Partition vertex_parts(const Body& mesh) {
  grid::Partition parts(mesh.grid_points.size());
  for (const auto& t : mesh.triangles) {
    parts.unite(t[0], t[1]);
    parts.unite(t[0], t[2]);
  }
  return parts;
}

Array<Box> boxes_of(const Body& mesh, grid::Partition parts) {
  Array<std::uint32_t> name(mesh.grid_points.size(), none);
  Array<Box> boxes;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    std::uint32_t& part = name[parts.find(mesh.triangles[t][0])];
    if (part == none) {
      part = static_cast<std::uint32_t>(boxes.size());
      boxes.emplace_back();
    }
    boxes[part].add(face_box(mesh, t));
  }
  return boxes;
}
Array<Box> boxes_of(const Body& mesh, const grid::Shells& shells) {
  Array<Box> boxes(shells.six_volumes.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) boxes[shells.of_triangle[t]].add(face_box(mesh, t));
  return boxes;
}

bool may_be_crowded(const Array<Box>& boxes) { return boxes.size() > grid::thresholds().group && are_crowded(boxes); }

/// A shell as a solid.
struct ShellSolid {
  std::optional<Body> body;  // none where the winding number is negative somewhere
  std::size_t crossings = 0;
};

/// A connected surface that is embedded, and not inside out, has 1 inside and 0 outside. The winding number of any
/// other one is nowhere negative exactly when nothing is inside of it turned round. Precondition: a volume > 0.
ShellSolid solid_of(Body shell, const Run& run) {
  const Array<Star> star_of = stars(shell);
  const FacePairs pairs = improper_pairs(shell, star_of);
  if (pairs.empty() && is_simple_surface(shell, star_of)) return {std::move(shell)};

  Body turned = complement(shell);
  turned.full_at_infinity = false;
  const Result<Body> negative = resolved_at_once(turned, pairs, run);
  if (!negative || negative.value().face_count() > 0) return {};
  Result<Body> positive = resolved_at_once(shell, pairs, run);
  if (!positive) return {};
  return {std::move(positive).value(), pairs.size()};
}

/// By shell: does its box meet that of one that is no solid, or is it none itself?
Array<std::uint8_t> are_in_rest(const Array<Box>& boxes, const std::vector<ShellSolid>& solids) {
  Array<BoxTree::Item> items;
  for (std::uint32_t s = 0; s < boxes.size(); ++s)
    if (!solids[s].body) items.push_back({boxes[s], s, s});

  const BoxTree others(items);
  Array<std::uint8_t> in_rest(boxes.size());
  for (std::uint32_t s = 0; s < boxes.size(); ++s) {
    Box box = boxes[s];
    others.meeting(box, [&](std::uint32_t) {
      in_rest[s] = 1;
      box = {};  // one is enough
    });
  }
  return in_rest;
}

}  // namespace

bool is_simple_surface(const Body& mesh, const Array<Star>& star_of) {
  if (!are_fans(star_of)) return false;
  grid::Partition parts = vertex_parts(mesh);
  const auto first = parts.find(mesh.triangles[0][0]);
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [&](const auto& t) { return parts.find(t[0]) == first; });
}

CrowdedShells crowded_shells(const Body& mesh, const Array<Star>& star_of, const std::atomic<bool>* cancel) {
  // Shells of fans are what hangs together over vertices, which is found in less time and memory than over edges.
  if (are_fans(star_of) && !may_be_crowded(boxes_of(mesh, vertex_parts(mesh)))) return {};
  const grid::Shells shells = grid::shells({mesh.grid_points.begin(), mesh.grid_points.size()},
                                           {mesh.triangles.begin(), mesh.triangles.size()});
  const Array<Box> boxes = boxes_of(mesh, shells);
  if (!may_be_crowded(boxes)) return {};

  const std::size_t count = boxes.size();
  const auto triangles =
      grid::in_buckets(mesh.triangles.size(), count, [&](std::uint32_t t) { return shells.of_triangle[t]; });
  Excerpts excerpt(mesh);
  std::vector<Body> bodies;
  for (std::size_t s = 0; s < count; ++s) bodies.push_back(excerpt(triangles[s]));
  std::vector<ShellSolid> solids(count);
  grid::in_stretches(count, 1, [&](std::size_t s, std::size_t, std::size_t) {
    if (shells.six_volumes[s] > 0) solids[s] = solid_of(std::move(bodies[s]), Run{{}, cancel});
  });

  const Array<std::uint8_t> in_rest = are_in_rest(boxes, solids);
  CrowdedShells result;
  for (std::size_t s = 0; s < count; ++s) {
    if (in_rest[s]) continue;
    result.solids.push_back(std::move(*solids[s].body));
    result.crossings += solids[s].crossings;
  }
  if (result.solids.size() <= grid::thresholds().group) return {};

  Array<std::uint32_t> others;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (in_rest[shells.of_triangle[t]]) others.push_back(t);
  result.rest = excerpt(others);
  return result;
}

}  // namespace quoin::booleans
