#include "examples/models.h"
#include "tests/api/doors/damaged_meshes.h"
#include "tests/api/labelled_trees.h"
#include "tests/grid/with_thresholds.h"

namespace quoin::api_test {
namespace {

using namespace damaged;  // NOLINT: meshes alone
using grid::Thresholds;
using grid::testing::WithThresholds;

Solid labelled_box(const Corner& low, const Corner& high, const Original& original,
                   const std::vector<std::uint32_t>& labels = std::vector<std::uint32_t>(12), const Grid& grid = {}) {
  const Mesh mesh = box_mesh(low, high);
  ImportOptions options;
  options.grid = grid;
  options.labels = labels;
  options.id = original.id;
  options.name = original.name;
  return Solid::from_triangles(mesh.points, mesh.triangles, options).value();
}

/// A label for each side of a box: z, z, y, y, x, x, low first.
const std::vector<std::uint32_t> six_labels{0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5};

/// Twice the area of triangles, by what they carry; exact for axis-parallel ones of small integers.
std::map<std::string, double> areas(const Solid& solid) {
  const LabelledMesh mesh = to_labelled_triangles(solid).value();
  std::map<std::string, double> sum;
  for (std::size_t t = 0; t < mesh.labels.size(); ++t) {
    const FaceLabel& l = mesh.labels[t];
    const std::string name =
        l.original == FaceLabel::unlabelled ? "-" : mesh.originals[l.original].name + "." + std::to_string(l.label);
    const auto c = corners_of(mesh, t);
    const Position n = cross(minus(c[1], c[0]), minus(c[2], c[0]));
    for (const Rational& x : n) sum[name] += exact::to_double(x < 0 ? Rational(-x) : x);
  }
  return sum;
}

/// Where faces of three operands of a symmetric difference coincide, who names what is left depends on who meets first:
/// such differences are left out where there is a choice.
bool has_choice(const Tree& tree, bool is_chain) {
  if (tree.rule == Tree::Rule::odd) {
    if (is_chain && tree.children.size() > 2) return true;
    std::set<std::size_t> leaves;
    for (const Tree& child : tree.children) {
      if (child.rule == Tree::Rule::odd || child.rule == Tree::Rule::complement) return true;
      if (child.rule == Tree::Rule::leaf && !leaves.insert(child.piece).second) return true;
    }
  }
  return std::any_of(tree.children.begin(), tree.children.end(),
                     [&](const Tree& child) { return has_choice(child, is_chain); });
}

std::vector<Piece> without_labels(std::vector<Piece> pieces) {
  for (Piece& piece : pieces) piece.solid = unlabelled(piece.solid);
  return pieces;
}

/// Every place carries what the rule says, of chains and of whole expressions; the point set is that without labels.
void try_random_trees(std::mt19937_64& random, int rounds) {
  std::size_t compared = 0;
  for (int round = 0; round < rounds && !::testing::Test::HasFailure(); ++round) {
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < 5; ++i) pieces.push_back(random_piece(random, i));
    const Tree tree = random_tree(random, pieces.size(), 1 + static_cast<int>(random() % 3));
    SCOPED_TRACE("round " + std::to_string(round));

    const Solid chain = in_a_chain(tree, pieces), whole = evaluate(expression_of(tree, pieces)).value();
    if (!has_choice(tree, true)) compared += expect_named(chain, tree, pieces, Order::of_each_operation);
    if (!has_choice(tree, false)) compared += expect_named(whole, tree, pieces, Order::of_the_whole);
    EXPECT_TRUE(same_faces(whole, evaluate(expression_of(tree, pieces), {.threads = 1}).value()));

    const Solid plain = in_a_chain(tree, without_labels(pieces));
    EXPECT_FALSE(has_labels(plain));
    EXPECT_EQ(chain.to_quoin(), plain.to_quoin());
    EXPECT_EQ(whole.to_quoin(), plain.to_quoin());
    EXPECT_EQ(chain.counts(), plain.counts());
    EXPECT_TRUE(same_faces(~~chain, chain));
  }
  EXPECT_GT(compared, static_cast<std::size_t>(10 * rounds));
}

TEST(Labels, EveryPlaceOfRandomTreesCarriesWhatTheRuleSays) {
  std::mt19937_64 random = random_engine();
  try_random_trees(random, 250);
}

TEST(Labels, OfLargeInputsAndOfPatchesFollowTheSameRule) {
  std::mt19937_64 random = random_engine();
  for (const Thresholds& thresholds : {Thresholds::smallest(), Thresholds::largest(), Thresholds::patched()}) {
    const WithThresholds set(thresholds);
    try_random_trees(random, 80);
  }
}

// Terms that stand in several places are evaluated by themselves, where they are large: they are named all the same.
TEST(Labels, TermsThatAreSharedFollowTheSameRule) {
  std::mt19937_64 random = random_engine();
  const WithThresholds set(Thresholds::smallest());
  for (int round = 0; round < 60 && !HasFailure(); ++round) {
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < 4; ++i) pieces.push_back(random_piece(random, i));
    const Tree shared{Tree::Rule::any, 0, {{Tree::Rule::leaf, 3}, {Tree::Rule::leaf, 1}, {Tree::Rule::leaf, 2}}};
    const Tree tree{Tree::Rule::any,
                    0,
                    {{Tree::Rule::all, 0, {{Tree::Rule::leaf, 0}, {Tree::Rule::leaf, 1}}},
                     {Tree::Rule::all, 0, {shared, {Tree::Rule::leaf, 2}}},
                     {Tree::Rule::difference, 0, {shared, {Tree::Rule::leaf, 0}}}}};
    const Expression term = expression_of(shared, pieces), p0 = pieces[0].solid, p1 = pieces[1].solid,
                     p2 = pieces[2].solid;
    expect_named(evaluate((p0 & p1) + (term & p2) + (term - p0)).value(), tree, pieces, Order::of_the_whole);
  }
}

// The diagonals of a labelled bar end on edges of a block whose face they pierce: nothing else of the bar ends there.
TEST(Labels, BordersEndOnAnEdgeOfAFaceWithManyEdges) {
  const WithThresholds set(grid::testing::with(&Thresholds::large_face, 0u));
  std::vector<Piece> pieces(2);
  pieces[0].mesh = box_mesh({1, 0, 1}, {4, 3, 3});
  pieces[0].labels.assign(12, 0);
  pieces[1].mesh = box_mesh({2, 1, 1}, {5, 2, 2});
  pieces[1].labels = {1, 2, 1, 0, 1, 1, 0, 2, 1, 1, 1, 1};
  for (std::uint32_t i = 0; i < 2; ++i) {
    const Mesh& mesh = pieces[i].mesh;
    pieces[i].solid = Solid::from_triangles(mesh.points, mesh.triangles,
                                            {.grid = Grid(), .labels = pieces[i].labels, .id = i, .name = "piece"})
                          .value();
  }
  const Tree tree{Tree::Rule::any, 0, {{Tree::Rule::leaf, 0}, {Tree::Rule::leaf, 1}}};
  EXPECT_GT(expect_named(in_a_chain(tree, pieces), tree, pieces, Order::of_the_whole), 0u);
}

// A symmetric difference of many is not taken in groups, of which the first would lose its faces: the first one names.
TEST(Labels, OfASymmetricDifferenceTheFirstOneNames) {
  std::vector<Solid> boxes;
  for (std::uint32_t id = 0; id < 9; ++id) boxes.push_back(labelled_box({0, 0, 0}, {1, 1, 1}, {id, "box"}));
  for (const Thresholds& thresholds : {Thresholds{}, Thresholds::smallest()}) {
    const WithThresholds set(thresholds);
    const LabelledMesh mesh = to_labelled_triangles(symmetric_difference(boxes).value()).value();
    EXPECT_EQ(mesh.labels.size(), 12u);
    EXPECT_EQ(mesh.originals, (std::vector<Original>{{0, "box"}}));
  }
}

TEST(Labels, ACubeOfSixLabelsMinusABallKeepsSix) {
  const Mesh ball = examples::icosphere({2, 2, 4}, 1.5, 2);
  ImportOptions options;
  options.name = "ball";
  options.grid = grid_of("1/1024");
  const Solid solid = labelled_box({0, 0, 0}, {4, 4, 4}, {1, "cube"}, six_labels, *options.grid) -
                      Solid::from_triangles(ball.points, ball.triangles, options).value();

  const LabelledMesh mesh = to_labelled_triangles(solid).value();
  ASSERT_EQ(mesh.labels.size(), mesh.triangles.size() / 3);
  ASSERT_EQ(mesh.originals, (std::vector<Original>{{1, "cube"}, {0, "ball"}}));
  std::set<std::uint32_t> cube, turned;
  for (const FaceLabel& l : mesh.labels) {
    EXPECT_EQ(l.turned, l.original == 1);
    if (l.original == 0) cube.insert(l.label);
  }
  EXPECT_EQ(cube.size(), 6u);
}

// Boxes whose faces never coincide: those of even coordinates and those of odd ones.
TEST(Labels, AreasAddUpLabelByLabel) {
  std::mt19937_64 random = random_engine();
  const auto box = [&](int shift, const std::string& name) {
    Corner low, high;
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = static_cast<double>(2 * (random() % 4)) + shift;
      high[k] = low[k] + static_cast<double>(2 + 2 * (random() % 4));
    }
    return labelled_box(low, high, {0, name}, six_labels);
  };
  for (int round = 0; round < 100; ++round) {
    const Solid a = box(0, "a"), b = box(1, "b");
    std::map<std::string, double> whole = areas(a), parts = areas(a + b), split = areas(a - b);
    for (const auto& [name, area] : areas(b)) whole[name] += area;
    for (const auto& [name, area] : areas(a & b)) parts[name] += area;
    EXPECT_EQ(parts, whole);
    // What is cut off a, and what is left of it, have its faces, and both sides of the cut.
    for (const auto& [name, area] : areas(a & b)) split[name] += area;
    std::map<std::string, double> cut = areas(a);
    for (const auto& [name, area] : areas(a & b))
      if (name[0] == 'b') cut[name] += 2 * area;
    EXPECT_EQ(split, cut);
  }
}

TEST(Labels, NeighboursOnOnePlaneAreOneFaceWhereLabelsAgree) {
  const Solid both = labelled_box({0, 0, 0}, {1, 1, 1}, {7}) + labelled_box({1, 0, 0}, {2, 1, 1}, {7});
  EXPECT_EQ(to_labelled_triangles(both).value().labels.size(), 12u);  // a box
  const Solid two = labelled_box({0, 0, 0}, {1, 1, 1}, {7}) + labelled_box({1, 0, 0}, {2, 1, 1}, {8});
  EXPECT_EQ(to_labelled_triangles(two).value().labels.size(), 20u);  // four sides of two faces each
  EXPECT_TRUE(both == two);
  EXPECT_FALSE(same_faces(both, two));
  EXPECT_FALSE(same_faces(both, unlabelled(both)));
  EXPECT_EQ(two.counts().faces, 6u);
}

// A border bends in the plane, at a vertex that no other edge needs.
TEST(Labels, BordersBend) {
  const Solid plate = labelled_box({0, 0, 0}, {8, 8, 1}, {1, "plate"});
  const Solid inlay =
      labelled_box({2, 2, 0}, {4, 6, 1}, {2, "inlay"}) + labelled_box({4, 2, 0}, {6, 4, 1}, {2, "inlay"});
  const Solid part = inlay + (plate - inlay);
  EXPECT_TRUE(part == plate);
  EXPECT_EQ(areas(part)["inlay.0"], 2 * 2 * 12.0);
  EXPECT_EQ(areas(part)["plate.0"], areas(plate)["plate.0"] - 2 * 2 * 12.0);
  EXPECT_TRUE(same_faces(plate + part, plate));  // the first one names what both have
  EXPECT_TRUE(same_faces(part + plate, part));
}

TEST(Labels, APartThatIsSplitAndUnitedAgainHasItsFaces) {
  std::mt19937_64 random = random_engine();
  for (int round = 0; round < 40; ++round) {
    const Solid solid = random_piece(random, 0).solid + random_piece(random, 1).solid;
    HalfSpace h;
    for (std::size_t k = 0; k < 4; ++k) h.plane[k] = std::to_string(static_cast<int>(random() % 9) - 4);
    if (h.plane[0] == "0" && h.plane[1] == "0" && h.plane[2] == "0") continue;
    const auto [above, below] = split(solid, h).value();
    EXPECT_TRUE(same_faces(above + below, solid));
    EXPECT_TRUE(same_faces(below + above, solid));
  }
}

// Long chains: names of the first solids, no list that grows.
TEST(Labels, AChainKeepsTheNamesOfItsFirstSolids) {
  const Grid grid = grid_of("1/64");
  const auto block = [&](const Corner& low, const Corner& high, const Original& original,
                         const std::vector<std::uint32_t>& labels) {
    return labelled_box(low, high, original, labels, grid);
  };
  const Solid start = block({0, 0, 0}, {16, 16, 2}, {1, "plate"}, six_labels);
  Solid part = start;
  for (int i = 0; i < 300; ++i) {
    const double x = i % 15 + 0.25, y = i / 15 % 15 + 0.25;
    const Solid peg = block({x, y, 0}, {x + .5, y + .5, 2}, {2, "peg"}, std::vector<std::uint32_t>(12, 9));
    part = part - peg;
    part = i % 3 == 0 ? start + part : part + peg;
  }
  const booleans::Body& body = Access::body(part);
  EXPECT_EQ(body.labels.origins->size(), 2u);
  EXPECT_TRUE(part == start);
  EXPECT_LT(body.face_count(), 16u * 225u);
  EXPECT_LE(body.labels.borders.size(), 8u * 225u * 2);
  std::set<std::string> names;
  for (const auto& [name, area] : areas(part)) names.insert(name);
  EXPECT_EQ(names, (std::set<std::string>{"plate.0", "plate.1", "plate.2", "plate.3", "plate.4", "plate.5", "peg.9"}));
}

TEST(Labels, OtherGridsKeepThem) {
  std::mt19937_64 random = random_engine();
  for (int round = 0; round < 40; ++round) {
    const Solid solid = random_piece(random, 0).solid - random_piece(random, 1).solid;
    for (const char* step : {"1/2", "1/3", "3/7"}) {
      const auto there = solid.on_grid(grid_of(step));
      if (!there) continue;  // a plane of long numbers, or a vertex between the steps
      EXPECT_TRUE(same_faces(there.value(), solid)) << step;
      EXPECT_TRUE(same_faces(there.value().on_grid(solid.grid()).value(), solid)) << step;
      EXPECT_EQ(has_labels(there.value()), has_labels(solid));
    }
  }
}

// Turned by a right angle and back, and mirrored twice: exactly as before. Turned by any angle: a box of one label a
// side keeps a side for each label.
TEST(Labels, MotionsKeepThem) {
  std::mt19937_64 random = random_engine();
  const Motion right = Motion::rotation({"0", "0", "1"}, "90").value(),
               back = Motion::rotation({"0", "0", "1"}, "-90").value();
  for (int round = 0; round < 40; ++round) {
    const Solid solid = random_piece(random, 0).solid - random_piece(random, 1).solid;
    const Solid turned = moved(solid, right).value();
    EXPECT_EQ(has_labels(turned), has_labels(solid));
    EXPECT_TRUE(same_faces(moved(turned, back).value(), solid));
    EXPECT_TRUE(turned == moved(unlabelled(solid), right).value());
  }

  const Solid cube = labelled_box({0, 0, 0}, {4, 4, 4}, {1, "cube"}, six_labels, grid_of("1/1024"));
  const Solid turned = moved(cube, Motion::rotation({"1", "2", "3"}, "17").value()).value();
  EXPECT_TRUE(turned == moved(unlabelled(cube), Motion::rotation({"1", "2", "3"}, "17").value()).value());
  const LabelledMesh mesh = to_labelled_triangles(turned).value();
  ASSERT_EQ(mesh.labels.size(), 12u);
  std::map<std::uint32_t, std::size_t> sides;
  for (const FaceLabel& l : mesh.labels) {
    EXPECT_FALSE(l.turned);
    ++sides[l.label];
  }
  EXPECT_EQ(sides, (std::map<std::uint32_t, std::size_t>{{0, 2}, {1, 2}, {2, 2}, {3, 2}, {4, 2}, {5, 2}}));
}

TEST(Labels, ImportKeepsThemThroughSealingAndCures) {
  std::mt19937_64 random = random_engine();
  for (int round = 0; round < 20; ++round) {
    Mesh mesh = bumpy_block(4, random);
    const std::size_t triangles = mesh.triangles.size() / 3;
    const auto labels_by_place = [&](const Mesh& m) {  // of a triangle, by its highest corner
      std::vector<std::uint32_t> labels;
      for (std::size_t t = 0; t < m.triangles.size() / 3; ++t) {
        const auto c = corners_of(m, t);
        labels.push_back(static_cast<std::uint32_t>(exact::to_double(std::max({c[0][2], c[1][2], c[2][2]}))) % 3);
      }
      return labels;
    };
    const std::vector<std::uint32_t> kept = labels_by_place(mesh);
    ImportOptions options;
    options.grid = grid_of("1/1024");
    options.labels = kept;
    const Solid whole = Solid::from_triangles(mesh.points, mesh.triangles, options).value();

    const auto chosen = some_of(size_of(mesh), 1 + random() % 20, 7, random);
    for (const std::size_t t : chosen) put_on_edge(mesh, t);
    std::vector<std::uint32_t> labels = kept;
    labels.resize(mesh.triangles.size() / 3);
    for (std::size_t t = triangles, i = 0; t < labels.size() && i < chosen.size(); ++t, ++i)
      labels[t] = kept[chosen[i]];
    options.labels = labels;
    const auto sealed = Solid::from_triangles(mesh.points, mesh.triangles, options);
    ASSERT_TRUE(sealed.has_value()) << sealed.error().message;
    EXPECT_TRUE(same_faces(sealed.value(), whole));
  }
}

TEST(Labels, WrongNumbersOfLabelsAreRefused) {
  const Mesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  ImportOptions options;
  const std::vector<std::uint32_t> labels(11);
  options.labels = labels;
  const auto refused = Solid::from_triangles(mesh.points, mesh.triangles, options);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::bad_index);
  EXPECT_EQ(refused.error().message, "there are 11 labels for 12 faces");
  EXPECT_FALSE(labelled(box({0, 0, 0}, {1, 1, 1}), {}, labels).has_value());
}

TEST(Labels, FacesOfACanonicalFormCanBeNamed) {
  const Solid solid = box({0, 0, 0}, {2, 2, 2}) - box({1, 1, 1}, {3, 3, 3});
  const std::size_t faces = solid.counts().faces;
  std::vector<std::uint32_t> labels;
  for (std::uint32_t f = 0; f < faces; ++f) labels.push_back(100 + f);
  const Solid named = labelled(solid, {5, "corner"}, labels).value();
  EXPECT_EQ(named.to_quoin(), solid.to_quoin());
  const LabelledMesh mesh = to_labelled_triangles(named).value();
  std::set<std::uint32_t> found;
  for (const FaceLabel& l : mesh.labels) {
    EXPECT_EQ(l.label, 100 + l.source);
    found.insert(l.label);
  }
  EXPECT_EQ(found.size(), faces);
}

// Components keep what their faces carry, whichever boundary is asked; they and their order are those of the point set.
TEST(Labels, ComponentsKeepThem) {
  std::mt19937_64 random = random_engine();
  for (int round = 0; round < 40; ++round) {
    Solid solid;
    for (std::size_t i = 0; i < 3; ++i) solid = solid ^ random_piece(random, i).solid;
    const std::vector<Solid> parts = solid.boundary().components(), same = solid.boundary(Faces::by_label).components(),
                             plain = unlabelled(solid).boundary().components();
    ASSERT_EQ(parts.size(), plain.size());
    ASSERT_EQ(parts.size(), same.size());
    Solid all;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      EXPECT_TRUE(parts[i] == plain[i]);
      all = all + parts[i];
      EXPECT_EQ(std::count_if(same.begin(), same.end(), [&](const Solid& s) { return same_faces(s, parts[i]); }), 1);
    }
    EXPECT_TRUE(same_faces(all, solid));
  }
}

TEST(Labels, AreOnTheFacesOfABoundary) {
  const Solid two = labelled_box({0, 0, 0}, {1, 1, 1}, {7, "a"}) + labelled_box({1, 0, 0}, {2, 1, 1}, {8, "b"});
  const Boundary plain = two.boundary(), labelled = two.boundary(Faces::by_label);
  EXPECT_EQ(plain.face_count(), 6u);
  EXPECT_EQ(plain.label(0).original, FaceLabel::unlabelled);
  ASSERT_EQ(labelled.face_count(), 10u);
  EXPECT_EQ(labelled.vertex_count(), 12u);
  EXPECT_EQ(labelled.edge_count(), 20u);
  EXPECT_EQ(labelled.shell_count(), 1u);
  EXPECT_EQ(labelled.originals(), (std::vector<Original>{{7, "a"}, {8, "b"}}));
  std::array<int, 2> faces{};
  for (std::uint32_t f = 0; f < labelled.face_count(); ++f) {
    const std::uint32_t original = labelled.label(f).original;
    ASSERT_LT(original, 2u);
    ++faces[original];
    for (const std::uint32_t v : labelled.face(f).loop(0))
      EXPECT_TRUE(original == 0 ? labelled.point(v)[0] <= 1 : labelled.point(v)[0] >= 1);
  }
  EXPECT_EQ(faces, (std::array{5, 5}));
}

// Mended exports: a triangle carries what the exact face at its place does.
TEST(Labels, MendedExportsCarryThem) {
  const Mesh noisy = examples::bumpy_sphere({50000, 0, 0}, 1, 3000, 5),
             other = examples::bumpy_sphere({50000.3, .2, .1}, 1, 3000, 6);
  ImportOptions options;
  std::vector<std::uint32_t> halves;
  for (std::size_t t = 0; t < noisy.triangles.size() / 3; ++t)
    halves.push_back(noisy.points[3 * noisy.triangles[3 * t]] < 50000 ? 1 : 2);
  options.labels = halves;
  options.name = "a";
  const Solid a = Solid::from_triangles(noisy.points, noisy.triangles, options).value();
  options.labels = {};
  options.name = "b";
  const Solid b = Solid::from_triangles(other.points, other.triangles, options).value();

  ExportReport report;
  ExportOptions as_float;
  as_float.float32 = true;
  const LabelledMesh mesh = to_labelled_triangles(a - b, as_float, &report).value();
  EXPECT_TRUE(report.valid);
  EXPECT_GT(report.mending_rounds, 0u);
  std::map<std::uint32_t, std::size_t> triangles;
  for (std::size_t t = 0; t < mesh.labels.size(); ++t) {
    const FaceLabel& l = mesh.labels[t];
    ++triangles[l.label];
    ASSERT_LT(l.original, 2u);
    if (l.label == 1) EXPECT_LT(mesh.points[3 * mesh.triangles[3 * t]], 50000.2);
    if (l.label == 2) EXPECT_GT(mesh.points[3 * mesh.triangles[3 * t]], 49999.8);
    EXPECT_EQ(l.turned, l.original == 1);
  }
  EXPECT_EQ(triangles.size(), 3u);
}

}  // namespace
}  // namespace quoin::api_test
