#include "booleans/candidates.h"

#include <functional>

#include "booleans/cell_filter.h"
#include "booleans/pair_search.h"
#include "booleans/triangle_pair.h"
#include "grid/stretches.h"

namespace quoin::booleans {
namespace {

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
    if (!apart(body.is_grid(v) ? exact::side(plane, body.grid_points[v]) : exact::side(plane, body.derived(v))))
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
  unsigned operator()(std::uint32_t i, std::uint32_t b) const {
    const Block &own = corners_[i / BoxBlock::width], &others = corners_[b];
    const std::size_t lane = i % BoxBlock::width;
    return lanes_with(std::array{others[0].data(), others[1].data(), others[2].data()},
                      std::array{own[0][lane], own[1][lane], own[2][lane]});
  }

 private:
  using Block = std::array<std::array<std::uint32_t, BoxBlock::width>, 3>;

  std::vector<Block> corners_;
};

/// Items, part by part, without most of those that share no cell with an item of another group.
/// visit_part(i, visit): visit(item) for the items of part i; `all` holds the `count` items, `factor` times as many
/// cells may be taken.
template <class VisitPart>
std::vector<BoxTree::Item> near_items(std::size_t parts, std::size_t count, const Box& all, std::size_t factor,
                                      VisitPart visit_part) {
  constexpr std::size_t length = 256, most_samples = 128, few = 256;
  if (count < few) {  // not worth it
    std::vector<BoxTree::Item> items;
    items.reserve(count);
    for (std::size_t i = 0; i < parts; ++i) visit_part(i, [&](const BoxTree::Item& item) { items.push_back(item); });
    return items;
  }
  const std::size_t stride = 1 + parts / most_samples;
  std::vector<Box> sample;
  for (std::size_t i = 0; i < parts; i += stride)
    visit_part(i, [&](const BoxTree::Item& item) { sample.push_back(item.box); });
  if (sample.empty()) sample.push_back(all);
  CellFilter cells(all, sample, count / sample.size() + 1, factor * count);
  std::vector<std::vector<BoxTree::Item>> kept(parts / length + 1);
  grid::in_stretches(parts, length, [&](std::size_t s, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      visit_part(i, [&](const BoxTree::Item& item) {
        cells.add(item.box, item.group);
        kept[s].push_back(item);
      });
  });
  grid::in_tasks(kept.size(), count, [&](std::size_t s) {
    std::erase_if(kept[s], [&](const BoxTree::Item& item) { return !cells.is_shared(item.box); });
  });
  std::size_t total = 0;
  for (const auto& k : kept) total += k.size();
  std::vector<BoxTree::Item> items;
  items.reserve(total);
  for (const auto& k : kept) items.insert(items.end(), k.begin(), k.end());
  return items;
}

/// The faces that may meet one of another operand: chunks are looked at first.
std::vector<BoxTree::Item> near_faces(const Operands& operands) {
  Box all;
  std::size_t count = 0;
  for (const OperandChunk& c : operands.chunks)
    if (!c.far) all.add(c.box), ++count;
  const auto chunks = near_items(operands.chunks.size(), count, all, 32, [&](std::size_t i, auto&& visit) {
    if (const OperandChunk& c = operands.chunks[i]; !c.far)
      visit(BoxTree::Item{c.box, static_cast<std::uint32_t>(i), c.operand});
  });
  count = 0;
  for (const BoxTree::Item& c : chunks) count += operands.chunks[c.id].end - operands.chunks[c.id].begin;
  return near_items(chunks.size(), count, all, 8, [&](std::size_t i, auto&& visit) {
    const OperandChunk& c = operands.chunks[chunks[i].id];
    for (std::uint32_t f = c.begin; f < c.end; ++f) {
      const Box box = face_box(*operands.bodies[c.operand], f - operands.base[c.operand]);
      if (operands.may_be_near(c.operand, box)) visit(BoxTree::Item{box, f, c.operand});
    }
  });
}

}  // namespace

std::vector<FaceIdPair> foreign_pairs(const Operands& operands) {
  const std::vector<BoxTree::Item> items = near_faces(operands);
  const bool few = operands.bodies.size() <= Operands::few;
  const BoxTree tree(items, few ? BoxTree::Order::by_group : BoxTree::Order::by_place);
  std::vector<SearchedFace> faces;
  faces.reserve(items.size());
  for (const std::uint32_t id : tree.ids()) {
    const auto [o, f] = operands.local(id);
    faces.push_back({operands.bodies[o], f});
  }
  const auto apart = [&](std::uint32_t i, std::uint32_t j) {
    const exact::Plane plane = faces[i].body->sign_plane(faces[i].face);
    return faces[j].corner_count() > TouchedFaces::large ? strictly_on_one_side(plane, tree.box(j))
                                                         : strictly_on_one_side(plane, *faces[j].body, faces[j].face);
  };
  const auto may_meet = [&](std::uint32_t i, std::uint32_t j) {
    if (faces[i].is_raw() && faces[j].is_raw())
      return meet(triangle(*faces[i].body, faces[i].face), triangle(*faces[j].body, faces[j].face));
    return !apart(i, j) && !apart(j, i);
  };
  return PairSearch(faces, tree, skip_nothing, may_meet).run(BoxTree::Pairs::foreign);
}

namespace {

/// All faces of a body, and a tree over them.
struct OwnFaces {
  explicit OwnFaces(const Body& body) : tree(items(body)) {
    for (const std::uint32_t f : tree.ids()) faces.push_back({&body, f});
  }
  static std::vector<BoxTree::Item> items(const Body& body) {
    std::vector<BoxTree::Item> r(body.face_count());
    for (std::uint32_t f = 0; f < r.size(); ++f) r[f] = {face_box(body, f), f, f};
    return r;
  }
  BoxTree tree;
  std::vector<SearchedFace> faces;
};

}  // namespace

std::vector<FaceIdPair> improper_pairs(const Body& mesh, const std::vector<Star>& star_of) {
  const OwnFaces own(mesh);
  const NeighbourMask neighbours(mesh, star_of, own.tree.ids());
  const auto wanted = [&](std::uint32_t i, std::uint32_t j) {
    return improper(mesh, own.faces[i].face, own.faces[j].face);
  };
  return PairSearch(own.faces, own.tree, std::cref(neighbours), wanted).run(BoxTree::Pairs::all);
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
    return body_.is_grid(v) ? exact::side(plane, body_.grid_points[v]) : exact::side(plane, body_.derived(v));
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
  std::vector<FaceIdPair> found;
  for (std::uint32_t f = 0; f < body.face_count(); ++f)
    if (prover.many_corners(f)) found.push_back({f, f});
  const OwnFaces own(body);
  const auto wanted = [&](std::uint32_t i, std::uint32_t j) {
    return !prover.proper(own.faces[i].face, own.faces[j].face);
  };
  const auto others = PairSearch(own.faces, own.tree, skip_nothing, wanted).run(BoxTree::Pairs::all);
  found.insert(found.end(), others.begin(), others.end());
  return found;
}

}  // namespace quoin::booleans
