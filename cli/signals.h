/// \file
/// Interruption: SIGINT, SIGTERM, SIGHUP, SIGQUIT and SIGXCPU end the program with exit code 130 and leave nothing
/// behind.
#pragma once

#include <quoin/quoin.h>

namespace quoin::cli {

/// Installs the handlers. SIGHUP stays ignored where it was (nohup). SIGPIPE and SIGXFSZ are ignored: writing then
/// fails with an error that can be reported.
void install_signal_handlers();

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

/// While one lives a file is being written, which polls, and no signal ends the process: a temporary file would stay.
class WritingStage {
 public:
  WritingStage();
  ~WritingStage();
  WritingStage(const WritingStage&) = delete;
  WritingStage& operator=(const WritingStage&) = delete;
};

}  // namespace quoin::cli
