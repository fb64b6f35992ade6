#include "tests/cli/support.h"

namespace quoin::cli_test {
namespace {

TEST_F(CliTest, ConvertKeepsTheSolidInEveryFormat) {
  const std::vector<std::pair<std::string, std::string>> formats = {
      {"stl", "stl"}, {"stl-ascii", "stl"}, {"obj", "obj"},   {"off", "off"}, {"ply", "ply"},    {"ply-ascii", "ply"},
      {"3mf", "3mf"}, {"glb", "glb"},       {"gltf", "gltf"}, {"amf", "amf"}, {"quoin", "quoin"}};
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
    const Outcome r = run({"convert", "far.off", "-o", name, "--step", "1", "--json", "--fast"});
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(r.json()["export"]["collapsed"], collapsed) << name;
    EXPECT_EQ(r.json()["export"]["flipped"], 0) << name;
    EXPECT_EQ(r.json()["volume"], "1");
  }
}

// The same cube is nothing in valid float32, and a word is said about it. Recentred it is there.
TEST_F(CliTest, FarSolidsAreRecentredOnRequest) {
  put("far.off", cube("67108864", "67108865"));
  const Outcome lost = run({"convert", "far.off", "-o", "out.stl", "--step", "1", "--json"});
  ASSERT_EQ(lost.code, 0) << lost.err;
  EXPECT_NE(lost.err.find("nothing is left"), std::string::npos) << lost.err;
  EXPECT_EQ(lost.json()["export"]["valid"], true);
  EXPECT_EQ(run({"convert", "far.off", "-o", "out.stl", "--step", "1", "--quiet"}).err, "");

  const Outcome kept = run({"convert", "far.off", "-o", "out.stl", "--step", "1", "--json", "--recentre"});
  ASSERT_EQ(kept.code, 0) << kept.err;
  EXPECT_EQ(kept.err, "");
  EXPECT_EQ(kept.json()["max_round"], 0);
  EXPECT_EQ(kept.json()["export"]["recentred"], (std::vector<double>{67108864.5, 67108864.5, 67108864.5}));
  EXPECT_EQ(run({"info", "out.stl", "--json"}).json()["volume"], "1");
  EXPECT_EQ(run({"convert", "far.off", "-o", "out.stl", "--fast", "--valid"}).code, 2);
}

// The second way: triangulating large faces asks for signs. A file and its summary ask for as many as the summary
// alone.
TEST_F(CliTest, ConvertTriangulatesOnce) {
  put("prism.json", R"({"quoin-model": 1, "step": "1/1000", "model":
    {"cylinder": {"radius": 10, "height": 4, "sides": 200}}})");
  ASSERT_EQ(run({"eval", "prism.json", "-o", "prism.quoin"}).code, 0);
  const auto signs = [&](Words words) {
    for (const char* option : {"--json", "--stats", "--threads", "1"}) words.push_back(option);
    return run(words).json()["statistics"]["filter"].get<std::uint64_t>();
  };
  const std::uint64_t info = signs({"info", "prism.quoin"});
  EXPECT_GT(info, signs({"check", "prism.quoin"}));
  for (const char* topology : {"manifold", "indexed"})
    EXPECT_EQ(signs({"convert", "prism.quoin", "-o", "out.off", "--output-topology", topology}), info) << topology;
}

TEST_F(CliTest, AsciiVariantIsChosenByFormat) {
  ASSERT_EQ(run({"convert", "a.off", "-o", "text.stl", "--format", "stl-ascii"}).code, 0);
  ASSERT_EQ(run({"convert", "a.off", "-o", "binary.stl"}).code, 0);
  EXPECT_EQ(get("text.stl").rfind("solid", 0), 0U);
  EXPECT_EQ(get("binary.stl").size(), 84U + 12U * 50U);
}

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

}  // namespace
}  // namespace quoin::cli_test
