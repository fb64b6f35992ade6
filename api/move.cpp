#include "api/place.h"
#include "api/run.h"
#include "booleans/body.h"

namespace quoin {
namespace {

Result<Solid> moved(const Solid& solid, const Motion& motion, const MoveOptions& options, MotionReport* report) {
  const rounding::RealizedMotion realized = rounding::realize(Access::motion(motion));
  if (report)
    *report = {.angle_error = exact::double_above(realized.angle_error_degrees), .primitives = 1, .by_planes = 1};
  // Nothing moves, or there is nothing that moves.
  if (realized.map == rounding::AffineMap{} || Access::operand(solid).face_count() == 0) return solid;
  if (!solid.is_bounded()) {
    auto complement = moved(~solid, motion, options, report);
    if (!complement) return complement.error();
    return ~complement.value();
  }
  const auto shape = shape_of(solid);
  constexpr double half = 0.5;  // of the time, for a mesh
  if (options.run.progress) options.run.progress(half);
  auto placed =
      place({{shape.get(), {}, &realized}}, Access::lattice(solid), options.rounding, step_of(options.run, half, 1));
  if (!placed) return placed.error();
  if (report) *report = placed.value().report;
  return Access::solid(solid.grid(), std::move(placed.value().primitives[0].body));
}

}  // namespace

Result<Solid> move(const Solid& solid, const Motion& motion, const MoveOptions& options, MotionReport* report) {
  return with_threads(options.run.threads, [&] { return moved(solid, motion, options, report); });
}

}  // namespace quoin
