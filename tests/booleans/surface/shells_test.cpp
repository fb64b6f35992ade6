#include "booleans/surface/shells.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

/// Appends triangles on new vertices.
void append(Triangulated& mesh, std::uint32_t vertex_count, const std::vector<Triangle>& triangles) {
  const auto base = static_cast<std::uint32_t>(mesh.source.size());
  for (std::uint32_t v = 0; v < vertex_count; ++v) mesh.source.push_back(base + v);
  for (const Triangle& t : triangles)
    for (const std::uint32_t v : t) mesh.corners.push_back(base + v);
  mesh.face.resize(mesh.corners.size() / 3);
}

/// A torus of n x m quadrilaterals, each two triangles.
void append_torus(Triangulated& mesh, std::uint32_t n, std::uint32_t m) {
  std::vector<Triangle> triangles;
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return i % n * m + j % m; };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  append(mesh, n * m, triangles);
}

/// Two triangles that are glued at other meshes' places: removed, and their rims joined by six more, a handle.
void append_handle(Triangulated& mesh, std::size_t a, std::size_t b) {
  const auto p = mesh.triangle(a), q = mesh.triangle(b);
  std::vector<std::uint32_t> corners;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto c = mesh.triangle(t);
    if (t != a && t != b) corners.insert(corners.end(), c.begin(), c.end());
  }
  // Seen from outside p runs forward and q backward along the tube.
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3, i = (3 - k) % 3, j = (3 - next) % 3;
    corners.insert(corners.end(), {p[k], p[next], q[i], p[next], q[j], q[i]});
  }
  mesh.corners = corners;
  mesh.face.resize(corners.size() / 3);
}

TEST(Shells, Nothing) {
  const Shells none_at_all = shells({});
  EXPECT_EQ(none_at_all.count, 0u);
  EXPECT_EQ(none_at_all.genus, 0);
}

// Spheres and tori, some of them joined by handles: every handle joins two shells, or adds one to the genus of one.
TEST(Shells, SpheresToriAndHandles) {
  for (std::uint64_t number = 0; number < case_count(300); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x5E9, number);
    Triangulated mesh;
    std::uint64_t count = 0;
    std::int64_t genus = 0;
    std::vector<std::uint32_t> part;  // of each vertex, by hand
    for (std::uint64_t i = random.below(6); i > 0; --i, ++count) {
      if (random.one_in(2)) {
        append(mesh, 4, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
      } else {
        append_torus(mesh, 3 + static_cast<std::uint32_t>(random.below(4)),
                     3 + static_cast<std::uint32_t>(random.below(4)));
        ++genus;
      }
      part.resize(mesh.source.size(), static_cast<std::uint32_t>(count));
    }

    for (std::uint64_t i = random.below(4); i > 0 && mesh.triangle_count() > 0; --i) {
      const std::size_t a = random.below(mesh.triangle_count()), b = random.below(mesh.triangle_count());
      if (a == b) continue;
      const std::uint32_t from = part[mesh.triangle(a)[0]], to = part[mesh.triangle(b)[0]];
      append_handle(mesh, a, b);
      if (from == to) {
        ++genus;
      } else {
        --count;
        std::replace(part.begin(), part.end(), to, from);
      }
    }

    const Shells found = shells(mesh);
    ASSERT_EQ(found.count, count);
    ASSERT_EQ(found.genus, genus);
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
