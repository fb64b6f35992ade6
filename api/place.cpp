#include "api/place.h"

#include <algorithm>
#include <cmath>

#include "booleans/canonical.h"

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

  PlacedBodies result{std::move(done.value().primitives), {}};
  MotionReport& report = result.report;
  Rational displacement = 0, angle = 0;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const rounding::Reconstructed& r = result.primitives[i];
    const rounding::RealizedMotion& motion = *primitives[i].motion;
    angle = std::max(angle, motion.angle_error_degrees);
    ++report.primitives;
    ++(r.by_planes ? report.by_planes : report.by_vertices);
    report.merged_points += r.merged_points;
    report.zero_area_triangles += r.zero_area_triangles;
    report.resolved_crossings += r.resolved_crossings;
    if (!primitives[i].shape) continue;
    const Rational by_angle = motion.displacement_per_unit * primitives[i].shape->reach + motion.displacement;
    displacement = std::max<Rational>(displacement, by_angle + r.displacement * lattice.step);
  }
  report.planes = done.value().planes;
  report.exact_planes = done.value().exact_planes;
  report.face_local_planes = done.value().face_local_planes;
  report.angle_error = exact::double_above(angle);
  report.displacement = exact::double_above(displacement);
  // As the rational that a double is it has few digits.
  if (std::isfinite(report.displacement)) displacement = exact::to_rational(report.displacement);
  report.displacement_bound = exact::to_string(displacement);
  return result;
}

std::shared_ptr<const rounding::Shape> shape_of(const Solid& solid) {
  return std::make_shared<rounding::Shape>(rounding::polyhedron_of(booleans::canonical(Access::body(solid))),
                                           Access::lattice(solid));
}

}  // namespace quoin
