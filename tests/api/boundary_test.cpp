#include "quoin/boundary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "api/access.h"
#include "booleans/body/locate.h"
#include "tests/api/solids.h"
#include "tests/booleans/lattice_sets.h"

namespace quoin::api_test {
namespace {

using exact::Rational;
using V3 = std::array<Rational, 3>;
using W3 = std::array<double, 3>;

Rational number(const std::string& text) { return *exact::parse_rational(text); }

V3 place(const Boundary& b, std::uint32_t v) {
  const auto text = b.coordinates(v);
  return {number(text[0]), number(text[1]), number(text[2])};
}

W3 cross(const W3& a, const W3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const W3& a, const W3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
W3 unit(const W3& a) {
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}
W3 normal(const Boundary& b, std::uint32_t f) {
  const auto plane = b.plane(f);
  return unit({std::stod(plane[0]), std::stod(plane[1]), std::stod(plane[2])});
}

/// Vertices, edges, faces, loops, shells, genus: the book's V, E, F, L, S, G.
using Euler = std::array<std::int64_t, 6>;
Euler euler(const Solid& solid) {
  const Boundary b = solid.boundary();
  Euler r{b.vertex_count(), b.edge_count(), b.face_count(), b.loop_count(), b.shell_count(), 0};
  for (std::uint32_t s = 0; s < b.shell_count(); ++s) r[5] += b.shell_genus(s);
  return r;
}

/// A prism over a triangle, swept along a vector.
Solid prism(const Corner& a, const Corner& b, const Corner& c, const Corner& along) {
  std::vector<double> points;
  for (const auto& p : {a, b, c}) points.insert(points.end(), p.begin(), p.end());
  for (const auto& p : {a, b, c})
    for (std::size_t k = 0; k < 3; ++k) points.push_back(p[k] + along[k]);
  const std::vector<std::uint32_t> starts{0, 3, 6, 10, 14, 18},
      out{0, 2, 1, 3, 4, 5, 0, 1, 4, 3, 1, 2, 5, 4, 2, 0, 3, 5};
  std::vector<std::uint32_t> in;
  for (std::size_t i = 0; i + 1 < starts.size(); ++i)
    for (std::uint32_t k = starts[i + 1]; k-- > starts[i];) in.push_back(out[k]);
  const auto solid = Solid::from_polygons(points, starts, out, {.grid = Grid()});
  return solid ? solid.value() : Solid::from_polygons(points, starts, in, {.grid = Grid()}).value();
}

/// A random lattice set as a solid.
Solid solid_of(const booleans::testing::LatticeSet& set, std::int64_t scale) {
  return Access::solid(Grid(), booleans::testing::boundary(set, scale));
}

booleans::testing::LatticeSet random_set(std::mt19937_64& random) {
  return booleans::testing::lattice_set([&](std::uint64_t n) { return random() % n; });
}

/// A few tetrahedra combined at random.
Solid random_solid(std::mt19937_64& random, int size, int terms) {
  Solid r = random_tetrahedron(random, size);
  for (int i = 1; i < terms; ++i) {
    const Solid t = random_tetrahedron(random, size);
    switch (random() % 4) {
      case 0:
        r = r - t;
        break;
      case 1:
        r = r ^ t;
        break;
      default:
        r = r + t;
    }
  }
  return r;
}

/// Walks close and agree with each other; counts are those of `counts` and `info`, which go by triangles.
void expect_walks(const Solid& solid) {
  const Boundary b = solid.boundary();
  const Counts counts = solid.counts();
  EXPECT_EQ(b.vertex_count(), counts.vertices);
  EXPECT_EQ(b.edge_count(), counts.edges);
  EXPECT_EQ(b.face_count(), counts.faces);

  // Faces: each loop is walked once, there and back.
  std::vector<int> seen(b.corner_count());
  for (std::uint32_t f = 0; f < b.face_count(); ++f) {
    const Boundary::Face face = b.face(f);
    for (std::uint32_t j = 0; j < face.loop_count(); ++j) {
      std::uint32_t c = face.first_corner(j);
      for (const std::uint32_t v : face.loop(j)) {
        EXPECT_EQ(b.vertex_of(c), v);
        EXPECT_EQ(b.face_of(c), f);
        EXPECT_EQ(b.previous(b.next(c)), c);
        EXPECT_EQ(b.edge_of(c).has_value(), face.loop(j).size() > 1);
        ++seen[c];
        c = b.next(c);
      }
      EXPECT_EQ(c, face.first_corner(j));
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), std::ptrdiff_t{b.corner_count()});

  // Edges: each half-edge is in one fan, and its opposite runs the other way.
  std::size_t uses = 0;
  for (std::uint32_t e = 0; e < b.edge_count(); ++e) {
    const Boundary::Edge edge = b.edge(e);
    EXPECT_LT(edge.vertices[0], edge.vertices[1]);
    if (e > 0) {
      EXPECT_LT(b.edge(e - 1).vertices, edge.vertices);
    }
    EXPECT_EQ(edge.fan.size() % 2, 0u);
    uses += edge.fan.size();
    for (std::size_t i = 0; i < edge.fan.size(); ++i) {
      const Boundary::Use &use = edge.fan[i], &after = edge.fan[(i + 1) % edge.fan.size()];
      EXPECT_NE(use.forward, after.forward);
      EXPECT_EQ(b.edge_of(use.corner), e);
      EXPECT_EQ(b.face_of(use.corner), use.face);
      EXPECT_EQ(b.vertex_of(use.corner), edge.vertices[use.forward ? 0 : 1]);
      EXPECT_EQ(b.vertex_of(b.next(use.corner)), edge.vertices[use.forward ? 1 : 0]);
      EXPECT_LE(edge.fan[0].corner, use.corner);
      if (!use.forward) {
        EXPECT_EQ(b.opposite(use.corner), after.corner);
        EXPECT_EQ(b.opposite(after.corner), use.corner);
      }
    }
  }

  // Vertices: the orbits of `next` after `opposite`, a loop of one corner being one by itself.
  std::vector<std::int64_t> characteristic(b.shell_count());
  std::fill(seen.begin(), seen.end(), 0);
  for (std::uint32_t c = 0; c < b.corner_count(); ++c) {
    if (b.edge_of(c)) ++uses;
    if (seen[c]) continue;
    ++characteristic[b.shell_of(b.face_of(c))];
    std::uint32_t at = c;
    do {
      EXPECT_EQ(b.vertex_of(at), b.vertex_of(c));
      EXPECT_EQ(b.shell_of(b.face_of(at)), b.shell_of(b.face_of(c)));
      EXPECT_EQ(seen[at]++, 0);
      at = b.next(b.opposite(at).value_or(at));
    } while (at != c);
  }
  EXPECT_EQ(uses % 2, 0u);

  // Euler-Poincare, shell by shell: V - E + F - (L - F) = 2 (1 - G).
  for (std::uint32_t c = 0; c < b.corner_count(); ++c)
    if (b.edge_of(c) && c < *b.opposite(c)) --characteristic[b.shell_of(b.face_of(c))];
  for (std::uint32_t f = 0; f < b.face_count(); ++f)
    characteristic[b.shell_of(f)] += 2 - std::int64_t{b.face(f).loop_count()};
  std::int64_t genus = 0;
  for (std::uint32_t s = 0; s < b.shell_count(); ++s) {
    EXPECT_EQ(characteristic[s], 2 - 2 * b.shell_genus(s));
    genus += b.shell_genus(s);
  }
  const Info info = solid.info();
  EXPECT_EQ(b.shell_count(), info.shells);
  EXPECT_EQ(genus, info.genus);
}

/// Fans turn counter-clockwise by angles computed in doubles, and the solid is where they say, at exact points. The
/// angles between planes of small solids are far from 0.
void expect_fans(const Solid& solid) {
  const Boundary b = solid.boundary();
  const Rational near = Rational(1, exact::Integer(1) << 200);
  for (std::uint32_t e = 0; e < b.edge_count(); ++e) {
    const Boundary::Edge edge = b.edge(e);
    const V3 low = place(b, edge.vertices[0]), high = place(b, edge.vertices[1]);
    W3 axis{};
    for (std::size_t k = 0; k < 3; ++k) axis[k] = exact::to_double(Rational(high[k] - low[k]));
    axis = unit(axis);

    const auto into = [&](const Boundary::Use& use) {
      const W3 left = cross(normal(b, use.face), axis);
      return use.forward ? left : W3{-left[0], -left[1], -left[2]};
    };
    const W3 x = into(edge.fan[0]), y = cross(axis, x);
    const auto angle = [&](const Boundary::Use& use) {
      const double a = std::atan2(dot(into(use), y), dot(into(use), x));
      return &use == &edge.fan[0] ? 0 : a < 0 ? a + 2 * M_PI : a;
    };
    for (std::size_t i = 0; i < edge.fan.size(); ++i) {
      const double from = angle(edge.fan[i]), to = i + 1 < edge.fan.size() ? angle(edge.fan[i + 1]) : 2 * M_PI;
      ASSERT_LT(from, to);
      V3 p;
      for (std::size_t k = 0; k < 3; ++k)
        p[k] = (low[k] + high[k]) / 2 +
               near * exact::to_rational(x[k] * std::cos((from + to) / 2) + y[k] * std::sin((from + to) / 2));
      EXPECT_EQ(booleans::locate(Access::body(solid), p), edge.fan[i].forward ? -1 : 1);
    }
  }
}

/// Components are connected, apart, and make the solid.
void expect_components(const Solid& solid) {
  const Boundary b = solid.boundary();
  const std::vector<Solid> parts = b.components();
  ASSERT_EQ(parts.size(), b.component_count());
  if (parts.empty()) {
    EXPECT_TRUE(solid.is_empty());
    return;
  }
  EXPECT_TRUE(unite(parts).value() == solid);
  Rational sum = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ(parts[i].boundary().component_count(), 1u);
    EXPECT_TRUE(Solid::from_quoin(parts[i].to_quoin()).has_value());
    if (solid.is_bounded()) sum += number(*parts[i].volume());
    for (std::size_t j = 0; j < i; ++j) EXPECT_TRUE((parts[i] & parts[j]).is_empty());
  }
  if (solid.is_bounded()) {
    EXPECT_EQ(exact::to_string(sum), volume(solid));
  }

  // Shells enclose what they bound: outer ones more, voids less.
  Rational enclosed = 0;
  for (std::uint32_t s = 0; s < b.shell_count(); ++s) {
    enclosed += (b.is_void(s) ? -1 : 1) * number(b.shell_volume(s));
    if (const auto parent = b.parent(s)) {
      EXPECT_NE(b.is_void(*parent), b.is_void(s));
      EXPECT_EQ(b.component_of(*parent) == b.component_of(s), b.is_void(s));
    }
  }
  EXPECT_EQ(exact::to_string(enclosed), solid.is_bounded() ? volume(solid) : "-" + volume(~solid));
}

void expect_round_trip(const Solid& solid, std::mt19937_64& random) {
  ExactPolygons polygons = solid.boundary().to_exact_polygons();
  const auto again = Solid::from_boundary(polygons);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_TRUE(again.value() == solid);
  EXPECT_EQ(again->to_quoin(), solid.to_quoin());

  // Vertices in another order are the same solid.
  std::vector<std::uint32_t> to(polygons.points.size());
  std::iota(to.begin(), to.end(), 0u);
  std::shuffle(to.begin(), to.end(), random);
  auto points = polygons.points;
  for (std::size_t v = 0; v < to.size(); ++v) polygons.points[to[v]] = points[v];
  for (std::uint32_t& c : polygons.corners) c = to[c];
  const auto shuffled = Solid::from_boundary(polygons);
  ASSERT_TRUE(shuffled) << shuffled.error().message;
  EXPECT_EQ(shuffled->to_quoin(), solid.to_quoin());
}

// The book's table of a tetrahedron with the faces A, B, C, D and the edges a .. f: from, to, left, right; then the
// predecessor and successor in the left face, and in the right one.
TEST(Boundary, WingedEdgesOfATetrahedron) {  // E15
  const std::array<Corner, 4> corners{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}};
  const Boundary b = tetrahedron(corners).boundary();
  ASSERT_EQ(b.edge_count(), 6u);

  // The face D = (a, b, f) lies on the right of 1 -> 2 -> 3.
  std::map<std::uint32_t, int> vertex;
  for (std::uint32_t v = 0; v < 4; ++v)
    for (std::size_t i = 0; i < 4; ++i)
      if (b.point(v) == corners[i]) vertex[v] = static_cast<int>(i) + 1;

  const std::map<std::array<int, 2>, char> edge_name{{{1, 2}, 'a'}, {{2, 3}, 'b'}, {{3, 1}, 'f'},
                                                     {{3, 4}, 'c'}, {{1, 4}, 'd'}, {{2, 4}, 'e'}};
  const std::map<int, char> face_without{{3, 'A'}, {1, 'B'}, {2, 'C'}, {4, 'D'}};
  const auto half_edge = [&](std::uint32_t c) {
    return std::array<int, 2>{vertex[b.vertex_of(c)], vertex[b.vertex_of(b.next(c))]};
  };
  const auto name_of_edge = [&](std::uint32_t c) {
    auto [u, v] = half_edge(c);
    const auto at = edge_name.find({u, v});
    return at != edge_name.end() ? at->second : edge_name.at({v, u});
  };
  const auto name_of_face = [&](std::uint32_t c) {
    std::set<int> all{1, 2, 3, 4};
    for (const std::uint32_t v : b.face(b.face_of(c)).vertices) all.erase(vertex[v]);
    return face_without.at(*all.begin());
  };

  std::set<std::string> rows;
  for (std::uint32_t c = 0; c < b.corner_count(); ++c) {
    const auto [u, v] = half_edge(c);
    if (!edge_name.contains({u, v})) continue;
    // Seen from outside the face of this half-edge is on its left, and that of the opposite one on its right.
    const std::uint32_t o = *b.opposite(c);
    rows.insert({name_of_edge(c), ':', name_of_face(c), name_of_face(o), ' ', name_of_edge(b.previous(c)),
                 name_of_edge(b.next(c)), ' ', name_of_edge(b.next(o)), name_of_edge(b.previous(o))});
  }
  EXPECT_EQ(rows, (std::set<std::string>{"a:AD de fb", "b:BD ec af", "f:CD cd ba", "c:BC be fd", "d:CA fc ae",
                                         "e:AB ad bc"}));
}

TEST(Boundary, EulerPoincare) {  // E16
  EXPECT_EQ(euler(box({0, 0, 0}, {4, 4, 4})), (Euler{8, 12, 6, 6, 1, 0}));
  const Solid holed = box({0, 0, 0}, {9, 9, 3}) - box({6, 6, -1}, {8, 8, 4}) - box({1, 1, 1}, {2, 2, 2});
  EXPECT_EQ(euler(holed), (Euler{24, 36, 16, 18, 2, 1}));
  expect_walks(holed);
  const Solid two_holes = holed - box({6, 1, -1}, {8, 3, 4});
  EXPECT_EQ(euler(two_holes)[5], 2);
  expect_walks(two_holes);

  // A prism with a square that hangs on one of its edges: numbers as of a cube, but no solid.
  ExactPolygons fin = prism({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}).boundary().to_exact_polygons();
  ASSERT_TRUE(Solid::from_boundary(fin));
  const auto at = [&](const std::string& x, const std::string& y, const std::string& z) {
    const std::array<std::string, 4> p{x, y, z, "1"};
    return static_cast<std::uint32_t>(std::find(fin.points.begin(), fin.points.end(), p) - fin.points.begin());
  };
  fin.points.push_back({"8", "0", "0", "1"});
  fin.points.push_back({"8", "0", "4", "1"});
  for (const std::uint32_t v : {at("4", "0", "0"), 6u, 7u, at("4", "0", "4")}) fin.corners.push_back(v);
  fin.loop_starts.push_back(static_cast<std::uint32_t>(fin.corners.size()));
  fin.face_starts.push_back(static_cast<std::uint32_t>(fin.loop_starts.size()) - 1);
  fin.planes.push_back({"0", "-1", "0", "0"});
  ASSERT_EQ(fin.points.size(), 8u);
  ASSERT_EQ(fin.planes.size(), 6u);
  const auto refused = Solid::from_boundary(fin);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::bad_quoin);
}

TEST(Boundary, FaceCycles) {  // E17
  const Solid table = box({0, 0, 0}, {8, 8, 2});
  const auto wedge = [](double x, double y) { return prism({x, y, 2}, {x, y + 1, 4}, {x, y - 1, 4}, {2, 0, 0}); };
  const auto loops_on_top = [](const Solid& solid) {
    const Boundary b = solid.boundary();
    std::vector<std::size_t> sizes;
    for (std::uint32_t f = 0; f < b.face_count(); ++f)
      if (b.plane(f) == std::array<std::string, 4>{"0", "0", "1", "-2"})
        for (std::uint32_t j = 0; j < b.face(f).loop_count(); ++j) sizes.push_back(b.face(f).loop(j).size());
    return sizes;
  };
  const Solid inner_slit = table + wedge(3, 4), outer_slit = table + wedge(0, 4);
  const Solid dot = table + tetrahedron({{{4, 4, 2}, {3, 3, 5}, {5, 3, 5}, {4, 6, 5}}});
  const Solid hole = inner_slit - box({5, 3, 0}, {7, 5, 2});
  EXPECT_EQ(loops_on_top(inner_slit), (std::vector<std::size_t>{4, 2}));
  EXPECT_EQ(loops_on_top(outer_slit), (std::vector<std::size_t>{7}));
  EXPECT_EQ(loops_on_top(dot), (std::vector<std::size_t>{4, 1}));
  EXPECT_EQ(loops_on_top(hole), (std::vector<std::size_t>{4, 7}));
  auto random = random_engine();
  for (const Solid& solid : {inner_slit, outer_slit, dot, hole})
    for (const Solid& s : {solid, ~solid}) {
      expect_walks(s);
      expect_fans(s);
      expect_components(s);
      expect_round_trip(s, random);
    }
  EXPECT_EQ(inner_slit.boundary().component_count(), 2u);
  EXPECT_EQ(dot.boundary().component_count(), 2u);
  EXPECT_TRUE(inner_slit.boundary().component(0) == table || inner_slit.boundary().component(1) == table);

  // Edges outside of the area, and a face of one vertex.
  const ExactPolygons whole = table.boundary().to_exact_polygons();
  const auto with_loop = [&](std::vector<std::uint32_t> first_loop, bool alone) {
    ExactPolygons p = whole;
    const std::vector<std::uint32_t> rest(p.corners.begin() + p.loop_starts[1], p.corners.end());
    const auto by = static_cast<std::uint32_t>(first_loop.size()) - p.loop_starts[1];
    p.corners = first_loop;
    p.corners.insert(p.corners.end(), rest.begin(), rest.end());
    for (std::size_t j = 1; j < p.loop_starts.size(); ++j) p.loop_starts[j] += by;
    if (!alone) p.points.push_back({"0", "9", "9", "1"});
    return Solid::from_boundary(p);
  };
  const std::vector<std::uint32_t> own(whole.corners.begin(), whole.corners.begin() + whole.loop_starts[1]);
  ASSERT_EQ(whole.planes[0], (std::array<std::string, 4>{"-1", "0", "0", "0"}));
  EXPECT_TRUE(with_loop(own, true));
  std::vector<std::uint32_t> spike = own;
  spike.insert(spike.end(), {8, own.back()});
  for (const auto& result : {with_loop(spike, false), with_loop({own[0]}, true)}) {
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::bad_quoin);
    EXPECT_EQ(result.error().where, "face 0");
  }
}

TEST(Boundary, ShellsFormAForest) {  // E26
  const Solid solid = box({0, 0, 0}, {9, 9, 9}) - box({1, 1, 1}, {3, 3, 3}) - box({5, 5, 5}, {8, 8, 8});
  const Boundary b = solid.boundary(), outside = (~solid).boundary();
  ASSERT_EQ(b.shell_count(), 3u);
  EXPECT_EQ(b.component_count(), 1u);
  EXPECT_EQ(outside.component_count(), 3u);
  std::multiset<std::string> volumes;
  for (std::uint32_t s = 0; s < 3; ++s) {
    const bool is_root = b.shell_volume(s) == "729";
    volumes.insert(b.shell_volume(s));
    EXPECT_EQ(b.is_void(s), !is_root);
    EXPECT_EQ(b.parent(s).has_value(), !is_root);
    EXPECT_EQ(b.shell_faces(s).size(), 6u);
  }
  EXPECT_EQ(volumes, (std::multiset<std::string>{"8", "27", "729"}));

  // Outside faces come in another order; flags flip.
  for (std::uint32_t s = 0; s < 3; ++s) {
    const bool is_root = outside.shell_volume(s) == "729";
    EXPECT_EQ(outside.is_void(s), is_root);
    EXPECT_EQ(outside.parent(s).has_value(), !is_root);
  }
  expect_components(solid);
  expect_components(~solid);
}

// The table of docs/boundary.md.
TEST(Boundary, TouchingParts) {
  const auto count = [](const Solid& solid) {
    expect_walks(solid);
    expect_fans(solid);
    expect_components(solid);
    const Boundary b = solid.boundary();
    std::array<std::uint32_t, 3> r{b.shell_count(), b.component_count(), 0};
    for (std::uint32_t s = 0; s < b.shell_count(); ++s) r[2] += b.is_void(s);
    return r;
  };
  using Counted = std::array<std::uint32_t, 3>;
  const Solid cube = box({0, 0, 0}, {1, 1, 1}), block = box({0, 0, 0}, {8, 8, 8});
  const Solid at_edge = cube + box({1, 1, 0}, {2, 2, 1}), at_corner = cube + box({1, 1, 1}, {2, 2, 2});
  EXPECT_EQ(count(at_edge), (Counted{2, 2, 0}));
  EXPECT_EQ(count(at_corner), (Counted{2, 2, 0}));
  EXPECT_EQ(count(~at_edge), (Counted{1, 1, 1}));
  EXPECT_EQ(count(~at_corner), (Counted{2, 1, 2}));

  const Solid ring = box({0, 0, 0}, {9, 9, 2}) - box({3, 3, -1}, {6, 6, 3});
  const Solid pinched = ring - prism({2, -1, -1}, {6, -1, -1}, {4, 1, -1}, {0, 0, 4}) -
                        prism({4, 1, -1}, {7, 4, -1}, {1, 4, -1}, {0, 0, 4});
  EXPECT_EQ(pinched.info().manifold, false);
  EXPECT_EQ(count(pinched), (Counted{1, 1, 0}));

  EXPECT_EQ(count(block - tetrahedron({{{4, 4, 8}, {3, 3, 5}, {5, 3, 5}, {4, 6, 5}}})), (Counted{2, 1, 1}));
  EXPECT_EQ(count(block - prism({3, 4, 8}, {3, 5, 6}, {3, 3, 6}, {2, 0, 0})), (Counted{1, 1, 0}));
}

TEST(Boundary, EmptyAndFull) {
  for (const Boundary& b : {Boundary(), Solid().boundary()}) {
    EXPECT_EQ(b.vertex_count() + b.edge_count() + b.face_count() + b.loop_count() + b.shell_count(), 0u);
    EXPECT_TRUE(b.components().empty());
  }
  const Solid full = Solid::full(grid_of("1/3"));
  const Boundary b = full.boundary();
  EXPECT_FALSE(b.is_bounded());
  ASSERT_EQ(b.component_count(), 1u);
  EXPECT_TRUE(b.component(0) == full);
  EXPECT_TRUE(Solid::from_boundary(b.to_exact_polygons()).value() == full);
}

/// Boxes in boxes, solid and void in turn. Appends what a shell should be: its own lowest corner and its parent's.
void add_boxes(std::mt19937_64& random, Corner low, Corner high, int depth, const std::string& around, Solid& solid,
               std::map<std::string, std::string>& parents) {
  const auto name = std::to_string(low[0]) + " " + std::to_string(low[1]) + " " + std::to_string(low[2]);
  solid = depth % 2 == 0 ? solid + box(low, high) : solid - box(low, high);
  parents[name] = around;
  const double width = high[0] - low[0];
  if (depth == 4 || width < 8) return;
  // Two halves along x, each with a box or not.
  const double middle = std::floor(low[0] + width / 2);
  for (const auto& [from, to] : {std::pair(low[0], middle), std::pair(middle, high[0])}) {
    if (random() % 4 == 0) continue;
    const double margin = 1 + static_cast<double>(random() % 2);
    add_boxes(random, {from + 1, low[1] + margin, low[2] + 1}, {to - 1, high[1] - 1, high[2] - margin}, depth + 1, name,
              solid, parents);
  }
}

TEST(Boundary, VoidsWithinSolidsWithinVoids) {
  auto random = random_engine();
  for (int round = 0; round < 6; ++round) {
    Solid solid;
    std::map<std::string, std::string> expected;
    for (const double x : {-200.0, 200.0}) add_boxes(random, {x, -64, -64}, {x + 128, 64, 64}, 0, "", solid, expected);
    for (const bool turned : {false, true}) {
      const Boundary b = (turned ? ~solid : solid).boundary();
      ASSERT_EQ(b.shell_count(), expected.size());
      std::vector<std::string> name;
      for (std::uint32_t s = 0; s < b.shell_count(); ++s) {
        W3 low = b.point(b.face(b.shell_faces(s)[0]).vertices[0]);
        for (const std::uint32_t f : b.shell_faces(s))
          for (const std::uint32_t v : b.face(f).vertices) low = std::min(low, b.point(v));
        name.push_back(std::to_string(low[0]) + " " + std::to_string(low[1]) + " " + std::to_string(low[2]));
      }
      for (std::uint32_t s = 0; s < b.shell_count(); ++s) {
        ASSERT_TRUE(expected.contains(name[s]));
        EXPECT_EQ(b.parent(s) ? name[*b.parent(s)] : "", expected[name[s]]);
        std::size_t depth = 0;
        for (std::string at = expected[name[s]]; !at.empty(); at = expected[at]) ++depth;
        EXPECT_EQ(b.is_void(s), (depth % 2 == 1) != turned);
      }
      expect_components(turned ? ~solid : solid);
    }
  }
}

// Tetrahedra of a lattice touch in edges and corners wherever they can. Parts of the interior hang together over their
// faces: counted without any surface.
TEST(Boundary, ComponentsOfLatticeSets) {
  auto random = random_engine();
  for (int round = 0; round < 150; ++round) {
    const auto set = random_set(random);
    const Solid solid = solid_of(set, 2);
    const Boundary b = solid.boundary();
    const auto simplices = booleans::testing::simplices(set);
    EXPECT_EQ(b.component_count(), booleans::testing::parts(set, simplices, true, 3));
    EXPECT_EQ((~solid).boundary().component_count(), booleans::testing::parts(set, simplices, false, 3));
    const auto topology = booleans::testing::separated_topology(set);
    EXPECT_EQ(b.shell_count(), topology.shells);
    EXPECT_EQ(euler(solid)[5], topology.genus);
    if (round % 5 != 0) continue;
    expect_walks(solid);
    expect_fans(solid);
    expect_components(solid);
    expect_components(~solid);
    expect_round_trip(solid, random);
  }
}

TEST(Boundary, RandomBooleans) {
  auto random = random_engine();
  for (int round = 0; round < 25; ++round) {
    const Solid solid = random_solid(random, 5, 2 + static_cast<int>(random() % 4));
    for (const Solid& s : {solid, ~solid}) {
      expect_walks(s);
      expect_fans(s);
      expect_components(s);
      expect_round_trip(s, random);
    }
  }
}

// Where numbers stand in model units; the points go by `to_quoin`, planes by the points that lie on them.
TEST(Boundary, NumbersInModelUnits) {
  const Grid grid = Grid::with_step_and_origin("1/7", {"1/3", "-5", "0"}).value();
  const auto points = std::array<Corner, 4>{{{0, 0, 0}, {9, 1, 0}, {1, 8, 0}, {2, 3, 7}}};
  const Solid solid = tetrahedron(points, grid) - box({3, 2, 1}, {12, 12, 3}, grid);
  const Boundary b = solid.boundary();
  const Polygons rounded = b.to_polygons();
  ASSERT_EQ(rounded.points.size(), 3 * b.vertex_count());
  for (std::uint32_t v = 0; v < b.vertex_count(); ++v) {
    const auto h = b.homogeneous(v);
    const V3 p = place(b, v);
    const V3 origin{Rational(1, 3), -5, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(p[k], Rational(origin[k] + number(h[k]) / number(h[3]) / 7));
      EXPECT_EQ(b.point(v)[k], exact::to_double(p[k]));
      EXPECT_EQ(rounded.points[3 * v + k], b.point(v)[k]);
    }
  }
  double area = 0;
  for (std::uint32_t f = 0; f < b.face_count(); ++f) {
    const auto plane = b.model_plane(f);
    for (const std::uint32_t v : b.face(f).vertices) {
      const V3 p = place(b, v);
      EXPECT_EQ(number(plane[0]) * p[0] + number(plane[1]) * p[1] + number(plane[2]) * p[2] + number(plane[3]), 0);
    }
    area += b.area(f);
  }
  EXPECT_NEAR(area, solid.area(), 1e-12 * area);
  EXPECT_EQ(box({0, 0, 0}, {2, 3, 5}).boundary().area(0), 15);
  const auto equal = Solid::from_boundary(b.to_exact_polygons());
  EXPECT_TRUE(equal.value() == solid);
  EXPECT_TRUE(equal->grid() == grid);
}

TEST(Boundary, EqualSolidsHaveEqualNumbers) {
  const Solid a = box({0, 0, 0}, {2, 2, 2}), b = box({2, 0, 0}, {4, 2, 2}), whole = box({0, 0, 0}, {4, 2, 2});
  const Boundary p = (a + b).boundary(), q = whole.boundary();
  ASSERT_EQ(p.face_count(), 6u);
  for (std::uint32_t f = 0; f < 6; ++f) {
    EXPECT_EQ(p.plane(f), q.plane(f));
    EXPECT_TRUE(std::ranges::equal(p.face(f).vertices, q.face(f).vertices));
    EXPECT_EQ(p.neighbours(f), q.neighbours(f));
    const auto around = p.neighbours(f);
    EXPECT_EQ(std::set<std::uint32_t>(around.begin(), around.end()).size(), 4u);
  }
}

// What is trusted wrongly has unspecified answers, and walks that end.
TEST(Boundary, TrustedWrongly) {
  auto random = random_engine();
  for (int round = 0; round < 60; ++round) {
    Mesh soup;
    for (std::uint64_t i = 0, n = 2 + random() % 4; i < n; ++i) {
      const Mesh one = random_tetrahedron(random, 2).to_triangles().value();
      const auto base = static_cast<std::uint32_t>(soup.points.size() / 3);
      soup.points.insert(soup.points.end(), one.points.begin(), one.points.end());
      for (const std::uint32_t v : one.triangles) soup.triangles.push_back(base + v);
    }
    const auto trusted = Solid::from_triangles(soup.points, soup.triangles, {.grid = Grid(), .trust = Trust::embedded});
    ASSERT_TRUE(trusted);
    for (const Solid& solid : {trusted.value(), ~trusted.value()}) {
      const Boundary b = solid.boundary();
      for (std::uint32_t c = 0; c < b.corner_count(); ++c) {
        const auto other = b.opposite(c);
        ASSERT_TRUE(!other || (b.opposite(*other) == c && b.edge_of(*other) == b.edge_of(c) && *other != c));
      }
      for (std::uint32_t s = 0; s < b.shell_count(); ++s) EXPECT_LT(b.component_of(s), b.component_count());
      EXPECT_EQ(b.components().size(), b.component_count());
      (void)Solid::from_boundary(b.to_exact_polygons());
      (void)Solid::from_boundary(b.to_exact_polygons(), Trust::embedded);
    }
  }
}

TEST(Boundary, ManyThreadsMayAskFirst) {
  const Solid solid = box({0, 0, 0}, {9, 9, 9}) - box({1, 1, 1}, {3, 3, 3}) - box({5, 5, 5}, {8, 8, 8});
  for (int round = 0; round < 20; ++round) {
    const Boundary b = solid.boundary();
    std::vector<std::array<std::uint32_t, 3>> said(8);
    std::vector<std::thread> threads;
    for (auto& own : said)
      threads.emplace_back([&b, &own] { own = {b.component_count(), b.shell_count(), b.edge_count()}; });
    for (std::thread& thread : threads) thread.join();
    for (const auto& own : said) EXPECT_EQ(own, (std::array<std::uint32_t, 3>{1, 3, 36}));
  }
}

TEST(Boundary, BadArraysAreRefused) {
  const ExactPolygons good = box({0, 0, 0}, {2, 2, 2}).boundary().to_exact_polygons();
  ASSERT_TRUE(Solid::from_boundary(good));
  const auto code = [&](auto&& spoil) {
    ExactPolygons bad = good;
    spoil(bad);
    const auto r = Solid::from_boundary(bad);
    return r ? "none" : to_string(r.error().code) + ", " + r.error().where;
  };
  EXPECT_EQ(code([](auto& p) { p.corners[3] = 8; }), "bad-index, corner 3");
  EXPECT_EQ(code([](auto& p) { p.loop_starts.pop_back(); }), "bad-index, loop_starts");
  EXPECT_EQ(code([](auto& p) { p.loop_starts.clear(); }), "bad-index, loop_starts");
  EXPECT_EQ(code([](auto& p) { p.loop_starts[1] = 0; }), "bad-index, loop_starts");
  EXPECT_EQ(code([](auto& p) { p.face_starts[1] = 7; }), "bad-index, face_starts");
  EXPECT_EQ(code([](auto& p) { p.face_starts.clear(); }), "bad-index, face_starts");
  EXPECT_EQ(code([](auto& p) { p.planes.pop_back(); }), "bad-index, planes");
  for (const char* word : {"", "-", "00", "-0", "1.0", "1/2", "x", " 1", "1\n"})
    EXPECT_EQ(code([&](auto& p) { p.points[2][1] = word; }), "bad-number, vertex 2");
  EXPECT_EQ(code([](auto& p) { p.points[2][1] = std::string(1000, '1'); }), "bad-number, vertex 2");
  EXPECT_EQ(code([](auto& p) { p.planes[4][3] = "1e3"; }), "bad-number, face 4");
  EXPECT_EQ(code([](auto& p) { p.points[5][3] = "0"; }), "bad-number, vertex 5");
  EXPECT_EQ(code([](auto& p) { p.points[5][3] = "-1"; }), "bad-number, vertex 5");
  EXPECT_EQ(code([](auto& p) { p.points[5][3] = "2"; }).substr(0, 9), "bad-quoin");
  EXPECT_EQ(code([](auto& p) { p.points[5] = p.points[4]; }), "bad-quoin, vertex 5");
  EXPECT_EQ(code([](auto& p) { p.planes[0][3] = "1"; }), "bad-quoin, face 0");
  EXPECT_EQ(code([](auto& p) { std::swap(p.corners[0], p.corners[1]); }).substr(0, 9), "bad-quoin");
  EXPECT_EQ(code([](auto& p) { p.full_at_infinity = true; }).substr(0, 9), "bad-quoin");
}

}  // namespace
}  // namespace quoin::api_test
