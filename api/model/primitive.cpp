#include "api/model/primitive.h"

#include <algorithm>
#include <limits>

#include "api/motion.h"
#include "booleans/body/canonical.h"
#include "io/too_large.h"
#include "rounding/planes/plane_rounding.h"
#include "rounding/shapes/hull.h"
#include "rounding/shapes/primitives.h"

namespace quoin {

using exact::Rational;
using ModelNode = Access::ModelNode;
using rounding::Polyhedron;
using rounding::WidePlane;

namespace {

/// The numbers of one node, read in one scope. The first error stays, and numbers after it are 1.
class Numbers {
 public:
  Numbers(const ModelNode& node, Parameters& parameters) : node_(node), parameters_(parameters) {}

  Rational scalar(std::size_t field) { return number(node_.values[field]); }
  template <std::size_t N>
  std::array<Rational, N> vector(std::size_t field) {
    return vector<N>(node_.values[field]);
  }
  template <std::size_t N>
  std::vector<std::array<Rational, N>> list(std::size_t field) {
    return list<N>(node_.values[field]);
  }
  std::vector<std::vector<std::vector<rounding::PlanePoint>>> polygons(std::size_t field) {
    std::vector<std::vector<std::vector<rounding::PlanePoint>>> r;
    for (const ModelValue& polygon : node_.values[field].items) {
      auto& outlines = r.emplace_back();
      for (const ModelValue& outline : polygon.items) outlines.push_back(list<2>(outline));
    }
    return r;
  }
  std::uint32_t count(std::size_t field) {
    const Rational v = scalar(field);
    constexpr auto most = std::numeric_limits<std::uint32_t>::max();
    // What is larger is too large as well.
    if (denominator(v) == 1 && v >= 0) return v < most ? static_cast<std::uint32_t>(numerator(v)) : most;
    fail({ErrorCode::bad_number, "\"" + node_.values[field].text + "\" is no count, that is a whole number"});
    return 3;
  }
  rounding::Fit fit(std::size_t field) {
    const std::string& word = node_.values[field].text;
    if (word == "circumscribed") return rounding::Fit::circumscribed;
    if (word == "equal-area") return rounding::Fit::equal_area;
    if (word != "inscribed")
      fail({ErrorCode::bad_primitive, "\"" + word + "\" is no fit: inscribed, circumscribed or equal-area"});
    return rounding::Fit::inscribed;
  }

  std::optional<Error> error;

 private:
  void fail(Error e) {
    if (!error) error = std::move(e);
  }
  Rational number(const ModelValue& value) {
    auto v = parameters_.value(value.text);
    if (v) return v.value();
    fail(v.error());
    return 1;
  }
  template <std::size_t N>
  std::array<Rational, N> vector(const ModelValue& value) {
    std::array<Rational, N> r;
    for (std::size_t k = 0; k < N; ++k) r[k] = number(value.items[k]);
    return r;
  }
  template <std::size_t N>
  std::vector<std::array<Rational, N>> list(const ModelValue& value) {
    std::vector<std::array<Rational, N>> r;
    for (const ModelValue& item : value.items) r.push_back(vector<N>(item));
    return r;
  }

  const ModelNode& node_;
  Parameters& parameters_;
};

Result<WidePlane> boundary_of(const std::array<Rational, 4>& plane) {
  if (plane[0] == 0 && plane[1] == 0 && plane[2] == 0)
    return Error{ErrorCode::bad_plane, "the normal of a half-space is 0: it has no direction"};
  return rounding::wide_plane({plane[0], plane[1], plane[2]}, plane[3]);
}

}  // namespace

Expression half_space(const exact::Plane& plane, const grid::Lattice& lattice) {
  const WidePlane p =
      moved({{plane.n[0], plane.n[1], plane.n[2]}, exact::to_integer(plane.d)}, rounding::to_grid(lattice));
  return HalfSpace{{p.n[0].str(), p.n[1].str(), p.n[2].str(), p.d.str()}};
}

namespace {

/// The polyhedron that half-spaces enclose, by a Boolean of them on a grid that is coarse for it. Planes that do not
/// fit that grid are rounded, and `is_exact` becomes false.
Result<Polyhedron> boolean_intersection(const std::vector<WidePlane>& planes, bool& is_exact, const Options& run) {
  Rational reach = 0;
  for (const WidePlane& p : planes) {
    const Rational size = rounding::magnitude(p.n[0]) + rounding::magnitude(p.n[1]) + rounding::magnitude(p.n[2]);
    reach = std::max<Rational>(reach, rounding::magnitude(p.d) / size);
  }

  grid::Lattice lattice;
  while (reach > lattice.step * (1 << 18)) lattice.step *= 2;
  const rounding::PlaneRounder rounder;
  const rounding::AffineMap to_model = inverse(rounding::to_grid(lattice));

  std::vector<Expression> terms;
  for (const WidePlane& p : planes) {
    const WidePlane in_steps = moved(p, to_model);
    const auto plane = rounder.round(in_steps, rounding::Method::best);
    if (!plane) return Error{ErrorCode::out_of_range, "a half-space is too far from the others"};
    is_exact = is_exact && rounder.fits(in_steps);
    terms.push_back(half_space(*plane, lattice));
  }

  auto solid =
      evaluate(Solid::empty(Access::grid(lattice)) + Expression::intersect(std::move(terms)), {.cancel = run.cancel});
  if (!solid) return solid.error();
  if (solid.value().is_empty()) return Polyhedron{};
  return carried(rounding::polyhedron_of(booleans::labelled_boundary(Access::body(solid.value()))), to_model);
}

/// The polyhedron that half-spaces enclose, exactly.
Result<Polyhedron> intersection(const std::vector<WidePlane>& planes, const Options& run) {
  if (planes.empty()) return Error{ErrorCode::unbounded, "an intersection of no half-spaces is all of space"};
  bool is_exact = true;
  auto near = boolean_intersection(planes, is_exact, run);
  if (!near || is_exact) return near;

  // Long numbers: from any point inside.
  const std::vector<rounding::Vector>& points = near.value().points;
  rounding::Vector inside{0, 0, 0};
  for (const rounding::Vector& v : points)
    for (std::size_t k = 0; k < 3; ++k) inside[k] += v[k] / points.size();
  for (const WidePlane& p : planes)
    if (value(p, inside) >= 0)
      return Error{ErrorCode::bad_primitive,
                   "what half-spaces with numbers of more than 62 bits enclose is empty, or too thin to be found"};
  return rounding::convex_polyhedron(planes, inside);
}

Result<Polyhedron> primitive(const ModelNode& node, Numbers& n, const Limits& limits, const Options& run) {
  using enum ModelKind;
  const auto excess = [&](std::uint64_t faces) -> std::optional<Error> {
    if (faces <= limits.sides) return std::nullopt;
    return io::too_large("the primitive has more faces", "sides", limits.sides);
  };
  // Fields are read in their order, so that of two errors the first is told: compilers need not keep that of arguments.
  const auto cylinder_of = [&](const Rational& bottom, const Rational& top, std::size_t height) -> Result<Polyhedron> {
    const Rational h = n.scalar(height);
    const std::uint32_t sides = n.count(height + 1);
    const rounding::Fit fit = n.fit(height + 2);
    if (auto fault = excess(sides)) return *fault;
    return rounding::frustum(sides, bottom, top, h, fit);
  };

  switch (node.kind) {
    case block:
      return rounding::block(n.vector<3>(0));
    case wedge: {
      const auto size = n.vector<3>(0);
      return rounding::wedge(size, n.scalar(1));
    }
    case prism: {
      const std::uint32_t sides = n.count(0);
      const Rational radius = n.scalar(1), height = n.scalar(2);
      if (auto fault = excess(sides)) return *fault;
      return rounding::frustum(sides, radius, radius, height, rounding::Fit::inscribed);
    }
    case ModelKind::cylinder: {
      const Rational radius = n.scalar(0);
      return cylinder_of(radius, radius, 1);
    }
    case cone:
      return cylinder_of(n.scalar(0), 0, 1);
    case frustum: {
      const Rational bottom = n.scalar(0);
      return cylinder_of(bottom, n.scalar(1), 2);
    }
    case sphere: {
      const Rational radius = n.scalar(0);
      const std::uint32_t sides = n.count(1);
      if (auto fault = excess(std::uint64_t{sides} * (sides / 2))) return *fault;
      return rounding::sphere(radius, sides);
    }
    case tangent_sphere: {
      const Rational radius = n.scalar(0);
      const std::uint32_t count = n.count(1);
      if (auto fault = excess(count)) return *fault;
      const auto planes = rounding::tangent_sphere(radius, count);
      return planes ? rounding::convex_polyhedron(planes.value(), {0, 0, 0}) : planes.error();
    }
    case torus: {
      const Rational major = n.scalar(0), minor = n.scalar(1);
      const std::uint32_t sides = n.count(2), minor_sides = n.count(3);
      if (auto fault = excess(std::uint64_t{sides} * minor_sides)) return *fault;
      return rounding::torus(major, minor, sides, minor_sides);
    }
    case convex: {
      std::vector<WidePlane> planes;
      for (const auto& p : n.list<4>(0)) {
        const auto plane = boundary_of(p);
        if (!plane) return plane.error();
        planes.push_back(plane.value());
      }
      return intersection(planes, run);
    }
    case hull:
      return rounding::convex_hull(n.list<3>(0));
    default: {
      const auto polygons = n.polygons(0);
      return rounding::extrusion(polygons, n.vector<3>(1));
    }
  }
}

Result<rounding::Motion> motion(const ModelNode& node, Numbers& n) {
  switch (node.kind) {
    case ModelKind::rotate: {
      const auto axis = n.vector<3>(0);
      return rotation_of(axis, n.scalar(1));
    }
    case ModelKind::translate:
      return rounding::Motion::translation(n.vector<3>(0));
    case ModelKind::turn:
      return turn_of(n.vector<4>(0));
    case ModelKind::transform: {
      const auto rows = n.list<3>(0);
      Rational deviation;
      return turn_of({rows[0], rows[1], rows[2]}, deviation);
    }
    case ModelKind::mirror:
      return mirror_of(n.vector<3>(0));
    default:
      return scaling_of(n.vector<3>(0));
  }
}

/// What `make` makes of the node's numbers; a number that cannot be read comes first.
template <class Make>
auto made(const ModelNode& node, Parameters& parameters, Make&& make) -> decltype(make(std::declval<Numbers&>())) {
  Numbers numbers(node, parameters);
  auto result = make(numbers);
  if (numbers.error) return *numbers.error;
  return result;
}

}  // namespace

bool is_motion(ModelKind kind) { return kind >= ModelKind::rotate && kind <= ModelKind::scale; }

Result<Polyhedron> primitive_of(const ModelNode& node, Parameters& parameters, const Limits& limits,
                                const Options& run) {
  return made(node, parameters, [&](Numbers& n) { return primitive(node, n, limits, run); });
}

Result<WidePlane> half_space_of(const ModelNode& node, Parameters& parameters) {
  return made(node, parameters, [](Numbers& n) { return boundary_of(n.vector<4>(0)); });
}

Result<rounding::Motion> motion_of(const ModelNode& node, Parameters& parameters) {
  return made(node, parameters, [&](Numbers& n) { return motion(node, n); });
}

}  // namespace quoin
