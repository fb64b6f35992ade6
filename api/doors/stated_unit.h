/// \file
/// The unit that all files of one operation have to state.
#pragma once

#include <string>

#include "quoin/format.h"
#include "quoin/result.h"

namespace quoin {

/// Files state a unit, the same one, or none.
class StatedUnit {
 public:
  /// Errors: "mixed-units", with the file.
  Result<void> add(Unit unit, const std::string& file);

 private:
  Unit unit_ = Unit::none;
  std::string file_;  // the first that states one
};

}  // namespace quoin
