#include "booleans/block_slabs.h"

#include <cmath>

namespace quoin::booleans {

std::array<exact::GridPoint, 2> ends_along(const std::array<std::int64_t, 3>& n, const Box& box) {
  std::array<exact::GridPoint, 2> r{};
  for (std::size_t k = 0; k < 3; ++k) {
    r[0].c[k] = n[k] < 0 ? box.high[k] : box.low[k];
    r[1].c[k] = n[k] < 0 ? box.low[k] : box.high[k];
  }
  return r;
}

namespace {

std::int64_t value(const std::array<std::int64_t, 3>& n, const exact::GridPoint& p) {
  return n[0] * p.c[0] + n[1] * p.c[1] + n[2] * p.c[2];
}

/// In the direction of d, components at most `size`.
std::array<std::int64_t, 3> scaled(const std::array<double, 3>& d, int size) {
  const double longest = std::max({std::fabs(d[0]), std::fabs(d[1]), std::fabs(d[2])});
  std::array<std::int64_t, 3> n{};
  for (std::size_t k = 0; k < 3; ++k) n[k] = longest > 0 ? static_cast<std::int64_t>(d[k] * size / longest) : 0;
  return n;
}

}  // namespace

LanePairs BlockSlabs::apart(std::uint32_t x, std::uint32_t y) const {
  const Slab &a = slabs_[slab_of_[x]], &b = slabs_[slab_of_[y]];
  if (a.is_bundle && b.is_bundle && bundles_apart(x, y)) return ~LanePairs{0};
  LanePairs rows = 0, columns = 0;
  for (std::uint32_t i = begin(x); i < end(x); ++i)
    if (b.reach.apart(reach(i, b.normal))) rows |= LanePairs{0xFF} << (8 * (i - begin(x)));
  for (std::uint32_t j = begin(y); j < end(y); ++j)
    if (a.reach.apart(reach(j, a.normal))) columns |= LanePairs{0x0101010101010101} << (j - begin(y));
  return rows | columns;
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
  Normal n{};
  for (std::size_t k = 0; k < 3; ++k) n[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
  return block_reach(x, n).apart(block_reach(y, n));
}

/// The directions in which eight neighbours are likely to be thin.
BlockSlabs::Slab BlockSlabs::slab(std::uint32_t block) const {
  std::array<double, 3> sum{}, along{};
  double area = 0, longest = 0;
  for (std::uint32_t i = begin(block); i < end(block); ++i) {
    const auto& [body, f] = faces_[i];
    const exact::Plane p = body->sign_plane(f);
    const std::array<double, 3> normal{double(p.n[0]), double(p.n[1]), double(p.n[2])};
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
