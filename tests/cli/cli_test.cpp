#include <regex>

#include "program.h"
#include "quoin/format.h"

namespace quoin::cli_test {
namespace {

using Words = std::vector<std::string>;
using Json = nlohmann::json;

const std::vector<std::string> info_keys = {"vertices",    "edges",         "faces",    "triangles", "shells",
                                            "genus",       "closed",        "manifold", "bounded",   "volume",
                                            "area_approx", "volume_approx", "box",      "step"};

void expect_keys(const Json& object, const std::vector<std::string>& keys) {
  for (const auto& key : keys) EXPECT_TRUE(object.contains(key)) << key << " is missing in " << object;
}

/// One sentence on stderr, `quoin: ... [code]`, nothing else there.
void expect_sentence(const Outcome& run, const std::string& code) {
  EXPECT_TRUE(std::regex_match(run.err, std::regex("quoin: [^\n]+ \\[" + code + "\\]\n"))) << run.err;
}

/// A refusal: exit code, sentence on stderr, error object on stdout.
void expect_error(const Outcome& run, int exit_code, const std::string& code, const std::string& file = "") {
  EXPECT_EQ(run.code, exit_code) << run.err;
  expect_sentence(run, code);
  const Json object = run.json();
  ASSERT_TRUE(object.contains("error")) << object;
  EXPECT_EQ(object.size(), 1U);
  const Json& error = object["error"];
  expect_keys(error, {"code", "message", "file", "where"});
  EXPECT_EQ(error["code"], code);
  EXPECT_EQ(error["file"], file);
  EXPECT_NE(error["message"], "");
}

// The four Booleans.

TEST_F(CliTest, VolumesOfTwoCubesAreExact) {
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"union", "15/8"}, {"intersection", "1/8"}, {"difference", "7/8"}, {"symmetric-difference", "7/4"}};
  for (const auto& [command, volume] : expected) {
    const Outcome r = run({command, "a.off", "b.off", "-o", "out.quoin", "--json"});
    ASSERT_EQ(r.code, 0) << command << ": " << r.err;
    EXPECT_EQ(r.json()["volume"], volume) << command;
    const Outcome again = run({"info", "out.quoin", "--json"});
    ASSERT_EQ(again.code, 0) << command << ": " << again.err;
    EXPECT_EQ(again.json()["volume"], volume) << command;
  }
}

TEST_F(CliTest, DifferenceSubtractsAllOthers) {
  put("c.off", cube("-0.5", "0.5"));
  const Outcome r = run({"difference", "a.off", "b.off", "c.off", "-o", "out.off", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.json()["volume"], "3/4");
}

TEST_F(CliTest, SymmetricDifferenceIsOddParity) {
  const Outcome r = run({"symmetric-difference", "a.off", "a.off", "a.off", "-o", "out.quoin", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.json()["volume"], "1");
}

TEST_F(CliTest, BooleanJsonHasTheKeysOfTheContract) {
  const Outcome r = run({"union", "a.off", "b.off", "-o", "out.stl", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  const Json object = r.json();
  expect_keys(object, info_keys);
  expect_keys(object, {"seconds", "cpu_seconds", "peak_rss_bytes", "max_snap", "export", "import"});
  const std::vector<std::string> stages = {"read", "build", "boolean", "export", "write", "total"};
  for (const char* clock : {"seconds", "cpu_seconds"}) {
    expect_keys(object[clock], stages);
    for (const auto& stage : stages) EXPECT_GE(object[clock][stage].get<double>(), 0.0) << stage;
  }
  expect_keys(object["export"], {"flipped", "collapsed", "split_edges", "closed"});
  EXPECT_EQ(object["export"]["closed"], true);
  EXPECT_GT(object["peak_rss_bytes"].get<std::uint64_t>(), 0U);
  EXPECT_EQ(object["max_snap"], 0.0);
  ASSERT_EQ(object["import"].size(), 2U);
  EXPECT_EQ(object["import"][1]["file"], "b.off");
  expect_keys(object["import"][1],
              {"max_snap", "merged_points", "zero_area_triangles", "nonplanar_polygons", "resolved_crossings"});
  EXPECT_FALSE(object.contains("statistics"));
}

TEST_F(CliTest, StatsCountTheRungs) {
  const Outcome r = run({"union", "a.off", "b.off", "-o", "out.stl", "--json", "--stats"});
  ASSERT_EQ(r.code, 0) << r.err;
  expect_keys(r.json()["statistics"], {"symbolic", "filter", "fixed_width", "rational"});
}

TEST_F(CliTest, SummaryIsOnStdoutUnlessQuiet) {
  const Outcome loud = run({"union", "a.off", "b.off", "-o", "out.stl"});
  EXPECT_EQ(loud.code, 0) << loud.err;
  EXPECT_NE(loud.out, "");
  EXPECT_EQ(loud.err, "");
  const Outcome quiet = run({"union", "a.off", "b.off", "-o", "out.stl", "--quiet"});
  EXPECT_EQ(quiet.code, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST_F(CliTest, ResultIsTheSameForAnyNumberOfThreads) {
  ASSERT_EQ(run({"union", "a.off", "b.off", "-o", "one.quoin", "--threads", "1"}).code, 0);
  ASSERT_EQ(run({"union", "a.off", "b.off", "-o", "two.quoin", "--threads", "2"}).code, 0);
  EXPECT_EQ(get("one.quoin"), get("two.quoin"));
}

TEST_F(CliTest, UnionWithItselfIsTheSolid) {
  ASSERT_EQ(run({"union", "a.off", "a.off", "-o", "union.quoin"}).code, 0);
  ASSERT_EQ(run({"convert", "a.off", "-o", "same.quoin"}).code, 0);
  EXPECT_NE(get("same.quoin"), "");
  EXPECT_EQ(get("union.quoin"), get("same.quoin"));
}

// complement, split.

TEST_F(CliTest, ComplementIsUnboundedAndAnInvolution) {
  const Outcome r = run({"complement", "a.off", "-o", "out.quoin", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.json()["volume"], nullptr);
  EXPECT_EQ(r.json()["bounded"], false);
  ASSERT_EQ(run({"complement", "out.quoin", "-o", "back.quoin"}).code, 0);
  ASSERT_EQ(run({"convert", "a.off", "-o", "same.quoin"}).code, 0);
  EXPECT_EQ(get("back.quoin"), get("same.quoin"));
}

// move, eval.

TEST_F(CliTest, MoveSaysHowFarAnythingIsFromExact) {
  const Outcome r =
      run({"move", "a.off", "--rotate", "z", "30", "--translate", "1", "-2", "1/3", "-o", "out.quoin", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  const auto json = r.json();
  ASSERT_EQ(json["quaternion"].size(), 4U);
  for (const auto& number : json["quaternion"]) EXPECT_TRUE(number.is_string());
  EXPECT_GT(json["angle_error"].get<double>(), 0);
  EXPECT_LT(json["angle_error"].get<double>(), 1e-24);
  EXPECT_NE(json["displacement_bound"].get<std::string>().find('/'), std::string::npos);
  EXPECT_EQ(json["rounding"]["method"], "best");
  EXPECT_EQ(json["rounding"]["by_planes"], 1);
  EXPECT_EQ(json["faces"], 6);
  EXPECT_EQ(json["vertices"], 8);
  for (const char* key : {"seconds", "cpu_seconds", "peak_rss_bytes", "max_snap", "step", "box"})
    EXPECT_TRUE(json.contains(key)) << key;
}

TEST_F(CliTest, MotionsActInOrderAndCompose) {
  ASSERT_EQ(run({"convert", "a.off", "-o", "a.quoin"}).code, 0);
  // There and back, and a full turn in parts.
  ASSERT_EQ(run({"move", "a.quoin", "--rotate", "1,1,0", "12.5", "--translate", "1", "2", "3", "--translate", "-1",
                 "-2", "-3", "--rotate", "-1,-1,0", "12.5", "-o", "back.quoin"})
                .code,
            0);
  EXPECT_EQ(get("back.quoin"), get("a.quoin"));
  ASSERT_EQ(run({"move", "a.quoin", "--rotate", "z", "350.5", "--rotate", "z", "9.5", "-o", "turn.quoin"}).code, 0);
  EXPECT_EQ(get("turn.quoin"), get("a.quoin"));
  // The order matters.
  ASSERT_EQ(run({"move", "a.quoin", "--rotate", "z", "90", "--translate", "2", "0", "0", "-o", "x.quoin"}).code, 0);
  ASSERT_EQ(run({"move", "a.quoin", "--translate", "2", "0", "0", "--rotate", "z", "90", "-o", "y.quoin"}).code, 0);
  EXPECT_NE(get("x.quoin"), get("y.quoin"));
  const auto x = run({"info", "x.quoin", "--json"}).json()["box"], y = run({"info", "y.quoin", "--json"}).json()["box"];
  EXPECT_EQ(x, (nlohmann::json{{1.0, 0.0, 0.0}, {2.0, 1.0, 1.0}}));
  EXPECT_EQ(y, (nlohmann::json{{-1.0, 2.0, 0.0}, {0.0, 3.0, 1.0}}));
  ASSERT_EQ(run({"move", "a.quoin", "--mirror", "x", "--scale", "2", "-o", "m.quoin"}).code, 0);
  EXPECT_EQ(run({"info", "m.quoin", "--json"}).json()["volume"], "8");
  const auto rough =
      run({"move", "a.quoin", "--rotate", "x", "1", "--rounding", "vertices", "-o", "v.quoin", "--json"});
  EXPECT_EQ(rough.json()["rounding"]["by_vertices"], 1);
}

TEST_F(CliTest, MotionsThatMakeNoSense) {
  expect_error(run({"move", "a.off", "-o", "out.off", "--json"}), 2, "usage");
  expect_error(run({"move", "a.off", "--rotate", "w", "30", "-o", "out.off", "--json"}), 2, "usage");
  expect_error(run({"move", "a.off", "--rotate", "z", "-o", "out.off", "--json"}), 2, "usage");
  expect_error(run({"move", "a.off", "--rotate", "0,0,0", "30", "-o", "out.off", "--json"}), 2, "usage");
  expect_error(run({"move", "a.off", "--translate", "1", "2", "far", "-o", "out.off", "--json"}), 2, "usage");
  expect_error(run({"move", "a.off", "--scale", "-1", "-o", "out.off", "--json"}), 2, "usage");
  expect_error(run({"move", "a.off", "--rotate", "z", "30", "--rounding", "up", "-o", "out.off", "--json"}), 2,
               "usage");
  const Outcome far = run({"move", "a.off", "--translate", "1000", "0", "0", "-o", "out.off", "--json"});
  expect_error(far, 1, "out-of-range");
  EXPECT_EQ(names(), (std::set<std::string>{"a.off", "b.off"}));
}

TEST_F(CliTest, EvalOfAModel) {
  put("model.json", R"({"quoin-model": 1, "step": "1/1000", "parameters": {"w": 2},
 "model": {"difference": [{"block": {"size": ["w", 1, 1]}},
                          {"rotate": {"axis": "z", "angle": 45, "of": {"mesh": {"file": "b.off"}}}}]}})");
  const Outcome r = run({"eval", "model.json", "-o", "out.quoin", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.json()["step"], "1/1000");
  EXPECT_EQ(r.json()["rounding"]["primitives"], 2);
  EXPECT_TRUE(r.json().contains("displacement_bound"));
  ASSERT_EQ(run({"eval", "-", "--set", "w=3", "--set", "w=4", "-o", "wide.quoin"}, get("model.json")).code, 0);
  put("box.json", R"({"quoin-model": 1, "model": {"block": {"size": ["w", "h", 1]}}})");
  const Outcome set = run({"eval", "-", "--set", "w=3", "--set", "h=1/2", "-o", "box.off", "--json"}, get("box.json"));
  ASSERT_EQ(set.code, 0) << set.err;
  EXPECT_EQ(set.json()["volume"], "3/2");
  expect_error(run({"eval", "box.json", "-o", "out.off", "--json"}), 1, "bad-parameter", "box.json");
  expect_error(run({"eval", "box.json", "--set", "w", "-o", "out.off", "--json"}), 2, "usage");
  put("bad.json", "{\"quoin-model\": 1,\n \"model\": {\"cube\": 1}}");
  const Outcome bad = run({"eval", "bad.json", "-o", "out.off", "--json"});
  expect_error(bad, 1, "bad-model", "bad.json");
  EXPECT_EQ(bad.json()["error"]["where"], "line 2, column 11");
  expect_error(run({"eval", "none.json", "-o", "out.off", "--json"}), 1, "missing-file", "none.json");
}

TEST_F(CliTest, TriangleFormatsRefuseTheUnbounded) {
  expect_error(run({"complement", "a.off", "-o", "out.stl", "--json"}), 1, "unbounded", "out.stl");
  EXPECT_EQ(names(), (std::set<std::string>{"a.off", "b.off"}));
}

TEST_F(CliTest, SplitTakesNegativeCoefficients) {
  const std::vector<Words> planes = {
      {"--plane", "-1,0,0,1/4"}, {"--plane=-1,0,0,1/4"}, {"--plane", "-.5,0,0,0.125"}, {"--plane", "-4e0,0,0,+1"}};
  for (const auto& plane : planes) {
    Words words = {"split", "a.off"};
    words.insert(words.end(), plane.begin(), plane.end());
    for (const char* word : {"-o", "above.quoin", "below.quoin", "--json"}) words.push_back(word);
    const Outcome r = run(words);
    // x < 1/4 is above.
    ASSERT_EQ(r.code, 0) << plane.back() << ": " << r.err;
    const Json object = r.json();
    expect_keys(object["above"], info_keys);
    expect_keys(object["below"], info_keys);
    expect_keys(object, {"seconds", "cpu_seconds", "peak_rss_bytes", "max_snap"});
    EXPECT_EQ(object["above"]["volume"], "1/4") << plane.back();
    EXPECT_EQ(object["below"]["volume"], "3/4") << plane.back();
  }
}

TEST_F(CliTest, SplitRefusesWhatIsNoPlane) {
  for (const char* plane : {"1,0,0", "1,0,0,0,0", "1,0,x,0", "0,0,0,1", "0/3,-0.0,0e9,1", "1/0,0,0,1", "1,,0,0", ""}) {
    const Outcome r = run({"split", "a.off", "--plane", plane, "-o", "above.stl", "below.stl", "--json"});
    expect_error(r, 2, "usage");
  }
  EXPECT_EQ(names(), (std::set<std::string>{"a.off", "b.off"}));
}

// info, check, convert.

TEST_F(CliTest, InfoOfACube) {
  const Outcome r = run({"info", "a.off", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  const Json object = r.json();
  expect_keys(object, info_keys);
  EXPECT_EQ(object["vertices"], 8);
  EXPECT_EQ(object["edges"], 12);
  EXPECT_EQ(object["faces"], 6);
  EXPECT_EQ(object["triangles"], 12);
  EXPECT_EQ(object["shells"], 1);
  EXPECT_EQ(object["genus"], 0);
  EXPECT_EQ(object["closed"], true);
  EXPECT_EQ(object["manifold"], true);
  EXPECT_EQ(object["bounded"], true);
  EXPECT_EQ(object["volume"], "1");
  EXPECT_EQ(object["volume_approx"], 1.0);
  EXPECT_EQ(object["area_approx"], 6.0);
  EXPECT_EQ(object["box"], Json::parse("[[0,0,0],[1,1,1]]"));
  EXPECT_TRUE(object["step"].is_string());
}

TEST_F(CliTest, InfoOfTheEmptySolid) {
  put("far.off", cube("5", "6"));
  ASSERT_EQ(run({"intersection", "a.off", "far.off", "-o", "empty.quoin"}).code, 0);
  const Outcome r = run({"info", "empty.quoin", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  const Json object = r.json();
  for (const char* key : {"vertices", "edges", "faces", "triangles", "shells"}) EXPECT_EQ(object[key], 0) << key;
  for (const char* key : {"closed", "manifold", "bounded"}) EXPECT_EQ(object[key], true) << key;
  EXPECT_EQ(object["volume"], "0");
  EXPECT_EQ(object["box"], nullptr);
}

TEST_F(CliTest, InfoPrintsAnAlignedTable) {
  const Outcome r = run({"info", "a.off"});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(std::regex_search(r.out, std::regex("(^|\n)vertices +8\n"))) << r.out;
  EXPECT_TRUE(std::regex_search(r.out, std::regex("\nvolume +1\n"))) << r.out;
  EXPECT_TRUE(std::regex_search(r.out, std::regex("\nvolume, exact +1\n"))) << r.out;
}

TEST_F(CliTest, InfoShortensLongNumbers) {
  // 38 steps of a long denominator.
  put("tiny.off", cube("0", "1e-30"));
  const Words words = {"info", "tiny.off", "--step", "1/3" + std::string(31, '7')};
  const Outcome tiny = run(words);
  ASSERT_EQ(tiny.code, 0) << tiny.err;
  Words with_json = words;
  with_json.push_back("--json");
  const std::string exact = run(with_json).json()["volume"];
  ASSERT_GT(exact.size(), 60U);
  const auto slash = exact.find('/');
  std::smatch found;
  const std::regex rows(
      "\nvolume +([0-9.]+e-[0-9]+)\nvolume, exact +([0-9]+)(\\.\\.\\.)?/([0-9]+)\\.\\.\\. \\(([0-9]+) "
      "digits, all with --json\\)\n");
  ASSERT_TRUE(std::regex_search(tiny.out, found, rows)) << tiny.out;
  EXPECT_NEAR(std::stod(found[1].str()) / 1e-90, 1, 0.1);
  EXPECT_EQ(exact.find(found[2].str()), 0U);
  EXPECT_EQ(exact.find(found[4].str(), slash), slash + 1);
  EXPECT_EQ(std::stoul(found[5].str()), exact.size() - 1);
}

TEST_F(CliTest, StepMakesDecimalsExact) {
  put("decimal.off", cube("0.1", "0.3"));
  const Outcome r = run({"info", "decimal.off", "--step", "1/1000", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.json()["volume"], "1/125");
  EXPECT_EQ(r.json()["step"], "1/1000");
}

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

TEST_F(CliTest, CheckRefusesAnInsideOutSurface) {
  std::string text = cube("0", "1");
  const auto faces = text.find("4 0 2 3 1");
  put("inside-out.off", text.substr(0, faces) + "4 1 3 2 0\n4 6 7 5 4\n4 4 5 1 0\n4 3 7 6 2\n4 2 6 4 0\n4 5 7 3 1\n");
  expect_error(run({"check", "inside-out.off", "--json"}), 1, "inside-out", "inside-out.off");
}

/// Two cubes as one OFF file, the second one inside out.
std::string one_body_inside_out() {
  const std::string faces = "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
  const std::string turned = "4 9 11 10 8\n4 14 15 13 12\n4 12 13 9 8\n4 11 15 14 10\n4 10 14 12 8\n4 13 15 11 9\n";
  const auto points = [](const std::string& text) { return text.substr(10, text.find("4 0 2 3 1") - 10); };
  return "OFF\n16 12 0\n" + points(cube("0", "2")) + points(cube("3.5", "4")) + faces + turned;
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

// A plate of a thousandth of a step, beside a block.
TEST_F(CliTest, APrimitiveThatVanishesIsSaid) {
  put("thin.json", R"({"quoin-model": 1, "model": {"rotate": {"axis": "y", "angle": 30, "of": {"union": [
    {"block": {"size": [10, 20, 1]}}, {"block": {"size": [10, 20, "1/1000"]}}]}}}})");
  const Words words{"eval", "thin.json", "-o", "out.quoin", "--step", "1", "--rounding", "vertices"};
  const Outcome plain = run(words);
  EXPECT_EQ(plain.code, 0) << plain.err;
  EXPECT_EQ(plain.err,
            "quoin: warning: 1 primitive is about as thin as a grid step, so that rounding vertices leaves nothing: "
            "dropped (thin.json, primitive 1)\n");
  Words more = words;
  more.push_back("--json");
  const auto rounding = run(more).json()["rounding"];
  EXPECT_EQ(rounding["vanished_primitives"], 1);
  EXPECT_EQ(rounding["vanished_where"], "primitive 1");
}

TEST_F(CliTest, CheckRefusesAMeshWithoutFaces) {
  put("wires.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3 1\n");
  expect_error(run({"check", "wires.obj", "--json"}), 1, "no-faces", "wires.obj");
  expect_error(run({"union", "a.off", "wires.obj", "-o", "out.stl", "--json"}), 1, "no-faces", "wires.obj");
}

TEST_F(CliTest, SplitIntoOneFileByTwoNamesIsRefused) {
  const std::string precious = cube("0", "3");
  put("old.off", precious);
  const auto path = [&](const std::string& name) { return folder() / name; };
  std::filesystem::create_hard_link(path("old.off"), path("hard.off"));
  std::filesystem::create_symlink("old.off", path("soft.off"));
  std::filesystem::create_symlink("soft.off", path("softer.off"));
  std::filesystem::create_symlink("new.off", path("dangling.off"));
  std::filesystem::create_directory(path("sub"));
  std::filesystem::create_directory_symlink("sub", path("other"));
  const auto before = names();
  const std::vector<std::array<std::string, 2>> pairs = {
      {"new.off", "./new.off"},      {"new.off", path("new.off").string()},
      {"sub/../new.off", "new.off"}, {"sub/new.off", "other/new.off"},
      {"old.off", "hard.off"},       {"hard.off", "softer.off"},
      {"soft.off", "old.off"},       {"dangling.off", "new.off"},
      {"new.off", "./dangling.off"}};
  for (const auto& [above, below] : pairs) {
    const Outcome r = run({"split", "a.off", "--plane", "1,0,0,-1/2", "-o", above, below, "--json"});
    expect_error(r, 2, "usage");
    EXPECT_EQ(names(), before) << above << " " << below;
    EXPECT_EQ(get("old.off"), precious);
    EXPECT_TRUE(std::filesystem::is_empty(path("sub")));
  }
  EXPECT_EQ(run({"split", "a.off", "--plane", "1,0,0,-1/2", "-o", "sub/new.off", "new.off"}).code, 0);
  expect_error(run({"split", "a.off", "--plane", "1,0,0,0", "-o", "no/a.off", "nor/a.off", "--json"}), 1, "unwritable",
               "no/a.off");
}

TEST_F(CliTest, ConvertKeepsTheSolidInEveryFormat) {
  const std::vector<std::pair<std::string, std::string>> formats = {
      {"stl", "stl"}, {"stl-ascii", "stl"}, {"obj", "obj"},    {"off", "off"},
      {"ply", "ply"}, {"ply-ascii", "ply"}, {"quoin", "quoin"}};
  for (const auto& [format, extension] : formats) {
    const std::string name = "out." + extension;
    const Outcome r = run({"convert", "a.off", "-o", name, "--format", format, "--json"});
    ASSERT_EQ(r.code, 0) << format << ": " << r.err;
    expect_keys(r.json(), {"volume", "seconds", "cpu_seconds", "peak_rss_bytes", "max_snap", "export", "import"});
    const Outcome back = run({"info", name, "--json"});
    ASSERT_EQ(back.code, 0) << format << ": " << back.err;
    EXPECT_EQ(back.json()["volume"], "1") << format;
    EXPECT_EQ(back.json()["faces"], 6) << format;
  }
}

// A cube of one step where float32 has multiples of 8: all its triangles collapse in an STL file, none in others.
TEST_F(CliTest, WhatRoundingDoesIsThatOfTheFormat) {
  put("far.off", cube("67108864", "67108865"));
  for (const auto& [name, collapsed] : std::vector<std::pair<std::string, int>>{{"out.stl", 12}, {"out.off", 0}}) {
    const Outcome r = run({"convert", "far.off", "-o", name, "--step", "1", "--json"});
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(r.json()["export"]["collapsed"], collapsed) << name;
    EXPECT_EQ(r.json()["export"]["flipped"], 0) << name;
    EXPECT_EQ(r.json()["volume"], "1");
  }
}

TEST_F(CliTest, AsciiVariantIsChosenByFormat) {
  ASSERT_EQ(run({"convert", "a.off", "-o", "text.stl", "--format", "stl-ascii"}).code, 0);
  ASSERT_EQ(run({"convert", "a.off", "-o", "binary.stl"}).code, 0);
  EXPECT_EQ(get("text.stl").rfind("solid", 0), 0U);
  EXPECT_EQ(get("binary.stl").size(), 84U + 12U * 50U);
}

// Streams.

TEST_F(CliTest, StandardInputAndOutput) {
  const Outcome r = run({"convert", "-", "-o", "-", "--format", "off"}, cube("0", "1"));
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.out.rfind("OFF", 0), 0U) << r.out;
  put("again.off", r.out);
  EXPECT_EQ(run({"info", "again.off", "--json"}).json()["volume"], "1");
  const Outcome info = run({"info", "-", "--format", "off", "--json"}, cube("0", "2"));
  ASSERT_EQ(info.code, 0) << info.err;
  EXPECT_EQ(info.json()["volume"], "8");
}

TEST_F(CliTest, StreamsThatCannotWorkAreUsageErrors) {
  expect_error(run({"info", "-", "--json"}, cube("0", "1")), 2, "usage");
  expect_error(run({"union", "-", "-", "-o", "out.stl", "--format", "off", "--json"}), 2, "usage");
  expect_error(run({"convert", "a.off", "-o", "-", "--format", "off", "--json"}), 2, "usage");
  const Words twice = {"split", "a.off", "--plane", "1,0,0,0", "-o", "-", "-", "--format", "off"};
  EXPECT_EQ(run(twice).code, 2);
}

// Words.

TEST_F(CliTest, VersionAndHelp) {
  const Outcome version = run({"--version"});
  EXPECT_EQ(version.code, 0);
  for (const char* word : {"quoin ", "commit ", "compiler ", "format "}) {
    EXPECT_NE(version.out.find(word), std::string::npos) << word;
  }
  expect_keys(run({"--version", "--json"}).json(), {"version", "commit", "compiler", "format_version"});
  EXPECT_EQ(run({"union", "--version"}).out, version.out);
  const Outcome help = run({"--help"});
  EXPECT_EQ(help.code, 0);
  for (const char* command : {"union", "intersection", "difference", "symmetric-difference", "complement", "split",
                              "info", "check", "convert"}) {
    EXPECT_NE(help.out.find(command), std::string::npos) << command;
    const Outcome one = run({command, "--help"});
    EXPECT_EQ(one.code, 0) << command;
    EXPECT_NE(one.out.find("Examples:"), std::string::npos) << command;
  }
}

TEST_F(CliTest, HelpAndErrorsListTheFormats) {
  const std::string help = run({"--help"}).out, one = run({"convert", "--help"}).out;
  const std::string refused = run({"info", "a.off", "--format", "dwg"}).err;
  for (const FormatInfo& info : formats()) {
    EXPECT_NE(help.find(std::string(info.extension)), std::string::npos) << info.name;
    EXPECT_NE(one.find(std::string(info.name)), std::string::npos) << info.name;
    EXPECT_NE(refused.find(std::string(info.name)), std::string::npos) << info.name;
  }
}

TEST_F(CliTest, WrongArgumentsAreExitCodeTwo) {
  const std::vector<Words> wrong = {{},
                                    {"unite", "a.off", "b.off", "-o", "out.stl"},
                                    {"eval", "a.off"},
                                    {"union", "a.off", "-o", "out.stl"},
                                    {"union", "a.off", "b.off"},
                                    {"info"},
                                    {"info", "a.off", "b.off"},
                                    {"info", "a.off", "--bogus"},
                                    {"info", "a.off", "--threads", "-1"},
                                    {"info", "a.off", "--threads", "many"},
                                    {"info", "a.off", "--step", "0"},
                                    {"info", "a.off", "--step", "-1"},
                                    {"info", "a.off", "--step", "wide"},
                                    {"info", "a.off", "--format", "dwg"},
                                    {"convert", "a.off", "-o", "out.stl", "--output-topology", "other"},
                                    {"convert", "a.off", "-o", "out.stl", "-o", "two.stl"},
                                    {"split", "a.off", "--plane", "1,0,0,0", "-o", "out.stl"},
                                    {"split", "a.off", "--plane", "1,0,0,0", "-o", "out.stl", "out.stl"},
                                    {"split", "a.off", "-o", "one.stl", "two.stl"}};
  for (const auto& words : wrong) {
    const Outcome plain = run(words);
    EXPECT_EQ(plain.code, 2) << testing::PrintToString(words) << plain.err;
    EXPECT_EQ(plain.out, "");
    expect_sentence(plain, "usage");
    Words with_json = words;
    with_json.push_back("--json");
    expect_error(run(with_json), 2, "usage");
  }
  EXPECT_EQ(names(), (std::set<std::string>{"a.off", "b.off"}));
}

TEST_F(CliTest, OptionsMayStandAnywhere) {
  const Outcome first = run({"--json", "union", "-o", "out.stl", "a.off", "b.off"});
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(first.json()["volume"], "15/8");
  const Outcome between = run({"union", "a.off", "-o", "out.stl", "b.off", "--json"});
  ASSERT_EQ(between.code, 0) << between.err;
  EXPECT_EQ(between.json()["volume"], "15/8");
}

TEST_F(CliTest, FileMayBeCalledLikeACommandOrAnOption) {
  put("union", cube("0", "1"));
  put("--json", cube("0", "1"));
  EXPECT_EQ(run({"union", "union", "a.off", "-o", "out.quoin", "--format", "off"}).code, 0);
  EXPECT_EQ(run({"check", "--quiet", "--format", "off", "--", "--json"}).code, 0);
}

// Refusals.

TEST_F(CliTest, RefusedInputLeavesNothingBehind) {
  put("out.stl", "precious");
  put("broken.off", cube("0", "1").substr(0, 40));
  put("part.xyz", "no one knows");
  const auto before = names();
  expect_error(run({"union", "a.off", "missing.stl", "-o", "out.stl", "--json"}), 1, "missing-file", "missing.stl");
  expect_error(run({"union", "a.off", "part.xyz", "-o", "out.stl", "--json"}), 1, "unknown-format", "part.xyz");
  const Outcome broken = run({"union", "a.off", "broken.off", "-o", "out.stl", "--json"});
  EXPECT_EQ(broken.code, 1);
  EXPECT_EQ(broken.json()["error"]["file"], "broken.off");
  EXPECT_EQ(names(), before);
  EXPECT_EQ(get("out.stl"), "precious");
}

TEST_F(CliTest, OutputThatCannotBeWrittenIsRefused) {
  const auto before = names();
  expect_error(run({"convert", "a.off", "-o", "nowhere/out.stl", "--json"}), 1, "unwritable", "nowhere/out.stl");
  expect_error(run({"convert", "a.off", "-o", "out.xyz", "--json"}), 1, "unknown-format", "out.xyz");
  EXPECT_EQ(names(), before);
}

TEST_F(CliTest, HalfWrittenOutputNeverAppears) {
  const auto before = names();
  // A binary STL of two cubes' union needs more than 1024 bytes.
  const Outcome r = run({"union", "a.off", "b.off", "-o", "out.stl", "--json"}, "", 1024);
  expect_error(r, 1, "unwritable", "out.stl");
  EXPECT_EQ(names(), before);
}

TEST_F(CliTest, ErrorsWithoutJsonKeepStdoutEmpty) {
  const Outcome r = run({"info", "missing.stl"});
  EXPECT_EQ(r.code, 1);
  EXPECT_EQ(r.out, "");
  expect_sentence(r, "missing-file");
  EXPECT_NE(r.err.find("(missing.stl"), std::string::npos) << r.err;
}

TEST_F(CliTest, FileNamesThatAreNotTextStayPrintable) {
  expect_error(run({"info", "no\xff\n.stl", "--json"}), 1, "missing-file", "no\xEF\xBF\xBD\n.stl");
}

// Interruption.

TEST_F(CliTest, InterruptedRunLeavesNothingBehind) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const auto before = names();
    std::array<int, 2> pipe = {};
    ASSERT_EQ(::pipe2(pipe.data(), O_CLOEXEC), 0);
    const pid_t child = start({"convert", "-", "-o", "out.stl", "--format", "off", "--json"}, pipe[0]);
    ::close(pipe[0]);
    // More than a pipe holds: once all is written the program is reading, and waits for the rest.
    const std::string text = "OFF\n" + std::string(std::size_t{4} << 20, ' ');
    std::size_t written = 0;
    while (written < text.size()) {
      const auto count = ::write(pipe[1], text.data() + written, text.size() - written);
      ASSERT_GT(count, 0);
      written += static_cast<std::size_t>(count);
    }
    ASSERT_EQ(::kill(child, signal), 0);
    const Outcome r = finish(child);
    ::close(pipe[1]);
    expect_error(r, 130, "cancelled");
    EXPECT_EQ(names(), before);
  }
}

}  // namespace
}  // namespace quoin::cli_test
