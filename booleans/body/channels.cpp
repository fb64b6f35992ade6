#include "booleans/body/channels.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "exact/predicates.h"
#include "grid/lists/buckets.h"
#include "grid/repair/surface.h"

namespace quoin::booleans {

using exact::GridPoint;
using exact::Rational;

PositionMap composed(const PositionMap& first, const PositionMap& second) {
  PositionMap map;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t j = 0; j < 4; ++j) {
      map[k][j] = j == 3 ? second[k][3] : Rational(0);
      for (std::size_t i = 0; i < 3; ++i) map[k][j] += second[k][i] * first[i][j];
    }
  return map;
}

bool is_identity(const PositionMap& map) {
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t j = 0; j < 4; ++j)
      if (map[k][j] != (j == k ? 1 : 0)) return false;
  return true;
}

PositionMap to_model(const grid::Lattice& lattice) {
  PositionMap map;
  for (std::size_t k = 0; k < 3; ++k) {
    map[k][k] = lattice.step;
    map[k][3] = lattice.origin[k];
  }
  return map;
}

PositionMap to_steps(const grid::Lattice& lattice) {
  PositionMap map;
  for (std::size_t k = 0; k < 3; ++k) {
    map[k][k] = 1 / lattice.step;
    map[k][3] = -lattice.origin[k] / lattice.step;
  }
  return map;
}

namespace {

/// Twice the area of a triangle seen along an axis; below 2^62.
std::int64_t seen_area(const GridPoint& p, const GridPoint& q, const GridPoint& r, int axis) {
  const auto u = static_cast<std::size_t>(axis + 1) % 3, v = static_cast<std::size_t>(axis + 2) % 3;
  const std::int64_t a = std::int64_t{q.c[u]} - p.c[u], b = std::int64_t{q.c[v]} - p.c[v],
                     c = std::int64_t{r.c[u]} - p.c[u], d = std::int64_t{r.c[v]} - p.c[v];
  return a * d - b * c;
}

/// The sum of weights times values over a divisor, correctly rounded.
double exact_mean(const std::array<Rational, 3>& weights, const std::array<double, 3>& values,
                  const Rational& divisor) {
  Rational sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += weights[i] * exact::to_rational(values[i]);
  return exact::to_double(Rational(sum / divisor));
}

/// The same of integers below 2^62, if a wider number tells; else NaN. Three products and two sums and a quotient, each
/// rounded by u = 2^-p with p the digits of long double: the error is below 7 u times the sum of the terms' sizes over
/// the divisor. A magnitude that may have lost digits to underflow is left to `exact_mean`.
double filtered_mean(const std::array<std::int64_t, 3>& weights, const std::array<double, 3>& values,
                     std::int64_t divisor) {
  using Wide = long double;
  Wide sum = 0, size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Wide term = static_cast<Wide>(weights[i]) * static_cast<Wide>(values[i]);
    sum += term;
    size += std::fabs(term);
  }
  const Wide value = sum / static_cast<Wide>(divisor);
  const Wide error = 8 * std::numeric_limits<Wide>::epsilon() * size / std::fabs(static_cast<Wide>(divisor));
  const auto low = static_cast<double>(value - error), high = static_cast<double>(value + error);
  const bool is_decided = std::numeric_limits<Wide>::digits > 62 && low == high && std::fabs(high) > 0x1p-900;
  return is_decided ? high : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::optional<Channels::Seed> seed_of(const std::array<GridPoint, 3>& corners) {
  Channels::Seed seed{corners};
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t area = seen_area(corners[0], corners[1], corners[2], axis);
    if (std::abs(area) <= std::abs(seed.area)) continue;
    seed.axis = axis;
    seed.area = area;
  }
  return seed.area != 0 ? std::optional(seed) : std::nullopt;
}

void Channels::at(std::uint32_t surface, const GridPoint& place, std::span<double> out) const {
  const auto& [corners, axis, area] = seeds[surface];
  std::array<std::int64_t, 3> weights{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (place == corners[i]) return void(std::ranges::copy(corner_values(surface, i), out.begin()));
    weights[i] = seen_area(place, corners[(i + 1) % 3], corners[(i + 2) % 3], axis);
  }

  for (std::size_t c = 0; c < count; ++c) {
    std::array<double, 3> v{};
    for (std::size_t i = 0; i < 3; ++i) v[i] = corner_values(surface, i)[c];
    out[c] = filtered_mean(weights, v, area);
    if (std::isnan(out[c])) out[c] = exact_mean({weights[0], weights[1], weights[2]}, v, area);
  }
}

void Channels::at(std::uint32_t surface, const std::array<Rational, 3>& place, std::span<double> out) const {
  const auto& [corners, axis, area] = seeds[surface];
  const auto u = static_cast<std::size_t>(axis + 1) % 3, v = static_cast<std::size_t>(axis + 2) % 3;
  std::array<Rational, 3> weights;
  for (std::size_t i = 0; i < 3; ++i) {
    const GridPoint &p = corners[(i + 1) % 3], &q = corners[(i + 2) % 3];
    weights[i] = (p.c[u] - place[u]) * (q.c[v] - place[v]) - (p.c[v] - place[v]) * (q.c[u] - place[u]);
  }
  for (std::size_t c = 0; c < count; ++c) {
    const std::array<double, 3> values{corner_values(surface, 0)[c], corner_values(surface, 1)[c],
                                       corner_values(surface, 2)[c]};
    out[c] = exact_mean(weights, values, area);
  }
}

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Works out the surfaces of one mesh.
class Surfaces {
 public:
  Surfaces(const ChannelInput& input, std::span<const GridPoint> points, std::span<const Triangle> triangles,
           std::span<const std::uint32_t> sources, const Origin& origin)
      : input_(input), points_(points), triangles_(triangles), sources_(sources), origin_(origin) {
    find_allowances();
    seeds_.resize(origin.faces);
    for (std::uint32_t f = 0; f < origin.faces; ++f) seeds_[f] = find_seed(f);
  }

  /// A polygon whose channels are no affine function.
  std::optional<std::uint32_t> bent_face() const {
    for (std::uint32_t f = 0; f < origin_.faces; ++f) {
      if (!seeds_[f] || size_of(f) == 3) continue;
      for (std::uint32_t i = 0; i < size_of(f); ++i)
        if (!is_value(*seeds_[f], input_.points[corner(f, i)], first(f) + i)) return f;
    }
    return std::nullopt;
  }

  void give(Origin& origin) {
    find_neighbours();
    grid::Buckets<> of_source = grid::in_buckets(triangles_.size(), origin_.faces + std::size_t{1},
                                                 [&](std::uint32_t t) { return std::min(sources_[t], origin_.faces); });
    origin.surfaces.assign(origin.faces, none_);
    auto channels = std::make_shared<Channels>();
    channels->count = input_.count;
    channels->to_seeds = to_steps(input_.lattice);
    for (std::uint32_t f = 0; f < origin.faces; ++f) {
      if (origin.surfaces[f] != none_) continue;
      const auto surface = static_cast<std::uint32_t>(channels->seeds.size());
      origin.surfaces[f] = surface;
      add(seeds_[f], *channels);
      if (seeds_[f]) grow(f, surface, of_source, origin.surfaces);
    }
    origin.channels = std::move(channels);
  }

 private:
  static constexpr std::uint32_t none_ = UINT32_MAX;
  /// A seed and the corners of the input that it has.
  struct Rooted : Channels::Seed {
    std::array<std::uint32_t, 3> corners_of_input;
  };

  std::uint32_t first(std::uint32_t f) const { return input_.starts.empty() ? 3 * f : input_.starts[f]; }
  std::uint32_t size_of(std::uint32_t f) const {
    return input_.starts.empty() ? 3 : input_.starts[f + 1] - input_.starts[f];
  }
  std::uint32_t corner(std::uint32_t f, std::uint32_t i) const { return input_.corners[first(f) + i]; }
  double value(std::uint32_t corner, std::size_t channel) const {
    return input_.values[std::size_t{corner} * input_.count + channel];
  }

  void find_allowances() {
    for (std::size_t c = 0; c < input_.count; ++c) {
      double low = 0, high = 0;
      for (std::size_t i = 0; i < input_.corners.size(); ++i) {
        const double v = value(static_cast<std::uint32_t>(i), c);
        low = i == 0 ? v : std::min(low, v);
        high = i == 0 ? v : std::max(high, v);
      }
      allowance_.push_back(input_.tolerance * (high - low));
    }
  }

  /// Of the first corners that span a plane.
  std::optional<Rooted> find_seed(std::uint32_t f) const {
    for (std::uint32_t i = 1; i + 1 < size_of(f); ++i) {
      const auto seed =
          seed_of({input_.points[corner(f, 0)], input_.points[corner(f, i)], input_.points[corner(f, i + 1)]});
      if (seed) return Rooted{*seed, {first(f), first(f) + i, first(f) + i + 1}};
    }
    return std::nullopt;
  }

  /// Does a seed's function have the values of a corner of the input in a point, but for the tolerance?
  bool is_value(const Rooted& seed, const GridPoint& p, std::uint32_t corner) const {
    std::array<double, 3> weights{};
    for (std::size_t i = 0; i < 3; ++i)
      weights[i] = static_cast<double>(seen_area(p, seed.corners[(i + 1) % 3], seed.corners[(i + 2) % 3], seed.axis)) /
                   static_cast<double>(seed.area);
    for (std::size_t c = 0; c < input_.count; ++c) {
      double expected = 0;
      for (std::size_t i = 0; i < 3; ++i) expected += weights[i] * value(seed.corners_of_input[i], c);
      if (!(std::fabs(expected - value(corner, c)) <= allowance_[c])) return false;
    }
    return true;
  }

  void find_neighbours() {
    neighbour_.assign(3 * triangles_.size(), none_);
    const grid::Array<grid::EdgeUse> uses = grid::edge_uses(triangles_);
    grid::for_edges(uses, [&](std::span<const grid::EdgeUse> edge) {
      if (edge.size() != 2 || edge[0].way == edge[1].way) return;
      neighbour_[edge[0].half] = edge[1].triangle();
      neighbour_[edge[1].half] = edge[0].triangle();
    });
  }

  bool are_on_one_plane(const Triangle& s, const Triangle& t) const {
    const auto p = [&](std::uint32_t v) -> const GridPoint& { return points_[v]; };
    for (const std::uint32_t v : t)
      if (exact::orientation(p(s[0]), p(s[1]), p(s[2]), p(v)) != 0) return false;
    return exact::dot_sign(exact::spanned_plane(p(s[0]), p(s[1]), p(s[2])),
                           exact::spanned_plane(p(t[0]), p(t[1]), p(t[2]))) > 0;
  }

  bool is_of_surface(const Rooted& seed, std::uint32_t root, std::uint32_t face) const {
    if (!seeds_[face] || origin_.label(face) != origin_.label(root)) return false;
    const Rooted& other = *seeds_[face];
    for (std::size_t i = 0; i < 3; ++i)
      if (!is_value(seed, other.corners[i], other.corners_of_input[i])) return false;
    return true;
  }

  /// Gives a surface the faces that go on from its first one.
  void grow(std::uint32_t root, std::uint32_t surface, const grid::Buckets<>& of_source,
            grid::Array<std::uint32_t>& surfaces) const {
    grid::Array<std::uint32_t> faces{root};
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (const std::uint32_t t : of_source[faces[i]])
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t n = neighbour_[3 * std::size_t{t} + k];
          if (n == none_ || sources_[n] >= origin_.faces || surfaces[sources_[n]] != none_) continue;
          if (!are_on_one_plane(triangles_[t], triangles_[n]) || !is_of_surface(*seeds_[root], root, sources_[n]))
            continue;
          surfaces[sources_[n]] = surface;
          faces.push_back(sources_[n]);
        }
  }

  /// A face without area has a surface that nobody asks for.
  void add(const std::optional<Rooted>& seed, Channels& channels) const {
    channels.seeds.push_back(seed ? static_cast<const Channels::Seed&>(*seed) : Channels::Seed{});
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t c = 0; c < input_.count; ++c)
        channels.values.push_back(seed ? value(seed->corners_of_input[i], c) : 0.0);
  }

  const ChannelInput& input_;
  const std::span<const GridPoint> points_;
  const std::span<const Triangle> triangles_;
  const std::span<const std::uint32_t> sources_;
  const Origin& origin_;
  grid::Array<double> allowance_;             // by channel
  grid::Array<std::optional<Rooted>> seeds_;  // by face
  grid::Array<std::uint32_t> neighbour_;      // over edge 3 t + k
};

}  // namespace

std::optional<std::uint32_t> add_channels(const ChannelInput& input, std::span<const GridPoint> points,
                                          std::span<const Triangle> triangles, std::span<const std::uint32_t> sources,
                                          Origin& origin) {
  Surfaces surfaces(input, points, triangles, sources, origin);
  if (const auto face = surfaces.bent_face()) return face;
  surfaces.give(origin);
  return std::nullopt;
}

std::shared_ptr<const Origins> carried(const std::shared_ptr<const Origins>& origins, const PositionMap& back) {
  const auto has_channels = [&](std::uint32_t i) { return (*origins)[i] && (*origins)[i]->channels; };
  bool any = false;
  for (std::uint32_t i = 0; origins && i < origins->size(); ++i) any = any || has_channels(i);
  if (!any) return origins;

  auto moved = std::make_shared<Origins>();
  for (std::uint32_t i = 0; i < origins->size(); ++i) {
    Origins::Pointer origin = (*origins)[i];
    if (has_channels(i)) {
      auto channels = std::make_shared<Channels>(*origin->channels);
      channels->to_seeds = composed(back, channels->to_seeds);
      auto copy = std::make_shared<Origin>(*origin);
      copy->channels = std::move(channels);
      origin = std::move(copy);
    }
    moved->add(origin);
  }
  moved->set_order(origins->in_order());
  return moved;
}

}  // namespace quoin::booleans
