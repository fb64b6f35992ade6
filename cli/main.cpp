/// \file
/// The program `quoin`: words in, exit code out.

#include <cerrno>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <variant>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "arguments.h"
#include "commands.h"
#include "ending.h"
#include "output.h"
#include "signals.h"

namespace quoin::cli {
namespace {

int exit_code(const Error& error) {
  if (error.code == ErrorCode::usage) return exit_usage;
  // Interrupted means that nothing was written.
  return error.code == ErrorCode::cancelled && written_files().empty() ? exit_interrupted : exit_refused;
}

Result<void> run(const std::vector<std::string>& words) {
  auto parsed = parse_arguments(words);
  if (!parsed) return parsed.error();
  if (const auto* answer = std::get_if<Answer>(&parsed.value())) return print(answer->text);
  return run_command(std::get<Arguments>(parsed.value()));
}

int guarded_run(const std::vector<std::string>& words, bool json) {
  try {
    const auto result = run(words);
    if (result) return exit_done;
    print_error(result.error(), json);
    return exit_code(result.error());
  } catch (const std::bad_alloc&) {
    print_error({.code = ErrorCode::out_of_memory, .message = "there is not enough memory for this"}, json);
    return exit_refused;
  } catch (const std::exception& exception) {
    print_error({.code = ErrorCode::internal_defect, .message = std::string("internal defect: ") + exception.what()},
                json);
    return exit_defect;
  }
}

/// As `json_wanted`, before there is any memory.
bool says_json(int argc, char** argv) {
  for (int i = 1; i < argc && std::strcmp(argv[i], "--") != 0; ++i)
    if (std::strcmp(argv[i], "--json") == 0) return true;
  return false;
}

/// Standard streams that are closed stay out of the way: else the next file would get their number, and be written to
/// by messages. Reading from the first, and writing to the others, fails.
void occupy_standard_streams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if (::fcntl(stream, F_GETFD) == -1 && errno == EBADF)
      static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

}  // namespace
}  // namespace quoin::cli

int main(int argc, char** argv) {
  quoin::cli::end_with_json(quoin::cli::says_json(argc, argv));
  quoin::cli::install_memory_handlers();
  quoin::cli::occupy_standard_streams();
  const std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
  const bool json = quoin::cli::json_wanted(words);
  quoin::cli::install_signal_handlers();
  return quoin::cli::guarded_run(words, json);
}
