#include <algorithm>
#include <cstring>

#include "io/formats.h"
#include "tests/io/io_support.h"

namespace quoin::io {
namespace {

using test::code_of;

/// Appends a value in the given byte order.
template <class Value>
void put(std::string& out, Value value, bool big) {
  char bytes[sizeof(Value)];
  std::memcpy(bytes, &value, sizeof value);
  if (big == (std::endian::native == std::endian::little)) std::reverse(bytes, bytes + sizeof value);
  out.append(bytes, sizeof value);
}

/// Every scalar type, lists before and behind what is used, other elements in between.
std::string rich_header(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment x\nobj_info y\nelement material 2\nproperty list uint8 float tint\nproperty uchar kind\n"
         "element vertex 4\nproperty list ushort char tags\nproperty float32 z\nproperty int8 a\nproperty short x\n"
         "property uint16 b\nproperty uint32 c\nproperty double y\nproperty float w\n"
         "element face 2\nproperty int flags\nproperty list int uint vertex_index\nproperty list uchar float64 uv\n"
         "element edge 1\nproperty int32 v1\nproperty int v2\nend_header\n";
}

std::string rich_ascii() {
  return rich_header("ascii") +
         "2 nan inf 7\n0 8\n"
         "0 0.1 -1 -5 2 3 0.25 nan\n3 1 2 3 1 0 0 0 0 0 x\n1 1 0 0 0 0 0 1e-3 0\n0 3 0 4 0 0 4 0\n"
         "9 3 0 1 2 0\n9 4 3 2 1 0 2 0.5 nan\n"
         "0 1\n";
}

std::string rich_binary(bool big) {
  std::string out = rich_header(big ? "binary_big_endian" : "binary_little_endian");
  const auto material = [&](std::vector<float> tint, std::uint8_t kind) {
    put(out, static_cast<std::uint8_t>(tint.size()), big);
    for (const float value : tint) put(out, value, big);
    put(out, kind, big);
  };
  const auto vertex = [&](std::size_t tags, double x, double y, float z) {
    put(out, static_cast<std::uint16_t>(tags), big);
    out.append(tags, '\7');
    put(out, z, big);
    put(out, std::int8_t{-1}, big);
    put(out, static_cast<std::int16_t>(x), big);
    put(out, std::uint16_t{2}, big);
    put(out, std::uint32_t{3}, big);
    put(out, y, big);
    put(out, std::numeric_limits<float>::quiet_NaN(), big);
  };
  const auto face = [&](const std::vector<std::uint32_t>& corners, std::size_t uv) {
    put(out, std::int32_t{9}, big);
    put(out, static_cast<std::int32_t>(corners.size()), big);
    for (const std::uint32_t corner : corners) put(out, corner, big);
    put(out, static_cast<std::uint8_t>(uv), big);
    for (std::size_t i = 0; i < uv; ++i) put(out, 0.5, big);
  };
  material({1, 2}, 7);
  material({}, 8);
  vertex(0, -5, 0.25, 0.1F);
  vertex(3, 0, 0, 1);
  vertex(1, 0, 1e-3, 0);
  vertex(0, 4, 4, 3);
  face({0, 1, 2}, 0);
  face({3, 2, 1, 0}, 2);
  put(out, std::int32_t{0}, big);
  put(out, std::int32_t{1}, big);
  return out;
}

std::string plain(const std::string& counts_and_types, const std::string& body, const std::string& format = "ascii") {
  return "ply\nformat " + format + " 1.0\n" + counts_and_types + "end_header\n" + body;
}

const std::string usual =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\n";

TEST(Ply, RoundTrip) {
  test::expect_round_trips(Format::ply);
  test::expect_round_trips(Format::ply_ascii);
  const test::Triangles mesh = test::strip(test::awkward_doubles());
  std::vector<double> expected = mesh.points;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i % 3 == 0) expected.push_back(3);
    expected.push_back(mesh.triangles[i]);
  }
  std::string text = write_mesh(mesh.points, mesh.triangles, Format::ply_ascii);
  text.erase(0, text.find("end_header\n") + 11);
  EXPECT_EQ(test::bits(test::numbers_by_strtod(text)), test::bits(expected));
  // The binary body, by hand.
  const std::string bytes = write_mesh(mesh.points, mesh.triangles, Format::ply);
  std::string body;
  for (const double coordinate : mesh.points) put(body, coordinate, false);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i % 3 == 0) body.push_back('\3');
    put(body, mesh.triangles[i], false);
  }
  EXPECT_EQ(bytes.substr(bytes.find("end_header\n") + 11), body);
}

TEST(Ply, AnyPropertiesInAnyEncoding) {
  for (const std::string& bytes :
       {rich_ascii(), test::with_crlf(rich_ascii()), rich_binary(false), rich_binary(true)}) {
    const Result<PolygonMesh> read = read_mesh(bytes, Format::ply);
    ASSERT_TRUE(read) << read.error().message << read.error().where;
    const double z = bytes.find("ascii") != std::string::npos ? 0.1 : static_cast<double>(0.1F);
    EXPECT_EQ(read.value().points, (std::vector<double>{-5, 0.25, z, 0, 0, 1, 0, 1e-3, 0, 4, 4, 3}));
    EXPECT_EQ(read.value().starts, (std::vector<std::uint32_t>{0, 3, 7}));
    EXPECT_EQ(read.value().corners, (std::vector<std::uint32_t>{0, 1, 2, 3, 2, 1, 0}));
  }
}

TEST(Ply, AHeaderOfAnyLineEndMayPrecedeAnyByte) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string header = plain(usual, "", "binary_little_endian");
    std::string bytes;
    for (const char c : header) bytes += c == '\n' ? end : std::string(1, c);
    // The first coordinate begins with the byte of a line feed.
    put(bytes, std::bit_cast<float>(0x3F80000AU), false);
    for (int i = 0; i < 8; ++i) put(bytes, static_cast<float>(i), false);
    bytes.push_back('\3');
    for (int i = 0; i < 3; ++i) put(bytes, i, false);
    const Result<PolygonMesh> read = read_mesh(bytes, Format::stl);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read.value().points[0], static_cast<double>(std::bit_cast<float>(0x3F80000AU)));
  }
}

TEST(Ply, FacesMayPrecedeVertices) {
  const std::string header =
      "element face 1\nproperty list uchar double vertex_indices\n"
      "element vertex 3\nproperty uchar x\nproperty char y\nproperty int z\n";
  EXPECT_EQ(code_of(plain(header, "3 0 1 2\n0 0 0 1 0 0\n0 1 0"), Format::ply), "");
  std::string body = "\3";
  for (int i = 0; i < 3; ++i) put(body, static_cast<double>(i), true);
  for (int i = 0; i < 18; ++i) body.push_back('\xff');
  const Result<PolygonMesh> read = read_mesh(plain(header, body, "binary_big_endian"), Format::ply);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read.value().points, (std::vector<double>{255, -1, -1, 255, -1, -1, 255, -1, -1}));
}

TEST(Ply, BodyErrors) {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  const auto code = [&](const std::string& body) { return code_of(plain(usual, body), Format::ply); };
  EXPECT_EQ(code(points + "3 0 1 2"), "");
  EXPECT_EQ(code(points + "3 0 1 3"), "bad-index");
  EXPECT_EQ(test::where_of(plain(usual, points + "3 0 1 3"), Format::ply), "line 13");
  EXPECT_EQ(code(points + "3 0 1 -1"), "bad-index");
  EXPECT_EQ(code(points + "2 0 1"), "bad-syntax");
  EXPECT_EQ(code(points + "3 0 1"), "absurd-count");
  EXPECT_EQ(code(points + "200 0 1 2"), "absurd-count");
  EXPECT_EQ(code(points + "-1 0 1 2"), "absurd-count");
  EXPECT_EQ(code(points + "3 0 1 x"), "bad-number");
  EXPECT_EQ(code(points + "3 0 1 2 9"), "bad-syntax");
  EXPECT_EQ(code("0 0 nan 1 0 0 0 1 0 3 0 1 2"), "non-finite");
  EXPECT_EQ(code("0 0 1e999 1 0 0 0 1 0 3 0 1 2"), "non-finite");
  EXPECT_EQ(code("0 0 a 1 0 0 0 1 0 3 0 1 2"), "bad-number");
  std::string body;
  for (int i = 0; i < 9; ++i) put(body, i == 4 ? std::numeric_limits<float>::infinity() : 1.0F, true);
  EXPECT_EQ(code_of(plain(usual, body, "binary_big_endian"), Format::ply), "non-finite");
}

TEST(Ply, HeaderErrors) {
  const auto code = [](const std::string& header) { return code_of(header, Format::ply); };
  EXPECT_EQ(code("plx\n"), "unknown-format");
  EXPECT_EQ(code("ply\n"), "truncated");
  EXPECT_EQ(code("ply\nformat utf8 1.0\nend_header\n"), "unknown-format");
  EXPECT_EQ(code("ply\nformat ascii 2.0\nend_header\n"), "unknown-format");
  EXPECT_EQ(code("ply\n" + usual + "end_header\n"), "bad-syntax");
  EXPECT_EQ(code(plain("", "")), "bad-syntax");
  EXPECT_EQ(code(plain(usual.substr(0, usual.find("element face")), "0 0 0 1 0 0 0 1 0")), "no-faces");
  EXPECT_EQ(code(plain("property float x\n" + usual, "")), "bad-syntax");
  EXPECT_EQ(code(plain(usual + "property list uchar int vertex_index\n", "")), "bad-syntax");
  EXPECT_EQ(code(plain(usual + "element face 1\n", "")), "bad-syntax");
  EXPECT_EQ(code(plain(usual + "property list float int extra\n", "")), "bad-syntax");
  EXPECT_EQ(code(plain(usual + "property quad extra\n", "")), "bad-syntax");
  EXPECT_EQ(code(plain(usual + "nonsense\n", "")), "bad-syntax");
  EXPECT_EQ(code(plain(usual + "element other x\n", "")), "bad-number");
  EXPECT_EQ(code(plain(usual + "element other -1\n", "")), "absurd-count");
  EXPECT_EQ(test::where_of(plain(usual + "nonsense\n", ""), Format::ply), "line 9");
}

TEST(Ply, AbsurdCounts) {
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    for (const std::string count : {"4294967296", "1000000000", "9223372036854775807", "99999999999999999999"}) {
      std::string header = usual;
      header.replace(header.find("vertex 3") + 7, 1, count);
      EXPECT_EQ(code_of(plain(header, "0 0 0 1 0 0 0 1 0 3 0 1 2", format), Format::ply), "absurd-count");
      EXPECT_EQ(code_of(plain("element other " + count + "\nproperty char c\n" + usual, "0 0 0", format), Format::ply),
                "absurd-count");
      EXPECT_EQ(code_of(plain("element other " + count + "\n" + usual, "0 0 0", format), Format::ply), "bad-syntax");
    }
  }
  const std::string list = "element other 1\nproperty list uint double d\n" + usual;
  EXPECT_EQ(code_of(plain(list, std::string(60, '\xff'), "binary_little_endian"), Format::ply), "absurd-count");
}

TEST(Ply, PrefixesAndMutations) {
  const test::Triangles mesh = test::tetrahedron();
  for (const Format format : {Format::ply, Format::ply_ascii}) {
    const std::string bytes = write_mesh(mesh.points, mesh.triangles, format);
    // In ascii, the last line end may be missing.
    EXPECT_EQ(test::read_all_prefixes(bytes, format), format == Format::ply ? 1U : 2U);
    test::read_mutations(bytes, format, 10000);
  }
  EXPECT_EQ(test::read_all_prefixes(rich_binary(true), Format::ply), 1U);
  EXPECT_EQ(test::read_all_prefixes(rich_ascii(), Format::ply), 2U);
  test::read_mutations(rich_binary(false), Format::ply, 20000);
  test::read_mutations(rich_binary(true), Format::ply, 20000);
  test::read_mutations(rich_ascii(), Format::ply, 20000);
}

TEST(Ply, TriangleStripsTurnEveryOtherTriangle) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nelement tristrips 1\nproperty list int int vertex_indices\n"
      "end_header\n0 0 0 1 2\n1 0 0 1 2\n0 1 0 1 2\n1 1 0 1 2\n0 2 0 1 2\n11 0 1 2 3 4 -1 4 4 2 3 -1\n";
  const auto mesh = read_ply(text);
  ASSERT_TRUE(mesh.has_value()) << mesh.error().message;
  EXPECT_EQ(mesh.value().corners, (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3, 2, 3, 4, 2, 4, 3}));
  ASSERT_EQ(mesh.value().notices.size(), 1U);
  EXPECT_EQ(mesh.value().notices[0], (Notice{5, "5 rows of vertex: red, green are passed over"}));
}

}  // namespace
}  // namespace quoin::io
