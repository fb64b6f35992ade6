#include <algorithm>
#include <cassert>
#include <cmath>
#include <mutex>

#include "api/access.h"
#include "api/compare.h"
#include "api/evaluate.h"
#include "booleans/body/canonical.h"
#include "booleans/body/locate.h"
#include "booleans/body/measure.h"
#include "booleans/on_lattice.h"
#include "exact/counters.h"

namespace quoin {

using booleans::Body;
using booleans::Rule;
using exact::Rational;

namespace {

/// A patched body, packed when that is first needed.
struct Patched : Body {
  explicit Patched(Body&& body) : Body(std::move(body)) {}
  const Body& packed() const {
    std::call_once(once, [&] { twin = booleans::packed(*this); });
    return twin;
  }
  mutable std::once_flag once;
  mutable Body twin;
};

}  // namespace

Solid Access::solid(const Grid& grid, Body&& body) {
  if (body.is_packed) return Solid(grid, std::make_shared<const Body>(std::move(body)));
  return Solid(grid, std::make_shared<const Patched>(std::move(body)));
}

const Body& Access::operand(const Solid& solid) {
  // Never destroyed: static objects may ask when their turn to go has come.
  static const Body& empty = *new Body;
  return solid.body_ ? *solid.body_ : empty;
}

const Body& Access::body(const Solid& solid) {
  const Body& body = operand(solid);
  return body.is_packed ? body : static_cast<const Patched&>(body).packed();
}

Solid::Solid() = default;
Solid::~Solid() = default;
Solid::Solid(const Solid&) = default;
Solid::Solid(Solid&&) noexcept = default;
Solid& Solid::operator=(const Solid&) = default;
Solid& Solid::operator=(Solid&&) noexcept = default;
Solid::Solid(Grid grid, std::shared_ptr<const Body> body) : grid_(std::move(grid)), body_(std::move(body)) {}

Solid Solid::empty(const Grid& grid) { return Solid(grid, nullptr); }

Solid Solid::full(const Grid& grid) {
  Body body;
  body.full_at_infinity = true;
  return Access::solid(grid, std::move(body));
}

Result<Solid> Solid::on_grid(const Grid& grid) const {
  if (grid == grid_) return *this;
  auto body = booleans::on_lattice(Access::body(*this), Access::lattice(*this), Access::lattice(grid));
  if (!body) return body.error();
  return Access::solid(grid, std::move(body).value());
}

const Grid& Solid::grid() const { return grid_; }

bool Solid::is_empty() const {
  const Body& body = Access::operand(*this);
  return body.face_count() == 0 && !body.full_at_infinity;
}

bool Solid::is_bounded() const { return !Access::operand(*this).full_at_infinity; }

std::optional<Box> Solid::box() const { return booleans::rounded_box(Access::body(*this), Access::lattice(*this)); }

Counts Solid::counts() const {
  const booleans::CanonicalCounts c = booleans::canonical_counts(Access::body(*this));
  return {c.vertices, c.edges, c.faces};
}

double Solid::area() const {
  const Rational& step = Access::lattice(*this).step;
  return booleans::approximate_area(Access::body(*this)) * exact::to_double(Rational(step * step));
}

std::optional<std::string> Solid::volume() const {
  if (!is_bounded()) return std::nullopt;
  const Rational& step = Access::lattice(*this).step;
  return exact::to_string(Rational(booleans::volume(Access::body(*this)) * step * step * step));
}

Location Solid::classify(const std::array<double, 3>& point) const {
  assert(std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]));
  const grid::Lattice& lattice = Access::lattice(*this);
  std::array<Rational, 3> p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = (exact::to_rational(point[k]) - lattice.origin[k]) / lattice.step;
  const int where = booleans::locate(Access::body(*this), p);
  return where > 0 ? Location::inside : where == 0 ? Location::boundary : Location::outside;
}

namespace {

Solid operated(Rule rule, const Solid& a, const Solid& b, bool complement_b) {
  return evaluate_flat(rule, {a, b}, complement_b ? 1 : booleans::none).value();
}

}  // namespace

Solid operator+(const Solid& a, const Solid& b) { return operated(Rule::any, a, b, false); }
Solid operator-(const Solid& a, const Solid& b) { return operated(Rule::all, a, b, true); }
Solid operator&(const Solid& a, const Solid& b) { return operated(Rule::all, a, b, false); }
Solid operator^(const Solid& a, const Solid& b) { return operated(Rule::odd, a, b, false); }
Solid operator~(const Solid& a) { return complement(a); }

Solid complement(const Solid& solid) { return Access::solid(solid.grid(), booleans::complement(Access::body(solid))); }

bool operator==(const Solid& a, const Solid& b) {
  if (Access::identity(a) == Access::identity(b) && a.grid() == b.grid()) return true;
  const Body &p = Access::body(a), &q = Access::body(b);
  if (p.full_at_infinity != q.full_at_infinity || (p.face_count() == 0) != (q.face_count() == 0)) return false;
  return a.grid() == b.grid() ? equal_on_one_grid(p, q) : equal_across_grids(a, b);
}

Statistics statistics() {
  const exact::Counters c = exact::total_counters();
  return {c.symbolic, c.filter, c.fixed_width, c.rational};
}

}  // namespace quoin
