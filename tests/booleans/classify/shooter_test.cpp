#include "booleans/classify/shooter.h"

#include <gtest/gtest.h>

#include "tests/booleans/classify/rational_rays.h"

namespace quoin::booleans::testing {
namespace {

/// The direction from v to w along two planes that are not parallel.
Direction along(const exact::Plane& p, const exact::Plane& q, const exact::Point& v, const exact::Point& w) {
  Direction d;
  const auto n = [](const exact::Plane& plane, std::size_t k) { return exact::Coefficient(plane.n[k]); };
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    d[k] = n(p, i) * n(q, j) - n(p, j) * n(q, i);
  }
  for (int k = 0; k < 3; ++k)
    if (const int s = d[static_cast<std::size_t>(k)].sign(); s != 0) {
      if (exact::compare_along(k, w, v) != s)
        for (auto& x : d) x = -x;
      break;
    }
  return d;
}

/// A ray next to every edge that runs forward in x or is parallel to z, from its first end.
std::vector<Ray> all_rays(const Arrangement& a) {
  std::vector<Ray> rays;
  const auto add = [&](AnyVertex v, AnyVertex w, const Direction& d) {
    if (d[0].sign() > 0 || (d[0].sign() == 0 && d[1].sign() == 0)) rays.push_back({v, w, {v.point(a), d}});
  };
  for (const SheetId s : a.sheets.ids())
    for (std::uint32_t h = 0; h < a.sheets[s].half_edges(); ++h) {
      const Sheet& sheet = a.sheets[s];
      const VertexId v = sheet.origin(h), w = sheet.target(h);
      add(v, w,
          along(a.names.planes[sheet.plane], a.names.planes[sheet.elements[h / 2].line], a.names.vertices.point(v),
                a.names.vertices.point(w)));
    }

  a.for_untouched([&](FaceId f, NodeId) {
    const auto [operand, face] = a.operands.own(f);
    const Body& body = a.operands[operand];
    body.for_edges(face, [&, o = operand](std::uint32_t u, std::uint32_t w) {
      if (!body.is_grid(u) || !body.is_grid(w)) return;
      const Vector d = vector(body.grid_points[w]) - vector(body.grid_points[u]);
      add(AnyVertex(a.names, o, u), AnyVertex(a.names, o, w),
          {exact::Int<127>(d[0]), exact::Int<127>(d[1]), exact::Int<127>(d[2])});
    });
  });
  return rays;
}

struct Counts {
  std::size_t near = 0, far = 0, missed = 0;  // hits with and without the start as a corner; none
};

/// Some of an arrangement's rays, shot at once, against rationals.
void expect_first_hits(const std::vector<Body>& bodies, Random& random, Counts& counts) {
  static constexpr std::array<std::size_t, 3> few{0, 4, 1u << 30};
  const WithThresholds thresholds(grid::testing::with(&grid::Thresholds::few_rays, few[random.below(3)]));
  const Arrangement a = arranged(bodies);
  std::vector<Ray> rays;
  for (const Ray& r : all_rays(a))
    if (rays.size() < 40 || random.one_in(4)) {
      if (rays.size() == 40)
        rays[random.below(40)] = r;
      else
        rays.push_back(r);
    }

  const auto polygons = polygons_of(a);
  Shooter shooter(a, rays);
  for (const Ray& r : rays) {
    const SideId expected = first_below(polygons, r.start);
    ASSERT_EQ(shooter.first_hit(r), expected);
    if (expected == none) {
      ++counts.missed;
      continue;
    }
    bool is_near = false;
    for (const Polygon& p : polygons)
      for (const auto& [v, w] : p.edges)
        is_near |= p.node == node_of(expected) && exact::compare_lexicographic(v, r.start.v) == 0;
    ++(is_near ? counts.near : counts.far);
  }
}

template <class Bodies>
Counts expect_first_hits(std::uint64_t salt, std::uint64_t usual, Bodies&& bodies) {
  Counts counts;
  for (std::uint64_t number = 0; number < case_count(usual); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(salt, number);
    expect_first_hits(bodies(random), random, counts);
    if (::testing::Test::HasFatalFailure()) break;
  }
  return counts;
}

// Tetrahedra with a common corner, of few directions: they share planes and edges, touch and cross.
TEST(Shooter, TetrahedraWithACommonCorner) {
  const Counts counts = expect_first_hits(0x5400, 24, [](Random& random) {
    const Vector apex = random.vector(-3, 3);
    const std::int64_t reach = random.one_in(2) ? 2 : 7;
    std::vector<Body> bodies;
    while (bodies.size() < 7) {
      const auto corner = [&] { return apex + random.vector(-reach, reach); };
      if (const auto body = tetrahedron({apex, corner(), corner(), corner()})) bodies.push_back(*body);
    }
    return bodies;
  });
  EXPECT_GT(counts.near, 100u);
  EXPECT_GT(counts.far, 100u);
  EXPECT_GT(counts.missed, 100u);
}

// The same within each other: cones of squares, each inside the next, and one of them cut in half by a wedge.
TEST(Shooter, ConesWithinConesAtOneApex) {
  const Counts counts = expect_first_hits(0x5401, 40, [](Random& random) {
    std::array<Vector, 3> columns{};
    for (Vector& c : columns) c = random.vector(-2, 2);
    std::vector<Body> bodies;
    for (std::int64_t r = 1; r < 8; ++r) {
      const std::vector<Vector> points{{0, 0, 0}, {10 + r, -r, -r}, {10 + r, r, -r}, {10 + r, r, r}, {10 + r, -r, r}};
      static constexpr std::array<Triangle, 6> faces{
          {{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 1, 4}, {1, 2, 3}, {1, 3, 4}}};
      if (const auto body = mapped(*mesh(points, faces), {1, 2, 3}, columns)) bodies.push_back(*body);
    }
    if (bodies.empty()) bodies.push_back(box({0, 0, 0}, {1, 1, 1}));
    if (random.one_in(2)) bodies.push_back(*tetrahedron({{{1, 2, 3}, {9, 3, 2}, {9, -6, 3}, {9, 2, -4}}}));
    return bodies;
  });
  EXPECT_GT(counts.near, 100u);
}

// Tetrahedra with a common corner inside the top of a plate, above it and within it: the plate comes between them,
// though the corner is none of its own.
TEST(Shooter, TipsOnBothSidesOfAPlate) {
  const Counts counts = expect_first_hits(0x5405, 20, [](Random& random) {
    std::vector<Body> bodies{box({-9, -9, -9}, {9, 0, 9})};
    while (bodies.size() < 9) {
      const std::int64_t side = random.one_in(2) ? 1 : -1;
      const auto corner = [&] {
        return Vector{random.between(-2, 6), side * random.between(1, 6), random.between(-6, 6)};
      };
      if (const auto body = tetrahedron({{{0, 0, 0}, corner(), corner(), corner()}})) bodies.push_back(*body);
    }
    return bodies;
  });
  EXPECT_GT(counts.near, 100u);
  EXPECT_GT(counts.far, 100u);
}

/// A cone, cut off by a box, whose apex is the common point of the planes; or where two such cones differ.
Body any_cone(const std::vector<exact::Plane>& planes, Random& random) {
  const exact::GridPoint low{{-20, -20, -20}}, high{{20, 20, 20}};
  const auto convex = [&] {
    std::vector<Body> sides;
    for (std::size_t i = 0; i < 3; ++i) {
      const exact::Plane& p = planes[random.below(planes.size())];
      sides.push_back(half_space_body(random.one_in(2) ? p : p.opposite(), low, high));
    }
    return combined(Rule::all, {&sides[0], &sides[1], &sides[2]});
  };
  return random.one_in(2) ? convex() : odd(convex(), convex());
}

// Cones with an apex off the grid, with reflex corners there.
TEST(Shooter, ConesWithAnApexOffTheGrid) {
  const Counts counts = expect_first_hits(0x5402, 40, [](Random& random) {
    const Vector apex = random.vector(-40, 40);  // in sevenths
    std::vector<exact::Plane> planes;
    while (planes.size() < 5) {
      const Vector n = random.vector(-3, 3);
      if (n == Vector{0, 0, 0}) continue;
      const std::int64_t d = n[0] * apex[0] + n[1] * apex[1] + n[2] * apex[2];
      planes.push_back(exact::reduced_plane(7 * n, -d));
    }
    std::vector<Body> bodies;
    for (int i = 0; i < 4; ++i) bodies.push_back(any_cone(planes, random));
    return bodies;
  });
  EXPECT_GT(counts.near, 100u);
  EXPECT_GT(counts.far, 100u);
}

// Long thin tetrahedra across the axes, whose boxes hold each other.
TEST(Shooter, Slivers) {
  const Counts counts = expect_first_hits(0x5403, 40, [](Random& random) {
    const std::int64_t length = random.one_in(2) ? 40 : 200'000'000;
    std::vector<Body> bodies;
    while (bodies.size() < 12) {
      const Vector at = random.vector(-12, 12);
      const std::int64_t turn = random.one_in(2) ? 1 : -1;
      const Vector end = at + Vector{length, turn * length, random.between(-3, 3)};
      if (const auto body = tetrahedron({at, at + random.vector(-2, 2), end, end + random.vector(-2, 2)}))
        bodies.push_back(*body);
    }
    return bodies;
  });
  EXPECT_GT(counts.far, 100u);
}

// Any solids, their vertices derived or not.
TEST(Shooter, AnySolids) {
  Counts counts;
  for_families(0x5404, 6, [&](Solids& solids, Random& random) {
    const Body b = solids.next();
    expect_first_hits({odd(solids.next(), b), random.one_in(2) ? b : solids.next(), solids.next()}, random, counts);
  });
  EXPECT_GT(counts.far, 100u);
  EXPECT_GT(counts.missed, 100u);
}

}  // namespace
}  // namespace quoin::booleans::testing
