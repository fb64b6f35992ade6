/// \file
/// What is written is valid and near, for every script of a Boolean, on grids whose numbers rounding spoils.
#include "api/access.h"
#include "booleans/boolean.h"
#include "fuzz/law.h"
#include "fuzz/script.h"
#include "quoin/quoin.h"
#include "tests/api/exact_mesh.h"

namespace quoin::fuzz {
namespace {

/// A step, and an origin that may lie far away.
grid::Lattice lattice_of(std::uint8_t byte) {
  grid::Lattice lattice;
  lattice.step = std::array<exact::Rational, 4>{1, exact::Rational(1, 3), exact::Rational(1, 1000),
                                                exact::Rational(1, 1024)}[byte % 4];
  const exact::Rational far(std::int64_t{1} << (byte / 8), 3);
  if ((byte & 4) != 0) lattice.origin = {far, -far / 7, far / 5};
  return lattice;
}

void check_export(const Solid& solid, const ExportOptions& options, const Mesh& exact) {
  ExportReport report;
  const auto mesh = solid.to_triangles(options, &report);
  require(static_cast<bool>(mesh), "bounded solids are written");
  const std::string fault = exact_mesh::fault(mesh.value());
  require(fault.empty(), "what is written is valid:", fault);
  require(report.valid && report.closed && report.flipped + report.collapsed == 0, "and the report says so");
  // The distance is measured in doubles.
  require(exact_mesh::farthest(mesh.value(), exact) <= report.max_round * (1 + 0x1p-20) + 0x1p-20,
          "nothing is farther away than the bound");
}

}  // namespace
}  // namespace quoin::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace quoin;
  if (size < 2) return 0;
  fuzz::Script script = fuzz::ScriptReader({data + 1, size - 1}).read();
  std::vector<const booleans::Body*> operands;
  for (const auto& body : script.operands) operands.push_back(&body);
  auto body = booleans::evaluate(operands, script.expression);
  if (!body || body.value().full_at_infinity) return 0;

  const Solid solid = Access::solid(Access::grid(fuzz::lattice_of(data[0])), std::move(body).value());
  const Mesh exact = solid.to_triangles({.topology = Topology::indexed, .validity = Validity::fast}).value();
  for (const bool float32 : {false, true})
    for (const Topology topology : {Topology::manifold, Topology::indexed})
      fuzz::check_export(solid, {.topology = topology, .float32 = float32}, exact);
  return 0;
}
