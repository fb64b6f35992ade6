/// \file
/// Laws that hold for every Boolean expression over every solid, checked on scripts.
#include <map>
#include <utility>

#include "booleans/body/canonical.h"
#include "booleans/body/fault.h"
#include "booleans/body/measure.h"
#include "booleans/boolean.h"
#include "booleans/embedding.h"
#include "booleans/resolve.h"
#include "booleans/surface/separated.h"
#include "booleans/surface/shells.h"
#include "fuzz/law.h"
#include "fuzz/script.h"
#include "tests/booleans/lattice_sets.h"
#include "tests/booleans/surface/position.h"
#include "tests/grid/with_thresholds.h"

namespace quoin::fuzz {
namespace {

using namespace booleans;

Body checked(Result<Body> result) {
  if (!result) fail("operations succeed:", result.error().message);
  Body body = std::move(result).value();
  if (const auto message = fault(body)) fail("results are without fault:", *message);
  return body;
}
Body combined(Rule rule, const Body& a, const Body& b, std::uint32_t negated_from = none) {
  const std::array<const Body*, 2> operands{&a, &b};
  return checked(evaluate(operands, Expression::flat(rule, 2, negated_from)));
}

/// The subtree at a node, one operation of two bodies after another.
Body pairwise(const Script& s, std::uint32_t node) {
  const auto& nodes = s.expression.nodes;
  std::optional<Body> value;
  if (nodes[node].rule == Rule::operand) value = s.operands[nodes[node].operand];
  for (std::uint32_t child = node + 1; child < nodes.size(); ++child) {
    if (nodes[child].parent != node) continue;
    const Body next = pairwise(s, child);
    value = value ? combined(nodes[node].rule, *value, next) : next;
  }
  return nodes[node].negated ? complement(*value) : *value;
}

/// The mesh's exact volume, through its own triangles.
exact::Rational mesh_volume(const Body& body, const Triangulated& mesh) {
  exact::Rational six = 0;
  for (std::size_t n = 0; n < mesh.triangle_count(); ++n) {
    const auto t = mesh.triangle(n);
    std::array<RationalPoint, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = testing::position(body, mesh, t[i]);
    const auto minor = [&](std::size_t i, std::size_t j) { return p[1][i] * p[2][j] - p[1][j] * p[2][i]; };
    six += p[0][0] * minor(1, 2) + p[0][1] * minor(2, 0) + p[0][2] * minor(0, 1);
  }
  return six / 6;
}

/// How often each directed edge occurs.
std::map<std::array<std::uint32_t, 2>, int> edge_uses(const Triangulated& mesh) {
  std::map<std::array<std::uint32_t, 2>, int> uses;
  for (std::size_t n = 0; n < mesh.triangle_count(); ++n) {
    const auto t = mesh.triangle(n);
    for (std::size_t k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
  }
  return uses;
}

/// Components and sum of genera of what export writes.
std::array<std::int64_t, 2> topology(const Body& body) {
  const Shells s = shells(separated(body, triangulated(body)));
  return {static_cast<std::int64_t>(s.count), s.genus};
}

void check_mesh(const Body& body) {
  const Triangulated whole = triangulated(body), apart = separated(body, whole);

  const auto together = edge_uses(whole), uses = edge_uses(apart);
  for (const auto& [edge, count] : together) {
    const auto reverse = together.find({edge[1], edge[0]});
    require(reverse != together.end() && reverse->second == count, "triangulations are closed");
  }
  for (const auto& [edge, count] : uses) {
    require(edge[0] != edge[1], "triangles have three corners");
    require(count == 1 && uses.count({edge[1], edge[0]}) == 1, "a separated mesh has two triangles at every edge");
  }

  require(mesh_volume(body, whole) == volume(body), "a triangulation keeps the volume");
  require(mesh_volume(body, apart) == volume(body), "a separated mesh keeps the volume");
  require(shells(apart).genus >= 0, "shells have no negative genus");
}

/// The bytes as a set of tetrahedra that touch wherever they can.
void check_lattice_set(std::span<const std::uint8_t> bytes) {
  std::size_t at = 0;
  const auto set =
      testing::lattice_set([&](std::uint64_t n) { return (at < bytes.size() ? bytes[at++] : std::uint8_t{0}) % n; });
  const Body body = testing::boundary(set, 1);
  if (body.triangles.empty()) return;
  check_mesh(body);

  const testing::SeparatedTopology counted = testing::separated_topology(set);
  require(topology(body) == std::array{static_cast<std::int64_t>(counted.shells), counted.genus},
          "shells and genus are those that counting gives");
}

void check_result(const Body& body) {
  const Canonical form = canonical(body);
  const Body again = body_of(form);
  if (const auto message = fault(again)) fail("canonical bodies are without fault:", *message);
  require(canonical(again) == form, "the canonical form is its own");
  if (const auto message = embedding_fault(again)) fail("results are clean:", *message);
  require(volume(again) == volume(body), "the canonical form keeps the volume");
  require(canonical(complement(complement(body))) == form, "two complements are none");
  require(combined(Rule::odd, body, again).face_count() == 0, "a body and its canonical form differ nowhere");
  check_mesh(body);
  require(topology(body) == topology(again), "shells and genus are of the point set");
}

void check_volumes(const Body& a, const Body& b) {
  const Body any = combined(Rule::any, a, b), all = combined(Rule::all, a, b), rest = combined(Rule::all, a, b, 1);
  require(volume(a) + volume(b) == volume(any) + volume(all), "volumes of union and intersection add up");
  require(volume(rest) + volume(all) == volume(a), "volumes of difference and intersection add up");
  require(canonical(combined(Rule::any, rest, all)) == canonical(a), "difference and intersection make the whole");
}

/// All operands as one mesh: winding numbers add, and > 0 is the union.
void check_resolve(const Script& s) {
  const Body mesh = testing::merged(s.operands);
  std::vector<const Body*> operands;
  for (const Body& b : s.operands) operands.push_back(&b);
  std::uint64_t crossings = 0;
  const Body resolved = checked(resolve(mesh, crossings));
  const Body all =
      checked(evaluate(operands, Expression::flat(Rule::any, static_cast<std::uint32_t>(operands.size()))));
  require(canonical(resolved) == canonical(all), "one mesh of all operands resolves to their union");
}

/// make(), a body, by any thresholds: its canonical form.
template <class Make>
Canonical form_by_any_way(Make make) {
  const auto made = [&](const grid::Thresholds& t) {
    const grid::testing::WithThresholds thresholds(t);
    return canonical(checked(make()));
  };
  const Canonical form = made(grid::Thresholds::smallest());
  require(form == made(grid::Thresholds::largest()) && form == made(grid::Thresholds::patched()),
          "no threshold changes a result");
  return form;
}

/// Flat regions that cover their plane more than once.
void check_folded_sheet(std::span<const std::uint8_t> bytes) {
  std::size_t at = 0;
  const auto between = [&](std::int64_t low, std::int64_t high) {
    const std::int64_t b = at < bytes.size() ? bytes[at++] : 0;
    return low + b % (high - low + 1);
  };
  const auto n = static_cast<std::uint32_t>(between(1, 6));
  const std::int64_t reach = between(1, 8);
  const auto mesh = testing::folded_sheet(between, n, reach);
  if (!mesh) return;
  form_by_any_way([&] {
    std::uint64_t crossings = 0;
    return resolve(*mesh, crossings);
  });
}

void run(std::span<const std::uint8_t> bytes) {
  check_folded_sheet(bytes);

  const Script s = script(bytes);
  std::vector<const Body*> operands;
  for (const Body& b : s.operands) operands.push_back(&b);
  const Body at_once = checked(evaluate(operands, s.expression));
  require(canonical(at_once) == form_by_any_way([&] { return evaluate(operands, s.expression); }),
          "no threshold changes a result");
  const Body stepwise = pairwise(s, 0);
  require(canonical(at_once) == canonical(stepwise), "all at once and one by one give one solid");
  check_result(at_once);
  check_resolve(s);
  check_volumes(s.operands.front(), s.operands.back());
  check_lattice_set(bytes);
}

}  // namespace
}  // namespace quoin::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  quoin::fuzz::run({data, size});
  return 0;
}
