/// \file
/// Laws that hold for every model, checked on scripts. All equalities are exact.
#include <algorithm>
#include <string_view>

#include "api/access.h"
#include "booleans/body/canonical.h"
#include "booleans/body/fault.h"
#include "booleans/embedding.h"
#include "exact/rational.h"
#include "fuzz/law.h"
#include "fuzz/model_script.h"

namespace quoin::fuzz {
namespace {

std::string told(const Error& e) { return to_string(e.code) + ": " + e.message + " (" + e.where + ")"; }

/// The codes that docs/errors.md has for motions and models.
void check_error(const Error& error) {
  static constexpr std::array<ErrorCode, 13> codes{
      ErrorCode::bad_number,   ErrorCode::bad_parameter, ErrorCode::bad_primitive,       ErrorCode::bad_axis,
      ErrorCode::bad_factor,   ErrorCode::bad_plane,     ErrorCode::not_a_rotation,      ErrorCode::unbounded,
      ErrorCode::inexact_grid, ErrorCode::out_of_range,  ErrorCode::inconsistent_motion, ErrorCode::non_finite,
      ErrorCode::too_large};
  require(std::find(codes.begin(), codes.end(), error.code) != codes.end(),
          "errors are those documented:", told(error));
  require(!error.message.empty(), "an error has a message:", to_string(error.code));
}

void check_solid(const Solid& solid) {
  const booleans::Body& body = Access::body(solid);
  if (const auto message = booleans::fault(body)) fail("results are without fault:", *message);
  const booleans::Body again = booleans::body_of(booleans::canonical(body));
  if (const auto message = booleans::fault(again)) fail("canonical results are without fault:", *message);
  if (const auto message = booleans::embedding_fault(again)) fail("results are clean:", *message);
}

void check_report(const MotionReport& report) {
  const auto bound = exact::parse_rational(report.displacement_bound);
  require(bound && *bound >= 0, "a displacement's bound is not negative:", report.displacement_bound);
  require(report.displacement >= exact::to_double(*bound), "a displacement is rounded up");
  require(report.angle_error >= 0, "an angle's error is not negative");
  require(report.by_planes + report.by_vertices == report.primitives, "primitives are rounded in one of two ways");
}

/// Two evaluations: the same solid on the same grid, byte for byte, or the same error.
void require_same(const Result<Solid>& a, const Result<Solid>& b, const char* law) {
  if (!a || !b) {
    require(static_cast<bool>(a) == static_cast<bool>(b), law, told(a ? b.error() : a.error()));
    return require(a.error().code == b.error().code, law, told(a.error()) + " / " + told(b.error()));
  }
  require(a.value() == b.value(), law);
  require(a.value().grid() == b.value().grid(), law, "(grids)");
  require(a.value().to_quoin() == b.value().to_quoin(), law, "(bytes)");
}

Result<Solid> evaluated(const Model& model, const ModelScript& s, unsigned threads = 1) {
  ModelOptions options = s.options;
  options.run.threads = threads;
  MotionReport report;
  auto solid = evaluate(model, options, &report);
  if (!solid)
    check_error(solid.error());
  else
    check_report(report);
  return solid;
}

Result<Solid> moved(const Solid& solid, const Motion& motion, const ModelScript& s, MotionReport& report) {
  auto result = moved(solid, motion, {.rounding = s.options.rounding, .run = {.threads = 1}}, &report);
  if (!result) {
    check_error(result.error());
    return result;
  }
  check_report(report);
  require(result.value().grid() == solid.grid(), "a solid moves on its own grid");
  check_solid(result.value());
  return result;
}

/// By right angles about the axes, whole steps and mirror images in the coordinate planes.
Motion exact_motion(const ModelScript& s, const Grid& grid) {
  const auto axis = [](int k) { return Text3{k % 3 == 0 ? "1" : "0", k % 3 == 1 ? "1" : "0", k % 3 == 2 ? "1" : "0"}; };
  const exact::Rational step = *exact::parse_rational(grid.step());
  Text3 by;
  for (std::size_t k = 0; k < 3; ++k)
    by[k] = exact::to_string(exact::Rational(step * *exact::parse_rational(s.grid_steps[k])));
  Motion motion = Motion::translation(by).value();
  const int kind = s.exact_kind;
  motion = motion.then(Motion::rotation(axis(kind), std::to_string(90 * (kind / 3 % 4))).value());
  if (kind / 12 % 2 == 1) motion = motion.then(Motion::mirror(axis(kind / 24)).value());
  if (kind / 72 % 2 == 1) motion = motion.then(Motion::rotation(axis(kind / 24), "90").value());
  return motion;
}

/// Nothing is rounded; only the world may be too small.
void check_exact(const Solid& solid, const ModelScript& s) {
  if (s.options.rounding == Rounding::vertices) return;
  const Motion motion = exact_motion(s, solid.grid());
  MotionReport report;
  const auto there = moved(solid, motion, s, report);
  if (!there)
    return require(there.error().code == ErrorCode::out_of_range, "an exact motion succeeds:", told(there.error()));
  require(report.displacement_bound == "0" && report.displacement == 0, "an exact motion displaces nothing");
  require(there.value().volume() == solid.volume(), "an exact motion keeps the volume");
  const auto back = moved(there.value(), motion.inverse(), s, report);
  require(static_cast<bool>(back), "an exact motion has a way back");
  require(back.value() == solid, "an exact motion and its inverse are none");
}

void check_move(const Solid& solid, const ModelScript& s) {
  const auto motion = s.step.motion();
  require(static_cast<bool>(motion), "the step is a motion");
  MotionReport report;
  const auto there = moved(solid, motion.value(), s, report);
  const auto none = moved(solid, motion.value().then(motion.value().inverse()), s, report);
  require(none && none.value() == solid, "a motion and its inverse, composed, are none");
  if (there && !solid.is_bounded()) require(!there.value().is_bounded(), "what is unbounded stays so");
}

void check_text(const Result<Solid>& solid, const ModelScript& s) {
  const auto read = Model::from_json(s.model.to_json());
  require(static_cast<bool>(read), "what is written is read:", read ? "" : told(read.error()));
  require_same(evaluated(read.value(), s), solid, "a model's text is the model:");
}

void check_there_and_back(const Result<Solid>& solid, const ModelScript& s) {
  require_same(evaluated(s.step.inverse()(s.step(s.model)), s), solid, "a model moved there and back is where it was:");
}

/// Planes that coincide are rounded alike, wherever they come from.
void check_union_with_itself(const ModelScript& s, const Model& copy) {
  const Model there = s.step(s.model);
  require_same(evaluated(there + s.step(copy), s), evaluated(there, s), "a model united with itself is itself:");
}

/// Besides the evaluation itself, one law for most scripts: a case takes a tenth of a second with sanitizers.
void run(std::span<const std::uint8_t> bytes) {
  const ModelScript s = model_script(bytes);
  const auto chosen = [&](int law) { return s.laws >= 240 || s.laws % 7 == law; };
  const auto solid = evaluated(s.model, s);
  if (solid) check_solid(solid.value());
  if (chosen(0)) require_same(evaluated(s.model, s, 2), solid, "threads change nothing:");
  if (chosen(1)) check_text(solid, s);
  if (chosen(2)) check_there_and_back(solid, s);
  if (chosen(3)) check_union_with_itself(s, s.model);
  if (chosen(4)) check_union_with_itself(s, model_script(bytes).model);
  if (solid && chosen(5)) check_exact(solid.value(), s);
  if (solid && chosen(6)) check_move(solid.value(), s);
}

}  // namespace
}  // namespace quoin::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  quoin::fuzz::run({data, size});
  return 0;
}
