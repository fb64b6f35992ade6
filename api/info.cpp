#include <algorithm>
#include <limits>

#include "api/access.h"
#include "api/run.h"
#include "booleans/canonical.h"
#include "booleans/export.h"
#include "booleans/measure.h"

namespace quoin {

using booleans::Body;
using booleans::Triangulated;
using exact::Rational;

namespace {

/// Whether no directed edge of a separated mesh occurs twice: where one does, an edge could not be separated because
/// the surface hangs together around both its ends.
bool has_single_edges(const Triangulated& mesh) {
  std::vector<std::uint64_t> edges;
  edges.reserve(mesh.corners.size());
  for (std::size_t n = 0; n < mesh.triangle_count(); ++n) {
    const auto t = mesh.triangle(n);
    for (std::size_t i = 0; i < 3; ++i) edges.push_back(std::uint64_t{t[i]} << 32 | t[(i + 1) % 3]);
  }
  std::sort(edges.begin(), edges.end());
  return std::adjacent_find(edges.begin(), edges.end()) == edges.end();
}

/// Rounding is monotone: the extremes of rounded coordinates are the rounded extremes.
std::array<std::array<double, 3>, 2> rounded_box(const booleans::Canonical& form, const grid::Lattice& lattice) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<std::array<double, 3>, 2> box{{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}}};
  const grid::Rounder rounder(lattice);
  for (const auto& p : form.vertices)
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = rounder.to_double(p, static_cast<int>(k));
      box[0][k] = std::min(box[0][k], x);
      box[1][k] = std::max(box[1][k], x);
    }
  return box;
}

void add_topology(const Body& body, Info& info) {
  const Triangulated mesh = booleans::triangulated(body);
  const Triangulated parts = booleans::separated(body, mesh);
  const booleans::Shells shells = booleans::shells(parts);
  info.triangles = mesh.triangle_count();
  info.shells = shells.count;
  info.genus = shells.genus;
  info.manifold = parts.source.size() == mesh.source.size() && has_single_edges(parts);
}

}  // namespace

Info Solid::info(const Options& options) const {
  const auto report = [&](double done) {
    if (options.progress) options.progress(done);
  };
  return with_threads(options.threads, [&] {
    const Body& body = Access::body(*this);
    const grid::Lattice& lattice = Access::lattice(*this);
    Info info;
    report(0);
    const booleans::Canonical form = booleans::canonical(body);
    info.vertices = form.vertices.size();
    info.edges = booleans::edge_count(form);
    info.faces = form.face_count();
    info.bounded = !body.full_at_infinity;
    if (!form.vertices.empty()) info.box = rounded_box(form, lattice);
    report(0.4);
    add_topology(body, info);
    report(0.7);
    const Rational square = lattice.step * lattice.step;
    if (info.bounded) {
      const Rational volume = booleans::volume(body) * square * lattice.step;
      info.volume = exact::to_string(volume);
      info.volume_approx = exact::to_double(volume);
    }
    info.area_approx = booleans::approximate_area(body) * exact::to_double(square);
    report(1);
    return info;
  });
}

}  // namespace quoin
