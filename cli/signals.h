/// \file
/// Interruption: SIGINT and SIGTERM end the program with exit code 130 and leave nothing behind.
#pragma once

#include <quoin/quoin.h>

namespace quoin::cli {

/// Exit code of an interrupted command.
inline constexpr int exit_interrupted = 130;

/// Installs the handlers. With `json` an interruption that ends the process at once prints its error object on stdout.
/// SIGPIPE and SIGXFSZ are ignored: writing then fails with an error that can be reported.
void install_signal_handlers(bool json);

/// Set by the first signal.
const Cancel& cancel_flag();

/// While one lives, the running stage polls `cancel_flag()`, and only the second signal ends the process at once.
/// Outside, stages that cannot poll (reading, formatting) are running and the first signal does.
class PolledStage {
 public:
  PolledStage();
  ~PolledStage();
  PolledStage(const PolledStage&) = delete;
  PolledStage& operator=(const PolledStage&) = delete;
};

}  // namespace quoin::cli
