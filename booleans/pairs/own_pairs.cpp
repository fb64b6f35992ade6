#include "booleans/pairs/own_pairs.h"

#include <functional>

#include "booleans/body/simple.h"
#include "booleans/pairs/fan_proof.h"
#include "booleans/pairs/neighbour_mask.h"
#include "booleans/pairs/pair_search.h"
#include "booleans/pairs/proper_pairs.h"
#include "booleans/pairs/triangle_pair.h"

namespace quoin::booleans {
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

/// Triangles that share a vertex whose star is embedded meet as they should. Polygons are no neighbours.
NeighbourMask neighbours_in(const Body& mesh, const Array<Star>& star_of, const Array<std::uint32_t>& order) {
  return {order, [&](std::uint32_t f, std::size_t k) {
            const std::uint32_t v = f < mesh.triangles.size() ? mesh.triangles[f][k] : none;
            return v != none && star_of[v] == Star::embedded ? v : none;
          }};
}

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
  const NeighbourMask neighbours = neighbours_in(mesh, star_of, own.tree.ids());
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
  const NeighbourMask neighbours = neighbours_in(body, star_of, own.tree.ids());
  const auto wanted = [&](std::uint32_t i, std::uint32_t j) {
    return !prover.proved(own.faces[i].face, own.faces[j].face);
  };
  const auto others =
      PairSearch(own.faces, own.tree, InParts::passed, std::cref(neighbours), wanted).run(BoxTree::Pairs::foreign);
  found.insert(found.end(), others.begin(), others.end());
  return found;
}

}  // namespace quoin::booleans
