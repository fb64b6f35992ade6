#include "signals.h"

#include <csignal>
#include <initializer_list>

#include "ending.h"

namespace quoin::cli {
namespace {

// A handler may touch lock-free atomics only.
static_assert(Cancel::is_always_lock_free);

Cancel cancelled{false};
Cancel polled{false};
Cancel writing{false};

constexpr std::initializer_list<int> interruptions = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU};

extern "C" void quoin_cli_handle_signal(int) {
  const bool first = !cancelled.exchange(true);
  if (writing.load() || (first && polled.load())) return;
  end_at_once(ErrorCode::cancelled, "interrupted", exit_interrupted);
}

bool is_ignored(int signal) {
  struct sigaction action = {};
  return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

void install_signal_handlers() {
  struct sigaction action = {};
  action.sa_handler = quoin_cli_handle_signal;
  sigemptyset(&action.sa_mask);
  // One signal at a time. A write that waits for its reader is interrupted, and asks for the flag.
  for (const int signal : interruptions) sigaddset(&action.sa_mask, signal);
  for (const int signal : interruptions)
    if (signal != SIGHUP || !is_ignored(SIGHUP)) ::sigaction(signal, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

const Cancel& cancel_flag() { return cancelled; }

PolledStage::PolledStage() { polled = true; }

PolledStage::~PolledStage() { polled = false; }

WritingStage::WritingStage() { writing = true; }

WritingStage::~WritingStage() { writing = false; }

}  // namespace quoin::cli
