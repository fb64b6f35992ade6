#include "arguments.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include <CLI/CLI.hpp>

#include "help.h"

namespace quoin::cli {
namespace {

using Words = std::vector<std::string>;

constexpr unsigned max_threads = 1024;

constexpr std::array<std::pair<std::string_view, Rounding>, 6> roundings = {
    {{"best", Rounding::best},
     {"naive", Rounding::naive},
     {"continued-fraction", Rounding::continued_fraction},
     {"lattice", Rounding::lattice},
     {"face-local", Rounding::face_local},
     {"vertices", Rounding::vertices}}};

constexpr std::array<std::pair<std::string_view, std::uint64_t Limits::*>, 9> limit_names = {
    {{"bytes", &Limits::bytes},
     {"stream-bytes", &Limits::stream_bytes},
     {"vertices", &Limits::vertices},
     {"faces", &Limits::faces},
     {"nodes", &Limits::nodes},
     {"model-faces", &Limits::model_faces},
     {"sides", &Limits::sides},
     {"digits", &Limits::digits},
     {"depth", &Limits::depth}}};

/// Values that still need a look after the words are parsed.
struct RawOptions {
  std::string plane;
  std::optional<std::string> step, format, unit, topology, rounding, repair, limits;
  Words rotate, translate, mirror, scale, set;
  std::vector<std::string> order;  // of the motions
  bool version = false, valid = false, fast = false;
};

/// "a, b or c"
std::string alternatives(const std::vector<std::string_view>& words) {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i) {
    list.append(i == 0 ? "" : i + 1 == words.size() ? " or " : ", ");
    list.append(words[i]);
  }
  return list;
}

std::string format_names() {
  std::vector<std::string_view> names;
  for (const FormatInfo& info : formats()) names.push_back(info.name);
  return alternatives(names);
}

std::string unit_names() {
  std::vector<std::string_view> names;
  for (auto unit = Unit::micron; unit <= Unit::meter; unit = static_cast<Unit>(static_cast<int>(unit) + 1))
    names.push_back(name_of(unit));
  return alternatives(names);
}

std::string rounding_names() {
  std::vector<std::string_view> names;
  for (const auto& rounding : roundings) names.push_back(rounding.first);
  return alternatives(names);
}

std::string limit_list() {
  std::vector<std::string_view> names;
  for (const auto& limit : limit_names) names.push_back(limit.first);
  return alternatives(names);
}

Error usage(std::string message) { return {.code = ErrorCode::usage, .message = std::move(message)}; }

bool value_option(const std::string& word) {
  return word == "--step" || word == "--threads" || word == "--output-topology" || word == "--format" ||
         word == "--repair" || word == "--unit" || word == "--limits";
}

bool answered(const Words& words, std::string_view long_name, std::string_view short_name) {
  return std::any_of(words.begin(), words.end(), [&](const auto& w) { return w == long_name || w == short_name; });
}

/// `quoin --json info A` means `quoin info A --json`: moves leading common options behind the command.
/// Returns the number of leading words moved.
std::size_t move_leading_options(Words& words) {
  std::size_t i = 0;
  while (i < words.size() && words[i].size() > 1 && words[i][0] == '-') i += value_option(words[i]) ? 2 : 1;
  if (i >= words.size()) return i;
  // They go right behind the command, ahead of any "--".
  std::rotate(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(i),
              words.begin() + static_cast<std::ptrdiff_t>(i + 1));
  return i;
}

/// Descriptions beside the options, in lines of at most 120 columns.
class NarrowFormatter : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    constexpr std::size_t width = 120;
    const std::size_t indent = get_column_width();
    std::string text = "  " + make_option_name(option, is_positional) + make_option_opts(option);
    std::size_t column = text.size();
    if (column + 1 > indent) {
      text += "\n";
      column = 0;
    }
    text.append(indent - column, ' ');
    column = indent;

    std::istringstream words(make_option_desc(option));
    for (std::string word; words >> word;) {
      if (column > indent && column + 1 + word.size() > width) {
        text += "\n" + std::string(indent, ' ');
        column = indent;
      }
      if (column > indent) text += ' ', ++column;
      text += word;
      column += word.size();
    }
    return text + "\n";
  }
};

/// One app a command, without subcommands: a file may be called "union".
std::unique_ptr<CLI::App> make_app(const CommandHelp& help, Arguments& a, RawOptions& raw) {
  auto app = std::make_unique<CLI::App>(help.summary, std::string("quoin ") + help.name);
  app->formatter(std::make_shared<NarrowFormatter>());
  app->footer(std::string("\n") + help.examples);
  app->set_help_flag("-h,--help", "This text.");

  const bool many = a.command == Command::unite || a.command == Command::intersect || a.command == Command::subtract ||
                    a.command == Command::symmetric_difference;
  auto* inputs = app->add_option("FILES", a.inputs,
                                 many ? "Two operands or more; part.3mf#2 is the second object of part.3mf, or "
                                        "#NAME; without it all objects of a file, united."
                                 : a.command == Command::eval ? "The model."
                                                              : "The solid; part.3mf#2 is the second object of a "
                                                                "file, or #NAME; without it all objects, united.")
                     ->required();
  many ? inputs->expected(2, CLI::detail::expected_max_vector_size) : inputs->expected(1);

  if (a.command != Command::info && a.command != Command::check) {
    const bool two = a.command == Command::split;
    app->add_option("-o,--output", a.outputs, two ? "Files to write: ABOVE BELOW." : "File to write.")
        ->required()
        ->expected(two ? 2 : 1)
        // Without this a vector option would also take the operands behind it.
        ->allow_extra_args(false);
    app->add_option("--output-topology", raw.topology,
                    "manifold (default): every edge of the written mesh has two triangles, parts that only touch are "
                    "separated; indexed: vertices are shared wherever they coincide.");
    auto* valid =
        app->add_flag("--valid", raw.valid,
                      "What is written as triangles, read as exact numbers, bounds a solid without crossings: "
                      "where rounding spoils that, it is mended (default).");
    app->add_flag("--fast", raw.fast, "Write correctly rounded numbers, whatever becomes of thin parts.")
        ->excludes(valid);
    app->add_flag("--recentre", a.recentre,
                  "Subtract the rounded centre of the box from what is written as triangles, and say which.");
  }

  if (a.command == Command::move) {
    const auto motion = [&](const char* name, Words& words, int size, const char* what) {
      app->add_option(name, words, what)->type_size(size)->allow_extra_args(false);
    };
    motion("--rotate", raw.rotate, 2, "AXIS ANGLE: x, y, z or x,y,z; degrees, right-handed, about the origin.");
    motion("--translate", raw.translate, 3, "X Y Z in model units.");
    motion("--mirror", raw.mirror, 1, "AXIS: the mirror image in the plane through the origin with this normal.");
    motion("--scale", raw.scale, 1, "FACTOR, or X,Y,Z: from the origin; positive.");
  }

  if (a.command == Command::eval)
    app->add_flag("--any-path", a.any_path, "The model may name files outside its folder.");
  if (a.command == Command::eval)
    app->add_option("--set", raw.set, "NAME=VALUE: of a parameter of the model.")->allow_extra_args(false);
  if (a.command == Command::move || a.command == Command::eval)
    app->add_option("--rounding", raw.rounding,
                    "best (default), naive, continued-fraction, lattice, face-local, vertices: how planes that do not "
                    "fit the grid are rounded.");
  if (a.command == Command::split) {
    // An option of exactly one value takes the next word whatever it starts with: "-1,0,0,5" needs no "=".
    app->add_option("--plane", raw.plane, "a,b,c,d of a x + b y + c z + d = 0, model units.")->required();
  }

  app->add_option("--step", raw.step,
                  std::string("Grid step in model units, e.g. 1/1000 or 0.001; default: that of ") +
                      (a.command == Command::eval ? "the model, of the solids in it" : "the .quoin operands") +
                      ", or one that fits.");
  app->add_flag_callback(
      "--exact-grid", [&a] { a.grid_rule = GridRule::exact; },
      "Refuse what no grid holds exactly together with the rest; default: it is rounded, and max_snap says how far.");
  app->add_flag("--trust", a.trust,
                a.command == Command::check || a.command == Command::eval
                    ? "Changes nothing here: all is proved."
                    : "Skip the proof that no operand crosses itself.");
  app->add_option("--repair", raw.repair,
                  "NAME[=VALUE],...: cures for meshes that are open or inside out, each reported: weld=TOL, "
                  "t-junctions=TOL, duplicates, orient, orient=solid, caps, caps=SIZE, invert-shells; all: every one, "
                  "with tolerances taken from the mesh. `check` says which one is needed.");
  app->add_option("--format", raw.format,
                  format_names() +
                      ": what \"-\" is, and files without a known extension; also chooses among the formats of an "
                      "output's extension.");
  app->add_option("--unit", raw.unit,
                  unit_names() +
                      ": converts what states another unit, and is that of all other numbers; needed where operands "
                      "state different ones. What is written states it where the format can.");
  app->add_option("--limits", raw.limits,
                  "NAME=N,... or none: the most that is taken in of " + limit_list() + "; N may be none.");
  app->add_option("--threads", a.threads, "Worker threads; 0 (default): all. The result is the same for any number.")
      ->check(CLI::Range(0U, max_threads));
  app->add_flag("--json", a.json, "One JSON object on standard output, nothing else there.");
  app->add_flag("--stats", a.stats, "Also say how many signs each rung of the arithmetic decided.");
  app->add_flag("--quiet", a.quiet, "No summary, no progress and no warnings.");
  app->add_flag("--version", raw.version, "Version, commit, compiler, format version.");
  return app;
}

enum class Number { malformed, zero, other };

/// Removes leading digits from `text`; returns how many, and clears `zero` at the first that is not 0.
std::size_t take_digits(std::string_view& text, bool& zero) {
  std::size_t count = 0;
  for (; count < text.size() && text[count] >= '0' && text[count] <= '9'; ++count) zero = zero && text[count] == '0';
  text.remove_prefix(count);
  return count;
}

bool take(std::string_view& text, std::string_view any_of) {
  if (text.empty() || any_of.find(text[0]) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

/// "-0.5", ".5", "1e-3".
Number decimal_kind(std::string_view text) {
  bool zero = true;
  take(text, "+-");
  std::size_t count = take_digits(text, zero);
  if (take(text, ".")) count += take_digits(text, zero);
  if (count == 0) return Number::malformed;

  if (take(text, "eE")) {
    bool ignored = true;
    take(text, "+-");
    if (take_digits(text, ignored) == 0) return Number::malformed;
  }
  if (!text.empty()) return Number::malformed;
  return zero ? Number::zero : Number::other;
}

/// A decimal, or a quotient of two.
Number number_kind(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return decimal_kind(text);
  if (decimal_kind(text.substr(slash + 1)) != Number::other) return Number::malformed;
  return decimal_kind(text.substr(0, slash));
}

Result<HalfSpace> parse_plane(const std::string& text) {
  HalfSpace plane;
  std::size_t begin = 0;
  bool normal = false;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t comma = text.find(',', begin);
    if ((comma == std::string::npos) != (i == 3)) return usage("--plane needs four numbers a,b,c,d");
    plane.plane[i] = text.substr(begin, i == 3 ? std::string::npos : comma - begin);
    begin = comma + 1;
    const Number kind = number_kind(plane.plane[i]);
    if (kind == Number::malformed) {
      return usage("--plane: \"" + plane.plane[i] + "\" is neither a decimal nor a rational p/q");
    }
    if (i < 3 && kind == Number::other) normal = true;
  }

  if (!normal) return usage("--plane: one of a, b, c must differ from 0");
  return plane;
}

/// "x", "y", "z" or three numbers.
Result<Text3> parse_vector(const char* option, const std::string& text) {
  if (text == "x") return Text3{"1", "0", "0"};
  if (text == "y") return Text3{"0", "1", "0"};
  if (text == "z") return Text3{"0", "0", "1"};
  const auto first = text.find(','), second = text.find(',', first + 1);
  if (first == std::string::npos || second == std::string::npos || text.find(',', second + 1) != std::string::npos)
    return usage(std::string(option) + ": \"" + text + "\" is neither x, y, z nor three numbers x,y,z");
  return Text3{text.substr(0, first), text.substr(first + 1, second - first - 1), text.substr(second + 1)};
}

/// The motion that the options say, in their order.
Result<Motion> read_motion(const RawOptions& raw) {
  Motion motion;
  std::size_t rotations = 0, translations = 0, mirrors = 0, scalings = 0;
  for (const std::string& option : raw.order) {
    Result<Motion> next = motion;
    if (option == "--rotate") {
      const auto axis = parse_vector("--rotate", raw.rotate[rotations]);
      if (!axis) return axis.error();
      next = Motion::rotation(axis.value(), raw.rotate[rotations + 1]);
      rotations += 2;
    } else if (option == "--translate") {
      const std::string* by = &raw.translate[translations];
      next = Motion::translation({by[0], by[1], by[2]});
      translations += 3;
    } else if (option == "--mirror") {
      const auto normal = parse_vector("--mirror", raw.mirror[mirrors++]);
      if (!normal) return normal.error();
      next = Motion::mirror(normal.value());
    } else {
      const std::string& text = raw.scale[scalings++];
      const auto by = text.find(',') == std::string::npos ? Text3{text, text, text} : parse_vector("--scale", text);
      if (!by) return by.error();
      next = Motion::scaling(by.value());
    }

    if (!next) return usage(option + ": " + next.error().message);
    motion = motion.then(next.value());
  }

  if (raw.order.empty()) return usage("move needs a motion: --rotate, --translate, --mirror or --scale");
  return motion;
}

/// "none", or "sides=1000,bytes=none".
Result<Limits> parse_limits(std::string_view text) {
  constexpr std::uint64_t any = std::numeric_limits<std::uint64_t>::max();
  if (text == "none") return Limits::none();

  Limits limits;
  for (bool more = true; more;) {
    const std::size_t comma = text.find(',');
    const std::string_view item = text.substr(0, comma);
    more = comma != std::string_view::npos;
    text.remove_prefix(more ? comma + 1 : text.size());

    const std::string_view name = item.substr(0, item.find('='));
    const auto* limit =
        std::find_if(limit_names.begin(), limit_names.end(), [&](const auto& known) { return known.first == name; });
    if (limit == limit_names.end() || name.size() == item.size())
      return usage("--limits wants none or NAME=N,... of " + limit_list() + ", not \"" + std::string(item) + "\"");

    const std::string_view value = item.substr(name.size() + 1);
    std::uint64_t number = any;
    const auto [end, fault] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (value != "none" && (fault != std::errc() || end != value.data() + value.size()))
      return usage("--limits: \"" + std::string(value) + "\" is neither a whole number nor none");
    limits.*limit->second = value == "none" ? any : number;
  }
  return limits;
}

Result<void> read_values(const RawOptions& raw, Arguments& a) {
  if (raw.limits) {
    const auto limits = parse_limits(*raw.limits);
    if (!limits) return limits.error();
    a.limits = limits.value();
  }
  if (raw.rounding) {
    const auto* found =
        std::find_if(roundings.begin(), roundings.end(), [&](const auto& r) { return r.first == *raw.rounding; });
    if (found == roundings.end()) {
      return usage("--rounding must be " + rounding_names() + ", not \"" + *raw.rounding + "\"");
    }
    a.rounding = found->second;
    a.rounding_name = *raw.rounding;
  }

  for (const std::string& text : raw.set) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0) return usage("--set wants NAME=VALUE, not \"" + text + "\"");
    a.parameters[text.substr(0, equals)] = text.substr(equals + 1);
  }

  if (a.command == Command::move) {
    const auto motion = read_motion(raw);
    if (!motion) return motion.error();
    a.motion = motion.value();
  }

  if (raw.format) {
    a.format = format_called(*raw.format);
    if (!a.format) return usage("--format must be " + format_names() + ", not \"" + *raw.format + "\"");
  }
  if (raw.repair) {
    const auto repair = Repair::parse(*raw.repair);
    if (!repair) return usage("--repair: " + repair.error().message);
    a.repair = repair.value();
  }
  if (raw.unit) {
    a.unit = unit_called(*raw.unit);
    if (!a.unit) return usage("--unit must be " + unit_names() + ", not \"" + *raw.unit + "\"");
  }
  if (raw.topology) {
    if (*raw.topology != "manifold" && *raw.topology != "indexed") {
      return usage("--output-topology must be manifold or indexed, not \"" + *raw.topology + "\"");
    }
    a.topology = *raw.topology == "manifold" ? Topology::manifold : Topology::indexed;
  }
  if (raw.fast) a.validity = Validity::fast;

  if (raw.step) {
    const auto grid = Grid::with_step(*raw.step);
    if (!grid) return usage("--step: " + grid.error().message);
    a.grid = grid.value();
  }

  if (a.command != Command::split) return {};
  const auto plane = parse_plane(raw.plane);
  if (!plane) return plane.error();
  a.plane = plane.value();
  return {};
}

/// What a path names once it is written: links are followed, also to what does not exist yet.
std::filesystem::path destination(std::filesystem::path path) {
  std::error_code ignored, missing;
  // As many links as systems follow.
  for (int links = 0; links < 40 && std::filesystem::is_symlink(path, ignored); ++links) {
    const std::filesystem::path target = std::filesystem::read_symlink(path, ignored);
    path = path.parent_path() / target;
  }

  const std::filesystem::path folder = std::filesystem::canonical(path.parent_path() / ".", missing);
  return missing ? path.lexically_normal() : folder / path.filename();
}

/// Whether two outputs name one file. Hard links do, though writing would part them: one of the two solids is not what
/// their reader expects.
bool same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  if (a == b || std::filesystem::equivalent(a, b, ignored)) return true;
  return a != "-" && b != "-" && destination(a) == destination(b);
}

/// What no single option can see.
Result<void> check_streams(const Arguments& a) {
  const auto from_stdin =
      std::count_if(a.inputs.begin(), a.inputs.end(), [](const std::string& path) { return file_of(path) == "-"; });
  if (from_stdin > 1) return usage("standard input can be read once only");
  // A model is always JSON.
  const bool unnamed_input = from_stdin > 0 && a.command != Command::eval;
  if ((unnamed_input || a.writes_to_stdout()) && !a.format) return usage("\"-\" needs --format");
  if (a.json && a.writes_to_stdout()) return usage("--json and \"-o -\" cannot share standard output");
  if (a.outputs.size() == 2 && same_file(a.outputs[0], a.outputs[1])) return usage("the two outputs are one file");

  const auto empty = [](const std::string& path) { return path.empty(); };
  if (std::any_of(a.inputs.begin(), a.inputs.end(), empty) || std::any_of(a.outputs.begin(), a.outputs.end(), empty)) {
    return usage("a file name is empty");
  }
  return {};
}

Error unknown_command(const std::string& name) {
  std::string message = "there is no command \"" + name + "\"";
  if (const auto* help = closest_command(name)) message += std::string(", perhaps ") + help->name + " is meant";
  return usage(message + "; see quoin --help");
}

}  // namespace

bool Arguments::writes_to_stdout() const { return std::find(outputs.begin(), outputs.end(), "-") != outputs.end(); }

Result<Format> Arguments::output_format(const std::string& path) const {
  const auto named = path == "-" ? Result<Format>(*format) : format_of(path);
  if (!named) {
    if (format) return *format;
    Error error = named.error();
    error.file = path;
    return error;
  }
  if (format && info_of(*format).extension == info_of(named.value()).extension) return *format;
  return named;
}

std::optional<Format> Arguments::input_format(const std::string& path) const {
  if (format_of(file_of(path))) return {};
  return format;
}

bool json_wanted(const std::vector<std::string>& words) {
  const auto end = std::find(words.begin(), words.end(), "--");
  return std::find(words.begin(), end, "--json") != end;
}

Result<std::variant<Arguments, Answer>> parse_arguments(std::vector<std::string> words) {
  using Parsed = std::variant<Arguments, Answer>;
  const bool json = json_wanted(words);
  const std::size_t leading = move_leading_options(words);
  if (leading >= words.size()) {
    if (answered(words, "--help", "-h")) return Parsed(Answer{general_help()});
    if (answered(words, "--version", "--version")) return Parsed(Answer{version_text(json)});
    return usage(words.empty() ? "a command is missing; see quoin --help"
                               : "a command is missing after \"" + words.back() + "\"; see quoin --help");
  }

  const CommandHelp* help = find_command(words[0]);
  if (help == nullptr) return unknown_command(words[0]);
  Arguments arguments;
  arguments.command = help->command;
  arguments.name = help->name;
  RawOptions raw;
  const auto app = make_app(*help, arguments, raw);

  words.erase(words.begin());
  const auto dashes = std::find(words.begin(), words.end(), "--");
  if (std::find(words.begin(), dashes, "--version") != dashes) return Parsed(Answer{version_text(json)});
  // CLI11 takes the words last first.
  std::reverse(words.begin(), words.end());
  try {
    app->parse(std::move(words));
  } catch (const CLI::CallForHelp&) {
    return Parsed(Answer{app->help()});
  } catch (const CLI::ParseError& error) {
    return usage(std::string(help->name) + ": " + error.what() + "; see quoin " + help->name + " --help");
  }

  // The parser lists an option once for each of its values.
  std::map<std::string, int> values;
  for (const CLI::Option* option : app->parse_order()) {
    const std::string name = option->get_name();
    const bool moves = name == "--rotate" || name == "--translate" || name == "--mirror" || name == "--scale";
    if (moves && values[name]++ % option->get_type_size() == 0) raw.order.push_back(name);
  }

  if (const auto read = read_values(raw, arguments); !read) return read.error();
  if (const auto checked = check_streams(arguments); !checked) return checked.error();
  return Parsed(std::move(arguments));
}

}  // namespace quoin::cli
