#include "booleans/resolve.h"

#include "booleans/body/canonical.h"
#include "booleans/crowded_shells.h"
#include "booleans/parts.h"
#include "booleans/stages.h"

namespace quoin::booleans {
namespace {

/// The union of solids and of what the rest of the shells make.
Result<Body> resolved_in_parts(const CrowdedShells& shells, std::uint64_t& crossings, const Run& run) {
  std::vector<const Body*> parts;
  for (const Body& solid : shells.solids) parts.push_back(&solid);
  crossings = shells.crossings;
  Result<Body> rest = Body{};
  if (!shells.rest.triangles.empty()) {
    const FacePairs pairs = improper_pairs(shells.rest, stars(shells.rest));
    crossings += pairs.size();
    rest = resolved_at_once(shells.rest, pairs, run.of_part());
    if (!rest) return rest;
    parts.push_back(&rest.value());
  }

  std::atomic<std::uint64_t> found = 0;
  Run counting = run;
  counting.pairs = &found;
  const Expression all = Expression::flat(Rule::any, static_cast<std::uint32_t>(parts.size()));
  Result<Body> united = evaluate_in_parts(parts, all, counting);
  crossings += found;
  return united;
}

}  // namespace

Result<Body> resolved_at_once(const Body& mesh, const FacePairs& pairs, const Run& run) {
  const Result<Arrangement> a = arrange(Operands({&mesh}, false), pairs, run);
  if (!a) return a.error();
  Result<Body> solved = selected(a.value(), Expression::itself(), run);
  // An edge of more faces than two may be left with two that lie on one plane, one of them cut: they are joined (B4).
  const bool may_have_parted = !a.value().patches().crowded[OperandId(0)].empty();
  return solved && may_have_parted ? Result<Body>(body_of(labelled_boundary(solved.value()))) : std::move(solved);
}

Result<Body> resolve(Body mesh, std::uint64_t& crossings, const Run& run) {
  if (!run.begin("pairs", 0.0)) return cancelled();
  crossings = 0;
  if (mesh.triangles.empty()) return mesh;
  const Array<Star> star_of = stars(mesh);
  const bool is_simple = is_simple_surface(mesh, star_of);
  if (!is_simple)
    if (const CrowdedShells shells = crowded_shells(mesh, star_of, run.cancel); !shells.solids.empty())
      return resolved_in_parts(shells, crossings, run);

  const FacePairs pairs = improper_pairs(mesh, star_of);
  crossings = pairs.size();
  // An embedded connected surface that is not inside out has 1 inside and 0 outside: the door has seen its volume.
  if (pairs.empty() && is_simple) return mesh;
  return resolved_at_once(mesh, pairs, run);
}

}  // namespace quoin::booleans
