#include "api/import.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "api/access.h"
#include "api/run.h"
#include "booleans/boolean.h"
#include "grid/import.h"

namespace quoin {
namespace {

bool cancelled(const Options& options) { return options.cancel != nullptr && options.cancel->load(); }

/// What all doors for meshes share; `import` makes an ImportedMesh on a lattice.
template <class Import>
Result<Solid> imported(std::span<const double> points, const ImportOptions& options, ImportReport* report,
                       Import&& import) {
  if (report) *report = {};
  if (cancelled(options.run)) return Error{"cancelled", "the import was cancelled"};
  Grid grid;
  if (options.grid) {
    grid = *options.grid;
  } else {
    const auto fitting = fitting_grid(std::array{points});
    if (!fitting) return fitting.error();
    grid = fitting.value();
  }
  if (options.run.stage) options.run.stage("snap, weld, validate");
  auto result = import(Access::lattice(grid));
  if (!result) return result.error();
  grid::ImportedMesh& mesh = result.value();
  if (report) {
    report->max_snap = mesh.max_snap;
    report->merged_points = mesh.merged_points;
    report->zero_area_triangles = mesh.zero_area_triangles;
    report->nonplanar_polygons = mesh.nonplanar_polygons;
  }
  if (mesh.triangles.empty()) return Solid::empty(grid);
  booleans::Body body;
  body.grid_points = std::move(mesh.points);
  body.triangles = std::move(mesh.triangles);
  if (options.trust == Trust::embedded) return Access::solid(grid, std::move(body));
  std::uint64_t crossings = 0;
  auto resolved = booleans::resolve(std::move(body), crossings, run_of(options.run));
  if (!resolved) return resolved.error();
  if (report) report->resolved_crossings = crossings;
  return Access::solid(grid, std::move(resolved).value());
}

}  // namespace

Result<Grid> fitting_grid(std::span<const std::span<const double>> meshes) {
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
  return Grid::fitting(low, high);
}

Result<Solid> Solid::from_triangles(std::span<const double> points, std::span<const std::uint32_t> triangles,
                                    const ImportOptions& options, ImportReport* report) {
  return with_threads(options.run.threads, [&] {
    return imported(points, options, report,
                    [&](const grid::Lattice& lattice) { return grid::import_triangles(points, triangles, lattice); });
  });
}

Result<Solid> Solid::from_triangles(std::span<const double> points, std::span<const std::uint32_t> triangles,
                                    const Grid& grid) {
  ImportOptions options;
  options.grid = grid;
  return from_triangles(points, triangles, options);
}

Result<Solid> Solid::from_polygons(std::span<const double> points, std::span<const std::uint32_t> starts,
                                   std::span<const std::uint32_t> corners, const ImportOptions& options,
                                   ImportReport* report) {
  return with_threads(options.run.threads, [&] {
    return imported(points, options, report, [&](const grid::Lattice& lattice) {
      return grid::import_polygons(points, starts, corners, lattice);
    });
  });
}

}  // namespace quoin
