/// \file
/// The commands themselves.
#pragma once

#include "arguments.h"

namespace quoin::cli {

/// Carries out a command and prints its result. Errors: those of the library; nothing has then been printed.
Result<void> run_command(const Arguments& arguments);

}  // namespace quoin::cli
