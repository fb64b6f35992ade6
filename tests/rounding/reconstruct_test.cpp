#include "rounding/reconstruct.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "booleans/boolean.h"
#include "booleans/embedding.h"
#include "booleans/measure.h"
#include "booleans/query.h"
#include "rounding/primitives.h"
#include "tests/rounding/support.h"

namespace quoin::rounding::testing {
namespace {

using booleans::Body;
using booleans::Canonical;

Shape shape(const Result<Polyhedron>& r) {
  EXPECT_TRUE(r.has_value()) << r.error().message;
  return Shape(r ? r.value() : Polyhedron{});
}
Placement placed(const Shape& s, const AffineMap& to_grid = {}) { return {&s, {}, to_grid}; }
AffineMap scaled(const AffineMap& map, const Rational& factor) {
  return composed(map, {{Vector{factor, 0, 0}, Vector{0, factor, 0}, Vector{0, 0, factor}}, {0, 0, 0}});
}
AffineMap shift(const Vector& by) { return {AffineMap{}.linear, by}; }
/// Some rotation by long numbers, and a shift.
AffineMap random_motion(std::mt19937_64& random) {
  return {matrix(quaternion(Integer(random() >> 32) + 1, Integer(random() >> 32), Integer(random() >> 32),
                            -Integer(random() >> 32))),
          {Rational(between(random, -1'000'000, 1'000'000), 997), Rational(between(random, -1'000'000, 1'000'000), 991),
           between(random, -1'000'000, 1'000'000)}};
}
Reconstruction made(const std::vector<Placement>& placements, const ReconstructionOptions& options = {}) {
  auto r = reconstruct(placements, options);
  EXPECT_TRUE(r.has_value()) << r.error().code << ' ' << r.error().message << ' ' << r.error().where;
  if (!r) return Reconstruction{std::vector<Reconstructed>(placements.size())};
  EXPECT_EQ(r.value().primitives.size(), placements.size());
  return std::move(r).value();
}
Reconstructed made(const Placement& placement, const ReconstructionOptions& options = {}) {
  return made(std::vector{placement}, options).primitives[0];
}

/// Clean by the proofs of booleans/; faces on one plane are joined before the second.
void expect_clean(const Body& body) {
  EXPECT_EQ(booleans::fault(body), std::nullopt);
  const Body joined = booleans::body_of(booleans::canonical(body));
  EXPECT_EQ(booleans::fault(joined), std::nullopt);
  EXPECT_EQ(booleans::embedding_fault(joined), std::nullopt);
  EXPECT_EQ(booleans::volume(joined), booleans::volume(body));
}

Vector vertex(const exact::Point& p) {
  return {exact::coordinate(p, 0), exact::coordinate(p, 1), exact::coordinate(p, 2)};
}
WidePlane wide(const exact::Plane& p) { return {{p.n[0], p.n[1], p.n[2]}, exact::to_integer(p.d)}; }
std::vector<Vector> carried(const Placement& placement) {
  std::vector<Vector> points;
  for (const Vector& p : placement.shape->polyhedron.points) points.push_back(placement.to_grid(p));
  return points;
}
/// The largest squared distance of a carried point to the nearest vertex, for shapes much larger than it.
Rational squared_movement(const Placement& placement, const Canonical& form) {
  std::vector<Vector> vertices;
  for (const exact::Point& v : form.vertices) vertices.push_back(vertex(v));
  Rational most = 0;
  for (const Vector& p : carried(placement)) {
    // Those near in doubles.
    std::vector<double> distance;
    for (const Vector& v : vertices) distance.push_back(exact::to_double(dot(v - p, v - p)));
    const double least = *std::min_element(distance.begin(), distance.end());
    Rational nearest = -1;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (distance[i] > least * 1.001 + 1e-300) continue;
      const Rational d = dot(vertices[i] - p, vertices[i] - p);
      if (nearest < 0 || d < nearest) nearest = d;
    }
    most = std::max(most, nearest);
  }
  return most;
}

/// Second way: the conditions of a simple convex polyhedron. How many pairs of a plane and a vertex not of its face are
/// there, and how many of these vertices are strictly below?
struct Conditions {
  std::size_t all = 0, hold = 0;
};
Conditions conditions(const Canonical& form) {
  Conditions c;
  for (std::uint32_t f = 0; f < form.face_count(); ++f) {
    const WidePlane plane = wide(form.planes[f]);
    const auto begin = form.corners.begin() + form.loop_corners[form.face_loops[f]];
    const auto end = form.corners.begin() + form.loop_corners[form.face_loops[f + 1]];
    for (std::uint32_t v = 0; v < form.vertices.size(); ++v) {
      if (std::find(begin, end, v) != end) {
        EXPECT_EQ(value(plane, vertex(form.vertices[v])), 0);
        continue;
      }
      ++c.all;
      c.hold += value(plane, vertex(form.vertices[v])) < 0 ? 1 : 0;
    }
  }
  return c;
}

/// Third way, from planes alone: those of a block in the order of opposite pairs. C1 and the 24 conditions.
bool is_block(const std::array<WidePlane, 6>& planes, const std::array<WidePlane, 6>& before) {
  const auto row = [](const WidePlane& p) { return Vector{p.n[0], p.n[1], p.n[2]}; };
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const std::array<std::size_t, 3> at{i ^ 1, (i / 2 + 1) % 3 * 2 + corner % 2, (i / 2 + 2) % 3 * 2 + corner / 2};
      const auto rows = [&](const auto& p) { return Matrix{row(p[at[0]]), row(p[at[1]]), row(p[at[2]])}; };
      const Matrix m = rows(planes);
      if (sign_of(determinant(m)) != sign_of(determinant(rows(before))) || determinant(m) == 0) return false;
      if (value(planes[i], inverse({m, {0, 0, 0}})({-planes[at[0]].d, -planes[at[1]].d, -planes[at[2]].d})) >= 0)
        return false;
    }
  return true;
}

// Example E09.

TEST(ReconstructTest, TheTurnedBox) {
  const Shape box = shape(block({3, 2, 1}));
  const Placement placement = placed(box, realize(Motion::turn(quaternion(2, 0, 0, 1))).map);
  for (const Method method : {Method::best, Method::naive, Method::continued_fraction, Method::lattice}) {
    const Reconstruction all = made(std::vector{placement}, {method});
    EXPECT_EQ(all.planes, 6u);
    EXPECT_EQ(all.exact_planes, 6u);
    EXPECT_EQ(all.face_local_planes, 0u);
    const Reconstructed& r = all.primitives[0];
    EXPECT_TRUE(r.by_planes);
    EXPECT_EQ(r.displacement, 0);
    EXPECT_EQ(r.plane, std::nullopt);
    EXPECT_EQ(r.merged_points + r.zero_area_triangles + r.resolved_crossings, 0u);
    const Canonical form = booleans::canonical(r.body);
    std::set<WidePlane> planes;
    for (const exact::Plane& p : form.planes) planes.insert(wide(p));
    const std::set<WidePlane> expected{{{-3, -4, 0}, 0},  {{3, 4, 0}, -15}, {{4, -3, 0}, 0},
                                       {{-4, 3, 0}, -10}, {{0, 0, -1}, 0},  {{0, 0, 1}, -1}};
    EXPECT_EQ(planes, expected);
    EXPECT_EQ(conditions(form).all, 24u);
    EXPECT_EQ(conditions(form).hold, 24u);
    EXPECT_EQ(booleans::volume(r.body), 6);
    EXPECT_EQ(squared_movement(placement, form), 0);
    expect_clean(r.body);
  }
}

TEST(ReconstructTest, TheThinBox) {
  const Shape plate = shape(block({3, 3, Rational(1, 100)}));
  const Motion motion = Motion::turn(quaternion(3, 0, 0, 1)).then(Motion::turn(quaternion(5, 2, 0, 0)));
  const Reconstructed r = made(placed(plate, realize(motion).map));
  EXPECT_EQ(r.displacement, 0);
  const Canonical form = booleans::canonical(r.body);
  EXPECT_EQ(conditions(form).hold, 24u);
  EXPECT_EQ(booleans::volume(r.body), Rational(9, 100));
  expect_clean(r.body);
}

// Of plates ever thinner those that a rounding keeps come out, the others are refused.
TEST(ReconstructTest, PlatesAreKeptOrRefused) {
  std::mt19937_64 random = generator(641);
  int kept = 0, refused = 0, mended = 0;
  for (int i = 0; i < 70; ++i) {
    const unsigned thinness = 35 + static_cast<unsigned>(below(random, 70));
    const Rational size = power_of_2(4 + static_cast<unsigned>(below(random, 17)));
    const Shape plate = shape(block({size, size, 1}));
    // Flattened by to_grid itself, then turned.
    const AffineMap flat{{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, Rational(1, power_of_2(thinness))}},
                         {0, 0, 0}};
    const Placement placement = placed(plate, composed(flat, random_motion(random)));
    std::array<WidePlane, 6> before, after;
    for (std::size_t f = 0; f < 6; ++f) {
      // Opposite pairs: bottom and top come first, then the sides around.
      const std::size_t at = std::array{0, 1, 2, 4, 3, 5}[f];
      before[f] = moved(plate.polyhedron.planes[at], inverse(placement.to_grid));
      after[f] = wide(*PlaneRounder().round(before[f], Method::best));
    }
    const auto r = reconstruct(std::vector{placement});
    if (r) {
      ++kept;
      const Canonical form = booleans::canonical(r.value().primitives[0].body);
      ASSERT_EQ(form.face_count(), 6u);
      ASSERT_EQ(conditions(form).all, 24u);
      ASSERT_EQ(conditions(form).hold, 24u) << thinness;
      ASSERT_GE(r.value().primitives[0].displacement * r.value().primitives[0].displacement,
                squared_movement(placement, form));
      // Planes rounded a second time are those that had to be.
      ASSERT_EQ(r.value().face_local_planes == 0, is_block(after, before)) << thinness;
      mended += r.value().face_local_planes > 0 ? 1 : 0;
      continue;
    }
    ++refused;
    ASSERT_EQ(r.error().code, "inconsistent-motion");
    ASSERT_FALSE(is_block(after, before));
    for (const char* part : {"primitive 0", "vertex ", "face "})
      ASSERT_NE(r.error().where.find(part), std::string::npos) << r.error().where;
  }
  EXPECT_GT(kept, 15);
  EXPECT_GT(refused, 10);
  EXPECT_GT(mended, 0);
  std::printf("kept %d (face_local %d), refused %d\n", kept, mended, refused);
}

TEST(ReconstructTest, TheVertexAndTheFaceOfARefusal) {
  const Shape plate = shape(block({1024, 1024, Rational(1, power_of_2(200))}));
  const Shape other = shape(block({1, 1, 1}));
  std::mt19937_64 random = generator(642);
  const AffineMap map = random_motion(random);
  const auto r = reconstruct(std::vector{placed(other), placed(plate, map)});
  ASSERT_FALSE(r.has_value());
  EXPECT_EQ(r.error().code, "inconsistent-motion");
  EXPECT_EQ(r.error().where.find("primitive 1, vertex "), 0u) << r.error().where;
  EXPECT_NE(r.error().where.find(", face "), std::string::npos) << r.error().where;
}

// Simple convex shapes under motions.

std::vector<Shape> convex_ones(const Rational& size) {
  std::vector<Shape> all;
  all.push_back(shape(convex_hull(std::vector<Vector>{{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {1, 2, size}})));
  all.push_back(shape(frustum(3, size, size, size, Fit::inscribed)));
  all.push_back(shape(wedge({size, size, size / 3}, size / 5)));
  all.push_back(shape(block({size, size / 2, size / 3})));
  all.push_back(shape(frustum(8, size, size, size, Fit::circumscribed)));
  all.push_back(shape(frustum(8, size, size / 3, size, Fit::equal_area)));
  all.push_back(shape(frustum(17, size / 2, size, size / 7, Fit::inscribed)));
  return all;
}

TEST(ReconstructTest, ConditionsOfSimpleConvexShapes) {
  std::mt19937_64 random = generator(643);
  const std::vector<Shape> shapes = convex_ones(power_of_2(20));
  for (int i = 0; i < 28; ++i) {
    const Shape& s = shapes[static_cast<std::size_t>(i) % shapes.size()];
    const Placement placement = placed(s, random_motion(random));
    const Reconstructed r = made(placement);
    const std::size_t F = s.polyhedron.face_count();
    const Canonical form = booleans::canonical(r.body);
    // Incidences are kept.
    ASSERT_EQ(form.face_count(), F);
    ASSERT_EQ(form.vertices.size(), s.polyhedron.points.size());
    ASSERT_EQ(booleans::edge_count(form), s.polyhedron.corners.size() / 2);
    const Conditions c = conditions(form);
    ASSERT_EQ(c.all, 2 * (F - 2) * (F - 3));
    ASSERT_EQ(c.hold, c.all);
    ASSERT_TRUE(r.by_planes);
    // The certificate.
    const Rational squared = squared_movement(placement, form);
    ASSERT_GE(r.displacement * r.displacement, squared);
    ASSERT_LE(r.displacement * r.displacement, squared * (1 + Rational(1, power_of_2(50))));
    ASSERT_LT(r.displacement, Rational(1, power_of_2(40)));
    ASSERT_GT(r.displacement, 0);
    expect_clean(r.body);
  }
  std::vector<std::size_t> counts;
  for (const Shape& s : shapes) {
    const auto form = booleans::canonical(made(placed(s)).body);
    counts.push_back(conditions(form).all);
  }
  EXPECT_EQ(counts, (std::vector<std::size_t>{4, 12, 12, 24, 112, 112, 2 * 17 * 16}));
}

TEST(ReconstructTest, ShapesThatAreNotConvex) {
  std::mt19937_64 random = generator(644);
  const Shape ring = shape(extrusion({{{{0, 0}, {900, 10}, {800, 700}, {300, 200}, {20, 900}},
                                       {{200, 100}, {400, 100}, {300, 150}},
                                       {{500, 100}, {600, 100}, {600, 200}, {500, 200}}}},
                                     {100, -50, 333}));
  const Rational before = sixfold_volume(ring.polyhedron) / 6;
  for (int i = 0; i < 10; ++i) {
    const Placement placement = placed(ring, random_motion(random));
    const Reconstructed r = made(placement);
    const Canonical form = booleans::canonical(r.body);
    EXPECT_TRUE(r.by_planes);
    EXPECT_EQ(form.face_count(), ring.polyhedron.face_count());
    EXPECT_EQ(form.vertices.size(), ring.polyhedron.points.size());
    EXPECT_EQ(form.loop_corners.size(), ring.polyhedron.loop_corners.size());
    EXPECT_EQ(form.corners.size(), ring.polyhedron.corners.size());
    EXPECT_GE(r.displacement * r.displacement, squared_movement(placement, form));
    EXPECT_LT(r.displacement, Rational(1, power_of_2(40)));
    EXPECT_LT(magnitude(booleans::volume(r.body) - before), Rational(1, 1000));
    expect_clean(r.body);
  }
}

// Two cubes that touch in a vertex do so after any motion.
TEST(ReconstructTest, TouchingCubes) {
  const Body a = booleans::box_body({{0, 0, 0}}, {{100, 100, 100}}),
             b = booleans::box_body({{100, 100, 100}}, {{150, 170, 190}});
  const std::array operands{&a, &b};
  const auto both = booleans::evaluate(operands, booleans::Expression::flat(booleans::Rule::any, 2));
  const Shape s(polyhedron_of(booleans::canonical(both.value())));
  ASSERT_TRUE(s.trihedral.has_value());
  std::mt19937_64 random = generator(645);
  for (int i = 0; i < 10; ++i) {
    const Reconstructed r = made(placed(s, random_motion(random)));
    const Canonical form = booleans::canonical(r.body);
    EXPECT_EQ(form.vertices.size(), 15u);
    EXPECT_EQ(form.face_count(), 12u);
    expect_clean(r.body);
  }
}

// Planes that fall together, that are opposite, that are parallel.

TEST(ReconstructTest, SharedPlanesAreRoundedOnce) {
  std::mt19937_64 random = generator(646);
  const Shape low = shape(block({300, 200, 100})), high = shape(block({300, 200, Rational(50, 3)}));
  for (int i = 0; i < 100; ++i) {
    AffineMap map = random_motion(random);
    if (i % 4 == 1) map = composed(realize(Motion::mirror(random_direction(random, 5))).map, map);
    if (i % 4 == 2) map = scaled(map, Rational(1 + below(random, 100), 17));
    const Reconstruction r = made({placed(low, map), placed(high, composed(shift({0, 0, 100}), map))});
    ASSERT_EQ(r.planes, 7u);
    std::array<Canonical, 2> forms;
    for (std::size_t k = 0; k < 2; ++k) forms[k] = booleans::canonical(r.primitives[k].body);
    // Four sides are common, one is opposite.
    const auto count = [&](bool opposite) {
      int n = 0;
      for (const exact::Plane& p : forms[0].planes)
        n += static_cast<int>(std::count(forms[1].planes.begin(), forms[1].planes.end(), opposite ? p.opposite() : p));
      return n;
    };
    ASSERT_EQ(count(false), 4);
    ASSERT_EQ(count(true), 1);
    const std::array operands{&r.primitives[0].body, &r.primitives[1].body};
    const auto sum = booleans::evaluate(operands, booleans::Expression::flat(booleans::Rule::any, 2));
    ASSERT_TRUE(sum.has_value());
    const Canonical form = booleans::canonical(sum.value());
    ASSERT_EQ(form.face_count(), 6u);
    ASSERT_EQ(form.vertices.size(), 8u);
    ASSERT_EQ(conditions(form).hold, 24u);
    ASSERT_EQ(booleans::volume(sum.value()),
              booleans::volume(r.primitives[0].body) + booleans::volume(r.primitives[1].body));
    const auto common = booleans::evaluate(operands, booleans::Expression::flat(booleans::Rule::all, 2));
    ASSERT_EQ(common.value().face_count(), 0u);
    // Opposite faces are still parallel.
    for (const Canonical& f : forms) {
      int pairs = 0;
      for (const exact::Plane& p : f.planes)
        for (const exact::Plane& q : f.planes) {
          const WidePlane a = wide(p), b = wide(q.opposite());
          pairs += squared_sine(a.n, b.n) == 0 && a.n[0] * b.n[0] + a.n[1] * b.n[1] + a.n[2] * b.n[2] > 0 ? 1 : 0;
        }
      ASSERT_EQ(pairs, 6);
    }
  }
}

TEST(ReconstructTest, HalfSpaces) {
  std::mt19937_64 random = generator(647);
  const Shape box = shape(block({300, 200, 100}));
  for (int i = 0; i < 20; ++i) {
    const AffineMap map = random_motion(random);
    // On the box's plane x = 300, from either side, and one of its own.
    Placement cut{nullptr, WidePlane{{1, 0, 0}, -300}, map}, rest{nullptr, WidePlane{{-1, 0, 0}, 300}, map},
        own{nullptr, WidePlane{{3, -1, 7}, 5}, map};
    const Reconstruction r = made({cut, placed(box, map), rest, own});
    EXPECT_EQ(r.planes, 7u);
    ASSERT_TRUE(r.primitives[0].plane && r.primitives[2].plane && r.primitives[3].plane);
    EXPECT_EQ(*r.primitives[0].plane, r.primitives[2].plane->opposite());
    const Canonical form = booleans::canonical(r.primitives[1].body);
    EXPECT_EQ(std::count(form.planes.begin(), form.planes.end(), *r.primitives[0].plane), 1);
    for (const auto& [k, p] : {std::pair(0, cut), {3, own}}) {
      const Reconstructed& got = r.primitives[static_cast<std::size_t>(k)];
      EXPECT_EQ(*got.plane, PlaneRounder().round(moved(*p.half_space, inverse(map)), Method::best));
      EXPECT_EQ(got.body.face_count(), 0u);
      EXPECT_EQ(got.displacement, 0);
      EXPECT_TRUE(got.by_planes);
    }
  }
  // One that fits stays.
  EXPECT_EQ(made({nullptr, WidePlane{{1, 2, 3}, -4}, {}}).plane, (exact::Plane{{1, 2, 3}, -4}));
}

// Exact motions.

TEST(ReconstructTest, ExactMotions) {
  std::mt19937_64 random = generator(648);
  const Shape shapes[] = {
      shape(block({3, 2, 1})),
      shape(frustum(4, 6, 0, 9, Fit::inscribed)),
      shape(frustum(4, 0, 6, 9, Fit::inscribed)),
      shape(sphere(8, 4)),
      shape(torus(5, 2, 4, 4)),
      shape(wedge({4, 2, 5}, 2)),
      shape(convex_hull(std::vector<Vector>{{0, 0, 0}, {9, 0, 0}, {0, 9, 1}, {1, 2, 9}, {7, 7, 7}}))};
  for (const Shape& s : shapes) {
    const Body still = made(placed(s)).body;
    for (int i = 0; i < 12; ++i) {
      Motion motion;
      for (int k = 0; k < 3; ++k) {
        Vector axis{0, 0, 0};
        axis[below(random, 3)] = 1;
        motion = motion.then(Motion::rotation(axis, 90 * between(random, -1, 2)))
                     .then(Motion::translation({between(random, -99, 99), between(random, -99, 99), 7}));
        if (below(random, 4) == 0) motion = motion.then(Motion::mirror(axis));
      }
      const Placement placement = placed(s, realize(motion).map);
      const Reconstruction all = made(std::vector{placement});
      const Reconstructed& r = all.primitives[0];
      EXPECT_EQ(r.displacement, 0);
      EXPECT_TRUE(r.by_planes);
      EXPECT_EQ(all.exact_planes, all.planes);
      EXPECT_EQ(booleans::volume(r.body), sixfold_volume(s.polyhedron) / 6);
      const Canonical form = booleans::canonical(r.body);
      std::set<Vector> points;
      for (const exact::Point& v : form.vertices) points.insert(vertex(v));
      const auto expected = carried(placement);
      EXPECT_EQ(points, std::set(expected.begin(), expected.end()));
      EXPECT_EQ(form.face_count(), s.polyhedron.face_count());
      expect_clean(r.body);
      // And back again it is what it was.
      const Shape there(polyhedron_of(form));
      EXPECT_TRUE(booleans::canonical(made(placed(there, inverse(placement.to_grid))).body) ==
                  booleans::canonical(still));
    }
  }
}

TEST(ReconstructTest, MirrorImages) {
  std::mt19937_64 random = generator(649);
  std::vector<Shape> shapes = convex_ones(power_of_2(10));
  shapes.push_back(shape(frustum(7, 500, 0, 300, Fit::inscribed)));
  shapes.push_back(shape(sphere(700, 8)));
  shapes.push_back(
      shape(extrusion({{{{0, 0}, {90, 0}, {90, 90}, {0, 90}}, {{30, 30}, {60, 30}, {45, 70}}}}, {9, 9, 99})));
  for (const Shape& s : shapes)
    for (const bool by_vertices : {false, true}) {
      const AffineMap map = random_motion(random);
      const AffineMap mirrored = composed(realize(Motion::mirror(random_direction(random, 9))).map, map);
      ASSERT_LT(determinant(mirrored.linear), 0);
      const Reconstructed r = made(placed(s, mirrored), {Method::best, by_vertices});
      EXPECT_GT(booleans::volume(r.body), 0);
      EXPECT_LT(magnitude(booleans::volume(r.body) / (sixfold_volume(s.polyhedron) / 6) - 1), Rational(1, 50));
      EXPECT_EQ(r.by_planes, s.trihedral && !by_vertices);
      expect_clean(r.body);
    }
}

// Vertex by vertex.

/// sqrt(3) / 2, with what an upper bound by doubles may add.
bool is_a_rounding(const Rational& displacement) {
  return displacement >= 0 && displacement * displacement <= Rational(3, 4) * (1 + Rational(1, power_of_2(16)));
}

TEST(ReconstructTest, VertexByVertex) {
  std::mt19937_64 random = generator(650);
  std::vector<Shape> shapes;
  shapes.push_back(shape(frustum(12, 500, 0, 400, Fit::inscribed)));
  shapes.push_back(shape(frustum(12, 500, 0, 400, Fit::circumscribed)));
  shapes.push_back(shape(sphere(600, 12)));
  shapes.push_back(shape(torus(500, 200, 12, 7)));
  shapes.push_back(shape(block({300, 200, 100})));
  shapes.push_back(
      shape(extrusion({{{{0, 0}, {90, 0}, {90, 90}, {0, 90}}, {{30, 30}, {60, 30}, {45, 70}}}}, {9, 9, 99})));
  for (const Shape& s : shapes)
    for (int i = 0; i < 4; ++i) {
      const Placement placement = placed(s, random_motion(random));
      const Reconstructed r = made(placement, {Method::best, s.trihedral.has_value()});
      EXPECT_FALSE(r.by_planes);
      EXPECT_TRUE(is_a_rounding(r.displacement));
      // Vertices are the nearest grid points.
      std::set<Vector> rounded;
      Rational most = 0;
      for (const Vector& p : carried(placement)) {
        Vector q;
        for (std::size_t k = 0; k < 3; ++k) q[k] = nearest_integer(p[k]);
        most = std::max(most, dot(q - p, q - p));
        rounded.insert(q);
      }
      EXPECT_GE(r.displacement * r.displacement, most);
      EXPECT_LE(r.displacement * r.displacement, most * (1 + Rational(1, power_of_2(20))));
      // Features are large here: nothing is merged and nothing crosses.
      EXPECT_EQ(r.merged_points, 0u);
      EXPECT_EQ(r.zero_area_triangles, 0u);
      EXPECT_EQ(r.resolved_crossings, 0u);
      std::set<Vector> vertices;
      for (const exact::Point& v : booleans::canonical(r.body).vertices) vertices.insert(vertex(v));
      EXPECT_TRUE(std::includes(rounded.begin(), rounded.end(), vertices.begin(), vertices.end()));
      expect_clean(r.body);
    }
}

// What doubles cannot tell: images halfway between grid points, or next to halfway, and images on grid points.
TEST(ReconstructTest, TiesAndExactImagesVertexByVertex) {
  const Shape s = shape(block({1 << 20, 30, 20}));
  const Rational hair(1, power_of_2(90));
  for (const Rational& half : {Rational(1, 2), Rational(1, 2) + hair, Rational(1, 2) - hair}) {
    const Placement placement = placed(s, shift({half, 1 + half, -half}));
    const Reconstructed r = made(placement, {Method::best, true});
    std::set<Vector> expected, vertices;
    for (const Vector& p : carried(placement))
      expected.insert({nearest_integer(p[0]), nearest_integer(p[1]), nearest_integer(p[2])});
    for (const exact::Point& v : booleans::canonical(r.body).vertices) vertices.insert(vertex(v));
    EXPECT_EQ(vertices, expected);
    EXPECT_TRUE(is_a_rounding(r.displacement));
  }
  // By 3, 4, 5: rows that are no integers, images that are.
  const Shape fives = shape(block({500, 1000, 25}));
  const AffineMap turn{matrix(quaternion(2, 0, 0, 1)), {0, 0, 0}};
  ASSERT_NE(denominator(turn.linear[0][0]), 1);
  EXPECT_EQ(made(placed(fives, turn), {Method::best, true}).displacement, 0);
  EXPECT_EQ(made(placed(fives, shift({7, -8, 9})), {Method::best, true}).displacement, 0);
  EXPECT_GT(made(placed(fives, shift({7, hair, 9})), {Method::best, true}).displacement, 0);
}

// Rounding may turn a thin shape inside out: what is left is then empty, as in folds that cross.
TEST(ReconstructTest, ThinShapesVertexByVertex) {
  const Rational z(1, 100);
  const Shape tetrahedron =
      shape(convex_hull(std::vector<Vector>{{0, 0, 40 * z}, {10, 0, 60 * z}, {0, 10, 60 * z}, {3, 3, 51 * z}}));
  const Reconstructed t = made(placed(tetrahedron), {Method::best, true});
  EXPECT_FALSE(t.by_planes);
  EXPECT_EQ(t.body.face_count(), 0u);
  // The way out that "inconsistent-motion" names.
  std::mt19937_64 random = generator(654);
  const Shape plate = shape(block({1 << 10, 1 << 10, Rational(1, power_of_2(90))}));
  for (int i = 0; i < 10; ++i) {
    const Placement placement = placed(plate, random_motion(random));
    const Reconstructed r = made(placement, {Method::best, true});
    EXPECT_FALSE(r.by_planes);
    EXPECT_TRUE(is_a_rounding(r.displacement));
    expect_clean(r.body);
  }
}

// A few grid steps in size: vertices merge, faces cross.
TEST(ReconstructTest, TinyShapesStayClean) {
  std::mt19937_64 random = generator(651);
  const Shape shapes[] = {shape(torus(3, 1, 12, 8)), shape(sphere(2, 12)), shape(frustum(9, 2, 0, 3, Fit::inscribed))};
  std::uint64_t merged = 0, flat = 0, crossings = 0, empty = 0;
  for (int i = 0; i < 90; ++i) {
    const Shape& s = shapes[static_cast<std::size_t>(i) % 3];
    AffineMap map = scaled(random_motion(random), Rational(1 + below(random, 40), 20));
    if (i % 5 == 0)
      map = composed({{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, Rational(1, 40)}}, {0, 0, 0}},
                     scaled(random_motion(random), 3));
    const Reconstructed r = made(placed(s, map));
    EXPECT_FALSE(r.by_planes);
    EXPECT_TRUE(is_a_rounding(r.displacement));
    expect_clean(r.body);
    EXPECT_GE(booleans::volume(r.body), 0);
    EXPECT_EQ(booleans::volume(r.body) > 0, r.body.face_count() > 0);
    merged += r.merged_points;
    flat += r.zero_area_triangles;
    crossings += r.resolved_crossings;
    empty += r.body.face_count() == 0 ? 1 : 0;
  }
  EXPECT_GT(merged, 0u);
  EXPECT_GT(flat, 0u);
  EXPECT_GT(crossings, 0u);
  // All in one point.
  const Reconstructed r = made(placed(shapes[0], scaled(AffineMap{}, Rational(1, 100))));
  EXPECT_EQ(r.body.face_count(), 0u);
  EXPECT_GT(r.merged_points, 0u);
  std::printf("merged %llu, without area %llu, crossings %llu, empty %llu\n", static_cast<unsigned long long>(merged),
              static_cast<unsigned long long>(flat), static_cast<unsigned long long>(crossings),
              static_cast<unsigned long long>(empty));
}

// Refusals.

/// The factor that an error names, and that it is what is needed.
void expect_factor(const std::vector<Placement>& placements, const std::string& where,
                   const ReconstructionOptions& options = {}) {
  const auto r = reconstruct(placements, options);
  ASSERT_FALSE(r.has_value());
  ASSERT_EQ(r.error().code, "out-of-range");
  EXPECT_EQ(r.error().where, where);
  const std::string lead = "a step ";
  const auto at = r.error().message.rfind(lead);
  ASSERT_NE(at, std::string::npos) << r.error().message;
  const std::string digits = r.error().message.substr(at + lead.size());
  const Integer factor(digits.substr(0, digits.find(' ')));
  ASSERT_GT(factor, 1);
  std::vector<Placement> coarser = placements;
  for (Placement& p : coarser) p.to_grid = scaled(p.to_grid, Rational(1, factor));
  const auto again = reconstruct(coarser, options);
  EXPECT_TRUE(again.has_value()) << factor << ": " << again.error().message;
  // Half of it would not do.
  for (Placement& p : coarser) p.to_grid = scaled(p.to_grid, 2);
  EXPECT_FALSE(reconstruct(coarser, options).has_value()) << factor;
}

TEST(ReconstructTest, OutOfRange) {
  std::mt19937_64 random = generator(652);
  const Shape box = shape(block({300, 200, 100})), ball = shape(sphere(600, 8));
  for (const Rational& far :
       {Rational(exact::world + 4'000'000), Rational(power_of_2(31) + 5), Rational(power_of_2(40) * 3)}) {
    for (int i = 0; i < 4; ++i) {
      AffineMap map = i == 0 ? AffineMap{} : random_motion(random);
      map.shift =
          map.shift + Vector{i % 2 == 0 ? far : Rational(0), i % 2 == 0 ? Rational(0) : Rational(-2 * far), far};
      expect_factor({placed(box, map)}, "primitive 0");
      expect_factor({placed(box, map)}, "primitive 0", {Method::best, true});
      expect_factor({placed(box), placed(ball, map)}, "primitive 1");
    }
  }
}

// Where vertices need different factors the largest is named.
TEST(ReconstructTest, OutOfRangeOfLongShapes) {
  const Shape beam = shape(block({Rational(power_of_2(32)), 8, 8}));
  // Its first vertex is just outside, its last far out.
  const AffineMap map = shift({exact::world + 10, 0, 0});
  expect_factor({placed(beam, map)}, "primitive 0");
  expect_factor({placed(beam, map)}, "primitive 0", {Method::best, true});
  // With long numbers, too.
  expect_factor({placed(beam, composed(shift({exact::world * 2, 0, 0}),
                                       {matrix(quaternion(3, 1, 0, 0)), {Rational(1, 3), 0, 0}}))},
                "primitive 0");
}

// So far away that no plane fits.
TEST(ReconstructTest, OutOfRangeOfPlanes) {
  std::mt19937_64 random = generator(653);
  const Shape box = shape(block({300, 200, 100}));
  for (const unsigned bits : {124u, 140u, 200u}) {
    AffineMap map = random_motion(random);
    map.shift = {power_of_2(bits), 0, 5};
    const auto r = reconstruct(std::vector{placed(box, map)});
    ASSERT_FALSE(r.has_value());
    EXPECT_EQ(r.error().code, "out-of-range");
    EXPECT_EQ(r.error().where, "primitive 0");
    const Placement half{nullptr, WidePlane{{1, 0, 0}, 0}, map};
    const auto h = reconstruct(std::vector{placed(box), half});
    if (h) continue;
    EXPECT_EQ(h.error().code, "out-of-range");
    EXPECT_EQ(h.error().where, "primitive 1");
  }
}

TEST(ReconstructTest, FacesThatAreNoRegion) {
  // A block one face of which looks inwards.
  Polyhedron p = block({3, 2, 1}).value();
  p.planes[0] = p.planes[0].opposite();
  const Shape turned(p);
  const auto r = reconstruct(std::vector{placed(turned, {matrix(quaternion(7, 3, 1, 2)), {Rational(1, 3), 0, 0}})},
                             {Method::best, true});
  ASSERT_FALSE(r.has_value());
  EXPECT_EQ(r.error().code, "bad-primitive");
  EXPECT_EQ(r.error().where, "primitive 0");
}

TEST(ReconstructTest, Cancelling) {
  const Shape box = shape(block({3, 2, 1})), ball = shape(sphere(600, 8));
  const AffineMap map{matrix(quaternion(7, 3, 1, 2)), {Rational(1, 3), 0, 0}};
  std::atomic<bool> cancel = true;
  ReconstructionOptions options;
  options.cancel = &cancel;
  for (const Shape* s : {&box, &ball})
    for (const bool by_vertices : {false, true}) {
      options.by_vertices = by_vertices;
      const auto r = reconstruct(std::vector{placed(*s, map)}, options);
      ASSERT_FALSE(r.has_value());
      EXPECT_EQ(r.error().code, "cancelled");
      cancel = false;
      EXPECT_TRUE(reconstruct(std::vector{placed(*s, map)}, options).has_value());
      cancel = true;
    }
}

TEST(ReconstructTest, NothingIsNothing) {
  const auto r = reconstruct({});
  ASSERT_TRUE(r.has_value());
  EXPECT_EQ(r.value().primitives.size(), 0u);
  EXPECT_EQ(r.value().planes, 0u);
}

TEST(ReconstructTest, TheReachOfAShape) {
  const Shape box = shape(block({3, 4, 12}));
  EXPECT_GE(box.reach, 13);
  EXPECT_LE(box.reach, 13 + Rational(1, power_of_2(35)));
  EXPECT_TRUE(box.trihedral.has_value());
  EXPECT_FALSE(shape(sphere(1, 4)).trihedral.has_value());
}

}  // namespace
}  // namespace quoin::rounding::testing
