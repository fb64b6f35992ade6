#include <algorithm>
#include <cmath>

#include "api/access.h"
#include "api/run.h"
#include "api/surface.h"
#include "booleans/surface/rounded.h"
#include "booleans/surface/separated.h"
#include "grid/balance.h"
#include "grid/snap.h"

namespace quoin {

using booleans::Body;
using booleans::Floats;
using booleans::Triangulated;

namespace {

/// What happened to a mesh on its way out; `points` are rounded.
ExportReport reported(const Body& body, const Triangulated& mesh, const grid::Lattice& lattice, Floats floats,
                      const std::vector<double>& points) {
  const auto effects = booleans::rounding_effects(body, mesh, lattice, floats, points);
  ExportReport report;
  report.triangles = mesh.triangle_count();
  report.flipped = effects.flipped;
  report.collapsed = effects.collapsed;
  report.split_edges = mesh.split_edges;
  report.closed = grid::is_balanced(mesh.corners, mesh.vertex_count());
  return report;
}

Result<Mesh> exported(const Body& body, const grid::Lattice& lattice, const ExportOptions& options, const Options& run,
                      ExportReport* report, SurfaceCounts* surface) {
  // False when the run was cancelled.
  const auto begin = [&](const char* stage, double fraction) {
    if (run.stage) run.stage(stage);
    if (run.progress) run.progress(fraction);
    return !run.cancel || !run.cancel->load(std::memory_order_relaxed);
  };
  const Error cancelled{ErrorCode::cancelled, "the export was cancelled"};

  if (!begin("triangulate", 0)) return cancelled;
  Triangulated mesh = booleans::triangulated(body);

  if (!begin("separate", 0.4)) return cancelled;
  const std::size_t vertices = mesh.vertex_count();
  const bool is_separated = options.topology == Topology::manifold;
  if (is_separated) mesh = booleans::separated(body, std::move(mesh));

  if (!begin("round", 0.7)) return cancelled;
  const Floats floats = options.float32 ? Floats::float32 : Floats::float64;
  Mesh out;
  out.points = booleans::rounded_points(body, mesh, lattice, floats);
  const auto far = std::find_if_not(out.points.begin(), out.points.end(), [](double x) { return std::isfinite(x); });
  if (far != out.points.end()) {
    const std::vector<double> places = booleans::rounded_points(body, mesh, lattice, Floats::float64);
    return Error{ErrorCode::out_of_range,
                 std::string("the solid reaches beyond the largest ") + (options.float32 ? "float32" : "double") +
                     "; scale the model down",
                 {},
                 "vertex " + grid::describe_point(&places[static_cast<std::size_t>(far - out.points.begin()) / 3 * 3])};
  }
  if (report) *report = reported(body, mesh, lattice, floats, out.points);
  if (surface) *surface = is_separated ? surface_counts(mesh, vertices) : surface_counts(body, mesh);

  out.triangles = std::move(mesh.corners);
  return out;
}

}  // namespace

Result<Mesh> Solid::to_triangles(const ExportOptions& options, ExportReport* report, SurfaceCounts* surface) const {
  if (report) *report = {};
  if (surface) *surface = {};
  const Body& body = Access::operand(*this);
  if (body.full_at_infinity)
    return Error{ErrorCode::unbounded, "an unbounded solid has no triangle mesh; its complement may have one"};
  return run_to_end(options.run, [&](const Options& run) {
    return with_threads(run.threads,
                        [&] { return exported(body, Access::lattice(*this), options, run, report, surface); });
  });
}

}  // namespace quoin
