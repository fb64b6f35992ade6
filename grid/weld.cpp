#include "grid/weld.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <numeric>
#include <utility>

#include "grid/lists/thresholds.h"

namespace quoin::grid {

using exact::GridPoint;

namespace {

std::uint32_t fingerprint(const GridPoint& p) {
  const auto x = static_cast<std::uint32_t>(p.c[0]), y = static_cast<std::uint32_t>(p.c[1]),
             z = static_cast<std::uint32_t>(p.c[2]);
  std::uint64_t h = (x | std::uint64_t{y} << 32) * 0x9E3779B97F4A7C15u;
  h ^= (h >> 32) ^ (z * 0xC2B2AE3D27D4EB4Fu);
  h *= 0xBF58476D1CE4E5B9u;
  h ^= h >> 29;
  h *= 0x94D049BB133111EBu;
  return static_cast<std::uint32_t>(h >> 32);
}

/// Open addressing: a slot holds fingerprint << 32 | id + 1, or 0; its place begins with the fingerprint's top bits,
/// so growing needs no point.
class Table {
 public:
  explicit Table(std::size_t expected) {
    resize(static_cast<int>(std::bit_width(std::max<std::size_t>(expected * 3 / 2, 64))));
  }

  void reserve(std::size_t count) {
    if (count * 4 < slots_.size() * 3 || bits_ == 32) return;
    const Array<std::uint64_t> old = std::move(slots_);
    resize(bits_ + 1);
    for (std::uint64_t slot : old) {
      if (slot == 0) continue;
      std::size_t i = place(static_cast<std::uint32_t>(slot >> 32));
      while (slots_[i] != 0) i = (i + 1) & mask_;
      slots_[i] = slot;
    }
  }

  void prefetch(std::uint32_t print) const { __builtin_prefetch(&slots_[place(print)], 1); }

  /// The id of the point equal to `p` among `points`, or `next` after entering it as that.
  std::uint32_t find_or_enter(std::uint32_t print, const GridPoint& p, const GridPoint* points, std::uint32_t next) {
    for (std::size_t i = place(print);; i = (i + 1) & mask_, ++collisions_) {
      const std::uint64_t slot = slots_[i];
      if (slot == 0) {
        slots_[i] = std::uint64_t{print} << 32 | (next + 1);
        return next;
      }
      const std::uint32_t id = static_cast<std::uint32_t>(slot) - 1;
      if (slot >> 32 == print && points[id] == p) return id;
    }
  }

  std::uint64_t collisions() const { return collisions_; }

 private:
  void resize(int bits) {
    bits_ = std::min(bits, 32);
    slots_.assign(std::size_t{1} << bits_, 0);
    mask_ = slots_.size() - 1;
  }
  std::size_t place(std::uint32_t print) const { return print >> (32 - bits_); }

  Array<std::uint64_t> slots_;
  std::size_t mask_ = 0;
  std::uint64_t collisions_ = 0;
  int bits_ = 0;
};

/// Counts the distinct positions that fell on a grid point together with a different, earlier one.
class Mergers {
 public:
  explicit Mergers(std::span<const double> input) : input_(input) {}

  /// Point `index` became point `id`, whose first input point is `first`.
  void note(std::uint32_t id, std::size_t first, std::size_t index) {
    const double *p = &input_[3 * first], *q = &input_[3 * index];
    if (p[0] == q[0] && p[1] == q[1] && p[2] == q[2]) return;
    positions_.push_back({id, {q[0] + 0.0, q[1] + 0.0, q[2] + 0.0}});  // no -0
  }
  std::uint64_t count() {
    std::sort(positions_.begin(), positions_.end());
    return static_cast<std::uint64_t>(std::unique(positions_.begin(), positions_.end()) - positions_.begin());
  }

 private:
  std::span<const double> input_;
  Array<std::pair<std::uint32_t, std::array<double, 3>>> positions_;
};

}  // namespace

Weld weld(Array<GridPoint>& points, std::span<const double> input, std::size_t expected) {
  const std::size_t n = points.size();
  assert(input.size() == 3 * n);

  Table table(std::min(expected, n));
  Mergers mergers(input);
  Weld result;
  Array<std::uint32_t> first;  // input point of each kept one, from the first merger on
  Array<GridPoint> kept;       // then the kept points; before that they are a prefix of `points`
  std::uint32_t next = 0;

  constexpr std::size_t batch = 32;
  std::array<std::uint32_t, batch> prints{};
  for (std::size_t begin = 0; begin < n; begin += batch) {
    const std::size_t end = std::min(n, begin + batch);
    table.reserve(next + batch);
    for (std::size_t i = begin; i < end; ++i) table.prefetch(prints[i - begin] = fingerprint(points[i]));
    for (std::size_t i = begin; i < end; ++i) {
      const GridPoint* const seen = result.ids.empty() ? points.data() : kept.data();
      const std::uint32_t id = table.find_or_enter(prints[i - begin], points[i], seen, next);
      if (result.ids.empty()) {
        if (id == next) {
          ++next;
          continue;
        }
        result.ids.resize(n);
        std::iota(result.ids.begin(), result.ids.begin() + static_cast<std::ptrdiff_t>(i), 0U);
        first.assign(result.ids.begin(), result.ids.begin() + static_cast<std::ptrdiff_t>(i));
        kept.assign(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i));
      }

      result.ids[i] = id;
      if (id == next) {
        ++next;
        kept.push_back(points[i]);
        first.push_back(static_cast<std::uint32_t>(i));
      } else {
        mergers.note(id, first[id], i);
      }
    }

    // A hash that clusters must not cost more than sorting.
    if (table.collisions() > thresholds().collisions * (end + 1024)) return weld_by_sorting(points, input);
  }

  if (result.ids.empty()) return result;
  points = std::move(kept);
  result.merged = mergers.count();
  return result;
}

Weld weld_by_sorting(Array<GridPoint>& points, std::span<const double> input) {
  const std::size_t n = points.size();
  Array<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return points[i] != points[j] ? points[i] < points[j] : i < j; });

  Array<std::uint32_t> first(n);  // the first input point equal to each
  for (std::size_t i = 0; i < n; ++i)
    first[order[i]] = i > 0 && points[order[i]] == points[order[i - 1]] ? first[order[i - 1]] : order[i];

  Weld result;
  result.ids.resize(n);
  Mergers mergers(input);
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (first[i] == i) {
      points[next] = points[i];
      result.ids[i] = next++;
    } else {
      result.ids[i] = result.ids[first[i]];
      mergers.note(result.ids[i], first[i], i);
    }
  }

  points.resize(next);
  if (next == n) result.ids.clear();
  result.merged = mergers.count();
  return result;
}

}  // namespace quoin::grid
