#include "rounding/reconstruct.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

#include "booleans/boolean.h"
#include "booleans/embedding.h"
#include "booleans/measure.h"
#include "booleans/query.h"
#include "exact/predicates.h"
#include "grid/import.h"
#include "rounding/enclosure.h"

namespace quoin::rounding {
namespace {

using booleans::none;

/// Displacements are measured in units of 2^-unit_bits grid steps.
constexpr unsigned unit_bits = 160;

/// An upper bound of the distance of two points that are within half a unit in every coordinate of these.
Rational distance_above(const std::array<Integer, 3>& a, const std::array<Integer, 3>& b) {
  Integer sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Integer most = abs(a[k] - b[k]) + 1;
    sum += most * most;
  }
  return Rational(sqrt(sum) + 1, Integer(1) << unit_bits);
}

bool in_world(const exact::Point& p) {
  return std::all_of(p.x.begin(), p.x.end(), [&](const exact::Numerator& x) {
    return abs(exact::to_integer(x)) <= exact::to_integer(p.w) * exact::world;
  });
}

bool in_world(const std::array<double, 3>& p) {
  return std::all_of(p.begin(), p.end(), [](double x) { return std::fabs(x) <= exact::world; });
}

std::string text(const Vector& p) {
  std::string s;
  for (const Rational& x : p) s += (s.empty() ? "(" : ", ") + std::to_string(exact::to_double(x));
  return s + ")";
}

std::string name(std::size_t primitive) { return "primitive " + std::to_string(primitive); }

/// A vertex lies beyond the world. Names the power of two by which the step must grow for the farthest one.
Error out_of_range(std::size_t primitive, std::span<const Vector> points) {
  Rational most = 0;
  const Vector* farthest = nullptr;
  for (const Vector& p : points)
    for (const Rational& x : p)
      if (farthest == nullptr || magnitude(x) > most) {
        most = magnitude(x);
        farthest = &p;
      }
  Integer factor = 2;
  while (most > Rational(factor * exact::world)) factor *= 2;
  return {"out-of-range",
          "the motion carries a vertex to " + text(*farthest) + " grid steps, beyond the world of +-2^29; a step " +
              factor.str() + " times as large would do",
          {},
          name(primitive)};
}

/// A plane of one or more primitives, in its canonical orientation.
struct PlaneClass {
  WidePlane exact;
  int level = 0;  // index of the method that rounds it, of `methods`
  exact::Plane rounded{};
  std::vector<std::pair<std::uint32_t, std::uint32_t>> faces;  // (primitive, face)
};

/// A condition that a rounding breaks: C1 or C2 at this vertex with the plane of this face.
struct Violation {
  std::uint32_t vertex, face;
  std::string what;
};

class Reconstructor {
 public:
  Reconstructor(std::span<const Placement> placements, const ReconstructionOptions& options)
      : placements_(placements), options_(options), methods_{options.method, Method::best, Method::face_local} {}

  Result<Reconstruction> run() {
    out_.primitives.resize(placements_.size());
    moved_.resize(placements_.size());
    face_class_.resize(placements_.size());
    for (std::uint32_t i = 0; i < placements_.size(); ++i) {
      if (is_by_planes(i)) gather(i);
      out_.primitives[i].by_planes = is_by_planes(i);
    }
    for (PlaneClass& c : classes_) {
      if (!round(c)) return unrepresentable(c);
      if (is_cancelled()) return cancelled();
      step();
    }
    for (std::uint32_t i = 0; i < placements_.size(); ++i) {
      if (is_cancelled()) return cancelled();
      if (is_by_planes(i)) continue;
      if (const auto done = by_vertices(i); !done) return done.error();
      step();
    }
    if (const auto done = by_planes(); !done) return done.error();
    count_planes();
    return std::move(out_);
  }

 private:
  bool is_cancelled() const { return options_.cancel && options_.cancel->load(); }
  static Error cancelled() { return {"cancelled", "the motion was cancelled"}; }

  /// One plane or primitive is done; what is done again counts once more, up to the whole.
  void step() {
    const std::size_t all = classes_.size() + placements_.size();
    done_ = std::min(done_ + 1, all);
    if (options_.progress) options_.progress(static_cast<double>(done_) / static_cast<double>(all));
  }

  bool is_by_planes(std::uint32_t i) const {
    const Placement& p = placements_[i];
    return !p.shape || (p.shape->trihedral && !options_.by_vertices);
  }

  /// The classes of a primitive's planes.
  void gather(std::uint32_t i) {
    const Placement& placement = placements_[i];
    const IntegerMap back = inverse(IntegerMap(placement.to_grid));
    const auto add = [&](const WidePlane& before, std::uint32_t face) {
      WidePlane plane = moved(before, back);
      const bool turned = !is_canonical(plane);
      if (turned) plane = plane.opposite();
      const auto [at, fresh] = ids_.try_emplace(plane, static_cast<std::uint32_t>(classes_.size()));
      if (fresh) classes_.push_back({plane, 0, {}, {}});
      classes_[at->second].faces.push_back({i, face});
      face_class_[i].push_back({at->second, turned});
    };
    if (!placement.shape) return add(*placement.half_space, none);
    for (std::uint32_t f = 0; f < placement.shape->polyhedron.face_count(); ++f)
      add(placement.shape->polyhedron.planes[f], f);
  }

  const std::vector<Vector>& moved_points(std::uint32_t i) {
    if (moved_[i].empty())
      for (const Vector& p : placements_[i].shape->polyhedron.points) moved_[i].push_back(placements_[i].to_grid(p));
    return moved_[i];
  }

  /// The points of all faces on a plane.
  std::vector<Vector> points_on(const PlaneClass& c) {
    std::vector<Vector> points;
    for (const auto& [i, f] : c.faces) {
      if (f == none) continue;
      const auto& all = moved_points(i);
      placements_[i].shape->polyhedron.for_edges(
          f, [&, &v = all](std::uint32_t u, std::uint32_t) { points.push_back(v[u]); });
    }
    return points;
  }

  /// By the first method from the class' level on that gives a plane.
  bool round(PlaneClass& c) {
    for (; c.level < 3; ++c.level) {
      const Method method = methods_[static_cast<std::size_t>(c.level)];
      std::optional<exact::Plane> p;
      if (method != Method::face_local) {
        p = rounder_.round(c.exact, method);
      } else if (const auto points = points_on(c); !points.empty()) {
        p = rounder_.round_near(c.exact, points);
      } else {
        p = rounder_.round(c.exact, Method::best);
      }
      if (p) {
        c.rounded = *p;
        return true;
      }
    }
    return false;
  }

  Error unrepresentable(const PlaneClass& c) {
    for (const auto& [primitive, face] : c.faces)
      if (face != none) return out_of_range(primitive, moved_points(primitive));
    return {"out-of-range",
            "the motion carries a plane too far from the origin of the grid",
            {},
            name(c.faces.front().first)};
  }

  exact::Plane plane(std::uint32_t i, std::uint32_t face) const {
    const auto& [id, turned] = face_class_[i][face];
    return turned ? classes_[id].rounded.opposite() : classes_[id].rounded;
  }

  Result<void> by_planes() {
    std::vector<bool> pending(placements_.size());
    for (std::uint32_t i = 0; i < placements_.size(); ++i) pending[i] = is_by_planes(i);
    for (bool again = true; again;) {
      again = false;
      for (std::uint32_t i = 0; i < placements_.size(); ++i) {
        if (!pending[i]) continue;
        if (is_cancelled()) return cancelled();
        pending[i] = false;
        std::optional<Violation> violation;
        if (const auto built = build(i, violation); !built) return built.error();
        if (!violation) {
          step();
          continue;
        }
        if (!strengthen(i, *violation, pending)) return inconsistent(i, *violation);
        again = true;
      }
    }
    return {};
  }

  /// Rounds the planes of the violated condition, or all of them, by the next method; false when there is none.
  bool strengthen(std::uint32_t i, const Violation& violation, std::vector<bool>& pending) {
    std::vector<std::uint32_t> faces;
    if (violation.vertex != none) {
      faces = {violation.face};
      for (const std::uint32_t f : placements_[i].shape->trihedral->faces[violation.vertex]) faces.push_back(f);
    } else {
      for (std::uint32_t f = 0; f < face_class_[i].size(); ++f) faces.push_back(f);
    }
    bool changed = false;
    for (const std::uint32_t f : faces) {
      PlaneClass& c = classes_[face_class_[i][f].first];
      if (c.level >= 2 || rounder_.fits(c.exact)) continue;
      // `best` after `best` would change nothing.
      c.level = methods_[static_cast<std::size_t>(c.level)] == Method::best ? 2 : c.level + 1;
      if (!round(c)) c.level = 2;  // the plane stays as it was
      changed = true;
      for (const auto& user : c.faces) pending[user.first] = true;
    }
    return changed;
  }

  Error inconsistent(std::uint32_t i, const Violation& v) {
    std::string where = name(i);
    if (v.vertex != none) where += ", vertex " + std::to_string(v.vertex) + " at " + text(moved_points(i)[v.vertex]);
    if (v.face != none) where += ", face " + std::to_string(v.face);
    return {"inconsistent-motion",
            "no rounding of its planes keeps the primitive's shape: " + v.what +
                "; a smaller step, or rounding vertex by vertex, would do",
            {},
            where};
  }

  /// The body of a primitive, or the condition that fails.
  Result<void> build(std::uint32_t i, std::optional<Violation>& violation) {
    const Placement& placement = placements_[i];
    Reconstructed& result = out_.primitives[i];
    if (!placement.shape) {
      result.plane = plane(i, 0);
      return {};
    }
    const Polyhedron& shape = placement.shape->polyhedron;
    const Trihedral& t = *placement.shape->trihedral;
    const int turn = determinant(placement.to_grid.linear) < 0 ? -1 : 1;
    booleans::Canonical form;
    for (std::uint32_t f = 0; f < shape.face_count(); ++f) form.planes.push_back(plane(i, f));
    for (std::uint32_t v = 0; v < shape.points.size(); ++v) {
      const auto& [f, g, h] = t.faces[v];
      if (exact::turn(form.planes[f], form.planes[g], form.planes[h]) != turn * t.sign[v]) {
        violation = {v, h, "three planes that meet in a vertex would turn round"};
        return {};
      }
      form.vertices.push_back(snapped(*exact::meet(form.planes[f], form.planes[g], form.planes[h])));
      if (!in_world(form.vertices.back())) return out_of_range(i, moved_points(i));
    }
    for (const auto& order : t.orders)
      if (exact::side(form.planes[order.face], form.vertices[order.from]) != order.side) {
        violation = {order.from, order.face, "the vertices of an edge would change their order"};
        return {};
      }
    add_loops(form, placement);
    booleans::Body body = booleans::body_of(form);
    auto fault = booleans::fault(body);
    if (!fault) fault = booleans::embedding_fault(body);
    if (fault) {
      violation = {none, none, *fault};
      return {};
    }
    result.body = std::move(body);
    result.displacement = displacement(i, form);
    return {};
  }

  /// How far the vertices are from where the motion has them, at most.
  Rational displacement(std::uint32_t i, const booleans::Canonical& form) {
    Rational most = 0;
    const auto is_exact = [&](const auto& c) { return rounder_.fits(classes_[c.first].exact); };
    if (std::all_of(face_class_[i].begin(), face_class_[i].end(), is_exact)) return most;
    const IntegerMap map(placements_[i].to_grid);
    const auto& points = placements_[i].shape->polyhedron.points;
    for (std::size_t v = 0; v < points.size(); ++v)
      most = std::max(most, distance_above(map(points[v], unit_bits), scaled(form.vertices[v])));
    return most;
  }

  /// In units.
  static std::array<Integer, 3> scaled(const exact::Point& p) {
    const Integer w = exact::to_integer(p.w);
    std::array<Integer, 3> r;
    for (std::size_t k = 0; k < 3; ++k) r[k] = nearest_integer(Integer(exact::to_integer(p.x[k]) << unit_bits), w);
    return r;
  }

  /// A grid point in the form of grid points.
  static exact::Point snapped(const exact::Point& p) {
    exact::GridPoint g{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = p.approximation[k];
      if (x != std::floor(x) || std::fabs(x) > exact::world) return p;
      g.c[k] = static_cast<std::int32_t>(x);
    }
    const exact::Point q = exact::point(g);
    return exact::compare_lexicographic(p, q) == 0 ? q : p;
  }

  /// The body whose planes and points the motion carries to ones of the grid; nothing when one of them does not fit.
  std::optional<booleans::Body> exactly(std::uint32_t i) {
    const Placement& placement = placements_[i];
    const Polyhedron& shape = placement.shape->polyhedron;
    const IntegerMap back = inverse(IntegerMap(placement.to_grid));
    booleans::Canonical form;
    for (const WidePlane& before : shape.planes) {
      const WidePlane plane = moved(before, back);
      if (!rounder_.fits(plane)) return std::nullopt;
      form.planes.push_back(*rounder_.round(plane, Method::best));
    }
    for (const Vector& p : moved_points(i)) {
      const auto q = point(p);
      if (!q) return std::nullopt;
      form.vertices.push_back(*q);
    }
    add_loops(form, placement);
    return booleans::body_of(form);
  }

  /// The point in lowest terms, if it lies in the world and is as short as a meeting of three planes.
  static std::optional<exact::Point> point(const Vector& v) {
    const Integer common = common_denominator(v);
    const auto w = exact::to_int<exact::Denominator::bits>(common);
    if (!w) return std::nullopt;
    exact::Point p{};
    p.w = *w;
    for (std::size_t k = 0; k < 3; ++k) {
      if (magnitude(v[k]) > exact::world) return std::nullopt;
      p.x[k] = *exact::to_int<exact::Numerator::bits>(whole(v[k], common));
      p.approximation[k] = exact::rounded_quotient(p.x[k], p.w);
    }
    return p;
  }

  /// The shape's loops, turned round by a mirror image.
  static void add_loops(booleans::Canonical& form, const Placement& placement) {
    const Polyhedron& shape = placement.shape->polyhedron;
    form.face_loops = shape.face_loops;
    form.loop_corners = shape.loop_corners;
    form.corners = shape.corners;
    if (determinant(placement.to_grid.linear) > 0) return;
    for (std::size_t j = 0; j + 1 < form.loop_corners.size(); ++j)
      std::reverse(form.corners.begin() + form.loop_corners[j], form.corners.begin() + form.loop_corners[j + 1]);
  }

  Result<void> by_vertices(std::uint32_t i) {
    const Placement& placement = placements_[i];
    Reconstructed& result = out_.primitives[i];
    if (!options_.by_vertices)
      if (auto body = exactly(i)) {
        result.body = std::move(*body);
        result.by_planes = true;
        return {};
      }
    auto triangles = triangulated(placement.shape->polyhedron);
    if (!triangles) return Error{"bad-primitive", "a face is no region: its loops cross", {}, name(i)};
    const auto snapped = snapped_points(placement, result.displacement);
    if (!snapped) return out_of_range(i, moved_points(i));
    const std::vector<double>& coordinates = *snapped;
    std::vector<std::uint32_t> corners;
    const bool turned = determinant(placement.to_grid.linear) < 0;
    for (auto& t : *triangles) {
      if (turned) std::swap(t[1], t[2]);
      corners.insert(corners.end(), t.begin(), t.end());
    }
    auto mesh = grid::import_triangles(coordinates, corners, grid::Lattice{}, grid::Facing::any);
    if (!mesh) {
      Error error = mesh.error();
      error.where = name(i);
      return error;
    }
    result.merged_points = merged_points(coordinates);
    result.zero_area_triangles = mesh.value().zero_area_triangles;
    if (mesh.value().triangles.empty()) return {};
    booleans::Body body;
    body.grid_points = std::move(mesh.value().points);
    body.triangles = std::move(mesh.value().triangles);
    auto resolved = booleans::resolve(std::move(body), result.resolved_crossings);
    if (!resolved) return resolved.error();
    // What rounding has turned inside out as a whole has no inside.
    if (booleans::volume(resolved.value()) > 0) result.body = std::move(resolved).value();
    return {};
  }

  /// The points of a shape at the grid points nearest to where they are carried, ties to even, three coordinates each;
  /// nothing if one leaves the world. `displacement` becomes an upper bound of their movement.
  static std::optional<std::vector<double>> snapped_points(const Placement& placement, Rational& displacement) {
    const MapFilter filter(placement.to_grid);
    const IntegerMap map(placement.to_grid);
    std::vector<double> coordinates;
    double most = 0;  // the square of the largest movement, of points that the filter decides
    for (const Vector& p : placement.shape->polyhedron.points) {
      const std::array approximation{exact::to_double(p[0]), exact::to_double(p[1]), exact::to_double(p[2])};
      const bool in_steps = common_denominator(p) == 1 && in_world(approximation);
      double square = 0;
      std::array<double, 3> nearest;
      bool is_decided = true;
      for (std::size_t k = 0; k < 3 && is_decided; ++k) {
        const auto [value, error] = filter(k, approximation, in_steps);
        nearest[k] = std::nearbyint(value);
        // What looks exact is not decided here, so that exact motions have the displacement 0.
        const double distance = std::fabs(value - nearest[k]);
        is_decided = error == 0 || (distance > error && distance + error < 0.5);
        square += (distance + error) * (distance + error);
      }
      if (is_decided) {
        most = std::max(most, square);
      } else {
        std::array<Integer, 3> q = map(p, 0);
        for (std::size_t k = 0; k < 3; ++k) nearest[k] = exact::to_double(q[k]);
        if (placement.to_grid(p) != Vector{q[0], q[1], q[2]}) {
          for (Integer& x : q) x <<= unit_bits;
          displacement = std::max(displacement, distance_above(map(p, unit_bits), q));
        }
      }
      if (!in_world(nearest)) return std::nullopt;
      coordinates.insert(coordinates.end(), nearest.begin(), nearest.end());
    }
    // The sums and the root are rounded: far less than 2^-40.
    displacement = std::max(displacement, exact::to_rational(std::sqrt(most) * (1 + 0x1p-40)));
    return coordinates;
  }

  /// How many points lie where an earlier one does.
  static std::uint64_t merged_points(const std::vector<double>& coordinates) {
    std::vector<std::array<double, 3>> points;
    for (std::size_t i = 0; i < coordinates.size(); i += 3)
      points.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
    std::sort(points.begin(), points.end());
    return static_cast<std::uint64_t>(points.end() - std::unique(points.begin(), points.end()));
  }

  void count_planes() {
    out_.planes = classes_.size();
    for (const PlaneClass& c : classes_) {
      const bool fits = rounder_.fits(c.exact);
      out_.exact_planes += fits;
      out_.face_local_planes += !fits && methods_[static_cast<std::size_t>(c.level)] == Method::face_local;
    }
  }

  std::span<const Placement> placements_;
  const ReconstructionOptions& options_;
  std::array<Method, 3> methods_;
  PlaneRounder rounder_;
  std::map<WidePlane, std::uint32_t> ids_;
  std::vector<PlaneClass> classes_;
  std::vector<std::vector<std::pair<std::uint32_t, bool>>> face_class_;  // by primitive and face: class, turned round
  std::vector<std::vector<Vector>> moved_;
  std::size_t done_ = 0;  // planes rounded and primitives made
  Reconstruction out_;
};

/// An upper bound of the distance of the points from the origin.
Rational reach_of(const Polyhedron& p) {
  double most = 0;
  for (const Vector& v : p.points) {
    const double x = exact::to_double(v[0]), y = exact::to_double(v[1]), z = exact::to_double(v[2]);
    most = std::max(most, x * x + y * y + z * z);
  }
  // Far from under- and overflow all these roundings are less than 2^-40 of it.
  if (most > 0x1p-900 && most < 0x1p1000) return exact::to_rational(std::sqrt(most) * (1 + 0x1p-40));
  Rational square = 0;
  for (const Vector& v : p.points) square = std::max(square, dot(v, v));
  return root_above(square);
}

}  // namespace

Shape::Shape(Polyhedron p, const grid::Lattice& units)
    : polyhedron(std::move(p)),
      trihedral(rounding::trihedral(polyhedron)),
      to_model(inverse(rounding::to_grid(units))),
      reach(units.step * reach_of(polyhedron) + root_above(dot(units.origin, units.origin))) {}

Result<Reconstruction> reconstruct(std::span<const Placement> placements, const ReconstructionOptions& options) {
  return Reconstructor(placements, options).run();
}

}  // namespace quoin::rounding
