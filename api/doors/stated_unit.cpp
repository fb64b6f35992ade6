#include "api/doors/stated_unit.h"

namespace quoin {

Result<void> StatedUnit::add(Unit unit, const std::string& file) {
  if (unit == Unit::none || unit == unit_) return {};
  if (unit_ != Unit::none)
    return Error{ErrorCode::mixed_units,
                 "the file is in " + std::string(name_of(unit)) + ", but " + file_ + " in " +
                     std::string(name_of(unit_)) + ": name the unit to convert to",
                 file};
  unit_ = unit;
  file_ = file;
  return {};
}

}  // namespace quoin
