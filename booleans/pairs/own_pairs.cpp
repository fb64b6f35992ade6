#include "booleans/pairs/own_pairs.h"

#include <functional>

#include "booleans/body/simple.h"
#include "booleans/pairs/fan_proof.h"
#include "booleans/pairs/pair_search.h"
#include "booleans/pairs/proper_pairs.h"
#include "booleans/pairs/triangle_pair.h"

namespace quoin::booleans {
namespace {

/// Triangles that share a vertex whose star is embedded meet as they should: nearly all pairs are of this kind.
class NeighbourMask {
 public:
  NeighbourMask(const Body& mesh, const Array<Star>& star_of, const Array<std::uint32_t>& order)
      : corners_((order.size() + BoxBlock::width - 1) / BoxBlock::width) {
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = order[i] < mesh.triangles.size() ? mesh.triangles[order[i]][k] : none;
        // Other vertices, and polygons, get a name that no other face has.
        corners_[i / BoxBlock::width][k][i % BoxBlock::width] =
            v != none && star_of[v] == Star::embedded ? v : none - static_cast<std::uint32_t>(i);
      }
  }
  /// The lanes of block b that are neighbours of the i-th triangle.
  unsigned operator()(std::uint32_t i, std::uint32_t b) const {
    const Block &own = corners_[i / BoxBlock::width], &others = corners_[b];
    const std::size_t lane = i % BoxBlock::width;
    return lanes_with(std::array{others[0].data(), others[1].data(), others[2].data()},
                      std::array{own[0][lane], own[1][lane], own[2][lane]});
  }

 private:
  using Block = std::array<std::array<std::uint32_t, BoxBlock::width>, 3>;

  Array<Block> corners_;
};

}  // namespace

namespace {

/// Faces of a body, and a tree over them.
struct OwnFaces {
  OwnFaces(const Body& body, const Array<BoxTree::Item>& items) : tree(items) {
    faces.reserve(items.size());
    for (const std::uint32_t f : tree.ids()) faces.push_back({&body, f});
  }
  BoxTree tree;
  Array<SearchedFace> faces;
};

/// Is the face marked? An empty list marks none.
bool has(const Array<std::uint8_t>& marks, std::uint32_t f) { return f < marks.size() && marks[f]; }

}  // namespace

FacePairs improper_pairs(const Body& mesh, const Array<Star>& star_of) {
  const Array<std::uint8_t> proved = proved_in_fans(mesh, star_of);
  Array<BoxTree::Item> items;
  items.reserve(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (!has(proved, t)) items.push_back({face_box(mesh, t), t, t});

  const OwnFaces own(mesh, items);
  const NeighbourMask neighbours(mesh, star_of, own.tree.ids());
  const auto wanted = [&](std::uint32_t i, std::uint32_t j) {
    return meet_out_of_place(mesh, own.faces[i].face, own.faces[j].face);
  };
  return PairSearch(own.faces, own.tree, InParts::passed, std::cref(neighbours), wanted).run(BoxTree::Pairs::all);
}

FacePairs doubtful_pairs(const Body& body) {
  const ProperPairs prover(body);
  FacePairs found;
  for (std::uint32_t f = 0; f < body.face_count(); ++f)
    if (body.corner_count(f) > 3 && !proved_simple(body, f)) found.push_back({FaceId(f), FaceId(f)});
  // Triangles that are proved to meet all others are a group: what they do with polygons is left to see.
  const Array<Star> star_of = stars(body);
  const Array<std::uint8_t> proved = proved_in_fans(body, star_of);
  Array<BoxTree::Item> items(body.face_count());
  for (std::uint32_t f = 0; f < items.size(); ++f)
    items[f] = {face_box(body, f), f, has(proved, f) ? static_cast<std::uint32_t>(items.size()) : f};

  const OwnFaces own(body, items);
  const NeighbourMask neighbours(body, star_of, own.tree.ids());
  const auto wanted = [&](std::uint32_t i, std::uint32_t j) {
    return !prover.proved(own.faces[i].face, own.faces[j].face);
  };
  const auto others =
      PairSearch(own.faces, own.tree, InParts::passed, std::cref(neighbours), wanted).run(BoxTree::Pairs::foreign);
  found.insert(found.end(), others.begin(), others.end());
  return found;
}

}  // namespace quoin::booleans
