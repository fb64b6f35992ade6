#include "io/formats.h"

#include "io/json.h"
#include "tests/io/io_support.h"
#include "tests/io/packages/gltf/documents.h"

namespace quoin::io {
namespace {

using test::bytes_of;
using test::document;
using test::glb;
using test::replaced;
using test::tetrahedron_buffer;
using test::word;

std::string code_of_document(const std::string& json) {
  return test::code_of(glb(json, tetrahedron_buffer()), Format::glb);
}

/// Floats come back to the bit; the points are shared.
TEST(Gltf, RoundTrips) {
  std::mt19937_64 random(test::seed());
  std::vector<double> coordinates;
  while (coordinates.size() < 6000)
    if (const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random())); std::isfinite(value))
      coordinates.push_back(value);
  for (const auto& mesh : {test::strip(coordinates), test::tetrahedron()})
    for (const Format format : {Format::glb, Format::gltf}) test::expect_round_trip(mesh, format);
  EXPECT_EQ(test::code_of(write_mesh({}, {}, Format::glb), Format::glb), "no-faces");
  EXPECT_EQ(test::code_of(write_mesh({}, {}, Format::gltf), Format::gltf), "no-faces");
}

// What others read of it: lengths, alignment and the bounds of the positions, by a second look at the bytes.
TEST(Gltf, WhatIsWrittenIsAsTheSpecificationHasIt) {
  const test::Triangles mesh{{-1.5, 2, 3, 1, 0, 0.1, 0, 1, 7}, {0, 1, 2}};
  const std::string bytes = write_mesh(mesh.points, mesh.triangles, Format::glb, Unit::inch);
  EXPECT_EQ(bytes.substr(0, 12), "glTF" + word(2) + word(static_cast<std::uint32_t>(bytes.size())));
  EXPECT_EQ(bytes.size() % 4, 0U);
  const std::size_t end = bytes.rfind("BIN") - 4;
  EXPECT_EQ(bytes.substr(12, 8), word(static_cast<std::uint32_t>(end - 20)) + "JSON");
  EXPECT_EQ(bytes.substr(end + 8, 36), bytes_of({-1.5F, 2, 3, 1, 0, 0.1F, 0, 1, 7}));
  EXPECT_EQ(bytes.substr(end + 44), word(0) + word(1) + word(2));

  const auto json = read_json(bytes.substr(20, end - 20));
  ASSERT_TRUE(json) << json.error().message;
  const Json& positions = json.value().member("accessors")->items[0];
  const auto texts = [&](const char* name) {
    std::string all;
    for (const Json& item : positions.member(name)->items) all += item.text + " ";
    return all;
  };
  EXPECT_EQ(texts("min"), "-1.5 0 0.10000000149011612 ");
  EXPECT_EQ(texts("max"), "1 2 7 ");
  EXPECT_EQ(json.value().member("nodes")->items[0].member("scale")->items[0].text, "0.0254");
}

TEST(Gltf, NodesPlaceMeshes) {
  const std::string nodes = R"({"name":"a","children":[1],"translation":[1,2,3],"rotation":[0,0,1,1],"scale":[2,2,2]},)"
                            R"({"mesh":0,"matrix":[1,2,3,0,4,5,6,0,7,8,9,0,10,11,12,1]},{"name":"b","mesh":0})";
  const auto scene = read_scene(glb(document(nodes), tetrahedron_buffer()), Format::glb);
  ASSERT_TRUE(scene) << scene.error().message << scene.error().where;
  EXPECT_EQ(scene.value().unit, Unit::meter);
  ASSERT_EQ(scene.value().objects.size(), 2U);
  EXPECT_EQ(scene.value().objects[0].name, "m");
  EXPECT_EQ(scene.value().objects[1].name, "b");
  const Placing& placing = scene.value().objects[0].meshes[0].placing;
  ASSERT_EQ(placing.size(), 4U);
  EXPECT_EQ(std::get<MatrixStep>(placing[0]), (MatrixStep{{1, 4, 7, 10, 2, 5, 8, 11, 3, 6, 9, 12}}));
  EXPECT_EQ(std::get<MatrixStep>(placing[1]), (MatrixStep{{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0}}));
  EXPECT_EQ(std::get<QuaternionStep>(placing[2]).by, (std::array<double, 4>{0, 0, 1, 1}));
  EXPECT_EQ(std::get<MatrixStep>(placing[3]), (MatrixStep{{1, 0, 0, 1, 0, 1, 0, 2, 0, 0, 1, 3}}));
  ASSERT_EQ(scene.value().notices.size(), 1U);
  EXPECT_EQ(scene.value().notices[0].count, 1U);  // the normals

  // The scene that the file shows, alone.
  const auto one =
      read_scene(glb(document(nodes, R"("indices":1)", R"(,"scene":1,"scenes":[{"nodes":[0]},{"nodes":[2]}])"),
                     tetrahedron_buffer()),
                 Format::glb);
  ASSERT_TRUE(one);
  ASSERT_EQ(one.value().objects.size(), 1U);
  EXPECT_EQ(one.value().objects[0].name, "b");
}

TEST(Gltf, WhatIsPassedOverIsCounted) {
  const std::string nodes = R"({"mesh":0,"skin":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{}}}})";
  const auto scene =
      read_scene(glb(document(nodes, R"("indices":1,"material":0,"targets":[{"POSITION":0},{"POSITION":0}])"),
                     tetrahedron_buffer()),
                 Format::glb);
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_EQ(scene.value().notices,
            (std::vector<Notice>{{1, "1 material is passed over"},
                                 {1, "1 list of normals, colours or other attributes is passed over"},
                                 {2, "2 morph targets are passed over"},
                                 {1, "1 skin is passed over"},
                                 {1, "1 list of instances is passed over"}}));
  EXPECT_EQ(scene.value().objects.size(), 1U);
}

TEST(Gltf, StripsFansAndPlainTriangles) {
  const auto corners = [](const std::string& primitive) {
    const auto mesh = read_mesh(glb(document(R"({"mesh":0})", primitive), tetrahedron_buffer()), Format::glb);
    EXPECT_TRUE(mesh) << primitive;
    return mesh ? mesh.value().corners : std::vector<std::uint32_t>();
  };
  using Corners = std::vector<std::uint32_t>;
  EXPECT_EQ(corners(R"("mode":5)"), (Corners{0, 1, 2, 1, 3, 2}));
  EXPECT_EQ(corners(R"("mode":6)"), (Corners{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(corners(R"("indices":1)"), (Corners{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}));
  EXPECT_EQ(code_of_document(document(R"({"mesh":0})", R"("mode":4)")), "bad-syntax");  // 4 corners
  EXPECT_EQ(code_of_document(document(R"({"mesh":0})", R"("mode":1)")), "no-faces");
}

TEST(Gltf, BuffersBesideAndInDataUris) {
  // "AAAA..." is the buffer in base64, by the writer's other half: a file of zeros would have no tetrahedron.
  const std::string nodes = R"({"mesh":0})";
  const auto beside = [](const std::string& name) -> Result<std::string> {
    if (name == "a b.bin") return tetrahedron_buffer();
    return Error{ErrorCode::missing_file, "not there", {}, name};
  };
  const auto scene = read_scene(document(nodes, R"("indices":1)", "", R"(,"uri":"a%20b.bin")"), Format::gltf, beside);
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_EQ(scene.value().meshes[0].corners.size(), 12U);
  const auto missing = read_scene(document(nodes, R"("indices":1)", "", R"(,"uri":"c.bin")"), Format::gltf, beside);
  EXPECT_EQ(missing.error().code, ErrorCode::missing_file);
  EXPECT_EQ(test::code_of(document(nodes, R"("indices":1)", "", R"(,"uri":"data:x;base64,AA*A")"), Format::gltf),
            "bad-syntax");
  EXPECT_EQ(test::code_of(document(nodes, R"("indices":1)", "", R"(,"uri":"data:x;base64,AAAA")"), Format::gltf),
            "truncated");
}

TEST(Gltf, HostileFilesAreRefused) {
  const std::string good = document(R"({"mesh":0})");
  EXPECT_EQ(code_of_document(good), "");
  EXPECT_EQ(code_of_document(replaced(good, R"("count":4)", R"("count":5)")), "absurd-count");
  EXPECT_EQ(code_of_document(replaced(good, R"("count":4)", R"("count":1e18)")), "absurd-count");
  EXPECT_EQ(code_of_document(replaced(good, R"("count":4)", R"("count":-1)")), "absurd-count");
  EXPECT_EQ(code_of_document(replaced(good, R"("count":4)", R"("count":3)")), "bad-index");
  EXPECT_EQ(code_of_document(replaced(good, R"("byteOffset":48)", R"("byteOffset":49)")), "absurd-count");
  EXPECT_EQ(code_of_document(replaced(good, R"("byteLength":72)", R"("byteLength":73)")), "truncated");
  EXPECT_EQ(code_of_document(replaced(good, R"("POSITION":0)", R"("POSITION":2)")), "bad-index");
  EXPECT_EQ(code_of_document(replaced(good, R"("POSITION":0)", R"("POSITION":1)")), "bad-syntax");
  EXPECT_EQ(code_of_document(replaced(good, R"("bufferView":1)", R"("bufferView":9)")), "bad-index");
  EXPECT_EQ(code_of_document(replaced(good, R"("mesh":0)", R"("mesh":1)")), "bad-index");
  EXPECT_EQ(code_of_document(replaced(good, "2.0", "1.0")), "unknown-format");
  EXPECT_EQ(
      code_of_document(document(R"({"mesh":0,"children":[0]})", R"("indices":1)", R"(,"scenes":[{"nodes":[0]}])")),
      "bad-syntax");
  EXPECT_EQ(code_of_document(document(R"({"mesh":0,"children":[1]})")), "bad-index");
  EXPECT_EQ(code_of_document(document(R"({"mesh":0,"scale":[1,2]})")), "bad-syntax");
  EXPECT_EQ(code_of_document(document(R"({"mesh":0,"scale":[1,2,1e999]})")), "bad-syntax");
  EXPECT_EQ(code_of_document(
                document(R"({"mesh":0})", R"("indices":1)", R"(,"extensionsRequired":["KHR_draco_mesh_compression"])")),
            "unknown-format");
  EXPECT_EQ(code_of_document(std::string(5000, '[')), "bad-syntax");
  const std::string nan = glb(good, bytes_of({std::nanf(""), 0, 0}) + tetrahedron_buffer().substr(12));
  EXPECT_EQ(test::code_of(nan, Format::glb), "non-finite");
}

TEST(Gltf, DamageIsNoticedOrHarmless) {
  const std::string good = glb(document(R"({"mesh":0})"), tetrahedron_buffer());
  EXPECT_EQ(test::read_all_prefixes(good, Format::glb), 1U);
  test::read_mutations(good, Format::glb, 3000);
}

}  // namespace
}  // namespace quoin::io
