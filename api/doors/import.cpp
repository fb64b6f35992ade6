#include "api/doors/import.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "api/access.h"
#include "api/doors/repair.h"
#include "api/labels.h"
#include "api/run.h"
#include "booleans/dropped_shells.h"
#include "booleans/resolve.h"
#include "grid/import.h"
#include "grid/snap.h"
#include "io/too_large.h"

namespace quoin {
namespace {

bool cancelled(const Options& options) { return options.cancel != nullptr && options.cancel->load(); }

Result<Grid> chosen_grid(std::span<const double> points, const ImportOptions& options) {
  if (options.grid) return *options.grid;
  return fitting_grid(std::array{points});
}

ImportReport report_of(const grid::ImportedMesh& mesh) {
  ImportReport report;
  report.max_snap = mesh.max_snap;
  report.merged_points = mesh.merged_points;
  report.zero_area_triangles = mesh.zero_area_triangles;
  report.nonplanar_polygons = mesh.nonplanar_polygons;
  report.sealed_t_junctions = mesh.sealed_t_junctions;
  return report;
}

void note_dropped_shells(const booleans::DroppedShells& dropped, const grid::Lattice& lattice, ImportReport& report) {
  const std::string place = grid::describe_point(lattice, dropped.lowest_corner);
  report.dropped_where = "shell at " + place;
  report.findings.push_back(
      {Defect::inside_out, dropped.count, 0, "near " + place, "invert-shells",
       std::to_string(dropped.count) + (dropped.count == 1 ? " shell is inside out" : " shells are inside out")});
  report.notices.push_back(notice_of_dropped_shells(dropped.count));
}

/// The body without crossings; adds to the report what that took, and what was lost.
Result<booleans::Body> resolved(const booleans::Body& mesh, const Grid& grid, const Options& run,
                                ImportReport* report) {
  std::uint64_t crossings = 0;
  auto body = booleans::resolve(mesh, crossings, run_of(run));
  if (!body || !report) return body;

  report->resolved_crossings = crossings;
  const booleans::DroppedShells dropped = booleans::dropped_shells(mesh, body.value());
  report->dropped_shells = dropped.count;
  if (dropped.count > 0) note_dropped_shells(dropped, Access::lattice(grid), *report);
  return body;
}

bool wants_labels(const ImportOptions& options) {
  return options.labels.size() > 0 || options.channels.size() > 0 || options.id != 0 || !options.name.empty();
}

/// A mesh as it was given; triangles have no `starts`.
struct Given {
  std::span<const double> points;
  std::span<const std::uint32_t> starts, corners;
  bool triangles;

  std::size_t faces() const { return triangles ? corners.size() / 3 : starts.empty() ? 0 : starts.size() - 1; }
};

/// The coordinates as doubles, which hold every float; `storage` keeps what had to be converted.
std::span<const double> doubles(const Coordinates& coordinates, std::vector<double>& storage) {
  if (const auto* exact = std::get_if<std::span<const double>>(&coordinates.values())) return *exact;
  const auto floats = std::get<std::span<const float>>(coordinates.values());
  storage.assign(floats.begin(), floats.end());
  return storage;
}

/// "bad-index" for a wrong number of labels or channels, "non-finite".
Result<void> check_labels(const Given& mesh, const ImportOptions& options) {
  if (const auto checked = check_label_count(options.labels.size(), mesh.faces()); !checked) return checked;
  const std::size_t channels = options.channels.size();
  if (channels != 0 && (mesh.corners.empty() || channels % mesh.corners.size() != 0))
    return Error{ErrorCode::bad_index, "there are " + std::to_string(channels) + " channel values for " +
                                           std::to_string(mesh.corners.size()) + " corners"};

  const auto far = std::visit(
      [](const auto& list) {
        return std::find_if(list.begin(), list.end(), [](auto x) { return !std::isfinite(x); }) - list.begin();
      },
      options.channels.values());
  if (static_cast<std::size_t>(far) == channels) return {};
  const std::string corner =
      "corner " + std::to_string(static_cast<std::size_t>(far) / (channels / mesh.corners.size()));
  return Error{ErrorCode::non_finite, "a channel of " + corner + " is not finite", {}, corner};
}

/// Gives an origin the channels of a mesh.
/// Errors: "bad-number" (a polygon whose channels are no affine function), those of `grid::snap`.
Result<void> add_channels(const Given& given, const grid::ImportedMesh& mesh, const grid::Lattice& lattice,
                          const ImportOptions& options, booleans::Origin& origin) {
  std::vector<double> storage;
  const auto snapped = grid::snap(given.points, lattice);
  if (!snapped) return snapped.error();
  const booleans::ChannelInput input{static_cast<std::uint32_t>(options.channels.size() / given.corners.size()),
                                     doubles(options.channels, storage),
                                     snapped.value().points,
                                     given.triangles ? std::span<const std::uint32_t>() : given.starts,
                                     given.corners,
                                     lattice,
                                     options.channel_tolerance};
  const auto bent = booleans::add_channels(input, mesh.points, mesh.triangles, mesh.sources, origin);
  if (!bent) return {};
  return Error{
      ErrorCode::bad_number,
      "the channels of face " + std::to_string(*bent) + " are no affine function of the position: give it as triangles",
      {},
      "face " + std::to_string(*bent)};
}

/// What the triangles of a mesh carry. Errors: those of `add_channels`.
Result<booleans::Labels> labels_of(const Given& given, const grid::ImportedMesh& mesh, const grid::Lattice& lattice,
                                   const ImportOptions& options) {
  booleans::Origin origin = origin_of({options.id, options.name}, given.faces(), options.labels);
  if (options.channels.size() > 0)
    if (const auto added = add_channels(given, mesh, lattice, options, origin); !added) return added.error();

  booleans::Origins origins;
  origins.add(std::make_shared<const booleans::Origin>(std::move(origin)));
  const grid::Sources& sources = mesh.sources;
  if (std::find(sources.begin(), sources.end(), grid::no_source) != sources.end()) origins.add(nullptr);

  booleans::Labels labels;
  labels.origins = std::make_shared<const booleans::Origins>(std::move(origins));
  const auto list = labels.triangles.grow(sources.size());
  std::transform(sources.begin(), sources.end(), list.begin(), [](std::uint32_t source) {
    return source == grid::no_source ? booleans::Provenance(1, 0) : booleans::Provenance(0, source);
  });
  return labels;
}

template <class Import>
Result<Solid> imported(const Given& given, const ImportOptions& options, const Options& run, ImportReport* report,
                       Import&& import) {
  if (report) *report = {};
  if (cancelled(run)) return Error{ErrorCode::cancelled, "the import was cancelled"};
  const auto grid = chosen_grid(given.points, options);
  if (!grid) return grid.error();

  if (run.stage) run.stage("snap, weld, validate");
  if (run.progress) run.progress(0);
  const auto cures = cures_of(options.repair);
  if (!cures) return cures.error();
  grid::Curing curing{cures.value(), wants_labels(options)};
  auto mesh = import(Access::lattice(grid.value()), curing);
  if (report && mesh) *report = report_of(mesh.value());
  if (report) {
    report->findings = std::move(curing.findings);
    report->repairs = std::move(curing.repairs);
  }
  if (!mesh) return mesh.error();

  booleans::Body body;
  if (curing.wants_sources) {
    auto labels = labels_of(given, mesh.value(), Access::lattice(grid.value()), options);
    if (!labels) return labels.error();
    body.labels = std::move(labels).value();
  }
  body.grid_points = std::move(mesh.value().points);
  body.triangles = std::move(mesh.value().triangles);
  body.is_proved = options.trust == Trust::nothing;
  const bool is_empty = body.triangles.empty();
  if (!is_empty && options.trust == Trust::nothing) {
    auto proved = resolved(body, grid.value(), step_of(run, 0.1, 0.95), report);
    if (!proved) return proved.error();
    body = std::move(proved).value();
  }

  Solid solid = is_empty ? Solid::empty(grid.value()) : Access::solid(grid.value(), std::move(body));
  if (report && solid.is_empty()) report->empty_on = "step " + grid.value().step();
  return solid;
}

Result<void> check_limits(std::size_t vertices, std::size_t faces, const Limits& limits) {
  if (vertices > limits.vertices)
    return io::too_large("the mesh of " + std::to_string(vertices) + " vertices has more", "vertices", limits.vertices);
  if (faces > limits.faces)
    return io::too_large("the mesh of " + std::to_string(faces) + " faces has more", "faces", limits.faces);
  return {};
}

/// What all doors for meshes share; `import` makes an ImportedMesh on a lattice.
template <class Import>
Result<Solid> import_to_end(const Given& given, const ImportOptions& options, ImportReport* report, Import&& import) {
  const auto limits = check_limits(given.points.size() / 3, given.faces(), options.limits);
  if (!limits) return limits.error();
  if (const auto checked = check_labels(given, options); !checked) return checked.error();
  return run_to_end(options.run, [&](const Options& run) {
    return with_threads(run.threads, [&] { return imported(given, options, run, report, import); });
  });
}

/// The first point that no grid can hold, as the place of an error.
std::string far_point(std::span<const std::span<const double>> meshes) {
  for (const auto points : meshes)
    for (std::size_t i = 0; i + 2 < points.size(); i += 3)
      for (std::size_t k = 0; k < 3; ++k)
        if (std::isfinite(points[i + k]) && std::fabs(points[i + k]) > 0x1p1020)
          return "vertex " + std::to_string(i / 3) + " " + grid::describe_point(&points[i]);
  return {};
}

}  // namespace

Notice notice_of_dropped_shells(std::uint64_t count) {
  return {count, std::to_string(count) + (count == 1 ? " shell is inside out and bounds nothing: dropped"
                                                     : " shells are inside out and bound nothing: dropped")};
}

Box mesh_box(std::span<const std::span<const double>> meshes) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  for (const auto points : meshes)
    for (std::size_t i = 0; i + 2 < points.size(); i += 3)
      for (std::size_t k = 0; k < 3; ++k) {
        if (!std::isfinite(points[i + k])) continue;
        low[k] = std::min(low[k], points[i + k]);
        high[k] = std::max(high[k], points[i + k]);
      }
  for (std::size_t k = 0; k < 3; ++k)
    if (low[k] > high[k]) low[k] = high[k] = 0;
  return {low, high};
}

Result<Grid> fitting_grid(std::span<const std::span<const double>> meshes) {
  const auto [low, high] = mesh_box(meshes);
  auto grid = Grid::fitting(low, high);
  if (grid) return grid;
  Error error = grid.error();
  error.where = far_point(meshes);
  return error;
}

namespace {

/// The indices without their sign: what is negative becomes 2^31 or more, and so names nothing.
std::span<const std::uint32_t> unsigned_indices(const Indices& indices) {
  if (const auto* plain = std::get_if<std::span<const std::uint32_t>>(&indices.values())) return *plain;
  const auto values = std::get<std::span<const std::int32_t>>(indices.values());
  // The language allows to read an object as the unsigned type that corresponds to its own.
  return {reinterpret_cast<const std::uint32_t*>(values.data()), values.size()};
}

/// Errors: "bad-index" where one is negative. `what` names the array's entries.
Result<void> check_signs(const Indices& indices, const std::string& what) {
  const auto* values = std::get_if<std::span<const std::int32_t>>(&indices.values());
  if (values == nullptr) return {};
  const auto at = std::find_if(values->begin(), values->end(), [](std::int32_t v) { return v < 0; });
  if (at == values->end()) return {};

  const std::string place = what + " " + std::to_string(at - values->begin());
  return Error{ErrorCode::bad_index, place + " is the negative number " + std::to_string(*at), {}, place};
}

}  // namespace

Result<Solid> Solid::from_triangles(Coordinates points, Indices triangles, const ImportOptions& options,
                                    ImportReport* report) {
  if (const auto checked = check_signs(triangles, "corner"); !checked) return checked.error();
  std::vector<double> storage;
  const auto coordinates = doubles(points, storage);
  const auto corners = unsigned_indices(triangles);

  return import_to_end({coordinates, {}, corners, true}, options, report,
                       [&](const grid::Lattice& lattice, grid::Curing& curing) {
                         return grid::import_triangles(coordinates, corners, lattice, grid::Facing::out, &curing);
                       });
}

Result<Solid> Solid::from_triangles(Coordinates points, Indices triangles, const Grid& grid) {
  ImportOptions options;
  options.grid = grid;
  return from_triangles(points, triangles, options);
}

Result<Solid> Solid::from_polygons(Coordinates points, Indices starts, Indices corners, const ImportOptions& options,
                                   ImportReport* report) {
  if (const auto checked = check_signs(starts, "start"); !checked) return checked.error();
  if (const auto checked = check_signs(corners, "corner"); !checked) return checked.error();
  std::vector<double> storage;
  const auto coordinates = doubles(points, storage);
  const auto first = unsigned_indices(starts), all = unsigned_indices(corners);

  return import_to_end({coordinates, first, all, false}, options, report,
                       [&](const grid::Lattice& lattice, grid::Curing& curing) {
                         return grid::import_polygons(coordinates, first, all, lattice, &curing);
                       });
}

Result<Diagnosis> diagnose(Coordinates points, Indices starts, Indices corners, const ImportOptions& options) {
  ImportReport report;
  const auto solid = Solid::from_polygons(points, starts, corners, options, &report);
  if (!solid && solid.error().code != ErrorCode::open_boundary && solid.error().code != ErrorCode::inside_out)
    return solid.error();
  return Diagnosis{std::move(report.findings)};
}

}  // namespace quoin
