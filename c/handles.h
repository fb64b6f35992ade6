/// \file
/// What the handles hold, and how plain arguments become those of the C++ API.
#pragma once

#include <array>
#include <atomic>
#include <string>
#include <vector>

#include "c/guard.h"

struct quoin_grid {
  quoin::Grid value;
};
struct quoin_solid {
  quoin::Solid value;
};
struct quoin_mesh {
  quoin::LabelledMesh value;
  std::vector<float> float32;
  std::vector<quoin_face_label> labels;
};
struct quoin_boundary {
  quoin::Boundary value;
};
struct quoin_motion {
  quoin::Motion value;
};
struct quoin_model {
  quoin::Model value;
};
struct quoin_cancel {
  quoin::Cancel value = false;
};

namespace quoin::c {

/// Options of a run, with callbacks as functions. It must live until the run is over.
class Running {
 public:
  explicit Running(const quoin_options* given);
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  const Options& options() const { return options_; }

 private:
  quoin_options given_;
  Cancel own_ = false;
  Options options_;
};

/// The same for an import.
class Importing {
 public:
  explicit Importing(const quoin_import_options* given);
  const ImportOptions& options() const { return options_; }

 private:
  quoin_import_options given_;
  Running run_;
  std::vector<std::uint32_t> labels_;  // what had 64 bits
  ImportOptions options_;
};

/// The same for an export.
class Exporting {
 public:
  explicit Exporting(const quoin_export_options* given);
  const ExportOptions& options() const { return options_; }
  bool wants_labels() const { return given_.labels != 0; }

 private:
  quoin_export_options given_;
  Running run_;
  ExportOptions options_;
};

void give(const ImportReport& report, quoin_import_report* out);
void give(const OperationReport& report, quoin_operation_report* out);
void give(const ExportReport& report, quoin_export_report* out);
void give(const MotionReport& report, quoin_motion_report* out);

/// The caller's coordinates, as they are.
Coordinates coordinates(const quoin_array& array, const char* where);

/// The caller's indices: as they are or, of 64 bits, copied into `room`. Throws what does not fit.
Indices indices(const quoin_array& array, std::vector<std::uint32_t>& room, const char* where);

/// N texts, none of them NULL.
template <std::size_t N>
std::array<std::string, N> texts(const char* const* given, const char* where) {
  demand(given, where);
  std::array<std::string, N> r;
  for (std::size_t i = 0; i < N; ++i) {
    demand(given[i], where);
    r[i] = given[i];
  }
  return r;
}

/// So many solids, none of them NULL.
std::vector<Solid> solids(const quoin_solid* const* given, std::size_t count, const char* where);

inline quoin_face_label face_label(const FaceLabel& l) { return {l.original, l.label, l.source, l.turned ? 1 : 0}; }

/// One of the solids that labels name; `name` may be NULL.
inline void give_original(const std::vector<Original>& originals, std::uint32_t original, std::uint32_t* id,
                          const char** name) {
  demand_below(original, originals.size(), "original");
  *id = originals[original].id;
  if (name) *name = originals[original].name.c_str();
}

inline Grid grid_or_default(const quoin_grid* grid) { return grid ? grid->value : Grid(); }

}  // namespace quoin::c
