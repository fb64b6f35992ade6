#include <limits>

#include "tests/api/labelled_trees.h"

namespace quoin::api_test {
namespace {

/// a x + b y + c z + d.
using Affine = std::array<int, 4>;

Rational value(const Affine& f, const Position& p) { return f[0] * p[0] + f[1] * p[1] + f[2] * p[2] + f[3]; }

/// A piece whose channels are affine functions, another pair of them for each label.
struct Textured {
  Piece piece;
  std::map<std::uint32_t, std::array<Affine, 2>> functions;
};

Affine random_affine(std::mt19937_64& random) {
  Affine f{};
  for (int& x : f) x = static_cast<int>(random() % 9) - 4;
  return f;
}

ImportOptions options_of(const Piece& piece, const std::vector<double>& channels) {
  ImportOptions options;
  options.grid = Grid();
  options.labels = piece.labels;
  options.id = piece.original.id;
  options.name = piece.original.name;
  options.channels = channels;
  return options;
}

Textured random_textured(std::mt19937_64& random, std::size_t number) {
  Textured t{random_piece(random, number), {}};
  if (t.piece.labels.empty()) t.piece.labels.assign(t.piece.mesh.triangles.size() / 3, 0);
  std::vector<double> channels;
  for (std::size_t i = 0; i < t.piece.labels.size(); ++i) {
    const auto [at, fresh] = t.functions.try_emplace(t.piece.labels[i]);
    if (fresh) at->second = {random_affine(random), random_affine(random)};
    for (const Position& p : corners_of(t.piece.mesh, i))
      for (const Affine& f : at->second) channels.push_back(exact::to_double(value(f, p)));
  }
  t.piece.solid =
      Solid::from_triangles(t.piece.mesh.points, t.piece.mesh.triangles, options_of(t.piece, channels)).value();
  return t;
}

/// Every corner has the values of the functions of the face it comes from, in the exact point that it is.
std::size_t expect_channels(const Solid& solid, const std::vector<Textured>& textured) {
  const LabelledMesh mesh =
      to_labelled_triangles(solid, {.topology = Topology::indexed, .validity = Validity::fast}).value();
  const booleans::Body& body = Access::operand(solid);
  const booleans::Triangulated exact_mesh = booleans::triangulated(body);
  EXPECT_EQ(exact_mesh.corners, mesh.triangles);
  if (mesh.labels.empty()) return 0;
  EXPECT_EQ(mesh.channel_count, 2u);
  EXPECT_EQ(mesh.channels.size(), 2 * mesh.triangles.size());
  if (::testing::Test::HasFailure()) return 0;

  for (std::size_t corner = 0; corner < mesh.triangles.size(); ++corner) {
    const exact::Point p = body.point(exact_mesh.source[mesh.triangles[corner]]);
    const Position at{exact::coordinate(p, 0), exact::coordinate(p, 1), exact::coordinate(p, 2)};
    const FaceLabel& label = mesh.labels[corner / 3];
    const auto& functions = textured[mesh.originals[label.original].id].functions.at(label.label);
    for (std::size_t c = 0; c < 2; ++c)
      EXPECT_EQ(mesh.channels[2 * corner + c], exact::to_double(value(functions[c], at)));
  }
  return mesh.triangles.size();
}

TEST(Channels, AreTheFunctionsOfTheirFacesInExactPoints) {
  std::mt19937_64 random = random_engine();
  std::size_t compared = 0;
  for (int round = 0; round < 150 && !HasFailure(); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    std::vector<Textured> textured;
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < 4; ++i) {
      textured.push_back(random_textured(random, i));
      pieces.push_back(textured.back().piece);
    }
    const Tree tree = random_tree(random, pieces.size(), 1 + static_cast<int>(random() % 3));
    Solid solid = in_a_chain(tree, pieces);
    if (!solid.is_bounded()) solid = ~solid;
    compared += expect_channels(solid, textured);
  }
  EXPECT_GT(compared, 5000u);
}

/// A box whose channel is one function on each side, or of which one triangle is shifted.
Solid textured_box(double shift) {
  const Mesh mesh = box_mesh({0, 0, 0}, {4, 4, 4});
  std::vector<double> channels;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const double* p = &mesh.points[3 * mesh.triangles[i]];
    channels.push_back(p[0] + 8 * p[1] + 64 * p[2] + (i < 3 ? shift : 0));
  }
  ImportOptions options;
  options.channels = channels;
  options.grid = Grid();
  return Solid::from_triangles(mesh.points, mesh.triangles, options).value();
}

TEST(Channels, ADiagonalInsideOneFunctionVanishes) {
  const Solid knife = box({1, 1, -1}, {2, 3, 5});
  const auto bottom = [&](const Solid& solid) {  // triangles on z = 0
    const LabelledMesh mesh = to_labelled_triangles(solid - knife).value();
    return std::count_if(mesh.labels.begin(), mesh.labels.end(),
                         [](const FaceLabel& l) { return l.original == 0 && l.source < 2; });
  };
  EXPECT_EQ(bottom(textured_box(0)), 8);
  EXPECT_EQ(bottom(textured_box(0x1p-16)), 8);  // within the tolerance of 2^-20 of the range, 292
  EXPECT_GT(bottom(textured_box(1)), 8);
  EXPECT_TRUE(textured_box(1) == textured_box(0));
}

TEST(Channels, GoWithMotions) {
  const Solid solid = textured_box(0), turned = moved(solid, Motion::rotation({"0", "0", "1"}, "90").value()).value();
  const auto values = [](const Solid& s) {
    const LabelledMesh mesh = to_labelled_triangles(s).value();
    return std::set<double>(mesh.channels.begin(), mesh.channels.end());
  };
  EXPECT_EQ(values(turned), values(solid));
  const LabelledMesh mesh = to_labelled_triangles(turned - box({-1, -1, -1}, {9, 9, 2})).value();
  std::size_t own = 0;
  for (std::size_t corner = 0; corner < mesh.triangles.size(); ++corner) {
    if (mesh.labels[corner / 3].original == FaceLabel::unlabelled) continue;
    const double* p = &mesh.points[3 * mesh.triangles[corner]];
    EXPECT_EQ(mesh.channels[corner], p[1] - 8 * p[0] + 64 * p[2]);  // (x, y) has come from (y, -x)
    ++own;
  }
  EXPECT_GT(own, 0u);
}

TEST(Channels, VerticesAreSplitWhereTheyDiffer) {
  std::mt19937_64 random = random_engine();
  for (int round = 0; round < 30; ++round) {
    const Solid solid = random_textured(random, 0).piece.solid + random_textured(random, 1).piece.solid;
    const LabelledMesh mesh = to_labelled_triangles(solid).value();
    const ChannelMesh split = split_by_channels(mesh);
    ASSERT_EQ(split.triangles.size(), mesh.triangles.size());
    std::set<std::pair<std::uint32_t, std::vector<double>>> vertices;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const std::uint32_t v = split.triangles[i];
      ASSERT_EQ(split.merged[v], mesh.triangles[i]);
      for (std::size_t k = 0; k < 3; ++k) ASSERT_EQ(split.points[3 * v + k], mesh.points[3 * mesh.triangles[i] + k]);
      std::vector<double> values;
      for (std::size_t c = 0; c < 2; ++c) {
        ASSERT_EQ(split.channels[2 * v + c], mesh.channels[2 * i + c]);
        values.push_back(mesh.channels[2 * i + c]);
      }
      vertices.insert({mesh.triangles[i], values});
    }
    EXPECT_EQ(vertices.size(), split.merged.size());
  }
}

TEST(Channels, OfPolygonsAndFloats) {
  const std::vector<float> points{0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 0, 0, 2, 2, 0, 2, 2, 2, 2, 0, 2, 2};
  const std::vector<std::int32_t> starts{0, 4, 8, 12, 16, 20, 24},
      corners{0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
  std::vector<float> channels;
  for (const std::int32_t v : corners) channels.push_back(points[3 * static_cast<std::size_t>(v)] + 0.5F);
  ImportOptions options;
  options.grid = Grid();
  options.channels = channels;
  const Solid cube = Solid::from_polygons(points, starts, corners, options).value();
  const LabelledMesh mesh = to_labelled_triangles(cube - box({1, 1, 1}, {3, 3, 3})).value();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (mesh.labels[i / 3].original == 0) EXPECT_EQ(mesh.channels[i], mesh.points[3 * mesh.triangles[i]] + 0.5);

  channels[2] += 1;
  const auto bent = Solid::from_polygons(points, starts, corners, options);
  ASSERT_FALSE(bent.has_value());
  EXPECT_EQ(bent.error().code, ErrorCode::bad_number);
  EXPECT_EQ(bent.error().where, "face 0");
  channels.pop_back();
  options.channels = channels;
  EXPECT_EQ(Solid::from_polygons(points, starts, corners, options).error().code, ErrorCode::bad_index);
  channels.push_back(std::numeric_limits<float>::infinity());
  options.channels = channels;
  EXPECT_EQ(Solid::from_polygons(points, starts, corners, options).error().where, "corner 23");
}

}  // namespace
}  // namespace quoin::api_test
