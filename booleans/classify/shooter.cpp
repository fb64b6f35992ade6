#include "booleans/classify/shooter.h"

#include <map>
#include <numeric>

#include "booleans/classify/interval.h"

namespace quoin::booleans {
namespace {

/// Is the plane (p_y > 0) below s: is p(s) > 0? Its terms are p(v), p . d, then -p_y < 0.
bool in_front(const exact::Plane& p, const RayStart& s) {
  if (const int at_v = exact::side(p, s.v)) return at_v > 0;
  return dot(p, s.d).sign() > 0;
}

/// Is p met before q? The distances p(s) / p_y and q(s) / q_y compare term by term; those of t^2 are equal.
bool nearer(const exact::Plane& p, const exact::Plane& q, const RayStart& s) {
  const exact::Coefficient py(p.n[1]), qy(q.n[1]);
  ++exact::counters().fixed_width;
  if (const int c = exact::compare(exact::scaled_value(p, s.v) * qy, exact::scaled_value(q, s.v) * py)) return c < 0;
  if (const int c = exact::compare(dot(p, s.d) * qy, dot(q, s.d) * py)) return c < 0;
  if (const int c = exact::compare(exact::Coefficient(p.n[2]) * qy, exact::Coefficient(q.n[2]) * py)) return c > 0;
  return exact::compare(exact::Coefficient(p.n[0]) * qy, exact::Coefficient(q.n[0]) * py) < 0;
}

/// What the ray goes through. In x and z that is, for an infinitely small shift, the space between two whole numbers:
/// low and high are the upper and the lower one, so that boxes meet it that reach over it.
/// Of a point off the grid whose rounded coordinate is whole nobody knows on which side of it that is.
Box box_of(const RayStart& s) {
  Box ray;
  ray.add(s.v.approximation);
  ray.low[1] = INT32_MIN;
  const bool is_grid = exact::is_grid(s.v);
  for (const std::size_t k : {std::size_t{0}, std::size_t{2}}) {
    const std::int32_t whole = static_cast<std::int32_t>(std::floor(s.v.approximation[k]));
    if (!is_grid && whole == s.v.approximation[k]) continue;
    const bool is_below = is_grid && k == 2 && s.d[2].sign() <= 0;
    ray.high[k] = whole - is_below;
    ray.low[k] = ray.high[k] + 1;
  }
  return ray;
}
/// Box of all rays, for boxes of rounded coordinates.
Box region(std::span<const Ray> rays) {
  Box all;
  for (const Ray& r : rays) all.add(r.start.v.approximation);
  all.low[1] = INT32_MIN;
  return all;
}

Interval coordinate(const Arrangement& a, AnyVertex v, std::size_t k) {
  const double x = v.approximation(a)[k];
  return v.is_grid(a) ? Interval(x) : Interval::around(x);
}
Interval coefficient(double rounded) { return Interval::around(rounded); }

/// The y of a plane (p_y > 0), or of a parallel one: where n_x x + n_y y + n_z z + d = 0.
Interval height(const std::array<std::int64_t, 3>& n, const Interval& d, const Interval& x, const Interval& z) {
  const auto of = [&](std::size_t k) { return coefficient(static_cast<double>(n[k])); };
  return -(of(0) * x + of(2) * z + d) / of(1);
}

/// The direction from one vertex to another.
struct Sight {
  Interval dx, y, z;  // y = dy/dx and z = dz/dx, where dx > 0

  Sight(const Arrangement& a, AnyVertex from, AnyVertex to) : dx(difference(a, from, to, 0)), y(0), z(0) {
    if (dx.low <= 0) return;
    y = difference(a, from, to, 1) / dx;
    z = difference(a, from, to, 2) / dx;
  }
  /// Surely.
  bool is_ahead() const { return dx.low > 0; }

 private:
  static Interval difference(const Arrangement& a, AnyVertex from, AnyVertex to, std::size_t k) {
    const Interval u = coordinate(a, from, k), v = coordinate(a, to, k);
    // Coordinates of grid points are small integers.
    return from.is_grid(a) && to.is_grid(a) ? Interval(v.low - u.low) : v - u;
  }
};

/// Slopes s as whole numbers: the floors of s / (1 + |s|) in units of 2^-30, or one of a little less, or a little more.
Interval squeezed(double s) { return Interval(s) / (Interval(1) + Interval(std::fabs(s))); }
std::int32_t whole(double x) { return static_cast<std::int32_t>(std::floor(std::ldexp(x, 30))); }
std::int32_t low_of(const Interval& slope) { return whole(squeezed(slope.low).low); }
std::int32_t high_of(const Interval& slope) { return whole(squeezed(slope.high).high); }

/// As a box: dz/dx along x, dy/dx along y.
Box box_of(const Sight& s) { return {{low_of(s.z), low_of(s.y), 0}, {high_of(s.z), high_of(s.y), 0}}; }

constexpr Box anywhere{{INT32_MIN, INT32_MIN, 0}, {INT32_MAX, INT32_MAX, 0}};

}  // namespace

Shooter::Shooter(const Arrangement& a, std::span<const Ray> rays) : a_(a), targets_(a, region(rays)) {
  if (rays.size() > grid::thresholds().few_rays) {
    find_hubs(rays);
    plant();
  }
  prepare(rays);
}

void Shooter::find_hubs(std::span<const Ray> rays) {
  std::unordered_map<AnyVertex, std::size_t, Hash> count;
  for (const Ray& r : rays)
    if (++count[r.v] == grid::thresholds().few_rays + 1) {
      number_of_.emplace(r.v, static_cast<std::uint32_t>(hubs_.size()));
      hubs_.push_back(r.v);
    }
}

std::uint32_t Shooter::hub_at(AnyVertex v) const {
  const auto at = number_of_.find(v);
  return at != number_of_.end() ? at->second : none;
}

std::vector<std::uint32_t> Shooter::hubs_of(std::uint32_t t) const {
  std::vector<std::uint32_t> hubs;
  if (hubs_.empty()) return hubs;
  targets_.for_corners(t, [&](AnyVertex v) {
    if (const std::uint32_t h = hub_at(v); h != none) hubs.push_back(h);
  });
  std::sort(hubs.begin(), hubs.end());
  hubs.erase(std::unique(hubs.begin(), hubs.end()), hubs.end());
  return hubs;
}

/// The slopes in which a target with that corner is seen; nothing where all of it has x <= the hub's.
std::optional<Box> Shooter::seen_from(AnyVertex hub, std::uint32_t t) const {
  Box box;
  bool reaches_ahead = false, is_all_ahead = true;
  targets_.for_corners(t, [&](AnyVertex v) {
    if (v == hub) return;
    const Sight sight(a_, hub, v);
    reaches_ahead |= sight.dx.high > 0;
    is_all_ahead &= sight.is_ahead();
    if (sight.is_ahead()) box.add(box_of(sight));
  });
  if (!reaches_ahead) return std::nullopt;
  return is_all_ahead ? box : anywhere;
}

void Shooter::plant() {
  std::vector<Array<BoxTree::Item>> seen(hubs_.size());
  std::map<std::vector<std::uint32_t>, Array<BoxTree::Item>> bundles;
  for (std::uint32_t t = 0; t < targets_.size(); ++t) {
    const auto hubs = hubs_of(t);
    bundles[hubs].push_back({targets_.box(t), t, t});
    for (const std::uint32_t h : hubs)
      if (const auto box = seen_from(hubs_[h], t)) seen[h].push_back({*box, t, t});
  }
  for (const auto& items : seen) seen_from_.emplace_back(items);

  Array<BoxTree::Item> boxes;
  for (const auto& [hubs, items] : bundles) {
    const auto number = static_cast<std::uint32_t>(bundles_.size());
    bundles_.push_back({hubs, BoxTree(items)});
    Box& all = boxes.emplace_back(BoxTree::Item{{}, number, number}).box;
    for (const BoxTree::Item& i : items) all.add(i.box);
  }
  bundle_tree_.emplace(boxes);
}

/// For what the rays may meet; where many components stand above each other that is all.
void Shooter::prepare(std::span<const Ray> rays) {
  std::vector<std::uint32_t> wanted;
  const std::size_t many = 2 * targets_.size();
  for (std::size_t i = 0; i < rays.size() && wanted.size() <= many; ++i)
    for_places(box_of(rays[i].start), none, [&](std::uint32_t t) { wanted.push_back(t); });
  if (wanted.size() > many) {
    wanted.resize(targets_.size());
    std::iota(wanted.begin(), wanted.end(), 0u);
  }
  targets_.prepare(wanted);
}

template <class Visit>
void Shooter::for_places(const Box& ray, std::uint32_t hub, Visit&& visit) const {
  if (!bundle_tree_) {
    for (std::uint32_t t = 0; t < targets_.size(); ++t)
      if (targets_.box(t).meets(ray)) visit(t);
    return;
  }
  bundle_tree_->meeting(ray, [&](std::uint32_t b) {
    const auto& hubs = bundles_[b].hubs;
    if (!std::binary_search(hubs.begin(), hubs.end(), hub)) bundles_[b].places.meeting(ray, visit);
  });
}

bool Shooter::hits(std::uint32_t t, const RayStart& s, Hit& hit) {
  bool turned = false;
  exact::Plane p = targets_.plane(t, turned);
  if (p.n[1] == 0) return false;
  if (p.n[1] < 0) {
    p = p.opposite();
    turned = !turned;
  }
  if (!in_front(p, s) || (hit.target != none && !nearer(p, hit.plane, s)) || !targets_.crossed(t, p, s)) return false;
  hit = {t, p, turned};
  return true;
}

SideId Shooter::first_hit(const Ray& ray) {
  const RayStart& s = ray.start;
  const std::uint32_t hub = hub_at(ray.v);
  Hit hit;
  Box way = box_of(s);

  if (hub != none) {
    const Sight sight(a_, ray.v, ray.w);
    Box slopes = sight.is_ahead() ? box_of(sight) : anywhere;
    slopes.low[1] = INT32_MIN;
    seen_from_[hub].meeting(slopes, [&](std::uint32_t t) {
      if (!targets_.box(t).meets(way) || !hits(t, s, hit)) return;
      way.low[1] = static_cast<std::int32_t>(std::floor(s.v.approximation[1])) - 1;  // infinitely near to v
      if (sight.is_ahead()) slopes.low[1] = low_of(height(hit.plane.n, 0, 1, sight.z));
    });
  }

  for_places(way, hub, [&](std::uint32_t t) {
    if (!hits(t, s, hit)) return;
    // Nothing below is nearer.
    const Interval d = coefficient(static_cast<double>(hit.plane.d));
    const double low = height(hit.plane.n, d, coordinate(a_, ray.v, 0), coordinate(a_, ray.v, 2)).low;
    way.low[1] = std::max(way.low[1], targets_.box(t).low[1]);
    if (low > way.low[1]) way.low[1] = static_cast<std::int32_t>(std::floor(low));
  });
  if (hit.target == none) return none;
  // The ray comes down on the side that looks towards +y.
  return hit.turned ? back_of(targets_.node(hit.target)) : front_of(targets_.node(hit.target));
}

}  // namespace quoin::booleans
