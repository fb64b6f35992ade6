#include "io/mesh.h"

#include <algorithm>
#include <cassert>

#include "io/formats.h"

namespace quoin::io {
namespace {

/// A wireframe, a cloud of points, or nothing at all: its place is the end of the file.
Error no_faces(const PolygonMesh& mesh, std::size_t size) {
  return {ErrorCode::no_faces,
          "the file has " + std::to_string(mesh.points.size() / 3) + " vertices and no face: it bounds no solid",
          {},
          "byte " + std::to_string(size)};
}

}  // namespace

void PolygonMesh::pass_over(std::uint64_t count, std::string_view one, std::string_view many) {
  if (count == 0) return;
  notices.push_back({count, std::to_string(count) + " " + std::string(count == 1 ? one : many) +
                                (count == 1 ? " is passed over" : " are passed over")});
}

std::string_view without_byte_order_mark(std::string_view bytes) {
  return bytes.starts_with("\xEF\xBB\xBF") ? bytes.substr(3) : bytes;
}

Result<PolygonMesh> read_mesh(std::string_view bytes, Format named) {
  if (bytes.empty()) return Error{ErrorCode::truncated, "the file is empty", {}, "byte 0"};
  const FormatRow& row = row_of(*format_to_read(bytes, named));
  if (row.info.is_exact)
    return Error{ErrorCode::unknown_format, "the file holds an exact solid, no mesh", {}, "line 1"};

  // A counted file is binary: whatever it begins with belongs to it.
  auto mesh = row.read(row.evidence == Evidence::length ? bytes : without_byte_order_mark(bytes));
  if (mesh && mesh.value().starts.size() == 1) return no_faces(mesh.value(), bytes.size());
  return mesh;
}

std::string write_mesh(std::span<const double> points, std::span<const std::uint32_t> triangles, Format format) {
  assert(points.size() % 3 == 0 && triangles.size() % 3 == 0);
  assert(std::all_of(triangles.begin(), triangles.end(), [&](std::uint32_t i) { return i < points.size() / 3; }));
  assert(!row_of(format).info.is_exact);
  return row_of(format).write(points, triangles);
}

}  // namespace quoin::io
