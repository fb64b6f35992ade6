#include "rounding/reconstruction/refusals.h"

namespace quoin::rounding {
namespace {

std::string text(const Vector& p) {
  std::string s;
  for (const Rational& x : p) s += (s.empty() ? "(" : ", ") + std::to_string(exact::to_double(x));
  return s + ")";
}

}  // namespace

std::string name_of(std::size_t primitive) { return "primitive " + std::to_string(primitive); }

Error out_of_range(std::size_t primitive, std::span<const Vector> points) {
  Rational most = -1;
  const Vector* farthest = nullptr;
  for (const Vector& p : points)
    if (const Rational reach = magnitude(p[longest_component(p)]); reach > most) {
      most = reach;
      farthest = &p;
    }

  Integer factor = 2;
  while (most > Rational(factor * exact::world)) factor *= 2;
  return {ErrorCode::out_of_range,
          "the motion carries a vertex to " + text(*farthest) + " grid steps, beyond the world of +-2^29; a step " +
              factor.str() + " times as large would do",
          {},
          name_of(primitive)};
}

Error half_space_out_of_range(std::size_t primitive) {
  return {ErrorCode::out_of_range,
          "the motion carries a plane too far from the origin of the grid",
          {},
          name_of(primitive)};
}

Error inconsistent(std::size_t primitive, const Violation& v, std::span<const Vector> points) {
  std::string where = name_of(primitive);
  if (v.vertex != booleans::none) where += ", vertex " + std::to_string(v.vertex) + " at " + text(points[v.vertex]);
  if (v.face != booleans::none) where += ", face " + std::to_string(v.face);
  return {ErrorCode::inconsistent_motion,
          "no rounding of its planes keeps the primitive's shape: " + v.what +
              "; a smaller step would do, or rounding vertex by vertex unless the whole is that thin",
          {},
          where};
}

Error no_region(std::size_t primitive) {
  return {ErrorCode::bad_primitive, "a face is no region: its loops cross", {}, name_of(primitive)};
}

Error cancelled() { return {ErrorCode::cancelled, "the motion was cancelled"}; }

}  // namespace quoin::rounding
