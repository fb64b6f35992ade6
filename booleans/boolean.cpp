#include "booleans/boolean.h"

#include "booleans/assemble.h"
#include "booleans/candidates.h"
#include "booleans/canonical.h"
#include "booleans/check.h"

namespace quoin::booleans {
namespace {

/// Reports stages and asks whether to go on.
class Stages {
 public:
  explicit Stages(const Run& run) : run_(run) {}
  /// Announces a stage, or the end (no name). False when the run was cancelled.
  bool begin(const char* name, double fraction) const {
    if (name && run_.stage) run_.stage(name);
    if (run_.progress) run_.progress(fraction);
    return !run_.cancel || !run_.cancel->load(std::memory_order_relaxed);
  }

 private:
  const Run& run_;
};

Error cancelled() { return {"cancelled", "the operation was cancelled"}; }

/// Everything after the broad phase.
Result<Body> arrange(Arrangement a, const Expression& expression, const std::vector<FaceIdPair>& near, Glue glue,
                     const Run& run) {
  const Stages stages(run);
  if (!stages.begin("merge coplanar", 0.2)) return cancelled();
  a.touched = collect_touched(a.operands, near, a.vertices, a.planes);
  if constexpr (exact::checked) check(a.touched, a.vertices, a.planes);
  if (!stages.begin("intersect", 0.3)) return cancelled();

  const Contacts contacts = find_contacts(a.touched, touched_pairs(a.touched, near), a.vertices, a.planes);
  if (!stages.begin("subdivide", 0.5)) return cancelled();

  a.sheets = draw_sheets(a.touched, contacts, a.vertices, a.planes);
  if constexpr (exact::checked)
    for (const Sheet& s : a.sheets) check(s, a.vertices, a.planes);
  if (!stages.begin("connect", 0.7)) return cancelled();
  connect(a, glue);
  if (exact::checked && glue == Glue::vertices) check(a);  // elsewhere an edge also has faces that are glued, not used
  if (!stages.begin("classify and select", 0.8)) return cancelled();
  const Selection selection = select(a, expression);
  if (!selection.consistent)
    return Error{"inconsistent",
                 "the surfaces do not bound a solid: an operand that was trusted crosses itself or is not closed"};
  if (!stages.begin("assemble", 0.9)) return cancelled();
  Body result = assemble(a, selection);
  if constexpr (exact::checked) check(result);
  stages.begin(nullptr, 1.0);
  return result;
}

}  // namespace

Result<Body> evaluate(std::span<const Body* const> operands, const Expression& expression, const Run& run) {
  if (!Stages(run).begin("broad phase", 0.0)) return cancelled();
  Arrangement a({operands.begin(), operands.end()});
  const std::vector<FaceIdPair> near = foreign_pairs(a.operands);
  return arrange(std::move(a), expression, near, Glue::vertices, run);
}

namespace {

/// One surface, connected over edges that all have exactly two faces? Where all stars are fans, triangles that hang
/// together over vertices hang together over such edges.
bool is_simple_surface(const Body& mesh, const std::vector<Star>& star_of) {
  if (std::find(star_of.begin(), star_of.end(), Star::other) != star_of.end()) return false;
  Partition parts(mesh.grid_points.size());
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
  if (!Stages(run).begin("prove embedding", 0.0)) return cancelled();
  crossings = 0;
  if (mesh.triangles.empty()) return mesh;
  const std::vector<Star> star_of = stars(mesh);
  const std::vector<FaceIdPair> near = improper_pairs(mesh, star_of);
  crossings = near.size();
  // An embedded connected surface that is not inside out has 1 inside and 0 outside: the door has seen its volume.
  if (near.empty() && is_simple_surface(mesh, star_of)) return mesh;
  Expression itself;
  itself.add({Rule::operand, false, 0, none});
  Result<Body> solved = arrange(Arrangement({&mesh}), itself, near, Glue::edges, run);
  if (!solved) return solved;
  return body_of(canonical(solved.value()));  // joins cut faces with untouched ones of their plane (B4)
}

}  // namespace quoin::booleans
