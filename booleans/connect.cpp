#include <numeric>
#include <tuple>

#include "booleans/arrangement.h"
#include "grid/stretches.h"

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

  /// Patches get their ids operand by operand, whichever is done first.
  void glue(Glue how) {
    const std::size_t n = a_.operands.bodies.size();
    std::vector<std::uint32_t> count(n), first(n);
    crowded_.resize(n);
    grid::in_tasks(n, a_.operands.face_count(), [&](std::size_t o) {
      const auto operand = static_cast<std::uint32_t>(o);
      count[o] = how == Glue::vertices ? glue_over_vertices(operand) : glue_over_edges(operand);
    });
    for (std::uint32_t o = 0; o < n; ++o) {
      first[o] = a_.node_count();
      a_.patch_operand.insert(a_.patch_operand.end(), count[o], o);
      if (a_.far_patch[o] != none) a_.far_patch[o] += first[o];
    }
    grid::in_stretches(a_.operands.chunks.size(), 1024, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const OperandChunk& c = a_.operands.chunks[i];
        const bool far = how == Glue::vertices && c.far;
        if (!far && first[c.operand] == 0) continue;
        for (std::uint32_t f = c.begin; f < c.end; ++f) {
          if (far)
            a_.patch_of[f] = first[c.operand];
          else if (a_.patch_of[f] != none)
            a_.patch_of[f] += first[c.operand];
        }
      }
    });
    for (const std::uint32_t f : a_.touched.members) a_.patch_of[f] = none;
    for (std::uint32_t o = 0; o < n; ++o) {
      if (!crowded_[o].empty()) a_.touched.vertex_of[o].resize(a_.operands.bodies[o]->vertex_count(), none);
      for (const auto& [f, u, v] : crowded_[o]) add_use(o, f, table_id(o, u), table_id(o, v));
    }
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
  /// Numbers the patches of one operand from 0; how many there are. Far faces are one patch, wherever they are: their
  /// labels are known. Near ones join it over vertices of the far faces around them.
  std::uint32_t glue_over_vertices(std::uint32_t operand) {
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
    std::uint32_t count = 0;
    if (std::any_of(chunks.begin(), chunks.end(), [](const OperandChunk& c) { return c.far; }))
      a_.far_patch[operand] = count++;
    std::vector<std::uint32_t> patch(body.vertex_count(), none);
    if (anchor != none) patch[parts.find(anchor)] = 0;
    for (const OperandChunk& c : chunks)
      if (!c.far)
        for_untouched(c, [&](std::uint32_t f) {
          std::uint32_t first = none;
          body.for_corners(f, [&](std::uint32_t v) { first = first == none ? v : first; });
          assign(operand, f, patch[parts.find(first)], count);
        });
    return count;
  }

  std::uint32_t glue_over_edges(std::uint32_t operand) {
    const Body& body = *a_.operands.bodies[operand];
    auto& adjacency = a_.touched.adjacency[operand];
    if (!adjacency || !adjacency->is_complete()) adjacency = std::make_unique<Adjacency>(body);
    Partition parts(body.face_count());
    for_untouched(operand, [&](std::uint32_t f) {
      body.for_edges(f, [&](std::uint32_t u, std::uint32_t v) {
        int count = 0;
        std::uint32_t mate = none;
        adjacency->faces_at_edge(u, v, [&](std::uint32_t g, bool forward) {
          ++count;
          if (g != f && !forward) mate = g;
        });
        if (count != 2 || mate == none)
          crowded_[operand].push_back({f, u, v});
        else if (untouched(operand, mate))
          parts.unite(f, mate);
      });
    });
    std::uint32_t count = 0;
    std::vector<std::uint32_t> patch(body.face_count(), none);
    for_untouched(operand, [&](std::uint32_t f) { assign(operand, f, patch[parts.find(f)], count); });
    return count;
  }

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
    grid::in_stretches(a_.vertices.size(), 4096, [&](std::size_t, std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v)
        std::sort(a_.uses.begin() + static_cast<std::ptrdiff_t>(v > 0 ? end[v - 1] : 0),
                  a_.uses.begin() + static_cast<std::ptrdiff_t>(end[v]), before);
    });
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
  void assign(std::uint32_t operand, std::uint32_t f, std::uint32_t& patch, std::uint32_t& count) {
    if (patch == none) patch = count++;
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
  std::vector<std::vector<std::array<std::uint32_t, 3>>> crowded_;  // (face, from, to) at edges of more than two faces
};

}  // namespace

void connect(Arrangement& a, Glue glue) {
  Connector c(a);
  c.number_facets();
  c.glue(glue);
  c.collect_uses();
}

}  // namespace quoin::booleans
