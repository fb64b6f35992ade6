#include <cstdlib>
#include <limits>

#include "c/handles.h"

namespace quoin::c {
namespace {

/// What fits of a text, up to the end of a character, and a 0.
template <std::size_t N>
void copy(std::string_view from, char (&to)[N]) noexcept {
  std::size_t n = std::min(from.size(), N - 1);
  const auto continues = [&](std::size_t i) { return (static_cast<unsigned char>(from[i]) & 0xC0u) == 0x80u; };
  if (n < from.size())
    while (n > 0 && continues(n)) --n;
  std::memcpy(to, from.data(), n);
  to[n] = '\0';
}

/// The numbers of an array of C.
template <class Number>
std::span<const Number> numbers(const quoin_array& array) {
  return {static_cast<const Number*>(array.data), array.count};
}

void demand_data(const quoin_array& array, const char* where) {
  demand(array.data != nullptr || array.count == 0, "the array is NULL and not empty", where);
}

}  // namespace

quoin_code code_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::missing_file:
      return QUOIN_MISSING_FILE;
    case ErrorCode::unreadable:
      return QUOIN_UNREADABLE;
    case ErrorCode::unknown_format:
      return QUOIN_UNKNOWN_FORMAT;
    case ErrorCode::truncated:
      return QUOIN_TRUNCATED;
    case ErrorCode::bad_syntax:
      return QUOIN_BAD_SYNTAX;
    case ErrorCode::bad_number:
      return QUOIN_BAD_NUMBER;
    case ErrorCode::non_finite:
      return QUOIN_NON_FINITE;
    case ErrorCode::bad_index:
      return QUOIN_BAD_INDEX;
    case ErrorCode::absurd_count:
      return QUOIN_ABSURD_COUNT;
    case ErrorCode::no_faces:
      return QUOIN_NO_FACES;
    case ErrorCode::bad_quoin:
      return QUOIN_BAD_QUOIN;
    case ErrorCode::unwritable:
      return QUOIN_UNWRITABLE;
    case ErrorCode::too_large:
      return QUOIN_TOO_LARGE;
    case ErrorCode::open_boundary:
      return QUOIN_OPEN_BOUNDARY;
    case ErrorCode::inside_out:
      return QUOIN_INSIDE_OUT;
    case ErrorCode::out_of_range:
      return QUOIN_OUT_OF_RANGE;
    case ErrorCode::inexact_grid:
      return QUOIN_INEXACT_GRID;
    case ErrorCode::mixed_units:
      return QUOIN_MIXED_UNITS;
    case ErrorCode::bad_plane:
      return QUOIN_BAD_PLANE;
    case ErrorCode::no_operand:
      return QUOIN_NO_OPERAND;
    case ErrorCode::too_many_terms:
      return QUOIN_TOO_MANY_TERMS;
    case ErrorCode::unbounded:
      return QUOIN_UNBOUNDED;
    case ErrorCode::inconsistent:
      return QUOIN_INCONSISTENT;
    case ErrorCode::cancelled:
      return QUOIN_CANCELLED;
    case ErrorCode::bad_model:
      return QUOIN_BAD_MODEL;
    case ErrorCode::bad_parameter:
      return QUOIN_BAD_PARAMETER;
    case ErrorCode::bad_primitive:
      return QUOIN_BAD_PRIMITIVE;
    case ErrorCode::bad_axis:
      return QUOIN_BAD_AXIS;
    case ErrorCode::bad_factor:
      return QUOIN_BAD_FACTOR;
    case ErrorCode::not_a_rotation:
      return QUOIN_NOT_A_ROTATION;
    case ErrorCode::inconsistent_motion:
      return QUOIN_INCONSISTENT_MOTION;
    case ErrorCode::usage:
      return QUOIN_USAGE;
    case ErrorCode::out_of_memory:
      return QUOIN_OUT_OF_MEMORY;
    case ErrorCode::internal_defect:
      break;
  }
  return QUOIN_INTERNAL_DEFECT;
}

quoin_code fail(quoin_error* error, quoin_code code, std::string_view message, std::string_view file,
                std::string_view where) noexcept {
  if (!error) return code;
  error->code = code;
  copy(message, error->message);
  copy(file, error->file);
  copy(where, error->where);
  return code;
}

char* text(std::string_view value) {
  auto* copied = static_cast<char*>(std::malloc(value.size() + 1));
  if (!copied) throw std::bad_alloc();
  std::memcpy(copied, value.data(), value.size());
  copied[value.size()] = '\0';
  return copied;
}

Running::Running(const quoin_options* given) : given_(taken(given, "options")) {
  Cancel& cancel = given_.cancel ? given_.cancel->value : own_;
  options_.cancel = &cancel;
  options_.threads = given_.threads;
  options_.grid_rule = enumerator<GridRule>(given_.grid_rule, 2, "options.grid_rule");
  if (given_.progress)
    options_.progress = [this, &cancel](double done) {
      if (given_.progress(done, given_.user) != 0) cancel = true;
    };
  if (given_.stage) options_.stage = [this](const char* name) { given_.stage(name, given_.user); };
}

Importing::Importing(const quoin_import_options* given) : given_(taken(given, "options")), run_(given_.run) {
  if (given_.grid) options_.grid = given_.grid->value;
  options_.trust = enumerator<Trust>(given_.trust, 2, "options.trust");
  options_.run = run_.options();
  if (given_.repair) options_.repair = Repair::parse(given_.repair).value();

  if (given_.labels.count > 0) options_.labels = indices(given_.labels, labels_, "options.labels");
  options_.id = given_.id;
  if (given_.name) options_.name = given_.name;
  if (given_.channels.count > 0) options_.channels = coordinates(given_.channels, "options.channels");
  if (given_.channel_tolerance != 0) options_.channel_tolerance = given_.channel_tolerance;
}

Exporting::Exporting(const quoin_export_options* given) : given_(taken(given, "options")), run_(given_.run) {
  options_.topology = enumerator<Topology>(given_.topology, 2, "options.topology");
  options_.validity = enumerator<Validity>(given_.validity, 2, "options.validity");
  options_.float32 = given_.float32 != 0;
  options_.recentre = given_.recentre != 0;
  options_.run = run_.options();
}

void give(const ImportReport& r, quoin_import_report* out) {
  give(quoin_import_report{0, r.max_snap, r.merged_points, r.zero_area_triangles, r.nonplanar_polygons,
                           r.resolved_crossings, r.dropped_shells, r.sealed_t_junctions, r.findings.size(),
                           r.repairs.size()},
       out);
}

void give(const OperationReport& r, quoin_operation_report* out) {
  give(quoin_operation_report{0, r.max_snap, r.rounded_operands, r.by_planes, r.by_vertices, r.resolved_crossings,
                              r.rounded_planes, r.vanished_operands},
       out);
}

void give(const ExportReport& r, quoin_export_report* out) {
  give(quoin_export_report{0,
                           r.triangles,
                           r.flipped,
                           r.collapsed,
                           r.split_edges,
                           r.shared_edges,
                           r.mending_rounds,
                           r.mended_crossings,
                           r.merged_vertices,
                           r.vanished_triangles,
                           r.closed,
                           r.valid,
                           r.max_round,
                           r.least_detail,
                           {r.recentred[0], r.recentred[1], r.recentred[2]}},
       out);
}

void give(const MotionReport& r, quoin_motion_report* out) {
  give(quoin_motion_report{0, r.displacement, r.angle_error, r.primitives, r.by_planes, r.by_vertices, r.planes,
                           r.exact_planes, r.face_local_planes, r.merged_points, r.zero_area_triangles,
                           r.resolved_crossings, r.vanished_primitives},
       out);
}

Coordinates coordinates(const quoin_array& array, const char* where) {
  demand_data(array, where);
  if (array.type == QUOIN_FLOAT64) return numbers<double>(array);
  demand(array.type == QUOIN_FLOAT32, "coordinates are float64 or float32", where);
  return numbers<float>(array);
}

Indices indices(const quoin_array& array, std::vector<std::uint32_t>& room, const char* where) {
  demand_data(array, where);
  if (array.type == QUOIN_UINT32) return numbers<std::uint32_t>(array);
  if (array.type == QUOIN_INT32) return numbers<std::int32_t>(array);
  demand(array.type == QUOIN_UINT64, "indices are uint32, int32 or uint64", where);

  room.reserve(array.count);
  for (const std::uint64_t i : numbers<std::uint64_t>(array)) {
    if (i > std::numeric_limits<std::uint32_t>::max())
      throw Exception({ErrorCode::bad_index,
                       "index " + std::to_string(i) + " is beyond 32 bits",
                       {},
                       where + (" " + std::to_string(room.size()))});
    room.push_back(static_cast<std::uint32_t>(i));
  }
  return room;
}

std::vector<Solid> solids(const quoin_solid* const* given, std::size_t count, const char* where) {
  demand(given != nullptr || count == 0, "the array is NULL and not empty", where);
  std::vector<Solid> r;
  r.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    demand(given[i], where);
    r.push_back(given[i]->value);
  }
  return r;
}

}  // namespace quoin::c
