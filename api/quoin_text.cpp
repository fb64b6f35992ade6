#include <algorithm>
#include <numeric>
#include <optional>
#include <string_view>

#include "api/access.h"
#include "booleans/body/canonical.h"
#include "booleans/body/validity.h"
#include "booleans/embedding.h"
#include "io/quoin.h"

namespace quoin {

using booleans::Boundary;
using exact::Integer;
using exact::Rational;

namespace {

Error bad(std::string message, std::string where) {
  return {ErrorCode::bad_quoin, std::move(message), {}, std::move(where)};
}

std::string vertex_name(std::size_t v) { return "vertex " + std::to_string(v); }
std::string face_name(std::size_t f) { return "face " + std::to_string(f); }

template <int Bits>
std::string text_of(const exact::Int<Bits>& v) {
  return exact::to_integer(v).str();
}

/// A rational in lowest terms.
Result<Rational> lattice_number(const std::string& text) {
  const auto value = exact::parse_rational(text);
  if (!value || exact::to_string(*value) != text)
    return bad("\"" + text.substr(0, 80) + "\" is not a rational in lowest terms", "grid");
  return *value;
}

Result<grid::Lattice> read_lattice(const io::ExactDocument& document) {
  grid::Lattice lattice;
  const auto step = lattice_number(document.step);
  if (!step) return step.error();
  if (step.value() <= 0) return bad("the step of the grid is not positive", "grid");
  lattice.step = step.value();

  for (std::size_t k = 0; k < 3; ++k) {
    const auto origin = lattice_number(document.origin[k]);
    if (!origin) return origin.error();
    lattice.origin[k] = origin.value();
  }
  return lattice;
}

/// An integer of at most 38 digits (10^38 < 2^127); nothing where there are more.
std::optional<exact::int128> short_integer(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  if (text.size() > 38) return std::nullopt;

  exact::int128 value = 0;
  for (const char c : text) value = 10 * value + (c - '0');
  return negative ? -value : value;
}

Error outside_world(std::size_t v) {
  return bad("the vertex lies outside the world of +-2^29 grid steps", vertex_name(v));
}

Result<exact::Point> read_grid_point(const std::array<std::string, 4>& text, std::size_t v) {
  exact::GridPoint p{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto x = short_integer(text[k]);
    if (!x || *x > exact::world || *x < -exact::world) return outside_world(v);
    p.c[k] = static_cast<std::int32_t>(*x);
  }
  return exact::point(p);
}

Result<exact::Point> read_point(const std::array<std::string, 4>& text, std::size_t v) {
  if (text[3] == "1") return read_grid_point(text, v);

  std::array<Integer, 4> x;
  Integer content = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    x[k] = Integer(text[k]);
    content = gcd(content, x[k]);
  }
  if (content != 1) return bad("the vertex is not in lowest terms", vertex_name(v));
  for (std::size_t k = 0; k < 3; ++k)
    if (abs(x[k]) > x[3] * exact::world) return outside_world(v);

  exact::Point p{};
  const auto w = exact::to_int<exact::Denominator::bits>(x[3]);
  if (!w) return bad("the denominator is longer than that of any meeting of three planes", vertex_name(v));
  p.w = *w;
  for (std::size_t k = 0; k < 3; ++k) {
    // No longer than 30 bits more than the denominator.
    p.x[k] = *exact::to_int<exact::Numerator::bits>(x[k]);
    p.approximation[k] = exact::rounded_quotient(p.x[k], p.w);
  }
  return p;
}

Result<exact::Plane> read_plane(const std::array<std::string, 4>& text, std::size_t f) {
  exact::Plane p{};
  std::int64_t content = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto n = short_integer(text[k]);
    if (!n || *n > exact::coefficient_limit || *n < -exact::coefficient_limit)
      return bad("a coefficient of the plane exceeds 2^62 - 1", face_name(f));
    p.n[k] = static_cast<std::int64_t>(*n);
    content = std::gcd(content, p.n[k]);
  }
  if (content == 0) return bad("the plane has no normal", face_name(f));

  const auto d = short_integer(text[3]);
  if (!d || *d > exact::offset_limit || *d < -exact::offset_limit)
    return bad("the offset of the plane exceeds (2^62 - 1)^2", face_name(f));
  p.d = *d;
  if (std::gcd(content, static_cast<std::int64_t>(p.d % content)) != 1)
    return bad("the plane is not in lowest terms", face_name(f));
  return p;
}

Result<Boundary> read_boundary(io::ExactDocument& document) {
  Boundary boundary;
  boundary.full_at_infinity = document.full_at_infinity;

  boundary.vertices.reserve(document.vertices.size());
  for (std::size_t v = 0; v < document.vertices.size(); ++v) {
    const auto p = read_point(document.vertices[v], v);
    if (!p) return p.error();
    boundary.vertices.push_back(p.value());
  }

  boundary.planes.reserve(document.planes.size());
  for (std::size_t f = 0; f < document.planes.size(); ++f) {
    const auto p = read_plane(document.planes[f], f);
    if (!p) return p.error();
    boundary.planes.push_back(p.value());
  }

  boundary.faces.face_start.assign(document.face_loops.begin(), document.face_loops.end());
  boundary.faces.loop_start.assign(document.loop_corners.begin(), document.loop_corners.end());
  boundary.faces.corners.assign(document.corners.begin(), document.corners.end());
  return boundary;
}

/// "faces 3 and 7", counted as in the text; "faces" where none is known. `faces`: of the body.
std::string names_of(std::span<const std::uint32_t> faces, const Boundary& boundary) {
  if (faces.empty()) return "faces";
  const auto order = booleans::faces_in_order_of_body(boundary);
  std::vector<std::uint32_t> numbers;
  for (const std::uint32_t f : faces) numbers.push_back(order[f]);
  std::sort(numbers.begin(), numbers.end());

  if (numbers.size() == 1) return face_name(numbers[0]);
  return "faces " + std::to_string(numbers[0]) + " and " + std::to_string(numbers[1]);
}

}  // namespace

std::string Solid::to_quoin() const {
  const booleans::Canonical form = booleans::canonical(Access::body(*this));
  io::ExactDocument document;
  document.step = grid_.step();
  document.origin = grid_.origin();
  document.full_at_infinity = form.full_at_infinity;

  document.vertices.reserve(form.vertices.size());
  for (const auto& p : form.vertices)
    document.vertices.push_back({text_of(p.x[0]), text_of(p.x[1]), text_of(p.x[2]), text_of(p.w)});
  document.planes.reserve(form.face_count());
  for (const auto& p : form.planes)
    document.planes.push_back(
        {std::to_string(p.n[0]), std::to_string(p.n[1]), std::to_string(p.n[2]), exact::to_integer(p.d).str()});

  document.face_loops.assign(form.faces.face_start.begin(), form.faces.face_start.end());
  document.loop_corners.assign(form.faces.loop_start.begin(), form.faces.loop_start.end());
  document.corners.assign(form.faces.corners.begin(), form.faces.corners.end());
  return io::write_quoin(document);
}

Result<Solid> Solid::from_quoin(std::string_view text, Trust trust) {
  auto document = io::read_quoin(text);
  if (!document) return document.error();

  auto lattice = read_lattice(document.value());
  if (!lattice) return lattice.error();

  const auto boundary = read_boundary(document.value());
  if (!boundary) return boundary.error();

  booleans::Body body = booleans::body_of(boundary.value());
  body.is_proved = trust == Trust::nothing;
  if (auto fault = booleans::fault(boundary.value())) return bad(fault->message, fault->where);
  if (trust == Trust::nothing) {
    grid::Array<std::uint32_t> faces;
    if (const auto fault = booleans::embedding_fault(body, &faces))
      return bad("the solid is not valid: " + *fault, names_of(faces, boundary.value()));
  }

  return Access::solid(Access::grid(std::move(lattice).value()), std::move(body));
}

}  // namespace quoin
