#include <memory>
#include <utility>

#include "api/place.h"
#include "api/run.h"
#include "booleans/body/channels.h"

namespace quoin {
namespace {

/// Of a solid and of its complement, whose surface is the same.
std::shared_ptr<const rounding::Shape> surface_of(const Solid& solid) {
  return shape_of(solid.is_bounded() ? solid : ~solid);
}

booleans::PositionMap position_map(const rounding::AffineMap& map) {
  booleans::PositionMap rows;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < 3; ++j) rows[k][j] = map.linear[k][j];
    rows[k][3] = map.shift[k];
  }
  return rows;
}

Result<Solid> placed(const Solid& solid, const rounding::RealizedMotion& motion, Rounding rounding, const Options& run,
                     MotionReport& report) {
  if (!solid.is_bounded()) {
    auto complement = placed(~solid, motion, rounding, run, report);
    if (!complement) return complement.error();
    return ~complement.value();
  }

  const auto shape = shape_of(solid);
  constexpr double half = 0.5;  // of the time, for a mesh
  if (run.progress) run.progress(half);

  auto bodies = place({{shape.get(), {}, &motion}}, Access::lattice(solid), rounding, step_of(run, half, 1));
  if (!bodies) return bodies.error();
  report = bodies.value().report;
  booleans::Body& body = bodies.value().primitives[0].body;
  body.labels.origins = booleans::carried(body.labels.origins, position_map(inverse(motion.map)));
  return Access::solid(solid.grid(), std::move(body));
}

Result<Solid> carried(const Solid& solid, const rounding::RealizedMotion& motion, Rounding rounding, const Options& run,
                      MotionReport& report) {
  report = {.angle_error = exact::double_above(motion.angle_error_degrees), .primitives = 1, .by_planes = 1};
  if (Access::operand(solid).face_count() == 0) return solid;

  if (motion.map == rounding::AffineMap{}) {
    // Nothing moves; but the motion may state an angle that is too small for a rational one.
    if (!motion.is_exact()) report_displacement(report, motion.displacement_within(surface_of(solid)->reach));
    return solid;
  }
  return placed(solid, motion, rounding, run, report);
}

}  // namespace

Result<Solid> moved(const Solid& solid, const Motion& motion, const MoveOptions& options, MotionReport* report) {
  return run_to_end(options.run, [&](const Options& run) {
    return with_threads(run.threads, [&] {
      MotionReport ignored;
      return carried(solid, rounding::realize(Access::motion(motion)), options.rounding, run,
                     report ? *report : ignored);
    });
  });
}

}  // namespace quoin
