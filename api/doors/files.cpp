#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numeric>

#include "api/access.h"
#include "api/doors/common_grid.h"
#include "api/doors/import.h"
#include "api/doors/placed.h"
#include "api/doors/stated_unit.h"
#include "api/evaluate.h"
#include "api/run.h"
#include "io/formats.h"
#include "io/mesh.h"

namespace quoin {
namespace {

Error in_file(Error error, const std::string& file) {
  error.file = file;
  return error;
}

/// A path, and what stands behind "#": the number or name of an object.
struct ObjectPath {
  std::string file;
  std::optional<std::string> object = {};
};

ObjectPath parted(const std::string& path) {
  const std::size_t at = path.rfind('#');
  if (at == std::string::npos || format_of(path)) return {path};
  const std::string file = path.substr(0, at);
  if (file != "-" && !format_of(file)) return {path};
  return {file, path.substr(at + 1)};
}

/// Reads a file beside another one: a name without a folder, so that no file says what is read elsewhere.
io::Beside beside(const std::string& path, const Limits& limits) {
  return [path, limits](const std::string& name) -> Result<std::string> {
    const std::size_t slash = path.rfind('/');
    const bool is_plain = !name.empty() && name != "-" && name != "." && name != ".." &&
                          name.find_first_of(std::string("/\\\0", 3)) == std::string::npos;
    if (path == "-" || !is_plain)
      return Error{ErrorCode::missing_file, "the file names another one that is not beside it", {}, name};
    auto bytes = io::read_file((slash == std::string::npos ? std::string() : path.substr(0, slash + 1)) + name, limits);
    if (bytes) return bytes;
    Error error = bytes.error();
    error.where = name;
    return error;
  };
}

/// The meshes of an object where they are placed, in the unit that is asked for.
Result<Source> source_of(const io::Scene& scene, std::size_t number, std::optional<Unit> unit) {
  const io::Object& object = scene.objects[number];
  rounding::AffineMap conversion;
  if (unit && scene.unit != Unit::none)
    for (std::size_t k = 0; k < 3; ++k) conversion.linear[k][k] = millimeters(scene.unit) / millimeters(*unit);

  Source source;
  source.unit = unit ? *unit : scene.unit;
  source.objects = {{number + 1, object.name, 0}};
  const std::string where = "object " + std::to_string(number + 1);
  for (const io::PlacedMesh& one : object.meshes) {
    const auto map = map_of(one.placing);
    auto mesh = map ? placed_mesh(scene.meshes[one.mesh], composed(map.value(), conversion)) : map.error();
    if (!mesh) {
      Error error = mesh.error();
      error.where = where;
      return error;
    }
    source.objects[0].faces += mesh.value().starts.size() - 1;
    io::PolygonMesh& there = mesh.value();
    source.others.push_back({std::move(there.points), std::move(there.starts), std::move(there.corners)});
  }
  source.mesh = std::move(source.others.front());
  source.others.erase(source.others.begin());
  return source;
}

/// The one object that is asked for: its number from 1, or its name. Errors: "bad-index".
Result<std::size_t> found_object(const io::Scene& scene, const std::string& wanted) {
  const auto& objects = scene.objects;
  const auto named =
      std::find_if(objects.begin(), objects.end(), [&](const io::Object& object) { return object.name == wanted; });
  if (named != objects.end() && !wanted.empty()) return static_cast<std::size_t>(named - objects.begin());

  std::size_t number = 0;
  const auto [end, code] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
  const bool is_number = code == std::errc() && end == wanted.data() + wanted.size();
  if (is_number && number >= 1 && number <= objects.size()) return number - 1;
  return Error{ErrorCode::bad_index,
               "the file has no object \"" + wanted + "\", but " + std::to_string(objects.size()) +
                   (objects.size() == 1 ? " object" : " objects"),
               {},
               "object " + wanted};
}

Result<std::vector<Source>> sources_of(const io::Scene& scene, const std::optional<std::string>& wanted,
                                       std::optional<Unit> unit) {
  std::vector<std::size_t> numbers;
  if (wanted) {
    const auto number = found_object(scene, *wanted);
    if (!number) return number.error();
    if (scene.objects[number.value()].meshes.empty())
      return Error{ErrorCode::no_faces, "the object has no face: it bounds no solid", {}, "object " + *wanted};
    numbers.push_back(number.value());
  } else {
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
      if (!scene.objects[i].meshes.empty()) numbers.push_back(i);
  }

  std::vector<Source> sources;
  for (const std::size_t number : numbers) {
    auto source = source_of(scene, number, unit);
    if (!source) return source.error();
    sources.push_back(std::move(source).value());
  }
  auto& notices = sources[0].notices;
  for (const io::PolygonMesh& mesh : scene.meshes)
    notices.insert(notices.end(), mesh.notices.begin(), mesh.notices.end());
  notices.insert(notices.end(), scene.notices.begin(), scene.notices.end());
  return sources;
}

Result<std::vector<Source>> parsed(const ObjectPath& path, std::string_view bytes, std::optional<Format> hint,
                                   Trust trust, std::optional<Unit> unit, const Limits& limits) {
  const auto named = hint ? Result<Format>(*hint) : format_of(path.file);
  const auto format = io::format_to_read(bytes, named ? std::optional(named.value()) : std::nullopt);
  if (!format) return named.error();

  if (!info_of(*format).is_exact) {
    const auto scene = io::read_scene(bytes, *format, beside(path.file, limits));
    return scene ? sources_of(scene.value(), path.object, unit) : scene.error();
  }
  if (path.object && *path.object != "1")
    return Error{ErrorCode::bad_index, "the file has one object", {}, "object " + *path.object};
  auto solid = Solid::from_quoin(io::without_byte_order_mark(bytes), trust);
  if (!solid) return solid.error();
  Source source;
  source.exact = std::move(solid).value();
  source.objects = {FileObject{}};
  return std::vector<Source>{std::move(source)};
}

/// All of them as one.
Source united(std::vector<Source> sources) {
  Source all = std::move(sources.front());
  for (auto source = sources.begin() + 1; source != sources.end(); ++source) {
    all.others.push_back(std::move(source->mesh));
    std::move(source->others.begin(), source->others.end(), std::back_inserter(all.others));
    all.objects.push_back(std::move(source->objects[0]));
  }
  return all;
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

  if (!io::fits(count, mesh.triangles.size() / 3, format))
    return Error{
        ErrorCode::out_of_range,
        "the mesh may need more than the " + std::to_string(io::max_bytes(format)) + " bytes that the format holds",
        {},
        "vertex " + std::to_string(count)};

  const bool narrow = info_of(format).is_float32;
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
  for (const Source& source : sources) {
    meshes.emplace_back(source.mesh.points);
    for (const PolygonMesh& other : source.others) meshes.emplace_back(other.points);
  }
  return meshes;
}

/// The grid that fits all meshes of the sources together.
Result<Grid> grid_around_meshes(const std::vector<Source>& sources) {
  std::vector<const Source*> owners;
  for (const Source& source : sources) owners.resize(owners.size() + 1 + source.others.size(), &source);
  return fitting_grid_of(meshes_of(sources),
                         [&](const Error& error, std::size_t i) { return in_file(error, owners[i]->name); });
}

/// What import did to several meshes of one source. Of dropped shells one notice says all, behind the others.
void add(ImportReport& all, const ImportReport& one) {
  const auto end_of_others = [](const ImportReport& r) { return r.notices.end() - (r.dropped_shells > 0 ? 1 : 0); };
  all.notices.erase(end_of_others(all), all.notices.end());
  all.notices.insert(all.notices.end(), one.notices.begin(), end_of_others(one));

  all.max_snap = std::max(all.max_snap, one.max_snap);
  all.merged_points += one.merged_points;
  all.zero_area_triangles += one.zero_area_triangles;
  all.nonplanar_polygons += one.nonplanar_polygons;
  all.resolved_crossings += one.resolved_crossings;
  all.dropped_shells += one.dropped_shells;
  if (all.dropped_where.empty()) all.dropped_where = one.dropped_where;
  all.sealed_t_junctions += one.sealed_t_junctions;
  all.findings.insert(all.findings.end(), one.findings.begin(), one.findings.end());
  all.repairs.insert(all.repairs.end(), one.repairs.begin(), one.repairs.end());
  if (all.dropped_shells > 0) all.notices.push_back(notice_of_dropped_shells(all.dropped_shells));
}

/// The only mesh of a source on a grid, or the union of all.
Result<Solid> imported(const Source& source, const ImportOptions& options, ImportReport& report) {
  const std::size_t count = 1 + source.others.size();
  // The union is as much work as all imports together.
  const double share = count == 1 ? 1 : 0.5 / static_cast<double>(count);
  std::vector<Solid> solids;
  for (std::size_t i = 0; i < count; ++i) {
    const PolygonMesh& mesh = i == 0 ? source.mesh : source.others[i - 1];
    ImportOptions each = options;
    each.run = step_of(options.run, share * static_cast<double>(i), share * static_cast<double>(i + 1));
    ImportReport one;
    auto solid = Solid::from_polygons(mesh.points, mesh.starts, mesh.corners, each, &one);
    if (count == 1) {
      report = one;
      return solid;
    }
    add(report, one);
    if (!solid) {
      Error error = solid.error();
      error.where = "mesh " + std::to_string(i + 1) + (error.where.empty() ? "" : ", " + error.where);
      return error;
    }
    solids.push_back(std::move(solid).value());
  }

  auto all = unite(solids, step_of(options.run, 0.5, 1));
  if (all && all.value().is_empty()) report.empty_on = "step " + options.grid->step();
  return all;
}

/// Errors: "mixed-units" where two sources state different units.
Result<void> check_units(const std::vector<Source>& sources) {
  StatedUnit stated;
  for (const Source& source : sources)
    if (auto added = stated.add(source.unit, source.name); !added) return added;
  return {};
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
                                     : imported(sources_[i], options, reports_[i]);
      auto& notices = reports_[i].notices;
      notices.insert(notices.begin(), sources_[i].notices.begin(), sources_[i].notices.end());
      if (!solid) return in_file(solid.error(), names_[i]);
      solids.push_back(std::move(solid).value());
      sources_[i] = {};  // large arrays are not kept longer than needed
    }
    return solids;
  }

  std::vector<Source> sources_;
  const ImportOptions& options_;
  const Options& run_;
  std::vector<std::string> names_;
  std::vector<ImportReport> reports_;
};

Result<std::vector<Solid>> built(std::vector<Source> sources, const ImportOptions& options, const Options& run,
                                 std::vector<ImportReport>* reports) {
  if (const auto checked = check_units(sources); !checked) return checked.error();
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

std::string file_of(const std::string& path) { return parted(path).file; }

Result<std::vector<Source>> read_objects(const std::string& path, std::optional<Format> format, Trust trust,
                                         std::optional<Unit> unit, const Limits& limits) {
  const ObjectPath parts = parted(path);
  const auto bytes = io::read_file(parts.file, limits);
  if (!bytes) return in_file(bytes.error(), path);
  auto sources = parsed(parts, bytes.value(), format, trust, unit, limits);
  if (!sources) return in_file(sources.error(), path);
  for (Source& source : sources.value()) source.name = path;
  return sources;
}

Result<Source> read_source(const std::string& path, std::optional<Format> format, Trust trust, std::optional<Unit> unit,
                           const Limits& limits) {
  auto sources = read_objects(path, format, trust, unit, limits);
  if (!sources) return sources.error();
  return united(std::move(sources).value());
}

Result<std::vector<Solid>> build(std::vector<Source> sources, const ImportOptions& options,
                                 std::vector<ImportReport>* reports) {
  return run_to_end(options.run, [&](const Options& run) { return built(std::move(sources), options, run, reports); });
}

Result<std::vector<Solid>> read(const std::vector<std::string>& paths, const ImportOptions& options,
                                std::vector<ImportReport>* reports) {
  std::vector<Source> sources;
  for (const std::string& path : paths) {
    auto source = read_source(path, std::nullopt, options.trust, {}, options.limits);
    if (!source) return source.error();
    sources.push_back(std::move(source).value());
  }
  return build(std::move(sources), options, reports);
}

Result<Solid> read_solid(const std::string& path, const ImportOptions& options, ImportReport* report) {
  std::vector<ImportReport> reports(1);
  auto solids = read({path}, options, &reports);
  if (report) *report = reports[0];
  if (!solids) return solids.error();
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

Result<std::string> to_bytes(const Mesh& mesh, Format format, Unit unit) {
  if (const auto checked = check_writable(mesh, format); !checked) return checked.error();
  return io::write_mesh(mesh.points, mesh.triangles, format, unit);
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
