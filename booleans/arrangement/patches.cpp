#include "booleans/arrangement/patches.h"

#include "booleans/body/half_edges.h"
#include "grid/lists/partition.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {
namespace {

/// What the glueing of one operand knows and makes.
struct PatchPart {
  const Operands& operands;
  const Touched& touched;
  OperandId operand;

  PatchPart(const Operands& all, const Touched& t, OperandId o) : operands(all), touched(t), operand(o) {}

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
  /// The number of a patch, which gets the next one if it has none.
  std::uint32_t number(std::uint32_t& patch) {
    if (patch == none) patch = count++;
    return patch;
  }

  std::uint32_t count = 0;  // of patches
  bool has_far = false;     // the first one is that of far faces, which are not listed
  struct Assigned {
    std::uint32_t face, patch;  // own numbers; at first a vertex of the patch
  };
  Array<Assigned> faces;
  Array<CrowdedEdge> crowded;
};

/// Unites the near vertices that far faces have; one of them, or none. `items` are boxes around all near vertices.
std::uint32_t join_over_far_faces(const PatchPart& part, const grid::Numbering& near, const Array<BoxTree::Item>& items,
                                  grid::Partition& parts) {
  std::uint32_t anchor = none;
  const BoxTree around(items);
  for (const OperandChunk& c : part.operands.chunks_of(part.operand)) {
    bool meets = false;
    if (c.far) around.meeting(c.box, [&](std::uint32_t) { meets = true; });
    if (!meets) continue;
    part.for_untouched(c, [&](std::uint32_t f) {
      for (const std::uint32_t v : part.body().corners_of(f)) {
        const std::uint32_t n = near[v];
        if (n == none) continue;
        if (anchor == none) anchor = n;
        parts.unite(anchor, n);
      }
    });
  }
  return anchor;
}

/// Far faces are one patch, wherever they are: their labels are known. Near ones join it over vertices of the far faces
/// around them.
void glue_over_vertices(PatchPart& part) {
  const Body& body = part.body();
  const auto chunks = part.operands.chunks_of(part.operand);
  // Where there are far chunks: of near ones, and of their vertices while these are fewer than all chunks.
  Array<BoxTree::Item> boxes, points;
  std::size_t near_faces = 0;
  for (const OperandChunk& c : chunks) {
    part.has_far = part.has_far || c.far;
    if (!c.far) near_faces += c.end.value - c.begin.value;
  }
  part.faces.reserve(near_faces);

  grid::Numbering near(body.vertex_count());
  grid::Partition parts(0);
  const std::size_t most_points = part.has_far ? chunks.size() : 0;
  const auto number = [&](std::uint32_t v) {
    const std::uint32_t n = near.add(v);
    if (n == parts.size()) {
      parts.add();
      if (n < most_points) body.add_to(points.emplace_back().box, v);
    }
    return n;
  };
  for (const OperandChunk& c : chunks) {
    if (c.far) continue;
    if (part.has_far) boxes.emplace_back().box = c.box;
    part.for_untouched(c, [&](std::uint32_t f) {
      const auto corners = body.corners_of(f);
      const std::uint32_t first = number(corners[0]);
      for (const std::uint32_t v : corners.subspan(1)) parts.unite(first, number(v));
      part.faces.push_back({f, first});
    });
  }

  const std::uint32_t anchor =
      part.has_far ? join_over_far_faces(part, near, near.size() < chunks.size() ? points : boxes, parts) : none;
  if (part.has_far) ++part.count;
  Array<std::uint32_t> patch(near.size(), none);
  if (anchor != none) patch[parts.find(anchor)] = 0;
  for (auto& [face, in] : part.faces) in = part.number(patch[parts.find(in)]);
}

/// Two untouched faces at an edge that no other has hang together over it.
void glue_over_edges(PatchPart& part) {
  const Body& body = part.body();
  const HalfEdges by_lower_vertex = half_edges(body.face_count(), body.vertex_count(),
                                               [&](std::uint32_t f, auto&& visit) { body.for_edges(f, visit); });
  const std::span<const HalfEdge> edges = by_lower_vertex.items();

  grid::Partition parts(body.face_count());
  for_undirected_edges(edges, [&](std::size_t begin, std::size_t end) {
    const HalfEdge &first = edges[begin], &last = edges[end - 1];
    const bool is_plain = end - begin == 2 && first.from == last.to && first.face != last.face;
    if (is_plain && !part.is_touched(first.face) && !part.is_touched(last.face)) parts.unite(first.face, last.face);
    for (const HalfEdge& e : edges.subspan(begin, is_plain ? 0 : end - begin))
      if (!part.is_touched(e.face)) part.crowded.push_back({part.operands.face(part.operand, e.face), e.from, e.to});
    return true;
  });

  Array<std::uint32_t> patch(body.face_count(), none);
  part.for_untouched([&](std::uint32_t f) { part.faces.push_back({f, part.number(patch[parts.find(f)])}); });
}

/// Adds the patches of one operand.
void add_part(const Operands& operands, const PatchPart& part, Patches& out) {
  const OperandId o = part.operand;
  const NodeId first = out.node_count();
  out.operand_of.insert(out.operand_of.end(), part.count, o);
  out.crowded[o] = part.crowded;

  if (part.has_far) {
    out.far[o] = first;
    const auto chunks = operands.chunks_of(o);
    for (std::size_t i = 0, next = 0; i < chunks.size(); i = next) {  // faces between two chunks are gone
      for (next = i + 1; next < chunks.size() && chunks[i].far && chunks[next].far;) ++next;
      if (chunks[i].far) out.of.fill(chunks[i].begin.value, chunks[next - 1].end.value, first);
    }
  }
  for (const auto& [f, patch] : part.faces) out.of.at(operands.face(o, f)) = first.value + patch;
}

}  // namespace

Patches glue(const Operands& operands, const Touched& touched, const Sheets& sheets) {
  const std::size_t n = operands.bodies.size();
  Patches out;
  out.first = sheets.facet_count();
  out.of = grid::PagedById<FaceId, NodeId>(operands.face_count(), none);
  out.far.assign(n, none);
  out.crowded.resize(n);

  std::vector<PatchPart> parts;
  for (const OperandId o : operands.ids()) parts.emplace_back(operands, touched, o);
  grid::in_tasks(n, operands.face_count(), [&](std::size_t i) {
    if (operands.are_clean)
      glue_over_vertices(parts[i]);
    else
      glue_over_edges(parts[i]);
  });
  for (const PatchPart& part : parts) add_part(operands, part, out);
  for (const FaceId f : touched.members)  // they may reach into far chunks
    if (out.of[f] != none) out.of.at(f) = none;
  return out;
}

}  // namespace quoin::booleans
