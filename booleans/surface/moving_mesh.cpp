#include "booleans/surface/moving_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "grid/lists/stretches.h"

namespace quoin::booleans {

MovingMesh::MovingMesh(const Body& body, const Triangulated& mesh, Floats floats, const grid::Lattice& lattice,
                       const std::vector<double>& points, const Moves& moves)
    : body_(body),
      mesh_(mesh),
      points_(points),
      moves_(moves),
      pad_(static_cast<std::int32_t>(moves.most / exact::to_double(lattice.step) * (1 + 0x1p-40)) + 1),
      unit_(floats == Floats::float32 ? 0x1p-24 : 0x1p-53),
      floor_(floats == Floats::float32 ? 0x1p-150 : std::numeric_limits<double>::denorm_min()) {
  number_added();
}

/// Copies of a vertex that `separated` added have one place.
void MovingMesh::number_added() {
  Array<std::uint32_t> order(mesh_.added.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return mesh_.added[i] != mesh_.added[j] ? mesh_.added[i] < mesh_.added[j] : i < j;
  });

  added_place_.resize(order.size());
  auto place = static_cast<std::uint32_t>(body_.vertex_count());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && mesh_.added[order[i]] != mesh_.added[order[i - 1]]) ++place;
    added_place_[order[i]] = place;
  }
}

MovingTriangle MovingMesh::triangle(std::uint32_t t) const {
  MovingTriangle r{};
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = mesh_.corners[3 * std::size_t{t} + i];
    r.place[i] = place(v);
    for (std::size_t k = 0; k < 3; ++k) r.at[i][k] = points_[3 * std::size_t{v} + k];
    if (!moves_.moved[v]) continue;
    for (const double x : r.at[i]) largest = std::max(largest, std::fabs(x));
    r.error = largest * unit_ + floor_;
  }
  return r;
}

Box MovingMesh::still_box(std::uint32_t t) const {
  Box b;
  for (const std::uint32_t v : mesh_.triangle(t)) {
    if (v < mesh_.source.size()) {
      body_.add_to(b, mesh_.source[v]);
      continue;
    }
    const RationalPoint& p = mesh_.added[v - mesh_.source.size()];
    b.add_around({exact::to_double(p[0]), exact::to_double(p[1]), exact::to_double(p[2])});
  }
  return b;
}

bool MovingMesh::still_meets(std::uint32_t t, const Box& box) const {
  if (t >= moves_.first) return still_box(t).meets(box);
  const auto& c = body_.triangles[mesh_.face[t]];
  WideBox own(body_.grid_points[c[0]]);
  own.add(body_.grid_points[c[1]]);
  own.add(body_.grid_points[c[2]]);
  return own.meets(WideBox(box));
}

Box MovingMesh::moving_box(std::uint32_t t) const {
  Box b = still_box(t);
  for (std::size_t k = 0; k < 3; ++k) {
    b.low[k] -= pad_;
    b.high[k] += pad_;
  }
  return b;
}

Array<std::uint8_t> steady_stars(const MovingMesh& mesh) {
  const auto count = static_cast<std::uint32_t>(mesh.triangle_count());
  // By vertex: the directions that all triangles around it face, and a bit that says that it is wanted.
  constexpr std::uint8_t wanted = 0x80;
  Array<std::uint8_t> common(mesh.vertex_count());
  for (std::uint32_t t = mesh.first_moved(); t < count; ++t)
    if (mesh.has_moved(t))
      for (const std::uint32_t v : mesh.corners(t)) common[v] = wanted | facing_all;

  // By triangle.
  Array<std::uint8_t> faced(count);
  const std::size_t batch = grid::long_stretch(count, 1024);
  grid::in_stretches(count, batch, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t) {
      const auto c = mesh.corners(t);
      if ((common[c[0]] | common[c[1]] | common[c[2]]) != 0)
        faced[t] = static_cast<std::uint8_t>(wanted | facing(mesh.triangle(t)));
    }
  });

  for (std::uint32_t t = 0; t < count; ++t)
    if (faced[t] != 0)
      for (const std::uint32_t v : mesh.corners(t)) common[v] &= faced[t];
  for (std::uint8_t& c : common) c = (c & facing_all) != 0;
  return common;
}

}  // namespace quoin::booleans
