#include "booleans/arrangement/touched.h"

#include <functional>
#include <unordered_map>

#include "booleans/arrangement/spared_loops.h"
#include "booleans/body/adjacency.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {
namespace {

/// The touched faces of one operand, before their planes and vertices have names.
struct TouchedPart {
  struct Edge {
    std::uint32_t from, to;  // own vertices
    std::uint32_t other;     // index into planes
    std::uint32_t across;    // the only other face at the edge, which runs backward there; none where that is not known
    std::uint32_t border = none;  // number of that border of the body
  };
  struct Use {
    std::uint32_t from, to, face;  // own vertices, own face
  };
  ById<TouchedId, TouchedFace> faces;  // their planes are to come; ranges count from this part's first
  Array<exact::Plane> planes;          // those of the faces, then others
  Array<Edge> edges;
  Array<std::uint32_t> isolated;  // own vertices
  Array<std::uint32_t> spared;    // own loops
  Array<Use> untouched;
  struct Member {
    std::uint32_t face;  // own
    TouchedId touched;
  };
  Array<Member> members;
};

bool same_plane(const exact::Plane& p, const exact::Plane& q) { return p == q || p == q.opposite(); }

/// Collects the touched faces of one operand.
class Collector {
 public:
  /// `named`: the faces in pairs, own numbers in ascending order. `hubs`: points where faces may meet others that no
  /// pair says so of, ascending.
  Collector(const Operands& operands, OperandId operand, std::span<const std::uint32_t> named,
            std::span<const exact::GridPoint> hubs)
      : body_(operands[operand]),
        hubs_(hubs),
        spared_(operands, operand, named),
        touched_of_(operands[operand].face_count(), none) {
    index(operands, operand, named);
    reserve(named.size());

    for (const std::uint32_t f : named) {
      if (touched_of_[f] != none) continue;
      if (f < body_.triangles.size())
        add_flat_region(f);
      else
        add_polygon(f);
    }
    for (const TouchedId t : Ids<TouchedId>(part.faces.size())) find_other_planes(t);
  }

  TouchedPart part;

 private:
  /// visit(loop) for the loops of a face that are drawn, the outer one first where others are spared.
  template <class Visit>
  void for_drawn_loops(std::uint32_t f, Visit&& visit) const {
    if (f < body_.triangles.size()) return visit(std::span<const std::uint32_t>(body_.triangles[f]));
    const std::uint32_t p = body_.polygon(f);
    const SparedLoops::Face* spared = spared_.find(p);
    const std::uint32_t outer = spared ? spared->outer_loop : none;
    if (outer != none) visit(body_.polygons.loop(outer));
    for (std::uint32_t j = body_.polygons.face_start[p]; j < body_.polygons.face_start[p + 1]; ++j)
      if (j != outer && !spared_[j]) visit(body_.polygons.loop(j));
  }

  Box box_of(std::uint32_t f) const {
    const SparedLoops::Face* spared = f < body_.triangles.size() ? nullptr : spared_.find(body_.polygon(f));
    return spared ? spared->box : face_box(body_, f);
  }

  /// A face with a vertex that is drawn has that vertex in one of the boxes: the first holds all faces whose loops are
  /// all drawn; what else is drawn is little.
  void index(const Operands& operands, OperandId operand, std::span<const std::uint32_t> named) {
    grid::Numbering drawn(body_.vertex_count());
    Array<Box> boxes(1);
    for (const std::uint32_t f : named) {
      const bool is_whole = f < body_.triangles.size() || !spared_.find(body_.polygon(f));
      if (is_whole) boxes[0].add(face_box(body_, f));
      for_drawn_loops(f, [&](std::span<const std::uint32_t> loop) {
        for (const std::uint32_t v : loop) drawn.add(v);
        if (!is_whole && loop.size() == 1) add_edge(loop[0], loop[0], boxes);
        if (!is_whole) grid::for_loop_edges(loop, [&](std::uint32_t u, std::uint32_t v) { add_edge(u, v, boxes); });
      });
    }
    adjacency_ = std::make_unique<const Adjacency>(body_, std::move(drawn), operands.chunks_meeting(operand, boxes));
  }
  /// Of many edges one box is as good.
  void add_edge(std::uint32_t u, std::uint32_t v, Array<Box>& boxes) const {
    constexpr std::size_t most = 64;
    Box edge;
    body_.add_to(edge, u);
    body_.add_to(edge, v);
    if (boxes.size() < most)
      boxes.push_back(edge);
    else
      boxes.back().add(edge);
  }

  void reserve(std::size_t named) {
    part.faces.reserve(named);
    part.planes.reserve(4 * named);
    part.edges.reserve(4 * named);
    part.members.reserve(2 * named);
    part.untouched.reserve(2 * named);
  }

  /// Knows one end of the edge. Regions that reach far make it complete.
  const Adjacency& at_edge(std::uint32_t u, std::uint32_t v) {
    if (!adjacency_->knows(u) && !adjacency_->knows(v)) adjacency_ = std::make_unique<const Adjacency>(body_);
    return *adjacency_;
  }

  void begin_region(std::uint32_t f, const exact::Plane& plane) {
    TouchedFace face{};
    face.source = f;
    face.along = exact::is_canonical(plane);
    face.edges_begin = static_cast<std::uint32_t>(part.edges.size());
    face.isolated_begin = static_cast<std::uint32_t>(part.isolated.size());
    face.spared_begin = static_cast<std::uint32_t>(part.spared.size());
    part.faces.push_back(face);
    part.planes.push_back(plane);
  }
  void add_member(std::uint32_t f) {
    const TouchedId t = static_cast<std::uint32_t>(part.faces.size() - 1);
    touched_of_.at(f) = t;
    part.faces.back().box.add(box_of(f));
    part.members.push_back({f, t});
  }
  /// Is the face one of the region that has begun?
  bool is_member(std::uint32_t f) const {
    return f != none && touched_of_[f] == TouchedId(static_cast<std::uint32_t>(part.faces.size() - 1));
  }
  void end_region() {
    part.faces.back().edges_end = static_cast<std::uint32_t>(part.edges.size());
    part.faces.back().isolated_end = static_cast<std::uint32_t>(part.isolated.size());
    part.faces.back().spared_end = static_cast<std::uint32_t>(part.spared.size());
  }

  /// All triangles coplanar with t, equally oriented, that carry the same and are connected with it over edges of
  /// exactly two faces.
  void add_flat_region(std::uint32_t t) {
    const exact::Plane plane = body_.plane(t);
    const std::size_t first = part.members.size();
    begin_region(t, plane);
    add_member(t);

    for (std::size_t i = first; i < part.members.size(); ++i) {
      const std::uint32_t member = part.members[i].face;
      body_.for_edges(member, [&](std::uint32_t u, std::uint32_t v) {
        const std::uint32_t across = face_across(member, u, v);
        if (is_member(across)) return;
        if (continues(across, u, v, plane) && body_.is_same_surface(t, across))
          add_member(across);
        else
          part.edges.push_back({u, v, none, across});
      });
    }
    if (!hubs_.empty()) add_hubs(first);
    end_region();
  }

  /// Corners of the members from `first` on that are hubs and lie inside the region become touching vertices.
  void add_hubs(std::size_t first) {
    const std::span boundary = std::span(part.edges).subspan(part.faces.back().edges_begin);
    const auto is_inside = [&](std::uint32_t v) {
      return std::none_of(boundary.begin(), boundary.end(), [&](const TouchedPart::Edge& e) { return e.from == v; });
    };

    const auto begin = static_cast<std::ptrdiff_t>(part.isolated.size());
    for (std::size_t i = first; i < part.members.size(); ++i)
      for (const std::uint32_t v : body_.triangles[part.members[i].face])
        if (std::binary_search(hubs_.begin(), hubs_.end(), body_.grid_points[v])) part.isolated.push_back(v);
    std::sort(part.isolated.begin() + begin, part.isolated.end());
    part.isolated.erase(std::unique(part.isolated.begin() + begin, part.isolated.end()), part.isolated.end());
    part.isolated.erase(std::remove_if(part.isolated.begin() + begin, part.isolated.end(), std::not_fn(is_inside)),
                        part.isolated.end());
  }

  /// The only other face at an edge of triangle t, if it runs from v to u; else none.
  std::uint32_t face_across(std::uint32_t t, std::uint32_t u, std::uint32_t v) {
    std::uint32_t across = none;
    int faces = 0;
    at_edge(u, v).faces_at_edge(u, v, [&](std::uint32_t f, bool forward) {
      ++faces;
      if (f != t && !forward) across = f;
    });
    return faces == 2 ? across : none;
  }

  /// Does a face at the edge {u, v} continue a triangle on that plane: is it one, too, with the same oriented plane?
  bool continues(std::uint32_t face, std::uint32_t u, std::uint32_t v, const exact::Plane& plane) const {
    if (face >= body_.triangles.size()) return false;
    const auto& c = body_.triangles[face];
    for (const std::uint32_t w : c)
      if (w != u && w != v && exact::side(plane, body_.grid_points[w]) != 0) return false;
    const auto& points = body_.grid_points;  // on one plane, so the direction of the normal tells
    return exact::dot_sign(exact::spanned_plane(points[c[0]], points[c[1]], points[c[2]]), plane) > 0;
  }

  void add_polygon(std::uint32_t f) {
    begin_region(f, body_.planes[body_.polygon(f)]);
    add_member(f);
    for_drawn_loops(f, [&](std::span<const std::uint32_t> loop) {
      if (loop.size() == 1) part.isolated.push_back(loop[0]);
      const std::size_t first = part.edges.size();
      grid::for_loop_edges(loop, [&](std::uint32_t u, std::uint32_t v) { part.edges.push_back({u, v, none, none}); });
      add_borders(loop, first);
    });
    if (spared_.any()) {
      const std::uint32_t p = body_.polygon(f);
      for (std::uint32_t j = body_.polygons.face_start[p]; j < body_.polygons.face_start[p + 1]; ++j)
        if (spared_[j]) part.spared.push_back(j);
    }
    end_region();
  }

  /// Tells the edges of a loop, listed from `first` on, which borders they are.
  void add_borders(std::span<const std::uint32_t> loop, std::size_t first) {
    if (body_.labels.borders.empty()) return;
    const auto begin = static_cast<std::uint32_t>(loop.data() - body_.polygons.corners.data());
    for (const Border& b : body_.labels.borders_within(begin, begin + static_cast<std::uint32_t>(loop.size())))
      part.edges[first + (b.corner - begin)].border = static_cast<std::uint32_t>(&b - body_.labels.borders.data());
  }

  /// The planes of the last face at an edge, and of the last one on another plane; none where there is none. Indices
  /// into part.planes.
  struct EdgePlanes {
    std::uint32_t last = none, other = none;
    std::uint32_t faces = 0;
  };

  /// Lists the untouched faces at an edge, too.
  EdgePlanes planes_at(const TouchedPart::Edge& e) {
    EdgePlanes found;
    const auto add_face = [&](std::uint32_t f, bool forward) {
      ++found.faces;
      std::uint32_t plane = touched_of_[f].value;
      if (plane == none) {
        part.untouched.push_back({forward ? e.from : e.to, forward ? e.to : e.from, f});
        plane = new_plane(body_.plane(f));
      }
      if (found.last != none && !same_plane(part.planes[found.last], part.planes[plane])) found.other = found.last;
      found.last = plane;
    };
    if (e.across != none)
      add_face(e.across, false);
    else
      at_edge(e.from, e.to).faces_at_edge(e.from, e.to, add_face);
    return found;
  }

  /// The same; asks once only about an edge of many faces.
  EdgePlanes known_planes_at(const TouchedPart::Edge& e) {
    const std::uint64_t edge = std::uint64_t{std::min(e.from, e.to)} << 32 | std::max(e.from, e.to);
    if (!crowded_.empty())
      if (const auto known = crowded_.find(edge); known != crowded_.end()) return known->second;

    const EdgePlanes found = planes_at(e);
    if (found.faces > grid::thresholds().few_faces_at_edge) crowded_.emplace(edge, found);
    return found;
  }

  /// Gives every edge of a face its other plane.
  void find_other_planes(TouchedId t) {
    const exact::Plane own = part.planes[t.value];
    for (std::uint32_t i = part.faces[t].edges_begin; i < part.faces[t].edges_end; ++i) {
      TouchedPart::Edge& e = part.edges[i];
      const EdgePlanes planes = known_planes_at(e);
      for (const std::uint32_t plane : {planes.other, planes.last})
        if (plane != none && !same_plane(part.planes[plane], own)) e.other = plane;
      if (e.other == none && e.border != none) e.other = new_plane(body_.labels.borders[e.border].other);
      if (e.other != none) continue;
      assert(body_.is_grid(e.from) && body_.is_grid(e.to));
      e.other = new_plane(exact::upright_plane(body_.grid_points[e.from], body_.grid_points[e.to], own));
    }
  }

  std::uint32_t new_plane(const exact::Plane& plane) {
    part.planes.push_back(plane);
    return static_cast<std::uint32_t>(part.planes.size() - 1);
  }

  const Body& body_;
  const std::span<const exact::GridPoint> hubs_;
  const SparedLoops spared_;
  grid::Paged<TouchedId> touched_of_;                      // by own face
  std::unordered_map<std::uint64_t, EdgePlanes> crowded_;  // of edges of many faces
  std::unique_ptr<const Adjacency> adjacency_;
};

/// Gives the planes and vertices of a part their names, and adds it.
void add_part(const Operands& operands, OperandId operand, const TouchedPart& part, Names& names, Touched& out) {
  Array<PlaneId> plane_id;
  plane_id.reserve(part.planes.size());
  for (const exact::Plane& p : part.planes) plane_id.push_back(names.planes.id(p));
  const auto name = [&](std::uint32_t v) { return names.name(operands[operand], operand, v); };

  names.operands[operand].listed.reserve(part.edges.size());
  const TouchedId first_face = out.faces.next_id();
  const auto first_edge = static_cast<std::uint32_t>(out.edges.size()),
             first_isolated = static_cast<std::uint32_t>(out.isolated.size()),
             first_spared = static_cast<std::uint32_t>(out.spared.size());
  for (const TouchedId t : Ids<TouchedId>(part.faces.size())) {
    TouchedFace face = part.faces[t];
    for (std::uint32_t i = face.edges_begin; i < face.edges_end; ++i) {
      const TouchedPart::Edge& e = part.edges[i];
      const VertexId from = name(e.from), to = name(e.to);
      out.edges.push_back({from, to, plane_id[e.other]});
    }
    for (std::uint32_t i = face.isolated_begin; i < face.isolated_end; ++i)
      out.isolated.push_back(name(part.isolated[i]));
    face.operand = operand;
    face.plane = plane_id[t.value];
    face.edges_begin += first_edge;
    face.edges_end += first_edge;
    face.isolated_begin += first_isolated;
    face.isolated_end += first_isolated;
    face.spared_begin += first_spared;
    face.spared_end += first_spared;
    out.faces.push_back(face);
  }

  out.spared.insert(out.spared.end(), part.spared.begin(), part.spared.end());

  for (const TouchedPart::Use& u : part.untouched)
    out.untouched.push_back({name(u.from), name(u.to), operand, operands.face(operand, u.face)});
  for (const auto& [f, t] : part.members) {
    const FaceId member = operands.face(operand, f);
    out.touched_of.at(member) = t.value + first_face.value;
    out.members.push_back(member);
  }
}

/// By operand, ascending: the faces that the pairs name. Of many pairs each face is listed once from the start.
ById<OperandId, Array<std::uint32_t>> named_faces(const Operands& operands, const FacePairs& pairs) {
  const bool many = pairs.size() >= grid::thresholds().few_keys;
  grid::PagedById<FaceId, std::uint8_t> is_listed(many ? operands.face_count() : 0);
  ById<OperandId, Array<std::uint32_t>> named(operands.bodies.size());
  for (const FacePair& p : pairs)
    for (const FaceId id : p) {
      if (many && is_listed[id]) continue;
      if (many) is_listed.at(id) = 1;
      const OwnFace f = operands.own(id);
      auto& list = named[f.operand];
      if (list.empty() || list.back() != f.face) list.push_back(f.face);  // pairs of one face follow each other
    }

  for (auto& list : named) {
    std::sort(list.begin(), list.end());
    if (!many) list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return named;
}

std::unique_ptr<const SegmentTree> tree_of_edges(const Touched& touched, TouchedId t, const Names& names) {
  Array<SegmentTree::Segment> edges;
  edges.reserve(touched.faces[t].edge_count());
  for (const BoundaryEdge& e : touched.edges_of(t)) edges.push_back({e.from, e.to});
  auto tree = std::make_unique<SegmentTree>(names.planes[touched.faces[t].plane], edges, names.vertices);
  tree->make_strips(names.vertices);
  return tree;
}

}  // namespace

Touched collect_touched(const Operands& operands, const FacePairs& pairs, Names& names) {
  const auto named = named_faces(operands, pairs);
  const std::size_t n = operands.bodies.size();
  Touched out;
  out.cover_once = operands.are_clean;
  out.touched_of = grid::PagedById<FaceId, TouchedId>(operands.face_count(), none);
  names.operands.resize(n);

  Array<exact::GridPoint> hubs = pairs.hubs;
  std::sort(hubs.begin(), hubs.end());
  hubs.erase(std::unique(hubs.begin(), hubs.end()), hubs.end());

  ById<OperandId, TouchedPart> parts(n);
  grid::in_tasks(n, operands.face_count(), [&](std::size_t i) {
    const OperandId o = static_cast<std::uint32_t>(i);
    if (named[o].empty()) return;
    Collector collector(operands, o, named[o], hubs);
    parts[o] = std::move(collector.part);
  });

  std::size_t faces = 0, edges = 0, members = 0, planes = 0, untouched = 0;
  for (const TouchedPart& p : parts) {
    faces += p.faces.size();
    edges += p.edges.size();
    members += p.members.size();
    planes += p.planes.size();
    untouched += p.untouched.size();
  }
  names.planes.reserve(planes);
  names.vertices.reserve(edges / 2, 0);
  out.faces.reserve(faces);
  out.edges.reserve(edges);
  out.members.reserve(members);
  out.untouched.reserve(untouched);
  for (const OperandId o : operands.ids()) {
    add_part(operands, o, parts[o], names, out);
    parts[o] = {};
  }

  out.edge_tree.resize(out.faces.size());
  grid::in_stretches(out.faces.size(), 256, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t)
      if (out.faces[t].edge_count() > grid::thresholds().large_face) out.edge_tree[t] = tree_of_edges(out, t, names);
  });
  return out;
}

}  // namespace quoin::booleans
