#include "booleans/surface/shells.h"

#include "grid/lists/partition.h"

namespace quoin::booleans {

Shells shells(const Triangulated& mesh) {
  grid::Partition parts(mesh.vertex_count());
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const auto t = mesh.triangle(i);
    parts.unite(t[0], t[1]);
    parts.unite(t[0], t[2]);
  }

  Shells r;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) r.count += parts.find(v) == v;

  // V - E + F = 2 (shells - genus), E = 3 F / 2.
  const auto v = static_cast<std::int64_t>(mesh.vertex_count()), f = static_cast<std::int64_t>(mesh.triangle_count());
  r.genus = static_cast<std::int64_t>(r.count) - (v - f / 2) / 2;
  return r;
}

}  // namespace quoin::booleans
