// Models and motions: construction histories, evaluated as one arrangement on the grid.
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "examples/gear_box.h"
#include "tests/api/long_numbers.h"
#include "tests/api/solids.h"

namespace quoin {
namespace {

using api_test::random_engine;
using api_test::volume;

Solid evaluated(const Model& model, const ModelOptions& options = {}, MotionReport* report = nullptr) {
  auto solid = evaluate(model, options, report);
  if (!solid) {
    const Error& e = solid.error();
    ADD_FAILURE() << e.code << ": " << e.message << " (" << e.where << ")";
    return {};
  }
  return std::move(solid).value();
}

ModelOptions on_grid(const std::string& step) { return {.grid = Grid::with_step(step).value()}; }

Model block(const std::string& a, const std::string& b, const std::string& c) { return Model::block({a, b, c}); }

std::string text(std::int64_t v) { return std::to_string(v); }

/// A direction of small integers, not 0.
Text3 random_axis(std::mt19937_64& random) {
  for (;;) {
    std::array<std::int64_t, 3> v{};
    for (auto& x : v) x = static_cast<std::int64_t>(random() % 11) - 5;
    if (v[0] != 0 || v[1] != 0 || v[2] != 0) return {text(v[0]), text(v[1]), text(v[2])};
  }
}

/// A decimal of four places within +-limit.
std::string random_decimal(std::mt19937_64& random, int limit) {
  const auto v = static_cast<std::int64_t>(random() % (20000u * static_cast<unsigned>(limit))) - 10000 * limit;
  return text(v) + "e-4";
}

Model randomly_moved(const Model& model, std::mt19937_64& random) {
  return model.rotated(random_axis(random), random_decimal(random, 180))
      .translated({random_decimal(random, 3), random_decimal(random, 3), random_decimal(random, 3)});
}

int cases(int fallback) {
  const char* value = std::getenv("QUOIN_CASES");
  return value != nullptr ? std::atoi(value) : fallback;
}

// E13: two blocks with a hole.
TEST(Model, BracketHasNoInnerWall) {
  const Solid solid = evaluated(examples::bracket_variants()[0], on_grid("1/1000"));
  EXPECT_EQ(volume(solid), "60");
  EXPECT_EQ(solid.info().genus, 1);
  EXPECT_EQ(solid.classify({1, 1, 0.5}), Location::inside);
  EXPECT_EQ(solid.classify({2, 1, 0.3}), Location::inside);
  EXPECT_EQ(solid.info().faces, 12U);
}

TEST(Model, UnionOfBracketVariants) {
  const std::vector<Model> variants = examples::bracket_variants();
  const Solid all = evaluated(Model::unite(variants), on_grid("1/1000"));
  // What one variant lacks another has: the angle and the rib.
  EXPECT_EQ(volume(all), "153/2");
  EXPECT_EQ(all.info().faces, 11U);
  EXPECT_EQ(all.info().genus, 0);
  std::mt19937_64 random = random_engine();
  for (int i = 0; i < cases(10); ++i) {
    const Solid turned = evaluated(randomly_moved(Model::unite(variants), random), on_grid("1/1000000"));
    EXPECT_EQ(turned.info().faces, 11U);
    EXPECT_EQ(turned.info().shells, 1U);
  }
}

// No floating-point engine keeps this: faces that coincide do so wherever they are moved.
TEST(Model, BlocksThatShareAFaceUniteWhereverTheyAre) {
  std::mt19937_64 random = random_engine();
  const Model two = block("1", "2", "3") + block("1", "2", "3").translated({"1", "0", "0"});
  std::vector<Model> row;
  for (int i = 0; i < 10; ++i) row.push_back(block("1/3", "1", "1/7").translated({text(i) + "/3", "0", "0"}));
  const Model ten = Model::unite(row);
  for (int i = 0; i < cases(60); ++i) {
    for (const Model* model : {&two, &ten}) {
      MotionReport report;
      const Solid solid = evaluated(randomly_moved(*model, random), {}, &report);
      const Info info = solid.info();
      ASSERT_EQ(info.faces, 6U) << i;
      ASSERT_EQ(info.vertices, 8U) << i;
      ASSERT_EQ(info.shells, 1U) << i;
      ASSERT_EQ(report.by_vertices, 0U);
      ASSERT_EQ(report.face_local_planes, 0U);
    }
  }
}

TEST(Model, ThereAndBackIsTheSameSolid) {
  std::mt19937_64 random = random_engine();
  const Model part = examples::bracket_variants()[3];
  const std::string start = evaluated(part, on_grid("1/4096")).to_quoin();
  for (int i = 0; i < 20; ++i) {
    const Text3 axis = random_axis(random), by{random_decimal(random, 9), "1/3", random_decimal(random, 9)};
    const std::string angle = random_decimal(random, 180);
    const Model back = part.rotated(axis, angle)
                           .translated(by)
                           .translated({"-(" + by[0] + ")", "-1/3", "-(" + by[2] + ")"})
                           .rotated(axis, "-(" + angle + ")");
    EXPECT_EQ(evaluated(back, on_grid("1/4096")).to_quoin(), start);
  }
}

TEST(Model, TenThousandSmallMotionsRoundOnce) {
  const Model part = block("3", "2", "1") + block("1", "1", "4");
  Model turned = part;
  for (int i = 0; i < cases(1000); ++i)
    turned = turned.rotated({"0", "0", "1"}, "0.001").translated({"0", "0", "1/1000"});
  MotionReport report;
  const Solid many = evaluated(turned, on_grid("1/1024"), &report);
  // Rotations about z and translations along it alternate: they are composed, exactly, not added.
  EXPECT_LT(report.displacement, 1e-12);
  EXPECT_EQ(many.info().faces, evaluated(part, on_grid("1/1024")).info().faces);
  Model spun = part;
  for (int i = 0; i < 10000; ++i) spun = spun.rotated({"0", "0", "1"}, "0.036");
  EXPECT_EQ(evaluated(spun, on_grid("1/1024")).to_quoin(), evaluated(part, on_grid("1/1024")).to_quoin());
}

TEST(Model, GearBoxAfterAFullTurnIsTheSameSolid) {
  const Model part = examples::gear_box();
  MotionReport report;
  const Solid start = evaluated(part, {}, &report);
  EXPECT_GE(report.primitives, 200U);
  EXPECT_EQ(report.by_vertices, 0U);
  Model turned = part;
  for (int i = 0; i < 360; ++i) turned = turned.rotated({"0", "0", "1"}, "1");
  const Solid end = evaluated(turned);
  EXPECT_EQ(end.to_quoin(), start.to_quoin());
  // On the way it is the same part, turned.
  const Solid way = evaluated(part.rotated({"0", "0", "1"}, "37"));
  const Info a = start.info(), b = way.info();
  EXPECT_EQ(a.faces, b.faces);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.genus, b.genus);
  EXPECT_EQ(a.shells, b.shells);
}

TEST(Model, GearsTurnInTheirBox) {
  const Solid start = evaluated(examples::gear_box());
  EXPECT_EQ(start.info().shells, 3U);
  ModelOptions options;
  for (const char* turn : {"7.3", "-100/3", "180"}) {
    options.parameters["turn"] = turn;
    const Info a = evaluated(examples::gear_box(), options).info(), b = start.info();
    EXPECT_EQ(std::tie(a.faces, a.edges, a.vertices, a.genus, a.shells),
              std::tie(b.faces, b.edges, b.vertices, b.genus, b.shells))
        << turn;
    EXPECT_EQ(std::round(1e9 * a.volume_approx), std::round(1e9 * b.volume_approx));
  }
  options.parameters["turn"] = "360";
  EXPECT_EQ(evaluated(examples::gear_box(), options).to_quoin(), start.to_quoin());
}

TEST(Model, HalfSpacesAndHulls) {
  const Model half = Model::half_space({"0", "0", "1", "-1/2"});
  EXPECT_EQ(volume(evaluated(block("1", "1", "1") & half)), "1/2");
  EXPECT_EQ(volume(evaluated(block("1", "1", "1") - half)), "1/2");
  EXPECT_FALSE(evaluated(Model::complement(block("1", "1", "1"))).is_bounded());
  EXPECT_EQ(evaluate(half).error().code, ErrorCode::unbounded);
  EXPECT_TRUE(evaluated(Model()).is_empty());
  EXPECT_EQ(volume(evaluated(Model::convex({{"1", "0", "0", "-1"},
                                            {"-1", "0", "0", "0"},
                                            {"0", "1", "0", "-1"},
                                            {"0", "-1", "0", "0"},
                                            {"0", "0", "1", "-1"},
                                            {"0", "0", "-1", "0"}}))),
            "1");
  EXPECT_EQ(evaluate(Model::convex({{"1", "0", "0", "-1"}})).error().code, ErrorCode::unbounded);
  MotionReport report;
  const Solid ball = evaluated(Model::tangent_sphere("1", "100").rotated({"1", "2", "3"}, "10"), {}, &report);
  EXPECT_EQ(ball.info().faces, 100U);
  EXPECT_EQ(report.by_planes, 1U);
}

// E32: a term whose box misses the box of all else changes nothing; nor does one inside, or around, another.
TEST(Model, RedundantTermsChangeNothing) {
  const auto plate = [](const char* x, const char* y, const char* a, const char* b) {
    return block(a, b, "1").translated({x, y, "0"});
  };
  const Model a = plate("0", "0", "2", "2"), b = plate("1", "1", "3", "2"), c = plate("3", "0", "2", "2"),
              d = plate("6", "6", "1", "1");
  const Model whole = (a + b) & (c + d);
  EXPECT_EQ(evaluated(whole, on_grid("1")), evaluated((a + b) & c, on_grid("1")));
  EXPECT_NE(volume(evaluated(whole, on_grid("1"))), volume(evaluated((a + b) & d, on_grid("1"))));
  EXPECT_EQ(evaluated(d + plate("5", "5", "3", "3"), on_grid("1")), evaluated(plate("5", "5", "3", "3"), on_grid("1")));
  EXPECT_EQ(evaluated(d & plate("5", "5", "3", "3"), on_grid("1")), evaluated(d, on_grid("1")));
}

TEST(Model, HalfSpacesMoveWithTheOthers) {
  std::mt19937_64 random = random_engine();
  // The half-space's plane is that of the block's face: it cuts nothing, or all.
  const Model face = Model::half_space({"1", "0", "0", "-1"});
  for (int i = 0; i < 20; ++i) {
    std::mt19937_64 again = random;
    const Solid whole = evaluated(randomly_moved(block("1", "2", "3") & face, random));
    EXPECT_EQ(whole.to_quoin(), evaluated(randomly_moved(block("1", "2", "3"), again)).to_quoin());
  }
}

std::string code(const Model& model) {
  const auto solid = evaluate(model);
  return solid ? "" : to_string(solid.error().code);
}

TEST(Model, ParametersAndErrors) {
  const Model part = block("w", "w*2", "h").with_parameters({{"w", "2"}, {"h", "w/4"}});
  EXPECT_EQ(volume(evaluated(part)), "4");
  ModelOptions options;
  options.parameters = {{"w", "4"}};
  EXPECT_EQ(volume(evaluated(part, options)), "32");
  EXPECT_EQ(code(block("v", "1", "1")), "bad-parameter");
  EXPECT_EQ(code(block("1+", "1", "1")), "bad-number");
  EXPECT_EQ(code(block("0", "1", "1")), "bad-primitive");
  EXPECT_EQ(code(block("1", "1", "1").rotated({"0", "0", "0"}, "1")), "bad-axis");
  EXPECT_EQ(code(block("1", "1", "1").scaled({"1", "-1", "1"})), "bad-factor");
  EXPECT_EQ(code(block("1", "1", "1").transformed({Text3{"2", "0", "0"}, {"0", "1", "0"}, {"0", "0", "1"}})),
            "not-a-rotation");
  const Error e = evaluate(block("1", "1", "1") + block("-1", "1", "1").named("lid")).error();
  EXPECT_EQ(e.where, "block \"lid\"");
  EXPECT_EQ(evaluate(block("1", "1", "1").translated({"1e9", "0", "0"}), on_grid("1")).error().code,
            ErrorCode::out_of_range);
}

// A text has at most 4,000 digits; what formulas make of it may have more.
TEST(Model, FormulasMakeLongNumbers) {
  std::string big = "a";
  for (int i = 0; i < 11; ++i) big += "*a";
  const auto result = [](const Model& model) {
    return evaluated(model.with_parameters({{"a", "1e400"}}), on_grid("1/1024"));
  };
  const Model part = block("2", "1", "1");
  EXPECT_EQ(result(part.rotated({big, "0", "0"}, "360/4")), result(part.rotated({"1", "0", "0"}, "90")));
  EXPECT_EQ(result(part.translated({big, "0", "0"}).translated({"-" + big, "0", "0"})), result(part));
  EXPECT_EQ(result(part.turned({"0", "0", "0", big}).turned({"0", "0", "0", "1"})), result(part));
}

TEST(Model, TangentSpheresOfAnyRadius) {
  const Solid unit = evaluated(Model::tangent_sphere("1", "12"), on_grid("1/1048576"));
  for (const char* radius : {"1.2345678901", "1e-9", "1e20", "100/3333333331"}) {
    MotionReport report;
    const auto solid = evaluate(Model::tangent_sphere(radius, "12"), {}, &report);
    ASSERT_TRUE(solid) << radius << ' ' << solid.error().message;
    EXPECT_EQ(solid.value().info().faces, unit.info().faces);
    EXPECT_EQ(report.by_planes, 1U);
  }
  EXPECT_EQ(evaluate(Model::tangent_sphere("0", "12")).error().code, ErrorCode::bad_primitive);
  EXPECT_EQ(evaluate(Model::tangent_sphere("-1", "12")).error().code, ErrorCode::bad_primitive);
}

TEST(Model, HalfSpacesOfLongNumbers) {
  auto planes = api_test::planes_of_long_numbers();
  MotionReport report;
  const Solid solid = evaluated(Model::convex(planes), {}, &report);
  EXPECT_EQ(solid.info().faces, 8U);
  EXPECT_EQ(solid.info().vertices, 6U);
  // 4/3 a^3, a = sqrt(3).
  EXPECT_EQ(std::round(1e6 * solid.info().volume_approx), std::round(1e6 * 4 * std::sqrt(3.0)));
  EXPECT_EQ(code(Model::convex({planes[0], planes[1], planes[2]})), "unbounded");
  // Nothing is on both sides.
  const std::string third = "0.5773502691896257645091487805019574556476";
  planes.push_back({third, third, third, "2"});
  EXPECT_EQ(code(Model::convex(planes)), "bad-primitive");
}

TEST(Model, NumbersBeyondTheDoubles) {
  for (const char* size : {"1e308", "1e309", "1e399"})
    EXPECT_EQ(evaluate(block(size, "1", "1")).error().code, ErrorCode::out_of_range) << size;
  // Of several the one that is too far.
  const auto far = evaluate(block("1", "1", "1") + block("1", "1e309", "1").named("pole"));
  ASSERT_FALSE(far);
  EXPECT_EQ(far.error().where.rfind("block \"pole\", vertex ", 0), 0U) << far.error().where;
  EXPECT_NE(far.error().where.find(", 1.797"), std::string::npos) << far.error().where;
  MotionReport report;
  const Model part = block("1e340", "1e340", "1e340").rotated({"0", "0", "1"}, "30").with_step("1e336");
  ASSERT_TRUE(evaluate(part, {}, &report));
  EXPECT_NE(report.displacement_bound, "0");
  EXPECT_NE(report.displacement_bound[0], '-');
}

TEST(Model, MirrorsAndScalings) {
  const Model part = examples::bracket_variants()[3];
  const Solid start = evaluated(part, on_grid("1/1024"));
  EXPECT_EQ(evaluated(part.mirrored({"1", "2", "0"}).mirrored({"1", "2", "0"}), on_grid("1/1024")), start);
  EXPECT_EQ(evaluated(part.mirrored({"1", "0", "0"}), on_grid("1/1024")).volume(), start.volume());
  EXPECT_EQ(volume(evaluated(examples::bracket_variants()[0].scaled({"2", "1", "1/3"}), on_grid("1/1024"))), "40");
}

TEST(Model, ProgressRunsFromNothingToAll) {
  std::vector<double> seen;
  Options run;
  run.progress = [&](double done) { seen.push_back(done); };
  const auto check = [&](std::size_t least) {
    EXPECT_GE(seen.size(), least);
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    if (!seen.empty()) {
      EXPECT_GE(seen.front(), 0);
      EXPECT_EQ(seen.back(), 1);
    }
    seen.clear();
  };
  const Model part = (block("3", "2", "1") - Model::cylinder("1/2", "1", "12")).rotated({"1", "2", "3"}, "10");
  const auto solid = evaluate(part, {.run = run});
  ASSERT_TRUE(solid);
  check(18);  // faces and primitives
  const Motion turn = Motion::rotation({"0", "0", "1"}, "1").value();
  for (const Solid& s : {solid.value(), ~solid.value()}) {
    ASSERT_TRUE(quoin::moved(s, turn, {.run = run}));
    check(4);
    ASSERT_TRUE(quoin::moved(s, turn, {.rounding = Rounding::vertices, .run = run}));
    check(2);
  }
}

// Moving a solid that has no history.

TEST(Move, FlatFacesStayFlat) {
  const Solid part = evaluated(examples::bracket_variants()[1], on_grid("1/65536"));
  MotionReport report;
  const Motion motion =
      Motion::rotation({"0", "0", "1"}, "30").value().then(Motion::translation({"1", "2", "3"}).value());
  const auto moved = quoin::moved(part, motion, {}, &report);
  ASSERT_TRUE(moved);
  EXPECT_EQ(report.by_planes, 1U);
  EXPECT_LT(report.displacement, 1e-16);
  EXPECT_EQ(moved.value().info().faces, part.info().faces);
  EXPECT_EQ(moved.value().info().vertices, part.info().vertices);
  // Rounded corner by corner they do not.
  const auto rough = quoin::moved(part, motion, {.rounding = Rounding::vertices}, &report);
  ASSERT_TRUE(rough);
  EXPECT_EQ(report.by_vertices, 1U);
  EXPECT_GT(rough.value().info().faces, part.info().faces);
}

TEST(Move, ExactMotionsAndTheirInverses) {
  std::mt19937_64 random = random_engine();
  for (int i = 0; i < 30; ++i) {
    // Corners with many faces, too.
    const Solid solid = api_test::random_tetrahedron(random, 20) + api_test::random_tetrahedron(random, 20);
    Motion motion;
    for (int k = 0; k < 4; ++k)
      motion = motion
                   .then(Motion::rotation({k % 3 == 0 ? "1" : "0", k % 3 == 1 ? "1" : "0", k % 3 == 2 ? "1" : "0"},
                                          text(90 * static_cast<std::int64_t>(random() % 4)))
                             .value())
                   .then(Motion::translation({text(static_cast<std::int64_t>(random() % 9)), "-3", "0"}).value());
    MotionReport report;
    const auto there = quoin::moved(solid, motion, {}, &report);
    ASSERT_TRUE(there);
    EXPECT_EQ(report.displacement_bound, "0");
    EXPECT_EQ(there.value().volume(), solid.volume());
    EXPECT_EQ(quoin::moved(there.value(), motion.inverse()).value(), solid);
    EXPECT_EQ(quoin::moved(solid, motion.then(motion.inverse())).value().to_quoin(), solid.to_quoin());
  }
}

TEST(Move, UnboundedAndEmptySolids) {
  const Motion motion = Motion::rotation({"1", "1", "0"}, "33").value();
  const Solid box = api_test::box({0, 0, 0}, {30, 20, 10});
  EXPECT_EQ(quoin::moved(~box, motion).value(), ~quoin::moved(box, motion).value());
  EXPECT_TRUE(quoin::moved(Solid(), motion).value().is_empty());
  EXPECT_FALSE(quoin::moved(Solid::full(Grid()), motion).value().is_bounded());
}

TEST(Move, OutOfRangeNamesAStepThatWorks) {
  const Solid box = api_test::box({0, 0, 0}, {30, 20, 10});
  const Motion far = Motion::translation({"1e9", "0", "0"}).value();
  const Error e = quoin::moved(box, far).error();
  EXPECT_EQ(e.code, ErrorCode::out_of_range);
  EXPECT_NE(e.message.find("a step 2 times as large"), std::string::npos) << e.message;
  const auto coarse = box.on_grid(Grid::with_step("2").value());
  ASSERT_TRUE(coarse);
  EXPECT_TRUE(quoin::moved(coarse.value(), far));
}

TEST(Move, BakedDriftStaysWithinTheCertificates) {
  // A block turned by 1 degree 360 times, rounded every time.
  const Solid start = evaluated(block("3", "2", "1").translated({"1", "1", "1"}), on_grid("1/1048576"));
  const Motion step = Motion::rotation({"0", "0", "1"}, "1").value();
  Solid solid = start;
  double allowed = 0;
  for (int i = 0; i < 360; ++i) {
    MotionReport report;
    auto next = quoin::moved(solid, step, {}, &report);
    ASSERT_TRUE(next);
    ASSERT_EQ(report.by_planes, 1U);
    allowed += report.displacement;
    solid = std::move(next).value();
  }
  EXPECT_LT(allowed, 1e-15);
  // Grown and shrunk by the bound, the start contains the end and is contained in it.
  const auto grown = [&](double by) {
    char low[64], high[3][64];
    std::snprintf(low, sizeof low, "%.20f", 1 - by);
    for (int k = 0; k < 3; ++k) std::snprintf(high[k], sizeof high[k], "%.20f", 3 - k + 2 * by);
    return evaluated(block(high[0], high[1], high[2]).translated({low, low, low}), on_grid("1/1048576"));
  };
  EXPECT_TRUE((solid - grown(2e-15)).is_empty());
  EXPECT_TRUE((grown(-2e-15) - solid).is_empty());
}

TEST(Motion, WhatIsCarriedOut) {
  const MotionInfo quarter = Motion::rotation({"0", "0", "2"}, "90").value().info();
  EXPECT_EQ(quarter.angle_error, 0);
  EXPECT_EQ(*quarter.quaternion, (std::array<std::string, 4>{"1", "0", "0", "1"}));
  EXPECT_EQ(quarter.linear[0], (Text3{"0", "-1", "0"}));
  EXPECT_FALSE(Motion::mirror({"1", "0", "0"}).value().info().quaternion);
  Motion turn;
  for (int i = 0; i < 360; ++i) turn = turn.then(Motion::rotation({"0", "1", "0"}, "1").value());
  EXPECT_EQ(turn, Motion());
  EXPECT_EQ(Motion::rotation({"0", "0", "0"}, "1").error().code, ErrorCode::bad_axis);
  EXPECT_EQ(Motion::rotation({"0", "0", "1"}, "ten").error().code, ErrorCode::bad_number);
  EXPECT_EQ(Motion::scaling({"0", "1", "1"}).error().code, ErrorCode::bad_factor);
  EXPECT_EQ(Motion::quaternion({"0", "0", "0", "0"}).error().code, ErrorCode::bad_axis);
  double deviation = -1;
  const auto near = Motion::matrix({Text3{"0.8", "-0.6", "0"}, {"0.6", "0.8", "0"}, {"0", "0", "1"}}, &deviation);
  ASSERT_TRUE(near);
  EXPECT_EQ(deviation, 0);
  EXPECT_EQ(near.value(), Motion::quaternion({"3", "0", "0", "1"}).value());
  EXPECT_EQ(Motion::matrix({Text3{"1", "0", "0"}, {"0", "1", "0"}, {"0", "0", "-1"}}).error().code,
            ErrorCode::not_a_rotation);
}

}  // namespace
}  // namespace quoin
