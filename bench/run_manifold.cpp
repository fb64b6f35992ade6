/// Runs the C++ library Manifold on a workload's folder; see bench/peer.h.
#include <manifold/manifold.h>

#include "bench/peer.h"

using namespace quoin;
using manifold::Manifold;
using manifold::OpType;

namespace {

std::vector<Manifold> import(const bench::Task& task) {
  std::vector<Manifold> solids;
  for (const Mesh& m : task.operands) {
    manifold::MeshGL64 mesh;
    mesh.numProp = 3;
    mesh.vertProperties = m.points;
    mesh.triVerts.assign(m.triangles.begin(), m.triangles.end());
    solids.emplace_back(mesh);
  }
  return solids;
}

/// Its operations are lazy; asking for the triangles does the work.
Manifold done(const Manifold& solid) {
  static_cast<void>(solid.NumTri());
  return solid;
}

Manifold combine(const bench::Task& task, std::vector<Manifold>& solids) {
  if (task.operation == "union") return done(Manifold::BatchBoolean(solids, OpType::Add));
  if (task.operation == "intersection") return done(Manifold::BatchBoolean(solids, OpType::Intersect));
  if (task.operation == "difference") return done(Manifold::BatchBoolean(solids, OpType::Subtract));
  if (task.operation == "parts") {
    std::vector<Manifold> parts;
    for (std::size_t i = 0; i + 1 < solids.size(); i += 2) parts.push_back(solids[i] - solids[i + 1]);
    return done(Manifold::BatchBoolean(parts, OpType::Add));
  }
  return bench::combine_pairwise(task, solids, [](const Manifold& a, const Manifold& b, char operation) {
    return done(operation == 'u' ? a + b : a - b);
  });
}

Mesh to_mesh(const Manifold& solid) {
  const manifold::MeshGL64 mesh = solid.GetMeshGL64();
  Mesh m;
  if (mesh.numProp == 3) {
    m.points = mesh.vertProperties;
  } else {
    for (std::size_t i = 0; i < mesh.vertProperties.size(); i += mesh.numProp)
      m.points.insert(m.points.end(), mesh.vertProperties.begin() + i, mesh.vertProperties.begin() + i + 3);
  }
  m.triangles.assign(mesh.triVerts.begin(), mesh.triVerts.end());
  return m;
}

}  // namespace

int main(int argc, char** argv) { return bench::run_peer(argc, argv, import, combine, to_mesh); }
