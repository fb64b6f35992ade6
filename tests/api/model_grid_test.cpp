#include <gtest/gtest.h>

#include <cmath>

#include "tests/api/solids.h"

namespace quoin::api_test {
namespace {

/// On the grid that fits it.
Solid fitting_box(const Corner& low, const Corner& high) {
  const Mesh mesh = box_mesh(low, high);
  return Solid::from_triangles(mesh.points, mesh.triangles).value();
}

Solid skew_tetrahedron(double size) {
  const std::vector<double> points{-.31 * size, -.4 * size, -.3 * size, .5 * size, -.3 * size, -.2 * size,
                                   .01 * size,  .5 * size,  -.4 * size, .1 * size, .2 * size,  .5 * size};
  return Solid::from_triangles(points, std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}).value();
}

Model block(const std::string& size) { return Model::block({size, size, size}); }

TEST(ModelGrid, SolidsOfTwoSizes) {
  const Model model = Model::difference(Model::solid(fitting_box({0, 0, 0}, {20, 20, 20})),
                                        {Model::solid(fitting_box({0, 0, 0}, {1, 1, 1}))});
  MotionReport report;
  const auto solid = evaluate(model, {}, &report);
  ASSERT_TRUE(solid) << solid.error().message;
  EXPECT_EQ(volume(solid.value()), "7999");
  EXPECT_EQ(report.primitives, 0u);
}

// A solid of whose grid the world is too small for the primitives.
TEST(ModelGrid, PrimitivesBeyondTheWorldOfTheSolids) {
  const auto solid = evaluate(Model::unite({Model::solid(fitting_box({0, 0, 0}, {1, 1, 1})), block("4096")}));
  ASSERT_TRUE(solid) << solid.error().message;
  EXPECT_EQ(volume(solid.value()), "68719476736");
}

// Long normals: on a grid for a block of 2^30 they do not stay what they are.
TEST(ModelGrid, SolidsThatDoNotFitAreRoundedAndReported) {
  const Solid small = skew_tetrahedron(1);
  const Model model = Model::unite({Model::solid(small), block("1073741824")});
  MotionReport report;
  const auto solid = evaluate(model, {}, &report);
  ASSERT_TRUE(solid) << solid.error().message;
  EXPECT_EQ(report.primitives, 2u);
  EXPECT_EQ(report.by_planes, 2u);
  EXPECT_GT(report.displacement, 0);
  EXPECT_LT(report.displacement, 1e-15);

  // Who asks for a grid gets it, or is refused.
  ModelOptions options;
  options.grid = solid.value().grid();
  EXPECT_EQ(evaluate(model, options).error().code, ErrorCode::inexact_grid);
  options.grid.reset();
  options.run.grid_rule = GridRule::exact;
  const auto refused = evaluate(model, options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::inexact_grid);
  EXPECT_EQ(refused.error().where.substr(0, 5), "solid");
}

}  // namespace
}  // namespace quoin::api_test
