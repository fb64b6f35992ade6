#include "grid/import.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

#include "grid/balance.h"
#include "grid/cut.h"
#include "grid/seal.h"
#include "grid/snap.h"
#include "grid/weld.h"

namespace quoin::grid {

using exact::GridPoint;
using exact::int128;

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// The input: triangles have no `starts`.
struct Faces {
  std::span<const double> points;
  std::span<const std::uint32_t> starts, corners;
  bool triangles;

  std::size_t count() const {
    if (triangles) return corners.size() / 3;
    return starts.empty() ? 0 : starts.size() - 1;
  }
  std::span<const std::uint32_t> face(std::size_t i) const {
    return triangles ? corners.subspan(3 * i, 3) : corners.subspan(starts[i], starts[i + 1] - starts[i]);
  }
};

constexpr std::size_t most_points = std::size_t{1} << 31, most_corners = std::size_t{1} << 31;

bool all_below(std::span<const std::uint32_t> values, std::size_t limit) {
  std::array<std::uint32_t, 4> greatest{};  // independent chains
  const std::size_t whole = values.size() / 4 * 4;
  for (std::size_t i = 0; i < whole; i += 4)
    for (std::size_t k = 0; k < 4; ++k) greatest[k] = std::max(greatest[k], values[i + k]);
  for (std::size_t i = whole; i < values.size(); ++i) greatest[0] = std::max(greatest[0], values[i]);
  return values.empty() || *std::max_element(greatest.begin(), greatest.end()) < limit;
}

/// "bad-index" and "out-of-range" for what cannot be addressed.
Result<void> check_indices(const Faces& f) {
  if (f.points.size() % 3 != 0) return Error{"bad-index", "the number of coordinates is not a multiple of 3"};
  if (f.triangles && f.corners.size() % 3 != 0)
    return Error{"bad-index", "the number of triangle corners is not a multiple of 3"};
  const std::size_t n = f.points.size() / 3;
  if (n > most_points || f.corners.size() > most_corners)
    return Error{"out-of-range", "a mesh of more than 2^31 points or corners cannot be imported"};
  if (!f.triangles)
    for (std::size_t i = 0; i < f.starts.size(); ++i)
      if (f.starts[i] > f.corners.size() || (i > 0 && f.starts[i] < f.starts[i - 1]))
        return Error{
            "bad-index", "polygon starts must increase and stay within the corners", {}, "start " + std::to_string(i)};
  if (all_below(f.corners, n)) return {};
  for (std::size_t i = 0; i < f.count(); ++i)
    for (std::uint32_t v : f.face(i))
      if (v >= n)
        return Error{
            "bad-index",
            "face " + std::to_string(i) + " names vertex " + std::to_string(v) + ", but there are " + std::to_string(n),
            {},
            "face " + std::to_string(i)};
  return Error{"bad-index", "a corner outside of all polygons names a vertex that does not exist"};
}

/// The triangles so far, and what is known of them.
class Collector {
 public:
  Collector(ImportedMesh& mesh, std::vector<std::uint32_t>& slivers) : mesh_(mesh), slivers_(slivers) {}

  void add(const Triangle& t) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
      ++mesh_.zero_area_triangles;
      return;
    }
    const GridPoint &p = mesh_.points[t[0]], &q = mesh_.points[t[1]], &r = mesh_.points[t[2]];
    const std::int64_t ex = std::int64_t{q[0]} - p[0], ey = std::int64_t{q[1]} - p[1], ez = std::int64_t{q[2]} - p[2];
    const std::int64_t fx = std::int64_t{r[0]} - p[0], fy = std::int64_t{r[1]} - p[1], fz = std::int64_t{r[2]} - p[2];
    const std::int64_t a = ey * fz - ez * fy, b = ez * fx - ex * fz, c = ex * fy - ey * fx;
    if ((a | b | c) == 0) slivers_.push_back(static_cast<std::uint32_t>(mesh_.triangles.size()));
    // 3 * 2^29 * 2^61 a triangle, below 2^124 for 2^32 of them.
    volume_ += int128(a) * p[0] + int128(b) * p[1] + int128(c) * p[2];
    mesh_.triangles.push_back(t);
  }

  /// Six times the enclosed volume.
  int128 volume() const { return volume_; }

 private:
  ImportedMesh& mesh_;
  std::vector<std::uint32_t>& slivers_;
  int128 volume_ = 0;
};

void add_triangles(const Faces& f, const std::vector<std::uint32_t>& ids, ImportedMesh& mesh, Collector& collector) {
  mesh.triangles.reserve(f.count());
  for (std::size_t i = 0; i < f.corners.size(); i += 3) {
    Triangle t{f.corners[i], f.corners[i + 1], f.corners[i + 2]};
    if (!ids.empty()) t = {ids[t[0]], ids[t[1]], ids[t[2]]};
    collector.add(t);
  }
}

/// The face's corners as point ids, without repetitions of neighbours.
void distinct_corners(std::span<const std::uint32_t> face, const std::vector<std::uint32_t>& ids,
                      std::vector<std::uint32_t>& loop) {
  loop.clear();
  for (std::uint32_t v : face) {
    const std::uint32_t id = ids.empty() ? v : ids[v];
    if (loop.empty() || loop.back() != id) loop.push_back(id);
  }
  while (loop.size() > 1 && loop.back() == loop.front()) loop.pop_back();
}

void add_polygons(const Faces& f, const std::vector<std::uint32_t>& ids, ImportedMesh& mesh, Collector& collector) {
  mesh.triangles.reserve(f.corners.size() - std::min(f.corners.size(), 2 * f.count()));
  Cutter cutter(mesh.points);
  std::vector<std::uint32_t> loop;
  std::vector<Triangle> pieces;
  for (std::size_t i = 0; i < f.count(); ++i) {
    distinct_corners(f.face(i), ids, loop);
    if (loop.size() < 3) {
      ++mesh.zero_area_triangles;
    } else if (loop.size() == 3) {
      collector.add({loop[0], loop[1], loop[2]});
    } else {
      pieces.clear();
      if (!cutter.cut(loop, pieces)) ++mesh.nonplanar_polygons;
      for (const Triangle& t : pieces) collector.add(t);
    }
  }
}

/// The first face, in input order, with an edge that is open; sealing and cutting keep the sum of directed edges, so
/// there is one.
Error open_boundary(const Faces& f, const std::vector<std::uint32_t>& ids, const ImportedMesh& mesh) {
  const std::vector<OpenEdge> open = open_edges(mesh.triangles);
  std::uint64_t count = 0;
  for (const OpenEdge& e : open) count += e.excess;
  const auto key = [](std::uint32_t a, std::uint32_t b) { return std::pair{std::min(a, b), std::max(a, b)}; };
  const auto is_open = [&](std::uint32_t a, std::uint32_t b) {
    const auto found =
        std::lower_bound(open.begin(), open.end(), key(a, b),
                         [&](const OpenEdge& e, const auto& wanted) { return key(e.from, e.to) < wanted; });
    return found != open.end() && found->from == a && found->to == b;
  };
  Error error{"open-boundary", "the surface is not closed: " + std::to_string(count) +
                                   (count == 1 ? " edge is" : " edges are") +
                                   " not balanced by the reverse edge of a neighbouring face"};
  for (std::size_t i = 0; i < f.count(); ++i) {
    const auto face = f.face(i);
    for (std::size_t j = 0; j < face.size(); ++j) {
      const std::uint32_t a = face[j], b = face[j + 1 < face.size() ? j + 1 : 0];
      if (!(ids.empty() ? is_open(a, b) : is_open(ids[a], ids[b]))) continue;
      error.where = "face " + std::to_string(i) + ", edge " + describe_point(&f.points[3 * std::size_t{a}]) + " - " +
                    describe_point(&f.points[3 * std::size_t{b}]);
      return error;
    }
  }
  assert(false);
  return error;
}

Result<ImportedMesh> import(const Faces& f, const Lattice& lattice) {
  if (const auto checked = check_indices(f); !checked) return checked.error();
  auto snapped = snap(f.points, lattice);
  if (!snapped) return snapped.error();
  ImportedMesh mesh;
  mesh.points = std::move(snapped.value().points);
  mesh.max_snap = snapped.value().max_snap;
  // A closed mesh has about half as many points as triangles.
  const Weld welded = weld(mesh.points, f.points, f.corners.size() / 5 + 16);
  mesh.merged_points = welded.merged;

  std::vector<std::uint32_t> slivers;
  Collector collector(mesh, slivers);
  if (f.triangles)
    add_triangles(f, welded.ids, mesh, collector);
  else
    add_polygons(f, welded.ids, mesh, collector);
  mesh.zero_area_triangles += slivers.size();
  if (!seal(mesh.points, mesh.triangles, slivers) || !is_balanced(mesh.triangles, mesh.points.size()))
    return open_boundary(f, welded.ids, mesh);
  if (collector.volume() < 0)
    return Error{"inside-out",
                 "the enclosed volume is negative: the faces must be counter-clockwise seen from outside"};
  return Result<ImportedMesh>(std::move(mesh));
}

}  // namespace

Result<ImportedMesh> import_polygons(std::span<const double> points, std::span<const std::uint32_t> starts,
                                     std::span<const std::uint32_t> corners, const Lattice& lattice) {
  return import({points, starts, corners, false}, lattice);
}

Result<ImportedMesh> import_triangles(std::span<const double> points, std::span<const std::uint32_t> triangles,
                                      const Lattice& lattice) {
  return import({points, {}, triangles, true}, lattice);
}

}  // namespace quoin::grid
