/// \file
/// What exceeds a limit.
#pragma once

#include <cstdint>
#include <string>

#include "quoin/limits.h"
#include "quoin/result.h"

namespace quoin::io {

/// `what` is too large: the sentence names the limit, as the command line calls it, and its value.
inline Error too_large(const std::string& what, const std::string& limit, std::uint64_t value,
                       const std::string& where = {}) {
  return {ErrorCode::too_large, what + " than the limit \"" + limit + "\" allows: " + std::to_string(value), {}, where};
}

}  // namespace quoin::io
