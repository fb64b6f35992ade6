#include "ending.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include <gmp.h>
#include <unistd.h>

namespace quoin::cli {
namespace {

// A handler may touch lock-free atomics only.
static_assert(std::atomic<bool>::is_always_lock_free);

std::atomic<bool> print_json{false};
std::atomic<bool> something_is_written{false};
std::atomic<bool> all_is_said{false};

void put(int descriptor, const char* text) {
  // Nothing can be done here about a failed write.
  [[maybe_unused]] const auto written = ::write(descriptor, text, std::strlen(text));
}

/// As `to_string`, without memory.
const char* word(ErrorCode code) {
  switch (code) {
    case ErrorCode::cancelled:
      return "cancelled";
    case ErrorCode::out_of_memory:
      return "out-of-memory";
    default:
      return "internal-defect";
  }
}

[[noreturn]] void end_without_memory() {
  end_at_once(ErrorCode::out_of_memory, "there is not enough memory for this", exit_refused);
}

void* allocate(std::size_t size) {
  void* const made = std::malloc(size);
  if (made == nullptr) end_without_memory();
  return made;
}

void* reallocate(void* old, std::size_t, std::size_t size) {
  void* const made = std::realloc(old, size);
  if (made == nullptr) end_without_memory();
  return made;
}

void release(void* old, std::size_t) { std::free(old); }

/// Libraries let exceptions leave functions that promise none.
[[noreturn]] void end_of_uncaught() {
  try {
    if (const auto thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    end_without_memory();
  } catch (...) {
  }
  end_at_once(ErrorCode::internal_defect, "internal defect: an exception that nobody catches", exit_defect);
}

/// The C library aborts where it cannot keep a list of what a thread destroys. Any other abort goes its way.
extern "C" void quoin_cli_handle_abort(int) {
  if (errno == ENOMEM) end_without_memory();
}

std::vector<std::string>& written() {
  static std::vector<std::string>& files = *new std::vector<std::string>;
  return files;
}

}  // namespace

void end_with_json(bool json) { print_json = json; }

void note_answered() { all_is_said = true; }

void end_at_once(ErrorCode code, const char* sentence, ExitCode exit_code) {
  if (all_is_said.load() && exit_code != exit_defect) ::_exit(exit_done);
  const bool written = something_is_written.load();
  put(STDERR_FILENO, written ? "quoin: the output is written, but: " : "quoin: ");
  put(STDERR_FILENO, sentence);
  put(STDERR_FILENO, " [");
  put(STDERR_FILENO, word(code));
  put(STDERR_FILENO, "]\n");
  if (print_json.load() && !written) {
    put(STDOUT_FILENO, "{\"error\":{\"code\":\"");
    put(STDOUT_FILENO, word(code));
    put(STDOUT_FILENO, "\",\"message\":\"");
    put(STDOUT_FILENO, sentence);
    put(STDOUT_FILENO, "\",\"file\":\"\",\"where\":\"\"}}\n");
  }
  ::_exit(written && exit_code != exit_defect ? exit_refused : exit_code);
}

void install_memory_handlers() {
  std::set_new_handler(end_without_memory);
  ::mp_set_memory_functions(allocate, reallocate, release);
  std::set_terminate(end_of_uncaught);
  std::signal(SIGABRT, quoin_cli_handle_abort);
}

const std::vector<std::string>& written_files() { return written(); }

void note_written(const std::string& path) {
  something_is_written = true;
  written().push_back(path);
}

}  // namespace quoin::cli
