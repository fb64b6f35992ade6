#include "io/mesh.h"

#include <algorithm>
#include <cassert>

#include "io/formats.h"
#include "io/packages/zip.h"

namespace quoin::io {
namespace {

/// A wireframe, a cloud of points, or nothing at all: its place is the end of the file.
Error no_faces(const Scene& scene, std::size_t size) {
  std::size_t count = 0;
  for (const PolygonMesh& mesh : scene.meshes) count += mesh.points.size() / 3;
  return {ErrorCode::no_faces,
          "the file has " + std::to_string(count) + " vertices and no face: it bounds no solid",
          {},
          "byte " + std::to_string(size)};
}

/// Objects keep the meshes that have faces, and their numbers. Whether anything is left.
bool drop_without_faces(Scene& scene) {
  std::uint64_t dropped = 0;
  bool some = false;
  for (Object& object : scene.objects) {
    dropped += std::erase_if(object.meshes,
                             [&](const PlacedMesh& placed) { return scene.meshes[placed.mesh].starts.size() == 1; });
    some = some || !object.meshes.empty();
  }
  if (dropped > 0) scene.notices.push_back(passed_over(dropped, "mesh without faces", "meshes without faces"));
  return some;
}

}  // namespace

Notice passed_over(std::uint64_t count, std::string_view one, std::string_view many) {
  return {count, std::to_string(count) + " " + std::string(count == 1 ? one : many) +
                     (count == 1 ? " is passed over" : " are passed over")};
}

void PolygonMesh::pass_over(std::uint64_t count, std::string_view one, std::string_view many) {
  if (count > 0) notices.push_back(passed_over(count, one, many));
}

std::string_view without_byte_order_mark(std::string_view bytes) {
  return bytes.starts_with("\xEF\xBB\xBF") ? bytes.substr(3) : bytes;
}

Result<Scene> read_scene(std::string_view bytes, Format named, const Beside& beside) {
  if (bytes.empty()) return Error{ErrorCode::truncated, "the file is empty", {}, "byte 0"};
  const FormatRow& row = row_of(*format_to_read(bytes, named));
  if (row.info.is_exact)
    return Error{ErrorCode::unknown_format, "the file holds an exact solid, no mesh", {}, "line 1"};

  // A counted file is binary: whatever it begins with belongs to it.
  auto scene = row.read(row.evidence == Evidence::length ? bytes : without_byte_order_mark(bytes), beside);
  if (!scene) return scene;
  if (!drop_without_faces(scene.value())) return no_faces(scene.value(), bytes.size());
  return scene;
}

std::string write_mesh(std::span<const double> points, std::span<const std::uint32_t> triangles, Format format,
                       Unit unit) {
  assert(points.size() % 3 == 0 && triangles.size() % 3 == 0);
  assert(std::all_of(triangles.begin(), triangles.end(), [&](std::uint32_t i) { return i < points.size() / 3; }));
  assert(!row_of(format).info.is_exact);
  assert(fits(points.size() / 3, triangles.size() / 3, format));
  return row_of(format).write(points, triangles, unit);
}

std::uint64_t max_bytes(Format format) {
  return format == Format::glb       ? max_count
         : format == Format::threemf ? ZipArchive::max_size
                                     : std::numeric_limits<std::uint64_t>::max();
}

bool fits(std::uint64_t points, std::uint64_t triangles, Format format) {
  // Lines of XML: three numbers of up to 24 characters, three indices of up to 10, and their names.
  const std::uint64_t size = format == Format::threemf ? points * 110 + triangles * 70
                             : format == Format::glb   ? points * 12 + triangles * 12
                                                       : 0;
  return size + 4096 < max_bytes(format);
}

}  // namespace quoin::io
