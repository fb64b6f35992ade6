#include "booleans/pairs/box_tree.h"

#include "grid/lists/stretches.h"

namespace quoin::booleans {
namespace {

/// Spreads the low 10 bits of v to every third bit.
std::uint32_t spread(std::uint32_t v) {
  v = (v | (v << 16)) & 0x030000FFu;
  v = (v | (v << 8)) & 0x0300F00Fu;
  v = (v | (v << 4)) & 0x030C30C3u;
  return (v | (v << 2)) & 0x09249249u;
}

constexpr int axis_bits = 10, key_bits = 3 * axis_bits;

/// The place of box centres on a Morton curve through the box of them all, `axis_bits` bits an axis.
class Places {
 public:
  explicit Places(const Box& all) : low_(all.low) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t extent = 2 * static_cast<std::uint64_t>(std::int64_t{all.high[k]} - all.low[k]);
      while (extent >> shift_[k] >> axis_bits) ++shift_[k];
    }
  }
  std::uint32_t operator()(const Box& box) const {
    std::uint32_t key = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t centre = std::int64_t{box.low[k]} + box.high[k] - 2 * std::int64_t{low_[k]};
      key |= spread(static_cast<std::uint32_t>(centre >> shift_[k])) << k;
    }
    return key;
  }

 private:
  std::array<std::int32_t, 3> low_;
  std::array<int, 3> shift_{};
};

using Keyed = std::pair<std::uint32_t, std::uint32_t>;  // key, index

/// Sorts `a`, given in the order of the indices, by the key into `b`: in three passes.
void radix_sort(std::span<Keyed> a, std::span<Keyed> b) {
  if (a.size() < grid::thresholds().few_keys) {
    std::copy(a.begin(), a.end(), b.begin());
    return std::sort(b.begin(), b.end());
  }
  constexpr int digit = key_bits / 3;
  constexpr std::uint32_t mask = (1u << digit) - 1;
  for (int shift = 0; shift < key_bits; shift += digit) {
    std::array<std::uint32_t, mask + 2> start{};
    for (const Keyed& x : a) ++start[((x.first >> shift) & mask) + 1];
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    for (const Keyed& x : a) b[start[(x.first >> shift) & mask]++] = x;
    std::swap(a, b);
  }
}

constexpr std::size_t stretch = std::size_t{1} << 14;

std::vector<BoxTree::Item> sorted(const std::vector<BoxTree::Item>& items, BoxTree::Order by) {
  Box all;
  for (const BoxTree::Item& x : items) all.add(x.box);
  const Places place(all);
  const bool grouped = by == BoxTree::Order::by_group;
  std::vector<std::size_t> start(2);  // of each group, then its end
  for (const BoxTree::Item& x : items) {
    const std::size_t group = grouped ? x.group : 0;
    if (start.size() < group + 2) start.resize(group + 2);
    ++start[group + 1];
  }
  for (std::size_t g = 1; g < start.size(); ++g) start[g] += start[g - 1];
  std::vector<Keyed> given(items.size()), order(items.size());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for (std::uint32_t i = 0; i < items.size(); ++i) given[next[grouped ? items[i].group : 0]++].second = i;
  grid::in_stretches(given.size(), stretch, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) given[i].first = place(items[given[i].second].box);
  });
  grid::in_tasks(start.size() - 1, items.size(), [&](std::size_t g) {
    const std::size_t size = start[g + 1] - start[g];
    radix_sort(std::span(given).subspan(start[g], size), std::span(order).subspan(start[g], size));
  });
  std::vector<BoxTree::Item> result(items.size());
  grid::in_stretches(order.size(), stretch, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) result[i] = items[order[i].second];
  });
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
