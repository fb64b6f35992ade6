#include "booleans/candidates.h"

#include <tbb/parallel_for.h>

#include <bit>
#include <cmath>

#include "booleans/triangle_pair.h"

namespace quoin::booleans {
namespace {

/// Collects the pairs that `wanted(pair)` accepts, in order, testing many at a time in parallel.
template <class Wanted>
class Sieve {
 public:
  explicit Sieve(Wanted wanted) : wanted_(wanted) {}
  void operator()(std::uint32_t f, std::uint32_t g) {
    waiting_.push_back({std::min(f, g), std::max(f, g)});
    if (waiting_.size() == most) test();
  }
  std::vector<FaceIdPair> take() {
    test();
    return std::move(found_);
  }

 private:
  static constexpr std::size_t most = std::size_t{1} << 19, chunk = 1024;

  void test() {
    keep_.resize(waiting_.size());
    tbb::parallel_for(std::size_t{0}, (waiting_.size() + chunk - 1) / chunk, [&](std::size_t c) {
      for (std::size_t i = c * chunk; i < std::min(waiting_.size(), (c + 1) * chunk); ++i)
        keep_[i] = wanted_(waiting_[i]);
    });
    for (std::size_t i = 0; i < waiting_.size(); ++i)
      if (keep_[i]) found_.push_back(waiting_[i]);
    waiting_.clear();
  }

  Wanted wanted_;
  std::vector<FaceIdPair> waiting_, found_;
  std::vector<std::uint8_t> keep_;
};

/// The corners of a box that lie lowest and highest along a direction.
std::array<exact::GridPoint, 2> ends_along(const std::array<std::int64_t, 3>& n, const Box& box) {
  std::array<exact::GridPoint, 2> r{};
  for (std::size_t k = 0; k < 3; ++k) {
    r[0].c[k] = n[k] < 0 ? box.high[k] : box.low[k];
    r[1].c[k] = n[k] < 0 ? box.low[k] : box.high[k];
  }
  return r;
}

/// Does the box lie strictly on one side of the plane?
bool strictly_on_one_side(const exact::Plane& plane, const Box& box) {
  const auto [lowest, highest] = ends_along(plane.n, box);
  return exact::side(plane, lowest) > 0 || exact::side(plane, highest) < 0;
}

/// Do all corners of the face lie strictly on one side of the plane?
bool strictly_on_one_side(const exact::Plane& plane, const Body& body, std::uint32_t face) {
  int seen = 0;
  const auto apart = [&](int s) {
    if (s == 0 || s * seen < 0) return false;
    seen = s;
    return true;
  };
  if (face < body.triangles.size()) {
    for (std::uint32_t v : body.triangles[face])
      if (!apart(exact::side(plane, body.grid_points[v]))) return false;
    return true;
  }
  const std::size_t p = face - body.triangles.size();
  for (std::uint32_t c = body.loop_corners[body.polygon_loops[p]]; c < body.loop_corners[body.polygon_loops[p + 1]];
       ++c) {
    const std::uint32_t v = body.corners[c];
    if (!apart(body.is_grid(v) ? exact::side(plane, body.grid_points[v])
                               : exact::side(plane, body.points[v - body.grid_points.size()])))
      return false;
  }
  return true;
}

GridTriangle triangle(const Body& body, std::uint32_t t) {
  const auto& c = body.triangles[t];
  return {body.grid_points[c[0]], body.grid_points[c[1]], body.grid_points[c[2]]};
}

/// Do two triangles of one mesh meet anywhere but in a common corner or edge, or overlap across one?
bool improper(const Body& mesh, std::uint32_t s, std::uint32_t t) {
  const GridTriangle p = triangle(mesh, s), q = triangle(mesh, t);
  const auto &a = mesh.triangles[s], &b = mesh.triangles[t];
  std::array<std::size_t, 3> shared_a{}, shared_b{};
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (a[i] == b[j]) shared_a[shared] = i, shared_b[shared++] = j;
  if (shared == 3) return true;
  if (shared == 2) {
    // Coplanar with both third corners on one side of the common edge: an overlap.
    const std::size_t i = 3 - shared_a[0] - shared_a[1], j = 3 - shared_b[0] - shared_b[1];
    if (orientation(p[0], p[1], p[2], q[j]) != 0) return false;
    const auto n = exact::plane_through(p[0], p[1], p[2]),
               m = exact::plane_through(p[shared_a[0]], p[shared_a[1]], q[j]);
    const auto own = exact::plane_through(p[shared_a[0]], p[shared_a[1]], p[i]);
    return n && m && own && exact::dot_sign(*m, *own) > 0;
  }
  if (shared == 1) {
    // What they share besides the corner reaches the opposite side of one of them.
    const std::size_t i = shared_a[0], j = shared_b[0];
    return meet(p[(i + 1) % 3], p[(i + 2) % 3], q) || meet(q[(j + 1) % 3], q[(j + 2) % 3], p);
  }
  return meet(p, q);
}

/// Triangles that share a vertex whose star is embedded meet as they should: nearly all pairs are of this kind.
class NeighbourMask {
 public:
  NeighbourMask(const Body& mesh, const std::vector<Star>& star_of, const std::vector<std::uint32_t>& order)
      : corners_((order.size() + BoxBlock::width - 1) / BoxBlock::width) {
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = mesh.triangles[order[i]][k];
        // Other vertices get a name that no triangle has twice.
        corners_[i / BoxBlock::width][k][i % BoxBlock::width] =
            star_of[v] == Star::embedded ? v : none - static_cast<std::uint32_t>(i);
      }
  }
  /// The lanes of block b that are neighbours of the i-th triangle.
  unsigned operator()(std::uint32_t i, std::uint32_t b, unsigned) const {
    const Block &own = corners_[i / BoxBlock::width], &others = corners_[b];
    unsigned r = 0;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t m = 0; m < 3; ++m) r |= lanes_equal(others[m].data(), own[k][i % BoxBlock::width]);
    return r;
  }

 private:
  using Block = std::array<std::array<std::uint32_t, BoxBlock::width>, 3>;

  std::vector<Block> corners_;
};

}  // namespace

namespace {

/// Drops items that share no cell of a uniform grid with an item of another group. `work` bounds the number of cells
/// and the number of cells that all boxes take together: cells are as fine as that allows.
class CellFilter {
 public:
  CellFilter(const std::vector<BoxTree::Item>& items, std::size_t work) {
    if (items.empty()) return;
    for (const BoxTree::Item& i : items) all_.add(i.box);
    while (cell_count() > std::min(work, std::size_t{1} << 21)) ++shift_;
    while (shift_ < 31 && coverage(items) > work) ++shift_;
    owner_.assign(cell_count(), none);
    for (const BoxTree::Item& i : items)
      for_cells(i.box, [&](std::uint32_t& owner) {
        if (owner == none)
          owner = i.group;
        else if (owner != i.group)
          owner = mixed;
        return true;
      });
  }
  bool keeps(const Box& box) {
    bool found = false;
    for_cells(box, [&](std::uint32_t owner) { return !(found = owner == mixed); });
    return found;
  }

 private:
  static constexpr std::uint32_t mixed = none - 1;

  std::uint32_t cell(std::size_t k, std::int32_t x) const {
    return static_cast<std::uint32_t>(std::int64_t{x} - all_.low[k]) >> shift_;
  }
  std::size_t cell_count() const {
    std::size_t n = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      n *= std::size_t{cell(k, all_.high[k])} + 1;
      if (n > std::size_t{1} << 32) break;
    }
    return n;
  }
  /// How many cells the boxes take together, as some of them tell.
  std::size_t coverage(const std::vector<BoxTree::Item>& items) const {
    const std::size_t stride = 1 + items.size() / 4096;
    std::size_t sum = 0;
    for (std::size_t i = 0; i < items.size(); i += stride) {
      const Box& box = items[i].box;
      std::size_t n = stride;
      for (std::size_t k = 0; k < 3; ++k) n *= std::size_t{cell(k, box.high[k])} - cell(k, box.low[k]) + 1;
      sum += n;
    }
    return sum;
  }
  /// visit(owner) until it returns false.
  template <class Visit>
  void for_cells(const Box& box, Visit&& visit) {
    std::array<std::uint32_t, 3> low{}, high{};
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = cell(k, box.low[k]);
      high[k] = cell(k, box.high[k]);
    }
    const std::size_t ny = cell(1, all_.high[1]) + std::size_t{1}, nx = cell(0, all_.high[0]) + std::size_t{1};
    for (std::size_t z = low[2]; z <= high[2]; ++z)
      for (std::size_t y = low[1]; y <= high[1]; ++y)
        for (std::size_t x = low[0]; x <= high[0]; ++x)
          if (!visit(owner_[(z * ny + y) * nx + x])) return;
  }

  Box all_;
  int shift_ = 0;
  std::vector<std::uint32_t> owner_;  // the group of the items in each cell, none or mixed
};

/// Drops items that share no cell with an item of another group.
void keep_near(std::vector<BoxTree::Item>& items, std::size_t work) {
  CellFilter cells(items, work);
  std::erase_if(items, [&](const BoxTree::Item& i) { return !cells.keeps(i.box); });
}

/// The faces that may meet a foreign one, with their boxes, in order; first whole chunks are dropped.
std::vector<BoxTree::Item> near_faces(const Operands& operands) {
  std::vector<BoxTree::Item> chunks, faces;
  for (std::uint32_t i = 0; i < operands.chunks.size(); ++i)
    if (const OperandChunk& c = operands.chunks[i]; !c.far) chunks.push_back({c.box, i, c.operand});
  keep_near(chunks, operands.face_count());
  for (const BoxTree::Item& item : chunks) {
    const OperandChunk& c = operands.chunks[item.id];
    for (std::uint32_t f = c.begin; f < c.end; ++f) {
      const Box box = face_box(*operands.bodies[c.operand], f - operands.base[c.operand]);
      if (operands.may_be_near(c.operand, box)) faces.push_back({box, f, c.operand});
    }
  }
  keep_near(faces, 4 * faces.size());
  return faces;
}

/// How far a face reaches along a direction.
struct Reach {
  std::int64_t low = INT64_MAX, high = INT64_MIN;
  void add(std::int64_t x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  bool apart(const Reach& r) const { return high < r.low || r.high < low; }
};

/// A slab around the eight faces of each block of a tree. Neighbours on a surface lie nearly in one plane, so the slab
/// is thin, and a face strictly on one side of it meets none of the eight, however much the boxes overlap: those of
/// long thin diagonal triangles do. Two bundles of such triangles that cross are also compared along the direction that
/// is perpendicular to both. Directions come from doubles, what lies along them is exact: any direction is right.
class BlockSlabs {
 public:
  BlockSlabs(const Operands& operands, const std::vector<std::uint32_t>& order)
      : slabs_((order.size() + BoxBlock::width - 1) / BoxBlock::width) {
    faces_.reserve(order.size());
    for (std::uint32_t id : order) {
      const auto [o, f] = operands.local(id);
      const Body& body = *operands.bodies[o];
      faces_.push_back({&body, f, f < body.triangles.size() ? Box{} : face_box(body, f)});
    }
    for (std::size_t b = 0; b < slabs_.size(); ++b) slabs_[b] = slab(b);
  }
  /// The lanes of block b that cannot meet the i-th face of the order: all, when it lies strictly on one side of the
  /// block's slab, else those strictly on one side of its own block's.
  unsigned operator()(std::uint32_t i, std::uint32_t b, unsigned lanes) {
    constexpr unsigned all = ~0u;
    const std::uint32_t own = i / BoxBlock::width;
    if (asked_ != std::array{own, b}) {
      asked_ = {own, b};
      bundles_apart_ = slabs_[own].is_bundle && slabs_[b].is_bundle && bundles_apart(own, b);
    }
    if (bundles_apart_ || slabs_[b].reach.apart(reach(faces_[i], slabs_[b].normal))) return all;
    unsigned r = 0;
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
      const Face& face = faces_[b * BoxBlock::width + lane];
      r |= static_cast<unsigned>(slabs_[own].reach.apart(reach(face, slabs_[own].normal))) << lane;
    }
    return r;
  }

 private:
  // Components below 2^30 and coordinates up to 2^29 + 1 make values below 2^61: all exact.
  using Normal = std::array<std::int64_t, 3>;
  struct Slab {
    Normal normal;
    Reach reach;
    Normal along;    // of the longest edge of a triangle, components below 2^14
    bool is_bundle;  // the triangles are long and thin
  };
  struct Face {
    const Body* body;
    std::uint32_t id;
    Box box;  // of polygons
  };

  static std::int64_t value(const Normal& n, const exact::GridPoint& p) {
    return n[0] * p.c[0] + n[1] * p.c[1] + n[2] * p.c[2];
  }
  static Reach reach(const Face& f, const Normal& n) {
    Reach r;
    if (f.id < f.body->triangles.size()) {
      for (const std::uint32_t v : f.body->triangles[f.id]) r.add(value(n, f.body->grid_points[v]));
      return r;
    }
    const auto [low, high] = ends_along(n, f.box);
    r.add(value(n, low));
    r.add(value(n, high));
    return r;
  }
  Reach reach(std::size_t block, const Normal& n) const {
    Reach r;
    const std::size_t begin = block * BoxBlock::width, end = std::min(begin + BoxBlock::width, faces_.size());
    for (std::size_t i = begin; i < end; ++i) {
      const Reach own = reach(faces_[i], n);
      r.add(own.low);
      r.add(own.high);
    }
    return r;
  }
  /// Components below 2 * 2^28.
  bool bundles_apart(std::size_t a, std::size_t b) const {
    const Normal &u = slabs_[a].along, &v = slabs_[b].along;
    Normal n{};
    for (std::size_t k = 0; k < 3; ++k) n[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
    return reach(a, n).apart(reach(b, n));
  }
  /// In the direction of d, components at most `size`.
  static Normal scaled(const std::array<double, 3>& d, int size) {
    const double longest = std::max({std::fabs(d[0]), std::fabs(d[1]), std::fabs(d[2])});
    Normal n{};
    for (std::size_t k = 0; k < 3; ++k) n[k] = longest > 0 ? static_cast<std::int64_t>(d[k] * size / longest) : 0;
    return n;
  }
  /// The directions in which eight neighbours are likely to be thin.
  Slab slab(std::size_t block) const {
    const std::size_t begin = block * BoxBlock::width, end = std::min(begin + BoxBlock::width, faces_.size());
    std::array<double, 3> sum{}, along{};
    double area = 0, longest = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const Body& body = *faces_[i].body;
      const exact::Plane p = body.sign_plane(faces_[i].id);
      const std::array<double, 3> normal{double(p.n[0]), double(p.n[1]), double(p.n[2])};
      for (std::size_t k = 0; k < 3; ++k) sum[k] += normal[k];
      area += std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
      if (faces_[i].id >= body.triangles.size()) {
        area = HUGE_VAL;  // of triangles only
        continue;
      }
      const auto& t = body.triangles[faces_[i].id];
      for (std::size_t c = 0; c < 3; ++c) {
        std::array<double, 3> e{};
        for (std::size_t k = 0; k < 3; ++k)
          e[k] = double(body.grid_points[t[c]].c[k]) - double(body.grid_points[t[(c + 1) % 3]].c[k]);
        const double length = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
        if (length > longest) longest = length, along = e;
      }
    }
    Slab s{scaled(sum, (1 << 30) - 1), {}, scaled(along, (1 << 14) - 1), 4 * area < longest};
    s.reach = reach(block, s.normal);
    return s;
  }

  std::vector<Face> faces_;  // in the tree's order
  std::vector<Slab> slabs_;
  std::array<std::uint32_t, 2> asked_{none, none};  // the last two blocks
  bool bundles_apart_ = false;
};

}  // namespace

std::vector<FaceIdPair> foreign_pairs(const Operands& operands) {
  const std::vector<BoxTree::Item> items = near_faces(operands);
  const auto box_of = [&](std::uint32_t face) -> const Box& {  // items are in the order of their ids
    return std::lower_bound(items.begin(), items.end(), face,
                            [](const BoxTree::Item& i, std::uint32_t id) { return i.id < id; })
        ->box;
  };
  const auto apart = [&](const Body& body, std::uint32_t f, const Body& other, std::uint32_t g, std::uint32_t id) {
    const exact::Plane plane = body.sign_plane(f);
    return other.corner_count(g) > TouchedFaces::large ? strictly_on_one_side(plane, box_of(id))
                                                       : strictly_on_one_side(plane, other, g);
  };
  Sieve sieve([&](const FaceIdPair& pair) {
    const auto [o, f] = operands.local(pair[0]);
    const auto [p, g] = operands.local(pair[1]);
    const Body &a = *operands.bodies[o], &b = *operands.bodies[p];
    if (f < a.triangles.size() && g < b.triangles.size()) return meet(triangle(a, f), triangle(b, g));
    return !apart(a, f, b, g, pair[1]) && !apart(b, g, a, f, pair[0]);
  });
  const bool few = operands.bodies.size() <= Operands::few;
  const BoxTree tree(items, few ? BoxTree::Order::by_group : BoxTree::Order::by_place);
  BlockSlabs slabs(operands, tree.ids());
  tree.foreign_pairs_but(slabs, sieve);
  return sieve.take();
}

std::vector<FaceIdPair> improper_pairs(const Body& mesh, const std::vector<Star>& star_of) {
  std::vector<BoxTree::Item> items(mesh.triangles.size());
  for (std::uint32_t t = 0; t < items.size(); ++t) items[t] = {face_box(mesh, t), t, t};
  Sieve sieve([&](const FaceIdPair& pair) { return improper(mesh, pair[0], pair[1]); });
  const BoxTree tree(items);
  const NeighbourMask neighbours(mesh, star_of, tree.ids());
  tree.pairs_but(neighbours, sieve);
  return sieve.take();
}

namespace {

/// Proves that faces of one body meet in common corners and edges only, where one look at a plane is enough.
class Prover {
 public:
  explicit Prover(const Body& body) : body_(body), adjacency_(body) {
    for (std::uint32_t f = 0; f < body.face_count(); ++f)
      if (f >= body.triangles.size()) for_points(f, [&](std::uint32_t v) { points_.push_back({v, f}); });
    std::sort(points_.begin(), points_.end());
  }

  bool many_corners(std::uint32_t f) const { return body_.corner_count(f) > 3; }

  bool proper(std::uint32_t f, std::uint32_t g) const {
    if (body_.corner_count(f) > body_.corner_count(g)) std::swap(f, g);
    return meets_in_common_parts(f, g) || (body_.corner_count(g) <= small && meets_in_common_parts(g, f));
  }

 private:
  static constexpr std::size_t small = 16;

  /// visit(v) for the loops of one corner.
  template <class Visit>
  void for_points(std::uint32_t f, Visit&& visit) const {
    const std::size_t p = f - body_.triangles.size();
    for (std::uint32_t j = body_.polygon_loops[p]; j < body_.polygon_loops[p + 1]; ++j)
      if (const auto loop = body_.loop(j); loop.size() == 1) visit(loop[0]);
  }
  int side(const exact::Plane& plane, std::uint32_t v) const {
    return body_.is_grid(v) ? exact::side(plane, body_.grid_points[v])
                            : exact::side(plane, body_.points[v - body_.grid_points.size()]);
  }
  bool lists(std::uint32_t face, std::uint32_t v) const {
    bool found = false;
    adjacency_.edges_at_vertex(v, [&](std::uint32_t g, std::uint32_t, bool) { found = found || g == face; });
    return found || std::binary_search(points_.begin(), points_.end(), FaceIdPair{v, face});
  }
  bool lists(std::uint32_t face, std::uint32_t u, std::uint32_t v) const {
    bool found = false;
    adjacency_.faces_at_edge(u, v, [&](std::uint32_t g, bool) { found = found || g == face; });
    return found;
  }
  /// Does f lie on one closed side of g's plane, and does g list all that f has on it? A face that a plane does not
  /// cross meets it in corners and edges only.
  bool meets_in_common_parts(std::uint32_t f, std::uint32_t g) const {
    const exact::Plane plane = body_.sign_plane(g);
    int seen = 0;
    bool good = true, on_plane = false;
    body_.for_corners(f, [&](std::uint32_t v) {
      if (!good) return;
      const int s = side(plane, v);
      good = s * seen >= 0 && (s != 0 || lists(g, v));
      seen = s != 0 ? s : seen;
      on_plane = on_plane || s == 0;
    });
    if (!good || seen == 0) return false;
    if (!on_plane) return true;
    body_.for_edges(f, [&](std::uint32_t u, std::uint32_t v) {
      if (good && side(plane, u) == 0 && side(plane, v) == 0) good = lists(g, u, v);
    });
    return good;
  }

  const Body& body_;
  const Adjacency adjacency_;
  std::vector<FaceIdPair> points_;  // (vertex, face), sorted
};

}  // namespace

std::vector<FaceIdPair> doubtful_pairs(const Body& body) {
  const Prover prover(body);
  std::vector<BoxTree::Item> items(body.face_count());
  for (std::uint32_t f = 0; f < items.size(); ++f) items[f] = {face_box(body, f), f, f};
  Sieve sieve([&](const FaceIdPair& pair) { return pair[0] == pair[1] || !prover.proper(pair[0], pair[1]); });
  for (std::uint32_t f = 0; f < items.size(); ++f)
    if (prover.many_corners(f)) sieve(f, f);
  BoxTree(items).pairs(sieve);
  return sieve.take();
}

}  // namespace quoin::booleans
