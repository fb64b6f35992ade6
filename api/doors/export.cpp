#include <algorithm>
#include <cmath>
#include <optional>

#include "api/access.h"
#include "api/doors/surface.h"
#include "api/labels.h"
#include "api/run.h"
#include "booleans/body/measure.h"
#include "booleans/mended.h"
#include "booleans/surface/detail.h"
#include "booleans/surface/rounded.h"
#include "booleans/surface/separated.h"
#include "booleans/surface/valid.h"
#include "grid/balance.h"
#include "grid/snap.h"

namespace quoin {

using booleans::Body;
using booleans::Floats;
using booleans::SharedEdges;
using booleans::Triangulated;

namespace {

/// A body as rounded triangles.
struct Draft {
  Triangulated mesh;
  std::size_t vertices = 0;  // before touching parts were separated
  std::vector<double> points;
  booleans::Moves moves;
  // If they are asked for:
  booleans::TriangleLabels labels;  // of the triangles
  PublicChannels channels;          // of their corners
};

Floats floats_of(const ExportOptions& options) { return options.float32 ? Floats::float32 : Floats::float64; }

Draft rounded(const Body& body, const grid::Lattice& lattice, Floats floats, Triangulated mesh) {
  Draft draft;
  draft.vertices = mesh.vertex_count();
  draft.mesh = std::move(mesh);
  draft.points = booleans::rounded_points(body, draft.mesh, lattice, floats);
  draft.moves = booleans::moves(body, draft.mesh, lattice, floats, draft.points);
  return draft;
}

Draft drafted(const Body& body, const grid::Lattice& lattice, Floats floats, Topology topology,
              SharedEdges shared = SharedEdges::split) {
  Triangulated mesh = booleans::triangulated(body);
  if (topology == Topology::indexed) return rounded(body, lattice, floats, std::move(mesh));
  const std::size_t vertices = mesh.vertex_count();
  Draft draft = rounded(body, lattice, floats, booleans::separated(body, std::move(mesh), shared));
  draft.vertices = vertices;
  return draft;
}

/// What the triangles of a draft carry.
booleans::TriangleLabels labels_of(const Body& body, const Draft& draft) {
  booleans::TriangleLabels labels{body.labels.origins};
  if (!body.labels) return labels;
  labels.of_triangle.reserve(draft.mesh.triangle_count());
  for (const std::uint32_t f : draft.mesh.face) labels.of_triangle.push_back(body.provenance(f));
  return labels;
}

/// What a draft carries for the outside. `centre`: what was subtracted from points in model units.
void label(const Body& body, const grid::Lattice& lattice, const std::array<double, 3>& centre, Draft& draft) {
  grid::Lattice own = lattice;
  for (std::size_t k = 0; k < 3; ++k) own.origin[k] += exact::to_rational(centre[k]);
  draft.labels = labels_of(body, draft);
  draft.channels = public_channels(body, draft.mesh, draft.labels, booleans::to_model(own));
}

bool is_valid(const Body& body, const grid::Lattice& lattice, Floats floats, const Draft& draft) {
  return booleans::is_valid(body, draft.mesh, floats, lattice, draft.points, draft.moves);
}

/// What is written, and what mending it took.
struct Mending {
  Draft draft;
  bool is_valid = false;
  std::uint64_t rounds = 0, crossings = 0, merged_points = 0, vanished_triangles = 0;
  double most = 0;
};

/// A valid draft of a body, or nothing. A vertex that `separated` puts inside an edge may find no room.
std::optional<Draft> valid_draft(const Body& body, const grid::Lattice& lattice, Floats floats, Topology topology) {
  Draft draft = drafted(body, lattice, floats, topology);
  if (is_valid(body, lattice, floats, draft)) return draft;
  if (draft.mesh.split_edges == 0) return std::nullopt;
  draft = drafted(body, lattice, floats, topology, SharedEdges::kept);
  return is_valid(body, lattice, floats, draft) ? std::optional(std::move(draft)) : std::nullopt;
}

/// Mends a draft of a body: its numbers are snapped to a lattice of numbers and resolved, until what comes out can be
/// rounded validly. Where points remain that rounding moves, the lattice becomes coarser from round to round.
/// It ends: at the latest where all points go to one and nothing is left.
/// Not valid only where a solid was trusted that is none, or cannot be resolved.
/// Errors: "cancelled".
Result<Mending> mended(const Body& body, const grid::Lattice& lattice, const ExportOptions& options, Draft draft,
                       bool with_labels, const std::array<double, 3>& centre, const Cancel* cancel) {
  constexpr int finest_rounds = 2, faster = 2;
  const Floats floats = floats_of(options);
  Mending all;
  all.most = draft.moves.most;
  const auto finished = [&](Draft&& valid, const Body& of, const grid::Lattice& on) {
    all.draft = std::move(valid);
    all.is_valid = true;
    if (with_labels) label(of, on, centre, all.draft);
  };
  if (draft.mesh.split_edges > 0) {
    if (auto valid = valid_draft(body, lattice, floats, options.topology)) {
      finished(std::move(*valid), body, lattice);
      return all;
    }
    draft = drafted(body, lattice, floats, Topology::indexed);
  }
  if (with_labels) draft.labels = labels_of(body, draft);

  for (int round = 1;; ++round) {
    auto next =
        booleans::mended(draft.points, draft.mesh.corners, draft.labels, floats,
                         {draft.moves.moved, std::max(0, faster * (round - finest_rounds))}, {.cancel = cancel});
    if (!next && next.error().code == ErrorCode::cancelled) return next.error();
    if (!next) break;
    ++all.rounds;
    all.crossings += next.value().crossings;
    all.merged_points += next.value().merged_points;
    all.vanished_triangles += next.value().vanished_triangles;
    all.most += next.value().most;

    const auto& [mended, numbers] = std::tie(next.value().body, next.value().lattice);
    if (auto valid = valid_draft(mended, numbers, floats, options.topology)) {
      all.most += valid->moves.most;
      finished(std::move(*valid), mended, numbers);
      return all;
    }
    draft = drafted(mended, numbers, floats, Topology::indexed);
    if (with_labels) draft.labels = labels_of(mended, draft);
    all.most += draft.moves.most;
  }
  all.draft = drafted(body, lattice, floats, options.topology);
  if (with_labels) label(body, lattice, centre, all.draft);
  return all;
}

/// The first vertex whose numbers are infinite, as the place of an error.
std::optional<Error> out_of_range(const Body& body, const Draft& draft, const grid::Lattice& lattice, bool float32) {
  const auto far =
      std::find_if_not(draft.points.begin(), draft.points.end(), [](double x) { return std::isfinite(x); });
  if (far == draft.points.end()) return std::nullopt;
  const std::vector<double> places = booleans::rounded_points(body, draft.mesh, lattice, Floats::float64);
  return Error{ErrorCode::out_of_range,
               std::string("the solid reaches beyond the largest ") + (float32 ? "float32" : "double") +
                   "; scale the model down",
               {},
               "vertex " + grid::describe_point(&places[static_cast<std::size_t>(far - draft.points.begin()) / 3 * 3])};
}

ExportReport reported(const Body& body, const Mending& mending, const grid::Lattice& lattice,
                      const ExportOptions& options) {
  const Draft& draft = mending.draft;
  ExportReport report;
  report.triangles = draft.mesh.triangle_count();
  report.split_edges = draft.mesh.split_edges;
  report.shared_edges = draft.mesh.shared_edges;
  report.closed = grid::is_balanced(draft.mesh.corners, draft.mesh.vertex_count());
  report.valid = mending.is_valid && body.is_proved;
  report.max_round = mending.most;
  report.mending_rounds = mending.rounds;
  report.mended_crossings = mending.crossings;
  report.merged_vertices = mending.merged_points;
  report.vanished_triangles = mending.vanished_triangles;
  if (mending.is_valid) return report;

  const auto effects = booleans::rounding_effects(body, draft.mesh, lattice, floats_of(options), draft.points);
  report.flipped = effects.flipped;
  report.collapsed = effects.collapsed;
  return report;
}

/// The centre of the box, each coordinate rounded to a multiple of the least power of two that is not below half the
/// box's largest side.
std::array<double, 3> rounded_centre(const Body& body, const grid::Lattice& lattice) {
  std::array<double, 3> centre{};
  const auto box = booleans::rounded_box(body, lattice);
  if (!box) return centre;
  const auto& [low, high] = *box;
  double half = 0;
  for (std::size_t k = 0; k < 3; ++k) half = std::max(half, high[k] / 2 - low[k] / 2);
  if (!(half > 0)) return centre;

  int exponent = 0;
  const double fraction = std::frexp(half, &exponent);
  if (fraction == 0.5) --exponent;
  for (std::size_t k = 0; k < 3; ++k)
    centre[k] = std::ldexp(std::nearbyint(std::ldexp(low[k] / 2 + high[k] / 2, -exponent)), exponent) + 0.0;
  return centre;
}

Result<LabelledMesh> exported(const Body& body, const grid::Lattice& own, const ExportOptions& options,
                              const Options& run, bool with_labels, ExportReport* report, SurfaceCounts* surface) {
  // False when the run was cancelled.
  const auto begin = [&](const char* stage, double fraction) {
    if (run.stage) run.stage(stage);
    if (run.progress) run.progress(fraction);
    return !run.cancel || !run.cancel->load(std::memory_order_relaxed);
  };
  const Error cancelled{ErrorCode::cancelled, "the export was cancelled"};
  const bool is_separated = options.topology == Topology::manifold;
  const Floats floats = floats_of(options);
  grid::Lattice lattice = own;
  std::array<double, 3> centre{};
  if (options.recentre) centre = rounded_centre(body, own);
  for (std::size_t k = 0; k < 3; ++k) lattice.origin[k] -= exact::to_rational(centre[k]);

  if (!begin("triangulate", 0)) return cancelled;
  Triangulated mesh = booleans::triangulated(body);

  if (!begin("separate", 0.4)) return cancelled;
  const std::size_t vertices = mesh.vertex_count();
  if (is_separated) mesh = booleans::separated(body, std::move(mesh));

  if (!begin("round", 0.6)) return cancelled;
  Draft draft = rounded(body, lattice, floats, std::move(mesh));
  if (const auto far = out_of_range(body, draft, lattice, options.float32)) return *far;
  if (surface) *surface = is_separated ? surface_counts(draft.mesh, vertices) : surface_counts(body, draft.mesh);

  if (!begin("prove", 0.7)) return cancelled;
  const bool wants_proof = options.validity == Validity::valid;
  Mending result;
  result.most = draft.moves.most;
  result.is_valid = wants_proof && is_valid(body, lattice, floats, draft);
  const double reach = ExportReport::detail_factor * result.most;
  const double detail = report && reach > 0 ? booleans::least_detail(body, draft.mesh, lattice, reach) : 0;

  if (wants_proof && !result.is_valid) {
    if (!begin("mend", 0.8)) return cancelled;
    auto mending = mended(body, lattice, options, std::move(draft), with_labels, centre, run.cancel);
    if (!mending) return cancelled;
    result = std::move(mending).value();
  } else {
    result.draft = std::move(draft);
    if (with_labels) label(body, lattice, centre, result.draft);
  }

  if (report) {
    *report = reported(body, result, lattice, options);
    report->recentred = centre;
    report->least_detail = detail;
  }
  const Draft& made = result.draft;
  PublicLabels labels;
  if (with_labels)
    labels = public_labels(made.labels.origins.get(), made.labels.of_triangle, made.mesh.triangle_count());
  return LabelledMesh{{std::move(result.draft.points), std::move(result.draft.mesh.corners)},
                      std::move(labels.originals),
                      std::move(labels.labels),
                      made.channels.count,
                      std::move(result.draft.channels.values)};
}

Result<LabelledMesh> exported_solid(const Solid& solid, const ExportOptions& options, bool with_labels,
                                    ExportReport* report, SurfaceCounts* surface) {
  if (report) *report = {};
  if (surface) *surface = {};
  const Body& body = Access::operand(solid);
  if (body.full_at_infinity)
    return Error{ErrorCode::unbounded, "an unbounded solid has no triangle mesh; its complement may have one"};
  return run_to_end(options.run, [&](const Options& run) {
    return with_threads(run.threads, [&] {
      return exported(body, Access::lattice(solid), options, run, with_labels, report, surface);
    });
  });
}

}  // namespace

Result<LabelledMesh> to_labelled_triangles(const Solid& solid, const ExportOptions& options, ExportReport* report) {
  return exported_solid(solid, options, true, report, nullptr);
}

Result<Mesh> Solid::to_triangles(const ExportOptions& options, ExportReport* report, SurfaceCounts* surface) const {
  auto mesh = exported_solid(*this, options, false, report, surface);
  if (!mesh) return mesh.error();
  return static_cast<Mesh&&>(std::move(mesh).value());
}

}  // namespace quoin
