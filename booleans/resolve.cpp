#include "booleans/resolve.h"

#include "booleans/body/canonical.h"
#include "booleans/pairs/own_pairs.h"
#include "booleans/stages.h"
#include "grid/lists/partition.h"

namespace quoin::booleans {
namespace {

/// One surface, connected over edges that all have exactly two faces? Where all stars are fans, triangles that hang
/// together over vertices hang together over such edges.
bool is_simple_surface(const Body& mesh, const Array<Star>& star_of) {
  if (std::find(star_of.begin(), star_of.end(), Star::other) != star_of.end()) return false;
  grid::Partition parts(mesh.grid_points.size());
  for (const auto& t : mesh.triangles) {
    parts.unite(t[0], t[1]);
    parts.unite(t[0], t[2]);
  }

  const auto first = parts.find(mesh.triangles[0][0]);
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [&](const auto& t) { return parts.find(t[0]) == first; });
}

}  // namespace

Result<Body> resolve(Body mesh, std::uint64_t& crossings, const Run& run) {
  if (!run.begin("pairs", 0.0)) return cancelled();
  crossings = 0;
  if (mesh.triangles.empty()) return mesh;
  const Array<Star> star_of = stars(mesh);
  const FacePairs pairs = improper_pairs(mesh, star_of);
  crossings = pairs.size();
  // An embedded connected surface that is not inside out has 1 inside and 0 outside: the door has seen its volume.
  if (pairs.empty() && is_simple_surface(mesh, star_of)) return mesh;

  const Result<Arrangement> a = arrange(Operands({&mesh}, false), pairs, run);
  if (!a) return a.error();
  Result<Body> solved = selected(a.value(), Expression::itself(), run);
  // An edge of more faces than two may be left with two that lie on one plane, one of them cut: they are joined (B4).
  const bool may_have_parted = !a.value().patches().crowded[OperandId(0)].empty();
  return solved && may_have_parted ? Result<Body>(body_of(canonical(solved.value()))) : std::move(solved);
}

}  // namespace quoin::booleans
