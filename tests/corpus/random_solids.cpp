#include <array>

#include "tests/booleans/support.h"
#include "tests/corpus/folder.h"

namespace quoin::corpus {
namespace {

namespace shapes = booleans::testing;
using shapes::Family;

constexpr std::size_t cases = 10;

/// A plane of small integers through a vertex of the body; one time in three it is half a step away.
std::string plane_near(shapes::Random& random, const booleans::Body& body) {
  const auto points = shapes::points_of(body);
  const shapes::Vector p = points[random.below(points.size())];
  shapes::Vector n{};
  while (n == shapes::Vector{}) n = random.vector(-3, 3);
  const std::int64_t twice = -2 * (n[0] * p[0] + n[1] * p[1] + n[2] * p[2]) + (random.one_in(3) ? 1 : 0);
  return std::to_string(n[0]) + "," + std::to_string(n[1]) + "," + std::to_string(n[2]) + "," + std::to_string(twice) +
         "/2";
}

/// Parts of either orientation in one mesh; a part more stands in a corner of its own where there is room for it.
void add_soups(Folder& folder, const std::string& name, const std::array<booleans::Body, 3>& parts) {
  folder.operation(name + "-soup", "convert " + folder.body(name + "-soup", shapes::merged(parts)) + " --step 1");
  const std::array mixed{parts[0], shapes::inside_out(parts[1]), parts[2], shapes::box({5000, 0, 0}, {5003, 9, 9})};
  const std::string file = folder.body(name + "-mixed", shapes::merged(mixed));
  folder.operation(name + "-mixed", "convert " + file + " --step 1");
}

void add_case(Folder& folder, Family family, std::size_t number) {
  const std::string name = std::string(shapes::name_of(family)) + "-" + numbered(number);
  shapes::Random random(0xC0A9 + static_cast<std::uint64_t>(family), number);
  shapes::Solids solids(random, family);
  const std::array parts{solids.raw(), solids.raw(), solids.raw()};
  const std::string a = folder.body(name + "-a", parts[0]), b = folder.body(name + "-b", parts[1]),
                    c = folder.body(name + "-c", parts[2]), step = " --step 1";

  const std::string either = folder.operation(name + "-union", "union " + a + " " + b + step);
  folder.operation(name + "-intersection", "intersection " + a + " " + b + step);
  const std::string less = folder.operation(name + "-difference", "difference " + a + " " + b + " " + c + step);
  const std::string odd = folder.operation(name + "-odd", "symmetric-difference " + a + " " + b + " " + c + step);

  // Chains.
  const std::string outside = folder.operation(name + "-complement", "complement " + either);
  folder.operation(name + "-outside", "intersection " + outside + " " + c);
  const std::string carved = folder.operation(name + "-carved", "difference " + either + " " + c);
  folder.operation(name + "-again", "symmetric-difference " + carved + " " + odd + " " + less);
  const std::string above = "@" + name + "-above.quoin", below = "@" + name + "-below.quoin";
  folder.operation(name + "-split",
                   "split " + either + " --plane " + plane_near(random, parts[0]) + " -o " + above + " " + below);
  folder.operation(name + "-whole", "union " + above + " " + below);

  add_soups(folder, name, parts);
}

}  // namespace

void add_random_solids(Folder& folder) {
  for (const Family family : shapes::families)
    for (std::size_t number = 0; number < cases; ++number) add_case(folder, family, number);
}

}  // namespace quoin::corpus
