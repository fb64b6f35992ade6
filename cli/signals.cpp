#include "signals.h"

#include <csignal>
#include <cstring>

#include <unistd.h>

namespace quoin::cli {
namespace {

// A handler may touch lock-free atomics only.
static_assert(Cancel::is_always_lock_free);

Cancel cancelled{false};
Cancel polled{false};
Cancel print_json{false};

constexpr char sentence[] = "quoin: interrupted [cancelled]\n";
constexpr char object[] =
    "{\"error\":{\"code\":\"cancelled\",\"message\":\"interrupted\",\"file\":\"\",\"where\":\"\"}}\n";

void put(int descriptor, const char* text) {
  // Nothing can be done here about a failed write.
  [[maybe_unused]] const auto written = ::write(descriptor, text, std::strlen(text));
}

extern "C" void quoin_cli_handle_signal(int) {
  const bool first = !cancelled.exchange(true);
  if (first && polled.load()) return;
  put(STDERR_FILENO, sentence);
  if (print_json.load()) put(STDOUT_FILENO, object);
  ::_exit(exit_interrupted);
}

}  // namespace

void install_signal_handlers(bool json) {
  print_json = json;
  struct sigaction action = {};
  action.sa_handler = quoin_cli_handle_signal;
  sigemptyset(&action.sa_mask);
  // One signal at a time. A write that waits for its reader is interrupted, and asks for the flag.
  sigaddset(&action.sa_mask, SIGINT);
  sigaddset(&action.sa_mask, SIGTERM);
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

const Cancel& cancel_flag() { return cancelled; }

PolledStage::PolledStage() { polled = true; }

PolledStage::~PolledStage() { polled = false; }

}  // namespace quoin::cli
