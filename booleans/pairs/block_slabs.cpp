#include "booleans/pairs/block_slabs.h"

#include "booleans/pairs/directions.h"
#include "exact/filter_bounds.h"

namespace quoin::booleans {

LanePairs BlockSlabs::apart(std::uint32_t x, std::uint32_t y) const {
  const Slab &a = slabs_[slab_of_[x]], &b = slabs_[slab_of_[y]];
  if (a.is_bundle && b.is_bundle && bundles_apart(x, y)) return ~LanePairs{0};
  LanePairs rows = 0, columns = 0;
  for (std::uint32_t i = begin(x); i < end(x); ++i)
    if (b.reach.apart(reach(i, b.normal))) rows |= LanePairs{0xFF} << (8 * (i - begin(x)));
  for (std::uint32_t j = begin(y); j < end(y); ++j)
    if (a.reach.apart(reach(j, a.normal))) columns |= LanePairs{0x0101010101010101} << (j - begin(y));
  const LanePairs left = ~(rows | columns);
  return ~left | (std::popcount(left) > grid::thresholds().crowded_slabs ? apart_along_line(x, y, left) : 0);
}

/// Coordinates along the line are below 2^61. A crossing is at s + t (r - s) with 0 <= t <= 1: three roundings of t
/// make 3 * 2^-53 of |r - s| < 2^62, less than 2^11; r - s is off by 2^9 at most, s by 2^7, the product rounds by 2^9,
/// the sum and the one with the slack by 2^8 each. All is less than 2^13. Proved by docs/proofs/crossing.g.
BlockSlabs::Interval BlockSlabs::within(std::uint32_t face, const Slab& slab, const Normal& line) const {
  constexpr double slack = exact::crossing_slack;
  Interval r;
  if (!faces_[face].is_raw()) {
    const Reach all = reach(face, line);
    return {static_cast<double>(all.low) - slack, static_cast<double>(all.high) + slack};
  }
  const Body& body = *faces_[face].body;
  std::array<std::int64_t, 3> height{};
  std::array<double, 3> along{};
  for (std::size_t k = 0; k < 3; ++k) {
    const exact::GridPoint& p = body.grid_points[body.triangles[faces_[face].face][k]];
    height[k] = value(slab.normal, p);
    along[k] = static_cast<double>(value(line, p));
    if (height[k] >= slab.reach.low && height[k] <= slab.reach.high) r.add(along[k]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    for (const std::int64_t end : {slab.reach.low, slab.reach.high})
      if ((height[k] < end) != (height[next] < end))
        r.add(along[k] + static_cast<double>(end - height[k]) / static_cast<double>(height[next] - height[k]) *
                             (along[next] - along[k]));
  }
  return {r.low - slack, r.high + slack};
}

LanePairs BlockSlabs::apart_along_line(std::uint32_t x, std::uint32_t y, LanePairs left) const {
  const Slab &a = slabs_[slab_of_[x]], &b = slabs_[slab_of_[y]];
  const Normal line = scaled(cross(doubles(a.normal), doubles(b.normal)), (1 << 30) - 1);
  std::array<Interval, BoxBlock::width> columns{};
  for (std::uint32_t j = begin(y); j < end(y); ++j) columns[j - begin(y)] = within(j, a, line);
  LanePairs r = 0;
  for (std::uint32_t i = begin(x); i < end(x); ++i) {
    const std::uint32_t row = BoxBlock::width * (i - begin(x));
    if ((left >> row & 0xFF) == 0) continue;
    const Interval own = within(i, b, line);
    for (std::uint32_t j = 0; j < BoxBlock::width; ++j) r |= LanePairs{own.apart(columns[j])} << (row + j);
  }
  return r;
}

BlockSlabs::Reach BlockSlabs::reach(std::uint32_t face, const Normal& n) const {
  Reach r;
  if (const auto& [body, f] = faces_[face]; faces_[face].is_raw()) {
    for (const std::uint32_t v : body->triangles[f]) r.add(value(n, body->grid_points[v]));
  } else {
    for (const exact::GridPoint& p : ends_along(n, tree_.box(face))) r.add(value(n, p));
  }
  return r;
}

BlockSlabs::Reach BlockSlabs::block_reach(std::uint32_t block, const Normal& n) const {
  Reach r;
  for (std::uint32_t i = begin(block); i < end(block); ++i) r.add(reach(i, n));
  return r;
}

/// Components of the direction are below 2 * 2^28.
bool BlockSlabs::bundles_apart(std::uint32_t x, std::uint32_t y) const {
  const Normal &u = slabs_[slab_of_[x]].along, &v = slabs_[slab_of_[y]].along;
  const Normal n = cross(u, v);
  return block_reach(x, n).apart(block_reach(y, n));
}

/// The directions in which eight neighbours are likely to be thin.
BlockSlabs::Slab BlockSlabs::slab(std::uint32_t block) const {
  std::array<double, 3> sum{}, along{};
  double area = 0, longest = 0;
  for (std::uint32_t i = begin(block); i < end(block); ++i) {
    const auto& [body, f] = faces_[i];
    const exact::Plane p = body->sign_plane(f);
    const std::array<double, 3> normal = doubles(p.n);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += normal[k];
    area += std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    if (!faces_[i].is_raw()) {
      area = HUGE_VAL;  // of triangles only
      continue;
    }
    const auto& t = body->triangles[f];
    for (std::size_t c = 0; c < 3; ++c) {
      std::array<double, 3> e{};
      for (std::size_t k = 0; k < 3; ++k)
        e[k] = double(body->grid_points[t[c]].c[k]) - double(body->grid_points[t[(c + 1) % 3]].c[k]);
      const double length = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
      if (length > longest) longest = length, along = e;
    }
  }
  Slab s{scaled(sum, (1 << 30) - 1), {}, scaled(along, (1 << 14) - 1), 4 * area < longest};
  s.reach = block_reach(block, s.normal);
  return s;
}

}  // namespace quoin::booleans
