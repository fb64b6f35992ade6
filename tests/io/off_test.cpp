#include "io/formats.h"
#include "tests/io/io_support.h"

namespace quoin::io {
namespace {

using test::code_of;

constexpr const char* small =
    "OFF # comment\n# another\n4 3 0\n\n0 0 0\n1 0 0 # here\n0 1 0\n0 0 1e0\n3 0 2 1\n3  0 1 3  255 0 0\n4 0 1 2 3\n";

TEST(Off, RoundTrip) {
  test::expect_round_trips(Format::off);
  const test::Triangles mesh = test::strip(test::awkward_doubles());
  std::vector<double> expected = {static_cast<double>(mesh.points.size() / 3),
                                  static_cast<double>(mesh.triangles.size() / 3), 0};
  expected.insert(expected.end(), mesh.points.begin(), mesh.points.end());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i % 3 == 0) expected.push_back(3);
    expected.push_back(mesh.triangles[i]);
  }
  const std::string text = write_mesh(mesh.points, mesh.triangles, Format::off).substr(3);
  EXPECT_EQ(test::bits(test::numbers_by_strtod(text)), test::bits(expected));
}

TEST(Off, CommentsColoursAndPolygons) {
  for (const std::string& text : {std::string(small), test::with_crlf(small)}) {
    const Result<PolygonMesh> read = read_mesh(text, Format::off);
    ASSERT_TRUE(read) << read.error().message << read.error().where;
    EXPECT_EQ(read.value().points, (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}));
    EXPECT_EQ(read.value().starts, (std::vector<std::uint32_t>{0, 3, 6, 10}));
    EXPECT_EQ(read.value().corners, (std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 0, 1, 2, 3}));
  }
}

TEST(Off, Headers) {
  const std::string plain = "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2";
  const std::string extras = "\n0 0 0 9 9 9 9\n1 0 0 9 9 9 9\n0 1 0 9 9 9 9\n3 0 1 2\n\n# end";
  for (const char* header :
       {"OFF 3 1 0", "OFF\n3 1 0", "OFF\n3 1", "OFF3 1 0", "OFF # x\n\n3 1 3", "#c\n\nOFF\n3 1 0"}) {
    EXPECT_EQ(code_of(header + plain, Format::off), "") << header;
  }
  for (const char* header :
       {"COFF\n3 1 0", "NOFF\n3 1 0", "STOFF 3 1 0", "CNOFF\n3 1 0", "STCNOFF\n3 1 0", "NCOFF 3 1"}) {
    EXPECT_EQ(code_of(header + extras, Format::off), "") << header;
  }
  for (const char* header :
       {"OFF BINARY\n3 1 0", "4OFF\n3 1 0", "nOFF\n3 3 1 0", "OFFX\n3 1 0", "3 1 0", "off\n3 1 0"}) {
    EXPECT_EQ(code_of(header + plain, Format::off), "unknown-format") << header;
  }
}

TEST(Off, Errors) {
  const std::string head = "OFF\n3 1 0\n";
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  const auto code = [](const std::string& text) { return code_of(text, Format::off); };
  EXPECT_EQ(code(head + points + "3 0 1 3\n"), "bad-index");
  EXPECT_EQ(test::where_of(head + points + "3 0 1 3\n", Format::off), "line 6");
  EXPECT_EQ(code(head + points + "3 0 1 -1\n"), "bad-index");
  EXPECT_EQ(code(head + points + "2 0 1\n"), "bad-syntax");
  EXPECT_EQ(code(head + points + "3 0 1\n0 2\n"), "bad-syntax");
  EXPECT_EQ(code(head + points + "3 0 1.5 2\n"), "bad-number");
  EXPECT_EQ(code(head + points + "3 0 1 2\n3 0 1 2\n"), "bad-syntax");
  EXPECT_EQ(code(head + points + "1000 0 1 2\n"), "absurd-count");
  EXPECT_EQ(code(head + points + "99999999999999999999 0 1 2\n"), "absurd-count");
  EXPECT_EQ(code(head + points), "truncated");
  EXPECT_EQ(code(head + "0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n"), "non-finite");
  EXPECT_EQ(test::where_of(head + "0 0 0\n1 0 inf\n0 1 0\n3 0 1 2\n", Format::off), "line 4");
  EXPECT_EQ(code(head + "0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "bad-syntax");
  EXPECT_EQ(code("OFF\n4294967295 1 0\n" + points), "absurd-count");
  EXPECT_EQ(code("OFF\n3 4294967295 0\n" + points), "absurd-count");
  EXPECT_EQ(code("OFF\n-3 1 0\n" + points), "absurd-count");
  EXPECT_EQ(code("OFF\n9223372036854775807 9223372036854775807 0\n" + points), "absurd-count");
  EXPECT_EQ(code("OFF\n3\n1 0\n" + points), "bad-syntax");
  EXPECT_EQ(code("OFF\n"), "truncated");
}

TEST(Off, NumbersMayRunOnOverLines) {
  const std::vector<std::uint32_t> corners = {0, 2, 1, 0, 1, 3, 3, 1, 2, 3, 2, 0};
  for (const char* text : {"OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2\n1\n3 0 1 3 3 3 1 2\n3\n3 2 0\n",
                           "OFF 4 4 6\n0 0 0 1 0\n0 0\n# on\n1 0 0 0 1 3 0 2 1 3 0 1 3 3 3 1 2 3 3 2 0"}) {
    const Result<PolygonMesh> read = read_mesh(text, Format::off);
    ASSERT_TRUE(read) << read.error().message << read.error().where;
    EXPECT_EQ(read.value().points, (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}));
    EXPECT_EQ(read.value().starts, test::triangle_starts(4));
    EXPECT_EQ(read.value().corners, corners);
  }
  // With a number too many the lines have the last word.
  EXPECT_EQ(test::where_of("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n2 2\n", Format::off), "line 6");
}

TEST(Off, PointsAloneHaveNoFaces) {
  EXPECT_EQ(code_of("OFF\n0 0 0\n", Format::off), "no-faces");
  EXPECT_EQ(code_of("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", Format::off), "no-faces");
}

TEST(Off, PrefixesAndMutations) {
  // Whole, without its last line end.
  EXPECT_EQ(test::read_all_prefixes(small, Format::off), 2U);
  test::read_mutations(small, Format::off, 20000);
}

TEST(Off, WhatStandsBehindNumbersIsCounted) {
  const auto mesh = read_off("COFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0\n3 0 1 2 9 9 9\n");
  ASSERT_TRUE(mesh.has_value()) << mesh.error().message;
  ASSERT_EQ(mesh.value().notices.size(), 2U);
  EXPECT_EQ(mesh.value().notices[0].count, 2U);
  EXPECT_EQ(mesh.value().notices[1], (Notice{1, "1 colour of a face is passed over"}));
}

}  // namespace
}  // namespace quoin::io
