/// \file
/// Laws that hold for every Boolean expression over every solid, checked on scripts.
#include <map>

#include "booleans/boolean.h"
#include "booleans/canonical.h"
#include "booleans/embedding.h"
#include "booleans/export.h"
#include "booleans/measure.h"
#include "booleans/query.h"
#include "fuzz/law.h"
#include "fuzz/script.h"

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
    std::array<std::array<exact::Rational, 3>, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      const exact::Point u = body.point(mesh.source[t[i]]);
      for (int k = 0; k < 3; ++k) p[i][static_cast<std::size_t>(k)] = exact::coordinate(u, k);
    }
    const auto minor = [&](std::size_t i, std::size_t j) { return p[1][i] * p[2][j] - p[1][j] * p[2][i]; };
    six += p[0][0] * minor(1, 2) + p[0][1] * minor(2, 0) + p[0][2] * minor(0, 1);
  }
  return six / 6;
}

void check_mesh(const Body& body) {
  const Triangulated whole = triangulated(body), apart = separated(body, whole);
  std::map<std::array<std::uint32_t, 2>, int> balance, uses, use;  // uses: by body vertices; use: by output vertices
  const auto for_edges = [](const Triangulated& mesh, auto visit) {
    for (std::size_t n = 0; n < mesh.triangle_count(); ++n)
      for (std::size_t k = 0; k < 3; ++k) visit(mesh.triangle(n)[k], mesh.triangle(n)[(k + 1) % 3]);
  };
  for_edges(whole, [&](std::uint32_t u, std::uint32_t v) {
    balance[{std::min(u, v), std::max(u, v)}] += u < v ? 1 : -1;
  });
  for_edges(whole, [&](std::uint32_t u, std::uint32_t v) { ++uses[{whole.source[u], whole.source[v]}]; });
  for (const auto& [edge, sum] : balance) require(sum == 0, "triangulations are closed");
  for_edges(apart, [&](std::uint32_t u, std::uint32_t v) { ++use[{u, v}]; });
  for (const auto& [edge, count] : use) {
    require(edge[0] != edge[1], "triangles have three corners");
    const auto reverse = use.find({edge[1], edge[0]});
    require(reverse != use.end() && reverse->second == count, "a separated mesh is closed");
    // Two wedges at one edge that hang together around both its ends keep two edges between the same two vertices.
    const auto touching = uses.find({apart.source[edge[0]], apart.source[edge[1]]});
    require(count == 1 || touching->second > 1, "a separated mesh has two triangles at every edge that is no contact");
  }
  require(mesh_volume(body, whole) == volume(body), "a triangulation keeps the volume");
  require(mesh_volume(body, apart) == volume(body), "a separated mesh keeps the volume");
  require(shells(apart).genus >= 0, "shells have no negative genus");
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

void run(std::span<const std::uint8_t> bytes) {
  const Script s = script(bytes);
  std::vector<const Body*> operands;
  for (const Body& b : s.operands) operands.push_back(&b);
  const Body at_once = checked(evaluate(operands, s.expression));
  const Body stepwise = pairwise(s, 0);
  require(canonical(at_once) == canonical(stepwise), "all at once and one by one give one solid");
  check_result(at_once);
  check_resolve(s);
  check_volumes(s.operands.front(), s.operands.back());
}

}  // namespace
}  // namespace quoin::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  quoin::fuzz::run({data, size});
  return 0;
}
