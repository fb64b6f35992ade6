/// \file
/// For programs that handle signals themselves. Not part of quoin/quoin.h.
#pragma once

#include "quoin/export.h"

namespace quoin {

/// Removes what an unfinished `write_bytes` or `Solid::write` has put on disk so far; that write then fails.
/// Async-signal-safe: for a handler that is about to end the process.
QUOIN_API void abandon_temporary_files();

}  // namespace quoin
