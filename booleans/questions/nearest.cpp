#include "booleans/questions/nearest.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "exact/counters.h"

namespace quoin::booleans {
namespace {

using exact::Rational;
using Doubles = std::array<double, 3>;

Rational inner_product_of(const RationalPoint& u, const RationalPoint& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}
RationalPoint way_between(const RationalPoint& u, const RationalPoint& v) {
  return {Rational(u[0] - v[0]), Rational(u[1] - v[1]), Rational(u[2] - v[2])};
}
RationalPoint moved_along(const RationalPoint& u, const RationalPoint& d, const Rational& t) {
  return {Rational(u[0] + t * d[0]), Rational(u[1] + t * d[1]), Rational(u[2] + t * d[2])};
}
RationalPoint vector_product(const RationalPoint& u, const RationalPoint& v) {
  return {Rational(u[1] * v[2] - u[2] * v[1]), Rational(u[2] * v[0] - u[0] * v[2]),
          Rational(u[0] * v[1] - u[1] * v[0])};
}

RationalPoint nearest_on_segment(const RationalPoint& u, const RationalPoint& v, const RationalPoint& p) {
  const RationalPoint d = way_between(v, u);
  const Rational t = inner_product_of(way_between(p, u), d) / inner_product_of(d, d);
  return t <= 0 ? u : t >= 1 ? v : moved_along(u, d, t);
}

/// Of a closed triangle: the foot of the perpendicular where that is in it, else on its edges.
RationalPoint nearest_on_triangle(const std::array<RationalPoint, 3>& c, const RationalPoint& p) {
  const RationalPoint n = vector_product(way_between(c[1], c[0]), way_between(c[2], c[0]));
  const Rational height = inner_product_of(n, way_between(p, c[0]));
  const RationalPoint foot = moved_along(p, n, -height / inner_product_of(n, n));
  const auto is_left = [&](const RationalPoint& u, const RationalPoint& v) {
    return inner_product_of(n, vector_product(way_between(v, u), way_between(foot, u))) >= 0;
  };
  if (is_left(c[0], c[1]) && is_left(c[1], c[2]) && is_left(c[2], c[0])) return foot;

  RationalPoint best;
  std::optional<Rational> least;
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint q = nearest_on_segment(c[i], c[i < 2 ? i + 1 : 0], p), d = way_between(p, q);
    const Rational squared = inner_product_of(d, d);
    if (least && squared >= *least) continue;
    least = squared;
    best = q;
  }
  return best;
}

double inner_product_of(const Doubles& u, const Doubles& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
Doubles way_between(const Doubles& u, const Doubles& v) { return {u[0] - v[0], u[1] - v[1], u[2] - v[2]}; }
Doubles vector_product(const Doubles& u, const Doubles& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// About the vector from the triangle's nearest point to the origin: a direction in which it is far.
Doubles way_from_triangle(const std::array<Doubles, 3>& c) {
  const Doubles n = vector_product(way_between(c[1], c[0]), way_between(c[2], c[0]));
  const auto is_left = [&](const Doubles& u, const Doubles& v) {
    return inner_product_of(n, vector_product(u, v)) >= 0;
  };
  if (is_left(c[0], c[1]) && is_left(c[1], c[2]) && is_left(c[2], c[0])) {
    const double t = -inner_product_of(n, c[0]) / inner_product_of(n, n);
    return {t * n[0], t * n[1], t * n[2]};
  }

  Doubles best{};
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < 3; ++i) {
    const Doubles &u = c[i], d = way_between(c[i < 2 ? i + 1 : 0], u);
    const double t = std::clamp(-inner_product_of(u, d) / inner_product_of(d, d), 0.0, 1.0);
    const Doubles way{-u[0] - t * d[0], -u[1] - t * d[1], -u[2] - t * d[2]};
    const double squared = inner_product_of(way, way);
    if (squared < least) least = squared, best = way;
  }
  return best;
}

/// Looks at boxes and triangles in order of lower bounds of their distances, until none can be nearer than what was
/// found.
class NearestSearch {
 public:
  NearestSearch(const Index& index, const QueryPoint& from)
      : index_(index), p_(from.rational()), near_(from.near()), is_tame_(true) {
    for (const Interval& x : near_) is_tame_ = is_tame_ && x.low > -0x1p300 && x.high < 0x1p300;
  }

  /// Precondition: there is a boundary.
  Nearest run() {
    const BoxTree& tree = index_.tree();
    const auto add_nodes = [&](std::size_t level, std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t x = begin; x < std::min(end, tree.node_count(level)); ++x)
        queue_.push({lower_bound(tree.node_box(level, x)), Step::open, level, x});
    };
    const std::size_t top = tree.level_count() - 1;
    add_nodes(top, 0, tree.node_count(top));

    while (!queue_.empty() && queue_.top().bound <= limit_) {
      const Candidate c = queue_.top();
      queue_.pop();
      if (c.step == Step::measure)
        measure(c.node);
      else if (c.level > 0)
        add_nodes(c.level - 1, c.node * BoxBlock::width, (c.node + 1) * BoxBlock::width);
      else
        queue_.push({std::max(c.bound, lower_bound(tree.ids()[c.node])), Step::measure, 0, tree.ids()[c.node]});
    }

    auto& faces = best_->faces;
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return *std::move(best_);
  }

 private:
  enum class Step {
    open,    // a node of the tree
    measure  // a triangle
  };
  struct Candidate {
    double bound;  // not above its squared distance
    Step step;
    std::size_t level;
    std::uint32_t node;
    bool operator<(const Candidate& c) const { return bound > c.bound; }
  };

  double lower_bound(const Box& box) const {
    if (!is_tame_) return 0;
    Interval squared = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double gap = std::max({(Interval(box.low[k]) - near_[k]).low, (near_[k] - Interval(box.high[k])).low, 0.0});
      if (gap > 0) squared = squared + Interval(gap) * Interval(gap);
    }
    return squared.low;
  }

  /// No point of the triangle is nearer: with g any vector, its points x have |p - x| >= g . (p - x) / |g|, which is
  /// least at a corner.
  double lower_bound(std::uint32_t t) const {
    if (!is_tame_) return 0;
    std::array<IntervalPoint, 3> seen{IntervalPoint{0, 0, 0}, IntervalPoint{0, 0, 0}, IntervalPoint{0, 0, 0}};
    std::array<Doubles, 3> about{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = index_.corners(t)[i];
      const auto a = index_.body().approximation(v);
      for (std::size_t k = 0; k < 3; ++k) {
        seen[i][k] = (index_.body().is_grid(v) ? Interval(a[k]) : Interval::around(a[k])) - near_[k];
        about[i][k] = seen[i][k].low;
      }
    }
    const Doubles g = way_from_triangle(about);
    double least = HUGE_VAL;
    for (const IntervalPoint& s : seen) least = std::min(least, (-(s[0] * g[0] + s[1] * g[1] + s[2] * g[2])).low);
    const Interval squared = Interval(g[0]) * g[0] + Interval(g[1]) * g[1] + Interval(g[2]) * g[2];
    if (!(least > 0) || !(squared.low > 0)) return 0;
    return (Interval(least) * least / squared).low;
  }

  void measure(std::uint32_t t) {
    ++exact::counters().rational;
    std::array<RationalPoint, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const exact::Point v = index_.body().point(index_.corners(t)[i]);
      corners[i] = {exact::coordinate(v, 0), exact::coordinate(v, 1), exact::coordinate(v, 2)};
    }
    RationalPoint q = nearest_on_triangle(corners, p_);
    const RationalPoint d = way_between(p_, q);
    Rational squared = inner_product_of(d, d);

    const bool is_equal = best_ && squared == best_->squared_distance;
    if (is_equal && q == best_->point) best_->faces.push_back(index_.face_name(t));
    if (best_ && (is_equal ? q >= best_->point : squared > best_->squared_distance)) return;
    limit_ = enclosure(squared).high;
    best_ = Nearest{std::move(squared), std::move(q), {index_.face_name(t)}};
  }

  const Index& index_;
  const RationalPoint p_;
  const IntervalPoint near_;
  bool is_tame_;
  std::priority_queue<Candidate> queue_;  // the least bound first
  double limit_ = HUGE_VAL;               // not below the squared distance found
  std::optional<Nearest> best_;
};

}  // namespace

std::optional<Nearest> nearest(const Index& index, const QueryPoint& from) {
  if (index.triangle_count() == 0) return std::nullopt;
  return NearestSearch(index, from).run();
}

}  // namespace quoin::booleans
