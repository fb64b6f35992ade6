#include "booleans/stars.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "booleans/fans.h"
#include "grid/balance.h"

namespace quoin::booleans {
namespace {

using Vector = std::array<std::int64_t, 3>;  // differences of grid points, at most 2^30

Vector difference(const exact::GridPoint& a, const exact::GridPoint& b) {
  return {std::int64_t{a[0]} - b[0], std::int64_t{a[1]} - b[1], std::int64_t{a[2]} - b[2]};
}

/// The k-th component of u x v: at most 2^61.
std::int64_t cross(const Vector& u, const Vector& v, std::size_t k) {
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  return u[i] * v[j] - u[j] * v[i];
}

class Stars {
 public:
  explicit Stars(const Body& mesh) : mesh_(mesh) {}

  std::vector<Star> run() {
    look_along_axes();
    for (std::uint32_t v = 0; v < star_.size(); ++v)
      if (star_[v] == Star::other) unproved_.push_back(v);
    if (!unproved_.empty()) look_at_the_rest();
    return std::move(star_);
  }

 private:
  /// Bit 2k: seen against +k the triangle turns counter-clockwise; bit 2k + 1: against -k.
  std::uint8_t views(const std::array<std::uint32_t, 3>& t) const {
    const auto& p = mesh_.grid_points;
    const Vector u = difference(p[t[1]], p[t[0]]), v = difference(p[t[2]], p[t[0]]);
    unsigned r = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t n = cross(u, v, k);
      r |= static_cast<unsigned>(n > 0) << (2 * k) | static_cast<unsigned>(n < 0) << (2 * k + 1);
    }
    return static_cast<std::uint8_t>(r);
  }

  void look_along_axes() {
    std::vector<std::uint8_t> common(mesh_.grid_points.size(), 63);  // views that all triangles of the star allow
    for (const auto& t : mesh_.triangles) {
      const std::uint8_t allowed = views(t);
      for (std::uint32_t v : t) common[v] &= allowed;
    }
    // The ray runs along the axis that follows k: a counter-clockwise triangle (v, a, b) has it in its sector when a is
    // on or below it and b above, in the axis after that.
    std::vector<std::uint8_t> over(mesh_.grid_points.size());  // sectors over the ray, at most 2
    for (const auto& t : mesh_.triangles)
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t v = t[c];
        if (common[v] == 0) continue;
        const auto view = static_cast<std::size_t>(std::countr_zero(common[v]));
        const std::size_t up = (view / 2 + 2) % 3;
        std::uint32_t a = t[(c + 1) % 3], b = t[(c + 2) % 3];
        if (view & 1) std::swap(a, b);  // seen from the other side, mirrored
        const std::int32_t at = mesh_.grid_points[v].c[up];
        if (mesh_.grid_points[a].c[up] <= at && at < mesh_.grid_points[b].c[up])
          over[v] |= static_cast<std::uint8_t>(over[v] + 1);
      }
    star_.resize(mesh_.grid_points.size());
    for (std::size_t v = 0; v < star_.size(); ++v)
      star_[v] = common[v] == 63 || (common[v] != 0 && over[v] == 1) ? Star::embedded : Star::other;
  }

  void look_at_the_rest() {
    Spokes spokes(grid::corners_of(mesh_.triangles), star_.size(),
                  [&](std::uint32_t v) { return star_[v] == Star::other; });
    for (const std::uint32_t v : unproved_) {
      const std::span<Spoke> star = spokes.at(v);
      if (is_one_fan(star)) star_[v] = is_embedded(v, star) ? Star::embedded : Star::ring;
    }
  }

  /// Along the sum of the normals, rounded to integers of at most 2^8: normals are below 2^62, so n . d is below 2^72;
  /// projected differences are at most 2^39.
  bool is_embedded(std::uint32_t v, std::span<const Spoke> star) const {
    const auto& p = mesh_.grid_points;
    std::array<double, 3> sum{};
    for (const Spoke& s : star) {
      const Vector a = difference(p[s.a], p[v]), b = difference(p[s.b], p[v]);
      std::array<double, 3> n{};
      for (std::size_t k = 0; k < 3; ++k) n[k] = static_cast<double>(cross(a, b, k));
      const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
      for (std::size_t k = 0; k < 3; ++k) sum[k] += n[k] / length;
    }
    const double largest = std::max({std::fabs(sum[0]), std::fabs(sum[1]), std::fabs(sum[2])});
    if (!(largest > 1e-6)) return false;
    Vector d{};
    for (std::size_t k = 0; k < 3; ++k) d[k] = std::lround(sum[k] / largest * 256);
    std::size_t k = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (std::abs(d[i]) > std::abs(d[k])) k = i;
    const std::size_t up = (k + 2) % 3;
    int over = 0;
    for (const Spoke& s : star) {
      const Vector a = difference(p[s.a], p[v]), b = difference(p[s.b], p[v]);
      exact::int128 turn = 0;
      for (std::size_t i = 0; i < 3; ++i) turn += exact::int128(cross(a, b, i)) * d[i];
      if (turn <= 0) return false;
      // Height over the ray in the view against d, times |d_k|; the view is mirrored where d_k < 0.
      const std::int64_t sign = d[k] < 0 ? -1 : 1;
      const std::int64_t above_a = sign * (a[up] * d[k] - a[k] * d[up]), above_b = sign * (b[up] * d[k] - b[k] * d[up]);
      over += d[k] < 0 ? (above_b <= 0 && above_a > 0) : (above_a <= 0 && above_b > 0);
    }
    return over == 1;
  }

  const Body& mesh_;
  std::vector<Star> star_;
  std::vector<std::uint32_t> unproved_;
};

}  // namespace

std::vector<Star> stars(const Body& mesh) { return Stars(mesh).run(); }

}  // namespace quoin::booleans
