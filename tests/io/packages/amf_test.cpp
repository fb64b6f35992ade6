#include "io/formats.h"
#include "io/packages/zip.h"

#include "tests/io/io_support.h"

namespace quoin::io {
namespace {

const std::string tetrahedron =
    "<mesh><vertices>"
    "<vertex><coordinates><x>0</x><y>0</y><z>0</z></coordinates></vertex>"
    "<vertex><coordinates><x> 1 </x><y>0</y><z>0</z></coordinates><color><r>1</r></color></vertex>"
    "<vertex><coordinates><x>0</x><y>1</y><z>0</z></coordinates></vertex>"
    "<vertex><coordinates><x>0</x><y>0</y><z>1e0</z></coordinates></vertex></vertices><volume>"
    "<triangle><v1>0</v1><v2>2</v2><v3>1</v3></triangle><triangle><v1>0</v1><v2>1</v2><v3>3</v3></triangle>"
    "<triangle><v1>1</v1><v2>2</v2><v3>3</v3></triangle><triangle><v1>2</v1><v2>0</v2><v3>3</v3></triangle>"
    "</volume></mesh>";

std::string amf(const std::string& content) {
  return "<?xml version=\"1.0\"?>\n<amf unit=\"inch\">" + content + "</amf>";
}

std::string object(const std::string& id, const std::string& content = tetrahedron) {
  return "<object id=\"" + id + "\"><metadata type=\"name\">part " + id + "</metadata>" + content + "</object>";
}

TEST(Amf, RoundTrips) { test::expect_round_trips(Format::amf); }

TEST(Amf, PlainAndZippedAreOne) {
  const std::string text = amf(object("3"));
  const std::string zipped = write_zip({{"part.amf", text}});
  for (const std::string& bytes : {text, zipped}) {
    EXPECT_EQ(format_to_read(bytes, std::nullopt), Format::amf);
    const auto scene = read_scene(bytes, Format::amf);
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(scene.value().unit, Unit::inch);
    EXPECT_EQ(scene.value().objects.at(0).name, "part 3");
    EXPECT_EQ(scene.value().meshes.at(0).points, test::tetrahedron().points);
    EXPECT_EQ(scene.value().meshes.at(0).corners, test::tetrahedron().triangles);
    EXPECT_EQ(scene.value().notices.at(0).count, 1U);
  }
}

TEST(Amf, ConstellationsPlaceObjects) {
  const auto scene =
      read_scene(amf(object("1") + object("2") +
                     "<constellation id=\"c\"><instance objectid=\"1\"><deltax>5</deltax><rz>90</rz></instance>"
                     "<instance objectid=\"1\"><deltaz>-1</deltaz></instance></constellation>"),
                 Format::amf);
  ASSERT_TRUE(scene) << scene.error().message;
  ASSERT_EQ(scene.value().objects.size(), 3U);
  EXPECT_EQ(scene.value().objects[0].name, "part 2");
  const Placing& placing = scene.value().objects[1].meshes[0].placing;
  ASSERT_EQ(placing.size(), 2U);
  EXPECT_EQ(std::get<AngleStep>(placing[0]).axis, 2U);
  EXPECT_EQ(std::get<AngleStep>(placing[0]).degrees, 90);
  EXPECT_EQ(std::get<MatrixStep>(placing[1]), (MatrixStep{{1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0}}));
}

TEST(Amf, HostileFilesAreRefused) {
  const auto code = [](const std::string& text) { return test::code_of(text, Format::amf); };
  const auto replaced = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_EQ(code("<stl/>"), "unknown-format");
  EXPECT_EQ(code(amf("")), "no-faces");
  EXPECT_EQ(code(amf(object("1") + object("1"))), "bad-syntax");
  EXPECT_EQ(code(amf(object("1", replaced(tetrahedron, "<v1>0", "<v1>4")))), "bad-index");
  EXPECT_EQ(code(amf(object("1", replaced(tetrahedron, "<v1>0", "<v1>-1")))), "bad-index");
  EXPECT_EQ(code(amf(object("1", replaced(tetrahedron, "<v1>0</v1>", "")))), "bad-syntax");
  EXPECT_EQ(code(amf(object("1", replaced(tetrahedron, "<x>0</x>", "<x>nan</x>")))), "non-finite");
  EXPECT_EQ(code(amf(object("1", replaced(tetrahedron, "<x>0</x>", "<x>a</x>")))), "bad-number");
  EXPECT_EQ(code(amf(object("1", replaced(tetrahedron, "<x>0</x>", "")))), "bad-syntax");
  EXPECT_EQ(code(amf("<constellation id=\"1\"><instance objectid=\"1\"/></constellation>")), "bad-syntax");
  EXPECT_EQ(code(amf("<constellation id=\"1\"><instance objectid=\"2\"/></constellation>")), "bad-index");
  test::read_mutations(amf(object("1")), Format::amf, 3000);
  EXPECT_EQ(test::read_all_prefixes(amf(object("1")), Format::amf), 1U);
}

}  // namespace
}  // namespace quoin::io
