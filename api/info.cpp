#include <algorithm>

#include "api/access.h"
#include "api/doors/surface.h"
#include "api/run.h"
#include "booleans/body/measure.h"

namespace quoin {

using booleans::Body;
using exact::Rational;

namespace {

void add_surface(const SurfaceCounts& counts, Info& info) {
  info.triangles = counts.triangles;
  info.shells = counts.shells;
  info.genus = counts.genus;
  info.manifold = counts.manifold;
}

/// Whether the exact volume is asked for.
bool is_exact(Volume wanted, const Body& body) {
  constexpr std::size_t short_bits = std::size_t{1} << 17;  // 40,000 digits, which take 0.1 s
  return wanted == Volume::exact || (wanted == Volume::exact_if_short && booleans::volume_bits(body) <= short_bits);
}

void add_measures(const Solid& solid, Volume wanted, Info& info) {
  info.area_approx = solid.area();
  if (!info.bounded) return;
  const Rational& step = Access::lattice(solid).step;
  const Rational cubic_step = step * step * step;
  if (!is_exact(wanted, Access::body(solid))) {
    info.volume_approx = booleans::rounded_volume(Access::body(solid), cubic_step);
    return;
  }

  const Rational volume = booleans::volume(Access::body(solid)) * cubic_step;
  info.volume = exact::to_string(volume);
  info.volume_approx = exact::to_double(volume);
}

}  // namespace

Info Solid::info(const Options& options, const SurfaceCounts* surface, Volume volume) const {
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

      add_surface(surface ? *surface : surface_counts(body, booleans::triangulated(body)), info);
      report(0.7);
    }

    add_measures(*this, volume, info);
    report(1);
    return info;
  });
}

}  // namespace quoin
