/// \file
/// The texts of --help and --version.
#pragma once

#include <string>

#include "arguments.h"

namespace quoin::cli {

/// What one command is called, does, and looks like in use.
struct CommandHelp {
  Command command;
  const char* name;
  const char* summary;
  /// Printed below the options.
  const char* examples;
};

/// The command of that name; nullptr if there is none.
const CommandHelp* find_command(const std::string& name);
/// The command whose name is closest to a mistyped one; nullptr if none is close.
const CommandHelp* closest_command(const std::string& name);

/// `quoin --help`.
std::string general_help();
/// `quoin --version`; as a JSON object with `json`.
std::string version_text(bool json);

}  // namespace quoin::cli
