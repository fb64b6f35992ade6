#include "tests/cli/support.h"

namespace quoin::cli_test {
namespace {

TEST_F(CliTest, CheckReportsWhatImportDid) {
  const Outcome r = run({"check", "a.off", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  const Json object = r.json();
  expect_keys(object, {"valid", "closed", "resolved_crossings", "zero_area_triangles", "merged_points", "max_snap"});
  EXPECT_EQ(object["valid"], true);
  EXPECT_EQ(object["closed"], true);
  EXPECT_EQ(object["resolved_crossings"], 0);
  EXPECT_NE(run({"check", "a.off"}).out, "");
  EXPECT_EQ(run({"check", "a.off", "--quiet"}).out, "");
}

TEST_F(CliTest, CheckRefusesAnOpenSurface) {
  std::string text = cube("0", "1");
  text.replace(text.find("8 6 0"), 5, "8 5 0");
  put("open.off", text.substr(0, text.rfind("4 1 3 7 5")));
  expect_error(run({"check", "open.off", "--json"}), 1, "open-boundary", "open.off");
}

/// A cube without its last face, with another face there twice.
std::string open_cube_with_a_copy() {
  std::string text = cube("0", "2");
  text.replace(text.rfind("4 1 3 7 5"), 9, "4 0 2 3 1");
  return text;
}

TEST_F(CliTest, CheckSaysAllThatIsWrong) {
  put("open.off", open_cube_with_a_copy());
  const Outcome plain = run({"check", "open.off"});
  EXPECT_EQ(plain.code, 1);
  EXPECT_EQ(plain.out,
            "  2 faces are there more often than the surface needs (near (0, 0, 0)); cure: --repair duplicates\n"
            "  1 planar hole, 2.828427124746193 across (near (2, 0, 0)); cure: --repair caps\n")
      << plain.err;
  const Json object = run({"check", "open.off", "--json"}).json();
  ASSERT_EQ(object["findings"].size(), 2U);
  expect_keys(object["findings"][0], {"kind", "count", "size", "where", "cure", "sentence"});
}

TEST_F(CliTest, RepairCuresWhatItIsAskedToAndSaysSo) {
  put("open.off", open_cube_with_a_copy());
  expect_error(run({"info", "open.off", "--repair", "caps", "--json"}), 1, "open-boundary", "open.off");
  const Words words{"info", "open.off", "--json", "--repair", "caps,duplicates"};
  const Outcome r = run(words);
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.json()["volume"], "8");
  EXPECT_EQ(r.json()["import"][0]["repairs"].size(), 2U);
  EXPECT_EQ(r.err,
            "quoin: open.off: repaired: 2 copies of faces dropped (near (0, 0, 0))\n"
            "quoin: open.off: repaired: 1 planar hole closed, at most 2.828427124746193 across (near (2, 0, 0))\n");
  EXPECT_EQ(run({"--repair", "all", "convert", "open.off", "-o", "out.quoin", "--quiet"}).err, "");
  EXPECT_EQ(run({"info", "out.quoin", "--json"}).json()["volume"], "8");
  expect_error(run({"info", "open.off", "--repair", "magic", "--json"}), 2, "usage");
}

TEST_F(CliTest, WhatIsPassedOverIsSaid) {
  put("a.obj",
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvn 1 0 0\nl 1 2\n"
      "f 1 3 2\nfo 1 2 4\nf 2 3 4\nf 1 4 3\n");
  const Outcome r = run({"info", "a.obj", "--json"});
  EXPECT_EQ(r.json()["volume"], "1/6");
  EXPECT_EQ(r.err, "quoin: a.obj: 2 normals are passed over\nquoin: a.obj: 1 line is passed over\n");
  EXPECT_EQ(r.json()["import"][0]["notices"].size(), 2U);
  EXPECT_EQ(r.json()["import"][0]["notices"][0]["count"], 2);
  EXPECT_EQ(run({"info", "a.obj", "--quiet"}).err, "");
}

TEST_F(CliTest, CheckRefusesAnInsideOutSurface) {
  std::string text = cube("0", "1");
  const auto faces = text.find("4 0 2 3 1");
  put("inside-out.off", text.substr(0, faces) + "4 1 3 2 0\n4 6 7 5 4\n4 4 5 1 0\n4 3 7 6 2\n4 2 6 4 0\n4 5 7 3 1\n");
  expect_error(run({"check", "inside-out.off", "--json"}), 1, "inside-out", "inside-out.off");
}

TEST_F(CliTest, CheckRefusesAMeshWithoutFaces) {
  put("wires.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3 1\n");
  expect_error(run({"check", "wires.obj", "--json"}), 1, "no-faces", "wires.obj");
  expect_error(run({"union", "a.off", "wires.obj", "-o", "out.stl", "--json"}), 1, "no-faces", "wires.obj");
}

TEST_F(CliTest, AnInsideOutBodyAmongOthersIsSaid) {
  put("two.off", one_body_inside_out());
  const std::string warning =
      "quoin: warning: 1 shell is inside out and bounds nothing of the solid: dropped "
      "(two.off, shell at (3.5, 3.5, 3.5))\n";
  for (const Words& words : std::vector<Words>{{"info", "two.off"},
                                               {"check", "two.off"},
                                               {"convert", "two.off", "-o", "out.quoin"},
                                               {"union", "a.off", "two.off", "-o", "out.quoin"}}) {
    const Outcome plain = run(words);
    EXPECT_EQ(plain.code, 0) << plain.err;
    EXPECT_EQ(plain.err, warning) << words[0];
    Words quiet = words;
    quiet.push_back("--quiet");
    EXPECT_EQ(run(quiet).err, "") << words[0];
  }
  const Outcome r = run({"info", "two.off", "--json"});
  EXPECT_EQ(r.err, warning);
  EXPECT_EQ(r.json()["volume"], "8");
  EXPECT_EQ(r.json()["import"][0]["dropped_shells"], 1);
  EXPECT_EQ(r.json()["import"][0]["dropped_where"], "shell at (3.5, 3.5, 3.5)");
  EXPECT_EQ(run({"check", "two.off", "--json"}).json()["dropped_shells"], 1);
  // To check is to prove, whatever is trusted.
  EXPECT_EQ(run({"check", "two.off", "--trust", "--json"}).json()["dropped_shells"], 1);
  EXPECT_NE(run({"check", "two.off"}).out.find("shells dropped       1"), std::string::npos);
  EXPECT_EQ(run({"check", "a.off", "--json"}).json()["dropped_shells"], 0);
}

TEST_F(CliTest, CheckRefusesAMeshWithoutAreas) {
  put("line.off", "OFF\n3 2 0\n0 0 0\n1 2 3\n2 4 6\n3 0 1 2\n3 2 1 0\n");
  const Outcome r = run({"check", "line.off", "--json"});
  expect_error(r, 1, "no-faces", "line.off");
  EXPECT_NE(r.err.find("none of the 2 faces has an area"), std::string::npos) << r.err;
  EXPECT_EQ(r.json()["error"]["where"], "face 0");
}

TEST_F(CliTest, AMeshOfWhichNothingIsLeftIsSaid) {
  put("tiny.off", cube("0.1", "0.2"));
  put("pair.off", "OFF\n3 2 0\n0 0 0\n4 0 0\n0 4 0\n3 0 1 2\n3 2 1 0\n");
  const auto warning = [](const std::string& more, const std::string& where) {
    return "quoin: warning: the mesh bounds nothing on this grid, the solid is empty" + more + " (" + where + ")\n";
  };
  const Words tiny{"check", "tiny.off", "--step", "1"};
  const Outcome plain = run(tiny);
  EXPECT_EQ(plain.code, 0);
  EXPECT_EQ(plain.err, warning(": 6 triangles have no area after snapping", "tiny.off, step 1"));
  EXPECT_EQ(run({"union", "a.off", "tiny.off", "--step", "1", "-o", "out.quoin"}).err, plain.err);
  EXPECT_EQ(run({"convert", "pair.off", "--step", "1", "-o", "out.quoin"}).err, warning("", "pair.off, step 1"));

  put("model.json", R"({"quoin-model": 1, "model": {"mesh": {"file": "pair.off"}}})");
  EXPECT_EQ(run({"eval", "model.json", "-o", "out.stl"}).err, warning("", "./pair.off, step 1/16777216"));

  Words quiet = tiny;
  quiet.push_back("--quiet");
  EXPECT_EQ(run(quiet).err, "");
  // What is said to be empty is no loss.
  EXPECT_EQ(run({"check", "out.quoin"}).err, "");
  EXPECT_EQ(run({"check", "tiny.off"}).err, "");
}

}  // namespace
}  // namespace quoin::cli_test
