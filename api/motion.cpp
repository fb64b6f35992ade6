#include "api/motion.h"

#include <string>

#include "api/access.h"
#include "rounding/motions/realize.h"

namespace quoin {

using exact::Rational;
using rounding::Quaternion;

namespace {

Error bad_axis(const char* what) {
  return {ErrorCode::bad_axis, std::string("the ") + what + " is 0: it has no direction"};
}

Result<Rational> number(std::string_view text, std::string where) {
  if (const auto v = exact::parse_rational(text)) return *v;
  return Error{ErrorCode::bad_number,
               "\"" + std::string(text.substr(0, 80)) + "\" is neither a decimal nor a rational p/q",
               {},
               std::move(where)};
}

/// `names`: of the numbers, a letter each.
template <std::size_t N>
Result<std::array<Rational, N>> numbers(const std::array<std::string, N>& texts, const std::string& what,
                                        std::string_view names = "xyz") {
  std::array<Rational, N> r;
  for (std::size_t k = 0; k < N; ++k) {
    const auto v = number(texts[k], what + ", " + names[k]);
    if (!v) return v.error();
    r[k] = v.value();
  }
  return r;
}

bool is_zero(const rounding::Vector& v) { return v == rounding::Vector{0, 0, 0}; }

}  // namespace

Motion::Motion() = default;
Motion::~Motion() = default;
Motion::Motion(const Motion&) = default;
Motion& Motion::operator=(const Motion&) = default;
Motion::Motion(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

Result<rounding::Motion> rotation_of(const rounding::Vector& axis, const Rational& degrees) {
  if (is_zero(axis)) return bad_axis("axis");
  return rounding::Motion::rotation(axis, degrees);
}

Result<rounding::Motion> turn_of(const std::array<Rational, 4>& wxyz) {
  const auto q = rounding::quaternion_along(wxyz);
  if (!q) return bad_axis("quaternion");
  return rounding::Motion::turn(*q);
}

Result<rounding::Motion> turn_of(const rounding::Matrix& rows, Rational& deviation) {
  const auto q = rounding::nearest_rotation(rows, deviation);
  if (!q)
    return Error{ErrorCode::not_a_rotation,
                 "the matrix is no rotation: its rows are not orthonormal to 1e-6, or its determinant is negative"};
  return rounding::Motion::turn(*q);
}

Result<rounding::Motion> mirror_of(const rounding::Vector& normal) {
  if (is_zero(normal)) return bad_axis("normal");
  return rounding::Motion::mirror(normal);
}

Result<rounding::Motion> scaling_of(const rounding::Vector& factors) {
  for (const Rational& x : factors)
    if (x <= 0)
      return Error{ErrorCode::bad_factor,
                   "a factor must be positive, not " + exact::to_string(x) + "; a mirror image turns a solid round"};
  return rounding::Motion::scaling(factors);
}

namespace {

Result<Motion> published(Result<rounding::Motion> motion) {
  if (!motion) return motion.error();
  return Access::motion(std::move(motion).value());
}

}  // namespace

Result<Motion> Motion::rotation(const Text3& axis, std::string_view degrees) {
  const auto a = numbers(axis, "axis");
  if (!a) return a.error();
  const auto angle = number(degrees, "angle");
  if (!angle) return angle.error();
  return published(rotation_of(a.value(), angle.value()));
}

Result<Motion> Motion::translation(const Text3& by) {
  const auto v = numbers(by, "translation");
  if (!v) return v.error();
  return Access::motion(rounding::Motion::translation(v.value()));
}

Result<Motion> Motion::quaternion(const std::array<std::string, 4>& wxyz) {
  const auto v = numbers(wxyz, "quaternion", "wxyz");
  if (!v) return v.error();
  return published(turn_of(v.value()));
}

Result<Motion> Motion::matrix(const std::array<Text3, 3>& rows, double* deviation) {
  rounding::Matrix m;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = numbers(rows[i], "row " + std::to_string(i));
    if (!row) return row.error();
    m[i] = row.value();
  }
  Rational difference = 0;
  auto motion = turn_of(m, difference);
  if (motion && deviation) *deviation = exact::to_double(difference);
  return published(std::move(motion));
}

Result<Motion> Motion::mirror(const Text3& normal) {
  const auto n = numbers(normal, "normal");
  if (!n) return n.error();
  return published(mirror_of(n.value()));
}

Result<Motion> Motion::scaling(const Text3& by) {
  const auto v = numbers(by, "factors");
  if (!v) return v.error();
  return published(scaling_of(v.value()));
}

Motion Motion::then(const Motion& next) const {
  return Access::motion(Access::motion(*this).then(Access::motion(next)));
}

Motion Motion::inverse() const { return Access::motion(Access::motion(*this).inverse()); }

MotionInfo Motion::info() const {
  const rounding::RealizedMotion realized = rounding::realize(Access::motion(*this));
  MotionInfo info;
  if (realized.rotation) {
    const Quaternion& q = *realized.rotation;
    info.quaternion = {q.w.str(), q.x.str(), q.y.str(), q.z.str()};
  }

  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) info.linear[i][j] = exact::to_string(realized.map.linear[i][j]);
    info.shift[i] = exact::to_string(realized.map.shift[i]);
  }
  info.angle_error = exact::double_above(realized.angle_error_degrees);
  return info;
}

bool operator==(const Motion& a, const Motion& b) { return Access::motion(a) == Access::motion(b); }

}  // namespace quoin
