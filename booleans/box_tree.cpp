#include "booleans/box_tree.h"

namespace quoin::booleans {
namespace {

/// Spreads the low 10 bits of v to every third bit.
std::uint32_t spread(std::uint32_t v) {
  v = (v | (v << 16)) & 0x030000FFu;
  v = (v | (v << 8)) & 0x0300F00Fu;
  v = (v | (v << 4)) & 0x030C30C3u;
  return (v | (v << 2)) & 0x09249249u;
}

/// Sorts (key, index), given in the order of the indices, by the 30-bit key: in three passes of 10 bits.
void radix_sort(std::vector<std::pair<std::uint32_t, std::uint32_t>>& a) {
  if (a.size() < 500) return std::sort(a.begin(), a.end());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> b(a.size());
  for (int shift = 0; shift < 30; shift += 10) {
    std::array<std::uint32_t, 1025> start{};
    for (const auto& x : a) ++start[((x.first >> shift) & 1023u) + 1];
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    for (const auto& x : a) b[start[(x.first >> shift) & 1023u]++] = x;
    a.swap(b);
  }
}

std::vector<BoxTree::Item> sorted(const std::vector<BoxTree::Item>& items, BoxTree::Order by) {
  Box all;
  for (const BoxTree::Item& x : items) all.add(x.box);
  // 10 bits per axis of the doubled centre.
  std::array<int, 3> shift{};
  for (std::size_t k = 0; k < 3 && !items.empty(); ++k) {
    std::uint64_t extent = 2 * static_cast<std::uint64_t>(std::int64_t{all.high[k]} - all.low[k]);
    while (extent >> shift[k] > 1023) ++shift[k];
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order(items.size());
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    std::uint32_t key = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t centre =
          std::int64_t{items[i].box.low[k]} + items[i].box.high[k] - 2 * std::int64_t{all.low[k]};
      key |= spread(static_cast<std::uint32_t>(centre >> shift[k])) << k;
    }
    order[i] = {key, i};
  }
  radix_sort(order);
  std::vector<std::size_t> start(1);
  if (by == BoxTree::Order::by_group) {
    for (const BoxTree::Item& x : items) {
      start.resize(std::max<std::size_t>(start.size(), x.group + std::size_t{2}));
      ++start[x.group + 1];
    }
    for (std::size_t g = 1; g < start.size(); ++g) start[g] += start[g - 1];
  }
  std::vector<BoxTree::Item> result(items.size());
  for (const auto& o : order) {
    const BoxTree::Item& x = items[o.second];
    result[start[by == BoxTree::Order::by_group ? x.group : 0]++] = x;
  }
  return result;
}

}  // namespace

BoxTree::BoxTree(const std::vector<Item>& given, Order order) {
  if (given.empty()) return;
  const std::vector<Item> items = sorted(given, order);
  ids_.reserve(items.size());
  for (const Item& x : items) ids_.push_back(x.id);
  levels_.reserve(12);  // 8^11 > 2^32: a level stays where it is while the next is made
  add_level(
      items.size(), [&](std::size_t i) { return items[i].box; }, [&](std::size_t i) { return items[i].group; });
  while (levels_.back().blocks.size() > 1) {
    const Level& below = levels_.back();
    const auto lanes = [&](std::size_t i) {
      return std::min<std::size_t>(BoxBlock::width, std::size_t{below.count} - i * BoxBlock::width);
    };
    const auto box = [&](std::size_t i) {
      Box sum;
      for (std::uint32_t lane = 0; lane < lanes(i); ++lane) sum.add(below.blocks[i].box(lane));
      return sum;
    };
    const auto group = [&](std::size_t i) {
      const auto first = below.group.begin() + static_cast<std::ptrdiff_t>(i * BoxBlock::width);
      return std::all_of(first, first + static_cast<std::ptrdiff_t>(lanes(i)),
                         [&](std::uint32_t g) { return g == *first; })
                 ? *first
                 : mixed;
    };
    add_level(below.blocks.size(), box, group);
  }
}

}  // namespace quoin::booleans
