#include <algorithm>

#include "api/access.h"
#include "api/run.h"
#include "booleans/body/measure.h"
#include "booleans/surface/separated.h"
#include "booleans/surface/shells.h"

namespace quoin {

using booleans::Body;
using booleans::Triangulated;
using exact::Rational;

namespace {

/// Of the mesh that an export writes.
void add_topology(const Body& body, Info& info) {
  Triangulated mesh = booleans::triangulated(body);
  const std::size_t vertices = mesh.vertex_count();
  mesh = booleans::separated(body, std::move(mesh));

  const booleans::Shells shells = booleans::shells(mesh);
  info.triangles = mesh.triangle_count();
  info.shells = shells.count;
  info.genus = shells.genus;
  info.manifold = mesh.vertex_count() == vertices;
}

void add_measures(const Solid& solid, Info& info) {
  info.area_approx = solid.area();
  if (!info.bounded) return;
  const Rational& step = Access::lattice(solid).step;
  const Rational volume = booleans::volume(Access::body(solid)) * step * step * step;
  info.volume = exact::to_string(volume);
  info.volume_approx = exact::to_double(volume);
}

}  // namespace

Info Solid::info(const Options& options) const {
  const auto report = [&](double done) {
    if (options.progress) options.progress(done);
  };
  return with_threads(options.threads, [&] {
    const Body& body = Access::body(*this);
    Info info;
    info.bounded = is_bounded();
    report(0);
    if (body.face_count() > 0) {
      const Counts counted = counts();
      info.vertices = counted.vertices;
      info.edges = counted.edges;
      info.faces = counted.faces;
      info.box = box();
      report(0.4);

      add_topology(body, info);
      report(0.7);
    }

    add_measures(*this, info);
    report(1);
    return info;
  });
}

}  // namespace quoin
