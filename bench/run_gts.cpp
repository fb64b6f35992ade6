/// Runs the GNU Triangulated Surface Library on a workload's folder; see bench/peer.h.
#include <gts.h>

#include <map>

#include "bench/peer.h"

namespace {

using namespace quoin;

GtsSurface* empty_surface() {
  return gts_surface_new(gts_surface_class(), gts_face_class(), gts_edge_class(), gts_vertex_class());
}

GtsSurface* surface(const Mesh& mesh) {
  GtsSurface* s = empty_surface();
  std::vector<GtsVertex*> v;
  for (std::size_t i = 0; i < mesh.points.size(); i += 3)
    v.push_back(gts_vertex_new(s->vertex_class, mesh.points[i], mesh.points[i + 1], mesh.points[i + 2]));
  std::map<std::pair<unsigned, unsigned>, GtsEdge*> edges;
  const auto edge = [&](unsigned a, unsigned b) {
    GtsEdge*& e = edges[std::minmax(a, b)];
    if (e == nullptr) e = gts_edge_new(s->edge_class, v[a], v[b]);
    return e;
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const auto* c = &mesh.triangles[t];
    gts_surface_add_face(s, gts_face_new(s->face_class, edge(c[0], c[1]), edge(c[1], c[2]), edge(c[2], c[0])));
  }
  return s;
}

GtsSurface* combined(GtsSurface* a, GtsSurface* b, char operation) {
  GNode *tree_a = gts_bb_tree_surface(a), *tree_b = gts_bb_tree_surface(b);
  GtsSurfaceInter* inter = gts_surface_inter_new(gts_surface_inter_class(), a, b, tree_a, tree_b, FALSE, FALSE);
  gboolean closed = TRUE;
  gts_surface_inter_check(inter, &closed);
  if (inter->edges != nullptr && !closed) {
    std::fprintf(stderr, "the curve of intersection is not closed\n");
    std::exit(1);
  }
  GtsSurface* out = empty_surface();
  if (operation == 'u') {
    gts_surface_inter_boolean(inter, out, GTS_1_OUT_2);
    gts_surface_inter_boolean(inter, out, GTS_2_OUT_1);
  } else if (operation == 'i') {
    gts_surface_inter_boolean(inter, out, GTS_1_IN_2);
    gts_surface_inter_boolean(inter, out, GTS_2_IN_1);
  } else {
    gts_surface_inter_boolean(inter, out, GTS_1_OUT_2);
    GtsSurface* inner = empty_surface();
    gts_surface_inter_boolean(inter, inner, GTS_2_IN_1);
    gts_surface_foreach_face(inner, reinterpret_cast<GtsFunc>(gts_triangle_revert), nullptr);
    gts_surface_merge(out, inner);
  }
  return out;
}

struct Names {
  std::map<void*, std::uint32_t> id;
  Mesh mesh;
  std::uint32_t of(GtsVertex* v) {
    const auto [at, fresh] = id.try_emplace(v, static_cast<std::uint32_t>(id.size()));
    if (fresh) mesh.points.insert(mesh.points.end(), {v->p.x, v->p.y, v->p.z});
    return at->second;
  }
};

}  // namespace

int main(int argc, char** argv) {
  return bench::run_peer(
      argc, argv,
      [](const bench::Task& task) {
        std::vector<GtsSurface*> all;
        for (const Mesh& m : task.operands) all.push_back(surface(m));
        return all;
      },
      [](const bench::Task& task, std::vector<GtsSurface*>& all) {
        return bench::combine_pairwise(task, all, combined);
      },
      [](GtsSurface* s) {
        Names names;
        gts_surface_foreach_face(
            s,
            [](gpointer face, gpointer data) -> gint {
              auto& n = *static_cast<Names*>(data);
              GtsVertex *a = nullptr, *b = nullptr, *c = nullptr;
              gts_triangle_vertices(GTS_TRIANGLE(face), &a, &b, &c);
              for (GtsVertex* v : {a, b, c}) n.mesh.triangles.push_back(n.of(v));
              return 0;
            },
            &names);
        return names.mesh;
      });
}
