#include "booleans/arrangement/uses.h"

#include <tuple>

#include "grid/lists/buckets.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {
namespace {

/// Order of uses with the same lower vertex.
bool comes_before(const Use& x, const Use& y) {
  return std::tie(x.high, x.node, x.left, x.plane) < std::tie(y.high, y.node, y.left, y.plane);
}

void add_facets(const Sheets& sheets, std::vector<Use>& uses) {
  for (const SheetId s : sheets.ids()) {
    const Sheet& sheet = sheets[s];
    for (std::uint32_t h = 0; h < sheet.half_edges(); ++h) {
      if (sheet.facet[h] == none) continue;
      const VertexId u = sheet.origin(h), v = sheet.target(h);
      uses.push_back({std::min(u, v), std::max(u, v), sheets.node(s, sheet.facet[h]), sheet.plane,
                      sheet.elements[h / 2].line, sheets.element(s, h / 2), u < v, false});
    }
  }
}

/// An untouched face at its directed edge.
Use use_of_patch(const Operands& operands, const Patches& patches, FaceId face, VertexId from, VertexId to,
                 PlaneTable& planes) {
  const OwnFace own = operands.own(face);
  const exact::Plane plane = operands[own.operand].plane(own.face);
  const bool turned = !exact::is_canonical(plane);
  // Left of from -> to seen from the outward normal; turning the view or the edge swaps the sides.
  const bool left = (from < to) != turned;
  return {std::min(from, to), std::max(from, to), patches.of[face], planes.id(plane), none, none, left, turned};
}

/// By lower vertex through counting, then within each.
std::vector<Use> sorted(std::vector<Use> uses, std::size_t vertices) {
  auto by_low = grid::moved_to_buckets(std::span(uses), vertices, [](const Use& u) { return u.low.value; });
  grid::in_stretches(vertices, 4096, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) std::sort(by_low[v].begin(), by_low[v].end(), comes_before);
  });

  // An untouched face that hangs at two touched ones is listed twice.
  const auto same = [](const Use& x, const Use& y) {
    return x.element == none && x.low == y.low && !comes_before(x, y) && !comes_before(y, x);
  };
  const auto all = by_low.items();
  uses.assign(all.begin(), std::unique(all.begin(), all.end(), same));
  return uses;
}

}  // namespace

Uses collect_uses(const Operands& operands, const Touched& touched, const Sheets& sheets, Names& names) {
  Uses uses{glue(operands, touched, sheets), {}};
  const auto add = [&](FaceId face, VertexId from, VertexId to) {
    uses.list.push_back(use_of_patch(operands, uses.patches, face, from, to, names.planes));
  };

  for (const OperandId o : operands.ids())
    for (const CrowdedEdge& e : uses.patches.crowded[o]) {
      const VertexId from = names.name(operands[o], o, e.from), to = names.name(operands[o], o, e.to);
      add(e.face, from, to);
    }
  add_facets(sheets, uses.list);
  for (const UntouchedUse& u : touched.untouched) add(u.face, u.from, u.to);

  uses.list = sorted(std::move(uses.list), names.vertices.size());
  return uses;
}

}  // namespace quoin::booleans
