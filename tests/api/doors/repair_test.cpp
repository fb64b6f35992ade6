// Meshes damaged in a known way: the diagnosis names exactly the damage, and the cure gives back what was.
#include <algorithm>
#include <cmath>
#include <set>

#include "tests/api/doors/damaged_meshes.h"
#include "tests/api/fractions.h"
#include "tests/api/solids.h"

namespace quoin {
namespace {

using namespace api_test;
using namespace damaged;

const Grid grid = grid_of("1/1048576");

Result<Solid> import(const Mesh& mesh, const Repair& repair = {}, ImportReport* report = nullptr) {
  ImportOptions options;
  options.grid = grid;
  options.repair = repair;
  return Solid::from_triangles(mesh.points, mesh.triangles, options, report);
}

std::vector<Finding> findings(const Mesh& mesh, const Repair& repair = {}) {
  ImportReport report;
  static_cast<void>(import(mesh, repair, &report));
  return report.findings;
}

std::vector<std::string> kinds(const std::vector<Finding>& list) {
  std::vector<std::string> names;
  for (const Finding& f : list) names.push_back(to_string(f.kind));
  return names;
}

Repair cure(const std::string& text) { return Repair::parse(text).value(); }

void expect_refused(const Mesh& mesh, const Repair& repair = {}) {
  const auto solid = import(mesh, repair);
  ASSERT_FALSE(solid.has_value());
  EXPECT_EQ(solid.error().code, ErrorCode::open_boundary) << solid.error().message;
}

// Vertices in the middle of edges of one triangle, exactly: closed without asking.
TEST(Repair, ExactTJunctionsAreSealedWithoutAsking) {
  auto random = random_engine();
  for (int round = 0; round < 30; ++round) {
    Mesh mesh = bumpy_block(4, random);
    const Solid whole = import(mesh).value();
    const auto chosen = some_of(size_of(mesh), 1 + random() % 20, 7, random);
    for (const std::size_t t : chosen) put_on_edge(mesh, t);
    shuffle(mesh, random);

    ImportReport report;
    const auto solid = import(mesh, {}, &report);
    ASSERT_TRUE(solid.has_value()) << solid.error().message;
    EXPECT_EQ(solid.value().to_quoin(), whole.to_quoin());
    EXPECT_EQ(report.sealed_t_junctions, chosen.size());
    EXPECT_TRUE(report.findings.empty());
    EXPECT_TRUE(report.repairs.empty());
  }
}

// Several vertices on one edge, on both of its sides, and edges that overlap in part only.
TEST(Repair, EdgesThatOverlapInPartAreSealed) {
  Mesh mesh = box_mesh({0, 0, 0}, {8, 8, 8});
  const Solid whole = import(mesh).value();
  // The edge 4 - 5, from (0, 0, 8) to (8, 0, 8), of triangles 2 (4 5 6) and 5 (1 5 4).
  const auto split = [&](std::size_t t, std::initializer_list<double> places) {
    std::uint32_t* corner = &mesh.triangles[3 * t];
    std::rotate(corner, std::find(corner, corner + 3, t == 2 ? 4U : 5U), corner + 3);
    const std::uint32_t end = corner[1], apex = corner[2];
    std::uint32_t from = 0;
    bool is_first = true;
    for (const double x : places) {
      const std::uint32_t next = add_vertex(mesh, {x, 0, 8});
      if (is_first)
        mesh.triangles[3 * t + 1] = next;
      else
        add_triangle(mesh, from, next, apex);
      from = next;
      is_first = false;
    }
    add_triangle(mesh, from, end, apex);
  };
  split(2, {1, 3, 6});
  split(5, {7, 6, 2});
  ImportReport report;
  const auto solid = import(mesh, {}, &report);
  ASSERT_TRUE(solid.has_value()) << solid.error().message;
  EXPECT_EQ(solid.value(), whole);
  EXPECT_EQ(report.sealed_t_junctions, 4U);
}

// Triangles torn off by a known width: the diagnosis knows it to 1 %, and the weld moves the torn ones back.
TEST(Repair, CracksAreMeasuredAndWelded) {
  auto random = random_engine();
  for (int round = 0; round < 20; ++round) {
    Mesh mesh = bumpy_block(4, random);
    const Solid whole = import(mesh).value();
    const double width = std::ldexp(1.0, -static_cast<int>(7 + random() % 12));
    const auto chosen = some_of(size_of(mesh), 1 + random() % 6, 16, random);
    std::set<std::uint32_t> torn;
    for (const std::size_t t : chosen) {
      torn.insert({mesh.triangles[3 * t], mesh.triangles[3 * t + 1], mesh.triangles[3 * t + 2]});
      tear_off(mesh, t, {width, 0, 0});
    }
    if (torn.size() != 3 * chosen.size()) continue;  // two of them shared a vertex
    shuffle(mesh, random);

    expect_refused(mesh);
    const auto found = findings(mesh);
    ASSERT_EQ(kinds(found), std::vector<std::string>{"crack"});
    EXPECT_EQ(found[0].count, torn.size());
    EXPECT_GE(found[0].size, width);
    EXPECT_LE(found[0].size, width * (1 + 1e-9));

    for (const Repair& repair : {cure(found[0].cure), cure("all")}) {
      ImportReport report;
      const auto solid = import(mesh, repair, &report);
      ASSERT_TRUE(solid.has_value()) << solid.error().message;
      EXPECT_EQ(solid.value(), whole);
      EXPECT_EQ(kinds(report.repairs), std::vector<std::string>{"crack"});
      EXPECT_EQ(report.repairs[0].count, torn.size());
      EXPECT_EQ(report.repairs[0].size, found[0].size);
      EXPECT_TRUE(report.findings.empty());
    }
    Repair narrow;
    narrow.weld = std::to_string(width * 0.75);
    expect_refused(mesh, narrow);
  }
}

// A weld moves nothing but boundary vertices: small triangles elsewhere stay.
TEST(Repair, AWeldLeavesTheRestAsItIs) {
  Mesh mesh = box_mesh({0, 0, 0}, {8, 8, 8});
  append(mesh, box_mesh({20, 0, 0}, {20.015625, 0.015625, 0.015625}));
  const Solid whole = import(mesh).value();
  tear_off(mesh, 0, {0.03125, 0, 0});
  EXPECT_EQ(import(mesh, cure("weld=1/16")).value(), whole);
}

// A tetrahedron with an edge of half the tolerance, one of its faces torn off beside it.
TEST(Repair, AWeldKeepsEdgesShorterThanTheTolerance) {
  Mesh mesh;
  mesh.points = {0, 0, 0, 0.03125, 0, 0, 0, 8, 0, 0, 0, 8};
  mesh.triangles = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  const Solid whole = import(mesh).value();
  tear_off(mesh, 0, {0, 0, 0.015625});
  ImportReport report;
  EXPECT_EQ(import(mesh, cure("weld=1/16"), &report).value(), whole);
  EXPECT_EQ(report.repairs[0].count, 3U);
}

// Vertices beside an edge, at a known distance: the cure bends the edge to them, and the volume changes by no more than
// that distance times the areas of the triangles around.
TEST(Repair, NearTJunctionsAreMeasuredAndJoined) {
  auto random = random_engine();
  for (int round = 0; round < 20; ++round) {
    Mesh mesh = bumpy_block(4, random);
    const Solid whole = import(mesh).value();
    const double distance = std::ldexp(1.0, -static_cast<int>(8 + random() % 10));
    const auto chosen = some_of(size_of(mesh), 1 + random() % 8, 9, random);
    for (const std::size_t t : chosen) put_on_edge(mesh, t, {0, distance, 0});
    shuffle(mesh, random);

    expect_refused(mesh);
    const auto found = findings(mesh);
    ASSERT_EQ(kinds(found), std::vector<std::string>{"t-junction"});
    EXPECT_EQ(found[0].count, chosen.size());
    EXPECT_LE(found[0].size, distance * (1 + 1e-9));

    for (const Repair& repair : {cure(found[0].cure), cure("all")}) {
      ImportReport report;
      const auto solid = import(mesh, repair, &report);
      ASSERT_TRUE(solid.has_value()) << solid.error().message;
      EXPECT_EQ(kinds(report.repairs), std::vector<std::string>{"t-junction"});
      const double change = std::fabs(solid.value().info().volume_approx - whole.info().volume_approx);
      EXPECT_LE(change, 2.0 * distance * static_cast<double>(chosen.size()));
    }
  }
}

// A triangle that is missing is a planar hole, whatever is around it; the cap is the triangle.
TEST(Repair, PlanarHolesAreCapped) {
  auto random = random_engine();
  for (int round = 0; round < 20; ++round) {
    Mesh mesh = bumpy_block(4, random);
    const Solid whole = import(mesh).value();
    auto chosen = some_of(size_of(mesh), 1 + random() % 5, 24, random);
    std::set<std::uint32_t> corners;
    std::reverse(chosen.begin(), chosen.end());
    for (const std::size_t t : chosen) {
      for (std::size_t k = 0; k < 3; ++k) corners.insert(mesh.triangles[3 * t + k]);
      remove_triangle(mesh, t);
    }
    if (corners.size() != 3 * chosen.size()) continue;
    shuffle(mesh, random);

    expect_refused(mesh);
    const auto found = findings(mesh);
    ASSERT_EQ(kinds(found), std::vector<std::string>{"hole"});
    EXPECT_EQ(found[0].count, chosen.size());
    EXPECT_EQ(found[0].cure, "caps");
    for (const char* text : {"caps", "all"}) EXPECT_EQ(import(mesh, cure(text)).value(), whole) << text;
  }
}

// A box without one of its sides, and one without two opposite ones: a tube.
TEST(Repair, MissingSidesOfABoxAreCapped) {
  Mesh mesh = box_mesh({0, 0, 0}, {2, 3, 5});
  const Solid whole = import(mesh).value();
  mesh.triangles.resize(30);
  EXPECT_EQ(findings(mesh)[0].count, 1U);
  EXPECT_EQ(import(mesh, cure("caps")).value(), whole);
  EXPECT_EQ(import(mesh, cure("all")).value(), whole);
  mesh.triangles.resize(24);
  EXPECT_EQ(findings(mesh)[0].count, 2U);
  EXPECT_EQ(import(mesh, cure("caps")).value(), whole);
}

// A hole of six triangles around a vertex is not planar: it is closed up to the size asked for.
TEST(Repair, SmallHolesAreClosedUpToASize) {
  auto random = random_engine();
  for (int round = 0; round < 20; ++round) {
    Mesh mesh = bumpy_block(6, random);
    const Solid whole = import(mesh).value();
    const std::uint32_t gone = mesh.triangles[3 * (random() % size_of(mesh))];
    std::size_t count = 0;
    for (std::size_t t = size_of(mesh); t-- > 0;) {
      const auto* corner = &mesh.triangles[3 * t];
      if (std::find(corner, corner + 3, gone) == corner + 3) continue;
      remove_triangle(mesh, t);
      ++count;
    }
    expect_refused(mesh);
    const auto found = findings(mesh);
    ASSERT_EQ(kinds(found), std::vector<std::string>{"hole"});
    EXPECT_EQ(found[0].count, 1U);
    EXPECT_LT(found[0].size, 4);
    expect_refused(mesh, cure("caps=1/2"));
    const auto solid = import(mesh, cure("caps=" + std::to_string(found[0].size + 0.001)));
    ASSERT_TRUE(solid.has_value()) << solid.error().message;
    // A hole of so few cells is not deeper than its size.
    EXPECT_LE(std::fabs(solid.value().info().volume_approx - whole.info().volume_approx), static_cast<double>(count));
  }
}

// What `all` closes: rims that are flat for their size, of half of the surface, and small holes however they bend.
TEST(Repair, FlatAndSmallHolesAreClosedByAll) {
  for (const auto& [depth, is_closed] : {std::pair{0.125, true}, {1.5, false}}) {
    Mesh mesh = box_mesh({0, 0, 0}, {4, 4, 8});
    mesh.triangles.resize(30);    // all but x = 4
    mesh.points[3 * 7] -= depth;  // (4, 4, 8)
    EXPECT_EQ(findings(mesh)[0].cure.find("caps="), 0U);
    const auto solid = import(mesh, cure("all"));
    ASSERT_EQ(solid.has_value(), is_closed) << depth;
    if (!is_closed) continue;
    // Of four corners there are two ways to close them: by a part more or less of 1/6 of 4 * 8 * depth.
    const double change = 128 - solid.value().info().volume_approx;
    EXPECT_GT(change, 0);
    EXPECT_LE(change, 4 * 8 * depth / 2);
  }

  auto random = random_engine();
  for (int round = 0; round < 20; ++round) {
    Mesh mesh = bumpy_block(8, random);
    const Solid whole = import(mesh).value();
    const std::uint32_t gone = mesh.triangles[3 * (random() % size_of(mesh))];
    for (std::size_t t = size_of(mesh); t-- > 0;) {
      const auto* corner = &mesh.triangles[3 * t];
      if (std::find(corner, corner + 3, gone) != corner + 3) remove_triangle(mesh, t);
    }
    ImportReport report;
    const auto solid = import(mesh, cure("all"), &report);
    ASSERT_TRUE(solid.has_value()) << solid.error().message;
    EXPECT_EQ(kinds(report.repairs), std::vector<std::string>{"hole"});
    EXPECT_LE(std::fabs(solid.value().info().volume_approx - whole.info().volume_approx), 6);
  }
}

// A flap as large as what it hangs on may be what is meant: it goes where it is named alone.
TEST(Repair, LargeFlapsAreDroppedByName) {
  Mesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  const Solid whole = import(mesh).value();
  const std::uint32_t tip = add_vertex(mesh, {0.5, 0.5, 16});
  add_triangle(mesh, 0, 1, tip);
  EXPECT_EQ(import(mesh, cure("all")).error().code, ErrorCode::open_boundary);
  EXPECT_EQ(findings(mesh)[0].kind, Defect::hole);
  EXPECT_EQ(import(mesh, cure("duplicates")).value(), whole);
  EXPECT_EQ(import(mesh, cure("duplicates,all")).value(), whole);
  mesh.points[3 * tip + 2] = 1.5;
  EXPECT_EQ(import(mesh, cure("all")).value(), whole);
}

TEST(Repair, TrianglesThatLookTheWrongWayTurn) {
  auto random = random_engine();
  for (int round = 0; round < 20; ++round) {
    Mesh mesh = bumpy_block(4, random);
    const Solid whole = import(mesh).value();
    const auto chosen = some_of(size_of(mesh), 1 + random() % 30, 5, random);
    for (const std::size_t t : chosen) turn_over(mesh, t);
    shuffle(mesh, random);

    expect_refused(mesh);
    const auto found = findings(mesh);
    ASSERT_EQ(kinds(found), std::vector<std::string>{"orientation"});
    EXPECT_EQ(found[0].count, chosen.size());
    EXPECT_EQ(found[0].cure, "orient");
    for (const char* text : {"orient", "orient=solid", "all"}) EXPECT_EQ(import(mesh, cure(text)).value(), whole);
  }
}

TEST(Repair, CopiesOfTrianglesAreDropped) {
  auto random = random_engine();
  for (int round = 0; round < 20; ++round) {
    Mesh mesh = bumpy_block(4, random);
    const Solid whole = import(mesh).value();
    const auto chosen = some_of(size_of(mesh), 1 + random() % 20, 3, random);
    const bool opposite = round % 2 == 1;
    for (const std::size_t t : chosen) {
      double_triangle(mesh, t);
      if (opposite) turn_over(mesh, size_of(mesh) - 1);
    }
    shuffle(mesh, random);

    expect_refused(mesh);
    const auto found = findings(mesh);
    ASSERT_EQ(kinds(found), std::vector<std::string>{"duplicate"});
    EXPECT_EQ(found[0].count, chosen.size());
    for (const char* text : {"duplicates", "all"}) EXPECT_EQ(import(mesh, cure(text)).value(), whole) << text;
  }
}

// A surface that is there twice is closed, and stays.
TEST(Repair, WhatIsClosedStaysAsItIs) {
  auto random = random_engine();
  Mesh mesh = bumpy_block(3, random);
  append(mesh, mesh);
  append(mesh, box_mesh({1, 1, 1}, {2, 2, 2}));  // outwards, within
  append(mesh, box_mesh({2, 2, 2}, {5, 5, 5}));  // across
  append(mesh, box_mesh({5, 5, 2}, {6, 6, 5}));  // along an edge
  const Solid whole = import(mesh).value();
  for (const char* text : {"all", "weld=1/100", "t-junctions=1/100", "duplicates", "caps,caps=100", "invert-shells"}) {
    ImportReport report;
    EXPECT_EQ(import(mesh, cure(text), &report).value(), whole) << text;
    EXPECT_TRUE(report.repairs.empty()) << text;
  }
}

TEST(Repair, FlapsAreDropped) {
  auto random = random_engine();
  for (int round = 0; round < 20; ++round) {
    Mesh mesh = bumpy_block(4, random);
    const Solid whole = import(mesh).value();
    const auto chosen = some_of(size_of(mesh), 1 + random() % 6, 11, random);
    for (const std::size_t t : chosen) add_flap(mesh, t);
    add_flap(mesh, size_of(mesh) - 1);  // a flap on a flap, at the edge that both share
    mesh.triangles[mesh.triangles.size() - 3] = mesh.triangles[mesh.triangles.size() - 4];
    mesh.points.back() += 1;
    append(mesh, terrain(1, 0, true, random));  // a loose square
    for (std::size_t i = mesh.points.size() - 12; i < mesh.points.size(); i += 3) mesh.points[i] += 100;
    shuffle(mesh, random);

    expect_refused(mesh);
    const auto found = findings(mesh);
    ASSERT_EQ(kinds(found), std::vector<std::string>{"flap"});
    EXPECT_EQ(found[0].count, chosen.size() + 3);
    for (const char* text : {"duplicates", "all"}) EXPECT_EQ(import(mesh, cure(text)).value(), whole) << text;
  }
}

TEST(Repair, ShellsTurnByThemselves) {
  Mesh small = box_mesh({10, 0, 0}, {12, 2, 2});
  turn_all(small);
  Mesh mesh = box_mesh({0, 0, 0}, {4, 4, 4});
  append(mesh, small);
  EXPECT_EQ(volume(import(mesh).value()), "64");
  const auto found = findings(mesh);
  ASSERT_EQ(kinds(found), std::vector<std::string>{"inside-out"});
  EXPECT_EQ(found[0].cure, "invert-shells");
  for (const char* text : {"invert-shells", "orient", "orient=solid", "all"})
    EXPECT_EQ(volume(import(mesh, cure(text)).value()), "72") << text;

  // All of it inside out, a void within and a body within that.
  Mesh nested = box_mesh({0, 0, 0}, {10, 10, 10}), hollow = box_mesh({1, 1, 1}, {9, 9, 9});
  turn_all(hollow);
  append(nested, hollow);
  append(nested, box_mesh({4, 4, 4}, {6, 6, 6}));
  EXPECT_EQ(volume(import(nested).value()), "496");
  EXPECT_EQ(volume(import(nested, cure("orient")).value()), "496");
  EXPECT_EQ(volume(import(nested, cure("invert-shells")).value()), "496");
  EXPECT_EQ(volume(import(nested, cure("orient=solid")).value()), "1000");
  turn_all(nested);
  EXPECT_EQ(import(nested).error().code, ErrorCode::inside_out);
  EXPECT_EQ(findings(nested)[0].kind, Defect::inside_out);
  EXPECT_EQ(volume(import(nested, cure("orient")).value()), "496");
  EXPECT_EQ(volume(import(nested, cure("invert-shells")).value()), "496");
  EXPECT_EQ(volume(import(nested, cure("all")).value()), "496");

  // A void that looks outwards is one by nesting alone.
  Mesh filled = box_mesh({0, 0, 0}, {10, 10, 10});
  append(filled, box_mesh({1, 1, 1}, {9, 9, 9}));
  EXPECT_EQ(volume(import(filled, cure("orient")).value()), "488");
  EXPECT_EQ(volume(import(filled, cure("all")).value()), "1000");
}

// Which of two equal bodies a triangle belongs to does not decide which one turns.
TEST(Repair, ShellsThatShareEdgesTurnInAnyOrder) {
  auto random = random_engine();
  Mesh mesh = box_mesh({0, 0, 0}, {4, 4, 4}), turned = box_mesh({4, 0, 0}, {8, 4, 4});
  turn_all(turned);
  append(mesh, turned);
  append(mesh, box_mesh({0, 4, 4}, {4, 8, 8}));
  append(mesh, box_mesh({0, 4, 4}, {4, 8, 8}));
  const std::string expected = import(mesh, cure("all")).value().to_quoin();
  for (int order = 0; order < 20; ++order) {
    shuffle(mesh, random);
    EXPECT_EQ(import(mesh, cure("all")).value().to_quoin(), expected);
  }
}

// From nearly flat to needles, with skirts on three sides or none.
TEST(Repair, OpenTerrainIsRefused) {
  auto random = random_engine();
  for (int round = 0; round < 60; ++round) {
    const double height = std::ldexp(1.0, static_cast<int>(random() % 13) - 4);
    Mesh mesh = terrain(4 + static_cast<std::uint32_t>(random() % 8), height, round % 2 == 0, random);
    if (round % 3 == 0) remove_triangle(mesh, size_of(mesh) / 2);
    if (round % 5 == 0 && height <= 4) add_skirts(mesh, 3);
    expect_refused(mesh, cure("all"));
    turn_all(mesh);
    expect_refused(mesh, cure("all"));
  }
}

/// Damage of all kinds at once.
Mesh damaged_block(std::mt19937_64& random) {
  Mesh mesh = bumpy_block(5, random);
  const std::size_t count = size_of(mesh);
  for (const std::size_t t : some_of(count, 3, 60, random)) tear_off(mesh, t, {0, 0x1p-10, 0x1p-11});
  for (const std::size_t t : some_of(count, 4, 50, random)) put_on_edge(mesh, t, {0x1p-12, 0, 0});
  for (const std::size_t t : some_of(count, 3, 70, random)) turn_over(mesh, t);
  for (const std::size_t t : some_of(count, 2, 90, random)) double_triangle(mesh, t);
  for (const std::size_t t : some_of(count, 2, 80, random)) add_flap(mesh, t);
  if (random() % 2 == 0) remove_triangle(mesh, random() % count);
  return mesh;
}

TEST(Repair, TheOrderOfTrianglesChangesNothing) {
  auto random = random_engine();
  int accepted = 0;
  for (int round = 0; round < 40; ++round) {
    Mesh mesh = damaged_block(random);
    const auto first = import(mesh, cure("all"));
    const auto found = findings(mesh);
    accepted += first ? 1 : 0;
    for (int again = 0; again < 3; ++again) {
      shuffle(mesh, random);
      const auto other = import(mesh, cure("all"));
      ASSERT_EQ(first.has_value(), other.has_value());
      if (first) {
        EXPECT_EQ(first.value().to_quoin(), other.value().to_quoin());
      }
      const auto found_again = findings(mesh);
      ASSERT_EQ(kinds(found), kinds(found_again));
      for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].sentence, found_again[i].sentence);
    }
  }
  EXPECT_GT(accepted, 20);
}

TEST(Repair, DiagnoseAnswersForArrays) {
  Mesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  std::vector<std::uint32_t> starts;
  for (std::uint32_t i = 0; i <= mesh.triangles.size(); i += 3) starts.push_back(i);
  EXPECT_TRUE(diagnose(mesh.points, starts, mesh.triangles).value().findings.empty());
  starts.pop_back();
  const Diagnosis open = diagnose(mesh.points, starts, mesh.triangles).value();
  ASSERT_EQ(kinds(open.findings), std::vector<std::string>{"hole"});
  EXPECT_EQ(open.findings[0].sentence.find("1 planar hole, 1.41421356"), 0U) << open.findings[0].sentence;
  mesh.triangles[0] = 99;
  EXPECT_EQ(diagnose(mesh.points, starts, mesh.triangles).error().code, ErrorCode::bad_index);
}

TEST(Repair, TheErrorNamesTheFirstFindingAndItsCure) {
  Mesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  double_triangle(mesh, 3);
  const Error error = import(mesh).error();
  EXPECT_NE(error.message.find(": 1 face is there more often than the surface needs (repair duplicates)"),
            std::string::npos)
      << error.message;
}

TEST(Repair, WordsOfCures) {
  const Repair all = cure("weld=0.5,t-junctions=1/3,duplicates,orient=solid,caps,caps=2,invert-shells,all");
  EXPECT_EQ(all.weld, "0.5");
  EXPECT_EQ(all.t_junctions, "1/3");
  EXPECT_EQ(all.caps_size, "2");
  EXPECT_EQ(all.orient, Orient::solid);
  EXPECT_TRUE(all.duplicates && all.caps && all.invert_shells && all.all);
  EXPECT_FALSE(Repair{}.is_asked());
  for (const char* wrong : {"", "weld", "weld=", "weld=x", "weld=-1", "orient=nested", "caps=1/0", "caps,", "all=1"})
    EXPECT_EQ(Repair::parse(wrong).error().code, ErrorCode::usage) << wrong;
  Repair bad;
  bad.weld = "much";
  const auto refused = import(box_mesh({0, 0, 0}, {1, 1, 1}), bad);
  EXPECT_EQ(refused.error().code, ErrorCode::bad_number);
  EXPECT_EQ(refused.error().where, "weld");
}

}  // namespace
}  // namespace quoin
