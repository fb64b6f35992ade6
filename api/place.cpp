#include "api/place.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "booleans/body/canonical.h"

namespace quoin {

using exact::Rational;
using rounding::Method;

namespace {

rounding::ReconstructionOptions options_of(Rounding rounding, const Options& run) {
  rounding::ReconstructionOptions options;
  options.progress = run.progress;
  options.cancel = run.cancel;
  options.by_vertices = rounding == Rounding::vertices;

  switch (rounding) {
    case Rounding::best:
    case Rounding::vertices:
      options.method = Method::best;
      break;
    case Rounding::naive:
      options.method = Method::naive;
      break;
    case Rounding::continued_fraction:
      options.method = Method::continued_fraction;
      break;
    case Rounding::lattice:
      options.method = Method::lattice;
      break;
    case Rounding::face_local:
      options.method = Method::face_local;
      break;
  }
  return options;
}

MotionReport report_of(const std::vector<Placed>& primitives, const rounding::Reconstruction& done,
                       const Rational& step) {
  MotionReport report;
  Rational displacement = 0, angle = 0;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const rounding::Reconstructed& r = done.primitives[i];
    const rounding::RealizedMotion& motion = *primitives[i].motion;
    ++report.primitives;
    ++(r.by_planes ? report.by_planes : report.by_vertices);
    report.merged_points += r.merged_points;
    report.zero_area_triangles += r.zero_area_triangles;
    report.resolved_crossings += r.resolved_crossings;
    if (r.vanished && report.vanished_primitives++ == 0) report.vanished_where = "primitive " + std::to_string(i);

    angle = std::max(angle, motion.angle_error_degrees);
    if (!primitives[i].shape) continue;
    const Rational by_angle = motion.displacement_within(primitives[i].shape->reach);
    displacement = std::max<Rational>(displacement, by_angle + r.displacement * step);
  }

  report.planes = done.planes;
  report.exact_planes = done.exact_planes;
  report.face_local_planes = done.face_local_planes;
  report.angle_error = exact::double_above(angle);
  report_displacement(report, displacement);
  return report;
}

}  // namespace

Result<PlacedBodies> place(const std::vector<Placed>& primitives, const grid::Lattice& lattice, Rounding rounding,
                           const Options& run) {
  const rounding::AffineMap steps = rounding::to_grid(lattice);
  std::vector<rounding::Placement> placements;
  for (const Placed& p : primitives) {
    const rounding::AffineMap to_grid = composed(p.motion->map, steps);
    placements.push_back({p.shape, p.half_space, p.shape ? composed(p.shape->to_model, to_grid) : to_grid});
  }

  auto done = rounding::reconstruct(placements, options_of(rounding, run));
  if (!done) return done.error();
  MotionReport report = report_of(primitives, done.value(), lattice.step);
  return PlacedBodies{std::move(done.value().primitives), std::move(report)};
}

void report_displacement(MotionReport& report, Rational displacement) {
  report.displacement = exact::double_above(displacement);
  // As the rational that a double is it has few digits.
  if (std::isfinite(report.displacement)) displacement = exact::to_rational(report.displacement);
  report.displacement_bound = exact::to_string(displacement);
}

std::shared_ptr<const rounding::Shape> shape_of(const Solid& solid) {
  return std::make_shared<rounding::Shape>(rounding::polyhedron_of(booleans::labelled_boundary(Access::body(solid))),
                                           Access::lattice(solid));
}

}  // namespace quoin
