#include "booleans/touched.h"

#include "grid/stretches.h"

namespace quoin::booleans {

Operands::Operands(std::vector<const Body*> list) : bodies(std::move(list)), base{0}, first_chunk{0} {
  std::vector<Chunk> own;
  for (std::uint32_t o = 0; o < bodies.size(); ++o) {
    const Body& body = *bodies[o];
    const auto faces = static_cast<std::uint32_t>(body.face_count());
    own.clear();
    if (body.chunks.empty()) add_chunks(body, 0, faces, own);
    Box& all = bounds.emplace_back();
    for (const Chunk& c : body.chunks.empty() ? own : body.chunks) {
      chunks.push_back({{base.back() + c.begin, base.back() + c.end, c.box}, o, false});
      all.add(c.box);
    }
    base.push_back(base.back() + faces);
    first_chunk.push_back(static_cast<std::uint32_t>(chunks.size()));
  }
  for (OperandChunk& c : chunks) c.far = !may_be_near(c.operand, c.box);
}

std::vector<Chunk> Operands::chunks_meeting(std::uint32_t operand, const Box& box) const {
  std::vector<Chunk> found;
  for (const OperandChunk& c : chunks_of(operand))
    if (c.box.meets(box)) found.push_back({c.begin - base[operand], c.end - base[operand], c.box});
  return found;
}

namespace {

/// The table id of a body's vertex.
std::uint32_t entered(const Body& body, std::uint32_t v, VertexTable& vertices) {
  return body.is_grid(v) ? vertices.id(body.grid_points[v]) : vertices.id(body.derived(v));
}

}  // namespace

std::uint32_t TouchedFaces::table_id(const Body& body, std::uint32_t operand, std::uint32_t v, VertexTable& vertices) {
  std::uint32_t& id = vertex_of[operand][v];
  if (id == none) {
    id = entered(body, v, vertices);
    table_vertices[operand].push_back(v);
  }
  return id;
}

namespace {

/// The touched faces of one operand, before planes and vertices have their ids: vertices are indices into the operand's
/// `table_vertices`, sheets and other planes indices into `planes`, one a face first.
struct Part {
  std::vector<TouchedFace> faces;
  std::vector<exact::Plane> planes;
  std::vector<BoundaryEdge> edges;
  std::vector<std::uint32_t> isolated;
  std::vector<UntouchedUse> untouched;
  std::vector<std::uint32_t> members;
};

/// Collects the touched faces of one operand. Of the outcome's lists it writes only what belongs to that operand.
class Collector {
 public:
  /// `named`: the faces in pairs, own ids in ascending order.
  Collector(const Operands& operands, std::uint32_t operand, std::span<const std::uint32_t> named, TouchedFaces& out,
            Part& part)
      : operands_(operands),
        body_(*operands.bodies[operand]),
        operand_(operand),
        base_(operands.base[operand]),
        named_(named),
        out_(out),
        part_(part) {}

  void run() {
    part_.faces.reserve(named_.size());
    part_.planes.reserve(4 * named_.size());
    part_.edges.reserve(4 * named_.size());
    part_.members.reserve(2 * named_.size());
    local_.reserve(4 * named_.size());
    std::vector<std::uint8_t> marked(body_.vertex_count());
    Box box;
    for (const std::uint32_t f : named_) {
      body_.for_corners(f, [&](std::uint32_t v) { marked[v] = 1; });
      box.add(face_box(body_, f));
    }
    // A face with a vertex of these has that vertex in its box.
    out_.adjacency[operand_] =
        std::make_unique<Adjacency>(body_, std::move(marked), operands_.chunks_meeting(operand_, box));
    const auto triangles = static_cast<std::uint32_t>(body_.triangles.size());
    for (const std::uint32_t f : named_) {
      if (out_.face_of[base_ + f] != none) continue;
      if (f < triangles)
        flood(f);
      else
        begin_face(f, body_.planes[f - triangles]);
      finish_face();
    }
    find_other_planes();
  }

 private:
  struct LocalEdge {
    std::uint32_t u, v;  // local vertex ids
  };

  /// Knows one end of the edge. Floods that run far make it complete.
  const Adjacency& adjacency(std::uint32_t u, std::uint32_t v) {
    auto& known = out_.adjacency[operand_];
    if (!known->knows(u) && !known->knows(v)) known = std::make_unique<Adjacency>(body_);
    return *known;
  }

  void begin_face(std::uint32_t f, const exact::Plane& plane) {
    TouchedFace face{};
    face.operand = operand_;
    face.source = f;
    face.sheet = static_cast<std::uint32_t>(part_.faces.size());
    face.along = exact::is_canonical(plane);
    face.edges_begin = static_cast<std::uint32_t>(part_.edges.size());
    face.isolated_begin = static_cast<std::uint32_t>(part_.isolated.size());
    out_.face_of[base_ + f] = face.sheet;
    part_.faces.push_back(face);
    part_.planes.push_back(plane);
    members_.assign(1, f);
  }

  /// All triangles coplanar with t, equally oriented, and connected with it over edges of exactly two faces.
  void flood(std::uint32_t t) {
    const exact::Plane plane = body_.plane(t);
    begin_face(t, plane);
    const auto index = static_cast<std::uint32_t>(part_.faces.size() - 1);
    for (std::size_t i = 0; i < members_.size(); ++i) {
      const auto& c = body_.triangles[members_[i]];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t mate = coplanar_mate(members_[i], c[k], c[(k + 1) % 3], plane);
        if (mate == none) {
          add_edge(c[k], c[(k + 1) % 3]);
        } else if (out_.face_of[base_ + mate] == none) {
          out_.face_of[base_ + mate] = index;
          members_.push_back(mate);
        }
      }
    }
  }

  /// The triangle that continues triangle t over its directed edge (u, v), if the edge is no real edge.
  std::uint32_t coplanar_mate(std::uint32_t t, std::uint32_t u, std::uint32_t v, const exact::Plane& plane) {
    std::uint32_t mate = none;
    int faces = 0;
    bool reversed = false;
    adjacency(u, v).faces_at_edge(u, v, [&](std::uint32_t f, bool forward) {
      ++faces;
      if (f != t) mate = f, reversed = !forward;
    });
    if (faces != 2 || mate == none || !reversed || mate >= body_.triangles.size()) return none;
    const auto& c = body_.triangles[mate];
    for (std::uint32_t w : c)
      if (w != u && w != v && exact::side(plane, body_.grid_points[w]) != 0) return none;
    const auto other = exact::plane_through(body_.grid_points[c[0]], body_.grid_points[c[1]], body_.grid_points[c[2]]);
    return other && *other == plane ? mate : none;
  }

  void finish_face() {
    TouchedFace& face = part_.faces.back();
    const auto triangles = static_cast<std::uint32_t>(body_.triangles.size());
    for (std::uint32_t f : members_) {
      part_.members.push_back(base_ + f);
      face.box.add(face_box(body_, f));
      if (f < triangles) continue;
      for (std::uint32_t j = body_.polygon_loops[f - triangles]; j < body_.polygon_loops[f - triangles + 1]; ++j) {
        const auto loop = body_.loop(j);
        if (loop.size() == 1) part_.isolated.push_back(index_of(loop[0]));
        for (std::size_t i = 0; i < loop.size() && loop.size() > 1; ++i)
          add_edge(loop[i], loop[i + 1 < loop.size() ? i + 1 : 0]);
      }
    }
    face.edges_end = static_cast<std::uint32_t>(part_.edges.size());
    face.isolated_end = static_cast<std::uint32_t>(part_.isolated.size());
  }

  std::uint32_t index_of(std::uint32_t v) {
    std::uint32_t& index = out_.vertex_of[operand_][v];
    if (index == none) {
      index = static_cast<std::uint32_t>(out_.table_vertices[operand_].size());
      out_.table_vertices[operand_].push_back(v);
    }
    return index;
  }

  void add_edge(std::uint32_t u, std::uint32_t v) {
    part_.edges.push_back({index_of(u), index_of(v), none});
    local_.push_back({u, v});
  }

  static bool same_plane(const exact::Plane& p, const exact::Plane& q) { return p == q || p == q.opposite(); }

  /// Gives every edge its other plane and lists the untouched faces that hang at it.
  void find_other_planes() {
    const auto new_plane = [&](const exact::Plane& plane) {
      part_.planes.push_back(plane);
      return static_cast<std::uint32_t>(part_.planes.size() - 1);
    };
    std::uint32_t at = 0;
    for (std::uint32_t i = 0; i < part_.faces.size(); ++i) {
      const exact::Plane own = part_.planes[i];
      for (; at < part_.faces[i].edges_end; ++at) {
        BoundaryEdge& e = part_.edges[at];
        const LocalEdge& l = local_[at];
        adjacency(l.u, l.v).faces_at_edge(l.u, l.v, [&](std::uint32_t f, bool forward) {
          const std::uint32_t g = out_.face_of[base_ + f];
          if (g == i) return;
          if (g != none) {
            if (!same_plane(part_.planes[g], own)) e.other = g;
            return;
          }
          part_.untouched.push_back({forward ? e.from : e.to, forward ? e.to : e.from, operand_, f});
          if (const exact::Plane plane = body_.plane(f); !same_plane(plane, own)) e.other = new_plane(plane);
        });
        if (e.other == none) e.other = new_plane(axis_parallel(l, own));
      }
    }
  }

  /// The plane through an edge and the axis in which the given plane's normal is largest. That axis is not parallel to
  /// the edge (the edge is perpendicular to the normal), and the new plane's normal lacks that component, so the two
  /// planes are not parallel. Its coefficients are edge lengths, at most 2^30.
  exact::Plane axis_parallel(const LocalEdge& e, const exact::Plane& plane) const {
    assert(body_.is_grid(e.u) && body_.is_grid(e.v));
    const exact::GridPoint &p = body_.grid_points[e.u], &q = body_.grid_points[e.v];
    std::size_t k = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (std::abs(plane.n[i]) > std::abs(plane.n[k])) k = i;
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    std::array<std::int64_t, 3> n{};
    n[i] = std::int64_t{q.c[j]} - p.c[j];
    n[j] = std::int64_t{p.c[i]} - q.c[i];
    return exact::reduced_plane(n, -(exact::int128(n[i]) * p.c[i] + exact::int128(n[j]) * p.c[j]));
  }

  const Operands& operands_;
  const Body& body_;
  const std::uint32_t operand_, base_;
  const std::span<const std::uint32_t> named_;
  TouchedFaces& out_;
  Part& part_;
  std::vector<std::uint32_t> members_;
  std::vector<LocalEdge> local_;  // of all edges
};

/// Gives the planes and vertices of a part their ids, and adds it.
void add_part(const Body& body, std::uint32_t operand, const Part& part, VertexTable& vertices, PlaneTable& planes,
              TouchedFaces& out) {
  std::vector<std::uint32_t> plane_id, vertex_id;
  plane_id.reserve(part.planes.size());
  for (const exact::Plane& p : part.planes) plane_id.push_back(planes.id(p));
  vertex_id.reserve(out.table_vertices[operand].size());
  for (const std::uint32_t v : out.table_vertices[operand]) {
    vertex_id.push_back(entered(body, v, vertices));
    out.vertex_of[operand][v] = vertex_id.back();
  }
  const auto first_face = static_cast<std::uint32_t>(out.faces.size()),
             first_edge = static_cast<std::uint32_t>(out.edges.size()),
             first_isolated = static_cast<std::uint32_t>(out.isolated.size());
  for (TouchedFace face : part.faces) {
    face.sheet = plane_id[face.sheet];
    face.edges_begin += first_edge;
    face.edges_end += first_edge;
    face.isolated_begin += first_isolated;
    face.isolated_end += first_isolated;
    out.faces.push_back(face);
  }
  for (const BoundaryEdge& e : part.edges) out.edges.push_back({vertex_id[e.from], vertex_id[e.to], plane_id[e.other]});
  for (const std::uint32_t v : part.isolated) out.isolated.push_back(vertex_id[v]);
  for (const UntouchedUse& u : part.untouched)
    out.untouched.push_back({vertex_id[u.from], vertex_id[u.to], u.operand, u.face});
  for (const std::uint32_t f : part.members) out.face_of[f] += first_face;
  out.members.insert(out.members.end(), part.members.begin(), part.members.end());
}

}  // namespace

TouchedFaces collect_touched(const Operands& operands, const std::vector<FaceIdPair>& near, VertexTable& vertices,
                             PlaneTable& planes) {
  const std::size_t n = operands.bodies.size();
  std::vector<std::vector<std::uint32_t>> named(n);
  for (const FaceIdPair& p : near)
    for (const std::uint32_t id : p) {
      const auto [o, f] = operands.local(id);
      named[o].push_back(f);
    }
  TouchedFaces out;
  out.face_of.assign(operands.face_count(), none);
  out.vertex_of.resize(n);
  out.table_vertices.resize(n);
  out.adjacency.resize(n);
  std::vector<Part> parts(n);
  grid::in_tasks(n, operands.face_count(), [&](std::size_t o) {
    if (named[o].empty()) return;
    std::sort(named[o].begin(), named[o].end());
    named[o].erase(std::unique(named[o].begin(), named[o].end()), named[o].end());
    out.vertex_of[o].assign(operands.bodies[o]->vertex_count(), none);
    Collector(operands, static_cast<std::uint32_t>(o), named[o], out, parts[o]).run();
  });
  std::size_t faces = 0, edges = 0, members = 0;
  for (const Part& p : parts) faces += p.faces.size(), edges += p.edges.size(), members += p.members.size();
  out.faces.reserve(faces);
  out.edges.reserve(edges);
  out.members.reserve(members);
  for (std::uint32_t o = 0; o < n; ++o) {
    add_part(*operands.bodies[o], o, parts[o], vertices, planes, out);
    parts[o] = {};
  }
  out.edge_tree.resize(out.faces.size());
  grid::in_stretches(out.faces.size(), 256, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const TouchedFace& f = out.faces[i];
      if (f.edges_end - f.edges_begin <= TouchedFaces::large) continue;
      std::vector<BoxTree::Item> items;
      for (std::uint32_t e = f.edges_begin; e < f.edges_end; ++e) {
        Box box;
        box.add(vertices.approximation(out.edges[e].from));
        box.add(vertices.approximation(out.edges[e].to));
        items.push_back({box, e, e});
      }
      out.edge_tree[i] = std::make_unique<BoxTree>(items);
    }
  });
  return out;
}

}  // namespace quoin::booleans
