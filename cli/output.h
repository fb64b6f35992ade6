/// \file
/// What the program says: results as JSON or text, errors, progress, and how long the stages took.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <quoin/quoin.h>
#include <nlohmann/json.hpp>

namespace quoin::cli {

using Json = nlohmann::ordered_json;

/// The stages of a command: parsing; arrays to solids; the Boolean; solid to triangle arrays with their check;
/// formatting and writing.
enum class Stage : std::size_t { read, build, boolean, export_triangles, write };
inline constexpr std::size_t stage_count = 5;

/// Wall and process CPU seconds spent in each stage.
class StageTimes {
 public:
  /// Runs `work` and adds its time to `stage`; returns what `work` returns.
  template <class Work>
  auto measure(Stage stage, Work&& work) {
    const Span span(*this, stage);
    return work();
  }

  /// Adds `seconds` and `cpu_seconds`, each with a key a stage and the sum, "total".
  void add_to(Json& object) const;
  double total_seconds() const;

 private:
  class Span {
   public:
    Span(StageTimes& times, Stage stage);
    ~Span();
    Span(const Span&) = delete;
    Span& operator=(const Span&) = delete;

   private:
    StageTimes& times_;
    std::size_t stage_;
    double wall_, cpu_;
  };

  std::array<double, stage_count> wall_ = {}, cpu_ = {};
};

/// One line on stderr, only if that is a terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool wanted);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// A callback for an operation that the line calls `what`; empty when there is no line. The line must outlive it.
  Progress show(const char* what);
  /// Makes the line disappear.
  void clear();

 private:
  bool enabled_;
  bool shown_ = false;
};

/// Info of a solid with its grid step.
Json info_json(const Solid& solid, const Info& info);
Json import_json(const std::string& file, const ImportReport& report);
/// The name of the unit, null for none.
Json unit_json(Unit unit);
/// Adds "unit" and "objects" of what was read; its meshes are not needed.
void add_contents(Json& object, const Source& source);
/// One line an object where there are several.
std::string objects_text(const Source& source);
Json export_json(const ExportReport& report);
Json statistics_json();
/// Adds "angle_error", "displacement_bound" and "rounding".
void add_motion(Json& object, const MotionReport& report, const std::string& method);

/// An aligned table of labels and values, one pair a line.
std::string table(const std::vector<std::array<std::string, 2>>& rows);
std::string info_text(const Solid& solid, const Info& info);
std::string import_text(const ImportReport& report);
std::string statistics_text();
/// One line, or two.
std::string motion_text(const MotionReport& report);

/// Shortest decimal that reads back to the same double.
std::string decimal(double value);

/// Peak resident memory of the process in bytes.
std::size_t peak_memory();

/// Writes to stdout and flushes. Errors: "unwritable".
Result<void> print(const std::string& text);
/// The object on one line; bytes of file names that are not UTF-8 become U+FFFD.
Result<void> print(const Json& object);
/// `quoin: <sentence> (<file>, <where>) [code]` on stderr, with `json` also {"error": {...}} on stdout, and beside it
/// "findings", where there are some.
void print_error(const Error& error, bool json);
/// What print_error is to say besides, of the mesh that is refused; and that.
void keep_findings(const std::vector<Finding>& findings);
const std::vector<Finding>& refused_findings();
Json findings_json(const std::vector<Finding>& findings);
/// A line each, with cure and place.
std::string findings_text(const std::vector<Finding>& findings);
/// `quoin: <file>: <sentence>` on stderr.
void print_notice(const std::string& sentence, const std::string& file);
/// `quoin: warning: <sentence> (<file>, <where>)` on stderr.
void print_warning(const std::string& sentence, const std::string& file, const std::string& where);

}  // namespace quoin::cli
