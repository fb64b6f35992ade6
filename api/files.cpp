#include <algorithm>
#include <cassert>

#include "api/access.h"
#include "api/evaluate.h"
#include "api/import.h"
#include "api/run.h"
#include "io/formats.h"
#include "io/mesh.h"
#include "io/quoin.h"

namespace quoin {
namespace {

Error in_file(Error error, const std::string& file) {
  error.file = file;
  return error;
}

/// Precondition: not Format::quoin.
io::Format mesh_format(Format format) {
  switch (format) {
    case Format::stl:
      return io::Format::stl;
    case Format::stl_ascii:
      return io::Format::stl_ascii;
    case Format::obj:
      return io::Format::obj;
    case Format::off:
      return io::Format::off;
    case Format::ply:
      return io::Format::ply;
    case Format::ply_ascii:
      return io::Format::ply_ascii;
    case Format::quoin:
      break;
  }
  assert(false);
  return io::Format::off;
}

std::string_view without_byte_order_mark(std::string_view bytes) {
  return bytes.starts_with("\xEF\xBB\xBF") ? bytes.substr(3) : bytes;
}

/// The format that the bytes show by themselves; nothing where only a name can tell.
std::optional<Format> format_by_content(std::string_view bytes) {
  const std::string_view text = without_byte_order_mark(bytes);
  if (io::looks_like_quoin(text)) return Format::quoin;
  if (io::looks_like_ply(text)) return Format::ply;
  if (io::looks_like_off(text)) return Format::off;
  if (io::is_exact_binary_stl(bytes)) return Format::stl;
  if (io::looks_like_ascii_stl(text)) return Format::stl_ascii;
  return std::nullopt;
}

/// An STL hint lets a binary file begin with any word; other hints give way to what the content shows.
Result<Format> format_to_read(const std::string& path, std::string_view bytes, std::optional<Format> format) {
  const auto named = format ? Result<Format>(*format) : format_of(path);
  const bool stl = named && (named.value() == Format::stl || named.value() == Format::stl_ascii);
  if (stl && io::is_exact_binary_stl(bytes)) return Format::stl;
  if (const auto shown = format_by_content(bytes)) {
    // Lengths can agree by chance: a name weighs more than that.
    if (*shown != Format::stl || !named) return *shown;
  }
  return named;
}

Result<Source> parsed(const std::string& path, std::string_view bytes, Format format, Trust trust) {
  Source source;
  source.name = path;
  if (format == Format::quoin) {
    auto solid = Solid::from_quoin(without_byte_order_mark(bytes), trust);
    if (!solid) return solid.error();
    source.exact = std::move(solid).value();
    return source;
  }
  auto mesh = io::read_mesh(bytes, mesh_format(format));
  if (!mesh) return mesh.error();
  source.mesh = {std::move(mesh.value().points), std::move(mesh.value().starts), std::move(mesh.value().corners)};
  return source;
}

/// The grid of all sources together.
Result<Grid> common_grid(const std::vector<Source>& sources) {
  const Source* finest = nullptr;
  for (const Source& source : sources)
    if (source.exact &&
        (finest == nullptr || Access::lattice(*source.exact).step < Access::lattice(*finest->exact).step))
      finest = &source;
  if (finest) return finest->exact->grid();
  std::vector<std::span<const double>> meshes;
  for (const Source& source : sources) meshes.emplace_back(source.mesh.points);
  return fitting_grid(meshes);
}

/// One source on the common grid.
Result<Solid> built(const Source& source, const ImportOptions& options, ImportReport& report) {
  if (source.exact) return source.exact->on_grid(*options.grid);
  const PolygonMesh& mesh = source.mesh;
  return Solid::from_polygons(mesh.points, mesh.starts, mesh.corners, options, &report);
}

}  // namespace

Result<Format> format_of(std::string_view file_name) {
  std::string ending(file_name.substr(file_name.size() - std::min<std::size_t>(file_name.size(), 6)));
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  constexpr std::array<std::pair<std::string_view, Format>, 5> known{{{".stl", Format::stl},
                                                                      {".obj", Format::obj},
                                                                      {".off", Format::off},
                                                                      {".ply", Format::ply},
                                                                      {".quoin", Format::quoin}}};
  for (const auto& [extension, format] : known)
    if (ending.ends_with(extension)) return format;
  return Error{"unknown-format", "the file name does not end with .stl, .obj, .off, .ply or .quoin",
               std::string(file_name)};
}

Result<Source> read_source(const std::string& path, std::optional<Format> format, Trust trust) {
  const auto bytes = io::read_file(path);
  if (!bytes) return in_file(bytes.error(), path);
  const auto found = format_to_read(path, bytes.value(), format);
  if (!found) return in_file(found.error(), path);
  auto source = parsed(path, bytes.value(), found.value(), trust);
  if (!source) return in_file(source.error(), path);
  return source;
}

Result<std::vector<Solid>> build(std::vector<Source> sources, const ImportOptions& options,
                                 std::vector<ImportReport>* reports) {
  if (reports) reports->assign(sources.size(), {});
  ImportOptions each = options;
  if (!each.grid) {
    const auto grid = common_grid(sources);
    if (!grid) return sources.size() == 1 ? in_file(grid.error(), sources[0].name) : grid.error();
    each.grid = grid.value();
  }
  std::vector<Solid> solids;
  solids.reserve(sources.size());
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto count = static_cast<double>(sources.size());
    each.run = step_of(options.run, static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
    ImportReport report;
    auto solid = built(sources[i], each, report);
    if (!solid) return in_file(solid.error(), sources[i].name);
    solids.push_back(std::move(solid).value());
    if (reports) (*reports)[i] = report;
    sources[i] = {};  // large arrays are not kept longer than needed
  }
  return solids;
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

Result<Model> Model::read(const std::string& path) {
  const auto text = io::read_file(path);
  if (!text) return in_file(text.error(), path);
  const auto slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, std::max<std::size_t>(slash, 1));
  auto model = from_json(text.value(), folder);
  // The mesh beside it has its own name.
  if (!model && model.error().file.empty()) return in_file(model.error(), path);
  return model;
}

std::string to_bytes(const Mesh& mesh, Format format) {
  return io::write_mesh(mesh.points, mesh.triangles, mesh_format(format));
}

Result<void> write_bytes(const std::string& path, std::string_view bytes) {
  const auto written = io::write_file(path, bytes);
  if (!written) return in_file(written.error(), path);
  return {};
}

void abandon_temporary_files() { io::abandon_temporary_files(); }

Result<void> Solid::write(const std::string& path, const ExportOptions& options) const {
  const auto format = format_of(path);
  if (!format) return format.error();
  if (format.value() == Format::quoin) return write_bytes(path, to_quoin());
  ExportOptions rounding = options;
  rounding.float32 = options.float32 || format.value() == Format::stl;
  const auto mesh = to_triangles(rounding);
  if (!mesh) return in_file(mesh.error(), path);
  return write_bytes(path, to_bytes(mesh.value(), format.value()));
}

}  // namespace quoin
