#include "io/packages/gltf/accessors.h"

#include "io/formats.h"
#include "tests/io/io_support.h"
#include "tests/io/packages/gltf/documents.h"

namespace quoin::io {
namespace {

using test::bytes_of;
using test::document_of;
using test::glb;
using test::quantised;
using test::replaced;

Scene scene_of(const std::string& bytes) {
  auto scene = read_scene(bytes, Format::glb);
  EXPECT_TRUE(scene) << scene.error().message << ", " << scene.error().where;
  return scene ? std::move(scene).value() : Scene{};
}

Error error_of(const std::string& bytes) {
  const auto scene = read_scene(bytes, Format::glb);
  if (scene) return {ErrorCode::internal_defect, "it was read"};
  EXPECT_FALSE(scene.error().where.empty());
  return scene.error();
}

/// By what the numbers of the first placed mesh are to be divided, first of all.
double divisor_of(const Scene& scene) {
  const Placing& placing = scene.objects.at(0).meshes.at(0).placing;
  const auto* step = placing.empty() ? nullptr : std::get_if<DivisionStep>(&placing[0]);
  return step == nullptr ? 1 : step->by;
}

// Integers of 8 and 16 bits to both ends of their ranges; normalised ones are not below -1.
TEST(GltfAccessors, QuantisedPositions) {
  struct Case {
    int component, least, most;
  };
  for (const auto& [component, least, most] :
       {Case{5120, -128, 127}, {5121, 0, 255}, {5122, -32768, 32767}, {5123, 0, 65535}}) {
    const std::vector<int> corners = {least, 0, 0, most, 0, 1, 0, most, 0, 3, 2, most};
    const std::vector<double> exact(corners.begin(), corners.end());
    const Scene plain = scene_of(quantised(corners, component, false));
    EXPECT_EQ(plain.meshes[0].points, exact) << component;
    EXPECT_EQ(divisor_of(plain), 1) << component;
    EXPECT_EQ(plain.meshes[0].corners, test::tetrahedron().triangles);

    const Scene normalized = scene_of(quantised(corners, component, true));
    std::vector<double> clamped = exact;
    if (least < 0) clamped[0] = -most;
    EXPECT_EQ(normalized.meshes[0].points, clamped) << component;
    EXPECT_EQ(divisor_of(normalized), most) << component;
  }
  EXPECT_EQ(error_of(quantised(std::vector<int>(12), 5125, false)).code, ErrorCode::bad_syntax);
  EXPECT_EQ(error_of(quantised(std::vector<int>(12), 5124, false)).code, ErrorCode::bad_syntax);
}

/// A view of three points and the type of their numbers, which are normalised if they are integers.
struct Points {
  int view, component;
};
constexpr int of_bytes = 0, of_shorts = 1, of_floats = 2;

/// A primitive of one triangle for each.
std::string mixed(float coordinate, const std::vector<Points>& list) {
  const std::string buffer = std::string("\x7f\0\0\0\0\x7f\0\0\0\0\x81\0", 12) +
                             std::string("\xff\x7f\0\0\0\0\0\0\1\0\0\0\0\0\0\0\1\0\0\0\1\0\0\0", 24) +
                             bytes_of({coordinate, 0, 0, 0, 1, 0, 0, 0, -1});
  std::string primitives, accessors;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string comma = i > 0 ? "," : "";
    primitives += comma + R"({"attributes":{"POSITION":)" + std::to_string(i) + "}}";
    accessors += comma + R"({"count":3,"type":"VEC3","normalized":true,"bufferView":)" + std::to_string(list[i].view) +
                 R"(,"componentType":)" + std::to_string(list[i].component) + "}";
  }
  return glb(document_of(primitives, accessors,
                         R"({"buffer":0,"byteLength":12,"byteStride":4},)"
                         R"({"buffer":0,"byteOffset":12,"byteLength":24,"byteStride":8},)"
                         R"({"buffer":0,"byteOffset":36,"byteLength":36})",
                         buffer.size()),
             buffer);
}

// Over the least common multiple of 127 and 32767, which are relatively prime.
TEST(GltfAccessors, PrimitivesOfOneMeshHaveOneDivisor) {
  const Scene scene = scene_of(mixed(0.1F, {{of_bytes, 5120}, {of_shorts, 5122}, {of_floats, 5126}}));
  constexpr double one = 127 * 32767;
  EXPECT_EQ(divisor_of(scene), one);
  EXPECT_EQ(scene.meshes[0].points, (std::vector<double>{one,
                                                         0,
                                                         0,
                                                         0,
                                                         one,
                                                         0,
                                                         0,
                                                         0,
                                                         -one,  //
                                                         one,
                                                         0,
                                                         0,
                                                         127,
                                                         0,
                                                         0,
                                                         127,
                                                         0,
                                                         127,  //
                                                         static_cast<double>(0.1F) * one,
                                                         0,
                                                         0,
                                                         0,
                                                         one,
                                                         0,
                                                         0,
                                                         0,
                                                         -one}));
}

// Three divisors and a float of 24 bits take 62 bits together.
TEST(GltfAccessors, WhatNoDoubleHoldsTogetherIsRefused) {
  const std::vector<Points> list = {{of_bytes, 5120}, {of_shorts, 5122}, {of_shorts, 5123}, {of_floats, 5126}};
  EXPECT_EQ(divisor_of(scene_of(mixed(0.5F, list))), 127.0 * 32767 * 65535);
  const Error error = error_of(mixed(1 + 0x1p-23F, list));
  EXPECT_EQ(error.code, ErrorCode::bad_syntax) << error.message;
  EXPECT_EQ(error.where, "accessor 3");
}

/// A tetrahedron of which point 3 and the second index are replaced; `base`: whether a view holds the points.
std::string sparse(bool has_base, const std::string& places = std::string("\1\3", 2)) {
  const std::string buffer = bytes_of({0, 0, 0, 9, 9, 9, 0, 1, 0, 9, 9, 9}) +
                             std::string("\0\2\1\0\0\3\1\2\3\2\0\3", 12) + bytes_of({1, 0, 0, 0, 0, 1}) + places +
                             std::string("\4\1", 2);
  return glb(document_of(R"({"attributes":{"POSITION":0},"indices":1})",
                         (has_base ? R"({"bufferView":0,)" : std::string("{")) +
                             R"("count":4,"type":"VEC3","componentType":5126,"sparse":{"count":2,)"
                             R"("indices":{"bufferView":3,"componentType":5121},"values":{"bufferView":2}}},)"
                             R"({"bufferView":1,"count":12,"type":"SCALAR","componentType":5121,"sparse":{"count":1,)"
                             R"("indices":{"bufferView":3,"byteOffset":2,"componentType":5121},)"
                             R"("values":{"bufferView":3,"byteOffset":3}}})",
                         R"({"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12},)"
                         R"({"buffer":0,"byteOffset":60,"byteLength":24},{"buffer":0,"byteOffset":84,"byteLength":4})",
                         buffer.size()),
             buffer);
}

TEST(GltfAccessors, SparseAccessorsReplaceElements) {
  const Scene scene = scene_of(sparse(true));
  EXPECT_EQ(scene.meshes[0].points, test::tetrahedron().points);
  EXPECT_EQ(scene.meshes[0].corners, test::tetrahedron().triangles);
  // Without a view zeros are replaced.
  EXPECT_EQ(scene_of(sparse(false)).meshes[0].points, (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1}));
}

TEST(GltfAccessors, HostileSparseAccessorsAreRefused) {
  EXPECT_EQ(error_of(sparse(true, std::string("\1\4", 2))).code, ErrorCode::bad_index);
  EXPECT_EQ(error_of(sparse(true, std::string("\3\3", 2))).code, ErrorCode::bad_index);
  EXPECT_EQ(error_of(sparse(true, std::string("\3\1", 2))).where, "accessor 0");

  const std::string good = sparse(true);
  const std::string json = good.substr(20, good.find("BIN") - 24), buffer = good.substr(good.find("BIN") + 4);
  const auto code = [&](const std::string& from, const std::string& to) {
    return to_string(error_of(glb(replaced(json, from, to), buffer)).code);
  };
  EXPECT_EQ(code(R"("sparse":{"count":2)", R"("sparse":{"count":5)"), "absurd-count");
  EXPECT_EQ(code(R"("sparse":{"count":2)", R"("sparse":{"count":3)"), "absurd-count");
  EXPECT_EQ(code(R"("values":{"bufferView":2})", R"("valued":{"bufferView":2})"), "bad-syntax");
  EXPECT_EQ(code(R"("values":{"bufferView":2})", R"("values":{"bufferView":7})"), "bad-index");
  EXPECT_EQ(code(R"("values":{"bufferView":2})", R"("values":{})"), "bad-syntax");
  EXPECT_EQ(
      code(R"("indices":{"bufferView":3,"componentType":5121})", R"("indices":{"bufferView":3,"componentType":5120})"),
      "bad-syntax");
}

// A few letters may claim any number of zeros.
TEST(GltfAccessors, ElementsThatNoBufferHoldsAreBounded) {
  const auto claim = [](std::uint64_t count) {
    return glb(document_of(R"({"attributes":{"POSITION":0}},{"attributes":{"POSITION":0}})",
                           R"({"count":)" + std::to_string(count) + R"(,"type":"VEC3","componentType":5126})", "", 0),
               "");
  };
  EXPECT_EQ(error_of(claim(max_unstored / 2 / 3 * 3)).code, ErrorCode::internal_defect);  // read
  EXPECT_EQ(error_of(claim(max_unstored / 2 + 1)).code, ErrorCode::absurd_count);
  EXPECT_EQ(error_of(claim(std::uint64_t{1} << 40)).code, ErrorCode::absurd_count);
}

// Compressed meshes are refused, whether the file says that it requires that or not, with a way out.
TEST(GltfAccessors, CompressionIsNamed) {
  for (const std::string extension : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
    const std::string member = R"(,"extensions":{")" + extension + R"(":{}})";
    const std::string plain = R"({"attributes":{"POSITION":0})",
                      accessor = R"("count":3,"type":"VEC3","componentType":5126})";
    const std::string required =
        replaced(document_of("", "", "", 0), R"("nodes")", R"("extensionsRequired":[")" + extension + R"("],"nodes")");
    const std::string primitive = document_of(plain + member + "}", "{" + accessor, "", 0);
    const std::string fallback =
        replaced(document_of(plain + "}", R"({"bufferView":0,)" + accessor, R"({"buffer":1,"byteLength":36})", 0),
                 R"({"byteLength":0})", R"({"byteLength":0},{"byteLength":36)" + member + "}");
    for (const std::string& json : {required, primitive, fallback}) {
      const Error error = error_of(glb(json, ""));
      EXPECT_EQ(error.code, ErrorCode::unknown_format) << json << error.message;
      EXPECT_NE(error.message.find(extension), std::string::npos) << error.message;
      EXPECT_NE(error.message.find("without compression"), std::string::npos) << error.message;
    }
  }
}

TEST(GltfAccessors, DamageIsNoticedOrHarmless) {
  const std::string both = mixed(0.1F, {{of_bytes, 5120}, {of_shorts, 5123}});
  for (const std::string& good : {sparse(true), both, quantised({9, 0, 0, 0, 9, 0, 0, 0, 9, 1, 1, 1}, 5122, true)}) {
    EXPECT_EQ(test::read_all_prefixes(good, Format::glb), 1U);
    test::read_mutations(good, Format::glb, 3000);
  }
}

}  // namespace
}  // namespace quoin::io
