#include "api/doors/repair.h"

#include "exact/rational.h"

namespace quoin {
namespace {

Error unknown(std::string_view word) {
  return {ErrorCode::usage,
          "\"" + std::string(word) +
              "\" is no cure: there are all, weld=TOL, t-junctions=TOL, duplicates, orient, orient=solid, caps, "
              "caps=SIZE and invert-shells"};
}

/// One NAME[=VALUE]; false where it is none.
bool add(std::string_view word, Repair& repair) {
  const auto equals = word.find('=');
  const std::string_view name = word.substr(0, equals);
  if (equals == word.npos) {
    if (name == "all") return repair.all = true;
    if (name == "duplicates") return repair.duplicates = true;
    if (name == "caps") return repair.caps = true;
    if (name == "invert-shells") return repair.invert_shells = true;
    if (name != "orient") return false;
    repair.orient = Orient::nested;
    return true;
  }

  const std::string value(word.substr(equals + 1));
  if (value.empty()) return false;
  if (name == "weld") return repair.weld = value, true;
  if (name == "t-junctions") return repair.t_junctions = value, true;
  if (name == "caps") return repair.caps_size = value, true;
  if (name != "orient" || value != "solid") return false;
  repair.orient = Orient::solid;
  return true;
}

Result<std::optional<exact::Rational>> tolerance(const std::string& text, const char* name) {
  if (text.empty()) return std::optional<exact::Rational>();
  auto number = exact::parse_rational(text);
  if (!number)
    return Error{ErrorCode::bad_number, "\"" + text + "\" is neither a decimal nor a rational p/q", {}, name};
  if (*number < 0) return Error{ErrorCode::bad_number, "a tolerance is not negative, as " + text + " is", {}, name};
  return number;
}

}  // namespace

std::string to_string(Defect kind) {
  switch (kind) {
    case Defect::crack:
      return "crack";
    case Defect::t_junction:
      return "t-junction";
    case Defect::duplicate:
      return "duplicate";
    case Defect::flap:
      return "flap";
    case Defect::orientation:
      return "orientation";
    case Defect::hole:
      return "hole";
    case Defect::branch:
      return "branch";
    case Defect::inside_out:
      break;
  }
  return "inside-out";
}

Result<Repair> Repair::parse(std::string_view text) {
  Repair repair;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    const std::string_view word = text.substr(begin, comma - begin);
    if (!add(word, repair)) return unknown(word);
    begin = comma + 1;
  }
  if (const auto cures = cures_of(repair); !cures)
    return Error{ErrorCode::usage, cures.error().where + ": " + cures.error().message};
  return repair;
}

Result<grid::Cures> cures_of(const Repair& repair) {
  const auto weld = tolerance(repair.weld, "weld");
  if (!weld) return weld.error();
  const auto t_junctions = tolerance(repair.t_junctions, "t-junctions");
  if (!t_junctions) return t_junctions.error();
  const auto caps_size = tolerance(repair.caps_size, "caps");
  if (!caps_size) return caps_size.error();

  grid::Cures cures;
  cures.weld = *weld;
  cures.t_junctions = *t_junctions;
  cures.caps_up_to = *caps_size;
  cures.duplicates = repair.duplicates;
  cures.caps = repair.caps;
  cures.invert_shells = repair.invert_shells;
  cures.all = repair.all;
  cures.orient = repair.orient;
  return cures;
}

}  // namespace quoin
