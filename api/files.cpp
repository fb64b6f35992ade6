#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "api/access.h"
#include "api/common_grid.h"
#include "api/evaluate.h"
#include "api/import.h"
#include "api/run.h"
#include "io/formats.h"
#include "io/mesh.h"

namespace quoin {
namespace {

Error in_file(Error error, const std::string& file) {
  error.file = file;
  return error;
}

Result<Source> parsed(const std::string& path, std::string_view bytes, std::optional<Format> hint, Trust trust) {
  const auto named = hint ? Result<Format>(*hint) : format_of(path);
  const auto format = io::format_to_read(bytes, named ? std::optional(named.value()) : std::nullopt);
  if (!format) return named.error();

  Source source;
  source.name = path;
  if (info_of(*format).is_exact) {
    auto solid = Solid::from_quoin(io::without_byte_order_mark(bytes), trust);
    if (!solid) return solid.error();
    source.exact = std::move(solid).value();
    return source;
  }

  auto mesh = io::read_mesh(bytes, *format);
  if (!mesh) return mesh.error();
  source.notices = std::move(mesh.value().notices);
  source.mesh = {std::move(mesh.value().points), std::move(mesh.value().starts), std::move(mesh.value().corners)};
  return source;
}

/// Whether the arrays are a mesh that the format can hold.
Result<void> check_writable(const Mesh& mesh, Format format) {
  if (format == Format::quoin)
    return Error{ErrorCode::unknown_format, "a .quoin file holds an exact solid, not a triangle mesh"};
  if (mesh.points.size() % 3 != 0)
    return Error{ErrorCode::bad_index,
                 "the number of coordinates is not a multiple of 3",
                 {},
                 "vertex " + std::to_string(mesh.points.size() / 3)};
  if (mesh.triangles.size() % 3 != 0)
    return Error{ErrorCode::bad_index,
                 "the number of triangle corners is not a multiple of 3",
                 {},
                 "face " + std::to_string(mesh.triangles.size() / 3)};

  const std::size_t count = mesh.points.size() / 3;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (mesh.triangles[i] >= count)
      return Error{
          ErrorCode::bad_index,
          "a triangle names vertex " + std::to_string(mesh.triangles[i]) + ", but there are " + std::to_string(count),
          {},
          "face " + std::to_string(i / 3)};

  const bool narrow = format == Format::stl;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    if (!std::isfinite(narrow ? static_cast<float>(mesh.points[i]) : mesh.points[i]))
      return Error{ErrorCode::non_finite,
                   std::string("a coordinate is not finite") + (narrow ? " in float32" : ""),
                   {},
                   "vertex " + std::to_string(i / 3)};
  return {};
}

std::vector<std::span<const double>> meshes_of(const std::vector<Source>& sources) {
  std::vector<std::span<const double>> meshes;
  for (const Source& source : sources) meshes.emplace_back(source.mesh.points);
  return meshes;
}

/// The grid that fits all meshes of the sources together.
Result<Grid> grid_around_meshes(const std::vector<Source>& sources) {
  return fitting_grid_of(meshes_of(sources),
                         [&](const Error& error, std::size_t i) { return in_file(error, sources[i].name); });
}

/// Whether all meshes lie in the world of a grid. Points that are not finite are left to import.
bool hold_meshes(const Grid& grid, const std::vector<Source>& sources) {
  const auto meshes = meshes_of(sources);
  if (std::all_of(meshes.begin(), meshes.end(), [](const auto& points) { return points.empty(); })) return true;

  grid::ModelBox box;
  for (const auto& [x, y, z] : mesh_box(meshes))
    box.add(std::array{exact::to_rational(x), exact::to_rational(y), exact::to_rational(z)});
  return in_world(Access::lattice(grid), box);
}

/// Adds what going to the common grid did to a source.
void add_rounding(ImportReport& report, const Rounded& rounded) {
  report.max_snap = exact::double_above(exact::to_rational(report.max_snap) + rounded.displacement);
  report.resolved_crossings += rounded.resolved_crossings;
  if (rounded.solid.is_empty()) report.empty_on = "step " + rounded.solid.grid().step();
}

/// Sources on their way to solids.
class Building {
 public:
  Building(std::vector<Source> sources, const ImportOptions& options, const Options& run)
      : sources_(std::move(sources)), options_(options), run_(run), reports_(sources_.size()) {
    for (const Source& source : sources_) names_.push_back(source.name);
  }
  std::vector<ImportReport>& reports() { return reports_; }

  /// The meshes on a grid, the exact sources too, if that is exact.
  Result<std::vector<Solid>> on(const Grid& grid) {
    return each(grid, [&](std::size_t i) { return sources_[i].exact->on_grid(grid); });
  }

  Result<std::vector<Solid>> on_common_grid() {
    std::vector<std::size_t> exact;
    for (std::size_t i = 0; i < sources_.size(); ++i)
      if (sources_[i].exact) exact.push_back(i);
    if (exact.empty()) {
      const auto grid = grid_around_meshes(sources_);
      return grid ? on(grid.value()) : grid.error();
    }

    std::vector<Solid> solids(sources_.size());
    for (const std::size_t i : exact) solids[i] = *sources_[i].exact;
    const std::vector<Solid> given = solids;
    if (const auto done = unify(solids, exact); !done) return done.error();
    if (const Grid common = solids[exact[0]].grid(); hold_meshes(common, sources_))
      return each(common, [&](std::size_t i) -> Result<Solid> { return solids[i]; });

    // Meshes beyond the world of that grid have one of their own, before all meet.
    reports_.assign(reports_.size(), {});
    const auto grid = grid_around_meshes(sources_);
    if (!grid) return grid.error();
    auto all = each(grid.value(), [&](std::size_t i) -> Result<Solid> { return given[i]; });
    if (!all) return all;
    std::vector<std::size_t> numbers(names_.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    if (const auto done = unify(all.value(), numbers); !done) return done.error();
    return all;
  }

 private:
  /// Some of the solids go to their common grid.
  Result<void> unify(std::vector<Solid>& solids, const std::vector<std::size_t>& numbers) {
    std::vector<Solid> some;
    for (const std::size_t i : numbers) some.push_back(solids[i]);
    const auto done = go_to_common_grid(
        some, run_, [&](Error error, std::size_t n) { return in_file(std::move(error), names_[numbers[n]]); },
        [&](std::size_t n, const Rounded& rounded) { add_rounding(reports_[numbers[n]], rounded); });
    if (!done) return done;
    for (std::size_t n = 0; n < numbers.size(); ++n) solids[numbers[n]] = some[n];
    return {};
  }

  /// Meshes imported on a grid, and what exact(i) makes of an exact source. The sources are used up.
  template <class Exact>
  Result<std::vector<Solid>> each(const Grid& grid, Exact&& exact) {
    std::vector<Solid> solids;
    solids.reserve(sources_.size());
    ImportOptions options = options_;
    options.grid = grid;
    const auto count = static_cast<double>(sources_.size());
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      options.run = step_of(run_, static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
      auto solid = sources_[i].exact ? run_to_end(options.run, [&](const Options&) { return exact(i); })
                                     : imported(sources_[i].mesh, options, reports_[i]);
      auto& notices = reports_[i].notices;
      notices.insert(notices.begin(), sources_[i].notices.begin(), sources_[i].notices.end());
      if (!solid) return in_file(solid.error(), names_[i]);
      solids.push_back(std::move(solid).value());
      sources_[i] = {};  // large arrays are not kept longer than needed
    }
    return solids;
  }

  static Result<Solid> imported(const PolygonMesh& mesh, const ImportOptions& options, ImportReport& report) {
    return Solid::from_polygons(mesh.points, mesh.starts, mesh.corners, options, &report);
  }

  std::vector<Source> sources_;
  const ImportOptions& options_;
  const Options& run_;
  std::vector<std::string> names_;
  std::vector<ImportReport> reports_;
};

Result<std::vector<Solid>> built(std::vector<Source> sources, const ImportOptions& options, const Options& run,
                                 std::vector<ImportReport>* reports) {
  Building building(std::move(sources), options, run);
  auto solids = options.grid ? building.on(*options.grid) : building.on_common_grid();
  if (reports) *reports = std::move(building.reports());
  return solids;
}

}  // namespace

std::span<const FormatInfo> formats() {
  // Never destroyed: static objects may ask when the program ends.
  static const std::vector<FormatInfo>& infos = *[] {
    auto* all = new std::vector<FormatInfo>;
    for (const io::FormatRow& row : io::format_rows()) all->push_back(row.info);
    return all;
  }();
  return infos;
}

const FormatInfo& info_of(Format format) { return io::row_of(format).info; }

std::optional<Format> format_called(std::string_view name) {
  for (const FormatInfo& info : formats())
    if (info.name == name) return info.format;
  return std::nullopt;
}

Result<Format> format_of(std::string_view file_name) { return io::format_of(file_name); }

Result<Source> read_source(const std::string& path, std::optional<Format> format, Trust trust) {
  const auto bytes = io::read_file(path);
  if (!bytes) return in_file(bytes.error(), path);
  auto source = parsed(path, bytes.value(), format, trust);
  if (!source) return in_file(source.error(), path);
  return source;
}

Result<std::vector<Solid>> build(std::vector<Source> sources, const ImportOptions& options,
                                 std::vector<ImportReport>* reports) {
  return run_to_end(options.run, [&](const Options& run) { return built(std::move(sources), options, run, reports); });
}

Result<std::vector<Solid>> read(const std::vector<std::string>& paths, const ImportOptions& options,
                                std::vector<ImportReport>* reports) {
  std::vector<Source> sources;
  for (const std::string& path : paths) {
    auto source = read_source(path, std::nullopt, options.trust);
    if (!source) return source.error();
    sources.push_back(std::move(source).value());
  }
  return build(std::move(sources), options, reports);
}

Result<Solid> read_solid(const std::string& path, const ImportOptions& options, ImportReport* report) {
  std::vector<ImportReport> reports;
  auto solids = read({path}, options, &reports);
  if (!solids) return solids.error();
  if (report) *report = reports[0];
  return std::move(solids.value()[0]);
}

Result<Model> Model::read(const std::string& path, std::vector<MeshImport>* imports) {
  if (imports) imports->clear();
  const auto text = io::read_file(path);
  if (!text) return in_file(text.error(), path);
  const auto slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, std::max<std::size_t>(slash, 1));
  auto model = from_json(text.value(), folder, imports);
  // The mesh beside it has its own name.
  if (!model && model.error().file.empty()) return in_file(model.error(), path);
  return model;
}

Result<std::string> to_bytes(const Mesh& mesh, Format format) {
  if (const auto checked = check_writable(mesh, format); !checked) return checked.error();
  return io::write_mesh(mesh.points, mesh.triangles, format);
}

Result<void> write_bytes(const std::string& path, std::string_view bytes, const Cancel* cancel) {
  const auto written = io::write_file(path, bytes, cancel);
  if (!written) return in_file(written.error(), path);
  return {};
}

Result<void> Solid::write(const std::string& path, const ExportOptions& options) const {
  const auto format = format_of(path);
  if (!format) return format.error();
  const FormatInfo& info = info_of(format.value());
  if (info.is_exact) return write_bytes(path, to_quoin(), options.run.cancel);

  ExportOptions rounding = options;
  rounding.float32 = options.float32 || info.is_float32;
  const auto mesh = to_triangles(rounding);
  if (!mesh) return in_file(mesh.error(), path);
  const auto bytes = to_bytes(mesh.value(), format.value());
  if (!bytes) return in_file(bytes.error(), path);
  return write_bytes(path, bytes.value(), options.run.cancel);
}

}  // namespace quoin
