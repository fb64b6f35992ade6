/// \file
/// Why something was refused: a code for programs, a sentence for people, and the one exception.
#pragma once

#include "quoin/export.h"

#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>

namespace quoin {

/// One enumerator for each code of docs/errors.md, in its order. Codes stay, sentences may change.
enum class ErrorCode : std::uint8_t {
  // files
  missing_file,
  unreadable,
  unknown_format,
  truncated,
  bad_syntax,
  bad_number,
  non_finite,
  bad_index,
  absurd_count,
  no_faces,
  bad_quoin,
  unwritable,
  too_large,
  // meshes
  open_boundary,
  inside_out,
  out_of_range,
  // grids and expressions
  inexact_grid,
  mixed_units,
  bad_plane,
  no_operand,
  too_many_terms,
  unbounded,
  inconsistent,
  cancelled,
  // motions and models
  bad_model,
  bad_parameter,
  bad_primitive,
  bad_axis,
  bad_factor,
  not_a_rotation,
  inconsistent_motion,
  // the command line, and defects
  usage,
  out_of_memory,
  internal_defect,
};

/// The code in kebab-case, as files, JSON and the command line show it: "open-boundary".
inline std::string to_string(ErrorCode code) {
  switch (code) {
    case ErrorCode::missing_file:
      return "missing-file";
    case ErrorCode::unreadable:
      return "unreadable";
    case ErrorCode::unknown_format:
      return "unknown-format";
    case ErrorCode::truncated:
      return "truncated";
    case ErrorCode::bad_syntax:
      return "bad-syntax";
    case ErrorCode::bad_number:
      return "bad-number";
    case ErrorCode::non_finite:
      return "non-finite";
    case ErrorCode::bad_index:
      return "bad-index";
    case ErrorCode::absurd_count:
      return "absurd-count";
    case ErrorCode::no_faces:
      return "no-faces";
    case ErrorCode::bad_quoin:
      return "bad-quoin";
    case ErrorCode::unwritable:
      return "unwritable";
    case ErrorCode::too_large:
      return "too-large";
    case ErrorCode::open_boundary:
      return "open-boundary";
    case ErrorCode::inside_out:
      return "inside-out";
    case ErrorCode::out_of_range:
      return "out-of-range";
    case ErrorCode::inexact_grid:
      return "inexact-grid";
    case ErrorCode::mixed_units:
      return "mixed-units";
    case ErrorCode::bad_plane:
      return "bad-plane";
    case ErrorCode::no_operand:
      return "no-operand";
    case ErrorCode::too_many_terms:
      return "too-many-terms";
    case ErrorCode::unbounded:
      return "unbounded";
    case ErrorCode::inconsistent:
      return "inconsistent";
    case ErrorCode::cancelled:
      return "cancelled";
    case ErrorCode::bad_model:
      return "bad-model";
    case ErrorCode::bad_parameter:
      return "bad-parameter";
    case ErrorCode::bad_primitive:
      return "bad-primitive";
    case ErrorCode::bad_axis:
      return "bad-axis";
    case ErrorCode::bad_factor:
      return "bad-factor";
    case ErrorCode::not_a_rotation:
      return "not-a-rotation";
    case ErrorCode::inconsistent_motion:
      return "inconsistent-motion";
    case ErrorCode::usage:
      return "usage";
    case ErrorCode::out_of_memory:
      return "out-of-memory";
    case ErrorCode::internal_defect:
      break;
  }
  return "internal-defect";
}

inline std::ostream& operator<<(std::ostream& out, ErrorCode code) { return out << to_string(code); }

/// Why something was refused, for people and for programs.
struct Error {
  ErrorCode code = ErrorCode::internal_defect;
  /// One sentence that says what is wrong and, where possible, what would help.
  std::string message = {};
  /// The file concerned; empty when there is none.
  std::string file = {};
  /// The place: a face, an edge, coordinates, a line number; empty when there is none.
  std::string where = {};
};

/// An error where no Result can carry it: thrown by operators, and by a Result that is asked for what it does not hold.
/// `what()` is "<message> (<file>, <where>) [<code>]".
class QUOIN_API Exception : public std::runtime_error {
 public:
  explicit Exception(Error error) : std::runtime_error(sentence(error)), error_(std::move(error)) {}
  const Error& error() const noexcept { return error_; }

 private:
  static std::string sentence(const Error& error) {
    const char* comma = error.file.empty() || error.where.empty() ? "" : ", ";
    const std::string place = error.file + comma + error.where;
    return error.message + (place.empty() ? "" : " (" + place + ")") + " [" + to_string(error.code) + "]";
  }

  Error error_;
};

}  // namespace quoin
