// Models as JSON: written, read, evaluated, refused.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/api/solids.h"

namespace quoin {
namespace {

using api_test::box;
using api_test::volume;

std::string told(const Error& e) { return to_string(e.code) + ": " + e.message + " (" + e.file + ", " + e.where + ")"; }

Model read_model(const std::string& text, const std::string& folder = ".") {
  auto model = Model::from_json(text, folder);
  if (!model) ADD_FAILURE() << told(model.error()) << "\n" << text.substr(0, 1000);
  return model ? std::move(model).value() : Model();
}

Solid evaluated(const Model& model, const ModelOptions& options = {}) {
  auto solid = evaluate(model, options);
  if (!solid) ADD_FAILURE() << told(solid.error());
  return solid ? std::move(solid).value() : Solid();
}

ModelOptions on_grid(const std::string& step) { return {.grid = api_test::grid_of(step)}; }

/// A document around a node, and perhaps other members.
std::string document(const std::string& node, const std::string& members = "") {
  return "{\"quoin-model\": 1, " + members + (members.empty() ? "" : ", ") + "\"model\": " + node + "}";
}

std::string volume_of(const std::string& node, const std::string& members = "", const ModelOptions& options = {}) {
  return volume(evaluated(read_model(document(node, members)), options));
}

/// "where: code" of a text that is refused, "" of one that is read.
std::string refusal(const std::string& text) {
  const auto model = Model::from_json(text);
  return model ? "" : model.error().where + ": " + to_string(model.error().code);
}

void expect_refused(const std::string& text, const std::string& where, const std::string& words) {
  const auto model = Model::from_json(text);
  ASSERT_FALSE(model) << text;
  EXPECT_EQ(model.error().code, ErrorCode::bad_model) << text;
  EXPECT_EQ(model.error().where, where) << text;
  EXPECT_NE(model.error().message.find(words), std::string::npos) << model.error().message << "\n" << text;
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

/// What is written is read as the same text and the same solid.
void expect_stays(const Model& model, const ModelOptions& options = on_grid("1/100000")) {
  const std::string text = model.to_json();
  const Model again = read_model(text);
  EXPECT_EQ(again.to_json(), text);
  EXPECT_TRUE(evaluated(again, options) == evaluated(model, options)) << text;
}

Model brick() { return Model::block({"1", "2", "3"}); }

TEST(ModelFile, EveryPrimitiveStays) {
  const std::vector<std::pair<Model, std::string>> models{
      {brick(), "6"},
      {Model::wedge({"2", "3", "4"}, "1"), "10"},
      {Model::prism("4", "1", "3"), "6"},
      {Model::cylinder("2", "1/2", "4"), "4"},
      {Model::cylinder("2", "1/2", "4", Fit::circumscribed), "8"},
      {Model::frustum("2", "1", "3", "4"), "14"},
      {Model::frustum("0", "1", "3", "4"), "2"},
      {Model::cone("1", "3", "4"), "2"},
      {Model::sphere("3", "4"), "36"},
      {Model::torus("3", "1", "4", "4"), "24"},
      {Model::convex({{"1", "0", "0", "-1"},
                      {"-1", "0", "0", "0"},
                      {"0", "1", "0", "-2"},
                      {"0", "-1", "0", "0"},
                      {"0", "0", "1", "-3"},
                      {"0", "0", "-1", "0"}}),
       "6"},
      {Model::hull({{"0", "0", "0"}, {"6", "0", "0"}, {"0", "6", "0"}, {"0", "0", "1"}, {"1", "1", "0"}}), "6"},
      {Model::extrusion({{{{"0", "0"}, {"4", "0"}, {"4", "4"}, {"0", "4"}}, {{"1", "1"}, {"2", "1"}, {"1", "2"}}},
                         {{{"5", "0"}, {"6", "0"}, {"5", "1"}}}},
                        {"1", "0", "2"}),
       "32"},
      {brick() & Model::half_space({"0", "0", "1", "-1/2"}), "1"},
      {Model::solid(box({0, 0, 0}, {1, 2, 4}, api_test::grid_of("1/8"))), "8"},
      {Model(), "0"},
  };
  for (const auto& [model, size] : models) {
    EXPECT_EQ(volume(evaluated(model, on_grid("1/1000"))), size) << model.to_json();
    expect_stays(model);
  }
  // These have round numbers of faces alone.
  expect_stays(Model::tangent_sphere("2", "12"));
  expect_stays(Model::cylinder("1", "1", "8", Fit::equal_area));
  expect_stays(Model::cylinder("1", "1"));
  EXPECT_EQ(evaluated(Model::tangent_sphere("2", "12")).info().faces, 12U);
}

TEST(ModelFile, EveryMotionStays) {
  const Model b = brick();
  const std::vector<std::pair<Model, Solid>> models{
      {b.translated({"1", "-2", "1/2"}), box({1, -2, 0.5}, {2, 0, 3.5}, api_test::grid_of("1/8"))},
      {b.rotated({"0", "0", "2"}, "90"), box({-2, 0, 0}, {0, 1, 3})},
      {b.turned({"1", "0", "0", "-1"}), box({0, -1, 0}, {2, 0, 3})},
      {b.transformed({Text3{"0", "0", "1"}, {"1", "0", "0"}, {"0", "1", "0"}}), box({0, 0, 0}, {3, 1, 2})},
      {b.mirrored({"0", "5", "0"}), box({0, -2, 0}, {1, 0, 3})},
      {b.scaled({"2", "3/2", "1"}), box({0, 0, 0}, {2, 3, 3})},
      {b.translated({"1", "0", "0"}).rotated({"0", "0", "1"}, "-90"), box({0, -2, 0}, {2, -1, 3})},
  };
  for (const auto& [model, solid] : models) {
    EXPECT_TRUE(evaluated(model, on_grid("1/8")) == solid) << model.to_json();
    expect_stays(model);
  }
  expect_stays(b.rotated({"1", "2", "3"}, "17.5").translated({"0.1", "1e-2", "1/3"}));
  expect_stays(b.turned({"4", "1", "-2", "3"}).mirrored({"1", "1", "0"}));
  // A solid without history moves as one primitive.
  expect_stays(Model::solid(box({0, 0, 0}, {1, 2, 4}, api_test::grid_of("1/8"))).rotated({"0", "0", "1"}, "30"));
}

TEST(ModelFile, EveryBooleanStays) {
  const Model a = brick(), b = Model::block({"2", "1", "1"}), c = Model::block({"1/2", "1/2", "4"});
  const std::vector<std::pair<Model, std::string>> models{
      {a + b, "7"},
      {a & b, "1"},
      {a - b, "5"},
      {a ^ b, "6"},
      {a - ~b, "1"},
      {Model::unite({a, b, c}), "29/4"},
      {Model::intersect({a, b, c}), "1/4"},
      {Model::symmetric_difference({a, b, c}), "6"},
      {Model::difference(a, {b, c}), "9/2"},
      {Model::difference(a, {}), "6"},
      {Model::unite({}), "0"},
      {Model::from_json(R"({"quoin-model": 1, "model": {"difference": []}})").value(), "0"},
      {Model::symmetric_difference({}), "0"},
      {Model::intersect({}), "unbounded"},
      {~a, "unbounded"},
      {a + Model(), "6"},
  };
  for (const auto& [model, size] : models) {
    EXPECT_EQ(volume(evaluated(model, on_grid("1/1000"))), size) << model.to_json();
    expect_stays(model);
  }
}

TEST(ModelFile, TextOfASmallModel) {
  const std::string text =
      "{\"quoin-model\": 1, \"model\": {\"block\": {\"size\": [1, 2.50, \"1/3\"]}, \"name\": \"b\"}}\n";
  EXPECT_EQ(Model::block({"1", "2.50", "1/3"}).named("b").to_json(), text);
  EXPECT_EQ(read_model(text).to_json(), text);
  EXPECT_EQ(Model().to_json(), "{\"quoin-model\": 1, \"model\": {\"union\": []}}\n");
  // Numbers that JSON spells otherwise, or that programs might round, are texts.
  EXPECT_EQ(Model::block({"+1", "1234567890123456", ".5"}).to_json(),
            "{\"quoin-model\": 1, \"model\": {\"block\": {\"size\": [\"+1\", \"1234567890123456\", \".5\"]}}}\n");
}

TEST(ModelFile, NumbersAreExact) {
  EXPECT_EQ(volume_of(R"({"block": {"size": [0.1, "1/3", 3e1]}})", R"("step": "1/30")"), "1");
  EXPECT_EQ(volume_of(R"({"block": {"size": ["(1 + 1/2) * 2", 1, "1e-1 * 10"]}})"), "3");
}

TEST(ModelFile, Defaults) {
  const auto json = [](const std::string& node) { return read_model(document(node)).to_json(); };
  EXPECT_EQ(json(R"({"cylinder": {"radius": 1, "height": 2}})"), Model::cylinder("1", "2").to_json());
  EXPECT_EQ(json(R"({"frustum": {"height": 3, "top": 2, "bottom": 1}})"), Model::frustum("1", "2", "3").to_json());
  EXPECT_EQ(json(R"({"cone": {"radius": 1, "height": 2}})"), Model::cone("1", "2").to_json());
  EXPECT_EQ(json(R"({"sphere": {"radius": 1}})"), Model::sphere("1").to_json());
  EXPECT_EQ(json(R"({"tangent-sphere": {"radius": 1}})"), Model::tangent_sphere("1").to_json());
  EXPECT_EQ(json(R"({"torus": {"major": 2, "minor": 1}})"), Model::torus("2", "1").to_json());
  EXPECT_EQ(json(R"({"cylinder": {"radius": 1, "height": 2, "sides": 5, "fit": "equal-area"}})"),
            Model::cylinder("1", "2", "5", Fit::equal_area).to_json());
}

TEST(ModelFile, ShortWays) {
  const auto json = [](const std::string& motion) {
    const std::string of = R"("of": {"block": {"size": [1, 2, 3]}})";
    return read_model(document(motion.substr(0, motion.size() - 2) + ", " + of + "}}")).to_json();
  };
  EXPECT_EQ(json(R"({"rotate": {"axis": "x", "angle": 5}})"), brick().rotated({"1", "0", "0"}, "5").to_json());
  EXPECT_EQ(json(R"({"rotate": {"axis": "y", "angle": 5}})"), brick().rotated({"0", "1", "0"}, "5").to_json());
  EXPECT_EQ(json(R"({"rotate": {"axis": "z", "angle": 5}})"), brick().rotated({"0", "0", "1"}, "5").to_json());
  EXPECT_EQ(json(R"({"mirror": {"normal": "y"}})"), brick().mirrored({"0", "1", "0"}).to_json());
  EXPECT_EQ(json(R"({"scale": {"factors": 2}})"), brick().scaled({"2", "2", "2"}).to_json());
  EXPECT_EQ(json(R"({"scale": {"factors": "a + 1"}})"), brick().scaled({"a + 1", "a + 1", "a + 1"}).to_json());
  EXPECT_EQ(refusal(document(R"({"translate": {"by": "x", "of": {"union": []}}})")), "line 1, column 52: bad-model");
  EXPECT_EQ(refusal(document(R"({"rotate": {"axis": "w", "angle": 1, "of": {"union": []}}})")),
            "line 1, column 51: bad-model");
}

TEST(ModelFile, SharedPartsStayShared) {
  const Model pin = Model::cylinder("1", "5", "6").named("pin"), other = Model::block({"1", "1", "1"});
  const Model pair = pin + pin.translated({"4", "0", "0"});
  const Model both = Model::unite({pair, pair.translated({"0", "9", "0"}), other, other.translated({"9", "9", "9"})});
  const std::string text = both.to_json();
  EXPECT_EQ(count(text, "\"cylinder\""), 1U) << text;
  EXPECT_EQ(count(text, "\"block\":"), 2U) << text;  // the part and the node
  EXPECT_EQ(count(text, "{\"part\": \"pin\"}"), 2U) << text;
  EXPECT_EQ(count(text, "{\"part\": \"union\"}"), 2U) << text;
  EXPECT_EQ(count(text, "{\"part\": \"block\"}"), 2U) << text;
  expect_stays(both);
  // Parts of one name.
  const Model a = Model::block({"1", "1", "1"}).named("p"), b = Model::block({"1", "1", "2"}).named("p");
  const Model same_names = Model::unite({a, b, a, b}) - Model::unite({other, other});
  EXPECT_EQ(count(same_names.to_json(), "{\"part\": \"p 2\"}"), 2U) << same_names.to_json();
  expect_stays(same_names);
}

TEST(ModelFile, SharingKeepsTextsShort) {
  Model model = brick();
  for (int i = 0; i < 60; ++i) model = model + model;
  const std::string text = model.to_json();
  EXPECT_LT(text.size(), 10000U);
  EXPECT_EQ(read_model(text).to_json(), text);
  Model small = brick();
  for (int i = 0; i < 12; ++i) small = small + small;
  EXPECT_EQ(volume(evaluated(read_model(small.to_json()))), "6");
}

TEST(ModelFile, DeepModels) {
  Model model = brick();
  for (int i = 0; i < 10000; ++i) model = model.translated({"1", "0", "0"});
  const std::string text = model.to_json();
  const Model again = read_model(text);
  EXPECT_TRUE(evaluated(again, on_grid("1")) == box({10000, 0, 0}, {10001, 2, 3}));
}

TEST(ModelFile, DeepBooleans) {
  const Model b = Model::block({"2", "2", "2"});
  Model model = brick();
  for (int i = 0; i < 700; ++i) model = ~(model & b);
  const std::string text = model.to_json();
  const Model again = read_model(text);
  EXPECT_EQ(again.to_json(), text);
  EXPECT_TRUE(evaluated(again) == evaluated(model));
}

TEST(ModelFile, ManyParts) {
  std::vector<Model> terms;
  for (int i = 0; i < 1000; ++i) {
    terms.push_back(Model::block({"1", "1", std::to_string(i + 1)}));
    terms.push_back(terms.back());
  }
  const std::string text = Model::unite(terms).to_json();
  EXPECT_EQ(count(text, "{\"part\": "), 2000U);
  EXPECT_EQ(read_model(text).to_json(), text);
}

TEST(ModelFile, NamesStay) {
  const Model odd = Model::block({"1", "1", "1"}).named("a \"b\"\n\xc3\xa9 {\"part\": 1}");
  expect_stays(odd + odd.translated({"1", "0", "0"}));
  expect_stays(brick().named("name").rotated({"0", "0", "1"}, "90").named("part"));
  expect_stays((brick().with_parameters({{"a", "1"}}).named("scope")));
  // What is no UTF-8 is replaced; two parts must not get one name by that.
  const Model x = Model::block({"1", "1", "1"}).named("\xff"), y = Model::block({"1", "2", "1"}).named("\xfe");
  EXPECT_EQ(refusal(Model::unite({x, x, y, y}).to_json()), "");
}

TEST(ModelFile, Parameters) {
  const std::string node = R"({"block": {"size": ["a", "b", "a + b"]}})";
  const std::string members = R"("parameters": {"a": 2, "b": "c * 3", "c": "1/2", "unused": "1/0"})";
  EXPECT_EQ(volume_of(node, members), "21/2");
  EXPECT_EQ(volume_of(node, members, {.parameters = {{"a", "1"}}}), "15/4");
  EXPECT_EQ(volume_of(node, members, {.parameters = {{"c", "2 * a"}}}), "336");
  EXPECT_EQ(volume_of(node, "", {.parameters = {{"a", "1"}, {"b", "0.5"}}}), "3/4");
  const auto missing = evaluate(read_model(document(node)));
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::bad_parameter);
  EXPECT_EQ(missing.error().where, "block at line 1, column 29");
  expect_stays(Model::block({"a", "b", "a + b"}).with_parameters({{"a", "2"}, {"b", "a * 3"}}));
  expect_stays(brick().rotated({"0", "0", "1"}, "a").with_parameters({{"a", "2"}}) + brick());
}

// The inner definition hides the outer one; the caller's holds everywhere.
TEST(ModelFile, NestedScopes) {
  const auto scope = [](const std::string& definitions, const std::string& of) {
    return R"({"scope": {"parameters": {)" + definitions + R"(}, "of": )" + of + "}}";
  };
  const std::string b = R"({"block": {"size": ["a", "b", 1]}})";
  const std::string moved = R"({"translate": {"by": [100, 0, 0], "of": )" + b + "}}";
  const std::string outer = R"("parameters": {"a": 2, "b": "10 * a"})";
  const std::string both = R"({"union": [)" + scope(R"("a": 3)", b) + ", " + moved + "]}";
  EXPECT_EQ(volume_of(both, outer), "130");
  EXPECT_EQ(volume_of(both, outer, {.parameters = {{"a", "1"}}}), "20");
  EXPECT_EQ(volume_of(R"({"union": [)" + scope(R"("b": 1)", scope(R"("a": 5)", b)) + "]}", outer), "5");
  EXPECT_EQ(
      volume_of(R"({"union": [)" + scope(R"("a": 7)", R"({"union": [)" + scope(R"("a": 5)", b) + "]}") + "]}", outer),
      "250");
  const auto cycle = evaluate(read_model(document(R"({"union": [)" + scope(R"("a": "a + 1")", b) + "]}", outer)));
  ASSERT_FALSE(cycle);
  EXPECT_EQ(cycle.error().code, ErrorCode::bad_parameter);
  // A part sees the parameters of where it is used.
  EXPECT_EQ(volume_of(R"({"union": [)" + scope(R"("a": 3)", R"({"part": "p"})") +
                          R"(, {"translate": {"by": [100, 0, 0], "of": {"part": "p"}}}]})",
                      outer + R"(, "parts": {"p": )" + b + "}"),
            "130");
  expect_stays(read_model(document(both, outer)));
  expect_stays(read_model(document(R"({"union": [)" + scope(R"("a": 3)", both) + "]}", outer)));
}

// Scopes without a node between them.
TEST(ModelFile, ScopesOfScopes) {
  const std::string b = R"({"block": {"size": ["a", 1, 1]}})";
  const std::string two = R"({"scope": {"parameters": {"a": 2}, "of": )" + b + "}}";
  const std::string three = R"({"scope": {"parameters": {"a": 3}, "of": )" + two + "}}";
  EXPECT_EQ(volume_of(two), "2");
  EXPECT_EQ(volume_of(two, R"("parameters": {"a": 1})"), "2");
  EXPECT_EQ(volume_of(three), "2");
  EXPECT_EQ(volume_of(R"({"union": [)" + three + "]}"), "2");
  EXPECT_EQ(volume_of(R"({"scope": {"parameters": {"a": 3}, "of": {"part": "p"}}})", R"("parts": {"p": )" + two + "}"),
            "2");
}

TEST(ModelFile, Steps) {
  const std::string node = R"({"block": {"size": [1, 1, "1/7"]}})";
  const auto step = [&](const std::string& n, const std::string& members, const ModelOptions& options = {}) {
    return evaluated(read_model(document(n, members)), options).grid().step();
  };
  EXPECT_EQ(step(node, R"("step": "1/14")"), "1/14");
  EXPECT_EQ(step(node, R"("step": 1e-3)"), "1/1000");
  EXPECT_EQ(step(node, R"("step": "1/14")", on_grid("1/700")), "1/700");
  EXPECT_EQ(step(R"({"union": [{"scope": {"step": "1/21", "of": )" + node + "}}]}", ""), "1/21");
  EXPECT_EQ(step(R"({"union": [{"scope": {"step": "1/21", "of": )" + node + "}}]}", R"("step": "1/14")"), "1/14");
  EXPECT_EQ(step(R"({"scope": {"step": "1/21", "of": )" + node + "}}", R"("step": "1/14")"), "1/14");
  expect_stays(brick().with_step("1/9"));
  expect_stays(brick().with_step("1e-3").translated({"1", "0", "0"}));
  for (const std::string bad : {"0", "-1", "\"a\"", "\"1/2 * 3\"", "[1]", "null"})
    EXPECT_EQ(refusal(document(node, "\"step\": " + bad)).substr(0, 15), "line 1, column ") << bad;
}

TEST(ModelFile, InlineSolids) {
  const Solid cube = box({0, 0, 0}, {2, 2, 2}, api_test::grid_of("1/3"));
  const std::string text = Model::solid(cube).to_json();
  EXPECT_NE(text.find("quoin 1\\ngrid 1/3 0 0 0\\n"), std::string::npos);
  EXPECT_TRUE(evaluated(read_model(text)) == cube);
  EXPECT_EQ(evaluated(read_model(text)).grid().step(), "1/3");
  expect_stays(Model::solid(~cube) & brick());
  expect_stays(Model::solid(~cube).translated({"1", "0", "0"}), on_grid("1/3"));
  EXPECT_EQ(refusal(document(R"({"solid": {"quoin": "quoin 2\n"}})")), "line 1, column 59: bad-model");
  EXPECT_EQ(refusal(document(R"({"solid": {}})")), "line 1, column 39: bad-model");
  EXPECT_EQ(refusal(document(R"({"solid": {"quoin": 1}})")), "line 1, column 39: bad-model");
}

TEST(ModelFile, MeshesOfAFolder) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / ("quoin_models_" + std::to_string(std::random_device()()));
  fs::create_directories(folder / "deep");
  const Solid tetrahedron = api_test::tetrahedron({api_test::Corner{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 2}});
  std::ofstream(folder / "deep" / "t.off") << "OFF\n4 4 0\n0 0 0\n3 0 0\n0 3 0\n0 0 2\n"
                                           << "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  ASSERT_TRUE(box({0, 0, 0}, {1, 1, 4}).write((folder / "b.stl").string()));
  ASSERT_TRUE(tetrahedron.write((folder / "t.quoin").string()));

  const Model off = read_model(document(R"({"mesh": {"file": "deep/t.off"}, "name": "tip"})"), folder.string());
  EXPECT_TRUE(evaluated(off) == tetrahedron);
  expect_stays(off);
  // It was read with the model: the text holds it.
  EXPECT_EQ(count(off.to_json(), "t.off"), 0U);
  EXPECT_EQ(count(off.to_json(), "\"name\": \"tip\""), 1U);
  const Model both = read_model(
      document(R"({"union": [{"mesh": {"file": "b.stl"}}, {"mesh": {"file": "t.quoin"}}]})", R"("step": "1/8")"),
      folder.string());
  EXPECT_EQ(volume(evaluated(both)), volume(box({0, 0, 0}, {1, 1, 4}) + tetrahedron));
  const std::string absolute = document("{\"mesh\": {\"file\": \"" + (folder / "b.stl").string() + "\"}}");
  EXPECT_EQ(Model::from_json(absolute, "/nowhere").error().code, ErrorCode::bad_model);
  const auto anywhere = Model::from_json(absolute, "/nowhere", nullptr, {.files = ModelFiles::anywhere});
  ASSERT_TRUE(anywhere);
  EXPECT_EQ(volume(evaluated(anywhere.value())), "4");

  const auto missing = Model::from_json(document(R"({"mesh": {"file": "no.stl"}})"), folder.string());
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::missing_file);
  EXPECT_EQ(missing.error().file, folder.string() + "/no.stl");

  // From a file: meshes are beside it, and errors name the file at fault.
  const auto written = [&](const std::string& text) {
    const std::string path = (folder / "model.json").string();
    std::ofstream(path) << text;
    return Model::read(path);
  };
  const auto read = written(document(R"({"mesh": {"file": "b.stl"}})"));
  ASSERT_TRUE(read);
  EXPECT_EQ(volume(evaluated(read.value())), "4");
  EXPECT_EQ(written(document(R"({"mesh": {"file": "no.stl"}})")).error().file, folder.string() + "/no.stl");
  const auto broken = written("{");
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.error().file, (folder / "model.json").string());
  EXPECT_EQ(broken.error().code, ErrorCode::bad_model);
  const auto absent = Model::read((folder / "absent.json").string());
  ASSERT_FALSE(absent);
  EXPECT_EQ(absent.error().code, ErrorCode::missing_file);
  EXPECT_EQ(absent.error().file, (folder / "absent.json").string());
  EXPECT_EQ(refusal(document(R"({"mesh": {}})")), "line 1, column 38: bad-model");
  EXPECT_EQ(refusal(document(R"({"mesh": {"file": 1}})")), "line 1, column 38: bad-model");
  EXPECT_EQ(refusal(document(R"({"mesh": {"file": "a", "unit": "mm"}})")), "line 1, column 63: bad-model");
  fs::remove_all(folder);
}

TEST(ModelFile, ImportsOfMeshes) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / ("quoin_imports_" + std::to_string(std::random_device()()));
  fs::create_directories(folder);
  const std::string mesh = (folder / "two.off").string(), exact = (folder / "b.quoin").string();
  // Two tetrahedra, the second one inside out.
  std::ofstream(mesh) << "OFF\n8 8 0\n0 0 0\n3 0 0\n0 3 0\n0 0 2\n9 0 0\n10 0 0\n9 1 0\n9 0 1\n"
                      << "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n3 4 5 6\n3 4 7 5\n3 5 7 6\n3 6 7 4\n";
  ASSERT_TRUE(box({0, 0, 0}, {1, 1, 4}).write(exact));

  const std::string text = document(R"({"union": [{"mesh": {"file": "b.quoin"}}, {"part": "p"}, {"part": "p"}]})",
                                    R"("parts": {"p": {"mesh": {"file": "two.off"}}})");
  std::vector<MeshImport> imports(5);
  const auto model = Model::from_json(text, folder.string(), &imports);
  ASSERT_TRUE(model) << told(model.error());
  ASSERT_EQ(imports.size(), 2U);
  // In the order of the text: parts come first.
  EXPECT_EQ(imports[0].file, mesh);
  EXPECT_EQ(imports[0].report.dropped_shells, 1U);
  EXPECT_EQ(imports[0].report.dropped_where, "shell at (9, 0, 0)");
  EXPECT_EQ(imports[1].file, exact);
  EXPECT_EQ(imports[1].report.dropped_shells, 0U);
  ImportReport alone;
  ASSERT_TRUE(read_solid(mesh, {}, &alone));
  EXPECT_EQ(imports[0].report.dropped_where, alone.dropped_where);

  // A model that is not read, and one without meshes, have none.
  const std::string path = (folder / "model.json").string();
  EXPECT_FALSE(Model::read(path, &imports));
  EXPECT_TRUE(imports.empty());
  std::ofstream(path) << text;
  ASSERT_TRUE(Model::read(path, &imports));
  EXPECT_EQ(imports.size(), 2U);
  ASSERT_TRUE(Model::from_json(document(R"({"union": []})"), ".", &imports));
  EXPECT_TRUE(imports.empty());
  fs::remove_all(folder);
}

// Files of one model state one unit, or are converted to the one that is asked for.
TEST(ModelFile, UnitsOfMeshes) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / ("quoin_units_" + std::to_string(std::random_device()()));
  fs::create_directories(folder);
  const Mesh mesh = box({0, 0, 0}, {1, 1, 1}).to_triangles().value();
  const auto put = [&](const char* name, Format format, Unit unit) {
    std::ofstream(folder / name, std::ios::binary) << to_bytes(mesh, format, unit).value();
  };
  put("inch.3mf", Format::threemf, Unit::inch);
  put("foot.amf", Format::amf, Unit::foot);
  put("none.off", Format::off, Unit::none);
  const auto text = [](const std::string& a, const std::string& b) {
    return document(R"({"union": [{"mesh": {"file": ")" + a + R"("}}, {"mesh": {"file": ")" + b + R"("}}]})");
  };

  std::vector<MeshImport> imports;
  ASSERT_TRUE(Model::from_json(text("none.off", "inch.3mf"), folder.string(), &imports));
  ASSERT_EQ(imports.size(), 2U);
  EXPECT_EQ(imports[0].unit, Unit::none);
  EXPECT_EQ(imports[1].unit, Unit::inch);

  const auto mixed = Model::from_json(text("inch.3mf", "foot.amf"), folder.string());
  ASSERT_FALSE(mixed);
  EXPECT_EQ(mixed.error().code, ErrorCode::mixed_units);
  EXPECT_EQ(mixed.error().file, (folder / "foot.amf").string());
  EXPECT_EQ(Model::from_json(text("foot.amf", "inch.3mf"), folder.string()).error().code, ErrorCode::mixed_units);

  // The cube of an inch lies in that of a foot, or touches nothing outside.
  const auto inches = Model::from_json(text("inch.3mf", "foot.amf"), folder.string(), &imports, {.unit = Unit::inch});
  ASSERT_TRUE(inches) << told(inches.error());
  EXPECT_EQ(volume(evaluated(inches.value())), "1728");
  EXPECT_EQ(imports[1].unit, Unit::inch);
  fs::remove_all(folder);
}

TEST(ModelFile, NotAModel) {
  EXPECT_EQ(refusal("").substr(0, 5), "line ");
  expect_refused("solid cube", "line 1, column 1", "not JSON");
  expect_refused(document("{\"block\": {\"size\": [1, 2, 3]}}") + "}", "line 1, column 60", "not JSON");
  expect_refused("[]", "line 1, column 1", "an object");
  expect_refused("{}", "line 1, column 1", "\"quoin-model\": 1 is missing");
  expect_refused("{\"quoin-model\": 1}", "line 1, column 1", "\"model\" is missing");
  expect_refused("{\"model\": {\"union\": []}}", "line 1, column 1", "\"quoin-model\": 1 is missing");
}

// A scope at the top is that of the document, unless it would be lost there.
TEST(ModelFile, ScopesThatSayNothingStay) {
  const std::string inner = R"({"scope": {"parameters": {"a": 1}, "of": {"block": {"size": ["a", 1, 1]}}}})";
  for (const std::string& text :
       {document(inner, R"("parameters": {})"), document(R"({"scope": {"of": )" + inner + "}}")}) {
    const Model model = read_model(text);
    const std::string written = model.to_json();
    EXPECT_EQ(read_model(written).to_json(), written) << text;
    EXPECT_EQ(volume(evaluated(model)), "1");
  }
  const Model made = Model::block({"a", "1", "1"}).with_parameters({{"a", "1"}}).named("part").with_parameters({});
  EXPECT_EQ(read_model(made.to_json()).to_json(), made.to_json());
}

TEST(ModelFile, Versions) {
  for (const std::string version : {"2", "0", "1.0", "\"1\"", "null", "[1]"}) {
    const auto model = Model::from_json("{\n\"quoin-model\": " + version + ", \"model\": {\"union\": []}}");
    ASSERT_FALSE(model) << version;
    EXPECT_EQ(model.error().code, ErrorCode::bad_model);
    EXPECT_EQ(model.error().where.rfind("line 2, column ", 0), 0U) << model.error().where;
    EXPECT_NE(model.error().message.find("version"), std::string::npos);
  }
  // Before anything else of the document.
  expect_refused("{\"new\": [], \"quoin-model\": \"2\"}", "line 1, column 30", "version");
}

TEST(ModelFile, UnknownMembers) {
  expect_refused(document("{\"union\": []}", "\n\"units\": \"mm\""), "line 2, column 13",
                 "\"units\" is not known here");
  expect_refused(document("{\"block\": {\"size\": [1, 2, 3],\n \"centre\": \"yes\"}}"), "line 2, column 16",
                 "\"centre\" is not known in \"block\"; known are: size");
  expect_refused(document("{\"block\": {\"size\": [1, 2, 3], \"of\": {}}}"), "line 1, column 65",
                 "\"of\" is not known");
  expect_refused(document("{\"mirror\": {\"normal\": \"x\", \"by\": [], \"of\": {\"union\": []}}}"),
                 "line 1, column 62", "known are: normal, of");
  expect_refused(document("{\"block\": {\"size\": [1, 2, 3], \"step\": \"1\"}}"), "line 1, column 69", "is not known");
  expect_refused(document("{\"solid\": {\"file\": \"a\"}}"), "line 1, column 50", "\"file\" is not known in \"solid\"");
  expect_refused(document("{\"cube\": {}}"), "line 1, column 29", "\"cube\" is no kind of node");
  expect_refused(document("{\"Block\": {\"size\": [1, 2, 3]}}"), "line 1, column 29", "\"Block\" is no kind of node");
}

TEST(ModelFile, NodesAreObjectsOfOneKind) {
  expect_refused(document("[]"), "line 1, column 29", "a node is an object");
  expect_refused(document("\"block\""), "line 1, column 35", "a node is an object");
  expect_refused(document("{}"), "line 1, column 29", "one member");
  expect_refused(document("{\"name\": \"a\"}"), "line 1, column 29", "one member");
  expect_refused(document("{\"union\": [], \"intersection\": []}"), "line 1, column 29", "one member");
  expect_refused(document("{\"union\": [], \"name\": \"a\", \"id\": 1}"), "line 1, column 29", "one member");
  expect_refused(document("{\"union\": [], \"name\": [1]}"), "line 1, column 51", "a name is a text");
  expect_refused(document("{\"union\": {}}"), "line 1, column 39", "a list of nodes");
  expect_refused(document("{\"union\": [\n{\"union\": []}, []]}"), "line 2, column 16", "a node is an object");
  expect_refused(document("{\"block\": [1, 2, 3]}"), "line 1, column 39", "\"block\" is an object");
  expect_refused(document("{\"complement\": []}"), "line 1, column 44", "a node is an object");
}

TEST(ModelFile, MissingFields) {
  expect_refused(document("{\"block\": {}}"), "line 1, column 39", "\"block\" lacks \"size\"");
  expect_refused(document("{\"cylinder\":\n {\"radius\": 1}}"), "line 2, column 2", "\"cylinder\" lacks \"height\"");
  expect_refused(document("{\"rotate\": {\"axis\": \"z\", \"of\": {\"union\": []}}}"), "line 1, column 40",
                 "\"rotate\" lacks \"angle\"");
  expect_refused(document("{\"scale\": {\"factors\": 2}}"), "line 1, column 39", "\"scale\" lacks \"of\"");
  expect_refused(document("{\"scope\": {\"step\": \"1\"}}"), "line 1, column 39", "\"scope\" lacks \"of\"");
}

TEST(ModelFile, WrongCountsAndValues) {
  expect_refused(document("{\"block\": {\"size\": [1, 2]}}"), "line 1, column 48",
                 "\"size\" wants a list of 3 numbers");
  expect_refused(document("{\"block\": {\"size\": [\"1\", \"2\", true]}}"), "line 1, column 62", "wants a number");
  expect_refused(document("{\"block\": {\"size\": {}}}"), "line 1, column 48", "\"size\" wants a list of 3 numbers");
  expect_refused(document("{\"sphere\": {\"radius\": [1]}}"), "line 1, column 51", "\"radius\" wants a number");
  expect_refused(document("{\"half-space\": {\"plane\": [1, 0, 0]}}"), "line 1, column 54", "a list of 4 numbers");
  expect_refused(document("{\"convex\": {\"planes\": [[1, 0, 0, 0], [1]]}}"), "line 1, column 66", "of 4 numbers");
  expect_refused(document("{\"convex\": {\"planes\": {}}}"), "line 1, column 51", "\"planes\" wants a list");
  expect_refused(document("{\"extrusion\": {\"along\": [0, 0, 1], \"polygons\": [[[{}]]]}}"), "line 1, column 79",
                 "\"polygons\" wants a list of 2 numbers");
  expect_refused(document("{\"extrusion\": {\"along\": [0, 0, 1], \"polygons\": [[[[1, 2, 3]]]]}}"),
                 "line 1, column 79", "\"polygons\" wants a list of 2 numbers");
  expect_refused(document("{\"transform\": {\"matrix\": [[1, 0, 0], [0, 1, 0]], \"of\": {\"union\": []}}}"),
                 "line 1, column 43", "a matrix has three rows");
  expect_refused(document("{\"union\": []}", "\"parameters\": [1]"), "line 1, column 34", "an object of numbers");
  expect_refused(document("{\"union\": []}", "\"parameters\": {\"a\": [1]}"), "line 1, column 40", "a parameter is a");
  expect_refused(document("{\"union\": []}", "\"parameters\": {\"1a\": \"1\"}"), "line 1, column 43", "no name");
  expect_refused(document("{\"union\": []}", "\"parts\": []"), "line 1, column 29", "an object of named nodes");
}

TEST(ModelFile, Parts) {
  expect_refused(document("{\"part\": \"a\"}"), "line 1, column 40", "there is no part \"a\"");
  expect_refused(document("{\"part\": [\"a\"]}", "\"parts\": {\"a\": {\"union\": []}}"), "line 1, column 69",
                 "no part");
  expect_refused(document("{\"part\": \"a\"}", "\"parts\": {\"a\":\n {\"union\": [{\"part\": \"a\"}]}}"),
                 "line 2, column 2", "the part \"a\" contains itself");
  expect_refused(
      document("{\"union\": []}",
               "\"parts\": {\"a\": {\"union\": [{\"part\": \"b\"}]}, \"b\": {\"complement\": {\"part\": \"a\"}}}"),
      "line 1, column 35", "the part \"a\" contains itself");
  // A part that nothing uses is checked too.
  expect_refused(document("{\"union\": []}", "\"parts\": {\"a\":\n {\"cube\": {}}}"), "line 2, column 2",
                 "no kind of node");
  expect_refused(document("{\"union\": []}", "\"parts\": {\"a\": {\"part\": \"c\"}}"), "line 1, column 46",
                 "no part \"c\"");
  // Parts may come before those that they use, and be renamed.
  EXPECT_EQ(volume_of(R"({"part": "a", "name": "x"})",
                      R"("parts": {"a": {"union": [{"part": "b"}]}, "b": {"block": {"size": [1, 2, 3]}}})"),
            "6");
}

TEST(ModelFile, ErrorsOfEvaluationNameTheNode) {
  const auto failure = [](const std::string& node) {
    const auto solid = evaluate(read_model(document(node)));
    return solid ? "" : to_string(solid.error().code) + ", " + solid.error().where;
  };
  EXPECT_EQ(failure(R"({"block": {"size": [1, 2, "1 +"]}})"), "bad-number, block at line 1, column 29");
  EXPECT_EQ(failure(R"({"block": {"size": [1, 2, 0]}, "name": "b"})"),
            "bad-primitive, block \"b\" at line 1, column 29");
  EXPECT_EQ(failure("{\"union\": [\n {\"cone\": {\"radius\": 1, \"height\": 1, \"sides\": \"7/2\"}}]}"),
            "bad-number, cone at line 2, column 2");
  EXPECT_EQ(failure(R"({"cone": {"radius": 1, "height": 1, "sides": 2}})"), "bad-primitive, cone at line 1, column 29");
  EXPECT_EQ(failure(R"({"cone": {"radius": 1, "height": 1, "fit": "loose"}})"),
            "bad-primitive, cone at line 1, column 29");
  const std::string of = R"("of": {"block": {"size": [1, 2, 3]}}}})";
  EXPECT_EQ(failure(R"({"rotate": {"axis": [0, 0, 0], "angle": 1, )" + of), "bad-axis, rotate at line 1, column 29");
  EXPECT_EQ(failure(R"({"mirror": {"normal": [0, "1 - 1", 0], )" + of), "bad-axis, mirror at line 1, column 29");
  EXPECT_EQ(failure(R"({"turn": {"quaternion": [0, 0, 0, 0], )" + of), "bad-axis, turn at line 1, column 29");
  EXPECT_EQ(failure(R"({"scale": {"factors": [1, 0, 1], )" + of), "bad-factor, scale at line 1, column 29");
  EXPECT_EQ(failure(R"({"scale": {"factors": -1, )" + of), "bad-factor, scale at line 1, column 29");
  EXPECT_EQ(failure(R"({"transform": {"matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 2]], )" + of),
            "not-a-rotation, transform at line 1, column 29");
  EXPECT_EQ(failure(R"({"convex": {"planes": []}})"), "unbounded, convex at line 1, column 29");
  EXPECT_EQ(failure(R"({"half-space": {"plane": [0, 0, 0, 1]}})"), "bad-plane, half-space at line 1, column 29");
  EXPECT_EQ(failure(R"({"half-space": {"plane": [0, 0, 1, 1]}})").substr(0, 9), "unbounded");
  const auto far = evaluate(read_model(document(R"({"translate": {"by": [1e9, 0, 0], )" + of)), on_grid("1"));
  ASSERT_FALSE(far);
  EXPECT_EQ(far.error().code, ErrorCode::out_of_range);
  EXPECT_EQ(far.error().where.substr(0, 26), "block at line 1, column 69") << far.error().where;
}

// docs/model-format.md

std::string documented_example() {
  const std::filesystem::path root = std::filesystem::path(QUOIN_TEST_DATA).parent_path().parent_path();
  std::ifstream page(root / "docs" / "model-format.md");
  std::string text, line;
  while (std::getline(page, line) && line != "```json") continue;
  while (std::getline(page, line) && line != "```") text += line + "\n";
  return text;
}

TEST(ModelFile, DocumentedExample) {
  const Model model = read_model(documented_example());
  const Solid solid = evaluated(model);
  EXPECT_EQ(volume(solid), "21280");
  EXPECT_EQ(solid.grid().step(), "1/1000");
  EXPECT_EQ(solid.info().genus, 2);
  EXPECT_EQ(volume(evaluated(model, {.parameters = {{"width", "80"}}})), "25280");
  expect_stays(model, {});
  // By hand, without the history.
  const Grid grid = api_test::grid_of("1/1000");
  const Solid plates = box({0, 0, 0}, {60, 40, 5}, grid) + box({0, 0, 0}, {5, 40, 50}, grid);
  const Solid slots = box({42, 6, 0}, {54, 12, 5}, grid) + box({42, 28, 0}, {54, 34, 5}, grid);
  const Solid rib =
      evaluate(Expression(box({5, 17.5, 5}, {25, 22.5, 25}, grid)) & HalfSpace{{"1", "0", "1", "-30"}}).value();
  EXPECT_TRUE(solid == plates + rib - slots);
}

}  // namespace
}  // namespace quoin
