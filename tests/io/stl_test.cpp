#include <cfloat>
#include <cstring>

#include "io/formats.h"
#include "tests/io/io_support.h"

namespace quoin::io {
namespace {

using test::code_of;

std::string little_endian(std::uint32_t value) {
  std::string out;
  for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<char>(value >> shift & 0xFF));
  return out;
}

/// A binary STL by hand; nine coordinates a facet.
std::string binary(std::string header, const std::vector<float>& coordinates) {
  header.resize(80);
  std::string out = header + little_endian(static_cast<std::uint32_t>(coordinates.size() / 9));
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (i % 9 == 0) out.append(12, '\xff');
    out += little_endian(std::bit_cast<std::uint32_t>(coordinates[i]));
    if (i % 9 == 8) out.append("\x12\x34");
  }
  return out;
}

const std::vector<float> one_facet = {0, 0, 0, 1.5F, 0, 0, 0, -0.25F, 1e-40F};

constexpr const char* ascii_facet =
    "solid a name\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1e0 0\n"
    "  endloop\n endfacet\nendsolid a name\n";

/// The points of the triangles' corners in order.
std::vector<double> corner_points(const test::Triangles& mesh) {
  std::vector<double> result;
  for (const std::uint32_t i : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) result.push_back(mesh.points[std::size_t{i} * 3 + k]);
  }
  return result;
}

TEST(Stl, AsciiRoundTripKeepsDoubles) {
  std::mt19937_64 random(test::seed());
  std::vector<double> coordinates = test::awkward_doubles();
  for (int i = 0; i < 3000; ++i) coordinates.push_back(test::any_finite(random));
  const test::Triangles mesh = test::strip(coordinates);
  const std::string text = write_mesh(mesh.points, mesh.triangles, Format::stl_ascii);
  const Result<PolygonMesh> read = read_mesh(text, Format::stl);
  ASSERT_TRUE(read) << read.error().message << read.error().where;
  EXPECT_EQ(test::bits(read.value().points), test::bits(corner_points(mesh)));
  EXPECT_EQ(read.value().starts, test::triangle_starts(mesh.triangles.size() / 3));
  // The second way.
  std::vector<double> vertices;
  for (std::size_t at = text.find("vertex "); at != std::string::npos; at = text.find("vertex ", at + 1)) {
    const auto line = test::numbers_by_strtod(text.substr(at + 7, text.find('\n', at) - at - 7));
    vertices.insert(vertices.end(), line.begin(), line.end());
  }
  EXPECT_EQ(test::bits(vertices), test::bits(corner_points(mesh)));
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
}

TEST(Stl, BinaryRoundTripRoundsToFloat) {
  std::mt19937_64 random(test::seed());
  std::vector<double> coordinates = {0.0, -0.0, 0.1, FLT_MAX, -FLT_MAX, FLT_MIN, FLT_TRUE_MIN, 1e-320, 1.0 / 3};
  for (int i = 0; i < 3000; ++i) {
    const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (std::isfinite(value)) coordinates.push_back(static_cast<double>(value));
  }
  const test::Triangles mesh = test::strip(coordinates);
  const std::string bytes = write_mesh(mesh.points, mesh.triangles, Format::stl);
  EXPECT_EQ(bytes.size(), 84 + 50 * mesh.triangles.size() / 3);
  EXPECT_EQ(bytes.substr(0, 17), "Quoin binary STL,");
  const Result<PolygonMesh> read = read_mesh(bytes, Format::stl);
  ASSERT_TRUE(read);
  std::vector<double> expected = corner_points(mesh);
  for (double& coordinate : expected) coordinate = static_cast<double>(static_cast<float>(coordinate));
  EXPECT_EQ(test::bits(read.value().points), test::bits(expected));
  EXPECT_EQ(read.value().starts, test::triangle_starts(mesh.triangles.size() / 3));
  for (std::size_t i = 0; i < read.value().corners.size(); ++i) ASSERT_EQ(read.value().corners[i], i);
}

std::vector<float> normal_of(const std::vector<double>& points) {
  const std::vector<std::uint32_t> triangle = {0, 1, 2};
  const std::string bytes = write_mesh(points, triangle, Format::stl);
  std::vector<float> normal(3);
  std::memcpy(normal.data(), bytes.data() + 84, 12);
  return normal;
}

TEST(Stl, NormalsAreUnitAndCounterClockwise) {
  EXPECT_EQ(normal_of({0, 0, 0, 1, 0, 0, 0, 1, 0}), (std::vector<float>{0, 0, 1}));
  EXPECT_EQ(normal_of({0, 0, 0, 0, 1, 0, 1, 0, 0}), (std::vector<float>{0, 0, -1}));
  EXPECT_EQ(normal_of({0, 0, 0, 3e38, 0, 0, 0, 0, -3e38}), (std::vector<float>{0, 1, 0}));
  EXPECT_EQ(normal_of({0, 0, 0, 0, 1e-44, 0, 0, 0, 1e-44}), (std::vector<float>{1, 0, 0}));
  EXPECT_EQ(normal_of({0, 0, 0, 1, 1, 1, 2, 2, 2}), (std::vector<float>{0, 0, 0}));
  const std::vector<double> huge = {-1.7e308, 0, 0, 1.7e308, 0, 0, 0, 1.7e308, 0};
  const std::vector<std::uint32_t> triangle = {0, 1, 2};
  EXPECT_NE(write_mesh(huge, triangle, Format::stl_ascii).find("facet normal 0 0 1\n"), std::string::npos);
}

TEST(Stl, BinaryMayStartWithSolid) {
  for (const char* header : {"solid", "solid facet normal 0 0 1", "ply\n", "OFF", "\xEF\xBB\xBF"}) {
    const Result<PolygonMesh> read = read_mesh(binary(header, one_facet), Format::stl);
    ASSERT_TRUE(read) << header;
    ASSERT_EQ(read.value().points.size(), 9U);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(read.value().points[i], static_cast<double>(one_facet[i]));
  }
  // Spaces instead of zeros, and padding behind the facet.
  std::string padded = binary(std::string("solid x") + std::string(73, ' '), one_facet);
  EXPECT_EQ(code_of(padded, Format::stl_ascii), "");
  padded += "\n";
  EXPECT_EQ(code_of(padded, Format::stl), "");
}

TEST(Stl, SizesThatContradictTheCount) {
  std::string bytes = binary("solid", one_facet);
  const Result<PolygonMesh> cut = read_mesh(std::string_view(bytes).substr(0, 133), Format::stl);
  ASSERT_FALSE(cut);
  EXPECT_EQ(cut.error().code, ErrorCode::truncated);
  EXPECT_NE(cut.error().message.find("134"), std::string::npos);
  EXPECT_NE(cut.error().message.find("133"), std::string::npos);
  EXPECT_EQ(code_of(bytes + std::string(49, 'x'), Format::stl), "");
  EXPECT_EQ(code_of(bytes + std::string(50, 'x'), Format::stl), "bad-syntax");
  bytes.replace(80, 4, "\xff\xff\xff\xff");
  EXPECT_EQ(code_of(bytes, Format::stl), "truncated");
  EXPECT_EQ(code_of("", Format::stl), "truncated");
  EXPECT_EQ(code_of("sol", Format::stl), "truncated");
}

TEST(Stl, BinaryRefusesNonFinite) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()}) {
    for (std::size_t at = 0; at < 9; ++at) {
      std::vector<float> coordinates = one_facet;
      coordinates[at] = bad;
      EXPECT_EQ(code_of(binary("x", coordinates), Format::stl), "non-finite");
      EXPECT_EQ(test::where_of(binary("x", coordinates), Format::stl), "byte 96");
    }
  }
}

TEST(Stl, AsciiIsLenientAboutCaseLinesAndNormals) {
  std::string text = ascii_facet;
  EXPECT_EQ(code_of(text, Format::stl), "");
  EXPECT_EQ(code_of(test::with_crlf(text), Format::stl), "");
  EXPECT_EQ(code_of("\xEF\xBB\xBF \n" + text, Format::stl), "");
  const Result<PolygonMesh> shouted = read_mesh(
      "SOLID\nFACET NORMAL nan NaN -inf OUTER LOOP VERTEX 1 2 3 vertex\n4 5 6 Vertex 7 8 9 ENDLOOP ENDFACET\n"
      "EndSolid\nsolid b\nendsolid\nsolid facet\nfacet normal 0 0 0 outer loop vertex 1 1 1 vertex 2 2 2 "
      "vertex 3 3 3 endloop endfacet endsolid",
      Format::stl);
  ASSERT_TRUE(shouted) << shouted.error().message << shouted.error().where;
  EXPECT_EQ(shouted.value().points, (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 1, 1, 1, 2, 2, 2, 3, 3, 3}));
  EXPECT_EQ(shouted.value().starts, (std::vector<std::uint32_t>{0, 3, 6}));
}

TEST(Stl, AsciiErrorsNameTheLine) {
  const auto with = [](std::string_view from, std::string_view to) {
    std::string text = ascii_facet;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_EQ(code_of(with("vertex 1 0 0", "vertex 1 nan 0"), Format::stl), "non-finite");
  EXPECT_EQ(test::where_of(with("vertex 1 0 0", "vertex 1 nan 0"), Format::stl), "line 5");
  EXPECT_EQ(code_of(with("vertex 1 0 0", "vertex 1 1e999 0"), Format::stl), "non-finite");
  EXPECT_EQ(code_of(with("vertex 1 0 0", "vertex 1 0,5 0"), Format::stl), "bad-number");
  EXPECT_EQ(code_of(with("   vertex 1 0 0\n", ""), Format::stl), "bad-syntax");
  EXPECT_EQ(code_of(with("endloop", "vertex 0 0 1 endloop"), Format::stl), "bad-syntax");
  EXPECT_EQ(code_of(with("endfacet", ""), Format::stl), "bad-syntax");
  EXPECT_EQ(code_of(with("endsolid a name", ""), Format::stl), "truncated");
  EXPECT_EQ(code_of(with("endsolid a name\n", "ends"), Format::stl), "truncated");
  EXPECT_EQ(code_of(std::string(ascii_facet) + "rest", Format::stl), "bad-syntax");
}

TEST(Stl, WithoutFacets) {
  EXPECT_EQ(code_of(binary("", {}), Format::stl), "no-faces");
  EXPECT_EQ(code_of("solid nothing\nendsolid nothing\n", Format::stl), "no-faces");
}

TEST(Stl, PrefixesAndMutations) {
  const std::string solid = binary("solid", one_facet);
  // Whole only: nothing shorter is a mesh.
  EXPECT_EQ(test::read_all_prefixes(solid, Format::stl), 1U);
  // The names behind "endsolid" may be cut.
  EXPECT_EQ(test::read_all_prefixes(ascii_facet, Format::stl), 1 + std::strlen(" a name\n"));
  test::read_mutations(solid, Format::stl, 20000);
  test::read_mutations(ascii_facet, Format::stl_ascii, 20000);
}

TEST(Stl, WordsBehindAFacetArePassedOver) {
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n";
  const std::string named = facet.substr(0, facet.size() - 1) + " outer 1\n";
  const auto mesh = read_stl("solid a\n" + facet + "endfacet 12 red\n" + facet + "endfacet " + named +
                             "endfacet endsolid a\nsolid b\nendsolid b\n");
  ASSERT_TRUE(mesh.has_value()) << mesh.error().message;
  EXPECT_EQ(mesh.value().starts.size(), 4U);
  ASSERT_EQ(mesh.value().notices.size(), 2U);
  EXPECT_EQ(mesh.value().notices[0], (Notice{4, "4 words behind facets are passed over"}));
  EXPECT_EQ(mesh.value().notices[1], (Notice{1, "1 part without facets is passed over"}));
}

}  // namespace
}  // namespace quoin::io
