/// \file
/// Cures as they are asked for become cures with numbers.
#pragma once

#include "grid/repair.h"
#include "quoin/repair.h"

namespace quoin {

/// Errors: "bad-number" (a tolerance that is no decimal or rational, or negative; `where` is its name).
Result<grid::Cures> cures_of(const Repair& repair);

}  // namespace quoin
