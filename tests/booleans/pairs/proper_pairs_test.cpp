#include "booleans/pairs/proper_pairs.h"

#include <gtest/gtest.h>

#include "tests/booleans/pairs/fans.h"

namespace quoin::booleans::testing {
namespace {

/// The same triangles as polygons.
Body as_polygons(const Body& mesh) {
  Body r;
  r.grid_points = mesh.grid_points;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    r.planes.push_back(mesh.plane(f));
    for (const std::uint32_t v : mesh.triangles[f]) r.polygons.corners.push_back(v);
    r.polygons.end_loop();
    r.polygons.end_face();
  }
  return r;
}

// Against all pairs of triangles, each looked at by itself: none that meets out of place is proved, most others are.
TEST(ProperPairs, NoneThatMeetsOutOfPlace) {
  std::size_t proved = 0, proper = 0;
  for (std::uint64_t number = 0; number < case_count(400); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x9A1, number);
    const auto mesh = with_fans(random);
    if (!mesh) continue;
    const std::set<FacePair> improper = improper_by_pairs(*mesh);
    const Body polygons = as_polygons(*mesh);
    const ProperPairs of_mesh(*mesh), of_polygons(polygons);

    const auto count = static_cast<std::uint32_t>(mesh->triangles.size());
    for (std::uint32_t f = 0; f < count; ++f)
      for (std::uint32_t g = f + 1; g < count; ++g) {
        const bool is_improper = improper.contains({FaceId(f), FaceId(g)});
        if (is_improper) {
          EXPECT_FALSE(of_mesh.proved(f, g)) << f << " " << g;
          EXPECT_FALSE(of_polygons.proved(f, g)) << f << " " << g;
        } else {
          ++proper;
          proved += of_mesh.proved(f, g);
        }
      }
  }
  EXPECT_GT(proved, proper * 9 / 10);
}

}  // namespace
}  // namespace quoin::booleans::testing
