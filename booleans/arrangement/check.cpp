#include "booleans/arrangement/check.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "booleans/arrangement/frame.h"
#include "booleans/body/fault.h"

namespace quoin::booleans {
namespace {

void require(bool holds, const char* law) {
  if (holds) return;
  std::fprintf(stderr, "quoin: internal check failed: %s\n", law);
  std::abort();
}

}  // namespace

void check(const Touched& touched, const Names& names) {
  for (const TouchedId t : Ids<TouchedId>(touched.faces.size())) {
    const PlaneId plane = touched.faces[t].plane;
    std::map<VertexId, int> balance;
    for (const BoundaryEdge& e : touched.edges_of(t)) {
      require(!exact::parallel(names.planes[plane], names.planes[e.other]),
              "an edge has two planes that are not parallel");
      for (const VertexId v : {e.from, e.to})
        require(names.side(v, plane) == 0 && names.side(v, e.other) == 0, "an edge lies on both its planes");
      ++balance[e.from];
      --balance[e.to];
    }
    for (const auto& [v, sum] : balance) require(sum == 0, "the boundary of a face is closed");
  }
}

void check(const Sheet& sheet, const Names& names) {
  const Frame frame(names.planes[sheet.plane]);
  const auto on = [&](VertexId v, PlaneId p) { return names.side(v, p) == 0; };
  for (const Sheet::Element& e : sheet.elements) {
    require(on(e.a, sheet.plane) && on(e.b, sheet.plane), "an element lies on its sheet");
    require(on(e.a, e.line) && on(e.b, e.line), "an element lies on its line");
    require(frame.compare(names.vertices, e.a, e.b) < 0, "an element runs forward");
  }

  std::vector<std::uint8_t> reached(sheet.clockwise.size());
  for (std::uint32_t h = 0; h < sheet.clockwise.size(); ++h) {
    const std::uint32_t next = sheet.clockwise[h];
    require(sheet.origin(next) == sheet.origin(h), "turning keeps the origin");
    require(!reached[next], "turning permutes the half-edges");
    reached[next] = 1;
    require(sheet.facet[sheet.clockwise[h ^ 1]] == sheet.facet[h], "a loop has one facet on its left");
  }
  for (const FacetId f : Ids<FacetId>(sheet.facet_count())) require(!sheet.covers(f).empty(), "every facet is covered");
}

void check(const Arrangement& a) {
  if (!a.operands.are_clean) return;  // there an edge also has faces that are glued, not used
  a.uses.for_edges([&](VertexId, std::span<const Use> uses) {
    std::map<OperandId, int> change;
    for (const Use& u : uses) {
      // Passing the facet counter-clockwise goes from its front to its back where it lies right of the edge.
      const int way = u.left() ? -1 : 1;
      a.for_jumps(u.node(), [&](OperandId operand, int by) { change[operand] += way * by; });
    }
    for (const auto& [operand, sum] : change) require(sum == 0, "the labels around an edge close up");
  });
}

namespace {

/// Each face carries something, and edges between polygons on one plane are listed as borders, with planes through
/// them.
void check_labels(const Body& body) {
  const Labels& labels = body.labels;
  if (!labels)
    return require(labels.triangles.empty() && labels.polygons.empty() && labels.borders.empty(), "no labels");
  require(labels.triangles.size() == body.triangles.size() && labels.polygons.size() == body.polygon_count(),
          "every face carries something");
  const auto is_origin = [&](const Provenance& p) { return p.origin() < labels.origins->size(); };
  require(std::all_of(labels.triangles.begin(), labels.triangles.end(), is_origin) &&
              std::all_of(labels.polygons.begin(), labels.polygons.end(), is_origin),
          "faces name origins of the body");
  for (std::size_t i = 1; i < labels.borders.size(); ++i)
    require(labels.borders[i - 1].corner < labels.borders[i].corner, "borders are in order");

  std::map<std::pair<std::uint32_t, std::uint32_t>, Array<std::uint32_t>> faces_at;
  body.for_runs([&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t f = begin; f < end; ++f)
      body.for_edges(f, [&](std::uint32_t u, std::uint32_t v) { faces_at[std::minmax(u, v)].push_back(f); });
  });
  const auto check_edge = [&](std::uint32_t f, std::uint32_t u, std::uint32_t v) {
    const auto& at = faces_at[std::minmax(u, v)];
    const exact::Plane* other = body.border(f, u, v);
    if (other)
      require(!exact::parallel(*other, body.plane(f)) && exact::side(*other, body.point(u)) == 0 &&
                  exact::side(*other, body.point(v)) == 0,
              "a border is the meeting of two planes");
    if (at.size() != 2 || at[0] == at[1] || !(body.plane(at[0]) == body.plane(at[1]))) return;
    require(other != nullptr, "an edge of a polygon on one plane is a border");
    require(!body.is_same_surface(at[0], at[1]), "neighbours on one plane carry something different");
  };
  body.for_runs([&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t f = std::max(begin, static_cast<std::uint32_t>(body.triangles.size())); f < end; ++f)
      body.for_edges(f, [&](std::uint32_t u, std::uint32_t v) { check_edge(f, u, v); });
  });
}

}  // namespace

void check(const Body& body) {
  check_labels(body);
  const auto message = fault(body, exact::world + 1);
  require(!message, message ? message->c_str() : "");
  std::uint32_t next = 0;
  for (const Chunk& c : body.chunks) {
    require((body.is_packed ? c.begin == next : c.begin >= next) && c.begin < c.end, "chunks follow each other");
    require((c.begin < body.triangles.size()) == (c.end <= body.triangles.size()), "a chunk has faces of one tier");
    for (std::uint32_t f = c.begin; f < c.end; ++f) {
      Box sum = c.box;
      sum.add(face_box(body, f));
      require(sum.low == c.box.low && sum.high == c.box.high, "a chunk's box holds its faces");
    }
    next = c.end;
  }
  require((body.is_packed && body.chunks.empty()) || next <= body.face_count(), "faces of chunks are there");
  require(!body.is_packed || body.chunks.empty() || next == body.face_count(), "chunks hold all faces");
}

}  // namespace quoin::booleans
