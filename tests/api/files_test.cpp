#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "io/quoin.h"
#include "tests/api/solids.h"

namespace quoin::api_test {
namespace {

class Files : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "quoin-files-XXXXXX";
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return folder_ / name; }
  void put(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
  }
  std::string get(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  std::filesystem::path folder_;
};

TEST_F(Files, EveryFormatComesBack) {
  const Solid a = box({0, 0, 0}, {2, 2, 2}) - box({1, 1, 1}, {3, 3, 3});
  ImportOptions options;
  options.grid = Grid();
  for (const char* name : {"a.stl", "a.obj", "a.OFF", "a.ply", "a.quoin"}) {
    ASSERT_TRUE(a.write(path(name))) << name;
    std::vector<ImportReport> reports;
    const auto back = read({path(name)}, options, &reports);
    ASSERT_TRUE(back) << name << ": " << back.error().message;
    ASSERT_EQ(back.value().size(), 1u);
    ASSERT_EQ(reports.size(), 1u);
    EXPECT_EQ(back.value()[0].to_quoin(), a.to_quoin()) << name;
  }
  const Mesh mesh = a.to_triangles().value();
  for (const Format format : {Format::stl_ascii, Format::ply_ascii}) {
    put("plain", to_bytes(mesh, format));
    const auto source = read_source(path("plain"));
    ASSERT_TRUE(source) << source.error().message;
    EXPECT_EQ(source.value().name, path("plain"));
    const auto back = build({source.value()}, options);
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(back.value()[0].to_quoin(), a.to_quoin());
  }
}

TEST_F(Files, QuoinIsByteExact) {
  auto random = random_engine();
  for (int round = 0; round < 20; ++round) {
    const Grid grid = Grid::with_step_and_origin("3/7", {"1/3", "0", "-5"}).value();
    Solid a = random_tetrahedron(random, 5) ^ random_tetrahedron(random, 5) ^ random_tetrahedron(random, 5);
    if (round % 2 == 0) a = ~a;
    if (round % 3 == 0) a = a.on_grid(grid).value();
    const std::string text = a.to_quoin();
    const auto back = Solid::from_quoin(text);
    ASSERT_TRUE(back) << back.error().message << " " << back.error().where;
    EXPECT_EQ(back.value().to_quoin(), text);
    EXPECT_TRUE(back.value() == a);
    EXPECT_EQ(back.value().volume(), a.volume());
  }
  for (const Solid& a : {Solid(), Solid::full(grid_of("1/3")), ~box({0, 0, 0}, {1, 1, 1})})
    EXPECT_EQ(Solid::from_quoin(a.to_quoin()).value().to_quoin(), a.to_quoin());
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// The vertices and faces of two files as one; whether space is full far away is taken from the first.
std::string both(const std::string& a, const std::string& b) {
  io::ExactDocument p = io::read_quoin(a).value();
  const io::ExactDocument q = io::read_quoin(b).value();
  const auto vertices = static_cast<std::uint32_t>(p.vertices.size());
  p.vertices.insert(p.vertices.end(), q.vertices.begin(), q.vertices.end());
  p.planes.insert(p.planes.end(), q.planes.begin(), q.planes.end());
  for (std::size_t i = 1; i < q.face_loops.size(); ++i)
    p.face_loops.push_back(p.face_loops[p.face_loops.size() - 1] + q.face_loops[i] - q.face_loops[i - 1]);
  for (std::size_t i = 1; i < q.loop_corners.size(); ++i)
    p.loop_corners.push_back(p.loop_corners[p.loop_corners.size() - 1] + q.loop_corners[i] - q.loop_corners[i - 1]);
  for (std::uint32_t c : q.corners) p.corners.push_back(c + vertices);
  return io::write_quoin(p);
}

TEST_F(Files, BadQuoinIsRefused) {
  const std::string good = box({0, 0, 0}, {1, 1, 1}).to_quoin();
  ASSERT_TRUE(Solid::from_quoin(good));
  std::vector<std::string> bad{"", "quoin 1\n", good.substr(0, good.size() / 2)};
  bad.push_back(replaced(good, "\n0 0 1\n", "\n0 0 2\n"));            // off its planes
  bad.push_back(replaced(good, "\n0 0 1\n", "\n0 0 0\n"));            // the same point twice
  bad.push_back(replaced(good, "\n0 0 1\n", "\n0 0 3 3\n"));          // not in lowest terms
  bad.push_back(replaced(good, "\n0 0 1\n", "\n0 0 536870913\n"));    // outside the world
  bad.push_back(replaced(good, "\n1 0 0 -1 1\n", "\n2 0 0 -2 1\n"));  // not in lowest terms
  bad.push_back(replaced(good, "\n1 0 0 -1 1\n", "\n0 0 0 -1 1\n"));  // no normal
  bad.push_back(replaced(good, "\n1 0 0 -1 1\n", "\n-1 0 0 1 1\n"));  // turned round
  bad.push_back(replaced(good, "infinity empty", "infinity full"));   // inside out
  bad.push_back(replaced(good, "grid 1 ", "grid 2/2 "));
  bad.push_back(both(good, box({0, 0, 0}, {1, 1, 1}).to_quoin()));  // every point twice
  const std::string wide = box({0, 0, 0}, {9, 9, 9}).to_quoin();
  bad.push_back(both(wide, box({1, 1, 1}, {2, 2, 2}).to_quoin()));   // winding number 2
  bad.push_back(both(wide, box({1, 1, 1}, {10, 2, 2}).to_quoin()));  // crossing faces
  bad.push_back(both(wide, box({9, 1, 1}, {10, 2, 2}).to_quoin()));  // faces that overlap from both sides
  EXPECT_TRUE(Solid::from_quoin(both(wide, box({10, 1, 1}, {11, 2, 2}).to_quoin())));
  EXPECT_TRUE(Solid::from_quoin(both(wide, (~box({1, 1, 1}, {2, 2, 2})).to_quoin())));  // a cavity
  for (const std::string& text : bad) {
    const auto solid = Solid::from_quoin(text);
    ASSERT_FALSE(solid) << text;
    EXPECT_EQ(solid.error().code, "bad-quoin");
    EXPECT_NE(solid.error().where, "") << solid.error().message;
  }
}

TEST_F(Files, RandomDamageNeverCrashes) {
  auto random = random_engine();
  const std::string good = (box({0, 0, 0}, {2, 2, 2}) - box({1, 1, 0}, {3, 3, 1})).to_quoin();
  for (int round = 0; round < 500; ++round) {
    std::string text = good;
    for (int i = 0; i < 2; ++i) text[random() % text.size()] = "0123456789- \n/"[random() % 14];
    const auto solid = Solid::from_quoin(text);
    if (!solid) {
      EXPECT_EQ(solid.error().code, "bad-quoin");
    }
  }
}

TEST_F(Files, ErrorsNameTheFile) {
  EXPECT_EQ(read({path("none.off")}).error().code, "missing-file");
  EXPECT_EQ(read({path("none.off")}).error().file, path("none.off"));
  put("a.txt", "hello");
  EXPECT_EQ(read({path("a.txt")}).error().code, "unknown-format");
  put("a.off", "OFF\n1 1 0\n");
  EXPECT_EQ(read({path("a.off")}).error().file, path("a.off"));
  put("a.quoin", "quoin 1\n");
  EXPECT_EQ(read({path("a.quoin")}).error().code, "bad-quoin");
  EXPECT_EQ(read({path("a.quoin")}).error().file, path("a.quoin"));
  Mesh open = box_mesh({0, 0, 0}, {1, 1, 1});
  open.triangles.resize(9);
  put("open.off", to_bytes(open, Format::off));
  const auto refused = read({path("open.off")});
  EXPECT_EQ(refused.error().code, "open-boundary");
  EXPECT_EQ(refused.error().file, path("open.off"));
  const Solid a = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(a.write(path("a.txt")).error().code, "unknown-format");
  EXPECT_EQ(a.write(path("no/such/a.off")).error().code, "unwritable");
  EXPECT_EQ(a.write(path("no/such/a.off")).error().file, path("no/such/a.off"));
  EXPECT_EQ((~a).write(path("b.off")).error().code, "unbounded");
  EXPECT_FALSE(std::filesystem::exists(path("b.off")));
  EXPECT_TRUE((~a).write(path("b.quoin")));
}

TEST_F(Files, ContentDecides) {
  const Solid a = box({0, 0, 0}, {1, 1, 1});
  put("wrong.stl", a.to_quoin());
  put("wrong.quoin", to_bytes(a.to_triangles().value(), Format::ply));
  put("none", to_bytes(a.to_triangles().value(), Format::stl));
  for (const char* name : {"wrong.stl", "wrong.quoin", "none"}) {
    const auto back = read({path(name)});
    ASSERT_TRUE(back) << name << ": " << back.error().message;
    EXPECT_TRUE(back.value()[0] == a) << name;
  }
}

TEST_F(Files, OneCommonGrid) {
  const Mesh small = box_mesh({0, 0, 0}, {1, 1, 1}), wide = box_mesh({0, 0, 0}, {1024, 1, 1});
  put("small.off", to_bytes(small, Format::off));
  put("wide.off", to_bytes(wide, Format::off));
  const auto both = read({path("small.off"), path("wide.off")});
  ASSERT_TRUE(both);
  EXPECT_EQ(both.value()[0].grid().step(), "1/65536");
  EXPECT_EQ(both.value()[1].grid().step(), "1/65536");
  EXPECT_EQ(volume(both.value()[0] + both.value()[1]), "1024");

  ASSERT_TRUE(box({0, 0, 0}, {1, 1, 1}, grid_of("1/3")).write(path("third.quoin")));
  ASSERT_TRUE(box({0, 0, 0}, {1, 1, 1}, grid_of("1/2")).write(path("half.quoin")));
  std::vector<ImportReport> reports;
  const auto exact = read({path("small.off"), path("half.quoin"), path("third.quoin")}, {}, &reports);
  ASSERT_TRUE(exact) << exact.error().message;
  for (const Solid& solid : exact.value()) {
    EXPECT_EQ(solid.grid().step(), "1/3");
    EXPECT_EQ(volume(solid), "1");
  }
  EXPECT_EQ(reports.size(), 3u);
  ImportOptions options;
  options.grid = grid_of("1/10");
  EXPECT_EQ(read({path("small.off"), path("half.quoin")}, options).value()[1].grid().step(), "1/10");
  EXPECT_TRUE(read({}).value().empty());
}

TEST_F(Files, FormatsByName) {
  EXPECT_EQ(format_of("a.b.QUOIN").value(), Format::quoin);
  EXPECT_EQ(format_of("x.Stl").value(), Format::stl);
  EXPECT_EQ(format_of("quoin").error().code, "unknown-format");
  EXPECT_EQ(format_of("").error().code, "unknown-format");
}

TEST(Export, TopologyOfTouchingCubes) {
  const Solid both = box({0, 0, 0}, {1, 1, 1}) + box({1, 1, 0}, {2, 2, 1});
  ExportReport report;
  const Mesh manifold = both.to_triangles({}, &report).value();
  EXPECT_EQ(manifold.points.size(), 3u * 16);
  EXPECT_EQ(report.triangles, 24u);
  EXPECT_TRUE(report.closed);
  const Mesh indexed = both.to_triangles({Topology::indexed, false}, &report).value();
  EXPECT_EQ(indexed.points.size(), 3u * 14);
  EXPECT_TRUE(report.closed);
  EXPECT_EQ(report.flipped + report.collapsed, 0u);
}

TEST(Export, CoordinatesAreCorrectlyRounded) {
  const Solid a = box({0, 0, 0}, {1, 1, 1}, grid_of("1/3"));
  const auto part = split(a, {{"1", "0", "0", "-2/3"}}).value()[1];
  const Mesh mesh = part.to_triangles().value();
  EXPECT_NE(std::find(mesh.points.begin(), mesh.points.end(), 2. / 3), mesh.points.end());
  const Mesh floats = part.to_triangles({Topology::manifold, true}).value();
  EXPECT_NE(std::find(floats.points.begin(), floats.points.end(), static_cast<double>(2.f / 3)), floats.points.end());
}

TEST(Export, ReportsWhatRoundingCollapsed) {
  // 1 thick where float32 has multiples of 8.
  const Grid grid = grid_of("1/4");
  const Solid a = box({67108864, 0, 0}, {67108865, 1, 1}, grid);
  ExportReport report;
  ASSERT_TRUE(a.to_triangles({}, &report));
  EXPECT_EQ(report.collapsed, 0u);
  ASSERT_TRUE(a.to_triangles({Topology::manifold, true}, &report));
  EXPECT_EQ(report.collapsed, 8u);
  EXPECT_EQ(report.flipped, 0u);
  EXPECT_TRUE(report.closed);
}

TEST(Export, ReportsWhatRoundingFlipped) {
  // In float32, x is a multiple of 8 here: the middle corner of the base changes the side of the other two.
  const Solid a =
      tetrahedron({Corner{67108877, 0, 0}, Corner{67108883, 1, 0}, Corner{67108887, 2, 0}, Corner{67108880, 1, 9}});
  ExportReport report;
  ASSERT_TRUE(a.to_triangles({}, &report));
  EXPECT_EQ(report.flipped + report.collapsed, 0u);
  ASSERT_TRUE(a.to_triangles({Topology::manifold, true}, &report));
  EXPECT_GT(report.flipped, 0u);
}

TEST(Export, TheUnboundedHasNoMesh) {
  EXPECT_EQ(Solid::full(Grid()).to_triangles().error().code, "unbounded");
  EXPECT_TRUE(Solid().to_triangles().value().triangles.empty());
  const Solid huge = box({0, 0, 0}, {1e200, 1e200, 1e200}, grid_of("1e200"));
  EXPECT_TRUE(huge.to_triangles());
  EXPECT_EQ(huge.to_triangles({Topology::manifold, true}).error().code, "out-of-range");
}

}  // namespace
}  // namespace quoin::api_test
