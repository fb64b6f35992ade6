#include "commands.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

#include "ending.h"
#include "output.h"
#include "signals.h"

namespace quoin::cli {
namespace {

/// What all commands share while they run.
struct Session {
  const Arguments& arguments;
  StageTimes times = {};
  ProgressLine progress;

  explicit Session(const Arguments& a) : arguments(a), progress(!a.quiet && !a.json) {}

  Options options(const char* what) {
    return {.progress = progress.show(what),
            .cancel = &cancel_flag(),
            .threads = arguments.threads,
            .grid_rule = arguments.grid_rule};
  }
};

/// The operands on one grid, and what import did to each file; of a model the files that it names.
struct Operands {
  std::vector<Solid> solids;
  std::vector<MeshImport> imports;
  std::vector<Source> contents;  // of each file what it states, without its meshes; none of a model
  /// How far the operation moved anything.
  double operation_snap = 0;

  /// That of the numbers, which are all in one.
  Unit unit(const Arguments& a) const {
    if (a.unit) return *a.unit;
    for (const MeshImport& import : imports)
      if (import.unit != Unit::none) return import.unit;
    return Unit::none;
  }
  double max_snap() const {
    double largest = operation_snap;
    for (const auto& import : imports) largest = std::max(largest, import.report.max_snap);
    return largest;
  }
};

/// What a command makes of its operands.
struct Computed {
  std::vector<Solid> solids;                // two for split
  std::optional<MotionReport> motion = {};  // of move and eval
  OperationReport operation = {};
};

/// One solid on its way to a file.
struct Output {
  std::string path;
  Solid solid;
  Unit unit = Unit::none;
  Info info = {};
  ExportReport report = {};
  std::optional<SurfaceCounts> surface = {};  // of what was written as triangles
  std::string bytes = {};
};

Error cancelled_error() { return {.code = ErrorCode::cancelled, .message = "interrupted"}; }

/// A stage that ended well just as the signal came counts as interrupted.
template <class T>
Result<T> unless_cancelled(Result<T> result) {
  if (cancel_flag().load()) return cancelled_error();
  return result;
}

/// Runs a stage that polls the cancel flag, in front of the progress line.
template <class Work>
auto polled_stage(Session& session, Stage stage, Work&& work) {
  const PolledStage guard;
  auto result = session.times.measure(stage, work);
  session.progress.clear();
  return unless_cancelled(std::move(result));
}

/// `surface`: what an export of the solid counted; nullptr without one.
Result<Info> measured_info(const Solid& solid, const SurfaceCounts* surface, Volume volume, Session& session) {
  const PolledStage guard;
  Result<Info> info = solid.info(session.options("measuring"), surface, volume);
  session.progress.clear();
  return unless_cancelled(std::move(info));
}

void warn_of_dropped_shells(const std::string& file, const ImportReport& report) {
  const std::uint64_t count = report.dropped_shells;
  if (count == 0) return;
  const std::string what =
      count == 1 ? "1 shell is inside out and bounds" : std::to_string(count) + " shells are inside out and bound";
  print_warning(what + " nothing of the solid: dropped", file, report.dropped_where);
}

/// A mesh has faces, so that one that becomes empty has lost all of them: they have collapsed, or they overlap and
/// cancel.
void warn_of_nothing_left(const std::string& file, const ImportReport& report) {
  if (report.empty_on.empty()) return;
  const std::uint64_t flat = report.zero_area_triangles;
  std::string what = "the mesh bounds nothing on this grid, the solid is empty";
  if (flat > 0)
    what += flat == 1 ? ": 1 triangle has no area after snapping"
                      : ": " + std::to_string(flat) + " triangles have no area after snapping";
  print_warning(what, file, report.empty_on);
}

/// What was passed over and what cures did, a line each; dropped shells have a warning of their own.
void say_notices(const std::string& file, const ImportReport& report) {
  for (std::size_t i = 0; i + (report.dropped_shells > 0 ? 1 : 0) < report.notices.size(); ++i)
    print_notice(report.notices[i].sentence, file);
  for (const Finding& repair : report.repairs)
    print_notice("repaired: " + repair.sentence + " (" + repair.where + ")", file);
}

/// Says what import could not keep.
void warn_of_losses(const Arguments& a, const std::vector<MeshImport>& imports) {
  if (a.quiet) return;
  for (const auto& [file, report, unit] : imports) {
    say_notices(file, report);
    warn_of_dropped_shells(file, report);
    warn_of_nothing_left(file, report);
  }
}

/// Says what rounding a motion could not keep.
void warn_of_losses(const Arguments& a, const MotionReport& report) {
  const std::uint64_t count = report.vanished_primitives;
  if (a.quiet || count == 0) return;
  const std::string what = count == 1 ? "1 primitive is" : std::to_string(count) + " primitives are";
  print_warning(what + " about as thin as a grid step, so that rounding vertices leaves nothing: dropped", a.inputs[0],
                report.vanished_where);
}

Result<Operands> load(Session& session, Trust trust) {
  const Arguments& a = session.arguments;
  std::vector<Source> sources, contents;
  sources.reserve(a.inputs.size());
  for (const auto& path : a.inputs) {
    auto source = session.times.measure(
        Stage::read, [&] { return read_source(path, a.input_format(path), trust, a.unit, a.limits); });
    if (!source) return source.error();
    const Source& read = source.value();
    contents.push_back({.name = path, .unit = read.unit, .objects = read.objects});
    sources.push_back(std::move(source).value());
  }

  std::vector<ImportReport> reports;
  auto solids = polled_stage(session, Stage::build, [&] {
    const ImportOptions options = {
        .grid = a.grid, .trust = trust, .run = session.options("building"), .repair = a.repair, .limits = a.limits};
    return build(std::move(sources), options, &reports);
  });
  if (!solids) {
    for (const ImportReport& report : reports)
      if (!report.findings.empty()) keep_findings(report.findings);
    return solids.error();
  }

  Operands operands{std::move(solids).value(), {}, std::move(contents)};
  for (std::size_t i = 0; i < reports.size(); ++i)
    operands.imports.push_back({a.inputs[i], reports[i], operands.contents[i].unit});
  warn_of_losses(a, operands.imports);
  return operands;
}

Result<Operands> load(Session& session) {
  return load(session, session.arguments.trust ? Trust::embedded : Trust::nothing);
}

/// Evaluates a model; fills in what import did to the files that it names.
Result<Computed> evaluate_model(Session& session, std::vector<MeshImport>& imports) {
  const Arguments& a = session.arguments;
  const std::string& path = a.inputs[0];
  const auto model = session.times.measure(Stage::read, [&] {
    const ModelReadOptions options = {.files = a.any_path ? ModelFiles::anywhere : ModelFiles::below,
                                      .unit = a.unit,
                                      .repair = a.repair,
                                      .limits = a.limits};
    return Model::read(path, &imports, options);
  });
  if (!model) {
    if (!imports.empty()) keep_findings(imports.back().report.findings);
    return model.error();
  }
  warn_of_losses(a, imports);

  Computed computed;
  auto solid = polled_stage(session, Stage::boolean, [&] {
    const ModelOptions options = {.grid = a.grid,
                                  .parameters = a.parameters,
                                  .rounding = a.rounding,
                                  .run = session.options("evaluating"),
                                  .limits = a.limits};
    return evaluate(model.value(), options, &computed.motion.emplace());
  });
  if (!solid) {
    Error error = solid.error();
    if (error.file.empty()) error.file = path;
    return error;
  }
  computed.solids.push_back(std::move(solid).value());
  return computed;
}

/// The Boolean or motion of the command.
Result<Computed> compute(Session& session, const std::vector<Solid>& solids) {
  const Arguments& a = session.arguments;
  const Options options = session.options("computing");
  OperationReport report;
  const auto one = [&](Result<Solid> solid) -> Result<Computed> {
    if (!solid) return solid.error();
    return Computed{{std::move(solid).value()}, {}, report};
  };

  switch (a.command) {
    case Command::unite:
      return one(unite(solids, options, &report));
    case Command::intersect:
      return one(intersect(solids, options, &report));
    case Command::subtract:
      return one(difference(solids[0], {solids.begin() + 1, solids.end()}, options, &report));
    case Command::symmetric_difference:
      return one(symmetric_difference(solids, options, &report));
    case Command::complement:
      return one(complement(solids[0]));
    case Command::split: {
      auto parts = split(solids[0], a.plane, options, &report);
      if (!parts) return parts.error();
      return Computed{{parts.value().begin(), parts.value().end()}, {}, report};
    }
    case Command::move: {
      MotionReport motion;
      auto computed = one(moved(solids[0], a.motion, {.rounding = a.rounding, .run = options}, &motion));
      if (computed) computed.value().motion = motion;
      return computed;
    }
    case Command::eval:
    case Command::convert:
    case Command::info:
    case Command::check:
      break;
  }
  return Computed{solids, {}, {}};
}

/// Refuses an output that could only fail after the work is done.
Result<void> check_output(const Arguments& a, const std::string& path) {
  if (const auto format = a.output_format(path); !format) return format.error();
  if (path == "-") return {};

  const auto slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  struct stat status = {};
  // What exists is judged when it is written: it may be a link to another folder, or a device.
  if (::lstat(path.c_str(), &status) == 0) {
    if (!S_ISDIR(status.st_mode)) return {};
    return Error{.code = ErrorCode::unwritable, .message = "the output is a folder", .file = path};
  }
  if (::access(folder.c_str(), W_OK | X_OK) == 0) return {};
  return Error{
      .code = ErrorCode::unwritable, .message = "the folder of the output is missing or not writable", .file = path};
}

/// Says when rounding moved points by a good part of the least detail of the solid.
void warn_of_rounding(const Output& output, bool float32) {
  const ExportReport& report = output.report;
  if (report.triangles == 0 && !output.solid.is_empty())
    print_warning("nothing is left of the solid in the numbers of this format", output.path, "");
  if (!(report.max_round * ExportReport::detail_factor > report.least_detail)) return;

  const std::string cure = float32 ? "a format with doubles (ply, off, obj) or --recentre keeps it"
                                   : "--recentre keeps it if the solid lies far from the origin";
  print_warning("rounding to " + std::string(float32 ? "float32" : "doubles") + " moved points by up to " +
                    decimal(report.max_round) + ", where some vertices are " + decimal(report.least_detail) +
                    " apart: " + cure,
                output.path, "");
}

/// Whether anyone hears what became of the results.
bool says_results(const Arguments& a) { return a.json || !a.quiet; }

/// Fills in the bytes of the file and, where it is said, what rounding did.
Result<void> format_output(Session& session, Output& output) {
  const Arguments& a = session.arguments;
  const auto format = a.output_format(output.path);
  if (!format) return format.error();
  const FormatInfo& kind = info_of(format.value());
  if (kind.is_exact) {
    output.bytes = session.times.measure(Stage::write, [&] { return output.solid.to_quoin(); });
    return {};
  }

  auto mesh = session.times.measure(Stage::export_triangles, [&] {
    const ExportOptions options = {.topology = a.topology,
                                   .float32 = kind.is_float32,
                                   .run = session.options("exporting"),
                                   .validity = a.validity,
                                   .recentre = a.recentre};
    if (!says_results(a)) return output.solid.to_triangles(options);
    return output.solid.to_triangles(options, &output.report, &output.surface.emplace());
  });
  if (!mesh) {
    Error error = mesh.error();
    error.file = output.path;
    return error;
  }

  if (!a.quiet) warn_of_rounding(output, kind.is_float32);
  auto bytes = session.times.measure(Stage::write, [&] { return to_bytes(mesh.value(), format.value(), output.unit); });
  if (!bytes) return bytes.error();
  output.bytes = std::move(bytes).value();
  return {};
}

std::string summary(const Arguments& a, const Output& output) {
  const Info& info = output.info;
  const auto count = [](std::uint64_t n, const char* what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
  };

  std::string text = output.path + ": ";
  if (!info.bounded) {
    text += "unbounded, ";
  } else {
    text += output.solid.is_empty() ? "empty, " : "volume " + decimal(info.volume_approx) + ", ";
  }
  text += count(info.faces, "face") + ", " + count(info.shells, "shell") + "\n";

  if (output.unit != Unit::none) {
    const auto format = a.output_format(output.path);
    const bool is_stated = format && info_of(format.value()).has_unit;
    text += "  in " + std::string(name_of(output.unit)) + (is_stated ? "\n" : ", which the file does not state\n");
  }

  const ExportReport& report = output.report;
  if (report.flipped + report.collapsed > 0) {
    text += "  rounding flipped " + count(report.flipped, "triangle") + " and collapsed " +
            std::to_string(report.collapsed) + "\n";
  }
  if (report.split_edges > 0) text += "  " + count(report.split_edges, "touching edge") + " split inside\n";
  if (!report.closed) text += "  the written mesh is not closed\n";
  if (report.shared_edges > 0) text += "  " + count(report.shared_edges, "touching edge") + " kept all triangles\n";
  if (report.mending_rounds > 0) {
    text += "  rounding spoiled the triangles, mended: " + count(report.mended_crossings, "crossing") + ", " +
            std::to_string(report.merged_vertices) + " merged vertices, " + std::to_string(report.vanished_triangles) +
            " vanished triangles; nothing moved by more than " + decimal(report.max_round) + "\n";
  }
  if (const auto& c = report.recentred; c != std::array<double, 3>{})
    text += "  recentred: " + decimal(c[0]) + ", " + decimal(c[1]) + ", " + decimal(c[2]) + " subtracted\n";
  return text;
}

std::string seconds_text(double seconds) {
  std::array<char, 48> line = {};
  std::snprintf(line.data(), line.size(), "seconds %.3g\n", seconds);
  return line.data();
}

/// Nothing where no file was imported.
std::string import_summary(const Operands& operands) {
  if (operands.imports.empty()) return {};
  std::string text = "largest snap " + decimal(operands.max_snap()) + "\n";
  for (const auto& [file, report, unit] : operands.imports) {
    const auto crossings = report.resolved_crossings;
    if (crossings > 0) text += file + ": resolved crossings " + std::to_string(crossings) + "\n";
  }
  return text;
}

Json imports_json(const Operands& operands) {
  Json list = Json::array();
  for (std::size_t i = 0; i < operands.imports.size(); ++i) {
    const MeshImport& import = operands.imports[i];
    list.push_back(import_json(import.file, import.report));
    list.back()["unit"] = unit_json(import.unit);
    if (i < operands.contents.size()) add_contents(list.back(), operands.contents[i]);
  }
  return list;
}

Json output_json(const Output& output) {
  Json object = info_json(output.solid, output.info);
  object["unit"] = unit_json(output.unit);
  object["export"] = export_json(output.report);
  object["max_round"] = output.report.max_round;
  return object;
}

Json result_json(const Session& session, const Operands& operands, const std::optional<MotionReport>& motion,
                 const std::vector<Output>& outputs) {
  Json object;
  if (outputs.size() == 2) {
    object["above"] = output_json(outputs[0]);
    object["below"] = output_json(outputs[1]);
  } else {
    object = output_json(outputs[0]);
  }

  session.times.add_to(object);
  object["peak_rss_bytes"] = peak_memory();
  object["max_snap"] = operands.max_snap();
  object["import"] = imports_json(operands);

  const Arguments& a = session.arguments;
  if (a.command == Command::move) {
    const auto quaternion = a.motion.info().quaternion;
    object["quaternion"] = quaternion ? Json(*quaternion) : Json(nullptr);
  }
  if (motion) add_motion(object, *motion, a.rounding_name);
  return object;
}

/// The last thing that a command does: prints the object with --json, otherwise the text; the counters of --stats
/// follow.
Result<void> say(const Arguments& a, Json object, const std::string& text) {
  Result<void> said = {};
  if (a.json) {
    if (a.stats) object["statistics"] = statistics_json();
    said = print(object);
  } else {
    const std::string all = text + (a.stats ? statistics_text() : "");
    if (a.writes_to_stdout())
      std::fputs(all.c_str(), stderr);
    else
      said = print(all);
  }
  if (said) note_answered();
  return said;
}

Result<void> run_info(Session& session) {
  const auto operands = load(session);
  if (!operands) return operands.error();
  const Solid& solid = operands.value().solids[0];
  const Volume volume = session.arguments.json ? Volume::exact : Volume::exact_if_short;
  const auto info = measured_info(solid, nullptr, volume, session);
  if (!info) return info.error();
  const Unit unit = operands.value().unit(session.arguments);
  Json object = info_json(solid, info.value());
  object["unit"] = unit_json(unit);
  object["max_snap"] = operands.value().max_snap();
  object["import"] = imports_json(operands.value());
  std::string text = info_text(solid, info.value());
  if (unit != Unit::none) text += "in " + std::string(name_of(unit)) + "\n";
  text += objects_text(operands.value().contents[0]) + import_summary(operands.value());
  return say(session.arguments, std::move(object), text);
}

/// What is wrong with a mesh that is refused, all of it.
void say_findings(const Arguments& a) {
  if (!a.quiet && !a.json) static_cast<void>(print(findings_text(refused_findings())));
}

Result<void> run_check(Session& session) {
  const Arguments& a = session.arguments;
  const auto operands = load(session, Trust::nothing);
  if (!operands) {
    say_findings(a);
    return operands.error();
  }

  const ImportReport& report = operands.value().imports[0].report;
  Json object;
  object["valid"] = true;
  object["closed"] = true;
  object["bounded"] = operands.value().solids[0].is_bounded();
  object.update(import_json(a.inputs[0], report));
  object["step"] = operands.value().solids[0].grid().step();
  const Source& contents = operands.value().contents[0];
  add_contents(object, contents);
  const std::string text =
      a.inputs[0] + ": valid, closed\n" + objects_text(contents) + import_text(report) + findings_text(report.findings);
  return say(a, std::move(object), a.quiet ? "" : text);
}

/// Every command that writes.
Result<void> run_writing(Session& session) {
  const Arguments& a = session.arguments;
  for (const auto& path : a.outputs) {
    if (const auto checked = check_output(a, path); !checked) return checked.error();
  }

  const bool is_model = a.command == Command::eval;
  auto operands = is_model ? Result<Operands>(Operands{}) : load(session);
  if (!operands) return operands.error();
  auto results = is_model
                     ? evaluate_model(session, operands.value().imports)
                     : polled_stage(session, Stage::boolean, [&] { return compute(session, operands.value().solids); });
  if (!results) return results.error();
  if (results.value().motion) warn_of_losses(a, *results.value().motion);
  operands.value().solids.clear();
  operands.value().operation_snap = results.value().operation.max_snap;

  const Unit unit = operands.value().unit(a);
  std::vector<Output> outputs;
  for (std::size_t i = 0; i < a.outputs.size(); ++i) outputs.push_back({a.outputs[i], results.value().solids[i], unit});
  results.value().solids.clear();
  for (auto& output : outputs) {
    if (const auto formatted = format_output(session, output); !formatted) return formatted.error();
    if (!says_results(a)) continue;
    const SurfaceCounts* const surface = output.surface ? &*output.surface : nullptr;
    const auto info = measured_info(output.solid, surface, a.json ? Volume::exact : Volume::rounded, session);
    if (!info) return info.error();
    output.info = info.value();
  }

  // Nothing is written before everything is ready.
  for (const auto& output : outputs) {
    const auto written = session.times.measure(Stage::write, [&] {
      const WritingStage guard;
      auto result = write_bytes(output.path, output.bytes, &cancel_flag());
      if (result) note_written(output.path);
      return result;
    });
    if (!written) return written.error().code == ErrorCode::cancelled ? cancelled_error() : written.error();
  }

  if (a.json) return say(a, result_json(session, operands.value(), results.value().motion, outputs), "");
  std::string text;
  if (!a.quiet) {
    for (const auto& output : outputs) text += summary(a, output);
    if (results.value().motion) text += motion_text(*results.value().motion);
    text += import_summary(operands.value());
    text += seconds_text(session.times.total_seconds());
  }
  return say(a, {}, text);
}

}  // namespace

Result<void> run_command(const Arguments& arguments) {
  Session session(arguments);
  switch (arguments.command) {
    case Command::info:
      return run_info(session);
    case Command::check:
      return run_check(session);
    default:
      return run_writing(session);
  }
}

}  // namespace quoin::cli
