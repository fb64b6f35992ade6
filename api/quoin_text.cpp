#include <algorithm>
#include <cassert>
#include <cmath>

#include "api/access.h"
#include "booleans/canonical.h"
#include "booleans/embedding.h"
#include "booleans/query.h"
#include "exact/predicates.h"
#include "io/quoin.h"

namespace quoin {

using booleans::Canonical;
using exact::Integer;
using exact::Rational;

namespace {

Error bad(std::string message, std::string where) { return {"bad-quoin", std::move(message), {}, std::move(where)}; }

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

Result<exact::Point> read_point(const std::array<std::string, 4>& text, std::size_t v) {
  std::array<Integer, 4> x;
  Integer content = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    x[k] = Integer(text[k]);
    content = gcd(content, x[k]);
  }
  if (content != 1) return bad("the vertex is not in lowest terms", vertex_name(v));
  for (std::size_t k = 0; k < 3; ++k)
    if (abs(x[k]) > x[3] * exact::world)
      return bad("the vertex lies outside the world of +-2^29 grid steps", vertex_name(v));
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
  const Integer limit = exact::coefficient_limit, offset_limit = exact::to_integer(exact::offset_limit);
  exact::Plane p{};
  Integer content = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Integer n(text[k]);
    if (abs(n) > limit) return bad("a coefficient of the plane exceeds 2^62 - 1", face_name(f));
    p.n[k] = static_cast<std::int64_t>(n);
    content = gcd(content, n);
  }
  if (content == 0) return bad("the plane has no normal", face_name(f));
  const Integer d(text[3]);
  if (abs(d) > offset_limit) return bad("the offset of the plane exceeds (2^62 - 1)^2", face_name(f));
  if (gcd(content, d) != 1) return bad("the plane is not in lowest terms", face_name(f));
  p.d = exact::to_int<exact::Offset::bits>(d)->low();
  return p;
}

Result<Canonical> read_form(io::ExactDocument& document) {
  Canonical form;
  form.full_at_infinity = document.full_at_infinity;
  form.vertices.reserve(document.vertices.size());
  for (std::size_t v = 0; v < document.vertices.size(); ++v) {
    const auto p = read_point(document.vertices[v], v);
    if (!p) return p.error();
    form.vertices.push_back(p.value());
  }
  form.planes.reserve(document.planes.size());
  for (std::size_t f = 0; f < document.planes.size(); ++f) {
    const auto p = read_plane(document.planes[f], f);
    if (!p) return p.error();
    form.planes.push_back(p.value());
  }
  form.face_loops = std::move(document.face_loops);
  form.loop_corners = std::move(document.loop_corners);
  form.corners = std::move(document.corners);
  return form;
}

/// Vertices are points in lowest terms: equal ones have equal numbers.
std::optional<Error> vertex_fault(const Canonical& form) {
  std::vector<std::uint32_t> order(form.vertices.size());
  for (std::uint32_t v = 0; v < order.size(); ++v) order[v] = v;
  std::sort(order.begin(), order.end(), [&](std::uint32_t u, std::uint32_t v) {
    return form.vertices[u].approximation < form.vertices[v].approximation ||
           (form.vertices[u].approximation == form.vertices[v].approximation &&
            exact::compare_lexicographic(form.vertices[u], form.vertices[v]) < 0);
  });
  for (std::size_t i = 1; i < order.size(); ++i)
    if (exact::compare_lexicographic(form.vertices[order[i - 1]], form.vertices[order[i]]) == 0)
      return bad("vertex " + std::to_string(std::min(order[i - 1], order[i])) + " is the same point",
                 vertex_name(std::max(order[i - 1], order[i])));
  return std::nullopt;
}

/// visit(u, v) for the directed edges of a face.
template <class Visit>
void for_face_edges(const Canonical& form, std::size_t f, Visit&& visit) {
  for (std::uint32_t j = form.face_loops[f]; j < form.face_loops[f + 1]; ++j) {
    const std::uint32_t begin = form.loop_corners[j], end = form.loop_corners[j + 1];
    for (std::uint32_t c = begin; c < end && end - begin > 1; ++c)
      visit(form.corners[c], form.corners[c + 1 < end ? c + 1 : begin]);
  }
}

/// The sign of the face's area, counter-clockwise seen from outside being positive.
int area_sign(const Canonical& form, std::size_t f) {
  const auto& n = form.planes[f].n;
  std::size_t k = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(n[i]) > std::abs(n[k])) k = i;
  const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
  // In doubles first: a term has an error of five roundings at most, the sum of m terms m more.
  double sum = 0, size = 0;
  std::size_t terms = 0;
  for_face_edges(form, f, [&](std::uint32_t i, std::uint32_t j) {
    const auto &a = form.vertices[i].approximation, &b = form.vertices[j].approximation;
    const double x = a[u] * b[v], y = b[u] * a[v];
    sum += x - y;
    size += std::fabs(x) + std::fabs(y);
    ++terms;
  });
  const int turned = n[k] < 0 ? -1 : 1;
  const double bound = 2 * (static_cast<double>(terms) + 5) * exact::unit_roundoff * size;
  if (std::fabs(sum) > bound) return sum > 0 ? turned : -turned;
  Rational area = 0;
  for_face_edges(form, f, [&](std::uint32_t i, std::uint32_t j) {
    const auto &a = form.vertices[i], &b = form.vertices[j];
    area += Rational(exact::to_integer(a.x[u] * b.x[v] - b.x[u] * a.x[v]),
                     Integer(exact::to_integer(a.w) * exact::to_integer(b.w)));
  });
  return area > 0 ? turned : area < 0 ? -turned : 0;
}

std::optional<Error> face_fault(const Canonical& form, std::size_t f) {
  const std::uint32_t begin = form.loop_corners[form.face_loops[f]], end = form.loop_corners[form.face_loops[f + 1]];
  for (std::uint32_t c = begin; c < end; ++c)
    if (exact::side(form.planes[f], form.vertices[form.corners[c]]) != 0)
      return bad("vertex " + std::to_string(form.corners[c]) + " does not lie on the plane of the face", face_name(f));
  bool short_edge = false;
  for_face_edges(form, f, [&](std::uint32_t u, std::uint32_t v) { short_edge = short_edge || u == v; });
  if (short_edge) return bad("an edge of the face has length zero", face_name(f));
  const int sign = area_sign(form, f);
  if (sign == 0) return bad("the face has no area", face_name(f));
  if (sign < 0) return bad("the loops of the face do not run counter-clockwise seen from outside", face_name(f));
  return std::nullopt;
}

/// Every directed edge is balanced by its reverse, and the faces at an edge do not all lie on one plane.
std::optional<Error> edge_fault(const Canonical& form) {
  struct Edge {
    std::uint32_t low, high;
    int way;
    std::uint32_t face;
    auto key() const { return std::pair(low, high); }
  };
  std::vector<Edge> edges;
  for (std::uint32_t f = 0; f < form.face_count(); ++f)
    for_face_edges(form, f, [&](std::uint32_t u, std::uint32_t v) {
      edges.push_back({std::min(u, v), std::max(u, v), u < v ? 1 : -1, f});
    });
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tuple(a.low, a.high, a.face) < std::tuple(b.low, b.high, b.face);
  });
  for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
    std::int64_t balance = 0;
    bool flat = true;
    for (; j < edges.size() && edges[j].key() == edges[i].key(); ++j) {
      balance += edges[j].way;
      flat = flat && exact::parallel(form.planes[edges[i].face], form.planes[edges[j].face]);
    }
    if (balance != 0)
      return bad("the edge between the vertices " + std::to_string(edges[i].low) + " and " +
                     std::to_string(edges[i].high) + " is not balanced by its reverse",
                 face_name(edges[i].face));
    if (flat)
      return bad("all faces at the edge between the vertices " + std::to_string(edges[i].low) + " and " +
                     std::to_string(edges[i].high) + " lie on one plane: it is no edge",
                 face_name(edges[j - 1].face));
  }
  return std::nullopt;
}

std::optional<Error> fault_of(const Canonical& form) {
  if (auto fault = vertex_fault(form)) return fault;
  for (std::size_t f = 0; f < form.face_count(); ++f)
    if (auto fault = face_fault(form, f)) return fault;
  return edge_fault(form);
}

}  // namespace

std::string Solid::to_quoin() const {
  const Canonical form = booleans::canonical(Access::body(*this));
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
  document.face_loops = form.face_loops;
  document.loop_corners = form.loop_corners;
  document.corners = form.corners;
  return io::write_quoin(document);
}

Result<Solid> Solid::from_quoin(std::string_view text, Trust trust) {
  auto document = io::read_quoin(text);
  if (!document) return document.error();
  auto lattice = read_lattice(document.value());
  if (!lattice) return lattice.error();
  const auto form = read_form(document.value());
  if (!form) return form.error();
  if (auto fault = fault_of(form.value())) return *fault;
  booleans::Body body = booleans::body_of(form.value());
  if (const auto fault = booleans::fault(body)) return bad("the solid is not valid: " + *fault, "faces");
  if (trust == Trust::nothing)
    if (const auto fault = booleans::embedding_fault(body)) return bad("the solid is not valid: " + *fault, "faces");
  return Access::solid(Access::grid(std::move(lattice).value()), std::move(body));
}

}  // namespace quoin
