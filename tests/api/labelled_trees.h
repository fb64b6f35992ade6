// Labelled solids under expressions, and a second way to name every place of the result: by exact classification of the
// place in front of it and behind it, through the tree.
#pragma once

#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "api/access.h"
#include "booleans/body/locate.h"
#include "booleans/surface/triangulated.h"
#include "exact/rational.h"
#include "quoin/quoin.h"
#include "tests/api/solids.h"

namespace quoin::api_test {

using Rational = exact::Rational;
using Position = std::array<Rational, 3>;

/// A closed convex mesh of small integers, with the label of each triangle.
struct Piece {
  Mesh mesh;
  std::vector<std::uint32_t> labels;  // empty: it carries nothing
  Original original;
  Solid solid;

  bool is_labelled() const { return !labels.empty(); }
};

inline Position minus(const Position& a, const Position& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Position cross(const Position& a, const Position& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Rational dot(const Position& a, const Position& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline bool is_zero(const Position& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }

inline std::array<Position, 3> corners_of(const Mesh& mesh, std::size_t t) {
  std::array<Position, 3> r;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) r[i][k] = exact::to_rational(mesh.points[3 * mesh.triangles[3 * t + i] + k]);
  return r;
}

/// Does a closed triangle hold a place?
inline bool holds(const std::array<Position, 3>& t, const Position& p) {
  const Position n = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  if (dot(n, minus(p, t[0])) != 0) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if (dot(n, cross(minus(t[(i + 1) % 3], t[i]), minus(p, t[i]))) < 0) return false;
  return true;
}

/// A tree over pieces. Leaves name a piece.
struct Tree {
  enum class Rule { leaf, any, all, odd, difference, complement };
  Rule rule = Rule::leaf;
  std::size_t piece = 0;
  std::vector<Tree> children = {};
};

inline void leaves_of(const Tree& tree, std::vector<std::size_t>& leaves) {
  if (tree.rule == Tree::Rule::leaf) leaves.push_back(tree.piece);
  for (const Tree& child : tree.children) leaves_of(child, leaves);
}

inline std::string text_of(const Tree& tree) {
  if (tree.rule == Tree::Rule::leaf) return std::to_string(tree.piece);
  std::string text(1, "?+&^-~"[static_cast<int>(tree.rule)]);
  text += "(";
  for (const Tree& child : tree.children) text += text_of(child) + " ";
  return text + ")";
}

/// Operation by operation.
inline Solid in_a_chain(const Tree& tree, const std::vector<Piece>& pieces) {
  if (tree.rule == Tree::Rule::leaf) return pieces[tree.piece].solid;
  Solid result = in_a_chain(tree.children[0], pieces);
  if (tree.rule == Tree::Rule::complement) return ~result;
  for (std::size_t i = 1; i < tree.children.size(); ++i) {
    const Solid next = in_a_chain(tree.children[i], pieces);
    if (tree.rule == Tree::Rule::any) result = result + next;
    if (tree.rule == Tree::Rule::all) result = result & next;
    if (tree.rule == Tree::Rule::odd) result = result ^ next;
    if (tree.rule == Tree::Rule::difference) result = result - next;
  }
  return result;
}

inline Expression expression_of(const Tree& tree, const std::vector<Piece>& pieces) {
  if (tree.rule == Tree::Rule::leaf) return pieces[tree.piece].solid;
  std::vector<Expression> terms;
  for (const Tree& child : tree.children) terms.push_back(expression_of(child, pieces));
  switch (tree.rule) {
    case Tree::Rule::any:
      return Expression::unite(terms);
    case Tree::Rule::all:
      return Expression::intersect(terms);
    case Tree::Rule::odd:
      return Expression::symmetric_difference(terms);
    case Tree::Rule::difference:
      return Expression::difference(terms[0], {terms.begin() + 1, terms.end()});
    default:
      return Expression::complement(terms[0]);
  }
}

/// What a place of a surface should carry; `original` is the piece's number, or nothing for one without labels.
struct Name {
  std::optional<std::size_t> piece;
  std::uint32_t label = 0;
  bool turned = false;
  friend bool operator==(const Name&, const Name&) = default;
};

/// Who comes first: as one operation names its operands, or each operation of a chain by itself.
enum class Order { of_the_whole, of_each_operation };

/// The second way.
class PlaceNamer {
 public:
  PlaceNamer(const Tree& tree, const std::vector<Piece>& pieces, Order order)
      : tree_(tree), pieces_(pieces), order_(order), rank_(ranks(tree)) {
    std::vector<std::size_t> leaves;
    leaves_of(tree, leaves);
    used_.insert(leaves.begin(), leaves.end());
  }

  /// The name of a place on the surface; `normal` looks outwards. Nothing where the place is not general: on an edge of
  /// some piece, or on a face of one across.
  std::optional<Name> at(const Position& place, const Position& normal) {
    cover_.clear();
    for (const std::size_t p : used_)
      if (!look_at(p, place, normal)) return std::nullopt;
    const Value root = value_of(tree_);
    EXPECT_FALSE(root.front) << text_of(tree_);
    EXPECT_TRUE(root.back) << text_of(tree_);
    return root.name ? *root.name : Name{pieces_.size()};
  }

 private:
  struct Cover {
    bool front, back;
    Name name;
  };
  struct Value {
    bool front = false, back = false;
    std::optional<Name> name = {};
  };
  /// By piece, -1 those without labels.
  using Ranks = std::map<int, int>;

  Ranks ranks(const Tree& tree) const {
    Ranks rank;
    std::vector<std::size_t> leaves;
    leaves_of(tree, leaves);
    for (const std::size_t p : leaves)
      rank.emplace(pieces_[p].is_labelled() ? static_cast<int>(p) : -1, static_cast<int>(rank.size()));
    return rank;
  }

  bool look_at(std::size_t p, const Position& place, const Position& normal) {
    const Piece& piece = pieces_[p];
    const int where = booleans::locate(Access::body(piece.solid), place);
    Cover cover{where > 0, where > 0, {}};
    if (where == 0) {
      std::optional<Name> found;
      for (std::size_t t = 0; t < piece.mesh.triangles.size() / 3; ++t) {
        const auto corners = corners_of(piece.mesh, t);
        if (!holds(corners, place)) continue;
        const Position n = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
        if (!is_zero(cross(n, normal))) return false;
        const bool turned = dot(n, normal) < 0;
        Name name{std::nullopt, 0, false};
        if (piece.is_labelled()) name = {p, piece.labels[t], turned};
        if (found && !(*found == name)) return false;
        found = name;
        cover = {turned, !turned, name};
      }
    }
    cover_.emplace(p, cover);
    return true;
  }

  Value value_of(const Tree& tree) const {
    if (tree.rule == Tree::Rule::leaf) {
      const Cover& cover = cover_.at(tree.piece);
      Value value{cover.front, cover.back};
      if (cover.front != cover.back) value.name = cover.name;
      return value;
    }
    Value value;
    int front = 0, back = 0;
    const Ranks rank = order_ == Order::of_the_whole ? rank_ : ranks(tree);
    const auto rank_of = [&](const Name& name) { return rank.at(name.piece ? static_cast<int>(*name.piece) : -1); };
    for (std::size_t i = 0; i < tree.children.size(); ++i) {
      Value child = value_of(tree.children[i]);
      const bool negated = tree.rule == Tree::Rule::complement || (tree.rule == Tree::Rule::difference && i > 0);
      front += child.front != negated;
      back += child.back != negated;
      if (child.front != child.back && (!value.name || rank_of(*child.name) < rank_of(*value.name)))
        value.name = child.name;
    }
    const auto all = static_cast<int>(tree.children.size());
    const auto holds = [&](int count) {
      if (tree.rule == Tree::Rule::any || tree.rule == Tree::Rule::complement) return count > 0;
      return tree.rule == Tree::Rule::odd ? count % 2 == 1 : count == all;
    };
    value.front = holds(front);
    value.back = holds(back);
    if (value.front == value.back) value.name.reset();
    return value;
  }

  const Tree& tree_;
  const std::vector<Piece>& pieces_;
  const Order order_;
  const Ranks rank_;
  std::set<std::size_t> used_;
  std::map<std::size_t, Cover> cover_;
};

/// Compares what every triangle of a result carries with the second way, at three places of each. Returns how many
/// places were compared.
inline std::size_t expect_named(const Solid& result, const Tree& tree, const std::vector<Piece>& pieces, Order order) {
  const booleans::Body& body = Access::body(result);
  const booleans::Triangulated mesh = booleans::triangulated(body);
  PlaceNamer namer(tree, pieces, order);
  std::size_t compared = 0;
  const auto position = [&](std::uint32_t v) -> Position {
    const exact::Point p = body.point(mesh.source[v]);
    Position r;
    for (std::size_t k = 0; k < 3; ++k) r[k] = Rational(exact::to_integer(p.x[k]), exact::to_integer(p.w));
    return r;
  };

  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto c = mesh.triangle(t);
    const std::array<Position, 3> at{position(c[0]), position(c[1]), position(c[2])};
    const Position normal = cross(minus(at[1], at[0]), minus(at[2], at[0]));
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Position place;
      for (std::size_t k = 0; k < 3; ++k)
        place[k] = (at[corner][k] * 97 + at[(corner + 1) % 3][k] * 2 + at[(corner + 2) % 3][k]) / 100;
      const std::optional<Name> expected = namer.at(place, normal);
      if (!expected) continue;
      ++compared;

      Name found{std::nullopt, 0, false};
      if (body.labels) {
        const booleans::Provenance p = body.provenance(mesh.face[t]);
        const auto& origin = (*body.labels.origins)[p.origin()];
        if (origin) {
          found = {origin->id, origin->label(p.face()), p.is_turned()};
          const auto source = corners_of(pieces[origin->id].mesh, p.face());
          const Position n = cross(minus(source[1], source[0]), minus(source[2], source[0]));
          EXPECT_EQ(dot(n, minus(place, source[0])), 0) << "not on the plane of its source face";
          EXPECT_EQ(dot(n, normal) < 0, p.is_turned());
        }
      }
      EXPECT_EQ(found, *expected) << text_of(tree) << ": piece " << int(found.piece.value_or(99)) << " label "
                                  << found.label << " turned " << found.turned << ", not piece "
                                  << int(expected->piece.value_or(99)) << " label " << expected->label << " turned "
                                  << expected->turned;
      if (::testing::Test::HasFailure()) return compared;
    }
  }
  return compared;
}

/// Random pieces on few planes: boxes and tetrahedra.
inline Piece random_piece(std::mt19937_64& random, std::size_t number) {
  const auto below = [&](unsigned n) { return static_cast<double>(random() % n); };
  for (;;) {
    Mesh mesh;
    if (random() % 3 != 0) {
      Corner low, high;
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = below(4);
        high[k] = low[k] + 1 + below(3);
      }
      mesh = box_mesh(low, high);
    } else {
      for (int i = 0; i < 12; ++i) mesh.points.push_back(below(6));
      mesh.triangles = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
      const auto t = corners_of(mesh, 0);
      const Position last{exact::to_rational(mesh.points[9]), exact::to_rational(mesh.points[10]),
                          exact::to_rational(mesh.points[11])};
      const Rational volume = dot(cross(minus(t[1], t[0]), minus(t[2], t[0])), minus(last, t[0]));
      if (volume == 0) continue;
      if (volume > 0)
        for (std::size_t i = 0; i < 12; i += 3) std::swap(mesh.triangles[i], mesh.triangles[i + 1]);
    }

    Piece piece;
    piece.mesh = mesh;
    piece.original = {static_cast<std::uint32_t>(number), "piece"};
    ImportOptions options;
    options.grid = Grid();
    if (random() % 5 != 0) {
      const unsigned kinds = 1 + random() % 3;
      for (std::size_t t = 0; t < mesh.triangles.size() / 3; ++t)
        piece.labels.push_back(static_cast<std::uint32_t>(random() % kinds));
      options.labels = piece.labels;
      options.id = piece.original.id;
      options.name = piece.original.name;
    }
    piece.solid = Solid::from_triangles(mesh.points, mesh.triangles, options).value();
    return piece;
  }
}

inline Tree random_tree(std::mt19937_64& random, std::size_t pieces, int depth) {
  if (depth == 0 || random() % 5 == 0) return {Tree::Rule::leaf, random() % pieces};
  Tree tree;
  const std::array rules{Tree::Rule::any,        Tree::Rule::any,        Tree::Rule::all,       Tree::Rule::odd,
                         Tree::Rule::difference, Tree::Rule::difference, Tree::Rule::complement};
  tree.rule = rules[random() % rules.size()];
  const std::size_t count = tree.rule == Tree::Rule::complement ? 1 : 2 + random() % 2;
  for (std::size_t i = 0; i < count; ++i) tree.children.push_back(random_tree(random, pieces, depth - 1));
  return tree;
}

}  // namespace quoin::api_test
