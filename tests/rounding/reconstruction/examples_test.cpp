// Worked examples of C. M. Hoffmann, Geometric and Solid Modeling (1989), chapters 4 and 5.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <vector>

#include "booleans/body/canonical.h"
#include "booleans/body/fault.h"
#include "booleans/body/measure.h"
#include "booleans/embedding.h"
#include "booleans/parts.h"
#include "rounding/motions/realize.h"
#include "rounding/reconstruction/reconstruct.h"
#include "rounding/shapes/primitives.h"
#include "tests/rounding/support.h"

namespace quoin::rounding::testing {
namespace {

// The pentagon of 4.2.4: drawing the star inside it and the star around it are inverse to each other.

template <class Number>
using Pentagon = std::array<std::array<Number, 2>, 5>;
template <class Number>
using Line = std::array<Number, 3>;

template <class Number>
Line<Number> line(const std::array<Number, 2>& p, const std::array<Number, 2>& q) {
  const Number a = q[1] - p[1], b = p[0] - q[0];
  return {a, b, -(a * p[0] + b * p[1])};
}
template <class Number>
std::array<Number, 2> meeting(const Line<Number>& p, const Line<Number>& q) {
  const Number d = p[0] * q[1] - q[0] * p[1];
  return {(p[1] * q[2] - q[1] * p[2]) / d, (p[2] * q[0] - q[2] * p[0]) / d};
}
/// Corner i of `in` lies on the diagonals i, i + 2 and i + 1, i + 3; of `out` on the sides i and i + 2.
template <class Number>
Pentagon<Number> in(const Pentagon<Number>& v) {
  Pentagon<Number> r;
  for (std::size_t i = 0; i < 5; ++i) r[i] = meeting(line(v[i], v[(i + 2) % 5]), line(v[(i + 1) % 5], v[(i + 3) % 5]));
  return r;
}
template <class Number>
Pentagon<Number> out(const Pentagon<Number>& v) {
  Pentagon<Number> r;
  for (std::size_t i = 0; i < 5; ++i) r[i] = meeting(line(v[i], v[(i + 1) % 5]), line(v[(i + 2) % 5], v[(i + 3) % 5]));
  return r;
}
template <class Number>
Pentagon<Number> pentagon(const Number& p) {
  return {{{0, 0}, {1, 0}, {1 + p, 1}, {1, 1 + p}, {0, 1}}};
}
/// `steps` times in, then out, or first out; corner i comes back as corner i + 2 after each pair.
template <class Number>
Number error(const Number& p, int steps, bool in_first) {
  const Pentagon<Number> before = pentagon(p);
  Pentagon<Number> v = before;
  for (int k = 0; k < 2 * steps; ++k) v = (k < steps) == in_first ? in(v) : out(v);
  Number most = 0;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      const Number e = v[i][k] - before[(i + 3 * static_cast<std::size_t>(steps)) % 5][k];
      most = std::max(most, Number(e < 0 ? -e : e));
    }
  return most;
}

/// Table 4.1 in doubles; its last two numbers as they are, not as printed. Columns: in^2 then out^2, in^3 then out^3,
/// out^2 then in^2, out^3 then in^3.
struct Row {
  int digits;
  std::array<double, 4> error;
};
constexpr Row table[] = {
    {1, {9.0e-14, 2.0e-12, 1.5e-14, 1.4e-13}}, {2, {7.9e-12, 2.0e-9, 5.9e-13, 6.8e-11}},
    {3, {5.0e-10, 1.8e-6, 5.2e-8, 8.8e-8}},    {4, {5.0e-8, 1.5e-3, 5.0e-5, 1.5e-4}},
    {5, {4.4e-7, 7.2e-1, 1.2e-1, 2.1e-1}},     {6, {1.8e-4, 7.2e-1, 1.2e+1, 5.4e+1}},
};

TEST(RoundingExamplesTest, PentagonInRationals) {
  for (const Row& row : table) {
    Rational p = 1;
    for (int i = 0; i < row.digits; ++i) p /= 10;
    for (const int steps : {1, 2, 3})
      for (const bool in_first : {true, false}) EXPECT_EQ(error(p, steps, in_first), 0);
  }
  const Pentagon<Rational> expected{{{1, Rational(10, 11)},
                                     {1, 1},
                                     {Rational(10, 11), 1},
                                     {Rational(10, 21), Rational(11, 21)},
                                     {Rational(11, 21), Rational(10, 21)}}};
  const Pentagon<Rational> inner = in(pentagon(Rational(1, 10)));
  EXPECT_EQ(std::set(inner.begin(), inner.end()), std::set(expected.begin(), expected.end()));
}

TEST(RoundingExamplesTest, PentagonInDoubles) {
  for (const Row& row : table) {
    const double p = std::strtod(("1e-" + std::to_string(row.digits)).c_str(), nullptr);
    for (std::size_t k = 0; k < 4; ++k) {
      const double e = error(p, k % 2 == 0 ? 2 : 3, k < 2);
      EXPECT_LE(e, 30 * row.error[k]) << p << ' ' << k;
      EXPECT_GE(e, row.error[k] / 30) << p << ' ' << k;
    }
  }
}

TEST(RoundingExamplesTest, PentagonNumbersGrow) {
  Pentagon<Rational> v = pentagon(Rational(1, 1000));
  std::vector<std::size_t> bits;
  for (int step = 0; step < 4; ++step) {
    v = in(v);
    std::size_t most = 0;
    for (const auto& corner : v)
      for (const Rational& x : corner)
        for (const Integer& n : {Integer(abs(numerator(x))), Integer(denominator(x))})
          most = std::max(most, n == 0 ? std::size_t{0} : std::size_t{msb(n)} + 1);
    bits.push_back(most);
  }
  EXPECT_EQ(bits, (std::vector<std::size_t>{11, 22, 41, 54}));
}

// The projective map of four points, 5.5.5.

/// The matrix that carries (1,0,0), (0,1,0), (0,0,1) and (1,1,1) to multiples of four vectors, no three in a plane.
Matrix frame(const std::array<Vector, 4>& p) {
  const Matrix columns{Vector{p[0][0], p[1][0], p[2][0]}, Vector{p[0][1], p[1][1], p[2][1]},
                       Vector{p[0][2], p[1][2], p[2][2]}};
  const Vector weights = inverse({columns, {0, 0, 0}})(p[3]);
  Matrix m = columns;
  for (Vector& row : m)
    for (std::size_t k = 0; k < 3; ++k) row[k] *= weights[k];
  return m;
}
AffineMap linear(const Matrix& m) { return {m, {0, 0, 0}}; }
Matrix projective_map(const std::array<Vector, 4>& from, const std::array<Vector, 4>& to) {
  return composed(inverse(linear(frame(from))), linear(frame(to))).linear;
}
/// The same point of the projective plane.
bool same(const Vector& a, const Vector& b) {
  return a != Vector{0, 0, 0} && b != Vector{0, 0, 0} && a[0] * b[1] == a[1] * b[0] && a[1] * b[2] == a[2] * b[1] &&
         a[2] * b[0] == a[0] * b[2];
}

TEST(RoundingExamplesTest, ProjectiveMapOfFourPoints) {
  // The matrix carries the second corner from (0, 1), not from (1, 0) as the text has it.
  const Matrix printed{Vector{4, 5, 0}, Vector{-5, 14, 6}, Vector{-2, 2, 3}};
  const std::array<Vector, 4> square{Vector{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}};
  const std::array<Vector, 4> corners{Vector{0, 2, 1}, {1, 4, 1}, {3, 5, 1}, {4, 1, 1}};
  const std::array<Vector, 4> images{Vector{0, 6, 3}, {5, 20, 5}, {9, 15, 3}, {4, 1, 1}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(linear(printed)(square[i]), images[i]);
    EXPECT_TRUE(same(images[i], corners[i]));
  }
  EXPECT_FALSE(same(linear(printed)(square[3]), corners[1]));
  const Matrix found = projective_map(square, corners);
  const Rational factor = printed[0][0] / found[0][0];
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(factor * found[i], printed[i]);
  // Any four points to any four others, exactly.
  std::mt19937_64 random = generator(681);
  int count = 0;
  for (int i = 0; i < 100; ++i) {
    std::array<std::array<Vector, 4>, 2> p;
    bool general = true;
    for (auto& four : p) {
      for (Vector& v : four) v = {random_rational(random), random_rational(random), 1};
      for (std::size_t k = 0; k < 4; ++k)
        general = general && determinant({four[k], four[(k + 1) % 4], four[(k + 2) % 4]}) != 0;
    }
    if (!general) continue;
    ++count;
    const Matrix m = projective_map(p[0], p[1]);
    ASSERT_NE(determinant(m), 0);
    for (std::size_t k = 0; k < 4; ++k) ASSERT_TRUE(same(linear(m)(p[0][k]), p[1][k]));
  }
  EXPECT_GT(count, 50);
}

// Two lines that are nearly parallel, 4.2.3: an error of p in their coefficients moves their meeting by 2 p / q.
TEST(RoundingExamplesTest, NearlyParallelLines) {
  const exact::Plane ground{{0, 0, 1}, 0};
  const auto meeting_of = [&](const Rational& p, const Rational& q) {
    const auto upright = [](const Rational& a, const Rational& b, const Rational& c) {
      return *PlaneRounder().round(wide_plane({a, b, 0}, c), Method::best);
    };
    const auto point = exact::meet(upright(-(1 + p), 1 - p, 0), upright(-(1 + q - p), 1 - q + p, 2 * q), ground);
    EXPECT_TRUE(point.has_value());
    return std::array{exact::coordinate(*point, 0), exact::coordinate(*point, 1)};
  };
  const auto in_doubles = [](double p, double q) {
    const double a = -(1 + p), b = 1 - p, c = -(1 + q - p), d = 1 - q + p, e = 2 * q;
    const double determinant = a * d - c * b;
    return std::array{b * e / determinant, -(a * e) / determinant};
  };
  const Rational q(1, power_of_2(18));
  EXPECT_EQ(meeting_of(0, q), (std::array<Rational, 2>{1, 1}));
  for (const unsigned bits : {30u, 40u, 53u, 54u}) {
    const Rational p(1, power_of_2(bits)), gain = 1 - 2 * p / q;
    EXPECT_EQ(meeting_of(p, q), (std::array<Rational, 2>{(1 - p) / gain, (1 + p) / gain})) << bits;
  }
  const Rational moved = meeting_of(Rational(1, power_of_2(53)), q)[0] - 1;
  EXPECT_EQ(std::round(exact::to_double(moved) * 1e15), 58208);
  const Rational half = meeting_of(Rational(1, power_of_2(54)), q)[0] - 1;
  EXPECT_EQ(std::round(exact::to_double(half) * 1e15), 29104);
  // Doubles know the order of magnitude, then nothing.
  const double rough = in_doubles(0x1p-53, 0x1p-18)[0] - 1;
  EXPECT_GT(rough, 1e-11);
  EXPECT_LT(rough, 2e-10);
  EXPECT_EQ(in_doubles(0x1p-54, 0x1p-18)[0], 1);
}

// The union of 150 triangles, Figures 4.8 to 4.11: narrow cracks everywhere. Rounded as a whole it would cross itself;
// it is made anew from its triangles, each rounded by its planes.

/// One corner close to the centre, two on a circle of radius 10^4.
std::vector<Shape> random_prisms(std::mt19937_64& random, int count) {
  std::vector<Shape> prisms;
  while (static_cast<int>(prisms.size()) < count) {
    std::vector<PlanePoint> triangle;
    for (const int radius : {1, 10'000, 10'000}) {
      const PlanePoint p = circle_point(Rational(below(random, 360'000'000), 1'000'000), 1 << 10);
      triangle.push_back({radius * p[0], radius * p[1]});
    }
    // Some have two corners in one place.
    if (auto prism = extrusion({{triangle}}, {0, 0, 10'000})) prisms.emplace_back(std::move(prism).value());
  }
  return prisms;
}

TEST(RoundingExamplesTest, UnionOfManyTriangles) {
  const char* text = std::getenv("QUOIN_CASES");
  const int cases = text != nullptr ? std::atoi(text) : 2;
  std::mt19937_64 random = generator(682);
  for (int i = 0; i < cases; ++i) {
    const std::vector<Shape> prisms = random_prisms(random, 150);
    const Vector axis = random_direction(random, 9);
    const Rational degrees = Rational(below(random, 360'000), 1000);
    const AffineMap map = realize(Motion::rotation(axis, degrees)).map;
    std::vector<Placement> placements;
    for (const Shape& s : prisms) placements.push_back({&s, {}, map});
    const auto moved = reconstruct(placements);
    ASSERT_TRUE(moved.has_value()) << moved.error().message << degrees;
    // Top and bottom are common.
    EXPECT_LE(moved.value().planes, 452u);
    EXPECT_GT(moved.value().planes, 440u);
    std::vector<const booleans::Body*> operands;
    std::set<std::array<Integer, 4>> planes;
    const auto key = [](const exact::Plane& p) {
      return std::array<Integer, 4>{p.n[0], p.n[1], p.n[2], exact::to_integer(p.d)};
    };
    Rational largest = 0;
    for (const Reconstructed& r : moved.value().primitives) {
      EXPECT_TRUE(r.by_planes);
      EXPECT_LT(r.displacement, Rational(1, power_of_2(30)));
      operands.push_back(&r.body);
      for (const exact::Plane& p : booleans::canonical(r.body).planes) planes.insert(key(p));
      largest = std::max(largest, booleans::volume(r.body));
    }
    EXPECT_LE(planes.size(), 452u);
    const auto expression = booleans::Expression::flat(booleans::Rule::any, 150);
    const auto sum = booleans::evaluate_in_parts(operands, expression);
    ASSERT_TRUE(sum.has_value()) << sum.error().message << degrees;
    const booleans::Canonical form = booleans::canonical(sum.value());
    for (const exact::Plane& p : form.planes) ASSERT_EQ(planes.count(key(p)), 1u);
    EXPECT_EQ(booleans::fault(sum.value()), std::nullopt);
    EXPECT_EQ(booleans::embedding_fault(booleans::body_of(form)), std::nullopt);
    // More than the largest, less than the cylinder's box.
    const Rational volume = booleans::volume(sum.value());
    EXPECT_GT(volume, largest);
    EXPECT_LT(volume, Rational(4) * 10'000 * 10'000 * 10'000);
    // The order decides nothing.
    std::reverse(operands.begin(), operands.end());
    const auto again = booleans::evaluate_in_parts(operands, expression);
    ASSERT_TRUE(again.has_value());
    EXPECT_TRUE(booleans::canonical(again.value()) == form);
    std::printf("%s degrees: %zu faces, %zu vertices\n", exact::to_string(degrees).c_str(), form.face_count(),
                form.vertices.size());
  }
}

/// A trihedral shape with its planes rounded to few bits, and how many of the conditions C1 and C2 that breaks.
struct Rounded {
  booleans::Boundary boundary;  // if none is broken
  int broken = 0;
};
Rounded rounded(const Shape& shape, const AffineMap& map, const PlaneRounder& rounder) {
  const Polyhedron& p = shape.polyhedron;
  const IntegerMap back(inverse(map));
  Rounded r;
  for (const WidePlane& before : p.planes)
    r.boundary.planes.push_back(*rounder.round(moved(before, back), Method::naive));
  std::vector<std::optional<exact::Point>> points;
  for (std::size_t v = 0; v < p.points.size(); ++v) {
    const auto& [f, g, h] = shape.trihedral->faces[v];
    const exact::Plane &a = r.boundary.planes[f], &b = r.boundary.planes[g], &c = r.boundary.planes[h];
    points.push_back(exact::meet(a, b, c));
    r.broken += exact::turn(a, b, c) != shape.trihedral->sign[v];
  }
  for (const auto& order : shape.trihedral->orders)
    r.broken += points[order.from] && exact::side(r.boundary.planes[order.face], *points[order.from]) != order.side;
  if (r.broken > 0) return r;
  for (const auto& point : points) r.boundary.vertices.push_back(*point);
  r.boundary.faces.face_start = p.faces.face_start;
  r.boundary.faces.loop_start = p.faces.loop_start;
  r.boundary.faces.corners = p.faces.corners;
  return r;
}

booleans::Body united(const std::vector<booleans::Body>& bodies) {
  std::vector<const booleans::Body*> operands;
  for (const booleans::Body& body : bodies) operands.push_back(&body);
  const auto count = static_cast<std::uint32_t>(bodies.size());
  auto sum = booleans::evaluate_in_parts(operands, booleans::Expression::flat(booleans::Rule::any, count));
  EXPECT_TRUE(sum.has_value());
  return std::move(sum).value();
}

// Figure 4.11. The union has narrow cracks whose sides are nearly parallel: where its own planes are rounded to few
// bits their corners change places, while the triangles it comes from keep their shape. Rounding its corners is no
// better.
TEST(RoundingExamplesTest, UnionOfManyTrianglesRoundedAsAWhole) {
  std::mt19937_64 random = generator(683);
  int shown = 0;
  for (int i = 0; i < 4; ++i) {
    const std::vector<Shape> prisms = random_prisms(random, 150);
    const AffineMap map =
        realize(Motion::rotation(random_direction(random, 9), Rational(below(random, 360'000), 1000))).map;
    std::vector<booleans::Body> still;
    std::vector<Placement> placements;
    for (const Shape& s : prisms) placements.push_back({&s, {}, {}});
    auto standing = reconstruct(placements);
    ASSERT_TRUE(standing.has_value());
    for (Reconstructed& r : standing.value().primitives) still.push_back(std::move(r.body));
    const Shape whole(polyhedron_of(booleans::canonical(united(still))));

    const Placement placement{&whole, {}, map};
    ReconstructionOptions options;
    options.by_vertices = true;
    const auto by_vertices = reconstruct({&placement, 1}, options);
    ASSERT_TRUE(by_vertices.has_value());
    EXPECT_GT(by_vertices.value().primitives[0].resolved_crossings, 0u);

    // Three sides may meet in a corner by chance.
    if (!whole.trihedral) continue;
    for (const unsigned bits : {8u, 10u, 12u}) {
      const PlaneRounder rounder(power_of_2(bits), power_of_2(bits + 16));
      std::vector<booleans::Body> turned;
      for (const Shape& s : prisms)
        if (const Rounded r = rounded(s, map, rounder); r.broken == 0) turned.push_back(booleans::body_of(r.boundary));
      const int broken = rounded(whole, map, rounder).broken;
      std::printf("%u bits: %d conditions of the union, %zu of 150 triangles broken\n", bits, broken,
                  prisms.size() - turned.size());
      EXPECT_GT(broken, 0);
      if (turned.size() < prisms.size()) continue;
      ++shown;
      for (const booleans::Body& body : turned) EXPECT_EQ(booleans::embedding_fault(body), std::nullopt);
      const booleans::Body sum = united(turned);
      EXPECT_EQ(booleans::fault(sum), std::nullopt);
      EXPECT_EQ(booleans::embedding_fault(booleans::body_of(booleans::canonical(sum))), std::nullopt);
    }
  }
  EXPECT_GT(shown, 0);
}

}  // namespace
}  // namespace quoin::rounding::testing
