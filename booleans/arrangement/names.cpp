#include "booleans/arrangement/names.h"

#include <bit>
#include <cmath>

namespace quoin::booleans {

PlaneId PlaneTable::id(const exact::Plane& plane) {
  const exact::Plane key = exact::is_canonical(plane) ? plane : plane.opposite();
  const std::size_t mask = slots_.size() - 1;
  std::size_t i = exact::hash(key) & mask;
  for (; slots_[i] != none; i = (i + 1) & mask)
    if (planes_[slots_[i]] == key) return slots_[i];

  const PlaneId id = planes_.add(key);
  slots_[i] = id;
  approximations_.push_back(exact::approximation(key));
  if (planes_.size() * 2 > slots_.size()) grow(slots_.size() * 2);
  return id;
}

void PlaneTable::reserve(std::size_t more) {
  const std::size_t n = planes_.size() + more;
  planes_.reserve(n);
  approximations_.reserve(n);
  if (n * 2 > slots_.size()) grow(std::bit_ceil(n * 2));
}

void PlaneTable::grow(std::size_t slots) {
  slots_.assign(slots, none);
  const std::size_t mask = slots_.size() - 1;
  for (const PlaneId id : Ids<PlaneId>(planes_.size())) {
    std::size_t i = exact::hash(planes_[id]) & mask;
    while (slots_[i] != none) i = (i + 1) & mask;
    slots_[i] = id;
  }
}

VertexTable::VertexTable() : slots_(64, none) {}

namespace {

std::size_t hash(const std::array<double, 3>& key) {
  std::uint64_t h = 0x9E3779B97F4A7C15u;
  for (double x : key) {
    h = (h ^ std::bit_cast<std::uint64_t>(x)) * 0xFF51AFD7ED558CCDu;
    h ^= h >> 29;
  }
  return h ^ (h >> 32);
}

/// Is the point a grid point? Correct rounding maps integers to themselves, so only integral approximations ask.
bool is_integral(const exact::Point& p) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = p.approximation[k];
    if (a != std::nearbyint(a)) return false;
  }
  for (std::size_t k = 0; k < 3; ++k)
    if (exact::compare(exact::Coefficient(static_cast<std::int64_t>(p.approximation[k])) * p.w, p.x[k]) != 0)
      return false;
  return true;
}

}  // namespace

VertexId& VertexTable::slot(const std::array<double, 3>& key, const exact::Point* exact) {
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t i = hash(key) & mask;; i = (i + 1) & mask) {
    const VertexId v = slots_[i];
    if (v == none) return slots_[i];
    if (approximations_[v] != key || is_grid(v) != (exact == nullptr)) continue;
    if (exact == nullptr) return slots_[i];
    const exact::Point& other = points_[derived_[v]];
    ++exact::counters().fixed_width;
    bool equal = true;
    for (std::size_t k = 0; k < 3 && equal; ++k)
      equal = exact::compare(exact->x[k] * other.w, other.x[k] * exact->w) == 0;
    if (equal) return slots_[i];
  }
}

void VertexTable::reserve(std::size_t more, std::size_t derived) {
  const std::size_t n = size() + more;
  approximations_.reserve(n);
  derived_.reserve(n);
  points_.reserve(points_.size() + derived);
  if (n * 2 > slots_.size()) grow(std::bit_ceil(n * 2));
}

void VertexTable::grow(std::size_t slots) {
  Array<VertexId> old(slots, none);
  slots_.swap(old);
  const std::size_t mask = slots_.size() - 1;
  for (const VertexId v : old) {
    if (v == none) continue;
    std::size_t i = hash(approximations_[v]) & mask;
    while (slots_[i] != none) i = (i + 1) & mask;
    slots_[i] = v;
  }
}

VertexId VertexTable::insert(const std::array<double, 3>& key, const exact::Point* exact) {
  VertexId& s = slot(key, exact);
  if (s != none) return s;

  const VertexId v = approximations_.add(key);
  s = v;
  derived_.push_back(exact ? static_cast<std::uint32_t>(points_.size()) : none);
  if (exact) points_.push_back(*exact);
  if (approximations_.size() * 2 > slots_.size()) grow(slots_.size() * 2);
  return v;
}

VertexId VertexTable::id(const exact::GridPoint& p) {
  return insert({double(p[0]), double(p[1]), double(p[2])}, nullptr);
}

VertexId VertexTable::id(const exact::Point& p) { return insert(p.approximation, is_integral(p) ? nullptr : &p); }

VertexId VertexTable::id(const Body& body, std::uint32_t v) {
  return body.is_grid(v) ? id(body.grid_points[v]) : id(body.derived(v));
}

int VertexTable::exact_side(VertexId v, const exact::Plane& p) const {
  return is_grid(v) ? exact::side(p, grid_point(v)) : exact::side_exact(p, points_[derived_[v]]);
}

int VertexTable::compare_along(int k, VertexId u, VertexId v) const {
  const auto i = static_cast<std::size_t>(k);
  return exact::compare_rounded(approximations_[u][i], approximations_[v][i], [&] {
    return u == v || (is_grid(u) && is_grid(v)) ? 0 : exact::compare_along(k, point(u), point(v));
  });
}

int VertexTable::compare_lexicographic(VertexId u, VertexId v) const {
  if (u == v) return 0;
  for (int k = 0; k < 3; ++k)
    if (const int c = compare_along(k, u, v)) return c;
  assert(false);
  return 0;
}

VertexId Names::name(const Body& body, OperandId operand, std::uint32_t v) {
  OperandNames& own = operands[operand];
  if (own.name_of.size() == 0) own.name_of = grid::Paged<VertexId>(body.vertex_count(), none);

  VertexId& name = own.name_of.at(v);
  if (name == none) {
    name = vertices.id(body, v);
    own.listed.push_back(v);
  }
  return name;
}

}  // namespace quoin::booleans
