#include "tests/cli/support.h"
#include "tests/io/packages/package.h"

namespace quoin::cli_test {
namespace {

/// Two items in inches: a tetrahedron of legs 6, and it again, 3 further along x, where both overlap.
std::string two_items() {
  using namespace io::test;
  return package(model_text("<basematerials id=\"9\"><base name=\"red\" displaycolor=\"#f00\"/></basematerials>" +
                                object_text(1, tetrahedron_text("6"), "name=\"tip\" pid=\"9\""),
                            "<item objectid=\"1\"/><item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 3 0 0\"/>",
                            "unit=\"inch\""));
}

TEST_F(CliTest, ObjectsAreUnitedOrTakenByNumber) {
  put("a.3mf", two_items());
  const auto volume = [&](const std::string& name) { return run({"info", name, "--json"}).json()["volume"]; };
  EXPECT_EQ(volume("a.3mf#1"), "36");
  EXPECT_EQ(volume("a.3mf#tip"), "36");
  EXPECT_EQ(volume("a.3mf#2"), "36");
  // Less than the sum: they overlap in a tetrahedron of legs 3.
  EXPECT_EQ(volume("a.3mf"), "135/2");
  ASSERT_EQ(run({"difference", "a.3mf#1", "a.3mf#2", "-o", "c.3mf"}).code, 0);
  EXPECT_EQ(volume("c.3mf"), "63/2");
  expect_error(run({"info", "a.3mf#3", "--json"}), 1, "bad-index", "a.3mf#3");

  const Json info = run({"info", "a.3mf", "--json"}).json();
  EXPECT_EQ(info["unit"], "inch");
  const Json& contents = info["import"][0];
  EXPECT_EQ(contents["unit"], "inch");
  ASSERT_EQ(contents["objects"].size(), 2U);
  EXPECT_EQ(contents["objects"][0], Json({{"number", 1}, {"name", "tip"}, {"faces", 4}}));
  EXPECT_EQ(contents["notices"][0]["count"], 1);
  const Outcome check = run({"check", "a.3mf"});
  EXPECT_NE(check.out.find("object 2: tip, 4 faces\n"), std::string::npos) << check.out;
  EXPECT_NE(check.err.find("colours and materials"), std::string::npos) << check.err;
  EXPECT_EQ(run({"check", "a.3mf", "--quiet"}).err, "");
}

TEST_F(CliTest, UnitsAreKeptAndNeverScaledSilently) {
  put("a.3mf", two_items());
  ASSERT_EQ(run({"convert", "a.3mf#1", "-o", "b.3mf"}).code, 0);
  EXPECT_EQ(run({"info", "b.3mf", "--json"}).json()["unit"], "inch");
  ASSERT_EQ(run({"union", "a.3mf", "a.off", "-o", "c.amf"}).code, 0);
  EXPECT_EQ(run({"info", "c.amf", "--json"}).json()["unit"], "inch");

  // glTF is in metres: the numbers stay, and the scale of the node says what they mean.
  ASSERT_EQ(run({"convert", "b.3mf", "-o", "m.glb"}).code, 0);
  expect_error(run({"union", "m.glb", "b.3mf", "-o", "d.stl", "--json"}), 1, "mixed-units", "b.3mf");
  const Json same = run({"symmetric-difference", "m.glb", "b.3mf", "-o", "d.stl", "--unit", "inch", "--json"}).json();
  EXPECT_EQ(same["volume"], "0");
  EXPECT_EQ(same["unit"], "inch");
  EXPECT_EQ(run({"info", "b.3mf", "--unit", "mm", "--step", "1/10", "--json"}).json()["volume"], "73741788/125");
  expect_error(run({"info", "b.3mf", "--unit", "yard", "--json"}), 2, "usage");
  EXPECT_EQ(run({"info", "a.off", "--json"}).json()["unit"], nullptr);
}

// Meshes of a model are operands in this.
TEST_F(CliTest, UnitsOfMeshesOfAModel) {
  put("a.3mf", two_items());
  put("one.json", R"({"quoin-model": 1, "model": {"mesh": {"file": "a.3mf#1"}}})");
  const Json kept = run({"eval", "one.json", "-o", "b.amf", "--json"}).json();
  EXPECT_EQ(kept["unit"], "inch");
  EXPECT_EQ(kept["import"][0]["unit"], "inch");
  EXPECT_EQ(kept["volume"], "36");
  EXPECT_EQ(run({"info", "b.amf", "--json"}).json()["unit"], "inch");
  // Legs of 6 inches are half a foot.
  const Json converted = run({"eval", "one.json", "--unit", "ft", "-o", "c.3mf", "--json"}).json();
  EXPECT_EQ(converted["unit"], "foot");
  EXPECT_EQ(run({"info", "c.3mf", "--json"}).json()["volume"], "1/48");

  put("two.json", R"({"quoin-model": 1, "model": {"symmetric-difference":
    [{"mesh": {"file": "a.3mf#1"}}, {"mesh": {"file": "c.3mf"}}, {"mesh": {"file": "a.off"}}]}})");
  expect_error(run({"eval", "two.json", "-o", "d.stl", "--json"}), 1, "mixed-units", "./c.3mf");
  const Json same = run({"eval", "two.json", "--unit", "inch", "-o", "d.stl", "--json"}).json();
  EXPECT_EQ(same["unit"], "inch");
  EXPECT_EQ(same["volume"], run({"info", "a.off", "--json"}).json()["volume"]);
}

}  // namespace
}  // namespace quoin::cli_test
