#include "booleans/surface/triangulated.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "booleans/arrangement/frame.h"
#include "booleans/surface/triangulate.h"
#include "exact/predicates.h"
#include "grid/balance.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {
namespace {

/// The corners of one polygon seen in its own plane, by local ids.
class PlanePoints {
 public:
  PlanePoints(const Body& body, const exact::Plane& plane, const std::vector<std::uint32_t>& ids)
      : plane_(plane), frame_(plane) {
    points_.reserve(ids.size());
    for (std::uint32_t v : ids) {
      points_.push_back(body.point(v));
      all_grid_ = all_grid_ && body.is_grid(v);
    }
  }

  int compare(std::uint32_t a, std::uint32_t b) const {
    if (a == b) return 0;
    if (const int c = exact::compare_along(frame_.u(), points_[a], points_[b])) return c;
    return exact::compare_along(frame_.v(), points_[a], points_[b]);
  }

  int orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    if (!all_grid_) return exact::orientation_in_plane(plane_, points_[a], points_[b], points_[c]);

    const auto p = planar(a), q = planar(b), r = planar(c);
    const std::int64_t det = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);  // below 2^61
    return det > 0 ? 1 : det < 0 ? -1 : 0;
  }

  /// Approximate coordinates for shape decisions.
  std::array<double, 2> approximate(std::uint32_t a) const {
    const auto& p = points_[a].approximation;
    return {p[static_cast<std::size_t>(frame_.u())], p[static_cast<std::size_t>(frame_.v())]};
  }

 private:
  std::array<std::int64_t, 2> planar(std::uint32_t a) const {
    const auto p = approximate(a);
    return {static_cast<std::int64_t>(p[0]), static_cast<std::int64_t>(p[1])};
  }

  exact::Plane plane_;
  Frame frame_;
  Scratch<exact::Point> points_;
  bool all_grid_ = true;
};

/// Triangulates polygons of a body, each with the memory of those before.
class Triangulator {
 public:
  explicit Triangulator(const Body& body) : body_(body) {}

  /// Appends the corners of the triangles of polygon p.
  void add(std::uint32_t p, std::vector<std::uint32_t>& out) {
    const auto corners = body_.polygons.corners_of(p);
    const bool is_simple = body_.polygons.loop_count(p) == 1;
    if (is_simple && corners.size() == 3) {
      out.insert(out.end(), corners.begin(), corners.end());
      return;
    }

    gather(p);
    const PlanePoints points(body_, body_.planes[p], ids_);
    triangles_.clear();
    const bool is_quadrilateral = edges_.size() == 4 && ids_.size() == 4 && isolated_.empty() && is_simple;
    if (!is_quadrilateral || !cut_quadrilateral(points)) cut(points);

    for (const FaceTriangle& t : triangles_)
      for (const std::uint32_t corner : t) out.push_back(ids_[corner]);
  }

 private:
  std::uint32_t local(std::uint32_t v) const {
    return static_cast<std::uint32_t>(std::lower_bound(ids_.begin(), ids_.end(), v) - ids_.begin());
  }

  /// The polygon's vertices in order, then its edges and isolated points by their numbers in that order.
  void gather(std::uint32_t p) {
    const auto corners = body_.polygons.corners_of(p);
    ids_.assign(corners.begin(), corners.end());
    std::sort(ids_.begin(), ids_.end());
    ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());

    edges_.clear();
    isolated_.clear();
    body_.polygons.for_points(p, [&](std::uint32_t v) { isolated_.push_back(local(v)); });
    body_.polygons.for_edges(p, [&](std::uint32_t u, std::uint32_t v) { edges_.push_back({local(u), local(v)}); });
  }

  /// Triangles for any polygon: a sweep, then flips that improve their shapes.
  void cut(const PlanePoints& points) {
    [[maybe_unused]] const bool closed =
        triangulate(points, static_cast<std::uint32_t>(ids_.size()), edges_, isolated_, triangles_);
    assert(closed);
    if (triangles_.size() < 2) return;

    shape_.resize(ids_.size());
    for (std::uint32_t i = 0; i < shape_.size(); ++i) shape_[i] = points.approximate(i);
    improve_triangles(points, edges_, shape_, triangles_);
  }

  /// Two triangles for a loop of four corners; false when neither diagonal leaves two proper ones.
  bool cut_quadrilateral(const PlanePoints& points) {
    // From the first corner in the plane's own order, wherever the loop begins.
    std::array<std::uint32_t, 4> c{};
    std::size_t first = 0;
    for (std::size_t i = 1; i < 4; ++i)
      if (points.compare(edges_[i][0], edges_[first][0]) < 0) first = i;
    for (std::size_t i = 0; i < 4; ++i) c[i] = edges_[(first + i) % 4][0];

    const auto proper = [&](std::size_t i) {  // the diagonal from corner i
      return points.orientation(c[i], c[i + 1], c[i + 2]) > 0 && points.orientation(c[i + 2], c[(i + 3) % 4], c[i]) > 0;
    };
    const bool even = proper(0), odd = proper(1);
    if (!even && !odd) return false;

    const auto at = [&](std::size_t i) { return points.approximate(c[i]); };
    if (even && !(odd && prefers_other_diagonal(at(2), at(0), at(1), at(3))))
      triangles_ = {{c[0], c[1], c[2]}, {c[2], c[3], c[0]}};
    else
      triangles_ = {{c[1], c[2], c[3]}, {c[3], c[0], c[1]}};
    return true;
  }

  const Body& body_;
  std::vector<std::uint32_t> ids_, isolated_;
  std::vector<FaceEdge> edges_;
  std::vector<FaceTriangle> triangles_;
  std::vector<std::array<double, 2>> shape_;
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
    Triangulator triangulator(body);
    Pieces& pieces = batches[b];
    for (std::size_t i = begin; i < end; ++i) {
      triangulator.add(body.polygon(polygons[i]), pieces.corners);
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
