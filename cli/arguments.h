/// \file
/// The words of a command line, understood: which command, which operands, which options.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <quoin/quoin.h>

namespace quoin::cli {

enum class Command {
  unite,
  intersect,
  subtract,
  symmetric_difference,
  complement,
  split,
  move,
  eval,
  info,
  check,
  convert
};

struct Arguments {
  Command command = Command::info;
  /// As typed, e.g. "symmetric-difference".
  std::string name;
  std::vector<std::string> inputs;
  /// None for info and check, two for split (above, below), otherwise one.
  std::vector<std::string> outputs;
  /// Of split.
  HalfSpace plane;
  /// Of move, in the order given.
  Motion motion;
  /// Of eval: values of parameters.
  std::map<std::string, std::string> parameters;
  /// Of move and eval; `rounding_name` is its word.
  Rounding rounding = Rounding::best;
  std::string rounding_name = "best";
  std::optional<Grid> grid;
  GridRule grid_rule = GridRule::common;
  std::optional<Format> format;
  /// Of all commands that read meshes, but for eval.
  Repair repair;
  /// What numbers are converted to where a file states another unit.
  std::optional<Unit> unit;
  Topology topology = Topology::manifold;
  Validity validity = Validity::valid;
  bool recentre = false;
  Limits limits = {};
  /// Of eval: the model may name files anywhere.
  bool any_path = false;
  unsigned threads = 0;
  bool json = false;
  bool trust = false;
  bool stats = false;
  bool quiet = false;

  /// Some output is standard output.
  bool writes_to_stdout() const;
  /// The format of an output. Errors: "unknown-format".
  Result<Format> output_format(const std::string& path) const;
  /// What to tell the reader about an input; nothing when content and extension suffice.
  std::optional<Format> input_format(const std::string& path) const;
};

/// Text asked for by --help or --version: to be printed, exit code 0.
struct Answer {
  std::string text;
};

/// `words`: the command line without the program's name.
/// Errors: "usage", with a sentence that says what would be right.
Result<std::variant<Arguments, Answer>> parse_arguments(std::vector<std::string> words);

/// Whether the words ask for --json, also when they cannot be understood otherwise.
bool json_wanted(const std::vector<std::string>& words);

}  // namespace quoin::cli
