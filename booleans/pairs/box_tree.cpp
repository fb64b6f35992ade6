#include "booleans/pairs/box_tree.h"

#include "grid/lists/buckets.h"
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
    std::array<std::uint32_t, mask + 3> start{};
    const auto for_items = [&](auto&& visit) {
      for (const Keyed& x : a) visit((x.first >> shift) & mask, x);
    };
    grid::counting_sort(start, for_items, [&](std::size_t) { return b.data(); });
    std::swap(a, b);
  }
}

constexpr std::size_t stretch = std::size_t{1} << 14;

Array<BoxTree::Item> sorted(const Array<BoxTree::Item>& items, BoxTree::Order by) {
  const bool grouped = by == BoxTree::Order::by_group;
  Box all;
  std::size_t groups = 1;
  for (const BoxTree::Item& x : items) {
    all.add(x.box);
    if (grouped) groups = std::max<std::size_t>(groups, x.group + 1);
  }

  grid::Buckets<Keyed> given(groups, [&](auto&& visit) {
    for (std::uint32_t i = 0; i < items.size(); ++i) visit(grouped ? items[i].group : 0, Keyed{0, i});
  });
  const Places place(all);
  grid::in_stretches(items.size(), stretch, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (Keyed& x : given.items().subspan(begin, end - begin)) x.first = place(items[x.second].box);
  });

  Array<Keyed> order(items.size());
  grid::in_tasks(groups, items.size(), [&](std::size_t g) {
    radix_sort(given[g], std::span(order).subspan(given.start(g), given[g].size()));
  });

  Array<BoxTree::Item> result(items.size());
  grid::in_stretches(order.size(), stretch, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) result[i] = items[order[i].second];
  });
  return result;
}

}  // namespace

BoxTree::BoxTree(const Array<Item>& given, Order order) {
  if (given.empty()) return;
  const Array<Item> items = sorted(given, order);
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
