#include "booleans/surface/valid.h"

#include <algorithm>
#include <atomic>
#include <tuple>

#include "booleans/pairs/neighbour_mask.h"
#include "booleans/surface/moving_mesh.h"
#include "booleans/surface/rational_triangles.h"
#include "grid/lists/loops.h"
#include "grid/lists/partition.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {

using exact::Rational;

namespace {

/// The proof for one mesh.
class Proof {
 public:
  explicit Proof(const MovingMesh& mesh) : mesh_(mesh), steady_(steady_stars(mesh)) {
    for (std::uint32_t t = mesh_.first_moved(); t < mesh_.triangle_count(); ++t) {
      if (!mesh_.has_moved(t)) continue;
      const Box own = mesh_.moving_box(t);
      moved_.push_back({own, t, 0});
      reach_.add(own);
    }
  }

  bool holds() { return pairs_are_proper() && (doubtful_.empty() || windings_are_right()); }

 private:
  using Doubtful = Array<std::uint32_t>;

  std::uint32_t steady_corner(std::uint32_t t, std::size_t k) const {
    const std::uint32_t v = mesh_.corners(t)[k];
    return steady_[v] ? v : none;
  }
  /// Have two triangles a vertex in common whose star stays embedded?
  bool are_neighbours(std::uint32_t t, std::uint32_t u) const {
    for (const std::uint32_t v : mesh_.corners(t))
      for (const std::uint32_t w : mesh_.corners(u))
        if (v == w && steady_[v]) return true;
    return false;
  }

  /// Adds triangles to `doubtful` where a pair is not seen to part all the way. False where they meet out of place.
  bool is_proper(std::uint32_t f, std::uint32_t g, Doubtful& doubtful) const {
    MovingTriangle t = mesh_.triangle(f), u = mesh_.triangle(g);
    const std::size_t shared = align(t, u);
    if (part_all_the_way(t, u, shared)) return true;

    doubtful.insert(doubtful.end(), {f, g});
    return !meet_out_of_place(rational(t.at), rational(u.at), shared);
  }

  /// Adds a triangle to `doubtful` where it may lose its area on its way.
  void examine(std::uint32_t t, Doubtful& doubtful) const {
    const auto c = mesh_.corners(t);
    if (steady_[c[0]] || steady_[c[1]] || steady_[c[2]]) return;
    if (facing(mesh_.triangle(t)) == 0) doubtful.push_back(t);
  }

  /// Of two triangles that moved.
  bool moved_are_proper(const BoxTree& tree) {
    Array<std::array<std::uint32_t, 2>> blocks;
    const auto never = [](std::size_t, std::uint32_t, std::uint32_t) { return false; };
    tree.block_pairs(BoxTree::Pairs::all, never, [&](std::uint32_t x, std::uint32_t y) { blocks.push_back({x, y}); });

    const NeighbourMask neighbours(tree.ids(), [&](std::uint32_t t, std::size_t k) { return steady_corner(t, k); });
    std::atomic<bool> proper = true;
    const std::size_t batch = grid::long_stretch(blocks.size(), 64);
    Array<Doubtful> doubtful(blocks.size() / batch + 1);
    grid::in_stretches(blocks.size(), batch, [&](std::size_t s, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && proper; ++i) {
        const auto [x, y] = blocks[i];
        LanePairs pairs = tree.lane_pairs(BoxTree::Pairs::all, x, y);
        pairs &= ~neighbours.among(pairs, x, y);
        BoxTree::for_lane_pairs(pairs, x, y, [&](std::uint32_t f, std::uint32_t g) {
          if (!is_proper(tree.ids()[f], tree.ids()[g], doubtful[s])) proper = false;
        });
      }
    });
    if (proper) doubtful_ = grid::joined(doubtful);
    return proper;
  }

  /// Of a triangle that did not move and one that did.
  bool others_are_proper(const BoxTree& tree) {
    std::atomic<bool> proper = true;
    const std::size_t count = mesh_.triangle_count(), batch = grid::long_stretch(count, 1024);
    Array<Doubtful> doubtful(count / batch + 1);
    grid::in_stretches(count, batch, [&](std::size_t s, std::size_t begin, std::size_t end) {
      for (auto t = static_cast<std::uint32_t>(begin); t < end && proper; ++t) {
        if (mesh_.has_moved(t)) {
          examine(t, doubtful[s]);
        } else if (mesh_.still_meets(t, reach_)) {
          tree.meeting(mesh_.still_box(t), [&](std::uint32_t u) {
            if (proper && !are_neighbours(t, u) && !is_proper(t, u, doubtful[s])) proper = false;
          });
        }
      }
    });
    for (const auto& part : doubtful) doubtful_.insert(doubtful_.end(), part.begin(), part.end());
    return proper;
  }

  bool pairs_are_proper() {
    const BoxTree tree(moved_);
    return moved_are_proper(tree) && others_are_proper(tree);
  }

  /// Triangles of one component, joined by edges of two triangles. A star that stays embedded hangs together by them.
  grid::Partition components() const {
    grid::Partition parts(mesh_.triangle_count());
    Array<std::uint32_t> first(mesh_.vertex_count(), none);
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t)
      for (const std::uint32_t v : mesh_.corners(t)) {
        if (!steady_[v]) continue;
        if (first[v] == none) first[v] = t;
        parts.unite(first[v], t);
      }
    unite_over_other_edges(parts);
    return parts;
  }
  void unite_over_other_edges(grid::Partition& parts) const {
    struct Edge {
      std::uint32_t low, high, triangle;
    };
    Array<Edge> edges;
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t)
      grid::for_loop_edges(mesh_.corners(t), [&](std::uint32_t u, std::uint32_t v) {
        if (steady_[u] || steady_[v]) return;
        const auto [low, high] = std::minmax({mesh_.place(u), mesh_.place(v)});
        edges.push_back({low, high, t});
      });
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
      return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });

    for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
      while (j < edges.size() && edges[j].low == edges[i].low && edges[j].high == edges[i].high) ++j;
      if (j - i == 2) parts.unite(edges[i].triangle, edges[i + 1].triangle);
    }
  }

  bool windings_are_right() {
    grid::Partition parts = components();
    for (std::uint32_t& t : doubtful_) t = parts.find(t);
    std::sort(doubtful_.begin(), doubtful_.end());
    doubtful_.erase(std::unique(doubtful_.begin(), doubtful_.end()), doubtful_.end());

    Array<BoxTree::Item> items(mesh_.triangle_count());
    for (std::uint32_t t = 0; t < items.size(); ++t) items[t] = {mesh_.moving_box(t), t, 0};
    const BoxTree tree(items);
    return std::all_of(doubtful_.begin(), doubtful_.end(),
                       [&](std::uint32_t t) { return winding_outside(t, tree) == 0; });
  }

  /// The winding number just outside a triangle, by a ray along an axis from a point inside it.
  int winding_outside(std::uint32_t t, const BoxTree& tree) const {
    const RationalTriangle own = rational(mesh_.triangle(t).at);
    const RationalPoint n = normal(own);
    const std::size_t k = n[0] != 0 ? 0 : n[1] != 0 ? 1 : 2;
    const bool up = n[k] > 0;
    Box ray = mesh_.moving_box(t);
    (up ? ray.high : ray.low)[k] = up ? INT32_MAX : INT32_MIN;
    Array<std::uint32_t> others;
    tree.meeting(ray, [&](std::uint32_t u) {
      if (u != t) others.push_back(u);
    });

    // Another point where the ray meets an edge: each edge rules out two points of a parabola at most.
    for (std::size_t attempt = 1; attempt <= 6 * others.size() + 1; ++attempt) {
      const Rational s(1, attempt + 2), weights[3] = {s, s * s, 1 - s - s * s};
      RationalPoint from{};
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) from[j] += weights[i] * own[i][j];

      int winding = 0;
      const bool is_clear = std::all_of(others.begin(), others.end(), [&](std::uint32_t u) {
        const auto step = passage(from, k, up, rational(mesh_.triangle(u).at));
        if (step) winding += *step;
        return step.has_value();
      });
      if (is_clear) return winding;
    }
    return 1;  // faces that are trusted, and overlap
  }

  const MovingMesh& mesh_;
  const Array<std::uint8_t> steady_;  // by vertex
  Array<BoxTree::Item> moved_;        // triangles of which a corner moved, ascending
  Box reach_;                         // of these
  Doubtful doubtful_;                 // triangles whose way is not known
};

}  // namespace

bool is_valid(const Body& body, const Triangulated& mesh, Floats floats, const grid::Lattice& lattice,
              const std::vector<double>& points, const Moves& moves) {
  if (moves.moved.empty()) return true;
  const RoundingEffects effects = rounding_effects(body, mesh, lattice, floats, points);
  if (effects != RoundingEffects{}) return false;

  // What moves by as much as the whole world has lost its shape.
  const double steps = moves.most / exact::to_double(lattice.step) * (1 + 0x1p-40);
  if (!(steps < exact::world)) return false;
  return Proof(MovingMesh(body, mesh, floats, lattice, points, moves)).holds();
}

}  // namespace quoin::booleans
