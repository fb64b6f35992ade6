#include <algorithm>
#include <charconv>
#include <numeric>
#include <optional>
#include <string_view>

#include "api/access.h"
#include "api/doors/exact_document.h"
#include "booleans/body/canonical.h"
#include "booleans/body/validity.h"
#include "booleans/embedding.h"
#include "exact/lowest_terms.h"
#include "io/quoin.h"

namespace quoin {

using exact::Integer;
using exact::Rational;

namespace {

Error bad(std::string message, std::string where) {
  return {ErrorCode::bad_quoin, std::move(message), {}, std::move(where)};
}

std::string vertex_name(std::size_t v) { return "vertex " + std::to_string(v); }
std::string face_name(std::size_t f) { return "face " + std::to_string(f); }

/// The decimals of a record's four numbers, until the next one.
class Decimals {
 public:
  std::array<std::string_view, 4> of(const exact::Point& p) {
    return {text(0, p.x[0]), text(1, p.x[1]), text(2, p.x[2]), text(3, p.w)};
  }
  std::array<std::string_view, 4> of(const exact::Plane& p) {
    return {text(0, p.n[0]), text(1, p.n[1]), text(2, p.n[2]), text(3, p.d)};
  }

 private:
  using Room = std::array<char, 88>;  // 80 digits and more

  template <int Bits>
  std::string_view text(std::size_t k, const exact::Int<Bits>& v) {
    if (v == exact::Int<Bits>(v.low())) return text(k, v.low());
    const std::string digits = exact::to_integer(v).str();
    std::copy(digits.begin(), digits.end(), room_[k].begin());
    return {room_[k].data(), digits.size()};
  }
  std::string_view text(std::size_t k, exact::int128 v) {
    char* at = room_[k].data();
    auto size = static_cast<exact::uint128>(v);
    if (v < 0) {
      *at++ = '-';
      size = -size;
    }
    return {room_[k].data(), static_cast<std::size_t>(written(at, size) - room_[k].data())};
  }

  /// Writes all digits in words of 19. Returns the end.
  static char* written(char* at, exact::uint128 v) {
    constexpr std::uint64_t word = 10'000'000'000'000'000'000u;
    if (v < word) return std::to_chars(at, at + 20, static_cast<std::uint64_t>(v)).ptr;

    at = written(at, v / word);
    auto rest = static_cast<std::uint64_t>(v % word);
    for (char* digit = at + 19; digit != at; rest /= 10) *--digit = static_cast<char>('0' + rest % 10);
    return at + 19;
  }

  std::array<Room, 4> room_;
};

/// A rational in lowest terms.
Result<Rational> lattice_number(std::string_view text) {
  const auto value = exact::parse_rational(text);
  if (!value || exact::to_string(*value) != text)
    return bad("\"" + std::string(text.substr(0, 80)) + "\" is not a rational in lowest terms", "grid");
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

/// A number of at most 19 digits.
std::uint64_t short_number(std::string_view digits) {
  std::uint64_t value = 0;
  for (const char c : digits) value = 10 * value + static_cast<std::uint64_t>(c - '0');
  return value;
}

/// An integer of at most 38 digits (10^38 < 2^127); nothing where there are more.
std::optional<exact::int128> short_integer(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  if (text.size() > 38) return std::nullopt;

  // The last 19 digits in one word, those before it in another.
  const std::size_t high_size = text.size() - std::min<std::size_t>(text.size(), 19);
  const auto high = short_number(text.substr(0, high_size)), low = short_number(text.substr(high_size));
  const exact::int128 value = exact::int128(high) * 10'000'000'000'000'000'000u + low;
  return negative ? -value : value;
}

Error outside_world(std::size_t v) {
  return bad("the vertex lies outside the world of +-2^29 grid steps", vertex_name(v));
}

Result<exact::Point> read_grid_point(const std::array<std::string_view, 4>& text, std::size_t v) {
  exact::GridPoint p{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto x = short_integer(text[k]);
    if (!x || *x > exact::world || *x < -exact::world) return outside_world(v);
    p.c[k] = static_cast<std::int32_t>(*x);
  }
  return exact::point(p);
}

Error not_in_lowest_terms(std::size_t v) { return bad("the vertex is not in lowest terms", vertex_name(v)); }

/// A derived point without its approximation; numbers of any length.
Result<exact::Point> read_long_point(const std::array<std::string_view, 4>& text, std::size_t v) {
  std::array<Integer, 4> x;
  Integer content = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    x[k] = Integer(std::string(text[k]));
    content = gcd(content, x[k]);
  }
  if (content != 1) return not_in_lowest_terms(v);
  for (std::size_t k = 0; k < 3; ++k)
    if (abs(x[k]) > x[3] * exact::world) return outside_world(v);

  exact::Point p{};
  const auto w = exact::to_int<exact::Denominator::bits>(x[3]);
  if (!w) return bad("the denominator is longer than that of any meeting of three planes", vertex_name(v));
  p.w = *w;
  // No longer than 30 bits more than the denominator.
  for (std::size_t k = 0; k < 3; ++k) p.x[k] = *exact::to_int<exact::Numerator::bits>(x[k]);
  return p;
}

/// The same of numbers that fit 128 bits, as nearly all do.
Result<exact::Point> read_short_point(const std::array<exact::int128, 4>& x, std::size_t v) {
  exact::Point p{};
  for (std::size_t k = 0; k < 3; ++k) p.x[k] = exact::Numerator(x[k]);
  p.w = exact::Denominator(x[3]);
  if (!exact::is_reduced(p)) return not_in_lowest_terms(v);

  const auto limit = p.w * exact::Coefficient(exact::world);
  for (const exact::Numerator& c : p.x)
    if (exact::compare(c, limit) > 0 || exact::compare(c, -limit) < 0) return outside_world(v);
  return p;
}

std::optional<std::array<exact::int128, 4>> short_integers(const std::array<std::string_view, 4>& text) {
  std::array<exact::int128, 4> x;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto number = short_integer(text[k]);
    if (!number) return std::nullopt;
    x[k] = *number;
  }
  return x;
}

Result<exact::Point> read_point(const std::array<std::string_view, 4>& text, std::size_t v) {
  if (text[3] == "1") return read_grid_point(text, v);

  const auto numbers = short_integers(text);
  auto p = numbers ? read_short_point(*numbers, v) : read_long_point(text, v);
  if (!p) return p;
  exact::Point& read = p.value();
  for (std::size_t k = 0; k < 3; ++k) read.approximation[k] = exact::rounded_quotient(read.x[k], read.w);
  return p;
}

Result<exact::Plane> read_plane(const std::array<std::string_view, 4>& text, std::size_t f) {
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

Result<booleans::Boundary> read_boundary(const io::ExactDocument& document) {
  booleans::Boundary boundary;
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
std::string names_of(std::span<const std::uint32_t> faces, const booleans::Boundary& boundary) {
  if (faces.empty()) return "faces";
  const auto order = booleans::faces_in_order_of_body(boundary);
  std::vector<std::uint32_t> numbers;
  for (const std::uint32_t f : faces) numbers.push_back(order[f]);
  std::sort(numbers.begin(), numbers.end());

  if (numbers.size() == 1) return face_name(numbers[0]);
  return "faces " + std::to_string(numbers[0]) + " and " + std::to_string(numbers[1]);
}

/// Room for a text whose numbers are as long as in most: more is found where they are longer.
std::string room_for(const booleans::Boundary& form) {
  constexpr std::size_t vertex = 110, plane = 90, corner = 8;
  std::string room;
  room.reserve(vertex * form.vertices.size() + plane * form.face_count() + corner * form.faces.corners.size() + 4096);
  grid::prefer_large_pages(room.data(), room.capacity());
  return room;
}

}  // namespace

std::string Solid::to_quoin() const {
  const booleans::Canonical form = booleans::canonical(Access::body(*this));
  Decimals decimals;
  io::QuoinWriter writer(room_for(form));
  const std::string step = grid_.step();
  const std::array<std::string, 3> origin = grid_.origin();
  writer.begin(step, {origin[0], origin[1], origin[2]}, form.full_at_infinity);

  writer.vertices(form.vertices.size());
  for (const exact::Point& p : form.vertices) writer.vertex(decimals.of(p));
  writer.faces(form.face_count());
  for (std::size_t f = 0; f < form.face_count(); ++f) {
    writer.face(decimals.of(form.planes[f]), form.faces.loop_count(f));
    form.faces.for_loops(f, [&](std::span<const std::uint32_t> loop) { writer.loop(loop); });
  }
  return writer.end();
}

Result<Solid> solid_of(const io::ExactDocument& document, Trust trust) {
  auto lattice = read_lattice(document);
  if (!lattice) return lattice.error();

  const auto boundary = read_boundary(document);
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

Result<Solid> Solid::from_quoin(std::string_view text, Trust trust) {
  const auto document = io::read_quoin(text);
  if (!document) return document.error();
  return solid_of(document.value(), trust);
}

Result<Solid> Solid::from_boundary(const ExactPolygons& polygons, Trust trust) {
  const GridText grid(polygons.grid);
  const auto document = document_of(polygons, grid);
  if (!document) return document.error();
  return solid_of(document.value(), trust);
}

}  // namespace quoin
