#include "booleans/embedding.h"

#include <gtest/gtest.h>

#include <tuple>

#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

/// The faces of both, equal points as one vertex.
Body together(const Body& a, const Body& b) {
  Body r;
  const auto less = [](const exact::Point& p, const exact::Point& q) { return exact::compare_lexicographic(p, q) < 0; };
  std::map<exact::Point, std::uint32_t, decltype(less)> ids(less);
  for (const bool grid : {true, false})
    for (const Body* body : {&a, &b})
      for (std::uint32_t v = 0; v < body->vertex_count(); ++v)
        if (body->is_grid(v) == grid && ids.emplace(body->point(v), r.vertex_count()).second) {
          if (grid)
            r.grid_points.push_back(body->grid_points[v]);
          else
            r.points.push_back(body->point(v));
        }
  for (const Body* body : {&a, &b}) {
    const auto id = [&](std::uint32_t v) { return ids.at(body->point(v)); };
    for (const auto& t : body->triangles) r.triangles.push_back({id(t[0]), id(t[1]), id(t[2])});
    r.planes.append(body->planes.begin(), body->planes.end());
    for (std::size_t p = 0; p < body->polygon_count(); ++p) {
      for (std::uint32_t j = body->polygons.face_start[p]; j < body->polygons.face_start[p + 1]; ++j) {
        for (std::uint32_t v : body->polygons.loop(j)) r.polygons.corners.push_back(id(v));
        r.polygons.loop_start.push_back(static_cast<std::uint32_t>(r.polygons.corners.size()));
      }
      r.polygons.face_start.push_back(static_cast<std::uint32_t>(r.polygons.loop_start.size() - 1));
    }
  }
  return r;
}

/// The precondition: no edge whose faces all lie on one plane.
bool has_flat_edge(const Body& body) {
  std::map<std::array<std::uint32_t, 2>, std::pair<exact::Plane, bool>> edges;
  for (std::uint32_t f = 0; f < body.face_count(); ++f)
    body.for_edges(f, [&](std::uint32_t u, std::uint32_t v) {
      const exact::Plane p = body.plane(f);
      const auto at = edges.try_emplace({std::min(u, v), std::max(u, v)}, p, true).first;
      at->second.second = at->second.second && exact::parallel(at->second.first, p);
    });
  return std::any_of(edges.begin(), edges.end(), [](const auto& e) { return e.second.second; });
}

Body normal_form(const Body& body) { return body_of(canonical(body)); }

Body half(const Body& a) {  // the side of a grid plane through it
  return all(a, half_space_body({{3, 1, 2}, -exact::int128{17}}, {{-64, -64, -64}}, {{64, 64, 64}}));
}

TEST(Embedding, ResultsAreClean) {
  for (std::uint64_t number = 0; number < case_count(150); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xE3B, number);
    Solids solids(random, families[number % families.size()]);
    const std::vector<Body> operands{solids.next(), solids.next(), solids.next()};
    const Body result = evaluated(operands, random_expression(random, operands.size(), 2));
    EXPECT_EQ(embedding_fault(normal_form(result)).value_or(""), "");
    EXPECT_EQ(embedding_fault(normal_form(complement(result))).value_or(""), "");
  }
}

// Two clean bodies side by side are clean exactly when their union has just their faces: whatever crosses, overlaps,
// touches or nests changes the union's canonical form. Likewise a body with the turned faces of another one is clean
// exactly when it is their difference.
TEST(Embedding, TwoBodiesAreCleanWhereTheirBooleanHasTheSameFaces) {
  std::array<int, 4> seen{};
  for (std::uint64_t number = 0; number < case_count(1500); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x2B0, number);
    Solids solids(random, families[number % families.size()]);
    const bool cavity = random.one_in(2);
    const Body a = normal_form(solids.next()), b = normal_form(solids.next());
    Body turned = cavity ? complement(b) : b;
    const Body both = together(a, turned);
    if (has_flat_edge(both)) continue;
    ASSERT_EQ(fault(both).value_or(""), "");
    const bool clean = canonical(both) == canonical(cavity ? minus(a, b) : any(a, b));
    Array<std::uint32_t> faces;
    const auto message = embedding_fault(both, &faces);
    EXPECT_EQ(!message, clean) << message.value_or("");
    EXPECT_EQ(message, embedding_fault(both));
    // Each body by itself is clean: two faces that meet out of place are of both.
    if (!message) {
      EXPECT_TRUE(faces.empty());
    } else if (message->starts_with("faces cross")) {
      ASSERT_EQ(faces.size(), 2u) << *message;
      const auto is_first = [&](std::uint32_t f) {
        return f < both.triangles.size() ? f < a.triangles.size() : both.polygon(f) < a.polygon_count();
      };
      EXPECT_NE(is_first(faces[0]), is_first(faces[1])) << *message;
    } else {
      EXPECT_EQ(faces.size(), 1u) << *message;
    }
    ++seen[2 * (cavity ? 1 : 0) + (clean ? 1 : 0)];
  }
  if (case_count(1500) >= 1500) {
    for (int count : seen) EXPECT_GT(count, 4);
  }
}

TEST(Embedding, NamedCases) {
  const Body cube = normal_form(box({0, 0, 0}, {8, 8, 8}));
  const auto with = [&](const Body& other) { return embedding_fault(together(cube, normal_form(other))); };
  EXPECT_FALSE(with(box({9, 0, 0}, {10, 8, 8}))) << "apart";
  EXPECT_FALSE(with(box({8, 8, 8}, {9, 9, 9}))) << "common corner";
  EXPECT_TRUE(with(box({4, 4, 4}, {12, 12, 12}))) << "crossing";
  EXPECT_TRUE(with(box({8, 2, 2}, {9, 4, 4}))) << "faces overlap from both sides";
  EXPECT_TRUE(with(box({1, 1, 1}, {2, 2, 2}))) << "winding number 2";
  EXPECT_FALSE(with(complement(box({1, 1, 1}, {2, 2, 2})))) << "cavity";
  EXPECT_TRUE(with(complement(box({9, 1, 1}, {10, 2, 2})))) << "winding number -1";
  EXPECT_TRUE(with(complement(*tetrahedron({{{9, 1, 1}, {10, 1, 1}, {9, 2, 1}, {9, 1, 2}}})))) << "the same, raw";
  EXPECT_TRUE(with(*tetrahedron({{{8, 4, 4}, {9, 4, 4}, {9, 5, 4}, {9, 4, 5}}}))) << "vertex in a face";
  EXPECT_TRUE(with(*tetrahedron({{{8, 8, 4}, {9, 8, 4}, {9, 9, 4}, {9, 8, 5}}}))) << "vertex in an edge";
  EXPECT_TRUE(with(half(box({-4, -4, -4}, {4, 4, 4})))) << "derived points";
  Body full = cube;
  full.full_at_infinity = true;
  EXPECT_TRUE(embedding_fault(full)) << "winding number 2 in a full space";
  full = complement(full);
  EXPECT_TRUE(embedding_fault(full)) << "inside out";
  EXPECT_FALSE(embedding_fault(complement(cube))) << "unbounded";
}

/// Where two closed axis-parallel rectangles or boxes meet, as one; nothing where they do not.
using Cuboid = std::array<std::array<std::int64_t, 3>, 2>;
std::optional<Cuboid> common(const Cuboid& p, const Cuboid& q) {
  Cuboid r{};
  for (std::size_t k = 0; k < 3; ++k) {
    r[0][k] = std::max(p[0][k], q[0][k]);
    r[1][k] = std::min(p[1][k], q[1][k]);
    if (r[0][k] > r[1][k]) return std::nullopt;
  }
  return r;
}

/// Whether rectangles meet otherwise than in a common edge or corner: along each axis the common part then begins or
/// ends where both do, and in one axis more than the normal's it has no length.
bool meet_out_of_place(const Cuboid& p, const Cuboid& q) {
  const auto meeting = common(p, q);
  if (!meeting) return false;
  const auto is_part = [&](const Cuboid& face) {
    int flat = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t low = (*meeting)[0][k], high = (*meeting)[1][k];
      flat += low == high;
      if (low == high ? low != face[0][k] && low != face[1][k] : low != face[0][k] || high != face[1][k]) return false;
    }
    return flat >= 2;
  };
  return !is_part(p) || !is_part(q);
}

// The second way: rectangles as intervals.
TEST(Embedding, FacesOfBoxesThatMeetOutOfPlaceAreNamed) {
  std::array<int, 3> seen{};  // by the number of faces named
  for (std::uint64_t number = 0; number < case_count(1000); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xB0C, number);
    const auto random_box = [&] {
      Vector low{}, high{};
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = random.between(0, 4);
        high[k] = low[k] + random.between(1, 5);
      }
      return normal_form(box(low, high));
    };
    const Body a = random_box(), b = random_box(), both = together(a, random.one_in(2) ? complement(b) : b);
    if (has_flat_edge(both) || fault(both)) continue;

    std::vector<Cuboid> rectangles;
    for (std::uint32_t f = 0; f < both.face_count(); ++f) {
      Cuboid& r = rectangles.emplace_back(Cuboid{{{99, 99, 99}, {-99, -99, -99}}});
      both.for_corners(f, [&](std::uint32_t v) {
        for (std::size_t k = 0; k < 3; ++k) {
          r[0][k] = std::min<std::int64_t>(r[0][k], both.grid_points[v][static_cast<int>(k)]);
          r[1][k] = std::max<std::int64_t>(r[1][k], both.grid_points[v][static_cast<int>(k)]);
        }
      });
    }
    bool is_crossing = false;
    for (std::size_t f = 0; f < rectangles.size(); ++f)
      for (std::size_t g = f + 1; g < rectangles.size(); ++g)
        is_crossing = is_crossing || meet_out_of_place(rectangles[f], rectangles[g]);

    Array<std::uint32_t> faces;
    const auto message = embedding_fault(both, &faces);
    ++seen[faces.size()];
    if (is_crossing) {
      ASSERT_EQ(faces.size(), 2u) << message.value_or("");
      EXPECT_TRUE(meet_out_of_place(rectangles[faces[0]], rectangles[faces[1]])) << *message;
    } else {
      EXPECT_EQ(faces.size(), message ? 1u : 0u);
    }
  }
  if (case_count(1000) >= 1000) {
    for (const int count : seen) EXPECT_GT(count, 4);
  }
}

// A face of two pieces is two faces; a pinched one is none.
TEST(Embedding, FacesOfSeveralPieces) {
  const Body two = together(normal_form(box({0, 0, 0}, {2, 2, 2})), normal_form(box({4, 0, 0}, {6, 2, 2})));
  ASSERT_FALSE(embedding_fault(two));
  Body joined = two;
  const auto plane_less = [](const exact::Plane& p, const exact::Plane& q) {
    return std::tie(p.n, p.d) < std::tie(q.n, q.d);
  };
  std::map<exact::Plane, std::vector<std::uint32_t>, decltype(plane_less)> by_plane(plane_less);
  for (std::uint32_t p = 0; p < two.polygon_count(); ++p) by_plane[two.planes[p]].push_back(p);
  joined.planes = {};
  joined.polygons.corners = {};
  joined.polygons.loop_start = joined.polygons.face_start = {0};
  for (const auto& [plane, members] : by_plane) {
    joined.planes.push_back(plane);
    for (std::uint32_t p : members) {
      two.for_corners(static_cast<std::uint32_t>(two.triangles.size()) + p,
                      [&](std::uint32_t v) { joined.polygons.corners.push_back(v); });
      joined.polygons.loop_start.push_back(static_cast<std::uint32_t>(joined.polygons.corners.size()));
    }
    joined.polygons.face_start.push_back(static_cast<std::uint32_t>(joined.polygons.loop_start.size() - 1));
  }
  ASSERT_LT(joined.polygon_count(), two.polygon_count());
  ASSERT_EQ(fault(joined).value_or(""), "");
  Array<std::uint32_t> faces;
  EXPECT_TRUE(embedding_fault(joined, &faces));
  // The two pieces are of one face, and meet no other out of place.
  EXPECT_EQ(faces.size(), 1u);
}

}  // namespace
}  // namespace quoin::booleans::testing
