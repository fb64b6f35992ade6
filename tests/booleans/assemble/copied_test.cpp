#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tests/booleans/assemble/making.h"

namespace quoin::booleans::testing {
namespace {

/// A face as numbers: its plane, then its loops from their least corner on; a triangle without its plane.
using Face = Array<std::int64_t>;

void add_plane(Face& face, const exact::Plane& p) {
  face.insert(face.end(), p.n.begin(), p.n.end());
  face.push_back(static_cast<std::int64_t>(p.d >> 64));
  face.push_back(static_cast<std::int64_t>(p.d));
}
void add_loop(Face& face, Array<std::uint32_t> loop, bool turned = false) {
  if (turned) std::reverse(loop.begin(), loop.end());
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  face.push_back(-1);
  face.insert(face.end(), loop.begin(), loop.end());
}

/// The untouched faces of the operands that stay, turned as they stay, from the operands themselves.
Array<Face> kept_faces(const Made& made, PointNumbers& numbers, bool raw) {
  Array<Face> faces;
  made.a.for_untouched([&](FaceId id, NodeId) {
    const auto [operand, f] = made.a.operands.own(id);
    const Body& body = made.a.operands[operand];
    const int kept = made.m.kept(id);
    if (kept == 0 || raw != (f < body.triangles.size())) return;
    Face& face = faces.emplace_back();
    Array<std::uint32_t> loop;
    if (raw) {
      for (const std::uint32_t v : body.triangles[f]) loop.push_back(numbers.of(body, v));
      return add_loop(face, loop, kept < 0);
    }
    add_plane(face, kept < 0 ? body.plane(f).opposite() : body.plane(f));
    body.polygons.for_loops(body.polygon(f), [&](std::span<const std::uint32_t> corners) {
      loop.clear();
      for (const std::uint32_t v : corners) loop.push_back(numbers.of(body, v));
      add_loop(face, loop, kept < 0);
    });
  });
  std::sort(faces.begin(), faces.end());
  return faces;
}

Array<Face> copied_triangles(const Made& made, PointNumbers& numbers) {
  Array<Face> faces;
  for (const Triangle& t : made.m.body.triangles) {
    Array<std::uint32_t> loop;
    for (const std::uint32_t v : t) loop.push_back(numbers.of(made.m.body, v));
    add_loop(faces.emplace_back(), loop);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// Those that are written, and those that wait.
Array<Face> copied_polygons(Made& made, PointNumbers& numbers) {
  Array<Face> faces;
  const auto add = [&](const auto& loops, std::size_t i, const exact::Plane& plane, auto number) {
    Face& face = faces.emplace_back();
    add_plane(face, plane);
    loops.for_loops(i, [&](const auto& corners) {
      Array<std::uint32_t> loop;
      for (const auto c : corners) loop.push_back(number(c));
      add_loop(face, loop);
    });
  };
  const Body& body = made.m.body;
  for (std::size_t i = 0; i < body.planes.size(); ++i)
    add(body.polygons, i, body.planes[i], [&](std::uint32_t c) { return numbers.of(body, ResultName::of_corner(c)); });
  for (std::size_t i = 0; i < made.m.waiting.size(); ++i) {
    const auto& [o, f] = made.m.waiting[i];
    std::map<PlaceId, std::uint32_t> number;
    made.a.operands[o].for_corners(
        f, [&, o = o](std::uint32_t v) { number[made.m.vertices.place(o, v)] = numbers.of(made.a.operands[o], v); });
    add(made.m.waiting_loops, i, made.m.kept_plane(made.m.waiting[i]), [&](PlaceId p) { return number.at(p); });
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// Chunks follow each other, and their boxes hold their faces.
template <class BoxOf>
void expect_chunks(const Array<Chunk>& chunks, std::uint32_t count, BoxOf box_of) {
  std::uint32_t next = 0;
  for (const Chunk& c : chunks) {
    EXPECT_EQ(c.begin, next);
    next = c.end;
    Box all = c.box;
    for (std::uint32_t f = c.begin; f < c.end; ++f) all.add(box_of(f));
    EXPECT_EQ(all.low, c.box.low);
    EXPECT_EQ(all.high, c.box.high);
  }
  EXPECT_EQ(next, count);
}

TEST(Copied, FacesThatStayAreCopiedAsTheyStay) {
  std::size_t triangles = 0, written = 0, waiting = 0;
  for_families(0xC09D, 40, [&](Solids& solids, Random& random) {
    const Array<Body> bodies{odd(solids.raw(), solids.raw()), solids.next(), solids.raw()};
    const Rule rule = random.one_in(2) ? Rule::odd : random.one_in(2) ? Rule::any : Rule::all;
    Made made(bodies, Expression::flat(rule, 3, random.one_in(2) ? 1 : none));
    Body& body = made.m.body;
    PointNumbers numbers;

    copy_raw(made.m);
    EXPECT_EQ(copied_triangles(made, numbers), kept_faces(made, numbers, true));
    expect_chunks(made.m.raw_chunks, static_cast<std::uint32_t>(body.triangles.size()),
                  [&](std::uint32_t f) { return face_box(body, f); });
    triangles += body.triangles.size();

    copy_polygons(made.m);
    EXPECT_EQ(copied_polygons(made, numbers), kept_faces(made, numbers, false));
    EXPECT_EQ(made.m.listed_polygons, body.planes.size());
    expect_chunks(made.m.polygon_chunks, made.m.listed_polygons, [&](std::uint32_t i) {
      Box all;
      for (const std::uint32_t c : body.polygons.corners_of(i)) {
        const ResultName name = ResultName::of_corner(c);
        if (name.is_derived())
          all.add_around(body.points[name.index()].approximation);
        else
          all.add(body.grid_points[name.index()]);
      }
      return all;
    });
    written += body.planes.size();
    waiting += made.m.waiting.size();

    // Each point once, whichever operands have it.
    std::set<exact::GridPoint> distinct(body.grid_points.begin(), body.grid_points.end());
    EXPECT_EQ(distinct.size(), body.grid_points.size());
  });
  EXPECT_GT(triangles, 50 * case_count(40));
  EXPECT_GT(written, case_count(40) / 8);
  EXPECT_GT(waiting, case_count(40));
}

// A polygon waits exactly where a vertex of it may be needed by what is touched.
TEST(Copied, PolygonsWithAVertexInTheTableWait) {
  for_families(0xC09E, 12, [&](Solids& solids, Random&) {
    const Array<Body> bodies{odd(solids.raw(), solids.raw()), solids.raw()};
    Made made(bodies, Expression::flat(Rule::odd, 2));
    copy_raw(made.m);
    copy_polygons(made.m);

    std::size_t near = 0, far = 0;
    for (const OperandId o : made.a.operands.ids())
      for (std::uint32_t f = static_cast<std::uint32_t>(bodies[o.value].triangles.size());
           f < bodies[o.value].face_count(); ++f) {
        if (made.m.kept(made.a.operands.face(o, f)) == 0) continue;
        bool in_table = false;
        bodies[o.value].for_corners(
            f, [&](std::uint32_t v) { in_table = in_table || made.a.names.operands[o].of(v) != none; });
        ++(in_table ? near : far);
      }
    EXPECT_EQ(made.m.waiting.size(), near);
    EXPECT_EQ(made.m.body.planes.size(), far);
  });
}

// What lies within a ball and is taken from it is turned round: a tetrahedron, and a plate with a pocket.
TEST(Copied, CavitiesAreTurnedRound) {
  const Body ball = *sphere({0, 0, 0}, 8, 8, [](std::uint32_t, std::uint32_t) { return 1000.0; });
  const Body tip = *tetrahedron({{{100, 0, 0}, {101, 0, 0}, {100, 1, 0}, {100, 0, 1}}});
  const Body plate = body_of(canonical(minus(box({0, 0, 0}, {6, 6, 2}), box({2, 2, 1}, {4, 4, 3}))));
  const Array<Body> bodies{tip, plate, ball};
  Made made(bodies, Expression::flat(Rule::odd, 3));
  copy_raw(made.m);
  copy_polygons(made.m);

  const Body& body = made.m.body;
  EXPECT_EQ(body.triangles.size(), 4 + ball.triangles.size());
  EXPECT_EQ(Array<Triangle>(body.triangles.begin(), body.triangles.begin() + 4),
            (Array<Triangle>{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}));
  Body cavity = body;
  cavity.triangles = {};
  EXPECT_EQ(dump(cavity), R"(face on [1 0 0 0]
  (0, 6, 0) (0, 6, 2) (0, 0, 2) (0, 0, 0)
face on [1 0 0 -4]
  (4, 4, 1) (4, 4, 2) (4, 2, 2) (4, 2, 1)
face on [0 1 0 0]
  (0, 0, 2) (6, 0, 2) (6, 0, 0) (0, 0, 0)
face on [0 1 0 -4]
  (2, 4, 2) (4, 4, 2) (4, 4, 1) (2, 4, 1)
face on [0 0 1 0]
  (6, 0, 0) (6, 6, 0) (0, 6, 0) (0, 0, 0)
face on [0 0 -1 2]
  (0, 6, 2) (6, 6, 2) (6, 0, 2) (0, 0, 2)
  (4, 2, 2) (4, 4, 2) (2, 4, 2) (2, 2, 2)
face on [0 0 -1 1]
  (2, 4, 1) (4, 4, 1) (4, 2, 1) (2, 2, 1)
face on [0 -1 0 6]
  (6, 6, 0) (6, 6, 2) (0, 6, 2) (0, 6, 0)
face on [0 -1 0 2]
  (4, 2, 1) (4, 2, 2) (2, 2, 2) (2, 2, 1)
face on [-1 0 0 6]
  (6, 0, 2) (6, 6, 2) (6, 6, 0) (6, 0, 0)
face on [-1 0 0 2]
  (2, 2, 2) (2, 4, 2) (2, 4, 1) (2, 2, 1)
)");
}

}  // namespace
}  // namespace quoin::booleans::testing
