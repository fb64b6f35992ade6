#include "output.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <numeric>
#include <system_error>

#include <sys/resource.h>
#include <unistd.h>

#include "ending.h"

namespace quoin::cli {
namespace {

constexpr std::array<const char*, stage_count> stage_names = {"read", "build", "boolean", "export", "write"};

double clock_seconds(clockid_t clock) {
  timespec time = {};
  ::clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Json stages_json(const std::array<double, stage_count>& seconds) {
  Json object;
  for (std::size_t i = 0; i < stage_count; ++i) object[stage_names[i]] = seconds[i];
  object["total"] = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  return object;
}

/// Control characters would break the promise of one line, or talk to the terminal.
std::string printable(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return text;
}

/// " (<file>, <where>)", of which both may be missing.
std::string place(const std::string& file, const std::string& where) {
  const char* comma = file.empty() || where.empty() ? "" : ", ";
  const std::string inside = file + comma + where;
  return inside.empty() ? "" : " (" + inside + ")";
}

void print_line(std::string line) {
  line = printable(std::move(line)) + "\n";
  std::fputs(line.c_str(), stderr);
}

std::string dump(const Json& object) { return object.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"; }

/// Of the mesh that is refused. Never destroyed.
std::vector<Finding>& kept_findings() {
  static std::vector<Finding>& findings = *new std::vector<Finding>;
  return findings;
}

const char* yes_or_no(bool value) { return value ? "yes" : "no"; }

/// "6,412"
std::string grouped(std::size_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

/// "p" or "p/q" as it is, or where it is long the beginnings of p and q and the number of all digits.
std::string shortened(const std::string& number) {
  constexpr std::size_t longest = 48, shown = 12;
  if (number.size() <= longest) return number;

  const auto beginning = [](const std::string& part) {
    return part.size() <= shown ? part : part.substr(0, shown) + "...";
  };
  const std::size_t slash = number.find('/');
  std::string text = beginning(number.substr(0, slash));
  if (slash != std::string::npos) text += "/" + beginning(number.substr(slash + 1));

  const auto digits = std::count_if(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
  return text + " (" + grouped(static_cast<std::size_t>(digits)) + " digits, all with --json)";
}

std::string corner(const std::array<double, 3>& point) {
  return decimal(point[0]) + " " + decimal(point[1]) + " " + decimal(point[2]);
}

}  // namespace

StageTimes::Span::Span(StageTimes& times, Stage stage)
    : times_(times),
      stage_(static_cast<std::size_t>(stage)),
      wall_(clock_seconds(CLOCK_MONOTONIC)),
      cpu_(clock_seconds(CLOCK_PROCESS_CPUTIME_ID)) {}

StageTimes::Span::~Span() {
  times_.wall_[stage_] += clock_seconds(CLOCK_MONOTONIC) - wall_;
  times_.cpu_[stage_] += clock_seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu_;
}

void StageTimes::add_to(Json& object) const {
  object["seconds"] = stages_json(wall_);
  object["cpu_seconds"] = stages_json(cpu_);
}

double StageTimes::total_seconds() const { return std::accumulate(wall_.begin(), wall_.end(), 0.0); }

ProgressLine::ProgressLine(bool wanted) : enabled_(wanted && ::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() { clear(); }

Progress ProgressLine::show(const char* what) {
  if (!enabled_) return {};
  return [this, what, last = -1](double fraction) mutable {
    const int percent = static_cast<int>(100 * std::clamp(fraction, 0.0, 1.0));
    if (percent == last) return;
    last = percent;
    shown_ = true;
    std::fprintf(stderr, "\r\033[Kquoin: %s %d %%", what, percent);
    std::fflush(stderr);
  };
}

void ProgressLine::clear() {
  if (!shown_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  shown_ = false;
}

std::string decimal(double value) {
  std::array<char, 32> buffer = {};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

Json info_json(const Solid& solid, const Info& info) {
  Json object;
  object["vertices"] = info.vertices;
  object["edges"] = info.edges;
  object["faces"] = info.faces;
  object["triangles"] = info.triangles;
  object["shells"] = info.shells;
  object["genus"] = info.genus;

  object["closed"] = info.closed;
  object["manifold"] = info.manifold;
  object["bounded"] = info.bounded;

  object["volume"] = info.bounded ? Json(info.volume) : Json(nullptr);
  object["volume_approx"] = info.bounded ? Json(info.volume_approx) : Json(nullptr);
  object["area_approx"] = info.area_approx;
  object["box"] = info.box ? Json(*info.box) : Json(nullptr);
  object["step"] = solid.grid().step();
  return object;
}

Json import_json(const std::string& file, const ImportReport& report) {
  Json object;
  object["file"] = file;
  object["max_snap"] = report.max_snap;
  object["merged_points"] = report.merged_points;
  object["zero_area_triangles"] = report.zero_area_triangles;
  object["nonplanar_polygons"] = report.nonplanar_polygons;
  object["resolved_crossings"] = report.resolved_crossings;
  object["dropped_shells"] = report.dropped_shells;
  object["dropped_where"] = report.dropped_where;
  object["sealed_t_junctions"] = report.sealed_t_junctions;
  object["findings"] = findings_json(report.findings);
  object["repairs"] = findings_json(report.repairs);
  Json notices = Json::array();
  for (const Notice& notice : report.notices)
    notices.push_back({{"count", notice.count}, {"sentence", notice.sentence}});
  object["notices"] = std::move(notices);
  return object;
}

Json findings_json(const std::vector<Finding>& findings) {
  Json list = Json::array();
  for (const Finding& f : findings)
    list.push_back({{"kind", to_string(f.kind)},
                    {"count", f.count},
                    {"size", f.size},
                    {"where", f.where},
                    {"cure", f.cure},
                    {"sentence", f.sentence}});
  return list;
}

std::string findings_text(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& f : findings) {
    text += "  " + f.sentence + " (" + f.where + ")";
    text += f.cure.empty() ? "\n" : "; cure: --repair " + f.cure + "\n";
  }
  return text;
}

Json unit_json(Unit unit) { return unit == Unit::none ? Json(nullptr) : Json(name_of(unit)); }

void add_contents(Json& object, const Source& source) {
  object["unit"] = unit_json(source.unit);
  object["objects"] = Json::array();
  for (const FileObject& one : source.objects) {
    Json& entry = object["objects"].emplace_back();
    entry["number"] = one.number;
    entry["name"] = one.name;
    entry["faces"] = one.faces;
  }
}

std::string objects_text(const Source& source) {
  if (source.objects.size() < 2) return {};
  std::string text;
  for (const FileObject& one : source.objects) {
    text += "object " + std::to_string(one.number) + ": ";
    if (!one.name.empty()) text += printable(one.name) + ", ";
    text += std::to_string(one.faces) + (one.faces == 1 ? " face\n" : " faces\n");
  }
  return text;
}

Json export_json(const ExportReport& report) {
  Json object;
  object["flipped"] = report.flipped;
  object["collapsed"] = report.collapsed;
  object["split_edges"] = report.split_edges;
  object["closed"] = report.closed;
  object["valid"] = report.valid;
  object["max_round"] = report.max_round;
  object["least_detail"] = report.least_detail;
  object["mending_rounds"] = report.mending_rounds;
  object["mended_crossings"] = report.mended_crossings;
  object["merged_vertices"] = report.merged_vertices;
  object["vanished_triangles"] = report.vanished_triangles;
  object["shared_edges"] = report.shared_edges;
  object["recentred"] = report.recentred;
  return object;
}

Json statistics_json() {
  const Statistics counts = statistics();
  Json object;
  object["symbolic"] = counts.symbolic;
  object["filter"] = counts.filter;
  object["fixed_width"] = counts.fixed_width;
  object["rational"] = counts.rational;
  return object;
}

void add_motion(Json& object, const MotionReport& report, const std::string& method) {
  object["angle_error"] = report.angle_error;
  object["displacement_bound"] = report.displacement_bound;

  Json rounding;
  rounding["method"] = method;
  rounding["primitives"] = report.primitives;
  rounding["by_planes"] = report.by_planes;
  rounding["by_vertices"] = report.by_vertices;
  rounding["planes"] = report.planes;
  rounding["exact_planes"] = report.exact_planes;
  rounding["face_local_planes"] = report.face_local_planes;
  rounding["merged_points"] = report.merged_points;
  rounding["zero_area_triangles"] = report.zero_area_triangles;
  rounding["resolved_crossings"] = report.resolved_crossings;
  rounding["vanished_primitives"] = report.vanished_primitives;
  rounding["vanished_where"] = report.vanished_where;
  object["rounding"] = std::move(rounding);
}

std::string table(const std::vector<std::array<std::string, 2>>& rows) {
  std::size_t width = 0;
  for (const auto& row : rows) width = std::max(width, row[0].size());
  std::string text;
  for (const auto& row : rows) text += row[0] + std::string(width + 2 - row[0].size(), ' ') + row[1] + "\n";
  return text;
}

std::string info_text(const Solid& solid, const Info& info) {
  std::vector<std::array<std::string, 2>> rows = {
      {"vertices", std::to_string(info.vertices)}, {"edges", std::to_string(info.edges)},
      {"faces", std::to_string(info.faces)},       {"triangles", std::to_string(info.triangles)},
      {"shells", std::to_string(info.shells)},     {"genus", std::to_string(info.genus)},
      {"closed", yes_or_no(info.closed)},          {"manifold", yes_or_no(info.manifold)},
      {"bounded", yes_or_no(info.bounded)}};

  rows.push_back({"volume", info.bounded ? decimal(info.volume_approx) : "infinite"});
  const bool is_known = !info.volume.empty();
  if (info.bounded)
    rows.push_back({"volume, exact", is_known ? shortened(info.volume) : "long, all digits with --json"});
  rows.push_back({"area, about", decimal(info.area_approx)});
  rows.push_back({"box, low", info.box ? corner((*info.box)[0]) : "none"});
  rows.push_back({"box, high", info.box ? corner((*info.box)[1]) : "none"});
  rows.push_back({"grid step", solid.grid().step()});
  return table(rows);
}

std::string import_text(const ImportReport& report) {
  return table({{"largest snap", decimal(report.max_snap)},
                {"merged points", std::to_string(report.merged_points)},
                {"zero-area triangles", std::to_string(report.zero_area_triangles)},
                {"nonplanar polygons", std::to_string(report.nonplanar_polygons)},
                {"T-junctions sealed", std::to_string(report.sealed_t_junctions)},
                {"crossings resolved", std::to_string(report.resolved_crossings)},
                {"shells dropped", std::to_string(report.dropped_shells)}});
}

std::string statistics_text() {
  const Statistics counts = statistics();
  return table({{"signs, symbolic", std::to_string(counts.symbolic)},
                {"signs, filter", std::to_string(counts.filter)},
                {"signs, fixed width", std::to_string(counts.fixed_width)},
                {"signs, rational", std::to_string(counts.rational)}});
}

std::string motion_text(const MotionReport& report) {
  std::string text = "  primitives " + std::to_string(report.primitives) + ": " + std::to_string(report.by_planes) +
                     " kept their flat faces, " + std::to_string(report.by_vertices) +
                     " were rounded corner by corner\n  nothing is farther from where it should be than " +
                     decimal(report.displacement) + "\n";
  if (report.resolved_crossings > 0)
    text += "  rounding made " + std::to_string(report.resolved_crossings) + " crossings, resolved\n";
  return text;
}

std::size_t peak_memory() {
  rusage usage = {};
  ::getrusage(RUSAGE_SELF, &usage);
  // Linux counts in KiB, macOS in bytes.
#ifdef __APPLE__
  return static_cast<std::size_t>(usage.ru_maxrss);
#else
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
#endif
}

Result<void> print(const std::string& text) {
  // What comes after a part would not be understood.
  static bool has_failed = false;
  end_with_json(false);
  errno = 0;
  const bool whole = !has_failed && std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (std::fflush(stdout) == 0 && whole) return {};
  const std::string reason = has_failed ? "it failed before" : std::generic_category().message(errno);
  has_failed = true;
  return Error{.code = ErrorCode::unwritable, .message = "cannot write to standard output: " + reason};
}

Result<void> print(const Json& object) { return print(dump(object)); }

void print_error(const Error& error, bool json) {
  const std::vector<std::string>& written = written_files();
  if (json) {
    Json object;
    object["error"] = {
        {"code", to_string(error.code)}, {"message", error.message}, {"file", error.file}, {"where", error.where}};
    if (!kept_findings().empty()) object["findings"] = findings_json(kept_findings());
    if (!written.empty()) object["error"]["written"] = written;
    // The sentence below is said in any case.
    static_cast<void>(print(object));
  }
  std::string sentence = error.message;
  while (!sentence.empty() && sentence.back() == '.') sentence.pop_back();
  for (std::size_t i = 0; i < written.size(); ++i) sentence += (i == 0 ? ", but this is written: " : ", ") + written[i];
  print_line("quoin: " + sentence + place(error.file, error.where) + " [" + to_string(error.code) + "]");
}

void keep_findings(const std::vector<Finding>& findings) { kept_findings() = findings; }

const std::vector<Finding>& refused_findings() { return kept_findings(); }

void print_notice(const std::string& sentence, const std::string& file) {
  print_line("quoin: " + file + ": " + sentence);
}

void print_warning(const std::string& sentence, const std::string& file, const std::string& where) {
  print_line("quoin: warning: " + sentence + place(file, where));
}

}  // namespace quoin::cli
