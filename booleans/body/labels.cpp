#include "booleans/body/labels.h"

#include <algorithm>
#include <functional>

#include "booleans/body/channels.h"

namespace quoin::booleans {
namespace {

std::size_t hash_of(const Origins::Pointer& origin) {
  if (!origin) return 0;
  return std::hash<std::string>()(origin->name) ^ (origin->id * 0x9E3779B97F4A7C15u + origin->faces);
}

template <class Entry>
bool has_lower_hash(const Entry& a, const Entry& b) {
  return a.hash < b.hash;
}

}  // namespace

bool operator==(const Origin& a, const Origin& b) {
  if (a.id != b.id || a.faces != b.faces || a.name != b.name || a.labels != b.labels || a.surfaces != b.surfaces)
    return false;
  return a.channels == b.channels || (a.channels && b.channels && *a.channels == *b.channels);
}

grid::Array<std::uint32_t> Origins::in_order() const {
  grid::Array<std::uint32_t> order(size());
  for (std::uint32_t i = 0; i < size(); ++i) order[rank_[i]] = i;
  return order;
}

std::uint32_t Origins::find(const Pointer& origin) const {
  const auto is_equal = [&](const Entry& e) {
    const Pointer& known = list_[e.origin];
    return known == origin || (known && origin && *known == *origin);
  };
  const auto [first, last] =
      std::equal_range(by_hash_.begin(), by_hash_.end(), Entry{hash_of(origin), 0}, has_lower_hash<Entry>);
  const auto found = std::find_if(first, last, is_equal);
  return found != last ? found->origin : static_cast<std::uint32_t>(size());
}

void Origins::add(const Pointer& origin) {
  const auto number = static_cast<std::uint32_t>(size());
  const Entry entry{hash_of(origin), number};
  by_hash_.insert(std::upper_bound(by_hash_.begin(), by_hash_.end(), entry, has_lower_hash<Entry>), entry);
  rank_.push_back(number);
  list_.push_back(origin);
}

void Origins::set_order(std::span<const std::uint32_t> order) {
  for (std::uint32_t i = 0; i < order.size(); ++i) rank_[order[i]] = i;
}

std::span<const Border> Labels::borders_within(std::uint32_t begin, std::uint32_t end) const {
  if (borders.empty()) return {};
  const auto before = [](const Border& b, std::uint32_t corner) { return b.corner < corner; };
  const Border* first = std::lower_bound(borders.begin(), borders.end(), begin, before);
  const Border* last = first;
  // Of most faces there are few.
  while (last != borders.end() && last->corner < end) ++last;
  return {first, last};
}

void Labels::append_borders(const Labels& from, std::uint32_t begin, std::uint32_t end, std::uint32_t to) {
  for (const Border& b : from.borders_within(begin, end)) borders.push_back({b.corner - begin + to, b.other});
}

void Labels::append_reversed_borders(const Labels& from, std::uint32_t begin, std::uint32_t end, std::uint32_t to) {
  const auto found = from.borders_within(begin, end);
  grid::Array<Border> reversed;
  for (const Border& b : found) reversed.push_back({reversed_corner(b.corner, begin, end) - begin + to, b.other});
  std::sort(reversed.begin(), reversed.end(), [](const Border& a, const Border& b) { return a.corner < b.corner; });
  borders.append(reversed.begin(), reversed.end());
}

void Labels::reverse_loops(std::span<const std::uint32_t> loop_start) {
  if (borders.empty()) return;
  Labels before;
  std::swap(before.borders, borders);
  for (std::size_t j = 0; j + 1 < loop_start.size(); ++j)
    append_reversed_borders(before, loop_start[j], loop_start[j + 1], loop_start[j]);
}

void Labels::settle() {
  triangles.settle();
  polygons.settle();
  borders.settle();
}

}  // namespace quoin::booleans
