#include "tests/io/packages/package.h"

#include "io/formats.h"
#include "io/packages/assembly.h"
#include "tests/io/io_support.h"

namespace quoin::io {
namespace {

using test::components_text;
using test::model_text;
using test::object_text;
using test::package;
using test::tetrahedron_text;

Error error_of(const std::string& bytes) {
  const auto scene = read_scene(bytes, Format::threemf);
  if (scene) return {ErrorCode::internal_defect, "it was read"};
  EXPECT_FALSE(scene.error().where.empty()) << scene.error().message;
  return scene.error();
}

std::string code_of_model(const std::string& model) { return to_string(error_of(package(model)).code); }

TEST(ThreeMf, RoundTrips) { test::expect_round_trips(Format::threemf); }

TEST(ThreeMf, UnitsAreKept) {
  const test::Triangles mesh = test::tetrahedron();
  for (const Unit unit : {Unit::micron, Unit::millimeter, Unit::centimeter, Unit::inch, Unit::foot, Unit::meter})
    for (const Format format : {Format::threemf, Format::amf})
      EXPECT_EQ(read_scene(write_mesh(mesh.points, mesh.triangles, format, unit), format).value().unit, unit);
  // Unstated it is the format's own.
  EXPECT_EQ(read_scene(write_mesh(mesh.points, mesh.triangles, Format::threemf), Format::threemf).value().unit,
            Unit::millimeter);
}

// Items are objects, by their order; a component's transform acts before its item's.
TEST(ThreeMf, ItemsAndComponents) {
  const std::string resources =
      object_text(7, tetrahedron_text(), "name=\"tip\" type=\"model\"") +
      object_text(9,
                  "<components><component objectid=\"7\" transform=\"1 2 3 4 5 6 7 8 9 10 11 12\"/>"
                  "<component objectid=\"7\"/></components>");
  const auto scene =
      read_scene(package(model_text(
                     resources, "<item objectid=\"9\" transform=\"1 0 0 0 1 0 0 0 1 5 6 7\"/><item objectid=\"7\"/>",
                     "unit=\"inch\"")),
                 Format::threemf);
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_EQ(scene.value().unit, Unit::inch);
  EXPECT_EQ(scene.value().meshes.size(), 1U);
  ASSERT_EQ(scene.value().objects.size(), 2U);
  const auto& [first, second] = std::tie(scene.value().objects[0], scene.value().objects[1]);
  EXPECT_EQ(first.name, "");
  EXPECT_EQ(second.name, "tip");
  ASSERT_EQ(first.meshes.size(), 2U);
  ASSERT_EQ(first.meshes[0].placing.size(), 2U);
  // Points are rows there: columns become rows.
  EXPECT_EQ(std::get<MatrixStep>(first.meshes[0].placing[0]), (MatrixStep{{1, 4, 7, 10, 2, 5, 8, 11, 3, 6, 9, 12}}));
  EXPECT_EQ(std::get<MatrixStep>(first.meshes[0].placing[1]), (MatrixStep{{1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7}}));
  EXPECT_EQ(first.meshes[1].placing.size(), 1U);
  EXPECT_TRUE(second.meshes[0].placing.empty());
}

TEST(ThreeMf, WhatIsPassedOverIsCounted) {
  const std::string painted =
      "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"
      "<vertex x=\"0\" y=\"1\" z=\"0\"/></vertices><triangles>"
      "<triangle v1=\"0\" v2=\"1\" v3=\"2\" pid=\"5\" p1=\"0\"/>"
      "<triangle v1=\"0\" v2=\"2\" v3=\"1\"/></triangles></mesh>";
  const auto scene =
      read_scene(package(model_text(
                     "<basematerials id=\"5\"><base name=\"red\" displaycolor=\"#ff0000\"/></basematerials>" +
                         object_text(1, painted, "pid=\"5\"") + object_text(2, tetrahedron_text(), "type=\"support\""),
                     "<item objectid=\"1\"/><item objectid=\"2\"/>")),
                 Format::threemf);
  ASSERT_TRUE(scene) << scene.error().message;
  ASSERT_EQ(scene.value().notices.size(), 2U);
  EXPECT_EQ(scene.value().notices[0].count, 2U);
  EXPECT_EQ(scene.value().notices[1].count, 1U);
  // A support bounds nothing, and keeps its number.
  ASSERT_EQ(scene.value().objects.size(), 2U);
  EXPECT_TRUE(scene.value().objects[1].meshes.empty());
}

// What other extensions add is counted, each element once, whatever is in it; what the core itself has is not.
TEST(ThreeMf, ElementsOfExtensionsAreCounted) {
  const std::string beams =
      "<b:beamlattice xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\">"
      "<b:beams><b:beam v1=\"0\" v2=\"1\"/></b:beams></b:beamlattice></mesh>";
  const std::string sets =
      "<t:trianglesets xmlns:t=\"http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07\">"
      "<t:triangleset name=\"a\" identifier=\"b\"><t:ref index=\"0\"/></t:triangleset>"
      "</t:trianglesets></mesh>";
  const auto with = [](const std::string& end) {
    std::string text = tetrahedron_text();
    return text.replace(text.rfind("</mesh>"), 7, end);
  };
  const auto scene =
      read_scene(package(model_text("<metadatagroup><metadata name=\"x\">y</metadata></metadatagroup>" +
                                        object_text(1, with(beams)) + object_text(2, with(sets)),
                                    "<item objectid=\"1\" printable=\"0\"/><item objectid=\"2\" printable=\"1\"/>")),
                 Format::threemf);
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_EQ(scene.value().notices,
            (std::vector<Notice>{{1, "1 element of an extension (beams, slices, or others) is passed over"},
                                 {1, "1 item is marked as not to be printed, and read all the same"}}));
  EXPECT_EQ(scene.value().objects.size(), 2U);
}

// The draft of 2013, by which old files are written.
TEST(ThreeMf, TheDraftIsRead) {
  std::string model =
      model_text("<color id=\"3\" value=\"#fff\"/>" + object_text(0, tetrahedron_text(), "colorid=\"3\""),
                 "<item objectid=\"0\"/>", "unit=\"inch\"");
  const std::string draft = "http://schemas.microsoft.com/3dmanufacturing/2013/01";
  model.replace(model.find(test::core_space), test::core_space.size(), draft);
  const auto scene = read_scene(package(model), Format::threemf);
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_EQ(scene.value().unit, Unit::inch);
  EXPECT_EQ(scene.value().meshes[0].corners.size(), 12U);
  EXPECT_EQ(scene.value().notices,
            (std::vector<Notice>{{1, "1 group of colours and materials of faces is passed over"}}));
}

// Slices say what meshes say, unless these are rough.
TEST(ThreeMf, SlicesBesideMeshes) {
  const std::string space = "xmlns:s=\"http://schemas.microsoft.com/3dmanufacturing/slice/2015/07\" ";
  const auto model = [&](const std::string& attributes) {
    return model_text("<s:slicestack id=\"3\" zbottom=\"0\"/>" + object_text(1, tetrahedron_text(), attributes),
                      "<item objectid=\"1\"/>", space + "requiredextensions=\"s\"");
  };
  for (const std::string attributes : {"s:slicestackid=\"3\"", "s:slicestackid=\"3\" s:meshresolution=\"fullres\""}) {
    const auto scene = read_scene(package(model(attributes)), Format::threemf);
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(scene.value().notices.at(0).count, 1U);
  }
  const Error rough = error_of(package(model("s:slicestackid=\"3\" s:meshresolution=\"lowres\"")));
  EXPECT_EQ(rough.code, ErrorCode::unknown_format);
  EXPECT_NE(rough.message.find("object 1"), std::string::npos) << rough.message;
}

// The production extension spreads objects over parts of the package.
TEST(ThreeMf, PartsThatOthersName) {
  const std::string space = "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" ";
  const std::string model =
      model_text(object_text(2, "<components><component p:path=\"/3D/Objects/a.model\" objectid=\"1\"/></components>"),
                 "<item objectid=\"2\"/>", space + "requiredextensions=\"p\"");
  const std::string part = model_text(object_text(1, tetrahedron_text()), "");
  const auto scene = read_scene(
      write_zip({{"_rels/.rels", test::relationships()}, {"3D/3dmodel.model", model}, {"3D/Objects/a.model", part}}),
      Format::threemf);
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_EQ(scene.value().meshes[0].corners.size(), 12U);

  const Error missing = error_of(package(model));
  EXPECT_EQ(missing.code, ErrorCode::bad_syntax);
  EXPECT_EQ(missing.where, "/3D/Objects/a.model");
}

TEST(ThreeMf, HostilePackagesAreRefused) {
  const std::string tetrahedron = object_text(1, tetrahedron_text()), item = "<item objectid=\"1\"/>";
  EXPECT_EQ(to_string(error_of(write_zip({{"a", "b"}})).code), "bad-syntax");
  EXPECT_EQ(error_of(write_zip({{"_rels/.rels", "<a/>"}})).where, "_rels/.rels");
  EXPECT_EQ(error_of(write_zip({{"_rels/.rels", test::relationships()}})).where, "/3D/3dmodel.model");
  EXPECT_EQ(code_of_model("<model/>"), "bad-syntax");
  EXPECT_EQ(code_of_model(""), "truncated");
  EXPECT_EQ(code_of_model(model_text(tetrahedron, item).substr(0, 400)), "truncated");
  EXPECT_EQ(code_of_model("<!DOCTYPE m [<!ENTITY a \"b\">]>" + model_text(tetrahedron, item).substr(21)), "bad-syntax");
  EXPECT_EQ(code_of_model(model_text(tetrahedron, "<item objectid=\"2\"/>")), "bad-index");
  EXPECT_EQ(code_of_model(model_text(tetrahedron, "")), "no-faces");
  EXPECT_EQ(code_of_model(model_text(tetrahedron + tetrahedron, item)), "bad-syntax");
  EXPECT_EQ(code_of_model(model_text(tetrahedron, item, "unit=\"yard\"")), "bad-syntax");
  EXPECT_EQ(code_of_model(model_text(tetrahedron, item, "xmlns:q=\"urn:q\" requiredextensions=\"q\"")),
            "unknown-format");
  EXPECT_EQ(code_of_model(model_text(object_text(1, tetrahedron_text("nan")), item)), "non-finite");
  EXPECT_EQ(code_of_model(model_text(object_text(1, tetrahedron_text("1e999")), item)), "non-finite");
  EXPECT_EQ(code_of_model(model_text(object_text(1, tetrahedron_text("1,5")), item)), "bad-number");
  EXPECT_EQ(code_of_model(model_text(tetrahedron, "<item objectid=\"1\" transform=\"1 2 3\"/>")), "bad-syntax");

  std::string wrong = tetrahedron;
  wrong.replace(wrong.find("v1=\"0\""), 6, "v1=\"4\"");
  const Error index = error_of(package(model_text(wrong, item)));
  EXPECT_EQ(index.code, ErrorCode::bad_index);
  EXPECT_EQ(index.where, "3D/3dmodel.model, line 1");
}

TEST(ThreeMf, ObjectsThatContainThemselvesAreRefused) {
  const std::string ring = object_text(1, components_text({2})) + object_text(2, components_text({3})) +
                           object_text(3, components_text({1}));
  const Error error = error_of(package(model_text(ring, "<item objectid=\"2\"/>")));
  EXPECT_EQ(error.code, ErrorCode::bad_syntax);
  EXPECT_EQ(error.where, "object 2");
}

// Each object holds the one before it twice: 2^40 tetrahedra in a few lines.
TEST(ThreeMf, DoublingsAreRefused) {
  std::string resources = object_text(1, tetrahedron_text());
  for (int id = 2; id <= 40; ++id) resources += object_text(id, components_text({id - 1, id - 1}));
  EXPECT_EQ(code_of_model(model_text(resources, "<item objectid=\"40\"/>")), "absurd-count");
  std::string chain = object_text(1, tetrahedron_text());
  for (int id = 2; id <= 100; ++id) chain += object_text(id, components_text({id - 1}));
  EXPECT_EQ(code_of_model(model_text(chain, "<item objectid=\"100\"/>")), "bad-syntax");
  EXPECT_EQ(code_of_model(model_text(chain, "<item objectid=\"50\"/>")), "internal-defect");  // read
}

TEST(ThreeMf, DeepElementsAreRefused) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_EQ(code_of_model(model_text(deep, "")), "bad-syntax");
}

}  // namespace
}  // namespace quoin::io
