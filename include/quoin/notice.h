/// \file
/// What import says of things that it passes over.
#pragma once

#include "quoin/export.h"

#include <cstdint>
#include <string>

namespace quoin {

/// Something of a file that a solid does not hold, or that bounds nothing.
struct Notice {
  std::uint64_t count = 0;
  /// "24 normals are passed over".
  std::string sentence = {};
  friend bool operator==(const Notice&, const Notice&) = default;
};

}  // namespace quoin
