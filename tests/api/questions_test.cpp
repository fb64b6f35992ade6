#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/api/solids.h"

namespace quoin::api_test {
namespace {

constexpr Location in = Location::inside, out = Location::outside, on = Location::boundary;

struct Times {
  std::vector<std::string> begin, end;
};
Times times(const Passage& p) {
  Times r;
  for (const Contact& c : p.contacts) {
    r.begin.push_back(c.begin.exact);
    r.end.push_back(c.end.exact);
  }
  return r;
}
using Texts = std::vector<std::string>;

/// The faces of a box in canonical order, by their planes (-1, 0, 0), (0, -1, 0), (0, 0, -1), (0, 0, 1), ..
enum Side : std::uint32_t { low_x, low_y, low_z, high_z, high_y, high_x };

TEST(Questions, LineThroughAPrism) {  // E14: the square prism about the cylinder
  const Questions prism(box({-1, -1, 0}, {1, 1, 2}));
  const auto p = prism.ray({2, 0, 0}, {-2, 0, 1}).value();
  EXPECT_EQ(p.start, out);
  EXPECT_EQ(times(p).begin, (Texts{"1/2", "3/2"}));
  EXPECT_EQ(times(p).end, (Texts{"1/2", "3/2"}));
  EXPECT_EQ(p.contacts[0].before, out);
  EXPECT_EQ(p.contacts[0].behind, in);
  EXPECT_EQ(p.contacts[1].before, in);
  EXPECT_EQ(p.contacts[1].behind, out);
  EXPECT_EQ(p.contacts[0].faces, std::vector<std::uint32_t>{high_x});
  EXPECT_EQ(p.contacts[1].faces, std::vector<std::uint32_t>{low_x});
  EXPECT_EQ(p.contacts[0].begin.rounded, 0.5);
}

TEST(Questions, TouchingAndLyingIn) {
  const Questions cube(box({0, 0, 0}, {1, 1, 1}));

  // Through two opposite corners, in decimals.
  const auto diagonal = cube.ray({"-0.1", "-1e-1", "-1/10"}, {"1", "1", "1"}).value();
  EXPECT_EQ(times(diagonal).begin, (Texts{"1/10", "11/10"}));
  EXPECT_EQ(diagonal.contacts[0].faces, (std::vector<std::uint32_t>{low_x, low_y, low_z}));
  EXPECT_EQ(diagonal.contacts[1].faces, (std::vector<std::uint32_t>{high_z, high_y, high_x}));

  // It touches an edge.
  const auto touching = cube.ray({2, 0, .5}, {-1, 1, 0}).value();
  EXPECT_EQ(times(touching).begin, Texts{"1"});
  EXPECT_EQ(touching.contacts[0].before, out);
  EXPECT_EQ(touching.contacts[0].behind, out);
  EXPECT_EQ(touching.contacts[0].faces, (std::vector<std::uint32_t>{high_y, high_x}));

  // In a face, along an edge, from within an edge.
  const auto lying = cube.segment({-1, .5, 1}, {3, .5, 1}).value();
  EXPECT_EQ(times(lying).begin, Texts{"1/4"});
  EXPECT_EQ(times(lying).end, Texts{"1/2"});
  EXPECT_EQ(lying.contacts[0].faces, (std::vector<std::uint32_t>{low_x, high_z, high_x}));
  const auto from_edge = cube.ray({.5, 1, 1}, {1, 0, 0}).value();
  EXPECT_EQ(from_edge.start, on);
  EXPECT_EQ(times(from_edge).begin, Texts{"0"});
  EXPECT_EQ(times(from_edge).end, Texts{"1/2"});
  EXPECT_EQ(from_edge.contacts[0].before, on);
  EXPECT_EQ(from_edge.contacts[0].behind, out);
  EXPECT_EQ(from_edge.contacts[0].faces, (std::vector<std::uint32_t>{high_z, high_y, high_x}));

  // It ends in the face that it comes to, and within one.
  const auto ending = cube.segment({.5, .5, .5}, {.5, .5, 1}).value();
  EXPECT_EQ(ending.start, in);
  EXPECT_EQ(times(ending).begin, Texts{"1"});
  EXPECT_EQ(ending.contacts[0].before, in);
  EXPECT_EQ(ending.contacts[0].behind, out);
  EXPECT_EQ(cube.segment({-1, .5, 1}, {.5, .5, 1})->contacts[0].behind, on);
  EXPECT_TRUE(cube.segment({.5, .5, .5}, {.5, .5, .75})->contacts.empty());
}

TEST(Questions, NumbersOfAnySize) {
  const Questions cube(box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(times(*cube.segment({-1e300, .5, .5}, {1e300, .5, .5})).begin.size(), 2u);
  EXPECT_EQ(cube.ray({.5, .5, .5}, {0x1p-1000, 0, 0})->contacts[0].begin.rounded, 0x1p999);
  EXPECT_EQ(cube.ray({.5, .5, .5}, {5e-324, 1e308, 0})->contacts[0].faces, std::vector<std::uint32_t>{high_y});
  EXPECT_EQ(cube.classify({1e308, -1e308, 5e-324}), out);
  EXPECT_EQ(cube.classify({5e-324, .5, .5}), in);
  EXPECT_EQ(cube.classify({-5e-324, .5, .5}), out);
  EXPECT_EQ(cube.classify({-0.0, .5, .5}), on);
  const std::string nearly = "0." + std::string(300, '9');
  EXPECT_EQ(cube.ray({nearly, "1/2", "1/2"}, {"1", "0", "0"})->contacts[0].begin.exact, "1/1" + std::string(300, '0'));
}

TEST(Questions, WhatIsNoLineIsRefused) {
  const Questions cube(box({0, 0, 0}, {1, 1, 1}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(cube.ray({0, nan, 0}, {1, 0, 0}).error().code, ErrorCode::non_finite);
  EXPECT_EQ(cube.ray({0, 0, 0}, {0, 0, -0.0}).error().code, ErrorCode::bad_axis);
  EXPECT_EQ(cube.segment({1, 2, 3}, {1, 2, 3}).error().code, ErrorCode::bad_axis);
  const auto word = cube.segment({"0", "0", "0"}, {"1", "one", "1"});
  EXPECT_EQ(word.error().code, ErrorCode::bad_number);
  EXPECT_EQ(word.error().where, "to, y");
  const auto points = cube.classify(std::vector<double>{0, 0, 0, 0, 0, nan});
  EXPECT_EQ(points.error().code, ErrorCode::non_finite);
  EXPECT_EQ(points.error().where, "point 1");
  Options run;
  const Cancel cancel = true;
  run.cancel = &cancel;
  EXPECT_EQ(cube.classify(std::vector<double>{0, 0, 0}, run).error().code, ErrorCode::cancelled);
}

// Against Solid::classify, which looks at every face; any number of threads, floats too.
TEST(Questions, ManyPointsAtOnce) {
  auto random = random_engine();
  const Grid grid = Grid::with_step_and_origin("1/3", {"1/7", "0", "-2"}).value();
  Solid solid = random_tetrahedron(random, 4, grid_of("1"));
  for (int i = 0; i < 6; ++i) solid = solid ^ random_tetrahedron(random, 4, grid_of("1"));
  const Solid bored = solid.on_grid(grid) ? solid.on_grid(grid).value() : solid;

  std::vector<double> points;
  std::vector<float> floats;
  for (int i = 0; i < 3 * 5000; ++i) {
    floats.push_back(static_cast<float>(random() % 33) / 4 - 4);
    points.push_back(floats.back());
  }
  const Questions questions(bored);
  Options one;
  one.threads = 1;
  const auto found = questions.classify(points).value();
  EXPECT_EQ(found, questions.classify(points, one).value());
  EXPECT_EQ(found, questions.classify(floats).value());
  ASSERT_EQ(found.size(), 5000u);
  for (std::size_t i = 0; i < 500; ++i)
    EXPECT_EQ(found[i], bored.classify({points[3 * i], points[3 * i + 1], points[3 * i + 2]}));
  for (const Location where : {in, on, out}) EXPECT_GT(std::count(found.begin(), found.end(), where), 0);
  EXPECT_TRUE(questions.classify(std::vector<double>{}).value().empty());
}

TEST(Questions, NearestInModelUnits) {
  const Grid grid = Grid::with_step_and_origin("1/2", {"1/2", "0", "-3"}).value();
  const Questions questions(box({.5, 0, -3}, {2.5, 3, 1}, grid));
  const Nearest corner = questions.nearest({3.5, 4, 3}).value();
  EXPECT_EQ(corner.squared_distance.exact, "6");
  EXPECT_EQ(corner.point[0].exact, "5/2");
  EXPECT_EQ(corner.point[1].exact, "3");
  EXPECT_EQ(corner.point[2].rounded, 1.0);
  EXPECT_EQ(corner.faces, (std::vector<std::uint32_t>{high_z, high_y, high_x}));
  EXPECT_EQ(corner.where, out);
  const Nearest within = questions.nearest({1.25, 1.5, -1}).value();
  EXPECT_EQ(within.squared_distance.exact, "9/16");
  EXPECT_EQ(within.point[0].exact, "1/2");
  EXPECT_EQ(within.where, in);
  EXPECT_EQ(questions.nearest({.5, 1, 1})->where, on);
  EXPECT_FALSE(Questions(Solid::full(Grid())).nearest({0, 0, 0}));
}

TEST(Questions, Interference) {
  const auto meet = [](const Solid& a, const Solid& b) {
    const Questions p(a), q(b);
    const Interference found = interference(p, q).value();
    EXPECT_EQ(found, interference(q, p).value());
    return found;
  };
  constexpr auto apart = Interference::apart, touching = Interference::touching,
                 overlapping = Interference::overlapping;
  const Solid cube = box({0, 0, 0}, {2, 2, 2});
  EXPECT_EQ(meet(cube, box({3, 0, 0}, {4, 2, 2})), apart);
  EXPECT_EQ(meet(cube, box({2, 1, 1}, {4, 5, 5})), touching);        // faces on each other
  EXPECT_EQ(meet(cube, box({2, 2, 0}, {4, 5, 5})), touching);        // an edge
  EXPECT_EQ(meet(cube, box({2, 2, 2}, {4, 5, 5})), touching);        // a corner
  EXPECT_EQ(meet(cube, box({1, 1, 1}, {4, 5, 5})), overlapping);     // they cross
  EXPECT_EQ(meet(cube, box({-1, -1, -1}, {4, 5, 5})), overlapping);  // one within the other
  EXPECT_EQ(meet(cube, box({0, 0, 0}, {2, 2, 1})), overlapping);     // within, faces on each other
  EXPECT_EQ(meet(cube, cube), overlapping);
  EXPECT_EQ(meet(cube, ~cube), touching);
  EXPECT_EQ(meet(~cube, ~box({5, 5, 5}, {6, 6, 6})), overlapping);
  EXPECT_EQ(meet(cube, Solid()), apart);
  EXPECT_EQ(meet(cube, Solid::full(Grid())), overlapping);
  EXPECT_EQ(meet(Solid(), Solid::full(Grid())), apart);
  const Solid shell = box({-9, -9, -9}, {9, 9, 9}) - box({-4, -4, -4}, {4, 4, 4});
  EXPECT_EQ(meet(cube, shell), apart);  // in its void
  EXPECT_EQ(meet(cube, shell + box({1, 1, 1}, {4, 4, 4})), overlapping);

  const Solid fine = box({2, .5, .5}, {3, 1, 1}, grid_of("1/2"));
  EXPECT_EQ(meet(cube, fine), touching);
  const Solid thirds = Solid::from_triangles(box_mesh({0, 0, 0}, {1, 1, 1}).points, box_mesh({}, {}).triangles,
                                             Grid::with_step_and_origin("1", {"1/3", "0", "0"}).value())
                           .value();
  EXPECT_EQ(meet(cube, thirds), overlapping);
}

TEST(Questions, MassOfABox) {
  const Grid grid = Grid::with_step_and_origin("1/2", {"1/2", "0", "-3"}).value();
  const Questions questions(box({.5, 0, -3}, {2.5, 3, 1}, grid));
  const MassProperties m = questions.mass_properties().value();
  EXPECT_EQ(m.volume.exact, "24");
  EXPECT_EQ((*m.centroid)[0].exact, "3/2");
  EXPECT_EQ((*m.centroid)[1].exact, "3/2");
  EXPECT_EQ((*m.centroid)[2].exact, "-1");
  EXPECT_EQ(m.first[2].rounded, -24.0);
  EXPECT_EQ(m.second[2].exact, "56");  // 2 * 3 * (1 + 27) / 3
  EXPECT_EQ(m.second[5].exact, "54");
  const std::array<std::string, 6> inertia{"50", "40", "26", "0", "0", "0"};  // V (b b + c c) / 12
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ((*m.inertia)[k].exact, inertia[k]);
  const auto [low, high] = questions.area_bounds();
  EXPECT_LE(low, 52);
  EXPECT_GE(high, 52);
  EXPECT_LT(high - low, 1e-12);

  EXPECT_EQ(Questions(Solid()).mass_properties()->volume.exact, "0");
  EXPECT_FALSE(Questions(Solid()).mass_properties()->centroid);
  EXPECT_FALSE(Questions(Solid::full(Grid())).mass_properties());
}

// The product of inertia of a tetrahedron at the origin, by its formula.
TEST(Questions, MassOfATetrahedron) {
  const Solid corner = tetrahedron({Corner{0, 0, 0}, Corner{1, 0, 0}, Corner{0, 1, 0}, Corner{0, 0, 1}});
  const MassProperties m = Questions(corner).mass_properties().value();
  EXPECT_EQ(m.volume.exact, "1/6");
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ((*m.centroid)[k].exact, "1/4");
    EXPECT_EQ(m.second[k].exact, "1/60");
    EXPECT_EQ(m.second[3 + k].exact, "1/120");
    EXPECT_EQ((*m.inertia)[k].exact, "1/80");
    EXPECT_EQ((*m.inertia)[3 + k].exact, "1/480");
  }
}

TEST(Questions, SectionInModelUnits) {
  const Grid grid = Grid::with_step_and_origin("1/2", {"1/2", "0", "-3"}).value();
  const Questions questions(box({.5, 0, -3}, {2.5, 3, 1}, grid));
  const Section level = questions.section({{"0", "0", "1", "0.25"}}).value();
  EXPECT_EQ(level.area->exact, "6");
  EXPECT_LE(level.area_bounds[0], 6);
  EXPECT_GE(level.area_bounds[1], 6);
  ASSERT_EQ(level.vertices.size(), 4u);
  EXPECT_EQ(level.vertices[3][0].exact, "5/2");
  EXPECT_EQ(level.vertices[3][1].exact, "3");
  EXPECT_EQ(level.vertices[3][2].exact, "-1/4");
  EXPECT_EQ(level.polygons, (std::vector<std::vector<std::vector<std::uint32_t>>>{{{0, 2, 3, 1}}}));

  const Section slanted = questions.section({{"1", "0", "1", "0"}}).value();
  EXPECT_FALSE(slanted.area);
  EXPECT_LE(slanted.area_bounds[0], 6 * std::sqrt(2.) * (1 + 1e-15));
  EXPECT_GE(slanted.area_bounds[1], 6 * std::sqrt(2.) * (1 - 1e-15));
  EXPECT_LT(slanted.area_bounds[1] - slanted.area_bounds[0], 1e-14);

  EXPECT_TRUE(questions.section({{"0", "0", "1", "3"}})->polygons.empty());
  EXPECT_EQ(questions.section({{"0", "0", "0", "1"}}).error().code, ErrorCode::bad_plane);
  EXPECT_EQ(questions.section({{"0", "0", "z", "1"}}).error().code, ErrorCode::bad_plane);
  EXPECT_EQ(Questions(Solid::full(Grid())).section({{"0", "0", "1", "0"}}).error().code, ErrorCode::unbounded);
}

TEST(Questions, UnboundedAndEmpty) {
  EXPECT_EQ(Questions(Solid()).classify({0, 0, 0}), out);
  EXPECT_EQ(Questions(Solid::full(Grid())).classify({0, 0, 0}), in);
  const Questions outside(~box({0, 0, 0}, {1, 1, 1}));
  const auto p = outside.ray({-1, .5, .5}, {1, 0, 0}).value();
  EXPECT_EQ(p.start, in);
  ASSERT_EQ(p.contacts.size(), 2u);
  EXPECT_EQ(p.contacts[0].behind, out);
  EXPECT_EQ(p.contacts[1].behind, in);
}

// By label answers are the same, and name faces that carry something.
TEST(Questions, ByLabel) {
  auto random = random_engine();
  for (int round = 0; round < 30; ++round) {
    std::vector<Solid> pieces;
    for (std::uint32_t i = 0; i < 2; ++i)
      pieces.push_back(labelled(random_tetrahedron(random, 4), {i, "piece"}).value());
    const Solid solid = pieces[0] + pieces[1];
    const Questions plain(solid), by_label(solid, Faces::by_label);
    const Boundary boundary = solid.boundary(Faces::by_label);
    EXPECT_EQ(plain.mass_properties(), by_label.mass_properties());
    for (int k = 0; k < 20; ++k) {
      const auto coordinate = [&] { return static_cast<double>(random() % 21) / 2 - 5; };
      const Corner from{coordinate(), coordinate(), coordinate()}, direction{coordinate(), coordinate(), 1};
      const Passage a = plain.ray(from, direction).value(), b = by_label.ray(from, direction).value();
      ASSERT_EQ(times(a).begin, times(b).begin);
      ASSERT_EQ(times(a).end, times(b).end);
      for (const Contact& c : b.contacts)
        for (const std::uint32_t f : c.faces) {
          const FaceLabel label = boundary.label(f);
          ASSERT_LT(label.original, boundary.originals().size());
          const Solid& piece = pieces[boundary.originals()[label.original].id];
          // The contact is on the piece that its face comes from.
          const Passage own = Questions(piece).ray(from, direction).value();
          EXPECT_TRUE(std::any_of(own.contacts.begin(), own.contacts.end(), [&](const Contact& o) {
            return o.begin.rounded <= c.end.rounded && o.end.rounded >= c.begin.rounded;
          })) << round;
        }
    }
  }
}

}  // namespace
}  // namespace quoin::api_test
