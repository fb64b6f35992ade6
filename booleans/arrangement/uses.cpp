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

/// visit(low, use) for the facets at all elements.
template <class Visit>
void for_facets(const Sheets& sheets, Visit&& visit) {
  for (const SheetId s : sheets.ids()) {
    const Sheet& sheet = sheets[s];
    for (std::uint32_t e = 0; e < sheet.elements.size(); ++e) {
      const auto& [a, b, line] = sheet.elements[e];
      const VertexId low = std::min(a, b), high = std::max(a, b);
      for (const std::uint32_t h : {2 * e, 2 * e + 1})
        if (const FacetId f = sheet.facet[h]; f != none)
          visit(low.value, Use{low, high, sheets.node(s, f), sheet.plane, line, sheets.element(s, e),
                               (a == low) == (h == 2 * e), false});
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

/// All uses, sorted. `patches`: those of untouched faces; one that hangs at two touched faces is listed twice.
Array<Use> sorted(const Sheets& sheets, const Array<Use>& patches, std::size_t vertices) {
  Array<Use> list;
  Array<std::uint32_t> start(vertices + 2);
  grid::counting_sort(
      std::span(start),
      [&](auto&& visit) {
        for (const Use& u : patches) visit(u.low.value, u);
        for_facets(sheets, visit);
      },
      [&](std::size_t n) {
        list.resize(n);
        return list.data();
      });
  grid::in_stretches(vertices, 4096, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v)
      std::sort(list.data() + start[v], list.data() + start[v + 1], comes_before);
  });

  const auto same = [](const Use& x, const Use& y) {
    return x.element == none && x.low == y.low && !comes_before(x, y) && !comes_before(y, x);
  };
  list.erase(std::unique(list.begin(), list.end(), same), list.end());
  return list;
}

}  // namespace

Uses collect_uses(const Operands& operands, const Touched& touched, const Sheets& sheets, Names& names) {
  Uses uses{glue(operands, touched, sheets), {}};
  Array<Use> patches;
  const auto add = [&](FaceId face, VertexId from, VertexId to) {
    patches.push_back(use_of_patch(operands, uses.patches, face, from, to, names.planes));
  };

  for (const OperandId o : operands.ids())
    for (const CrowdedEdge& e : uses.patches.crowded[o]) {
      const VertexId from = names.name(operands[o], o, e.from), to = names.name(operands[o], o, e.to);
      add(e.face, from, to);
    }
  for (const UntouchedUse& u : touched.untouched) add(u.face, u.from, u.to);

  uses.list = sorted(sheets, patches, names.vertices.size());
  return uses;
}

}  // namespace quoin::booleans
