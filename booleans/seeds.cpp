#include "booleans/seeds.h"

#include <map>
#include <numeric>
#include <optional>
#include <unordered_map>

#include "booleans/facets.h"

namespace quoin::booleans {
namespace {

/// A vertex of the arrangement by name: a table id, or an operand's own vertex that is not in the table.
using Name = std::uint64_t;
constexpr Name outside_table = Name{1} << 63;

/// One facet at one edge {v, w} of the extreme vertex v.
struct Corner {
  Name w;
  std::uint32_t node;
  exact::Plane plane;                // canonical
  std::optional<exact::Plane> line;  // another plane through the edge
  bool left;                         // left of v -> w, seen from the canonical normal
  bool turned;                       // patches: outward is against the canonical normal
};

class Seeder {
 public:
  Seeder(const Arrangement& a, const std::vector<std::uint32_t>& component_of, const std::vector<std::uint8_t>& placed)
      : a_(a),
        component_of_(component_of),
        placed_(placed),
        extreme_(placed.size()),
        corners_(placed.size()),
        direction_(placed.size()) {
    for (std::uint32_t c = 0; c < placed.size(); ++c)
      if (!placed[c]) open_.push_back(c);
  }

  std::vector<Seed> run() {
    if (open_.empty()) return {};
    find_extremes();
    collect_corners();
    for (const std::uint32_t c : open_) seeds_.push_back({outer_side(c), none});
    shoot();
    return std::move(seeds_);
  }

 private:
  static constexpr Name none_yet = ~Name{0};
  /// The smallest vertex found so far.
  struct Extreme {
    Name name = none_yet;
    std::array<double, 3> at{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  };

  Name name(std::uint32_t operand, std::uint32_t v) const {
    const auto& table = a_.touched.vertex_of[operand];
    if (!table.empty() && table[v] != none) return table[v];
    return outside_table | Name{operand} << 32 | v;
  }
  static std::uint32_t operand_of(Name n) { return static_cast<std::uint32_t>((n & ~outside_table) >> 32); }
  static std::uint32_t id_of(Name n) { return static_cast<std::uint32_t>(n); }
  exact::Point point(Name n) const {
    return n & outside_table ? a_.operands.bodies[operand_of(n)]->point(id_of(n)) : a_.vertices.point(id_of(n));
  }
  std::array<double, 3> approximation(Name n) const {
    return n & outside_table ? a_.operands.bodies[operand_of(n)]->approximation(id_of(n))
                             : a_.vertices.approximation(id_of(n));
  }
  bool is_grid(Name n) const {
    return n & outside_table ? a_.operands.bodies[operand_of(n)]->is_grid(id_of(n)) : a_.vertices.is_grid(id_of(n));
  }
  int compare(int k, Name x, Name y) const {
    const double p = approximation(x)[static_cast<std::size_t>(k)], q = approximation(y)[static_cast<std::size_t>(k)];
    if (p != q) return p < q ? -1 : 1;
    return is_grid(x) && is_grid(y) ? 0 : exact::compare_along(k, point(x), point(y));
  }

  void offer(std::uint32_t component, Name n, const std::array<double, 3>& at) {
    Extreme& best = extreme_[component];
    if (placed_[component]) return;
    if (at[0] > best.at[0] || best.name == n) return;  // most corners end here; rounding is monotone
    int order = best.name == none_yet ? -1 : 0;
    for (int k = 0; k < 3 && order == 0; ++k) order = compare(k, n, best.name);
    // Equal points under different names do not occur within one component: touching vertices are in the table.
    if (order < 0) best = {n, at};
  }

  void find_extremes() {
    for (const Use& u : a_.uses)
      for (const std::uint32_t v : {u.low, u.high}) offer(component_of_[u.facet], v, a_.vertices.approximation(v));
    for (const OperandChunk& c : a_.operands.chunks)
      if (c.box.low[0] <= farthest())
        for_untouched(c, [&](const Body& body, std::uint32_t face, std::uint32_t node) {
          body.for_corners(face, [&](std::uint32_t v) {
            const auto at = body.approximation(v);
            if (at[0] <= extreme_[component_of_[node]].at[0]) offer(component_of_[node], name(c.operand, v), at);
          });
        });
  }

  /// The largest x of all extremes found so far. With many components that is asked for once in a while only.
  double farthest() {
    if (open_.size() > few && asked_++ % open_.size() != 0) return farthest_;
    farthest_ = -HUGE_VAL;
    for (const std::uint32_t c : open_) farthest_ = std::max(farthest_, extreme_[c].at[0]);
    return farthest_;
  }

  /// visit(body, face, node) for the untouched faces of a chunk; faces count from the operand's first.
  template <class Visit>
  void for_untouched(const OperandChunk& c, Visit&& visit) const {
    for (std::uint32_t f = c.begin; f < c.end; ++f)
      if (a_.patch_of[f] != none)
        visit(*a_.operands.bodies[c.operand], f - a_.operands.base[c.operand], a_.patch_of[f]);
  }

  /// All facets of a component at its extreme vertex, edge by edge.
  void collect_corners() {
    std::unordered_multimap<Name, std::uint32_t> wanted;
    for (const std::uint32_t c : open_) wanted.emplace(extreme_[c].name, c);
    std::vector<std::vector<std::uint8_t>> is_wanted(a_.operands.bodies.size());  // per operand and own vertex
    for (std::uint32_t o = 0; o < is_wanted.size(); ++o) {
      is_wanted[o].resize(a_.operands.bodies[o]->vertex_count());
      for (const std::uint32_t v : a_.touched.table_vertices[o])
        if (wanted.contains(a_.touched.vertex_of[o][v])) is_wanted[o][v] = 1;
    }
    for (const std::uint32_t c : open_)
      if (const Name n = extreme_[c].name; n & outside_table) is_wanted[operand_of(n)][id_of(n)] = 1;
    const auto offer_corner = [&](Name v, Corner corner) {
      const auto range = wanted.equal_range(v);
      for (auto i = range.first; i != range.second; ++i)
        if (component_of_[corner.node] == i->second) corners_[i->second].push_back(corner);
    };
    for (const Use& u : a_.uses) {
      if (u.facet >= a_.facet_count()) continue;  // untouched faces follow
      const Corner corner{u.high, u.facet, a_.planes[u.plane], a_.planes[u.line], u.left, false};
      offer_corner(u.low, corner);
      Corner reversed = corner;
      reversed.w = u.low;
      reversed.left = !u.left;
      offer_corner(u.high, reversed);
    }
    std::vector<BoxTree::Item> points(open_.size());
    for (std::size_t i = 0; i < points.size(); ++i) points[i].box.add(extreme_[open_[i]].at);
    const BoxTree tree(points);
    for (const OperandChunk& c : a_.operands.chunks) {
      bool near = false;
      tree.meeting(c.box, [&](std::uint32_t) { near = true; });
      if (near)
        for_untouched(c, [&](const Body& body, std::uint32_t face, std::uint32_t node) {
          body.for_edges(face, [&](std::uint32_t u, std::uint32_t v) {
            for (const bool forward : {true, false}) {
              if (!is_wanted[c.operand][forward ? u : v]) continue;
              const exact::Plane p = body.plane(face);
              const bool turned = !exact::is_canonical(p);
              offer_corner(
                  name(c.operand, forward ? u : v),
                  {name(c.operand, forward ? v : u), node, turned ? p.opposite() : p, {}, forward != turned, turned});
            }
          });
        });
    }
  }

  std::optional<Direction> direction(Name v, Name w, const std::vector<const Corner*>& edge) const {
    Direction d;
    if (is_grid(v) && is_grid(w)) {
      const auto p = approximation(v), q = approximation(w);
      for (std::size_t k = 0; k < 3; ++k) d[k] = exact::Int<127>(static_cast<std::int64_t>(q[k] - p[k]));
      return d;
    }
    for (const Corner* c : edge) {
      for (const Corner* e : edge) {
        const exact::Plane& other = c == e && c->line ? *c->line : e->plane;
        if (exact::parallel(c->plane, other)) continue;
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
          const auto n = [](const exact::Plane& p, std::size_t m) { return exact::Coefficient(p.n[m]); };
          d[k] = n(c->plane, i) * n(other, j) - n(c->plane, j) * n(other, i);
        }
        // Orient it from v to w.
        for (int k = 0; k < 3; ++k) {
          const int s = d[static_cast<std::size_t>(k)].sign();
          if (s == 0) continue;
          if (compare(k, w, v) != s)
            for (auto& x : d) x = -x;
          return d;
        }
      }
    }
    return std::nullopt;
  }

  /// Does edge direction d come before e: vertical first, then least dy/dx, then least dz?
  static bool precedes(const Direction& d, const Direction& e) {
    const bool vertical = d[0].sign() == 0 && d[1].sign() == 0;
    if (vertical || (e[0].sign() == 0 && e[1].sign() == 0)) return vertical;
    if (const int slope = exact::compare(d[0] * e[1], d[1] * e[0])) return slope > 0;
    const std::size_t k = d[0].sign() != 0 ? 0 : 1;  // both run forward in this axis
    return exact::compare(d[2] * e[k], e[2] * d[k]) < 0;
  }

  Side outer_side(std::uint32_t component) {
    const Name v = extreme_[component].name;
    std::map<Name, std::vector<const Corner*>> edges;
    for (const Corner& c : corners_[component]) edges[c.w].push_back(&c);
    const std::vector<const Corner*>* chosen = nullptr;
    Direction best{};
    for (const auto& [w, edge] : edges) {
      const auto d = direction(v, w, edge);
      if (!d || (chosen && !precedes(*d, best))) continue;
      best = *d;
      chosen = &edge;
    }
    assert(chosen);
    direction_[component] = best;
    // The first facet counter-clockwise around the edge: it turns left to every other.
    int k = 0;
    while (best[static_cast<std::size_t>(k)].sign() == 0) ++k;
    const int forward = best[static_cast<std::size_t>(k)].sign();
    const Corner* first = (*chosen)[0];
    for (const Corner* c : *chosen) {
      const int turn = exact::cross_sign(c->plane, first->plane, k) * forward * (c->left == first->left ? 1 : -1);
      if (turn > 0) first = c;
    }
    // Counter-clockwise before a facet that lies left of its edge is its back, else its front.
    const bool back = first->left != first->turned;
    return 2 * first->node + (back ? 1 : 0);
  }

  /// Finds the nearest target in each ray's way.
  void shoot() {
    if (placed_.size() == 1) return;  // a ray meets other components only
    Box rays;
    for (const std::uint32_t c : open_) rays.add(extreme_[c].at);
    rays.low[1] = INT32_MIN;
    Targets targets(a_, rays);
    std::optional<BoxTree> tree;
    if (open_.size() > 4) {
      std::vector<BoxTree::Item> items(targets.size());
      for (std::uint32_t t = 0; t < items.size(); ++t) items[t] = {targets.box(t), t, t};
      tree.emplace(items);
    }
    const auto ray_of = [&](std::uint32_t c) {
      Box ray;
      ray.add(extreme_[c].at);
      ray.low[1] = INT32_MIN;
      return ray;
    };
    const auto for_targets = [&](const Box& ray, auto&& visit) {
      if (tree) return tree->meeting(ray, visit);
      for (std::uint32_t t = 0; t < targets.size(); ++t)
        if (targets.box(t).meets(ray)) visit(t);
    };
    // What the rays may meet; where many components stand above each other that is all.
    std::vector<std::uint32_t> wanted;
    for (std::size_t i = 0; i < open_.size() && wanted.size() <= 2 * targets.size(); ++i)
      for_targets(ray_of(open_[i]), [&](std::uint32_t t) { wanted.push_back(t); });
    if (wanted.size() > 2 * targets.size()) {
      wanted.resize(targets.size());
      std::iota(wanted.begin(), wanted.end(), 0u);
    }
    targets.prepare(wanted);
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const std::uint32_t c = open_[i];
      const RayStart start{point(extreme_[c].name), direction_[c]};
      Box ray = ray_of(c);
      std::uint32_t nearest = none;
      exact::Plane nearest_plane{};  // oriented towards +y
      bool nearest_turned = false;   // that is against the facet's front
      const auto consider = [&](std::uint32_t t) {
        bool turned = false;
        exact::Plane p = targets.plane(t, turned);
        if (p.n[1] == 0) return;
        if (p.n[1] < 0) {
          p = p.opposite();
          turned = !turned;
        }
        if (!in_front(p, start) || (nearest != none && !nearer(p, nearest_plane, start))) return;
        if (!targets.crossed(t, p, start)) return;
        nearest = t;
        nearest_plane = p;
        nearest_turned = turned;
        ray.low[1] = targets.box(t).low[1];  // nothing below is nearer
      };
      for_targets(ray, consider);
      // The ray comes down on the side that looks towards +y.
      seeds_[i].beyond = nearest == none ? none : 2 * targets.node(nearest) + (nearest_turned ? 1 : 0);
    }
  }

  /// Is the plane (p_y > 0) below s: is p(s) > 0? Its terms are p(v), p . d, then -p_y < 0.
  static bool in_front(const exact::Plane& p, const RayStart& s) {
    if (const int at_v = exact::side(p, s.v)) return at_v > 0;
    return dot(p, s.d).sign() > 0;
  }

  /// Is p met before q? The distances p(s) / p_y and q(s) / q_y compare term by term; those of t^2 are equal.
  static bool nearer(const exact::Plane& p, const exact::Plane& q, const RayStart& s) {
    const exact::Coefficient py(p.n[1]), qy(q.n[1]);
    ++exact::counters().fixed_width;
    if (const int c = exact::compare(exact::scaled_value(p, s.v) * qy, exact::scaled_value(q, s.v) * py)) return c < 0;
    if (const int c = exact::compare(dot(p, s.d) * qy, dot(q, s.d) * py)) return c < 0;
    if (const int c = exact::compare(exact::Coefficient(p.n[2]) * qy, exact::Coefficient(q.n[2]) * py)) return c > 0;
    return exact::compare(exact::Coefficient(p.n[0]) * qy, exact::Coefficient(q.n[0]) * py) < 0;
  }

  const Arrangement& a_;
  const std::vector<std::uint32_t>& component_of_;
  const std::vector<std::uint8_t>& placed_;
  std::vector<std::uint32_t> open_;  // the components that need a seed
  static constexpr std::size_t few = 8;
  std::vector<Extreme> extreme_;  // by component, as what follows
  double farthest_ = HUGE_VAL;
  std::size_t asked_ = 0;
  std::vector<std::vector<Corner>> corners_;
  std::vector<Direction> direction_;  // of each component's extreme edge
  std::vector<Seed> seeds_;           // by place in open_
};

}  // namespace

std::vector<Seed> find_seeds(const Arrangement& a, const std::vector<std::uint32_t>& component_of,
                             const std::vector<std::uint8_t>& placed) {
  return Seeder(a, component_of, placed).run();
}

}  // namespace quoin::booleans
