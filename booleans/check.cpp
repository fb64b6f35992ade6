#include "booleans/check.h"

#include <cstdio>
#include <cstdlib>
#include <map>

#include "booleans/query.h"

namespace quoin::booleans {
namespace {

void require(bool holds, const char* law) {
  if (holds) return;
  std::fprintf(stderr, "quoin: internal check failed: %s\n", law);
  std::abort();
}

}  // namespace

void check(const TouchedFaces& touched, const VertexTable& vertices, const PlaneTable& planes) {
  const auto on = [&](std::uint32_t v, std::uint32_t p) {
    return vertices.side(v, planes[p], planes.approximation(p)) == 0;
  };
  for (const TouchedFace& f : touched.faces) {
    std::map<std::uint32_t, int> balance;
    for (std::uint32_t e = f.edges_begin; e < f.edges_end; ++e) {
      const BoundaryEdge& edge = touched.edges[e];
      require(!exact::parallel(planes[f.sheet], planes[edge.other]), "an edge has two planes that are not parallel");
      for (const std::uint32_t v : {edge.from, edge.to})
        require(on(v, f.sheet) && on(v, edge.other), "an edge lies on both its planes");
      ++balance[edge.from];
      --balance[edge.to];
    }
    for (const auto& [v, sum] : balance) require(sum == 0, "the boundary of a face is closed");
  }
}

void check(const Sheet& sheet, const VertexTable& vertices, const PlaneTable& planes) {
  const Frame frame(planes[sheet.plane]);
  const auto on = [&](std::uint32_t v, std::uint32_t p) {
    return vertices.side(v, planes[p], planes.approximation(p)) == 0;
  };
  for (const Sheet::Element& e : sheet.elements) {
    require(on(e.a, sheet.plane) && on(e.b, sheet.plane), "an element lies on its sheet");
    require(on(e.a, e.line) && on(e.b, e.line), "an element lies on its line");
    require(frame.compare(vertices, e.a, e.b) < 0, "an element runs forward");
  }
  std::vector<std::uint8_t> reached(sheet.clockwise.size());
  for (std::uint32_t h = 0; h < sheet.clockwise.size(); ++h) {
    const std::uint32_t next = sheet.clockwise[h];
    require(sheet.origin(next) == sheet.origin(h), "turning keeps the origin");
    require(!reached[next], "turning permutes the half-edges");
    reached[next] = 1;
    require(sheet.facet[sheet.clockwise[h ^ 1]] == sheet.facet[h], "a loop has one facet on its left");
  }
  for (std::size_t f = 0; f < sheet.facet_count(); ++f)
    require(sheet.cover_start[f] < sheet.cover_start[f + 1], "every facet is covered");
}

void check(const Arrangement& a) {
  std::vector<std::uint32_t> sheet_of(a.facet_count());
  for (std::uint32_t s = 0; s < a.sheets.size(); ++s)
    for (std::uint32_t f = a.facet_base[s]; f < a.facet_base[s + 1]; ++f) sheet_of[f] = s;
  std::map<std::uint32_t, int> change;
  for (std::size_t i = 0; i < a.uses.size(); ++i) {
    const Use& u = a.uses[i];
    if (i > 0 && (a.uses[i - 1].low != u.low || a.uses[i - 1].high != u.high)) change.clear();
    // Passing the facet counter-clockwise goes from its front to its back where it lies right of the edge.
    const int way = u.left ? -1 : 1;
    if (u.facet >= a.facet_count()) {
      change[a.patch_operand[u.facet - a.facet_count()]] += u.turned ? -way : way;
    } else {
      const Sheet& sheet = a.sheets[sheet_of[u.facet]];
      const std::uint32_t f = u.facet - a.facet_base[sheet_of[u.facet]];
      for (std::uint32_t c = sheet.cover_start[f]; c < sheet.cover_start[f + 1]; ++c) {
        const TouchedFace& face = a.touched.faces[sheet.cover[c]];
        change[face.operand] += face.along ? way : -way;
      }
    }
    const bool last = i + 1 == a.uses.size() || a.uses[i + 1].low != u.low || a.uses[i + 1].high != u.high;
    if (last)
      for (const auto& [operand, sum] : change) require(sum == 0, "the labels around an edge close up");
  }
}

void check(const Body& body) {
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
