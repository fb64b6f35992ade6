#include "booleans/arrangement/patches.h"

#include <optional>

#include "grid/lists/partition.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {
namespace {

/// What the glueing of one operand knows and makes.
struct PatchPart {
  const Operands& operands;
  const Touched& touched;
  OperandId operand;
  Patches& out;

  const Body& body() const { return operands[operand]; }
  bool is_touched(std::uint32_t f) const { return touched.is_touched(operands.face(operand, f)); }

  /// visit(face), its own number, for the untouched faces of a chunk.
  template <class Visit>
  void for_untouched(const OperandChunk& c, Visit&& visit) const {
    for (const FaceId f : Ids<FaceId>(c.begin, c.end))
      if (!touched.is_touched(f)) visit(operands.own(operand, f));
  }
  template <class Visit>
  void for_untouched(Visit&& visit) const {
    for (const OperandChunk& c : operands.chunks_of(operand)) for_untouched(c, visit);
  }
  /// Puts a face into a patch, which gets the next number if it has none. Numbers count from the operand's first.
  void assign(std::uint32_t f, std::uint32_t& patch, std::uint32_t& count) const {
    if (patch == none) patch = count++;
    out.of[operands.face(operand, f)] = patch;
  }
};

/// How many patches there are. Far faces are one patch, wherever they are: their labels are known. Near ones join it
/// over vertices of the far faces around them.
std::uint32_t glue_over_vertices(const PatchPart& part) {
  const Body& body = part.body();
  const auto chunks = part.operands.chunks_of(part.operand);
  Box around;  // near faces that are not touched
  grid::Partition parts(body.vertex_count());
  Array<std::uint8_t> is_near(body.vertex_count());
  for (const OperandChunk& c : chunks)
    if (!c.far)
      part.for_untouched(c, [&](std::uint32_t f) {
        around.add(c.box);
        const auto corners = body.corners_of(f);
        for (const std::uint32_t v : corners) {
          is_near[v] = 1;
          parts.unite(corners[0], v);
        }
      });

  std::uint32_t anchor = none;  // a vertex of near and far faces
  for (const OperandChunk& c : chunks)
    if (c.far && c.box.meets(around))
      part.for_untouched(c, [&](std::uint32_t f) {
        for (const std::uint32_t v : body.corners_of(f)) {
          if (!is_near[v]) continue;
          if (anchor == none) anchor = v;
          parts.unite(anchor, v);
        }
      });

  std::uint32_t count = 0;
  if (std::any_of(chunks.begin(), chunks.end(), [](const OperandChunk& c) { return c.far; }))
    part.out.far[part.operand] = count++;
  Array<std::uint32_t> patch(body.vertex_count(), none);
  if (anchor != none) patch[parts.find(anchor)] = 0;
  for (const OperandChunk& c : chunks)
    if (!c.far)
      part.for_untouched(c, [&](std::uint32_t f) { part.assign(f, patch[parts.find(body.corners_of(f)[0])], count); });
  return count;
}

std::uint32_t glue_over_edges(const PatchPart& part) {
  const Body& body = part.body();
  const Adjacency* adjacency = part.touched.adjacency[part.operand].get();
  std::optional<Adjacency> own;
  if (!adjacency || !adjacency->is_complete()) adjacency = &own.emplace(body);

  grid::Partition parts(body.face_count());
  part.for_untouched([&](std::uint32_t f) {
    body.for_edges(f, [&](std::uint32_t u, std::uint32_t v) {
      int count = 0;
      std::uint32_t mate = none;
      adjacency->faces_at_edge(u, v, [&](std::uint32_t g, bool forward) {
        ++count;
        if (g != f && !forward) mate = g;
      });
      if (count != 2 || mate == none)
        part.out.crowded[part.operand].push_back({part.operands.face(part.operand, f), u, v});
      else if (!part.is_touched(mate))
        parts.unite(f, mate);
    });
  });

  std::uint32_t count = 0;
  Array<std::uint32_t> patch(body.face_count(), none);
  part.for_untouched([&](std::uint32_t f) { part.assign(f, patch[parts.find(f)], count); });
  return count;
}

}  // namespace

Patches glue(const Operands& operands, const Touched& touched, const Sheets& sheets) {
  const std::size_t n = operands.bodies.size();
  Patches out;
  out.first = sheets.facet_count();
  out.of.assign(operands.face_count(), none);
  out.far.assign(n, none);
  out.crowded.resize(n);

  ById<OperandId, std::uint32_t> count(n);
  grid::in_tasks(n, operands.face_count(), [&](std::size_t i) {
    const OperandId o = static_cast<std::uint32_t>(i);
    const PatchPart part{operands, touched, o, out};
    count[o] = operands.are_clean ? glue_over_vertices(part) : glue_over_edges(part);
  });

  // Patches get their ids operand by operand, whichever was done first.
  ById<OperandId, NodeId> first(n);
  for (const OperandId o : operands.ids()) {
    first[o] = out.node_count();
    out.operand_of.insert(out.operand_of.end(), count[o], o);
    if (out.far[o] != none) out.far[o] = out.far[o].value + first[o].value;
  }
  grid::in_stretches(operands.chunks.size(), 1024, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const OperandChunk& c = operands.chunks[i];
      const bool far = operands.are_clean && c.far;
      const NodeId base = first[c.operand];
      if (!far && base == NodeId(0)) continue;
      for (const FaceId f : Ids<FaceId>(c.begin, c.end)) {
        if (far)
          out.of[f] = base;
        else if (out.of[f] != none)
          out.of[f] = out.of[f].value + base.value;
      }
    }
  });
  for (const FaceId f : touched.members) out.of[f] = none;
  return out;
}

}  // namespace quoin::booleans
