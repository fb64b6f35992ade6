#include "io/formats.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include "io/quoin.h"

namespace quoin::io {
namespace {

using MeshReader = Result<PolygonMesh> (*)(std::string_view);
using MeshWriter = std::string (*)(std::span<const double>, std::span<const std::uint32_t>);

/// A file that is one mesh, without a name or unit.
template <MeshReader read>
Result<Scene> one_mesh(std::string_view bytes, const Beside&) {
  auto mesh = read(bytes);
  if (!mesh) return mesh.error();
  Scene scene;
  scene.meshes.push_back(std::move(mesh).value());
  scene.objects.push_back({{}, {PlacedMesh{}}});
  return scene;
}

template <MeshWriter write>
std::string without_unit(std::span<const double> points, std::span<const std::uint32_t> triangles, Unit) {
  return write(points, triangles);
}

constexpr std::array<FormatRow, 11> rows = {{
    {{Format::stl, "stl", ".stl", false, true},
     Evidence::length,
     is_exact_binary_stl,
     one_mesh<read_stl>,
     without_unit<write_stl>},
    {{Format::stl_ascii, "stl-ascii", ".stl"},
     Evidence::word,
     looks_like_ascii_stl,
     one_mesh<read_stl>,
     without_unit<write_stl_ascii>},
    {{Format::obj, "obj", ".obj"}, Evidence::none, nullptr, one_mesh<read_obj>, without_unit<write_obj>},
    {{Format::off, "off", ".off"}, Evidence::word, looks_like_off, one_mesh<read_off>, without_unit<write_off>},
    {{Format::ply, "ply", ".ply"}, Evidence::word, looks_like_ply, one_mesh<read_ply>, without_unit<write_ply>},
    {{Format::ply_ascii, "ply-ascii", ".ply"},
     Evidence::none,
     nullptr,
     one_mesh<read_ply>,
     without_unit<write_ply_ascii>},
    {{Format::threemf, "3mf", ".3mf", false, false, true},
     Evidence::word,
     looks_like_threemf,
     read_threemf,
     write_threemf},
    {{Format::glb, "glb", ".glb", false, true, true}, Evidence::word, looks_like_glb, read_gltf, write_glb},
    {{Format::gltf, "gltf", ".gltf", false, true, true}, Evidence::word, looks_like_gltf, read_gltf, write_gltf},
    {{Format::amf, "amf", ".amf", false, false, true}, Evidence::word, looks_like_amf, read_amf, write_amf},
    {{Format::quoin, "quoin", ".quoin", true}, Evidence::word, looks_like_quoin, nullptr, nullptr},
}};

constexpr bool in_order() {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (static_cast<std::size_t>(rows[i].info.format) != i) return false;
  return true;
}
static_assert(in_order(), "a row is found by its enumerator");

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool ends_with_ignoring_case(std::string_view text, std::string_view ending) {
  if (text.size() < ending.size()) return false;
  text.remove_prefix(text.size() - ending.size());
  return std::equal(text.begin(), text.end(), ending.begin(), [](char a, char b) { return lower(a) == b; });
}

/// ".stl, .obj, .off, .ply or .quoin"
std::string extension_list() {
  std::vector<std::string_view> extensions;
  for (const FormatRow& row : rows)
    if (std::find(extensions.begin(), extensions.end(), row.info.extension) == extensions.end())
      extensions.push_back(row.info.extension);

  std::string list;
  for (std::size_t i = 0; i < extensions.size(); ++i) {
    list.append(i == 0 ? "" : i + 1 == extensions.size() ? " or " : ", ");
    list.append(extensions[i]);
  }
  return list;
}

bool is_shown(const FormatRow& row, std::string_view bytes, std::optional<Format> named) {
  switch (row.evidence) {
    case Evidence::none:
      return false;
    case Evidence::word:
      return row.is_shown(without_byte_order_mark(bytes));
    case Evidence::length:
      return row.is_shown(bytes) && (!named || row_of(*named).info.extension == row.info.extension);
  }
  assert(false);
  return false;
}

}  // namespace

std::span<const FormatRow> format_rows() { return rows; }

const FormatRow& row_of(Format format) { return rows[static_cast<std::size_t>(format)]; }

Result<Format> format_of(std::string_view file_name) {
  const auto* row = std::find_if(rows.begin(), rows.end(), [&](const FormatRow& r) {
    return ends_with_ignoring_case(file_name, r.info.extension);
  });
  if (row != rows.end()) return row->info.format;
  return Error{ErrorCode::unknown_format, "the file name does not end with " + extension_list(),
               std::string(file_name)};
}

std::optional<Format> format_to_read(std::string_view bytes, std::optional<Format> named) {
  const auto* row =
      std::find_if(rows.begin(), rows.end(), [&](const FormatRow& r) { return is_shown(r, bytes, named); });
  return row == rows.end() ? named : row->info.format;
}

}  // namespace quoin::io
