#include "booleans/classify/seeds.h"

#include <map>
#include <optional>

#include "booleans/classify/shooter.h"

namespace quoin::booleans {
namespace {

/// The smallest vertex of a component found so far.
struct Extreme {
  AnyVertex vertex;
  std::array<double, 3> at{HUGE_VAL, HUGE_VAL, HUGE_VAL};
};

/// One facet at one edge {v, w} of the extreme vertex v of a component.
struct UseCorner {
  AnyVertex w;
  NodeId node;
  exact::Plane plane;                // canonical
  std::optional<exact::Plane> line;  // another plane through the edge
  bool left;                         // left of v -> w, seen from the canonical normal
  bool turned;                       // patches: outward is against the canonical normal
};

/// The components that need a seed.
struct Open {
  const Arrangement& a;
  const Components& components;
  const ById<ComponentId, std::uint8_t>& is_placed;
  std::vector<ComponentId> list;

  Open(const Arrangement& arrangement, const Components& all, const ById<ComponentId, std::uint8_t>& placed)
      : a(arrangement), components(all), is_placed(placed) {
    for (const ComponentId c : Ids<ComponentId>(all.count))
      if (!placed[c]) list.push_back(c);
  }
  ComponentId of(NodeId n) const { return components.of[n]; }
};

/// visit(body, face, node) for the untouched faces of a chunk; faces count from the operand's first.
template <class Visit>
void for_untouched(const Arrangement& a, const OperandChunk& c, Visit&& visit) {
  for (const FaceId f : Ids<FaceId>(c.begin, c.end))
    if (const NodeId n = a.patches().of[f]; n != none) visit(a.operands[c.operand], a.operands.own(c.operand, f), n);
}

/// Finds the extreme vertices of all open components.
class Extremes {
 public:
  explicit Extremes(const Open& open) : open_(open), best_(open.components.count) {
    const Arrangement& a = open.a;
    a.uses.for_edges([&](VertexId low, std::span<const Use> uses) {
      for (const Use& u : uses)
        for (const VertexId v : {low, u.high()}) offer(open.of(u.node()), v, a.names.vertices.approximation(v));
    });

    for (const OperandChunk& c : a.operands.chunks) {
      if (is_placed(c) || c.box.low[0] > farthest()) continue;
      for_untouched(a, c, [&](const Body& body, std::uint32_t face, NodeId node) {
        for (const std::uint32_t v : body.corners_of(face)) {
          const auto at = body.approximation(v);
          if (at[0] <= best_[open.of(node)].at[0]) offer(open.of(node), AnyVertex(a.names, c.operand, v), at);
        }
      });
    }
  }
  ById<ComponentId, Extreme> take() { return std::move(best_); }

 private:
  /// Far chunks belong to a patch that has its place.
  bool is_placed(const OperandChunk& c) const {
    const NodeId far = open_.a.patches().far[c.operand];
    return c.far && far != none && open_.is_placed[open_.of(far)];
  }
  void offer(ComponentId component, AnyVertex v, const std::array<double, 3>& at) {
    Extreme& best = best_[component];
    if (open_.is_placed[component]) return;
    if (at[0] > best.at[0] || best.vertex == v) return;  // most corners end here; rounding is monotone
    int order = best.vertex.is_nothing() ? -1 : 0;
    for (int k = 0; k < 3 && order == 0; ++k) order = v.compare_along(open_.a, k, best.vertex);
    // Equal points under different names do not occur within one component: touching vertices are in the table.
    if (order < 0) best = {v, at};
  }

  /// The largest x of all extremes found so far. With many components that is asked for once in a while only.
  double farthest() {
    if (open_.list.size() > grid::thresholds().few_components && asked_++ % open_.list.size() != 0) return farthest_;
    farthest_ = -HUGE_VAL;
    for (const ComponentId c : open_.list) farthest_ = std::max(farthest_, best_[c].at[0]);
    return farthest_;
  }

  const Open& open_;
  ById<ComponentId, Extreme> best_;
  double farthest_ = HUGE_VAL;
  std::size_t asked_ = 0;
};

/// Gathers all facets of the open components at their extreme vertices, edge by edge.
class CornerCollector {
 public:
  CornerCollector(const Open& open, const ById<ComponentId, Extreme>& extremes)
      : open_(open), extremes_(extremes), corners_(extremes.size()), is_wanted_(open.a.names.vertices.size()) {
    for (const ComponentId c : open.list)
      if (const AnyVertex v = extremes[c].vertex; v.is_named()) is_wanted_[v.named()] = 1;
    add_uses();
    add_untouched();
  }
  ById<ComponentId, std::vector<UseCorner>> take() { return std::move(corners_); }

 private:
  void offer(AnyVertex v, const UseCorner& corner) {
    const ComponentId c = open_.of(corner.node);
    if (extremes_[c].vertex == v) corners_[c].push_back(corner);
  }

  void add_uses() {
    open_.a.uses.for_edges([&](VertexId low, std::span<const Use> uses) {
      if (!is_wanted_[low] && !is_wanted_[uses[0].high()]) return;
      for (const Use& u : uses)
        if (u.is_facet()) add_facet(low, u);  // untouched faces follow
    });
  }

  /// Another plane through a facet's edge.
  PlaneId line(const Use& u) const {
    const Sheets& sheets = open_.a.sheets;
    const SheetId s = sheets.sheet_of(u.node());
    return sheets[s].elements[u.element().value - sheets.element(s, 0).value].line;
  }
  void add_facet(VertexId low, const Use& u) {
    const Arrangement& a = open_.a;
    UseCorner corner{u.high(), u.node(), a.names.planes[u.plane()], a.names.planes[line(u)], u.left(), false};
    offer(low, corner);
    corner.w = low;
    corner.left = !u.left();
    offer(u.high(), corner);
  }

  void add_untouched() {
    const Arrangement& a = open_.a;
    const auto is_wanted = wanted_vertices();
    Array<BoxTree::Item> points(open_.list.size());
    for (std::size_t i = 0; i < points.size(); ++i) points[i].box.add(extremes_[open_.list[i]].at);
    const BoxTree tree(points);

    for (const OperandChunk& c : a.operands.chunks) {
      Box box = c.box;
      bool near = false;
      tree.meeting(box, [&](std::uint32_t) {
        near = true;
        box = {};  // one is enough
      });
      if (!near) continue;
      for_untouched(a, c, [&](const Body& body, std::uint32_t face, NodeId node) {
        body.for_edges(face, [&](std::uint32_t u, std::uint32_t v) {
          for (const bool forward : {true, false})
            if (is_wanted[c.operand][forward ? u : v])
              add_edge(c.operand, face, node, forward ? u : v, forward ? v : u, forward);
        });
      });
    }
  }

  /// Of an untouched face, the edge from v to w; `forward`: the face runs that way.
  void add_edge(OperandId operand, std::uint32_t face, NodeId node, std::uint32_t v, std::uint32_t w, bool forward) {
    const Arrangement& a = open_.a;
    const exact::Plane p = a.operands[operand].plane(face);
    const bool turned = !exact::is_canonical(p);
    offer(AnyVertex(a.names, operand, v),
          {AnyVertex(a.names, operand, w), node, turned ? p.opposite() : p, {}, forward != turned, turned});
  }

  /// Per operand and own vertex: is it some component's extreme vertex?
  ById<OperandId, grid::Paged<std::uint8_t>> wanted_vertices() const {
    const Arrangement& a = open_.a;
    ById<OperandId, grid::Paged<std::uint8_t>> is_wanted(a.operands.bodies.size());
    for (const OperandId o : a.operands.ids()) {
      is_wanted[o] = grid::Paged<std::uint8_t>(a.operands[o].vertex_count());
      const OperandNames& names = a.names.operands[o];
      for (const std::uint32_t v : names.listed)
        if (is_wanted_[names.name_of[v]]) is_wanted[o].at(v) = 1;
    }
    for (const ComponentId c : open_.list)
      if (const AnyVertex v = extremes_[c].vertex; !v.is_nothing() && !v.is_named())
        is_wanted[v.operand()].at(v.own()) = 1;
    return is_wanted;
  }

  const Open& open_;
  const ById<ComponentId, Extreme>& extremes_;
  ById<ComponentId, std::vector<UseCorner>> corners_;
  ById<VertexId, std::uint8_t> is_wanted_;
};

/// The direction from v to w, where at least two planes through that edge are not parallel.
std::optional<Direction> direction(const Arrangement& a, AnyVertex v, AnyVertex w,
                                   const std::vector<const UseCorner*>& edge) {
  Direction d;
  if (v.is_grid(a) && w.is_grid(a)) {
    const auto p = v.approximation(a), q = w.approximation(a);
    for (std::size_t k = 0; k < 3; ++k) d[k] = exact::Int<127>(static_cast<std::int64_t>(q[k] - p[k]));
    return d;
  }

  const auto cross = [](const exact::Plane& p, const exact::Plane& q) {
    Direction r;
    const auto n = [](const exact::Plane& plane, std::size_t m) { return exact::Coefficient(plane.n[m]); };
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      r[k] = n(p, i) * n(q, j) - n(p, j) * n(q, i);
    }
    return r;
  };
  for (const UseCorner* c : edge)
    for (const UseCorner* e : edge) {
      const exact::Plane& other = c == e && c->line ? *c->line : e->plane;
      if (exact::parallel(c->plane, other)) continue;
      d = cross(c->plane, other);
      for (int k = 0; k < 3; ++k) {  // oriented from v to w
        const int s = d[static_cast<std::size_t>(k)].sign();
        if (s == 0) continue;
        if (w.compare_along(a, k, v) != s)
          for (auto& x : d) x = -x;
        return d;
      }
    }
  return std::nullopt;
}

/// Does edge direction d come before e: vertical first, then least dy/dx, then least dz?
bool precedes(const Direction& d, const Direction& e) {
  const bool vertical = d[0].sign() == 0 && d[1].sign() == 0;
  if (vertical || (e[0].sign() == 0 && e[1].sign() == 0)) return vertical;
  if (const int slope = exact::compare(d[0] * e[1], d[1] * e[0])) return slope > 0;
  const std::size_t k = d[0].sign() != 0 ? 0 : 1;  // both run forward in this axis
  return exact::compare(d[2] * e[k], e[2] * d[k]) < 0;
}

/// Where the ray of a component starts.
struct Start {
  SideId outer;
  Ray ray;
};

/// Nothing when no edge at v has two planes: of a clean operand that does not happen.
std::optional<Start> start_of(const Arrangement& a, AnyVertex v, const std::vector<UseCorner>& corners) {
  std::map<AnyVertex, std::vector<const UseCorner*>> edges;
  for (const UseCorner& c : corners) edges[c.w].push_back(&c);
  const std::vector<const UseCorner*>* chosen = nullptr;
  AnyVertex end;
  Direction best{};
  for (const auto& [w, edge] : edges) {
    const auto d = direction(a, v, w, edge);
    if (!d || (chosen && !precedes(*d, best))) continue;
    best = *d;
    end = w;
    chosen = &edge;
  }
  if (!chosen) return std::nullopt;

  // The first facet counter-clockwise around the edge: it turns left to every other.
  int k = 0;
  while (best[static_cast<std::size_t>(k)].sign() == 0) ++k;
  const int forward = best[static_cast<std::size_t>(k)].sign();
  const UseCorner* first = (*chosen)[0];
  for (const UseCorner* c : *chosen) {
    const int turn = exact::cross_sign(c->plane, first->plane, k) * forward * (c->left == first->left ? 1 : -1);
    if (turn > 0) first = c;
  }

  // Counter-clockwise before a facet that lies left of its edge is its back, else its front.
  const bool back = first->left != first->turned;
  return Start{back ? back_of(first->node) : front_of(first->node), {v, end, {v.point(a), best}}};
}

}  // namespace

std::vector<Seed> find_seeds(const Arrangement& a, const Components& components,
                             const ById<ComponentId, std::uint8_t>& is_placed) {
  const Open open(a, components, is_placed);
  if (open.list.empty()) return {};
  const auto extremes = Extremes(open).take();
  const auto corners = CornerCollector(open, extremes).take();

  std::vector<Seed> seeds;
  std::vector<Ray> rays;
  for (const ComponentId c : open.list) {
    const auto start = start_of(a, extremes[c].vertex, corners[c]);
    seeds.push_back({start ? start->outer : SideId(none), none});
    if (start) rays.push_back(start->ray);
  }
  if (components.count == 1) return seeds;  // a ray meets other components only

  Shooter shooter(a, rays);
  auto ray = rays.begin();
  for (Seed& s : seeds)
    if (s.outer != none) s.beyond = shooter.first_hit(*ray++);
  return seeds;
}

}  // namespace quoin::booleans
