#include "booleans/pairs/crowd.h"

#include <algorithm>

#include "booleans/pairs/box_tree.h"
#include "grid/lists/thresholds.h"

namespace quoin::booleans {
namespace {

/// How many of a box's neighbours meet each other, rounded up, as if all were like some that stand at equal distances
/// in the list.
std::size_t crowd_around(const Array<Box>& boxes, const Array<std::uint32_t>& neighbours) {
  constexpr std::size_t most_asked = 8;
  const std::size_t asked = std::min(neighbours.size(), most_asked);
  const auto box = [&](std::size_t i) -> const Box& { return boxes[neighbours[i * neighbours.size() / asked]]; };
  std::size_t pairs = 0, meeting = 0;
  for (std::size_t i = 0; i < asked; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      ++pairs;
      meeting += box(i).meets(box(j));
    }
  return pairs == 0 ? 0 : (neighbours.size() * meeting + pairs - 1) / pairs;
}

}  // namespace

bool are_crowded(const Array<Box>& boxes) {
  Array<BoxTree::Item> items;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) items.push_back({boxes[i], i, i});
  const BoxTree tree(items);

  const std::size_t most = 2 * grid::thresholds().neighbours * boxes.size();  // each pair counts twice
  std::size_t crowd = 0;
  Array<std::uint32_t> neighbours;
  for (std::uint32_t i = 0; i < boxes.size() && crowd <= most; ++i) {
    neighbours.clear();
    tree.meeting(boxes[i], [&](std::uint32_t other) {
      if (other != i) neighbours.push_back(other);
    });
    crowd += crowd_around(boxes, neighbours);
  }
  return crowd > most;
}

}  // namespace quoin::booleans
