#include "rounding/reconstruction/reconstruct.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "rounding/reconstruction/conditions.h"
#include "rounding/reconstruction/displacement.h"
#include "rounding/reconstruction/exact_body.h"
#include "rounding/reconstruction/plane_classes.h"
#include "rounding/reconstruction/refusals.h"
#include "rounding/reconstruction/vertex_rounding.h"

namespace quoin::rounding {
namespace {

using booleans::none;

/// What is done, and whether to go on.
class Progress {
 public:
  explicit Progress(const ReconstructionOptions& options) : options_(options) {}
  void begin(std::size_t all) { all_ = all; }
  bool is_cancelled() const { return options_.cancel && options_.cancel->load(); }

  /// One plane or primitive is done; what is done again counts once more, up to the whole.
  void step() {
    done_ = std::min(done_ + 1, all_);
    if (options_.progress) options_.progress(static_cast<double>(done_) / static_cast<double>(all_));
  }

 private:
  const ReconstructionOptions& options_;
  std::size_t done_ = 0, all_ = 0;
};

/// Which placements are rounded plane by plane.
std::vector<bool> by_planes(std::span<const Placement> placements, bool by_vertices) {
  std::vector<bool> result;
  for (const Placement& p : placements) result.push_back(!p.shape || (p.shape->trihedral && !by_vertices));
  return result;
}

/// The planes of a primitive's faces, and the vertices in which they meet.
struct Attempt {
  booleans::Boundary boundary;
  booleans::Body body;
  std::optional<Violation> violation;
};

/// With the planes as they are rounded now. The body is made when C1 and C2 hold.
Attempt attempt(std::uint32_t i, const Placement& placement, const PlaneClasses& planes) {
  const Trihedral& t = *placement.shape->trihedral;
  Attempt a;
  for (std::uint32_t f = 0; f < planes.faces[i].size(); ++f) a.boundary.planes.push_back(planes.rounded(i, f));

  a.violation = meet_vertices(t, placement.is_turned_round() ? -1 : 1, a.boundary);
  if (!a.violation) a.violation = order_violation(t, a.boundary);
  if (a.violation) return a;

  place_faces(placement, a.boundary);
  a.body = booleans::body_of(a.boundary);
  a.violation = crossing_violation(a.body);
  return a;
}

/// Of a primitive whose conditions hold.
Reconstructed reconstructed(std::uint32_t i, const Placement& placement, const PlaneClasses& planes,
                            const ClassRounder& rounder, Attempt&& a) {
  Reconstructed result;
  result.body = std::move(a.body);
  bool is_exact = true;
  for (std::uint32_t f = 0; f < planes.faces[i].size(); ++f) is_exact = is_exact && rounder.is_exact(planes.of(i, f));
  if (!is_exact) {
    const auto& points = placement.shape->polyhedron.points;
    result.displacement = displacement_above(points, IntegerMap(placement.to_grid), a.boundary);
  }
  return result;
}

/// Rounds the planes of the violated condition, or all of the primitive's, by a stronger method; false when there is
/// none. Those who use one of them are `pending` again.
bool strengthen(std::uint32_t i, const Placement& placement, const Violation& violation, PlaneClasses& planes,
                ClassRounder& rounder, std::vector<bool>& pending) {
  std::vector<std::uint32_t> faces;
  if (violation.vertex != none) {
    const auto& around = placement.shape->trihedral->faces[violation.vertex];
    faces = {violation.face, around[0], around[1], around[2]};
  } else {
    for (std::uint32_t f = 0; f < planes.faces[i].size(); ++f) faces.push_back(f);
  }

  bool changed = false;
  for (const std::uint32_t f : faces) {
    PlaneClass& c = planes.of(i, f);
    if (!rounder.strengthen(c)) continue;
    changed = true;
    for (const PlaneClass::User& user : c.users) pending[user.placement] = true;
  }
  return changed;
}

Result<void> round_classes(PlaneClasses& planes, ClassRounder& rounder, CarriedPoints& points, Progress& progress) {
  for (PlaneClass& c : planes.classes) {
    if (!rounder.round(c)) {
      for (const auto& [primitive, face] : c.users)
        if (face != none) return out_of_range(primitive, points.of(primitive));
      return half_space_out_of_range(c.users.front().placement);
    }
    if (progress.is_cancelled()) return cancelled();
    progress.step();
  }
  return {};
}

/// Primitive by primitive, until the conditions of all hold.
Result<void> reconstruct_by_planes(std::span<const Placement> placements, std::vector<bool> pending,
                                   PlaneClasses& planes, ClassRounder& rounder, CarriedPoints& points,
                                   Progress& progress, std::vector<Reconstructed>& out) {
  for (bool again = true; again;) {
    again = false;
    for (std::uint32_t i = 0; i < placements.size(); ++i) {
      if (!pending[i]) continue;
      if (progress.is_cancelled()) return cancelled();
      pending[i] = false;

      const Placement& placement = placements[i];
      if (!placement.shape) {
        out[i].plane = planes.rounded(i, 0);
        progress.step();
        continue;
      }

      Attempt a = attempt(i, placement, planes);
      if (!a.violation) {
        out[i] = reconstructed(i, placement, planes, rounder, std::move(a));
        progress.step();
        continue;
      }
      if (a.violation->kind == Violation::Kind::world) return out_of_range(i, points.of(i));
      if (!strengthen(i, placement, *a.violation, planes, rounder, pending))
        return inconsistent(i, *a.violation, points.of(i));
      again = true;
    }
  }
  return {};
}

/// Exactly where that goes, else vertex by vertex.
Result<Reconstructed> without_planes(std::uint32_t i, const Placement& placement, bool by_vertices,
                                     CarriedPoints& points) {
  if (!by_vertices)
    if (auto body = exact_body(i, placement, points)) {
      Reconstructed result;
      result.body = std::move(*body);
      return result;
    }
  return round_vertices(i, placement, points);
}

void count_planes(const PlaneClasses& planes, const ClassRounder& rounder, Reconstruction& out) {
  out.planes = planes.classes.size();
  for (const PlaneClass& c : planes.classes) {
    out.exact_planes += rounder.is_exact(c);
    out.face_local_planes += rounder.is_face_local(c);
  }
}

}  // namespace

Result<Reconstruction> reconstruct(std::span<const Placement> placements, const ReconstructionOptions& options) {
  Reconstruction out;
  out.primitives.resize(placements.size());
  Progress progress(options);
  CarriedPoints points(placements);

  const std::vector<bool> planar = by_planes(placements, options.by_vertices);
  PlaneClasses planes = plane_classes(placements, planar);
  progress.begin(planes.classes.size() + placements.size());
  ClassRounder rounder(placements, options.method, points);
  if (const auto done = round_classes(planes, rounder, points, progress); !done) return done.error();

  for (std::uint32_t i = 0; i < placements.size(); ++i) {
    if (progress.is_cancelled()) return cancelled();
    if (planar[i]) continue;
    auto made = without_planes(i, placements[i], options.by_vertices, points);
    if (!made) return made.error();
    out.primitives[i] = std::move(made).value();
    progress.step();
  }

  const auto done = reconstruct_by_planes(placements, planar, planes, rounder, points, progress, out.primitives);
  if (!done) return done.error();
  count_planes(planes, rounder, out);
  return out;
}

}  // namespace quoin::rounding
