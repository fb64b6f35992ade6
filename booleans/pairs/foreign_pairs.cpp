#include "booleans/pairs/foreign_pairs.h"

#include "booleans/pairs/cell_filter.h"
#include "booleans/pairs/directions.h"
#include "booleans/pairs/pair_search.h"
#include "booleans/pairs/triangle_pair.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {
namespace {

/// Do all corners of the face lie strictly on one side of the plane?
bool strictly_on_one_side(const exact::Plane& plane, const Body& body, std::uint32_t face) {
  int seen = 0;
  const auto apart = [&](int s) {
    if (s == 0 || s * seen < 0) return false;
    seen = s;
    return true;
  };
  for (const std::uint32_t v : body.corners_of(face))
    if (!apart(body.is_grid(v) ? exact::side(plane, body.grid_points[v]) : exact::side(plane, body.derived(v))))
      return false;
  return true;
}

/// Items, part by part, without most of those that share no cell with an item of another group.
/// visit_part(i, visit): visit(item) for the items of part i; `all` holds the `count` items, `factor` times as many
/// cells may be taken.
template <class VisitPart>
Array<BoxTree::Item> near_items(std::size_t parts, std::size_t count, const Box& all, std::size_t factor,
                                VisitPart visit_part) {
  constexpr std::size_t most_samples = 1024;
  const std::size_t length = grid::stretch(256);
  if (count < grid::thresholds().few_boxes) {  // not worth it
    Array<BoxTree::Item> items;
    items.reserve(count);
    for (std::size_t i = 0; i < parts; ++i) visit_part(i, [&](const BoxTree::Item& item) { items.push_back(item); });
    return items;
  }

  Array<Array<BoxTree::Item>> kept(parts / length + 1);
  grid::in_stretches(parts, length, [&](std::size_t s, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      visit_part(i, [&](const BoxTree::Item& item) { kept[s].push_back(item); });
  });

  const std::size_t stride = 1 + count / most_samples;
  Array<Box> sample;
  for (const auto& list : kept)
    for (std::size_t i = 0; i < list.size(); i += stride) sample.push_back(list[i].box);
  if (sample.empty()) sample.push_back(all);

  CellFilter cells(all, sample, count / sample.size() + 1, factor * count);
  grid::in_tasks(kept.size(), count, [&](std::size_t s) {
    for (const BoxTree::Item& item : kept[s]) cells.add(item.box, item.group);
  });
  grid::in_tasks(kept.size(), count, [&](std::size_t s) {
    std::erase_if(kept[s], [&](const BoxTree::Item& item) { return !cells.is_shared(item.box); });
  });
  return grid::joined(kept);
}

/// The faces that may meet one of another operand: chunks are looked at first.
Array<BoxTree::Item> near_faces(const Operands& operands) {
  Box all;
  std::size_t count = 0;
  for (const OperandChunk& c : operands.chunks)
    if (!c.far) all.add(c.box), ++count;
  const auto chunks = near_items(operands.chunks.size(), count, all, 32, [&](std::size_t i, auto&& visit) {
    if (const OperandChunk& c = operands.chunks[i]; !c.far)
      visit(BoxTree::Item{c.box, static_cast<std::uint32_t>(i), c.operand.value});
  });

  count = 0;
  for (const BoxTree::Item& c : chunks) count += operands.chunks[c.id].end.value - operands.chunks[c.id].begin.value;
  return near_items(chunks.size(), count, all, 8, [&](std::size_t i, auto&& visit) {
    const OperandChunk& c = operands.chunks[chunks[i].id];
    for (const FaceId f : Ids<FaceId>(c.begin, c.end)) {
      // A face of many corners has a chunk of its own.
      const bool is_alone = c.end.value - c.begin.value == 1;
      const Box box = is_alone ? c.box : face_box(operands[c.operand], operands.own(c.operand, f));
      if (operands.may_be_near(c.operand, box)) visit(BoxTree::Item{box, f.value, c.operand.value});
    }
  });
}

}  // namespace

FacePairs foreign_pairs(const Operands& operands) {
  const Array<BoxTree::Item> items = near_faces(operands);
  const bool few = operands.bodies.size() <= grid::thresholds().few_operands;
  const BoxTree tree(items, few ? BoxTree::Order::by_group : BoxTree::Order::by_place);
  Array<SearchedFace> faces;
  faces.reserve(items.size());
  for (const std::uint32_t id : tree.ids()) {
    const OwnFace f = operands.own(FaceId(id));
    faces.push_back({operands.bodies[f.operand], f.face});
  }

  const auto apart = [&](std::uint32_t i, std::uint32_t j) {
    const exact::Plane plane = faces[i].body->sign_plane(faces[i].face);
    return faces[j].corner_count() > grid::thresholds().large_face
               ? strictly_on_one_side(plane, tree.box(j))
               : strictly_on_one_side(plane, *faces[j].body, faces[j].face);
  };
  const auto may_meet = [&](std::uint32_t i, std::uint32_t j) {
    if (faces[i].is_raw() && faces[j].is_raw())
      return meet(triangle(*faces[i].body, faces[i].face), triangle(*faces[j].body, faces[j].face));
    return !apart(i, j) && !apart(j, i);
  };

  return PairSearch(faces, tree, InParts::one_each, skip_nothing, may_meet).run(BoxTree::Pairs::foreign);
}

}  // namespace quoin::booleans
