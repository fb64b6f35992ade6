/// \file
/// The program `quoin`: words in, exit code out.

#include <exception>
#include <new>
#include <string>
#include <variant>
#include <vector>

#include "arguments.h"
#include "commands.h"
#include "output.h"
#include "signals.h"

namespace quoin::cli {
namespace {

enum ExitCode { exit_done = 0, exit_refused = 1, exit_usage = 2, exit_defect = 3 };

int exit_code(const Error& error) {
  if (error.code == ErrorCode::usage) return exit_usage;
  return error.code == ErrorCode::cancelled ? exit_interrupted : exit_refused;
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

}  // namespace
}  // namespace quoin::cli

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
  const bool json = quoin::cli::json_wanted(words);
  quoin::cli::install_signal_handlers(json);
  return quoin::cli::guarded_run(words, json);
}
