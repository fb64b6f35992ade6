#include <algorithm>
#include <cassert>
#include <cmath>

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

/// The grid of all sources together.
Result<Grid> common_grid(const std::vector<Source>& sources) {
  std::vector<Solid> exact;
  for (const Source& source : sources)
    if (source.exact) exact.push_back(*source.exact);
  if (!exact.empty()) return finest_grid(exact);

  std::vector<std::span<const double>> meshes;
  for (const Source& source : sources) meshes.emplace_back(source.mesh.points);
  return fitting_grid_of(meshes, [&](const Error& error, std::size_t i) { return in_file(error, sources[i].name); });
}

/// One source on the common grid.
Result<Solid> built(const Source& source, const ImportOptions& options, ImportReport& report) {
  if (source.exact)
    return run_to_end(options.run, [&](const Options&) { return source.exact->on_grid(*options.grid); });

  const PolygonMesh& mesh = source.mesh;
  return Solid::from_polygons(mesh.points, mesh.starts, mesh.corners, options, &report);
}

Result<std::vector<Solid>> built(std::vector<Source> sources, const ImportOptions& options, const Options& run,
                                 std::vector<ImportReport>* reports) {
  if (reports) reports->assign(sources.size(), {});
  ImportOptions each = options;
  if (!each.grid) {
    const auto grid = common_grid(sources);
    if (!grid) return grid.error();
    each.grid = grid.value();
  }

  std::vector<Solid> solids;
  solids.reserve(sources.size());
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto count = static_cast<double>(sources.size());
    each.run = step_of(run, static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
    ImportReport report;
    auto solid = built(sources[i], each, report);
    if (!solid) return in_file(solid.error(), sources[i].name);
    solids.push_back(std::move(solid).value());
    if (reports) (*reports)[i] = report;
    sources[i] = {};  // large arrays are not kept longer than needed
  }
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

Result<Source> read_source(const std::string& path, std::optional<Format> format, Trust trust, const Limits& limits) {
  const auto bytes = io::read_file(path, limits);
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
    auto source = read_source(path, std::nullopt, options.trust, options.limits);
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

Result<Model> Model::read(const std::string& path, std::vector<MeshImport>* imports, const ModelReadOptions& options) {
  if (imports) imports->clear();
  const auto text = io::read_file(path, options.limits);
  if (!text) return in_file(text.error(), path);
  const auto slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, std::max<std::size_t>(slash, 1));
  auto model = from_json(text.value(), folder, imports, options);
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
