#include "booleans/arrangement/spared_loops.h"

#include <algorithm>

namespace quoin::booleans {
namespace {

using Polygons = decltype(Body::polygons);

Box box_of_loop(const Body& body, std::uint32_t loop) {
  Box box;
  for (const std::uint32_t v : body.polygons.loop(loop)) body.add_to(box, v);
  return box;
}

bool is_equal(const Box& a, const Box& b) { return a.low == b.low && a.high == b.high; }

/// The one loop whose box is that of the face; none when there are several.
std::uint32_t only_outer(std::span<const Box> loops, const Box& face) {
  std::uint32_t outer = none;
  for (std::uint32_t i = 0; i < loops.size(); ++i) {
    if (!is_equal(loops[i], face)) continue;
    if (outer != none) return none;
    outer = i;
  }
  return outer;
}

/// Calls pass() until it changes nothing; false when that takes many rounds.
template <class Pass>
bool settles(Pass&& pass) {
  for (int rounds = 0; rounds < 8; ++rounds)
    if (!pass()) return true;
  return false;
}

/// R of the header, grown until no loop of the face meets it in part. False when an edge of the outer loop meets it.
bool grow_around(std::span<const Box> loops, std::uint32_t outer, std::span<const Box> outer_edges, Box& r) {
  std::vector<std::uint8_t> within(loops.size());
  within[outer] = 1;
  const bool is_settled = settles([&] {
    bool grew = false;
    for (std::size_t i = 0; i < loops.size(); ++i) {
      if (within[i] || !loops[i].meets(r)) continue;
      within[i] = 1;
      r.add(loops[i]);
      grew = true;
    }
    return grew;
  });
  return is_settled && std::none_of(outer_edges.begin(), outer_edges.end(), [&](const Box& e) { return e.meets(r); });
}

}  // namespace

SparedLoops::SparedLoops(const Operands& operands, OperandId operand, std::span<const std::uint32_t> touched) {
  if (!operands.are_clean) return;
  const Body& body = operands[operand];
  for (const std::uint32_t f : touched) {
    if (f < body.triangles.size() || body.corner_count(f) <= grid::thresholds().large_face) continue;
    if (const std::uint32_t p = body.polygon(f); body.polygons.loop_count(p) > 1) choose(operands, operand, p);
  }
  if (!faces_.empty()) keep_shared(operands, operand);
}

/// Spares the loops outside R.
void SparedLoops::choose(const Operands& operands, OperandId operand, std::uint32_t polygon) {
  const Body& body = operands[operand];
  const Polygons& polygons = body.polygons;
  const std::uint32_t first = polygons.face_start[polygon];

  Box face;
  std::vector<Box> loops;
  loops.reserve(polygons.loop_count(polygon));
  for (std::uint32_t j = first; j < polygons.face_start[polygon + 1]; ++j) {
    loops.push_back(box_of_loop(body, j));
    face.add(loops.back());
  }
  const std::uint32_t outer = only_outer(loops, face);
  if (outer == none) return;

  std::vector<Box> outer_edges;
  grid::for_loop_edges(polygons.loop(first + outer), [&](std::uint32_t u, std::uint32_t v) {
    Box& box = outer_edges.emplace_back();
    body.add_to(box, u);
    body.add_to(box, v);
  });
  Box r;
  for (const OperandId o : operands.ids())
    if (o != operand && operands.bounds[o].meets(face)) r.add(operands.bounds[o]);
  if (!grow_around(loops, outer, outer_edges, r)) return;

  faces_.push_back({polygon, first + outer, face});
  is_spared_.resize(polygons.loop_count());
  for (std::uint32_t i = 0; i < loops.size(); ++i) is_spared_[first + i] = i != outer && !loops[i].meets(r);
}

/// Draws the loops of which a vertex is on another face that is near, or on a loop that is drawn.
void SparedLoops::keep_shared(const Operands& operands, OperandId operand) {
  const Body& body = operands[operand];
  const auto triangles = static_cast<std::uint32_t>(body.triangles.size());
  std::vector<std::uint8_t> is_drawn(body.vertex_count());
  const auto draw = [&](std::uint32_t loop) {
    for (const std::uint32_t v : body.polygons.loop(loop)) is_drawn[v] = 1;
  };

  for (const OperandChunk& c : operands.chunks_of(operand)) {
    if (c.far) continue;
    for (std::uint32_t f = operands.own(operand, c.begin); f < operands.own(operand, c.end); ++f) {
      if (f < triangles)
        for (const std::uint32_t v : body.triangles[f]) is_drawn[v] = 1;
      else
        for (std::uint32_t j = body.polygons.face_start[f - triangles]; j < body.polygons.face_start[f - triangles + 1];
             ++j)
          if (!is_spared_[j]) draw(j);
    }
  }

  const bool is_settled = settles([&] {
    bool changed = false;
    for (const Face& c : faces_)
      for (std::uint32_t j = body.polygons.face_start[c.polygon]; j < body.polygons.face_start[c.polygon + 1]; ++j) {
        if (!is_spared_[j]) continue;
        const auto loop = body.polygons.loop(j);
        if (std::none_of(loop.begin(), loop.end(), [&](std::uint32_t v) { return is_drawn[v]; })) continue;
        is_spared_[j] = 0;
        draw(j);
        changed = true;
      }
    return changed;
  });
  if (!is_settled) {
    is_spared_.clear();
    faces_.clear();
  }
}

const SparedLoops::Face* SparedLoops::find(std::uint32_t polygon) const {
  const auto at = std::lower_bound(faces_.begin(), faces_.end(), polygon,
                                   [](const Face& f, std::uint32_t p) { return f.polygon < p; });
  return at != faces_.end() && at->polygon == polygon ? &*at : nullptr;
}

}  // namespace quoin::booleans
