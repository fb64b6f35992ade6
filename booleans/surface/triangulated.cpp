#include "booleans/surface/triangulated.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <optional>

#include "booleans/arrangement/frame.h"
#include "booleans/surface/triangulate.h"
#include "exact/predicates.h"
#include "grid/balance.h"
#include "grid/lists/kept.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {
namespace {

/// At least n items; those that are there stay.
template <class T>
void make_room(Array<T>& list, std::size_t n) {
  if (list.size() < n) list.resize(n);
}

/// The corners of one polygon seen in its own plane, by local ids.
class PlanePoints {
 public:
  /// Other corners, vertices of the body by local id, in the memory of those before. Body and ids must stay.
  void assign(const Body& body, const exact::Plane& plane, std::span<const std::uint32_t> ids) {
    body_ = &body;
    plane_ = &plane;
    ids_ = ids;
    const Frame frame(plane);
    u_ = static_cast<std::size_t>(frame.u());
    v_ = static_cast<std::size_t>(frame.v());
    make_room(planar_, ids.size());
    make_room(whole_, ids.size());

    all_grid_ = true;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const std::uint32_t v = ids[i];
      if (body.is_grid(v)) {
        const auto& p = body.grid_points[v].c;
        whole_[i] = {p[u_], p[v_]};
        planar_[i] = {static_cast<double>(p[u_]), static_cast<double>(p[v_])};
      } else {
        const auto& p = body.derived(v).approximation;
        planar_[i] = {p[u_], p[v_]};
        all_grid_ = false;
      }
    }
  }

  int compare(std::uint32_t a, std::uint32_t b) const {
    if (const int c = compare_along(0, a, b)) return c;
    return compare_along(1, a, b);
  }

  int orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    if (!all_grid_) return orientation_of_any(a, b, c);

    const auto &p = whole_[a], &q = whole_[b], &r = whole_[c];
    const std::int64_t det = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);  // below 2^61
    return det > 0 ? 1 : det < 0 ? -1 : 0;
  }

  /// Approximate coordinates by local id, for shape decisions.
  std::span<const std::array<double, 2>> approximate() const { return {planar_.data(), ids_.size()}; }

 private:
  exact::Point point(std::uint32_t a) const { return body_->point(ids_[a]); }

  int compare_along(std::size_t k, std::uint32_t a, std::uint32_t b) const {
    return exact::compare_rounded(planar_[a][k], planar_[b][k], [&] {
      return all_grid_ || a == b ? 0 : exact::compare_along(static_cast<int>(k == 0 ? u_ : v_), point(a), point(b));
    });
  }

  int orientation_of_any(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const int filtered = exact::projected_filter(planar_[a], planar_[b], planar_[c]);
    if (filtered == 2) return exact::orientation_in_plane_exact(*plane_, point(a), point(b), point(c));
    ++exact::counters().filter;
    return filtered;
  }

  const Body* body_ = nullptr;
  const exact::Plane* plane_ = nullptr;
  std::span<const std::uint32_t> ids_;
  std::size_t u_ = 0, v_ = 1;  // see Frame
  bool all_grid_ = true;
  Array<std::array<double, 2>> planar_;
  Array<std::array<std::int64_t, 2>> whole_;  // of grid points
};

/// Triangulates polygons, each with the memory of those before.
class Triangulator {
 public:
  Triangulator() : cutter_(points_, triangles_) {}

  /// Appends the corners of the triangles of polygon p of a body.
  void add(const Body& body, std::uint32_t p, std::vector<std::uint32_t>& out) {
    const auto corners = body.polygons.corners_of(p);
    const bool is_simple = body.polygons.loop_count(p) == 1;
    if (is_simple && corners.size() == 3) {
      out.insert(out.end(), corners.begin(), corners.end());
      return;
    }

    triangles_.clear();
    if (is_simple && corners.size() == 4) {
      points_.assign(body, body.planes[p], corners);
      if (cut_quadrilateral()) return append(corners, out);
    }

    number_corners(corners);
    points_.assign(body, body.planes[p], ids_);
    cut(body, p, is_simple && ids_.size() == corners.size());
    append(ids_, out);
  }

 private:
  void append(std::span<const std::uint32_t> ids, std::vector<std::uint32_t>& out) const {
    const std::size_t size = out.size();
    out.resize(size + 3 * triangles_.size());
    auto next = out.begin() + static_cast<std::ptrdiff_t>(size);
    for (const FaceTriangle& t : triangles_)
      for (const std::uint32_t corner : t) *next++ = ids[corner];
  }

  /// Numbers the vertices of a polygon in order.
  void number_corners(std::span<const std::uint32_t> corners) {
    const std::size_t count = corners.size();
    sorted_.resize(count);
    for (std::size_t i = 0; i < count; ++i) sorted_[i] = std::uint64_t{corners[i]} << 32 | i;
    std::sort(sorted_.begin(), sorted_.end());

    make_room(number_, count);
    ids_.resize(count);
    std::uint32_t last = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto v = static_cast<std::uint32_t>(sorted_[i] >> 32);
      if (i > 0 && ids_[last] != v) ++last;
      ids_[last] = v;
      number_[static_cast<std::uint32_t>(sorted_[i])] = last;
    }
    ids_.resize(last + 1);
  }

  /// Triangles for any polygon: a sweep, then flips that improve their shapes.
  /// No edge of a single loop has triangles on both sides: none has to be kept from flips.
  void cut(const Body& body, std::uint32_t p, bool is_single_loop) {
    edges_.clear();
    if (!is_single_loop || !cutter_.cut_loop({number_.data(), ids_.size()})) {
      gather(body, p);
      [[maybe_unused]] const bool closed = cutter_.cut(static_cast<std::uint32_t>(ids_.size()), edges_, isolated_);
      assert(closed);
    }
    if (triangles_.size() >= 2) cutter_.improve(edges_, points_.approximate());
  }

  /// The edges and isolated points of a polygon.
  void gather(const Body& body, std::uint32_t p) {
    isolated_.clear();
    std::size_t first = 0;
    body.polygons.for_loops(p, [&](std::span<const std::uint32_t> loop) {
      const auto numbers = std::span(number_).subspan(first, loop.size());
      first += loop.size();
      if (numbers.size() == 1) isolated_.push_back(numbers[0]);
      grid::for_loop_edges(numbers, [&](std::uint32_t u, std::uint32_t v) { edges_.push_back({u, v}); });
    });
  }

  /// Two triangles for a loop of four corners; false when neither diagonal leaves two proper ones.
  bool cut_quadrilateral() {
    // From the first corner in the plane's own order, wherever the loop begins.
    std::uint32_t first = 0;
    for (std::uint32_t i = 1; i < 4; ++i)
      if (points_.compare(i, first) < 0) first = i;
    std::array<std::uint32_t, 4> c{};
    for (std::uint32_t i = 0; i < 4; ++i) c[i] = (first + i) % 4;

    const auto proper = [&](std::size_t i) {  // the diagonal from corner i
      return points_.orientation(c[i], c[i + 1], c[i + 2]) > 0 &&
             points_.orientation(c[i + 2], c[(i + 3) % 4], c[i]) > 0;
    };
    const bool even = proper(0), odd = proper(1);
    if (!even && !odd) return false;

    const auto at = [&](std::size_t i) { return points_.approximate()[c[i]]; };
    const bool stays = even && !(odd && prefers_other_diagonal(at(2), at(0), at(1), at(3)));
    const std::uint32_t i = stays ? 0 : 1;
    triangles_.push_back({c[i], c[i + 1], c[i + 2]});
    triangles_.push_back({c[i + 2], c[(i + 3) % 4], c[i]});
    return true;
  }

  PlanePoints points_;
  std::vector<FaceTriangle> triangles_;
  FaceCutter<PlanePoints> cutter_;
  Array<std::uint64_t> sorted_;  // corners: the vertex, then the place
  Array<std::uint32_t> ids_, isolated_;
  Array<std::uint32_t> number_;  // by corner
  Array<FaceEdge> edges_;
};

/// For the polygons of one stretch. That of a small body is kept for the next one of the thread.
class LocalTriangulator {
 public:
  explicit LocalTriangulator(const Body& body)
      : kept_(body.polygons.corners.size() < few_corners ? grid::kept_by_thread<Triangulator>() : nullptr) {
    if (!kept_) own_.emplace();
  }

  Triangulator& operator*() { return kept_ ? *kept_ : *own_; }

 private:
  static constexpr std::size_t few_corners = 4096;
  Triangulator* kept_;
  std::optional<Triangulator> own_;
};

void append_numbers(Array<std::uint32_t>& list, std::uint32_t begin, std::uint32_t end) {
  const std::size_t size = list.size();
  list.resize(size + (end - begin));
  std::iota(list.begin() + static_cast<std::ptrdiff_t>(size), list.end(), begin);
}

/// Room for all triangles: a face of n corners in h loops has fewer than n + 2 h of them.
void reserve(const Body& body, Triangulated& mesh) {
  const std::size_t most = body.triangles.size() + body.polygons.corners.size() + 2 * body.polygons.loop_count();
  grid::reserve_large(mesh.corners, 3 * most);
  mesh.face.reserve(most);
}

/// Adds the raw triangles, of body vertices for now, and returns the polygons.
Array<std::uint32_t> add_triangles(const Body& body, Triangulated& mesh) {
  const auto raw = static_cast<std::uint32_t>(body.triangles.size());
  Array<std::uint32_t> polygons;
  body.for_runs([&](std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t middle = std::clamp(raw, begin, end);
    append_numbers(mesh.face, begin, middle);
    append_numbers(polygons, middle, end);
    const auto own = grid::corners_of(std::span(body.triangles).subspan(begin, middle - begin));
    mesh.corners.insert(mesh.corners.end(), own.begin(), own.end());
  });
  return polygons;
}

/// The triangles of some polygons, in order.
struct Pieces {
  std::vector<std::uint32_t> corners, face;
};

/// Adds the triangles of polygons, of body vertices for now.
void add_polygons(const Body& body, const Array<std::uint32_t>& polygons, Triangulated& mesh) {
  const std::size_t batch = grid::long_stretch(polygons.size(), 64);
  std::vector<Pieces> batches((polygons.size() + batch - 1) / batch);
  grid::in_stretches(polygons.size(), batch, [&](std::size_t b, std::size_t begin, std::size_t end) {
    LocalTriangulator triangulator(body);
    Pieces& pieces = batches[b];
    pieces.corners.reserve(6 * (end - begin));  // polygons have two triangles at least, if they are none themselves
    pieces.face.reserve(2 * (end - begin));
    for (std::size_t i = begin; i < end; ++i) {
      (*triangulator).add(body, body.polygon(polygons[i]), pieces.corners);
      pieces.face.resize(pieces.corners.size() / 3, polygons[i]);
    }
  });

  for (const Pieces& p : batches) {
    mesh.corners.insert(mesh.corners.end(), p.corners.begin(), p.corners.end());
    mesh.face.insert(mesh.face.end(), p.face.begin(), p.face.end());
  }
}

/// Names the body vertices in use by output vertices, in order.
void number_vertices(const Body& body, Triangulated& mesh) {
  Array<std::uint8_t> used(body.vertex_count());
  for (const std::uint32_t v : mesh.corners) used[v] = 1;
  const auto count = static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
  mesh.source.resize(count);
  if (count == used.size()) return std::iota(mesh.source.begin(), mesh.source.end(), 0u);

  Array<std::uint32_t> id(used.size());
  for (std::uint32_t v = 0, i = 0; v < used.size(); ++v)
    if (used[v]) mesh.source[i] = v, id[v] = i++;
  for (std::uint32_t& v : mesh.corners) v = id[v];
}

}  // namespace

Triangulated triangulated(const Body& body) {
  Triangulated mesh;
  reserve(body, mesh);
  const Array<std::uint32_t> polygons = add_triangles(body, mesh);
  add_polygons(body, polygons, mesh);
  number_vertices(body, mesh);
  return mesh;
}

}  // namespace quoin::booleans
