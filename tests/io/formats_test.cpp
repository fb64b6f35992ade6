#include "io/formats.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "tests/io/io_support.h"

namespace quoin::io {
namespace {

TEST(Format, ByExtension) {
  EXPECT_EQ(format_of("a.stl").value(), Format::stl);
  EXPECT_EQ(format_of("a.b.STL").value(), Format::stl);
  EXPECT_EQ(format_of("/x.y/a.Obj").value(), Format::obj);
  EXPECT_EQ(format_of("a.off").value(), Format::off);
  EXPECT_EQ(format_of("a.PLY").value(), Format::ply);
  EXPECT_EQ(format_of("a.3MF").value(), Format::threemf);
  EXPECT_EQ(format_of("a.glb").value(), Format::glb);
  EXPECT_EQ(format_of("a.gltf").value(), Format::gltf);
  EXPECT_EQ(format_of("a.amf").value(), Format::amf);
  EXPECT_EQ(format_of("a.Quoin").value(), Format::quoin);
  for (const char* name : {"", "-", "stl", "a", "a.stl2", "a.", "a.stl/b"}) {
    const Result<Format> format = format_of(name);
    ASSERT_FALSE(format) << name;
    EXPECT_EQ(format.error().code, ErrorCode::unknown_format);
    EXPECT_EQ(format.error().message,
              "the file name does not end with .stl, .obj, .off, .ply, .3mf, .glb, .gltf, .amf or .quoin");
  }
}

TEST(Format, ContentOverrulesTheHint) {
  const test::Triangles mesh = test::tetrahedron();
  for (const Format hint : {Format::stl, Format::obj, Format::off, Format::ply}) {
    for (const Format real : {Format::stl_ascii, Format::off, Format::ply, Format::ply_ascii, Format::threemf,
                              Format::glb, Format::gltf, Format::amf}) {
      const Result<PolygonMesh> read = read_mesh(write_mesh(mesh.points, mesh.triangles, real), hint);
      ASSERT_TRUE(read) << read.error().message;
      EXPECT_EQ(read.value().corners.size(), 12U);
    }
  }
}

TEST(Format, TheTableIsWhole) {
  std::set<std::string_view> names, extensions;
  for (const FormatRow& row : format_rows()) {
    EXPECT_EQ(&row_of(row.info.format), &row);
    EXPECT_TRUE(names.insert(row.info.name).second) << row.info.name;
    EXPECT_EQ(row.is_shown == nullptr, row.evidence == Evidence::none) << row.info.name;
    EXPECT_EQ(row.read == nullptr, row.info.is_exact) << row.info.name;
    EXPECT_EQ(row.write == nullptr, row.info.is_exact) << row.info.name;
    // An extension stands for the first of its formats.
    const bool is_first = extensions.insert(row.info.extension).second;
    EXPECT_EQ(format_of("a" + std::string(row.info.extension)).value() == row.info.format, is_first) << row.info.name;
  }
}

TEST(Format, ContentDecidesThenTheName) {
  const test::Triangles mesh = test::tetrahedron();
  for (const FormatRow& row : format_rows()) {
    if (row.info.is_exact) continue;
    const std::string bytes = write_mesh(mesh.points, mesh.triangles, row.info.format);
    const auto unnamed = format_to_read(bytes, std::nullopt);
    if (row.evidence == Evidence::none && row.info.extension == ".obj") {
      EXPECT_FALSE(unnamed);
    } else {
      ASSERT_TRUE(unnamed) << row.info.name;
      EXPECT_EQ(row_of(*unnamed).info.extension, row.info.extension);
    }
    // A byte order mark hides nothing from words.
    if (row.evidence == Evidence::word) {
      EXPECT_EQ(format_to_read("\xEF\xBB\xBF" + bytes, std::nullopt), row.info.format) << row.info.name;
    }
    EXPECT_EQ(row_of(*format_to_read(bytes, row.info.format)).info.extension, row.info.extension);
  }
  EXPECT_EQ(format_to_read("quoin 1\n", Format::stl), Format::quoin);
  EXPECT_EQ(read_mesh("quoin 1\n", Format::stl).error().code, ErrorCode::unknown_format);
  // A length that fits by chance: the name weighs more.
  const std::string binary = write_mesh(mesh.points, mesh.triangles, Format::stl);
  EXPECT_EQ(format_to_read(binary, std::nullopt), Format::stl);
  EXPECT_EQ(format_to_read(binary, Format::stl_ascii), Format::stl);
  EXPECT_EQ(format_to_read(binary, Format::obj), Format::obj);
  EXPECT_EQ(format_to_read("hello", std::nullopt), std::nullopt);
  EXPECT_EQ(format_to_read("hello", Format::off), Format::off);
}

std::string page(const std::string& name) {
  const std::filesystem::path root = std::filesystem::path(QUOIN_TEST_DATA).parent_path().parent_path();
  std::ifstream file(root / name);
  EXPECT_TRUE(file.good()) << name;
  return {std::istreambuf_iterator<char>(file), {}};
}

// The rows | `name` | `.extension` | ... of the README are those of the table, in its order.
TEST(Format, TheDocsListTheTable) {
  std::string expected, found;
  for (const FormatRow& row : format_rows())
    expected += "| `" + std::string(row.info.name) + "` | `" + std::string(row.info.extension) + "` |\n";
  std::istringstream readme(page("README.md"));
  bool inside = false;
  for (std::string line; std::getline(readme, line);) {
    if (line.starts_with("#")) inside = line == "## Formats";
    if (!inside || !line.starts_with("| `") || line.starts_with("| `--format`")) continue;
    const auto end = line.find('|', line.find('|', 1) + 1);
    found += line.substr(0, end + 1) + "\n";
  }
  EXPECT_EQ(found, expected);

  // The picture of the flow names them in capitals, and exact ones by their extension.
  const std::string overview = page("docs/overview.md");
  for (const FormatRow& row : format_rows()) {
    std::string word(row.info.extension);
    if (!row.info.is_exact) {
      word.erase(0, 1);
      std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::toupper(c); });
    }
    EXPECT_NE(overview.find(word), std::string::npos) << word;
  }
}

}  // namespace
}  // namespace quoin::io
