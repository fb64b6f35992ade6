#include "booleans/on_lattice.h"

#include <algorithm>
#include <optional>

#include "booleans/body/canonical.h"
#include "exact/rational.h"
#include "grid/snap.h"

namespace quoin::booleans {

using exact::Integer;
using exact::Rational;

namespace {

/// new = (scale * old + shift) / divisor, all integers, scale and divisor > 0: grid steps of one lattice to another's.
struct Map {
  Integer scale, divisor;
  std::array<Integer, 3> shift;
};

Map map_between(const grid::Lattice& from, const grid::Lattice& to) {
  const Rational ratio = from.step / to.step;
  std::array<Rational, 3> shift;
  for (std::size_t k = 0; k < 3; ++k) shift[k] = (from.origin[k] - to.origin[k]) / to.step;
  const auto [n, divisor] = exact::over_common_denominator(std::array{ratio, shift[0], shift[1], shift[2]});
  return {n[0], divisor, {n[1], n[2], n[3]}};
}

enum class Misfit { none, inexact, out_of_range };

/// Carries elements over; the first that does not fit is remembered and the others are then meaningless.
class Mover {
 public:
  explicit Mover(const Map& map) : map_(map) {}
  Misfit fault() const { return fault_; }

  exact::Point point(const exact::Point& p) {
    const Integer w = exact::to_integer(p.w);
    std::array<Integer, 4> v{0, 0, 0, map_.divisor * w};
    Integer content = v[3];
    for (std::size_t k = 0; k < 3; ++k) {
      v[k] = map_.scale * exact::to_integer(p.x[k]) + map_.shift[k] * w;
      content = gcd(content, v[k]);
    }
    for (Integer& x : v) x /= content;
    for (std::size_t k = 0; k < 3; ++k)
      if (abs(v[k]) > v[3] * exact::world) return fail(Misfit::out_of_range, p);

    exact::Point r{};
    const auto denominator = exact::to_int<exact::Denominator::bits>(v[3]);
    if (!denominator) return fail(Misfit::inexact, p);
    r.w = *denominator;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto numerator = exact::to_int<exact::Numerator::bits>(v[k]);
      if (!numerator) return fail(Misfit::inexact, p);
      r.x[k] = *numerator;
      r.approximation[k] = exact::rounded_quotient(r.x[k], r.w);
    }
    return r;
  }

  /// Precondition: the map leads to grid points.
  exact::GridPoint grid_point(const exact::GridPoint& p) {
    exact::GridPoint r{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Integer x = map_.scale * p.c[k] + map_.shift[k];
      if (abs(x) > exact::world) return fail(Misfit::out_of_range, p);
      r.c[k] = static_cast<std::int32_t>(x);
    }
    return r;
  }

  // n . x + d = 0 with x = (divisor y - shift) / scale.
  exact::Plane plane(const exact::Plane& p) {
    std::array<Integer, 4> v;
    v[3] = exact::to_integer(p.d) * map_.scale;
    Integer content = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      v[k] = p.n[k] * map_.divisor;
      v[3] -= p.n[k] * map_.shift[k];
      content = gcd(content, v[k]);
    }
    content = gcd(content, v[3]);

    const Integer limit = exact::coefficient_limit, offset_limit = exact::to_integer(exact::offset_limit);
    exact::Plane r{};
    for (std::size_t k = 0; k < 3; ++k) {
      v[k] /= content;
      if (abs(v[k]) > limit) return fail(Misfit::inexact, p);
      r.n[k] = static_cast<std::int64_t>(v[k]);
    }
    v[3] /= content;
    if (abs(v[3]) > offset_limit) return fail(Misfit::inexact, p);
    r.d = exact::to_int<exact::Offset::bits>(v[3])->low();
    return r;
  }

 private:
  template <class Element>
  const Element& fail(Misfit fault, const Element& element) {
    // Of two faults the worse: no finer step mends a point outside the world.
    fault_ = std::max(fault_, fault);
    return element;
  }

  const Map& map_;
  Misfit fault_ = Misfit::none;
};

/// Grid points stay grid points: the body keeps its shape.
Misfit move_body(const Map& map, Body& body) {
  Mover mover(map);
  // Their boxes are of the old lattice.
  body.chunks.clear();
  for (auto& p : body.grid_points.edit()) p = mover.grid_point(p);
  for (auto& p : body.points.edit()) p = mover.point(p);
  for (auto& p : body.planes.edit()) p = mover.plane(p);
  for (auto& b : body.labels.borders.edit()) b.other = mover.plane(b.other);
  return mover.fault();
}

/// Grid points may become derived ones: triangles become the maximal faces they are parts of.
Misfit move_boundary(const Map& map, Boundary& boundary) {
  Mover mover(map);
  for (auto& p : boundary.vertices) p = mover.point(p);
  for (auto& p : boundary.planes) p = mover.plane(p);
  for (auto& b : boundary.labels.borders.edit()) b.other = mover.plane(b.other);
  return mover.fault();
}

/// A body on another lattice; `form`, its canonical form, is made when it is first needed.
Misfit moved(const Body& body, const Map& map, std::optional<Body>& result, std::optional<Boundary>& form) {
  Misfit fault = Misfit::none;
  if (map.divisor == 1) {
    result = body;
    fault = move_body(map, *result);
  } else {
    if (!form) form = labelled_boundary(body);
    Boundary boundary = *form;
    fault = move_boundary(map, boundary);
    if (fault == Misfit::none) result = body_of(boundary);
  }

  if (fault != Misfit::none) result.reset();
  return fault;
}
Misfit moved(const Body& body, const Map& map, std::optional<Body>& result) {
  std::optional<Boundary> form;
  return moved(body, map, result, form);
}

/// The coarsest lattice with the target's origin on which every point of both lattices lies.
grid::Lattice common_lattice(const grid::Lattice& from, const grid::Lattice& to) {
  grid::Lattice r = to;
  r.step = exact::common_divisor(from.step, to.step);
  for (std::size_t k = 0; k < 3; ++k) r.step = exact::common_divisor(r.step, Rational(from.origin[k] - to.origin[k]));
  return r;
}

/// The first vertex that has the fault, or the first face whose plane has it, by its first corner. One has.
std::string place_of(const Body& body, const grid::Lattice& from, const Map& map, Misfit fault) {
  const auto fails = [&](auto&& carry) {
    Mover mover(map);
    carry(mover);
    return mover.fault() == fault;
  };
  const auto described = [&, rounder = grid::Rounder(from)](const exact::Point& p) {
    const std::array<double, 3> x{rounder.to_double(p, 0), rounder.to_double(p, 1), rounder.to_double(p, 2)};
    return grid::describe_point(x.data());
  };

  const auto place_in = [&](const auto& vertices, const auto& planes, const auto& first_corner) -> std::string {
    for (const exact::Point& p : vertices)
      if (fails([&](Mover& m) { m.point(p); })) return "vertex " + described(p);
    for (std::size_t f = 0; f < planes.size(); ++f)
      if (fails([&](Mover& m) { m.plane(planes[f]); })) return "face at " + described(first_corner(f));
    return {};
  };

  if (map.divisor != 1) {
    const auto form = canonical(body);
    return place_in(form.vertices, form.planes,
                    [&](std::size_t f) { return form.vertices[form.faces.corners_of(f)[0]]; });
  }
  for (const exact::GridPoint& p : body.grid_points)
    if (fails([&](Mover& m) { m.grid_point(p); })) return "vertex " + described(exact::point(p));
  return place_in(body.points, body.planes, [&](std::size_t f) { return body.point(body.polygons.corners_of(f)[0]); });
}

Error inexact(const Body& body, const grid::Lattice& from, const grid::Lattice& to) {
  const grid::Lattice common = common_lattice(from, to);
  std::optional<Body> result;
  const bool works = moved(body, map_between(from, common), result) == Misfit::none;
  return {ErrorCode::inexact_grid,
          "the solid on the grid of step " + exact::to_string(from.step) + " is not exact on the grid of step " +
              exact::to_string(to.step) + "; the step " + exact::to_string(works ? common.step : from.step) +
              " would work",
          {},
          place_of(body, from, map_between(from, to), Misfit::inexact)};
}

Error out_of_range(const Body& body, const grid::Lattice& from, const grid::Lattice& to) {
  std::optional<Body> result;
  grid::Lattice centred = to;
  centred.origin = from.origin;
  const bool works = moved(body, map_between(from, centred), result) == Misfit::none;
  return {ErrorCode::out_of_range,
          "the solid reaches beyond the world of +-2^29 steps of " + exact::to_string(to.step) +
              (works ? std::string("; the same step with the origin of its own grid would work")
                     : "; the step " + exact::to_string(from.step) + " of its own grid, with its origin, would work"),
          {},
          place_of(body, from, map_between(from, to), Misfit::out_of_range)};
}

}  // namespace

Result<Body> on_lattice(const Body& body, const grid::Lattice& from, const grid::Lattice& to) {
  std::optional<Body> result;
  switch (moved(body, map_between(from, to), result)) {
    case Misfit::none:
      break;
    case Misfit::inexact:
      return inexact(body, from, to);
    case Misfit::out_of_range:
      return out_of_range(body, from, to);
  }
  return std::move(*result);
}

std::optional<Body> Carrier::to(const grid::Lattice& lattice) {
  std::optional<Body> result;
  moved(body_, map_between(from_, lattice), result, form_);
  return result;
}

}  // namespace quoin::booleans
