#include <algorithm>

#include "booleans/assemble/making.h"

namespace quoin::booleans {

void keep_chunk(Array<Chunk>& chunks, std::uint32_t begin, std::uint32_t end, const Box& box) {
  if (begin == end) return;
  if (!chunks.empty() && chunks.back().end == begin && end - chunks.back().begin <= grid::thresholds().chunk &&
      chunks.back().box.meets(box)) {
    chunks.back().end = end;
    chunks.back().box.add(box);
  } else {
    chunks.push_back({begin, end, box});
  }
}

OperandId find_host(const Arrangement& a, const Selection& selection) {
  for (const OperandId o : a.operands.ids()) {
    const std::size_t own = a.operands[o].face_count(), others = a.operands.face_count() - own + a.touched.faces.size();
    const NodeId far = a.patches().far[o];
    if (own >= grid::thresholds().host * others && far != none && selection.kept[far] > 0) return o;
  }
  return none;
}

namespace {

/// Gives derived points new ids, so that there is room for new grid points and for some more.
void move_derived(Body& body, std::size_t new_points) {
  const auto from = static_cast<std::uint32_t>(body.derived_base());
  const std::size_t grid = body.grid_points.size();
  body.room = static_cast<std::uint32_t>(grid + grid / 4 + 2 * new_points);
  for (std::uint32_t& v : body.polygons.corners.edit())
    if (v >= from) v += body.room - from;
}

/// A run of faces of a chunk of the host stays; own numbers.
void keep_run(Making& m, const Box& box, std::uint32_t begin, std::uint32_t end) {
  const auto raw = static_cast<std::uint32_t>(m.a.operands[m.host].triangles.size());
  if (begin < raw)
    keep_chunk(m.raw_chunks, begin, end, box);
  else
    keep_chunk(m.polygon_chunks, begin - raw, end - raw, box);
}

/// A face of the host that is near what is touched: does it stay as it is? Its vertices then keep their names.
bool stays_as_it_is(Making& m, std::uint32_t face) {
  const Body& host = m.a.operands[m.host];
  if (m.kept(m.a.operands.face(m.host, face)) <= 0) return false;

  const auto corners = host.corners_of(face);
  if (face < host.triangles.size()) {
    for (const std::uint32_t v : corners) m.vertices.named(m.host, v);
    return true;
  }
  return std::none_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return m.vertices.in_table(m.host, v); });
}

void keep_near_chunk(Making& m, const OperandChunk& c) {
  const Body& host = m.a.operands[m.host];
  std::uint32_t begin = m.a.operands.own(m.host, c.begin);
  for (const FaceId f : Ids<FaceId>(c.begin, c.end)) {
    const std::uint32_t own = m.a.operands.own(m.host, f);
    if (stays_as_it_is(m, own)) continue;
    keep_run(m, c.box, begin, own);
    begin = own + 1;
    if (m.kept(f) != 0) m.changed.push_back(own);
    if (own >= host.triangles.size()) m.body.gone_corners += host.corner_count(own);
  }
  keep_run(m, c.box, begin, m.a.operands.own(m.host, c.end));
}

}  // namespace

namespace {

/// Numbers of origins change to those among all operands; where all stay, the list stays shared.
void rename(grid::SharedList<Provenance>& list, const Array<std::uint32_t>& number) {
  for (auto& p : list.edit()) p = p.in(number[p.origin()]);
}

}  // namespace

void keep_labels(Making& m) {
  Labels& labels = m.body.labels;
  labels.origins = m.a.operands.origins;
  if (m.host == none) return;

  const Array<std::uint32_t>& number = m.a.operands.origins_of[m.host];
  if (!m.a.operands[m.host].labels) {
    std::ranges::fill(labels.triangles.grow(m.body.triangles.size()), Provenance(number[0], 0));
    std::ranges::fill(labels.polygons.grow(m.body.planes.size()), Provenance(number[0], 0));
    return;
  }
  if (number.empty()) return;
  rename(labels.triangles, number);
  rename(labels.polygons, number);
}

void keep_host(Making& m) {
  const Operands& operands = m.a.operands;
  const Body& host = operands[m.host];
  m.body = host;
  m.body.is_packed = false;
  m.body.chunks.clear();

  std::size_t new_points = m.a.names.vertices.size();
  for (const Body* other : operands.bodies) new_points += other == &host ? 0 : other->grid_points.size();
  if (host.grid_points.size() + new_points > host.derived_base()) move_derived(m.body, new_points);

  Array<BoxTree::Item> listed;
  Box around;
  for (const std::uint32_t v : m.a.names.operands[m.host].listed) {
    listed.emplace_back().box.add(host.approximation(v));
    around.add(host.approximation(v));
  }
  const BoxTree table(listed);
  for (const OperandChunk& c : operands.chunks_of(m.host)) {
    bool near = !c.far;
    if (c.far && c.box.meets(around)) table.meeting(c.box, [&](std::uint32_t) { near = true; });
    if (near)
      keep_near_chunk(m, c);
    else
      keep_run(m, c.box, operands.own(m.host, c.begin), operands.own(m.host, c.end));
  }
}

Waste waste(const Body& body) {
  std::size_t live = 0, corners = body.polygons.corners.size() - body.gone_corners;
  for (const Chunk& c : body.chunks) {
    live += c.end - c.begin;
    if (c.begin < body.triangles.size()) corners += 3 * (c.end - c.begin);
  }
  // A vertex is a corner of at least three faces.
  const std::size_t gone = body.face_count() - live, claimed = 3 * (body.grid_points.size() + body.points.size()),
                    gone_claimed = claimed - std::min(claimed, corners);

  const std::size_t factor = grid::thresholds().live_per_gone;
  if (factor * gone > live || factor * gone_claimed > 4 * corners) return Waste::much;
  return factor * body.gone_corners > 4 * corners ? Waste::loops : Waste::little;
}

void tidy(Body& body) {
  switch (waste(body)) {
    case Waste::much:
      body = packed(body);
      break;
    case Waste::loops:
      drop_gone_loops(body);
      break;
    case Waste::little:
      break;
  }
}

}  // namespace quoin::booleans
