#include <algorithm>

#include "io/formats.h"
#include "tests/io/io_support.h"

namespace quoin::io {
namespace {

using test::code_of;

constexpr const char* small =
    "# a comment \\\nmtllib x.mtl\no thing\nv 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv +0 1. 0\nv 0 0 1e0\nvt 0 0\nvn 0 0 1\n"
    "s off\nf 1 3 2\nf 1/1 2/1 4/1\nf 2//1 3//1 4//1\nf -2/-1/-1 -4/-1/-1 -1/-1/-1\nl 1 2\n";

TEST(Obj, RoundTrip) {
  test::expect_round_trips(Format::obj);
  const test::Triangles mesh = test::strip(test::awkward_doubles());
  std::vector<double> expected = mesh.points;
  for (const std::uint32_t i : mesh.triangles) expected.push_back(i + 1.0);
  std::string text = write_mesh(mesh.points, mesh.triangles, Format::obj);
  text.erase(0, text.find('\n'));
  for (char& c : text) c = c == 'v' || c == 'f' ? ' ' : c;
  EXPECT_EQ(test::bits(test::numbers_by_strtod(text)), test::bits(expected));
}

TEST(Obj, AllFormsOfCorners) {
  const Result<PolygonMesh> read = read_mesh(small, Format::obj);
  ASSERT_TRUE(read) << read.error().message << read.error().where;
  EXPECT_EQ(read.value().points, (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}));
  EXPECT_EQ(read.value().corners, (std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}));
  EXPECT_EQ(read.value().starts, test::triangle_starts(4));
  const Result<PolygonMesh> crlf = read_mesh(test::with_crlf(small), Format::obj);
  ASSERT_TRUE(crlf);
  EXPECT_EQ(crlf.value().corners, read.value().corners);
  std::string mac = small;
  std::replace(mac.begin(), mac.end(), '\n', '\r');
  const Result<PolygonMesh> old = read_mesh(mac, Format::obj);
  ASSERT_TRUE(old);
  EXPECT_EQ(old.value().corners, read.value().corners);
}

TEST(Obj, LinesJoinAndPolygonsKeepTheirCorners) {
  const Result<PolygonMesh> read = read_mesh(
      "v 0 0 \\\n 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng a \\\nf 9 9 9\nf 1 2\\\n 3 \\\r\n4 # end\n\tf 1 2 3", Format::obj);
  ASSERT_TRUE(read) << read.error().message << read.error().where;
  EXPECT_EQ(read.value().points.size(), 12U);
  EXPECT_EQ(read.value().starts, (std::vector<std::uint32_t>{0, 4, 7}));
  EXPECT_EQ(read.value().corners, (std::vector<std::uint32_t>{0, 1, 2, 3, 0, 1, 2}));
}

TEST(Obj, NegativeIndicesCountBackFromTheirPlace) {
  const Result<PolygonMesh> read =
      read_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -3 -2 -1\nf 5 -1 1\nv 7 7 7\n", Format::obj);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read.value().corners, (std::vector<std::uint32_t>{0, 1, 2, 1, 2, 3, 4, 3, 0}));
}

TEST(Obj, Errors) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const auto code = [&](const std::string& rest) { return code_of(points + rest, Format::obj); };
  EXPECT_EQ(code("f 1 2 4\n"), "bad-index");
  EXPECT_EQ(test::where_of(points + "\nf 1 2 4\nf 1 2 3", Format::obj), "line 5");
  EXPECT_EQ(code("f 1 2 0\n"), "bad-index");
  EXPECT_EQ(code("f 1 2 -4\n"), "bad-index");
  EXPECT_EQ(code("f 1 2 -9223372036854775808\n"), "bad-index");
  EXPECT_EQ(code("f 1 2 99999999999999999999\n"), "bad-index");
  EXPECT_EQ(code("f 1 2 4294967296\n"), "bad-index");
  EXPECT_EQ(code("f 1 2\n"), "bad-syntax");
  EXPECT_EQ(test::where_of(points + "f 1 2\nv 0 0 0\n", Format::obj), "line 4");
  EXPECT_EQ(code("f\n"), "bad-syntax");
  EXPECT_EQ(code("f 1 2 x\n"), "bad-number");
  EXPECT_EQ(code("f 1 2 3.5\n"), "bad-syntax");
  EXPECT_EQ(code("f 1 2 3/a\n"), "bad-syntax");
  EXPECT_EQ(code("v 0 0\nv 0 0 0\n"), "bad-syntax");
  EXPECT_EQ(code("v 0 0"), "truncated");
  EXPECT_EQ(code("v 0 0 nan\n"), "non-finite");
  EXPECT_EQ(test::where_of(points + "v 0 0 -inf\n", Format::obj), "line 4");
  EXPECT_EQ(code("v 0 0 1e309\n"), "non-finite");
  EXPECT_EQ(code("v 0 0 1,5\n"), "bad-number");
  EXPECT_EQ(code_of("", Format::obj), "truncated");
  EXPECT_EQ(code_of("<html>\n", Format::obj), "unknown-format");
  EXPECT_EQ(code_of(std::string("v 0 0 0\n\0", 9), Format::obj), "unknown-format");
}

TEST(Obj, AWireframeHasNoFaces) {
  const std::string wires = "o frame\nv 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3 1\np 1\n";
  EXPECT_EQ(code_of(wires, Format::obj), "no-faces");
  EXPECT_EQ(test::where_of(wires, Format::obj), "byte " + std::to_string(wires.size()));
  EXPECT_EQ(code_of("# nothing\n", Format::obj), "no-faces");
  EXPECT_EQ(code_of(wires + "f 1 2 3\n", Format::obj), "");
}

TEST(Obj, PrefixesAndMutations) {
  (void)test::read_all_prefixes(small, Format::obj);
  test::read_mutations(small, Format::obj, 20000);
}

TEST(Obj, WhatIsPassedOverIsCounted) {
  const auto mesh = read_obj(
      "v 0 0 0 1 0 0\nv 1 0 0 0.5\nv 0 1 0\nvt 0 0\nvn 0 0 1\nusemtl red\np 1\nl 1 2\nfo 1 2 3\nf 1/1 2/1 3/1\n");
  ASSERT_TRUE(mesh.has_value()) << mesh.error().message;
  EXPECT_EQ(mesh.value().starts.size(), 3U);
  std::vector<std::string> said;
  for (const Notice& notice : mesh.value().notices) said.push_back(notice.sentence);
  const std::vector<std::string> expected = {
      "1 colour of a vertex is passed over", "1 normal is passed over", "1 texture coordinate is passed over",
      "1 use of a material is passed over",  "1 line is passed over",   "1 point is passed over"};
  EXPECT_EQ(said, expected);
}

}  // namespace
}  // namespace quoin::io
