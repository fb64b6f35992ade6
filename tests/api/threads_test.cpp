#include <gtest/gtest.h>

#include "examples/models.h"
#include "quoin/quoin.h"

namespace quoin {
namespace {

Solid imported(const Mesh& mesh, unsigned threads) {
  ImportOptions options;
  options.grid = Grid::with_step("1/1048576").value();
  options.run.threads = threads;
  return Solid::from_triangles(mesh.points, mesh.triangles, options).value();
}

/// Faces in many stretches, contacts in many chunks, crossings in many sheets: all are worked in parallel.
TEST(Threads, AnyNumberGivesTheSameBytes) {
  const Mesh one = examples::bumpy_sphere({0, 0, 0}, 1, 80000, 1), two = examples::bumpy_sphere({0, 0, 0}, 1, 80000, 2);
  std::string text;
  Mesh mesh;
  for (const unsigned threads : {1u, 2u, 3u}) {
    Options options;
    options.threads = threads;
    const Solid a = imported(one, threads), b = imported(two, threads);
    const Solid result = evaluate(Expression(a) ^ Expression(b), options).value();
    ExportOptions output;
    output.run.threads = threads;
    const Mesh triangles = result.to_triangles(output).value();
    if (threads == 1) {
      text = result.to_quoin();
      mesh = triangles;
    }
    EXPECT_EQ(result.to_quoin(), text);
    EXPECT_EQ(triangles.points, mesh.points);
    EXPECT_EQ(triangles.triangles, mesh.triangles);
  }
}

}  // namespace
}  // namespace quoin
