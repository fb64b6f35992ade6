#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "exact/rational.h"
#include "io/quoin.h"
#include "tests/api/doors/quoin_damage.h"
#include "tests/api/fractions.h"
#include "tests/api/solids.h"
#include "tests/io/packages/gltf/documents.h"
#include "tests/io/packages/package.h"

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
  for (const char* name : {"a.stl", "a.obj", "a.OFF", "a.ply", "a.3mf", "a.glb", "a.gltf", "a.amf", "a.quoin"}) {
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
    put("plain", to_bytes(mesh, format).value());
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

/// The vertices and faces of two files as one, in canonical order; whether space is full far away is taken from the
/// first. Precondition: integer vertices, faces of one loop.
std::string both(const std::string& a, const std::string& b) {
  damage::Document p = damage::opened(a), q = damage::opened(b);
  auto& vertices = p.numbers.vertices;
  const auto before = static_cast<std::uint32_t>(vertices.size());
  vertices.insert(vertices.end(), q.numbers.vertices.begin(), q.numbers.vertices.end());
  for (auto& face : q.faces)
    for (auto& v : face[0]) v += before;

  const auto numbers = [](const std::array<std::string, 4>& text) {
    std::array<long long, 4> r{};
    for (std::size_t k = 0; k < 4; ++k) r[k] = damage::number(text[k]);
    return r;
  };
  std::vector<std::uint32_t> order(vertices.size()), rank(vertices.size());
  for (std::uint32_t v = 0; v < order.size(); ++v) order[v] = v;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t u, std::uint32_t v) { return numbers(vertices[u]) < numbers(vertices[v]); });
  for (std::uint32_t i = 0; i < order.size(); ++i) rank[order[i]] = i;

  damage::Document r{p.numbers, {}};
  r.numbers.planes.clear();
  for (std::size_t i = 0; i < order.size(); ++i) r.numbers.vertices[i] = vertices[order[i]];
  std::vector<std::pair<std::array<std::string, 4>, std::vector<std::uint32_t>>> faces;
  for (const damage::Document* d : {&p, &q})
    for (std::size_t f = 0; f < d->faces.size(); ++f) {
      std::vector<std::uint32_t> loop;
      for (const std::uint32_t v : d->faces[f][0]) loop.push_back(rank[v]);
      std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
      faces.emplace_back(d->numbers.planes[f], loop);
    }
  std::sort(faces.begin(), faces.end(), [&](const auto& x, const auto& y) {
    return std::pair(numbers(x.first), x.second) < std::pair(numbers(y.first), y.second);
  });
  for (const auto& [plane, loop] : faces) {
    r.numbers.planes.push_back(plane);
    r.faces.push_back({loop});
  }
  return damage::closed(r);
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
  const auto fault_of = [](const std::string& text) {
    const auto solid = Solid::from_quoin(text);
    return solid ? "" : solid.error().message;
  };
  for (std::size_t i = bad.size() - 3; i < bad.size(); ++i)
    EXPECT_EQ(fault_of(bad[i]).substr(0, 22), "the solid is not valid") << fault_of(bad[i]);
  // One of the faces is the wide box's at x = 9, the other one of those that meet it; of nested boxes one of the inner.
  using Plane = std::array<std::string, 4>;
  const auto planes_at_fault = [](const std::string& text) {
    const std::string where = Solid::from_quoin(text).error().where;
    const auto planes = damage::opened(text).numbers.planes;
    std::set<Plane> found;
    std::smatch numbers;
    if (!std::regex_match(where, numbers, std::regex("faces? ([0-9]+)(?: and ([0-9]+))?"))) ADD_FAILURE() << where;
    for (std::size_t i = 1; i < numbers.size(); ++i)
      if (numbers[i].matched) found.insert(planes.at(std::stoul(numbers[i].str())));
    return found;
  };
  for (std::size_t i = bad.size() - 2; i < bad.size(); ++i) {
    const std::set<Plane> planes = planes_at_fault(bad[i]);
    EXPECT_EQ(planes.size(), 2U);
    EXPECT_EQ(planes.count({"1", "0", "0", "-9"}), 1U);
    EXPECT_EQ(planes.count({"1", "0", "0", "-10"}), 0U);
  }
  const std::set<Plane> nested = planes_at_fault(bad[bad.size() - 3]);
  ASSERT_EQ(nested.size(), 1U);
  EXPECT_TRUE((*nested.begin())[3] == "1" || (*nested.begin())[3] == "-2") << (*nested.begin())[3];
  EXPECT_TRUE(Solid::from_quoin(both(wide, box({10, 1, 1}, {11, 2, 2}).to_quoin())));
  EXPECT_TRUE(Solid::from_quoin(both(wide, (~box({1, 1, 1}, {2, 2, 2})).to_quoin())));  // a cavity
  for (const std::string& text : bad) {
    const auto solid = Solid::from_quoin(text);
    ASSERT_FALSE(solid) << text;
    EXPECT_EQ(solid.error().code, ErrorCode::bad_quoin);
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
      EXPECT_EQ(solid.error().code, ErrorCode::bad_quoin);
    }
  }
}

TEST_F(Files, ErrorsNameTheFile) {
  EXPECT_EQ(read({path("none.off")}).error().code, ErrorCode::missing_file);
  EXPECT_EQ(read({path("none.off")}).error().file, path("none.off"));
  put("a.txt", "hello");
  EXPECT_EQ(read({path("a.txt")}).error().code, ErrorCode::unknown_format);
  put("a.off", "OFF\n1 1 0\n");
  EXPECT_EQ(read({path("a.off")}).error().file, path("a.off"));
  put("a.quoin", "quoin 1\n");
  EXPECT_EQ(read({path("a.quoin")}).error().code, ErrorCode::bad_quoin);
  EXPECT_EQ(read({path("a.quoin")}).error().file, path("a.quoin"));
  Mesh open = box_mesh({0, 0, 0}, {1, 1, 1});
  open.triangles.resize(9);
  put("open.off", to_bytes(open, Format::off).value());
  const auto refused = read({path("open.off")});
  EXPECT_EQ(refused.error().code, ErrorCode::open_boundary);
  EXPECT_EQ(refused.error().file, path("open.off"));
  const Solid a = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(a.write(path("a.txt")).error().code, ErrorCode::unknown_format);
  EXPECT_EQ(a.write(path("no/such/a.off")).error().code, ErrorCode::unwritable);
  EXPECT_EQ(a.write(path("no/such/a.off")).error().file, path("no/such/a.off"));
  EXPECT_EQ((~a).write(path("b.off")).error().code, ErrorCode::unbounded);
  EXPECT_FALSE(std::filesystem::exists(path("b.off")));
  EXPECT_TRUE((~a).write(path("b.quoin")));
}

TEST_F(Files, OneFileAtATime) {
  const Solid a = box({0, 0, 0}, {1, 1, 1.25}, grid_of("1/4"));
  ASSERT_TRUE(a.write(path("a.off")));
  ImportReport report;
  const auto back = read_solid(path("a.off"), {.grid = Grid()}, &report);
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(volume(*back), "1");
  EXPECT_GE(report.max_snap, 0.25);
  EXPECT_EQ(read_solid(path("none.off")).error().file, path("none.off"));
}

TEST(ToBytes, RefusesWhatIsNoMesh) {
  const Mesh good = box_mesh({0, 0, 0}, {1, 1, 1});
  Mesh half = good;
  half.points.pop_back();
  EXPECT_EQ(to_bytes(half, Format::off).error().where, "vertex 7");
  half = good;
  half.triangles.pop_back();
  EXPECT_EQ(to_bytes(half, Format::off).error().where, "face 11");
  for (const Format format :
       {Format::stl, Format::stl_ascii, Format::obj, Format::off, Format::ply, Format::ply_ascii}) {
    EXPECT_TRUE(to_bytes(good, format));
    Mesh bad = good;
    bad.triangles[5] = 8;
    EXPECT_EQ(to_bytes(bad, format).error().code, ErrorCode::bad_index);
    EXPECT_EQ(to_bytes(bad, format).error().where, "face 1");
    bad = good;
    bad.triangles.pop_back();
    EXPECT_EQ(to_bytes(bad, format).error().code, ErrorCode::bad_index);
    bad = good;
    bad.points.pop_back();
    EXPECT_EQ(to_bytes(bad, format).error().code, ErrorCode::bad_index);
    bad = good;
    bad.points[4] = std::nan("");
    EXPECT_EQ(to_bytes(bad, format).error().code, ErrorCode::non_finite);
    bad.points[4] = 1e300;
    EXPECT_EQ(to_bytes(bad, format).has_value(), format != Format::stl);
  }
  EXPECT_EQ(to_bytes(good, Format::quoin).error().code, ErrorCode::unknown_format);
  EXPECT_TRUE(to_bytes({}, Format::off));
}

TEST_F(Files, ContentDecides) {
  const Solid a = box({0, 0, 0}, {1, 1, 1});
  put("wrong.stl", a.to_quoin());
  put("wrong.quoin", to_bytes(a.to_triangles().value(), Format::ply).value());
  put("none", to_bytes(a.to_triangles().value(), Format::stl).value());
  for (const char* name : {"wrong.stl", "wrong.quoin", "none"}) {
    const auto back = read({path(name)});
    ASSERT_TRUE(back) << name << ": " << back.error().message;
    EXPECT_TRUE(back.value()[0] == a) << name;
  }
}

TEST_F(Files, OneCommonGrid) {
  const Mesh small = box_mesh({0, 0, 0}, {1, 1, 1}), wide = box_mesh({0, 0, 0}, {1024, 1, 1});
  put("small.off", to_bytes(small, Format::off).value());
  put("wide.off", to_bytes(wide, Format::off).value());
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

// A mesh beyond the world of the exact source's grid.
TEST_F(Files, MeshesBeyondTheWorldOfExactSources) {
  const Mesh wide = box_mesh({0, 0, 0}, {1024, 1024, 1});
  put("wide.off", to_bytes(wide, Format::off).value());
  const Mesh unit = box_mesh({0, 0, 0}, {1, 1, 1});
  ASSERT_TRUE(Solid::from_triangles(unit.points, unit.triangles).value().write(path("unit.quoin")));
  std::vector<ImportReport> reports;
  const auto solids = read({path("unit.quoin"), path("wide.off")}, {}, &reports);
  ASSERT_TRUE(solids) << solids.error().message;
  EXPECT_TRUE(solids.value()[0].grid() == solids.value()[1].grid());
  EXPECT_EQ(volume(solids.value()[1] - solids.value()[0]), "1048575");
  EXPECT_EQ(reports[0].max_snap, 0);
  EXPECT_EQ(reports[1].max_snap, 0);

  // Long normals on a fine grid, beside a plate that needs a coarse one.
  const std::vector<double> points{-.31, -.4, -.3, .5, -.3, -.2, .01, .5, -.4, .1, .2, .5};
  const Solid skew =
      Solid::from_triangles(points, std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}).value();
  ASSERT_TRUE(skew.write(path("skew.quoin")));
  const Mesh huge = box_mesh({0, 0, 0}, {1e9, 1e9, 1e9});
  put("huge.off", to_bytes(huge, Format::off).value());
  for (const auto& names : std::vector<std::vector<std::string>>{{path("skew.quoin"), path("huge.off")},
                                                                 {path("huge.off"), path("skew.quoin")}}) {
    const auto rounded = read(names, {}, &reports);
    ASSERT_TRUE(rounded) << rounded.error().message;
    const std::size_t at = names[0] == path("skew.quoin") ? 0 : 1;
    EXPECT_GT(reports[at].max_snap, 0);
    EXPECT_LT(reports[at].max_snap, 1e-15);
    EXPECT_EQ(reports[1 - at].max_snap, 0);
  }

  ImportOptions exact;
  exact.run.grid_rule = GridRule::exact;
  const auto refused = read({path("huge.off"), path("skew.quoin")}, exact);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::inexact_grid);
  EXPECT_EQ(refused.error().file, path("skew.quoin"));
}

TEST_F(Files, AMeshWithoutFacesIsRefused) {
  const std::vector<std::pair<std::string, std::string>> files = {
      {"wires.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"},
      {"empty.off", to_bytes(Mesh(), Format::off).value()},
      {"empty.stl", to_bytes(Mesh(), Format::stl).value()},
      {"ascii.stl", to_bytes(Mesh(), Format::stl_ascii).value()},
      {"empty.ply", to_bytes(Mesh(), Format::ply).value()},
      {"cloud.ply",
       "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
       "end_header\n0 0 0\n"}};
  for (const auto& [name, bytes] : files) {
    put(name, bytes);
    const auto solids = read({path(name)});
    ASSERT_FALSE(solids) << name;
    EXPECT_EQ(solids.error().code, ErrorCode::no_faces) << name;
    EXPECT_EQ(solids.error().file, path(name));
    EXPECT_NE(solids.error().where, "");
  }
  // The exact format and arrays can state the empty solid.
  ASSERT_TRUE(Solid().write(path("empty.quoin")));
  EXPECT_TRUE(read({path("empty.quoin")}).value()[0].is_empty());
  EXPECT_TRUE(Solid::from_triangles({}, {}).value().is_empty());
  EXPECT_TRUE(Solid::from_triangles(std::vector<double>{1, 2, 3}, {}).value().is_empty());
}

TEST_F(Files, AMeshWithoutAreasIsRefused) {
  Mesh line = box_mesh({0, 0, 0}, {1, 1, 1});
  for (std::size_t i = 0; i < line.points.size(); i += 3) line.points[i + 1] = line.points[i + 2] = line.points[i];
  put("line.off", to_bytes(line, Format::off).value());
  const auto solids = read({path("line.off")});
  ASSERT_FALSE(solids);
  EXPECT_EQ(solids.error().code, ErrorCode::no_faces);
  EXPECT_EQ(solids.error().file, path("line.off"));
  EXPECT_EQ(solids.error().where, "face 0");
  EXPECT_NE(solids.error().message.find("none of the 12 faces"), std::string::npos) << solids.error().message;
  for (const Trust trust : {Trust::nothing, Trust::embedded})
    EXPECT_EQ(Solid::from_triangles(line.points, line.triangles, {.trust = trust}).error().code, ErrorCode::no_faces);

  // What is wiped out by snapping is the empty solid, and the report says how.
  const Mesh small = box_mesh({0.1, 0.1, 0.1}, {0.2, 0.2, 0.2});
  ImportReport report;
  const auto nothing = Solid::from_triangles(small.points, small.triangles, {.grid = grid_of("1")}, &report);
  ASSERT_TRUE(nothing);
  EXPECT_TRUE(nothing.value().is_empty());
  EXPECT_EQ(report.zero_area_triangles, 12u);
}

/// Two meshes as one, the points of each its own.
Mesh joined(Mesh a, const Mesh& b) {
  const auto behind = static_cast<std::uint32_t>(a.points.size() / 3);
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const std::uint32_t v : b.triangles) a.triangles.push_back(behind + v);
  return a;
}

Mesh inside_out(Mesh mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) std::swap(mesh.triangles[t], mesh.triangles[t + 1]);
  return mesh;
}

TEST_F(Files, AnInsideOutBodyAmongOthersIsReported) {
  const Mesh good = box_mesh({0, 0, 0}, {2, 2, 2}), bad = inside_out(box_mesh({3.5, 0, 0}, {5, 2, 1}));
  ImportReport report;
  const auto solid = Solid::from_triangles(joined(good, bad).points, joined(good, bad).triangles, {}, &report);
  ASSERT_TRUE(solid);
  EXPECT_EQ(volume(solid.value()), "8");
  EXPECT_EQ(report.dropped_shells, 1u);
  EXPECT_EQ(report.dropped_where, "shell at (3.5, 0, 0)");
  EXPECT_EQ(report.resolved_crossings, 0u);

  // Inner voids, and a surface that is there twice, lose nothing.
  const Mesh hollow = joined(box_mesh({-1, -1, -1}, {3, 3, 3}), inside_out(good));
  ASSERT_TRUE(Solid::from_triangles(hollow.points, hollow.triangles, {}, &report));
  EXPECT_EQ(report.dropped_shells, 0u);
  EXPECT_EQ(report.dropped_where, "");
  const Mesh twice = joined(good, good);
  ASSERT_TRUE(Solid::from_triangles(twice.points, twice.triangles, {}, &report));
  EXPECT_EQ(report.dropped_shells, 0u);

  put("a.off", to_bytes(good, Format::off).value());
  put("b.off", to_bytes(joined(good, bad), Format::off).value());
  std::vector<ImportReport> reports;
  ASSERT_TRUE(read({path("a.off"), path("b.off")}, {}, &reports));
  EXPECT_EQ(reports[0].dropped_shells, 0u);
  EXPECT_EQ(reports[1].dropped_shells, 1u);
}

TEST_F(Files, ErrorsNameThePlace) {
  const Mesh cube = box_mesh({0, 0, 0}, {1, 1, 1});
  const auto where = [](const auto& result) { return result ? "a solid" : result.error().where; };
  Mesh broken = inside_out(cube);
  EXPECT_EQ(where(Solid::from_triangles(broken.points, broken.triangles)), "shell at (0, 0, 0)");
  broken = joined(box_mesh({5, 0, 0}, {6, 1, 1}), inside_out(box_mesh({0.5, 0, 0}, {4, 4, 4})));
  EXPECT_EQ(where(Solid::from_triangles(broken.points, broken.triangles)), "shell at (0.5, 0, 0)");
  broken = cube;
  broken.points.pop_back();
  EXPECT_EQ(where(Solid::from_triangles(broken.points, broken.triangles)), "vertex 7");
  broken = cube;
  broken.triangles.pop_back();
  EXPECT_EQ(where(Solid::from_triangles(broken.points, broken.triangles)), "face 11");
  broken = cube;
  broken.points[4] = 1e308;
  EXPECT_EQ(where(Solid::from_triangles(broken.points, broken.triangles)), "vertex 1 (1, 1e+308, 0)");
  EXPECT_EQ(where(Grid::fitting({0, 0, 0}, {1, 1e308, 1})), "high corner (1, 1e+308, 1)");
  EXPECT_EQ(where(Grid::fitting({0, -HUGE_VAL, 0}, {1, 1, 1})), "low corner (0, -inf, 0)");

  put("near.off", to_bytes(cube, Format::off).value());
  put("far.off", to_bytes(broken, Format::off).value());
  const auto solids = read({path("near.off"), path("far.off")});
  ASSERT_FALSE(solids);
  EXPECT_EQ(solids.error().code, ErrorCode::out_of_range);
  EXPECT_EQ(solids.error().file, path("far.off"));
  EXPECT_EQ(solids.error().where, "vertex 1 (1, 1e+308, 0)");
}

TEST_F(Files, ProgressOfEveryImportEndsAtOne) {
  const Mesh clean = box_mesh({0, 0, 0}, {2, 2, 2});
  const Mesh crossing = joined(clean, box_mesh({1, 1, 1}, {3, 3, 3}));
  const Mesh apart = joined(clean, box_mesh({4, 4, 4}, {5, 5, 5}));
  const Mesh flat = [&] {
    Mesh mesh = clean;
    for (std::size_t i = 2; i < mesh.points.size(); i += 3) mesh.points[i] = 0;
    return mesh;
  }();
  Fractions fractions;
  ImportOptions options;
  for (const Trust trust : {Trust::nothing, Trust::embedded})
    for (const Mesh* mesh : {&clean, &crossing, &apart, &flat}) {
      options.trust = trust;
      options.run.progress = fractions.record();
      ASSERT_TRUE(Solid::from_triangles(mesh->points, mesh->triangles, options));
      fractions.expect_whole("from_triangles");
      std::vector<std::uint32_t> starts;
      for (std::uint32_t i = 0; i <= mesh->triangles.size(); i += 3) starts.push_back(i);
      options.run.progress = fractions.record();
      ASSERT_TRUE(Solid::from_polygons(mesh->points, starts, mesh->triangles, options));
      fractions.expect_whole("from_polygons");
    }
  options.run.progress = fractions.record();
  ASSERT_TRUE(Solid::from_triangles({}, {}, options));
  fractions.expect_whole("no triangles");

  put("a.off", to_bytes(clean, Format::off).value());
  put("b.stl", to_bytes(crossing, Format::stl).value());
  ASSERT_TRUE(box({0, 0, 0}, {1, 1, 1}).write(path("c.quoin")));
  for (const Trust trust : {Trust::nothing, Trust::embedded})
    for (const std::vector<std::string>& names : std::vector<std::vector<std::string>>{{"a.off"},
                                                                                       {"c.quoin"},
                                                                                       {"a.off", "b.stl", "c.quoin"},
                                                                                       {"c.quoin", "c.quoin", "a.off"},
                                                                                       {"b.stl", "a.off", "a.off"},
                                                                                       {}}) {
      std::vector<std::string> paths;
      for (const std::string& name : names) paths.push_back(path(name));
      options.trust = trust;
      options.run.progress = fractions.record();
      ASSERT_TRUE(read(paths, options));
      fractions.expect_whole(std::to_string(names.size()) + " files");
    }
}

TEST_F(Files, FormatsByName) {
  EXPECT_EQ(format_of("a.b.QUOIN").value(), Format::quoin);
  EXPECT_EQ(format_of("x.Stl").value(), Format::stl);
  EXPECT_EQ(format_of("quoin").error().code, ErrorCode::unknown_format);
  EXPECT_EQ(format_of("").error().code, ErrorCode::unknown_format);
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
  ASSERT_TRUE(a.to_triangles({.float32 = true, .validity = Validity::fast}, &report));
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
  ASSERT_TRUE(a.to_triangles({.float32 = true, .validity = Validity::fast}, &report));
  EXPECT_GT(report.flipped, 0u);
}

TEST(Export, TheUnboundedHasNoMesh) {
  EXPECT_EQ(Solid::full(Grid()).to_triangles().error().code, ErrorCode::unbounded);
  EXPECT_TRUE(Solid().to_triangles().value().triangles.empty());
  const Solid huge = box({0, 0, 0}, {1e200, 1e200, 1e200}, grid_of("1e200"));
  EXPECT_TRUE(huge.to_triangles());
  const auto refused = huge.to_triangles({Topology::manifold, true});
  EXPECT_EQ(refused.error().code, ErrorCode::out_of_range);
  EXPECT_EQ(refused.error().where.rfind("vertex (", 0), 0u) << refused.error().where;
  EXPECT_NE(refused.error().where.find("1e+200"), std::string::npos) << refused.error().where;
}

// Items of a package of three: a tetrahedron, the same elsewhere, and one that overlaps the first, inside out where it
// is mirrored without being turned round.
std::string three_items() {
  using namespace io::test;
  return package(model_text(object_text(1, tetrahedron_text("4"), "name=\"tip\""),
                            "<item objectid=\"1\"/>"
                            "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 10 0 0\"/>"
                            "<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 2 0 0\"/>",
                            "unit=\"inch\""));
}

TEST_F(Files, ObjectsOfOneFile) {
  put("a.3mf", three_items());
  ImportOptions options;
  options.grid = Grid();
  const Solid tip = read_solid(path("a.3mf#1"), options).value();
  EXPECT_EQ(tip, read_solid(path("a.3mf#tip"), options).value());
  EXPECT_EQ(tip.volume(), "32/3");
  const auto objects = read_objects(path("a.3mf"));
  ASSERT_TRUE(objects) << objects.error().message;
  ASSERT_EQ(objects.value().size(), 3u);
  EXPECT_EQ(objects.value()[1].mesh.points[3], 14);
  EXPECT_EQ(objects.value()[2].objects[0].number, 3u);
  EXPECT_EQ(objects.value()[0].unit, Unit::inch);

  // All together are the union of each by itself.
  const auto apart = build(objects.value(), options).value();
  EXPECT_EQ(read_solid(path("a.3mf"), options).value(), unite(apart).value());
  const auto all = read_source(path("a.3mf")).value();
  EXPECT_EQ(all.others.size(), 2u);
  EXPECT_EQ(all.objects.size(), 3u);

  for (const char* name : {"a.3mf#0", "a.3mf#4", "a.3mf#x", "a.3mf#", "a.3mf#1x"}) {
    const auto none = read_source(path(name));
    ASSERT_FALSE(none) << name;
    EXPECT_EQ(none.error().code, ErrorCode::bad_index) << name;
    EXPECT_EQ(none.error().file, path(name));
  }
  EXPECT_EQ(file_of("b#1.stl"), "b#1.stl");
  EXPECT_EQ(file_of("b.stl#1.off"), "b.stl#1.off");
  EXPECT_EQ(file_of("b.stl#1"), "b.stl");
  EXPECT_EQ(file_of("-#2"), "-");
}

TEST_F(Files, UnitsAreKeptOrConvertedWhenAsked) {
  put("inch.3mf", three_items());
  ASSERT_TRUE(box({0, 0, 0}, {1, 1, 1}).write(path("none.off")));
  put("mm.3mf", io::test::package(io::test::model_text(io::test::object_text(1, io::test::tetrahedron_text("127")),
                                                       "<item objectid=\"1\"/>")));
  const auto inch = read_source(path("inch.3mf#1")).value(), mm = read_source(path("mm.3mf")).value(),
             none = read_source(path("none.off")).value();
  EXPECT_EQ(none.unit, Unit::none);
  EXPECT_TRUE(build({inch, none}));
  const auto mixed = build({none, mm, inch});
  ASSERT_FALSE(mixed);
  EXPECT_EQ(mixed.error().code, ErrorCode::mixed_units);
  EXPECT_EQ(mixed.error().file, path("inch.3mf#1"));

  // 4 inches are 101.6 mm, and 127 mm 5 inches, to the bit.
  const auto in_mm = read_source(path("inch.3mf#1"), {}, Trust::nothing, Unit::millimeter).value();
  EXPECT_EQ(in_mm.unit, Unit::millimeter);
  EXPECT_EQ(in_mm.mesh.points[3], 101.6);
  EXPECT_EQ(read_source(path("mm.3mf"), {}, Trust::nothing, Unit::inch).value().mesh.points[3], 5);
  const auto taken = read_source(path("none.off"), {}, Trust::nothing, Unit::foot).value();
  EXPECT_EQ(taken.unit, Unit::foot);
  EXPECT_EQ(taken.mesh.points, none.mesh.points);
}

// Each mesh of a source may have shells that are inside out: one notice says all of them, behind the others.
TEST(SourceOfMeshes, NoticesOfDroppedShells) {
  const auto two_bodies = [](double x) {
    PolygonMesh mesh;
    const auto add_tetrahedron = [&](double at, double leg, bool inside_out) {
      const auto first = static_cast<std::uint32_t>(mesh.points.size() / 3);
      mesh.points.insert(mesh.points.end(), {at, 0, 0, at + leg, 0, 0, at, leg, 0, at, 0, leg});
      for (auto [a, b, c] : {std::array<std::uint32_t, 3>{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
        if (inside_out) std::swap(b, c);
        mesh.corners.insert(mesh.corners.end(), {first + a, first + b, first + c});
        mesh.starts.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
      }
    };
    add_tetrahedron(x, 6, false);
    add_tetrahedron(x + 10, 3, true);
    return mesh;
  };
  Source source;
  source.mesh = two_bodies(0);
  source.others = {two_bodies(100)};
  source.notices = {{3, "3 lines are passed over"}};

  std::vector<ImportReport> reports;
  const auto solids = build({source}, {}, &reports);
  ASSERT_TRUE(solids) << solids.error().message;
  EXPECT_EQ(solids.value()[0].volume(), "72");
  EXPECT_EQ(reports[0].dropped_shells, 2U);
  EXPECT_EQ(reports[0].notices, (std::vector<Notice>{{3, "3 lines are passed over"},
                                                     {2, "2 shells are inside out and bound nothing: dropped"}}));
}

// Normalised integers of a glTF are exact until they are placed.
TEST_F(Files, QuantisedPositionsAreRoundedOnce) {
  const std::vector<int> corners = {0, 0, 0, 65535, 0, 0, 0, 1, 0, 0, 0, 3};
  put("plain.glb", io::test::quantised(corners, 5123, true));
  put("moved.glb", io::test::quantised(corners, 5123, true, R"(,"scale":[0.1,0.1,0.1],"translation":[0,7,0])"));
  const auto plain = read_source(path("plain.glb")), moved = read_source(path("moved.glb"));
  ASSERT_TRUE(plain && moved);
  const exact::Rational tenth = exact::to_rational(0.1);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    EXPECT_EQ(plain.value().mesh.points[i], corners[i] / 65535.0);
    EXPECT_EQ(moved.value().mesh.points[i],
              exact::to_double(exact::Rational(corners[i] * tenth / 65535 + (i % 3 == 1 ? 7 : 0))));
  }
}

// A glTF may name files beside it, and no others.
TEST_F(Files, BuffersAreBesideTheFile) {
  const Mesh mesh = box({0, 0, 0}, {1, 1, 1}).to_triangles().value();
  const std::string glb = to_bytes(mesh, Format::glb).value();
  const std::size_t begin = glb.find("BIN") - 4;
  std::string json = glb.substr(20, begin - 20);
  const auto with_uri = [&](const std::string& uri) {
    std::string text = json;
    return text.insert(text.find("\"buffers\":[{") + 12, "\"uri\":\"" + uri + "\",");
  };
  std::filesystem::create_directory(path("below"));
  for (const char* name : {"data.bin", "below/data.bin"}) put(name, glb.substr(begin + 8));
  put("good.gltf", with_uri("data.bin"));
  EXPECT_EQ(read_solid(path("good.gltf")).value().volume(), "1");
  for (const std::string& uri :
       {std::string("below/data.bin"), std::string("../data.bin"), path("data.bin"), std::string("data%00.bin"),
        std::string(".."), std::string("-"), std::string("no.bin")}) {
    put("bad.gltf", with_uri(uri));
    const auto refused = read_source(path("bad.gltf"));
    ASSERT_FALSE(refused) << uri;
    EXPECT_EQ(refused.error().code, ErrorCode::missing_file) << uri;
    EXPECT_EQ(refused.error().file, path("bad.gltf"));
    EXPECT_FALSE(refused.error().where.empty());
  }
}

}  // namespace
}  // namespace quoin::api_test
