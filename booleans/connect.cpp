#include <numeric>
#include <tuple>

#include "booleans/arrangement.h"

namespace quoin::booleans {
namespace {

class Connector {
 public:
  explicit Connector(Arrangement& a) : a_(a) {}

  void number_facets() {
    a_.facet_base = {0};
    a_.element_base = {0};
    for (const Sheet& s : a_.sheets) {
      a_.facet_base.push_back(a_.facet_base.back() + static_cast<std::uint32_t>(s.facet_count()));
      a_.element_base.push_back(a_.element_base.back() + static_cast<std::uint32_t>(s.elements.size()));
    }
    a_.patch_of.assign(a_.operands.face_count(), none);
    a_.far_patch.assign(a_.operands.bodies.size(), none);
  }

  /// Far faces are one patch, wherever they are: their labels are known. Near ones join it over vertices of the far
  /// faces around them.
  void glue_over_vertices(std::uint32_t operand) {
    const Body& body = *a_.operands.bodies[operand];
    const auto chunks = a_.operands.chunks_of(operand);
    Box around;
    for (const OperandChunk& c : chunks)
      if (!c.far) around.add(c.box);
    Partition parts(body.vertex_count());
    std::vector<std::uint8_t> is_near(body.vertex_count());
    for (const OperandChunk& c : chunks)
      if (!c.far)
        for_untouched(c, [&](std::uint32_t f) {
          std::uint32_t first = none;
          body.for_corners(f, [&](std::uint32_t v) {
            is_near[v] = 1;
            if (first == none)
              first = v;
            else
              parts.unite(first, v);
          });
        });
    std::uint32_t anchor = none;  // a vertex of near and far faces
    for (const OperandChunk& c : chunks)
      if (c.far && c.box.meets(around))
        for_untouched(c, [&](std::uint32_t f) {
          body.for_corners(f, [&](std::uint32_t v) {
            if (!is_near[v]) return;
            if (anchor == none) anchor = v;
            parts.unite(anchor, v);
          });
        });
    std::vector<std::uint32_t> patch(body.vertex_count(), none);
    std::uint32_t& far = a_.far_patch[operand];
    for (const OperandChunk& c : chunks)
      if (c.far) {
        if (far == none) far = new_patch(operand);
        std::fill(a_.patch_of.begin() + c.begin, a_.patch_of.begin() + c.end, far);
      }
    if (anchor != none) patch[parts.find(anchor)] = far;
    for (const OperandChunk& c : chunks)
      if (!c.far)
        for_untouched(c, [&](std::uint32_t f) {
          std::uint32_t first = none;
          body.for_corners(f, [&](std::uint32_t v) { first = first == none ? v : first; });
          assign(operand, f, patch[parts.find(first)]);
        });
  }

  void glue_over_edges(std::uint32_t operand) {
    const Body& body = *a_.operands.bodies[operand];
    auto& adjacency = a_.touched.adjacency[operand];
    if (!adjacency || !adjacency->is_complete()) adjacency = std::make_unique<Adjacency>(body);
    Partition parts(body.face_count());
    std::vector<std::array<std::uint32_t, 3>> crowded;  // (face, from, to) at edges of more than two faces
    for_untouched(operand, [&](std::uint32_t f) {
      body.for_edges(f, [&](std::uint32_t u, std::uint32_t v) {
        int count = 0;
        std::uint32_t mate = none;
        adjacency->faces_at_edge(u, v, [&](std::uint32_t g, bool forward) {
          ++count;
          if (g != f && !forward) mate = g;
        });
        if (count != 2 || mate == none)
          crowded.push_back({f, u, v});
        else if (untouched(operand, mate))
          parts.unite(f, mate);
      });
    });
    std::vector<std::uint32_t> patch(body.face_count(), none);
    for_untouched(operand, [&](std::uint32_t f) { assign(operand, f, patch[parts.find(f)]); });
    if (!crowded.empty()) a_.touched.vertex_of[operand].resize(body.vertex_count(), none);
    for (const auto& [f, u, v] : crowded) add_use(operand, f, table_id(operand, u), table_id(operand, v));
  }

  void collect_uses() {
    for (std::uint32_t s = 0; s < a_.sheets.size(); ++s) {
      const Sheet& sheet = a_.sheets[s];
      for (std::uint32_t h = 0; h < 2 * sheet.elements.size(); ++h) {
        if (sheet.facet[h] == none) continue;
        const std::uint32_t u = sheet.origin(h), v = sheet.target(h);
        a_.uses.push_back({std::min(u, v), std::max(u, v), a_.facet_base[s] + sheet.facet[h], sheet.plane,
                           sheet.elements[h / 2].line, a_.element_base[s] + h / 2, u < v, false});
      }
    }
    for (const UntouchedUse& u : a_.touched.untouched) add_use(u.operand, u.face, u.from, u.to);
    sort_uses();
    // An untouched face that hangs at two touched ones is listed twice.
    const auto same = [&](const Use& x, const Use& y) {
      return x.facet >= a_.facet_count() && x.low == y.low && !before(x, y) && !before(y, x);
    };
    a_.uses.erase(std::unique(a_.uses.begin(), a_.uses.end(), same), a_.uses.end());
  }

 private:
  /// Order of uses with the same lower vertex.
  static bool before(const Use& x, const Use& y) {
    return std::tie(x.high, x.facet, x.left, x.plane) < std::tie(y.high, y.facet, y.left, y.plane);
  }

  /// By lower vertex through counting, then within each.
  void sort_uses() {
    std::vector<std::uint32_t> end(a_.vertices.size() + 1);
    for (const Use& u : a_.uses) ++end[u.low + 1];
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<Use> sorted(a_.uses.size());
    for (const Use& u : a_.uses) sorted[end[u.low]++] = u;
    a_.uses.swap(sorted);
    for (std::size_t v = 0, begin = 0; v + 1 < end.size(); begin = end[v++])
      std::sort(a_.uses.begin() + static_cast<std::ptrdiff_t>(begin),
                a_.uses.begin() + static_cast<std::ptrdiff_t>(end[v]), before);
  }

  bool untouched(std::uint32_t operand, std::uint32_t f) const {
    return a_.touched.face_of[a_.operands.base[operand] + f] == none;
  }
  /// visit(face), an own id of its operand.
  template <class Visit>
  void for_untouched(const OperandChunk& c, Visit&& visit) {
    for (std::uint32_t f = c.begin; f < c.end; ++f)
      if (a_.touched.face_of[f] == none) visit(f - a_.operands.base[c.operand]);
  }
  template <class Visit>
  void for_untouched(std::uint32_t operand, Visit&& visit) {
    for (const OperandChunk& c : a_.operands.chunks_of(operand)) for_untouched(c, visit);
  }
  std::uint32_t new_patch(std::uint32_t operand) {
    a_.patch_operand.push_back(operand);
    return a_.node_count() - 1;
  }
  void assign(std::uint32_t operand, std::uint32_t f, std::uint32_t& patch) {
    if (patch == none) patch = new_patch(operand);
    a_.patch_of[a_.operands.base[operand] + f] = patch;
  }
  std::uint32_t table_id(std::uint32_t operand, std::uint32_t v) {
    return a_.touched.table_id(*a_.operands.bodies[operand], operand, v, a_.vertices);
  }
  void add_use(std::uint32_t operand, std::uint32_t f, std::uint32_t from, std::uint32_t to) {
    const exact::Plane plane = a_.operands.bodies[operand]->plane(f);
    const bool turned = !exact::is_canonical(plane);
    // Left of from -> to seen from the outward normal; turning the view or the edge swaps the sides.
    const bool left = (from < to) != turned;
    a_.uses.push_back({std::min(from, to), std::max(from, to), a_.patch_of[a_.operands.base[operand] + f],
                       a_.planes.id(plane), none, none, left, turned});
  }

  Arrangement& a_;
};

}  // namespace

void connect(Arrangement& a, Glue glue) {
  Connector c(a);
  c.number_facets();
  for (std::uint32_t i = 0; i < a.operands.bodies.size(); ++i) {
    if (glue == Glue::vertices)
      c.glue_over_vertices(i);
    else
      c.glue_over_edges(i);
  }
  for (const std::uint32_t f : a.touched.members) a.patch_of[f] = none;
  c.collect_uses();
}

}  // namespace quoin::booleans
