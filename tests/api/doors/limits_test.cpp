// Small input that asks for much is refused at once, and the sentence names the limit.
#include <array>
#include <string>

#include "tests/api/solids.h"

namespace quoin {
namespace {

std::string told(const Error& error) { return to_string(error.code) + ": " + error.message; }

template <class T>
std::string refusal(const Result<T>& result) {
  return result ? "taken" : told(result.error());
}

std::string excess(const std::string& what, const std::string& limit, const std::string& value) {
  return "too-large: " + what + " than the limit \"" + limit + "\" allows: " + value;
}

std::string document(const std::string& model, const std::string& parts = "{}") {
  return R"({"quoin-model": 1, "parts": )" + parts + R"(, "model": )" + model + "}";
}

/// A block that is doubled so many times.
std::string doubled(int times) {
  std::string parts = R"({"p0": {"block": {"size": [1, 1, 1]}})", part = R"({"part": "p0"})";
  for (int i = 1; i <= times; ++i) {
    parts += ", \"p" + std::to_string(i) + "\": {\"union\": [" + part + R"(, {"translate": {"by": [)" +
             std::to_string(1 << i) + ", 0, 0], \"of\": " + part + "}}]}";
    part = "{\"part\": \"p" + std::to_string(i) + "\"}";
  }
  return document(part, parts + "}");
}

TEST(Limits, CountsOfPrimitivesAreBounded) {
  const std::string excessive = excess("the primitive has more faces", "sides", "65000");
  EXPECT_EQ(refusal(evaluate(Model::sphere("1", "1000000"))), excessive);
  EXPECT_EQ(refusal(evaluate(Model::sphere("1", "362"))), excessive);  // 362 * 181 = 65,522
  EXPECT_EQ(refusal(evaluate(Model::tangent_sphere("1", "65536"))), excessive);
  EXPECT_EQ(refusal(evaluate(Model::torus("2", "1", "256", "256"))), excessive);
  EXPECT_EQ(refusal(evaluate(Model::cylinder("1", "1", "65001"))), excessive);
  EXPECT_EQ(refusal(evaluate(Model::cone("1", "1", "1e30"))), excessive);
  EXPECT_EQ(refusal(evaluate(Model::prism("99999999999", "1", "1"))), excessive);
  EXPECT_EQ(evaluate(Model::sphere("1", "1000000").named("ball")).error().where, "sphere \"ball\"");
}

TEST(Limits, AreInclusive) {
  ModelOptions options;
  options.limits.sides = 8 * 4;
  EXPECT_EQ(evaluate(Model::sphere("1", "8"), options).value().counts().faces, 32U);
  EXPECT_EQ(refusal(evaluate(Model::sphere("1", "10"), options)),
            excess("the primitive has more faces", "sides", "32"));
  options.limits.sides = 7;
  EXPECT_EQ(evaluate(Model::cylinder("1", "1", "7"), options).value().counts().faces, 9U);
  EXPECT_FALSE(evaluate(Model::cylinder("1", "1", "8"), options));
}

TEST(Limits, NoneLeavesThePrimitivesOwnBounds) {
  ModelOptions options;
  options.limits = Limits::none();
  EXPECT_EQ(evaluate(Model::sphere("1", "1000000"), options).error().code, ErrorCode::bad_primitive);
}

// 2^18 blocks of 1.8 KB of text.
TEST(Limits, NodesCountAsTheyAreReached) {
  const auto model = Model::from_json(doubled(18));
  ASSERT_TRUE(model) << told(model.error());
  EXPECT_EQ(refusal(evaluate(model.value())), excess("the model has more nodes", "nodes", "100000"));

  // Unions, blocks and translations: 8 + 7 + 7 places of nodes.
  const Model small = Model::from_json(doubled(3)).value();
  ModelOptions options;
  options.limits.nodes = 22;
  EXPECT_EQ(evaluate(small, options).value().volume(), "8");
  options.limits.nodes = 21;
  EXPECT_EQ(refusal(evaluate(small, options)), excess("the model has more nodes", "nodes", "21"));
}

TEST(Limits, FacesOfAllPrimitivesAreBounded) {
  const Model block = Model::block({"1", "1", "1"});
  const Model two = block + block.translated({"5", "0", "0"});
  ModelOptions options;
  options.limits.model_faces = 12;
  EXPECT_EQ(evaluate(two, options).value().volume(), "2");
  options.limits.model_faces = 11;
  EXPECT_EQ(refusal(evaluate(two, options)),
            excess("the primitives of the model have more faces", "model-faces", "11"));
}

TEST(Limits, DigitsOfNumbers) {
  const std::string ones(1000000, '1');
  const std::string excessive = excess("the number of 1000000 digits has more", "digits", "4000");
  EXPECT_EQ(refusal(evaluate(Model::block({ones, "1", "1"}))), excessive);
  // In a text as a number, as a formula, and in what is no model.
  for (const std::string& number : {ones, "\"1 + " + ones + "\"", "0." + ones}) {
    const auto read = Model::from_json(document("\n{\"block\": {\"size\": [" + number + ", 1, 1]}}"));
    EXPECT_EQ(refusal(read), excessive);
    EXPECT_EQ(read.error().where, "line 2");
  }

  ModelOptions options;
  options.limits.digits = 3;
  EXPECT_TRUE(evaluate(Model::block({"1.25", "100 + 100 * 2", "1"}), options));
  EXPECT_EQ(refusal(evaluate(Model::block({"1.250", "1", "1"}), options)),
            excess("the number of 4 digits has more", "digits", "3"));
  options.limits = Limits::none();
  const std::string third = "0." + std::string(5000, '3');
  EXPECT_TRUE(evaluate(Model::block({third, "1", "1"}), options));
}

TEST(Limits, DepthOfNodes) {
  const auto nested = [](int depth) {
    std::string text = R"({"block": {"size": [1, 1, 1]}})";
    for (int i = 1; i < depth; ++i) text = R"({"complement": )" + text + "}";
    return document(text);
  };
  EXPECT_TRUE(Model::from_json(nested(490)));
  ModelReadOptions options;
  options.limits.depth = 4;
  EXPECT_TRUE(Model::from_json(nested(4), ".", nullptr, options));
  const auto deep = Model::from_json(nested(5), ".", nullptr, options);
  EXPECT_EQ(refusal(deep), excess("nodes are nested more deeply", "depth", "4"));
  EXPECT_EQ(deep.error().where.substr(0, 7), "line 1,");
  options.limits = Limits::none();
  EXPECT_EQ(refusal(Model::from_json(nested(501), ".", nullptr, options)),
            excess("nodes are nested more deeply", "depth", "500"));
}

TEST(Limits, VerticesAndFacesOfMeshes) {
  const std::vector<double> points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::vector<std::uint32_t> triangles = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  ImportOptions options;
  options.limits.vertices = options.limits.faces = 4;
  EXPECT_TRUE(Solid::from_triangles(points, triangles, options));
  options.limits.vertices = 3;
  EXPECT_EQ(refusal(Solid::from_triangles(points, triangles, options)),
            excess("the mesh of 4 vertices has more", "vertices", "3"));
  options.limits.vertices = 4;
  options.limits.faces = 3;
  EXPECT_EQ(refusal(Solid::from_triangles(points, triangles, options)),
            excess("the mesh of 4 faces has more", "faces", "3"));
  const std::vector<std::uint32_t> starts = {0, 3, 6, 9, 12};
  EXPECT_EQ(refusal(Solid::from_polygons(points, starts, triangles, options)),
            excess("the mesh of 4 faces has more", "faces", "3"));
  options.limits.faces = 4;
  EXPECT_TRUE(Solid::from_polygons(points, starts, triangles, options));
}

}  // namespace
}  // namespace quoin
