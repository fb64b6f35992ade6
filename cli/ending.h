/// \file
/// Ends of the program that come from anywhere: a signal, exhausted memory, a defect; and what is on disk by then.
#pragma once

#include <string>
#include <vector>

#include <quoin/quoin.h>

namespace quoin::cli {

enum ExitCode { exit_done = 0, exit_refused = 1, exit_usage = 2, exit_defect = 3, exit_interrupted = 130 };

/// With `json`, `end_at_once` also prints an error object on stdout. Precondition for that: nothing is there yet.
void end_with_json(bool json);

/// The outputs are in place and the answer is printed: what is left is to release memory, which may need some (a JSON
/// object is taken apart by a list). From now on `end_at_once` ends in success, but for a defect.
void note_answered();

/// Ends the process with an exit code and one sentence, for handlers: it allocates nothing and calls what is
/// async-signal-safe alone. Once an output is in place the sentence says that first, stdout stays as it is, and the
/// exit code is that of a refusal.
[[noreturn]] void end_at_once(ErrorCode code, const char* sentence, ExitCode exit_code);

/// Installs what a program may and a library may not: handlers of exhausted memory, of C++ and of GMP, which end the
/// process with "out-of-memory" where they stand, and of exceptions that nobody catches.
/// GMP, which is C, would abort; nothing is thrown through its frames.
void install_memory_handlers();

/// Outputs that are in place.
const std::vector<std::string>& written_files();
/// Precondition: the file is in place.
void note_written(const std::string& path);

}  // namespace quoin::cli
