#include "help.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <string_view>
#include <vector>

#include <quoin/format.h>
#include <quoin/version.h>
#include <nlohmann/json.hpp>

namespace quoin::cli {
namespace {

constexpr std::array<CommandHelp, 11> commands = {{
    {Command::unite, "union", "All points that lie in A or B or any further operand.",
     R"(Examples:
  quoin union body.stl handle.stl -o part.stl
  quoin union part-*.obj -o assembly.quoin        any number of parts is one operation
  quoin union A.stl B.stl -o - --format off | viewer)"},
    {Command::intersect, "intersection", "All points that lie in every operand.",
     R"(Examples:
  quoin intersection a.off b.off -o common.off
  quoin intersection case.stl board.stl -o clash.stl --json     volume "0": they do not collide)"},
    {Command::subtract, "difference", "The first operand minus all the others.",
     R"(Examples:
  quoin difference plate.stl drill1.stl drill2.stl -o plate-drilled.stl
  quoin difference mould.obj part.obj -o cavity.quoin --step 1/1000)"},
    {Command::symmetric_difference, "symmetric-difference", "All points that lie in an odd number of operands.",
     R"(Examples:
  quoin symmetric-difference old.stl new.stl -o changes.stl
  quoin symmetric-difference a.quoin b.quoin -o d.quoin --json  volume "0": the same solid)"},
    {Command::complement, "complement", "Everything that A is not.",
     R"(The complement of a bounded solid is unbounded. A .quoin file can hold it; triangle formats refuse to.
Examples:
  quoin complement part.stl -o outside.quoin
  quoin complement outside.quoin -o part.stl)"},
    {Command::split, "split", "Cuts A along a plane into the part above and the part below.",
     R"(ABOVE is where a x + b y + c z + d > 0. Coefficients are decimals or rationals, in the units of the model.
Examples:
  quoin split part.stl --plane 0,0,1,-5 -o upper.stl lower.stl       cut at z = 5
  quoin split part.stl --plane -1,0,0,1/3 -o left.quoin right.quoin  above is x < 1/3)"},
    {Command::move, "move", "Rotates, translates, mirrors or scales A.",
     R"(Motions act in the order given and compose exactly; each may be repeated. Angles are degrees: multiples of 90 about
x, y, z are exact, others are replaced by a rational rotation closer than 10^-25 degrees, and --json says which.
Flat faces stay flat where every corner lies on three planes; other solids are rounded corner by corner to the grid.
A is moved on its own grid: choose a larger --step, or translate it back, if it would leave it.
Examples:
  quoin move part.stl --rotate z 30 --translate 1 2 3 -o moved.stl
  quoin move part.quoin --rotate 1,1,0 12.5 -o turned.quoin --json
  quoin move part.stl --mirror x -o left.stl)"},
    {Command::eval, "eval", "Evaluates a model: primitives, motions and Booleans in a JSON file.",
     R"(The format is described in docs/model-format.md. All motions above a primitive act at once, and it is rounded once.
eval always proves that no mesh or solid of the model crosses itself: --trust changes nothing.
A model may name files in its folder and below; --any-path lets it name others. --repair cures each mesh among them.
Examples:
  quoin eval bracket.json -o bracket.stl
  quoin eval gearbox.json --set width=120 --set holes=6 -o gearbox.quoin --json)"},
    {Command::info, "info", "Prints counts and exact measures of A.",
     R"(Counts are of the solid (its maximal faces, their edges and corners), not of the triangles in the file.
Volume is in cubic units of the model: the nearest decimal, then the exact number, of which --json prints every digit.
Examples:
  quoin info part.stl
  quoin info part.quoin --json
  quoin info - --format stl < part.stl)"},
    {Command::check, "check", "Says whether A is a valid solid, and what import did to it.",
     R"(Exit code 0: valid; 1: refused, and the error says why and where. --quiet prints nothing but that error.
Of a mesh that is open or inside out it lists what is wrong, where, and the --repair that cures it.
check always proves that the surface does not cross itself: --trust changes nothing.
Examples:
  quoin check scan.ply
  quoin check part.stl --quiet && echo fine)"},
    {Command::convert, "convert", "Reads A and writes it in another format.",
     R"(To .quoin nothing but the snap to the grid is lost; triangle formats round coordinates, and report what that did.
Examples:
  quoin convert part.stl -o part.quoin
  quoin convert part.quoin -o part.stl --format stl-ascii
  quoin convert part.3mf#2 -o lid.stl
  quoin convert part.3mf -o part.glb --unit m
  quoin convert - -o - --format obj < a.obj > b.obj)"},
}};

// Levenshtein's distance.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

}  // namespace

const CommandHelp* find_command(const std::string& name) {
  const auto found = std::find_if(commands.begin(), commands.end(), [&](const auto& c) { return c.name == name; });
  return found == commands.end() ? nullptr : &*found;
}

const CommandHelp* closest_command(const std::string& name) {
  // Longer words than any command's are not worth comparing.
  if (name.size() > 32) return nullptr;
  const auto* best = std::min_element(commands.begin(), commands.end(), [&](const auto& a, const auto& b) {
    return distance(name, a.name) < distance(name, b.name);
  });
  return distance(name, best->name) <= 3 ? best : nullptr;
}

namespace {

/// The extensions of exact or of other formats, each once: ".stl .obj"
std::string extensions(bool exact) {
  std::vector<std::string_view> found;
  for (const FormatInfo& info : formats())
    if (info.is_exact == exact && std::find(found.begin(), found.end(), info.extension) == found.end())
      found.push_back(info.extension);

  std::string text;
  for (const std::string_view extension : found) text.append(text.empty() ? "" : " ").append(extension);
  return text;
}

}  // namespace

std::string general_help() {
  std::string text =
      "quoin: exact Boolean operations on solids bounded by plane faces\n\n"
      "Usage: quoin COMMAND FILES... [OPTIONS]\n\n"
      "Commands:\n";
  for (const auto& command : commands) {
    std::string line = std::string("  ") + command.name;
    line.resize(24, ' ');
    text += line + command.summary + "\n";
  }
  text += "\nEvery command explains itself: quoin COMMAND --help\n\nFiles: " + extensions(false) +
          " are triangle or polygon meshes;\n  " + extensions(true) + " is the exact solid, without any loss.\n";
  text += R"(  Content decides the format where it can, then the extension.
  "-" is standard input or output; --format then says what flows through it.
  An output file appears whole or not at all. One that exists keeps its owner, permissions and links.
  A file may hold several objects: part.3mf#2 is the second one (a build item of 3MF, a node with a mesh of glTF),
  part.3mf#lid the one of that name. Without "#" an operand is all objects of the file, united: the default.

Units: Quoin takes numbers as they are ("model units", often millimetres) and never scales silently. A unit that a file
  states (3MF, AMF; glTF is in metres) is shown and written again where the format can. Operands that state different
  units, and meshes of one model, are refused, unless --unit says what to convert to; those that state none are taken to
  be in it, and so are the numbers of a model.
  Volumes are in cubic model units.

Grid: points of meshes are snapped to a common grid, and everything after that is exact. The default step is a power
  of two at which all inputs fit +-2^26 steps; --step 1/1000 makes decimals with three places exact.
  The largest move is reported as max_snap. A .quoin operand brings its grid along, which --step replaces where that is
  exact. Of several grids a common one is found, exact where any is; else the operands that do not fit are rounded,
  once, and reported; --exact-grid refuses instead.

Meshes must be closed and not inside out; a refusal names the place, what is wrong there and its cure: `check` lists
  all of it, --repair cures it. What a file holds besides faces is passed over, a line each on stderr. A warning names a
  body that is inside out among others, since nothing is left of it; --quiet suppresses it.

Triangles are written valid: read as exact numbers they bound a solid without crossings. Numbers are correctly rounded;
  where that spoils thin parts the mesh is mended, and counted. --fast leaves it as rounded. A warning says when
  rounding moves points by more than the shortest edge; --recentre writes the mesh about the origin.
Input that asks for more than memory should give is refused (too-large), naming the limit; --limits raises it.

Examples:
  quoin union body.stl handle.stl -o part.stl
  quoin difference plate.stl drill.stl -o plate-drilled.quoin --step 1/1000
  quoin split part.stl --plane 0,0,1,-5 -o upper.stl lower.stl
  quoin info part.stl --json

Exit codes: 0 done; 1 refused (the error says why, and where); 2 wrong arguments; 3 a defect of quoin; 130 interrupted.
)";
  return text;
}

std::string version_text(bool json) {
  if (json) {
    nlohmann::ordered_json object;
    object["version"] = QUOIN_VERSION_STRING;
    object["commit"] = commit();
    object["compiler"] = compiler();
    object["format_version"] = format_version();
    return object.dump() + "\n";
  }
  return std::string("quoin ") + QUOIN_VERSION_STRING + "\ncommit " + commit() + "\ncompiler " + compiler() +
         "\n.quoin format " + std::to_string(format_version()) + "\n";
}

}  // namespace quoin::cli
