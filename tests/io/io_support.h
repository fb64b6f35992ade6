/// \file
/// What the tests of the room io share.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "io/mesh.h"

namespace quoin::io {

/// The first mesh of a file, as it stands.
inline Result<PolygonMesh> read_mesh(std::string_view bytes, Format named, const Beside& beside = {}) {
  auto scene = read_scene(bytes, named, beside);
  if (!scene) return scene.error();
  return std::move(scene.value().meshes.at(0));
}

}  // namespace quoin::io

namespace quoin::io::test {

/// The seed of random tests: QUOIN_SEED, else a fixed one; printed.
inline std::uint64_t seed() {
  const char* given = std::getenv("QUOIN_SEED");
  const std::uint64_t value = given != nullptr ? std::strtoull(given, nullptr, 10) : 20240229;
  std::cout << "QUOIN_SEED=" << value << "\n";
  return value;
}

/// A double of any bit pattern that is finite.
inline double any_finite(std::mt19937_64& random) {
  for (;;) {
    const auto value = std::bit_cast<double>(random());
    if (std::isfinite(value)) return value;
  }
}

inline std::vector<double> awkward_doubles() {
  using Limits = std::numeric_limits<double>;
  return {0.0,
          -0.0,
          0.1,
          1.0 / 3,
          1e308,
          -1e308,
          Limits::max(),
          Limits::lowest(),
          Limits::min(),
          Limits::denorm_min(),
          -Limits::denorm_min(),
          2.2250738585072011e-308,
          1e22,
          1e23,
          9007199254740993.0,
          -123456.789e-7,
          1e-5,
          5e-324};
}

struct Triangles {
  std::vector<double> points;
  std::vector<std::uint32_t> triangles;
};

inline Triangles tetrahedron() { return {{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}}; }

/// Triangles 0 1 2, 1 2 3, ... over the given coordinates.
inline Triangles strip(std::vector<double> coordinates) {
  while (coordinates.size() % 3 != 0 || coordinates.size() < 9) coordinates.push_back(0.5);
  Triangles result;
  for (std::uint32_t i = 0; i + 2 < coordinates.size() / 3; ++i) {
    result.triangles.insert(result.triangles.end(), {i, i + 1, i + 2});
  }
  result.points = std::move(coordinates);
  return result;
}

/// Equality of bits: -0 differs from 0.
inline std::vector<std::uint64_t> bits(const std::vector<double>& values) {
  std::vector<std::uint64_t> result;
  for (const double value : values) result.push_back(std::bit_cast<std::uint64_t>(value));
  return result;
}

inline std::vector<std::uint32_t> triangle_starts(std::size_t count) {
  std::vector<std::uint32_t> starts;
  for (std::size_t i = 0; i <= count; ++i) starts.push_back(static_cast<std::uint32_t>(3 * i));
  return starts;
}

/// The promises of PolygonMesh.
inline bool is_valid(const PolygonMesh& mesh) {
  if (mesh.points.size() % 3 != 0 || mesh.starts.empty() || mesh.starts.front() != 0) return false;
  if (mesh.starts.back() != mesh.corners.size()) return false;

  for (std::size_t i = 0; i + 1 < mesh.starts.size(); ++i) {
    if (mesh.starts[i + 1] < mesh.starts[i] || mesh.starts[i + 1] - mesh.starts[i] < 3) return false;
  }
  for (const double coordinate : mesh.points) {
    if (!std::isfinite(coordinate)) return false;
  }
  for (const std::uint32_t corner : mesh.corners) {
    if (corner >= mesh.points.size() / 3) return false;
  }
  return true;
}

/// "" when the bytes were read, else the code of the error; checks what both cases promise.
inline std::string code_of(std::string_view bytes, Format format) {
  // A copy of exact size, so that the sanitizer sees a read behind the end.
  const std::vector<char> copy(bytes.begin(), bytes.end());
  const Result<PolygonMesh> mesh = read_mesh(std::string_view(copy.data(), copy.size()), format);
  if (!mesh) {
    EXPECT_FALSE(mesh.error().message.empty());
    EXPECT_FALSE(mesh.error().where.empty());
    EXPECT_NE(mesh.error().code, ErrorCode::internal_defect);
    return to_string(mesh.error().code);
  }

  EXPECT_TRUE(is_valid(mesh.value()));
  const std::size_t allocated =
      mesh.value().points.capacity() * 8 + mesh.value().starts.capacity() * 4 + mesh.value().corners.capacity() * 4;
  EXPECT_LE(allocated, 64 + 32 * bytes.size());
  return "";
}

inline std::string where_of(std::string_view bytes, Format format) {
  const Result<PolygonMesh> mesh = read_mesh(bytes, format);
  return mesh ? "" : mesh.error().where;
}

/// Reads every prefix: an error or a valid mesh. Returns how many prefixes were read as meshes.
inline std::size_t read_all_prefixes(std::string_view bytes, Format format) {
  std::size_t good = 0;
  for (std::size_t size = 0; size <= bytes.size(); ++size) {
    if (code_of(bytes.substr(0, size), format).empty()) ++good;
  }
  return good;
}

/// Reads variants of `bytes` with a few bytes changed, removed, doubled or swapped for telling ones.
inline void read_mutations(std::string_view bytes, Format format, std::size_t rounds) {
  constexpr std::string_view telling = " \n\r\t-+./#\\0123456789eEnaif\xff\x7f\x80";
  std::mt19937_64 random(seed());
  for (std::size_t round = 0; round < rounds; ++round) {
    std::string mutant(bytes);
    for (std::uint64_t change = random() % 4 + 1; change > 0 && !mutant.empty(); --change) {
      const std::size_t at = random() % mutant.size();
      switch (random() % 5) {
        case 0:
          mutant[at] = static_cast<char>(random());
          break;
        case 1:
          mutant[at] = telling[random() % telling.size()];
          break;
        case 2:
          mutant.erase(at, random() % 8 + 1);
          break;
        case 3:
          mutant.insert(at, 1, telling[random() % telling.size()]);
          break;
        default:
          mutant.insert(at, mutant.substr(at, random() % 40));
      }
    }

    (void)code_of(mutant, format);
    if (::testing::Test::HasFailure()) {
      ADD_FAILURE() << "round " << round;
      return;
    }
  }
}

/// Writes, reads and compares arrays bit by bit; for formats that share points and hold doubles.
inline void expect_round_trip(const Triangles& mesh, Format format) {
  const std::string bytes = write_mesh(mesh.points, mesh.triangles, format);
  EXPECT_EQ(bytes, write_mesh(mesh.points, mesh.triangles, format));
  const Result<PolygonMesh> read = read_mesh(bytes, format);
  ASSERT_TRUE(read) << read.error().message << ", " << read.error().where;
  EXPECT_EQ(bits(read.value().points), bits(mesh.points));
  EXPECT_EQ(read.value().corners, mesh.triangles);
  EXPECT_EQ(read.value().starts, triangle_starts(mesh.triangles.size() / 3));
}

/// Round trips of awkward and of random doubles and of a closed mesh; one without faces is written and refused.
inline void expect_round_trips(Format format) {
  expect_round_trip(strip(awkward_doubles()), format);
  expect_round_trip(tetrahedron(), format);
  EXPECT_EQ(code_of(write_mesh({}, {}, format), format), "no-faces");
  std::mt19937_64 random(seed());
  std::vector<double> coordinates;
  for (int i = 0; i < 6000; ++i) coordinates.push_back(any_finite(random));
  expect_round_trip(strip(coordinates), format);
}

/// The numbers of a text, through strtod: the second way.
inline std::vector<double> numbers_by_strtod(const std::string& text) {
  std::vector<double> result;
  for (const char* p = text.c_str(); *p != 0;) {
    char* after = nullptr;
    const double value = std::strtod(p, &after);
    if (after == p) {
      ++p;
    } else {
      result.push_back(value);
      p = after;
    }
  }
  return result;
}

inline std::string with_crlf(const std::string& text) {
  std::string result;
  for (const char c : text) result.append(c == '\n' ? "\r\n" : std::string(1, c));
  return result;
}

}  // namespace quoin::io::test
