/// \file
/// Closed meshes, and ways to damage them that are known to the last digit.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include "quoin/triangles.h"

namespace quoin::damaged {

using Vertex = std::array<double, 3>;

inline Vertex vertex(const Mesh& mesh, std::uint32_t i) {
  return {mesh.points[3 * i], mesh.points[3 * i + 1], mesh.points[3 * i + 2]};
}

inline std::uint32_t add_vertex(Mesh& mesh, const Vertex& v) {
  mesh.points.insert(mesh.points.end(), v.begin(), v.end());
  return static_cast<std::uint32_t>(mesh.points.size() / 3 - 1);
}

inline void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
}

inline std::size_t size_of(const Mesh& mesh) { return mesh.triangles.size() / 3; }

/// The surface of a block of n x n x n unit cubes, its vertices moved at random by multiples of 1/64 up to 1/8.
inline Mesh bumpy_block(std::uint32_t n, std::mt19937_64& random) {
  Mesh mesh;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> known;
  const auto at = [&](const std::array<std::uint32_t, 3>& place) {
    const auto [entry, is_new] = known.try_emplace(place, static_cast<std::uint32_t>(mesh.points.size() / 3));
    if (is_new)
      for (const std::uint32_t c : place) mesh.points.push_back(c + static_cast<double>(random() % 17) / 64 - 0.125);
    return entry->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const std::uint32_t side : {0U, n})
      for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j) {
          const auto corner = [&](std::uint32_t di, std::uint32_t dj) {
            std::array<std::uint32_t, 3> place{};
            place[axis] = side;
            place[(axis + 1) % 3] = i + di;
            place[(axis + 2) % 3] = j + dj;
            return at(place);
          };
          const std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          if (side == 0) {
            add_triangle(mesh, a, c, b);
            add_triangle(mesh, a, d, c);
          } else {
            add_triangle(mesh, a, b, c);
            add_triangle(mesh, a, c, d);
          }
        }
  return mesh;
}

/// Puts a vertex on an edge of triangle t alone: at its middle, moved by `shift`.
inline void put_on_edge(Mesh& mesh, std::size_t t, const Vertex& shift = {}) {
  const std::uint32_t a = mesh.triangles[3 * t], b = mesh.triangles[3 * t + 1], c = mesh.triangles[3 * t + 2];
  Vertex middle{};
  for (std::size_t k = 0; k < 3; ++k) middle[k] = (vertex(mesh, a)[k] + vertex(mesh, b)[k]) / 2 + shift[k];
  const std::uint32_t m = add_vertex(mesh, middle);
  mesh.triangles[3 * t + 1] = m;
  add_triangle(mesh, m, b, c);
}

/// Gives a triangle three vertices of its own, moved by `shift`: a crack around it.
inline void tear_off(Mesh& mesh, std::size_t t, const Vertex& shift) {
  for (std::size_t k = 0; k < 3; ++k) {
    Vertex v = vertex(mesh, mesh.triangles[3 * t + k]);
    for (std::size_t i = 0; i < 3; ++i) v[i] += shift[i];
    mesh.triangles[3 * t + k] = add_vertex(mesh, v);
  }
}

inline void remove_triangle(Mesh& mesh, std::size_t t) {
  const auto begin = mesh.triangles.begin() + static_cast<std::ptrdiff_t>(3 * t);
  mesh.triangles.erase(begin, begin + 3);
}

inline void turn_over(Mesh& mesh, std::size_t t) { std::swap(mesh.triangles[3 * t], mesh.triangles[3 * t + 1]); }

inline void double_triangle(Mesh& mesh, std::size_t t) {
  add_triangle(mesh, mesh.triangles[3 * t], mesh.triangles[3 * t + 1], mesh.triangles[3 * t + 2]);
}

/// Hangs a triangle on an edge of triangle t, with its tip far out.
inline void add_flap(Mesh& mesh, std::size_t t) {
  const std::uint32_t a = mesh.triangles[3 * t], b = mesh.triangles[3 * t + 1];
  Vertex tip{};
  for (std::size_t k = 0; k < 3; ++k) tip[k] = vertex(mesh, a)[k] + static_cast<double>(3 * k + 2) / 4;
  add_triangle(mesh, a, b, add_vertex(mesh, tip));
}

inline void append(Mesh& mesh, const Mesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size() / 3);
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const std::uint32_t v : other.triangles) mesh.triangles.push_back(first + v);
}

inline void turn_all(Mesh& mesh) {
  for (std::size_t t = 0; t < size_of(mesh); ++t) turn_over(mesh, t);
}

/// Numbers 0 .. count - 1, a few of them, pairwise different and at least `gap` apart.
inline std::vector<std::size_t> some_of(std::size_t count, std::size_t wanted, std::size_t gap,
                                        std::mt19937_64& random) {
  std::vector<std::size_t> result;
  for (std::size_t at = random() % gap; at < count && result.size() < wanted; at += gap + random() % gap)
    result.push_back(at);
  return result;
}

/// The triangles in another order, each beginning with another corner.
inline void shuffle(Mesh& mesh, std::mt19937_64& random) {
  for (std::size_t i = size_of(mesh); i > 1; --i) {
    const std::size_t j = random() % i;
    for (std::size_t k = 0; k < 3; ++k) std::swap(mesh.triangles[3 * (i - 1) + k], mesh.triangles[3 * j + k]);
  }
  for (std::size_t t = 0; t < size_of(mesh); ++t) {
    const auto begin = mesh.triangles.begin() + static_cast<std::ptrdiff_t>(3 * t);
    std::rotate(begin, begin + static_cast<std::ptrdiff_t>(random() % 3), begin + 3);
  }
}

/// Walls from the first sides of a landscape of n x n cells, x = 0 and so around, down to z = -1.
inline void add_skirts(Mesh& mesh, int sides) {
  const auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(mesh.points.size() / 3)));
  const auto n = side - 1;
  const auto rim = [&](std::uint32_t i) {
    const std::uint32_t along = i % n;
    const std::array<std::uint32_t, 4> at{along, along * side + n, n * side + n - along, (n - along) * side};
    return at[i / n % 4];
  };
  const auto foot = [&](std::uint32_t v) { return add_vertex(mesh, {vertex(mesh, v)[0], vertex(mesh, v)[1], -1}); };
  for (std::uint32_t i = 0, below = foot(rim(0)); i < static_cast<std::uint32_t>(sides) * n; ++i) {
    const std::uint32_t a = rim(i), b = rim(i + 1), next = foot(b);
    add_triangle(mesh, a, b, next);
    add_triangle(mesh, a, next, below);
    below = next;
  }
}

/// A landscape of n x n cells, heights at random up to `height`; its border is flat where asked.
inline Mesh terrain(std::uint32_t n, double height, bool flat_border, std::mt19937_64& random) {
  Mesh mesh;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j) {
      const bool is_border = i == 0 || j == 0 || i == n || j == n;
      const double z = flat_border && is_border ? 0 : height * static_cast<double>(random() % 1024) / 1024;
      mesh.points.insert(mesh.points.end(), {static_cast<double>(i), static_cast<double>(j), z});
    }
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * (n + 1) + j, b = a + n + 1;
      add_triangle(mesh, a, b, b + 1);
      add_triangle(mesh, a, b + 1, a + 1);
    }
  return mesh;
}

}  // namespace quoin::damaged
