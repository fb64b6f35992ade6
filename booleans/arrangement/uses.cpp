#include "booleans/arrangement/uses.h"

#include <atomic>

#include "grid/lists/stretches.h"

namespace quoin::booleans {
namespace {

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
          visit(low.value,
                Use::of_facet(high, sheets.node(s, f), (a == low) == (h == 2 * e), sheet.plane, sheets.element(s, e)));
    }
  }
}

/// An untouched face at its directed edge.
struct PatchUse {
  VertexId low;
  Use use;

  PatchUse(const Patches& patches, FaceId face, VertexId from, VertexId to)
      : low(std::min(from, to)), use(Use::of_patch(std::max(from, to), patches.of[face], from < to, face)) {}
};

/// Sorts the uses with one low end, mostly few.
void sort(std::span<Use> uses) {
  if (uses.size() > static_cast<std::size_t>(grid::thresholds().few_sorted)) return std::sort(uses.begin(), uses.end());
  for (std::size_t i = 1; i < uses.size(); ++i) {
    const Use u = uses[i];
    std::size_t j = i;
    for (; j > 0 && u < uses[j - 1]; --j) uses[j] = uses[j - 1];
    uses[j] = u;
  }
}

/// All uses, those of each low end sorted. One of a patch may be there twice: false then.
bool sort_by_edges(const Sheets& sheets, const Array<PatchUse>& patches, std::size_t vertices,
                   grid::Buckets<Use>& uses) {
  uses.assign(vertices, [&](auto&& visit) {
    for (const PatchUse& p : patches) visit(p.low.value, p.use);
    for_facets(sheets, visit);
  });

  std::atomic<bool> is_distinct = true;
  grid::in_stretches(vertices, 4096, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      sort(uses[v]);
      if (std::adjacent_find(uses[v].begin(), uses[v].end()) != uses[v].end()) is_distinct = false;
    }
  });
  return is_distinct;
}

/// The same, each one once.
grid::Buckets<Use> distinct(const grid::Buckets<Use>& uses) {
  return {uses.size(), [&](auto&& visit) {
            for (std::size_t v = 0; v < uses.size(); ++v)
              for (std::size_t i = 0; i < uses[v].size(); ++i)
                if (i == 0 || uses[v][i] != uses[v][i - 1]) visit(v, uses[v][i]);
          }};
}

}  // namespace

Uses collect_uses(const Operands& operands, const Touched& touched, const Sheets& sheets, Names& names) {
  Uses uses{glue(operands, touched, sheets), {}};
  Array<PatchUse> patches;
  patches.reserve(touched.untouched.size());
  for (const OperandId o : operands.ids())
    for (const CrowdedEdge& e : uses.patches.crowded[o]) {
      const VertexId from = names.name(operands[o], o, e.from), to = names.name(operands[o], o, e.to);
      patches.emplace_back(uses.patches, e.face, from, to);
    }
  for (const UntouchedUse& u : touched.untouched) patches.emplace_back(uses.patches, u.face, u.from, u.to);

  // A face that hangs at two touched ones is listed twice.
  if (!sort_by_edges(sheets, patches, names.vertices.size(), uses.at)) uses.at = distinct(uses.at);
  return uses;
}

}  // namespace quoin::booleans
