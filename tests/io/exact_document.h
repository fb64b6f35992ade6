/// \file
/// The content of a .quoin file with numbers of its own, so that they can be changed.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/quoin.h"

namespace quoin::io::test {

/// As io::ExactDocument.
struct ExactDocument {
  using Record = std::array<std::string, 4>;

  std::string step = "1";
  std::array<std::string, 3> origin = {"0", "0", "0"};
  bool full_at_infinity = false;
  std::vector<Record> vertices, planes;
  std::vector<std::uint32_t> face_loops = {0}, loop_corners = {0}, corners;

  ExactDocument() = default;
  explicit ExactDocument(const io::ExactDocument& d)
      : step(d.step),
        full_at_infinity(d.full_at_infinity),
        face_loops(d.face_loops),
        loop_corners(d.loop_corners),
        corners(d.corners) {
    for (std::size_t k = 0; k < 3; ++k) origin[k] = d.origin[k];
    const auto owned = [](const auto& r) {
      return Record{std::string(r[0]), std::string(r[1]), std::string(r[2]), std::string(r[3])};
    };
    for (const auto& r : d.vertices) vertices.push_back(owned(r));
    for (const auto& r : d.planes) planes.push_back(owned(r));
  }
  friend bool operator==(const ExactDocument&, const ExactDocument&) = default;
};

inline std::string write_quoin(const ExactDocument& d) {
  io::ExactDocument r;
  r.step = d.step;
  for (std::size_t k = 0; k < 3; ++k) r.origin[k] = d.origin[k];
  r.full_at_infinity = d.full_at_infinity;
  for (const auto& v : d.vertices) r.vertices.push_back({v[0], v[1], v[2], v[3]});
  for (const auto& p : d.planes) r.planes.push_back({p[0], p[1], p[2], p[3]});
  r.face_loops = d.face_loops;
  r.loop_corners = d.loop_corners;
  r.corners = d.corners;
  return io::write_quoin(r);
}

inline Result<ExactDocument> read_quoin(std::string_view text) {
  const auto read = io::read_quoin(text);
  if (!read) return read.error();
  return ExactDocument(read.value());
}

}  // namespace quoin::io::test
