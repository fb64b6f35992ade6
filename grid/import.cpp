#include "grid/import.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <string>
#include <utility>

#include "grid/area.h"
#include "grid/balance.h"
#include "grid/cut.h"
#include "grid/diagnosis.h"
#include "grid/lists/loops.h"
#include "grid/lists/stretches.h"
#include "grid/seal.h"
#include "grid/shells.h"
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
  /// A mesh of as many points as this is no closed surface, or one whose points are to be welded first.
  bool may_be_balanced() const { return triangles && points.size() <= corners.size(); }
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
  if (f.points.size() % 3 != 0)
    return Error{ErrorCode::bad_index,
                 "the number of coordinates is not a multiple of 3",
                 {},
                 "vertex " + std::to_string(f.points.size() / 3)};
  if (f.triangles && f.corners.size() % 3 != 0)
    return Error{ErrorCode::bad_index,
                 "the number of triangle corners is not a multiple of 3",
                 {},
                 "face " + std::to_string(f.corners.size() / 3)};

  const std::size_t n = f.points.size() / 3;
  if (n > most_points || f.corners.size() > most_corners)
    return Error{ErrorCode::out_of_range, "a mesh of more than 2^31 points or corners cannot be imported"};
  if (!f.triangles)
    for (std::size_t i = 0; i < f.starts.size(); ++i)
      if (f.starts[i] > f.corners.size() || (i > 0 && f.starts[i] < f.starts[i - 1]))
        return Error{ErrorCode::bad_index,
                     "polygon starts must increase and stay within the corners",
                     {},
                     "start " + std::to_string(i)};

  if (all_below(f.corners, n)) return {};
  for (std::size_t i = 0; i < f.count(); ++i)
    for (std::uint32_t v : f.face(i))
      if (v >= n)
        return Error{
            ErrorCode::bad_index,
            "face " + std::to_string(i) + " names vertex " + std::to_string(v) + ", but there are " + std::to_string(n),
            {},
            "face " + std::to_string(i)};

  const auto stray = std::find_if(f.corners.begin(), f.corners.end(), [&](std::uint32_t v) { return v >= n; });
  return Error{ErrorCode::bad_index,
               "a corner outside of all polygons names a vertex that does not exist",
               {},
               "corner " + std::to_string(stray - f.corners.begin())};
}

/// Whether some face has an area, before snapping. Of nearly every mesh one of the first faces tells by its signs.
bool has_areas(const Faces& f) {
  for (const Look look : {Look::at_signs, Look::exactly})
    for (std::size_t i = 0; i < f.count(); ++i)
      if (has_area(f.points, f.face(i), look)) return true;
  return false;
}

Error no_areas(const Faces& f) {
  const std::string which =
      f.count() == 1 ? "the only face has no area" : "none of the " + std::to_string(f.count()) + " faces has an area";
  return {ErrorCode::no_faces, which + ": all corners of a face lie on one line, so nothing is bounded", {}, "face 0"};
}

/// What is known of triangles.
struct Collected {
  std::uint64_t zero_area = 0;   // without the slivers
  Array<std::uint32_t> slivers;  // of three distinct collinear corners
  int128 volume = 0;             // six times what they enclose

  /// Takes note of a triangle, which is to become number `index`; false when it is nothing.
  bool add(const Array<GridPoint>& points, const Triangle& t, std::size_t index) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
      ++zero_area;
      return false;
    }

    const GridPoint &p = points[t[0]], &q = points[t[1]], &r = points[t[2]];
    const std::int64_t ex = std::int64_t{q[0]} - p[0], ey = std::int64_t{q[1]} - p[1], ez = std::int64_t{q[2]} - p[2];
    const std::int64_t fx = std::int64_t{r[0]} - p[0], fy = std::int64_t{r[1]} - p[1], fz = std::int64_t{r[2]} - p[2];
    const std::int64_t a = ey * fz - ez * fy, b = ez * fx - ex * fz, c = ex * fy - ey * fx;
    if ((a | b | c) == 0) slivers.push_back(static_cast<std::uint32_t>(index));
    // 3 * 2^29 * 2^61 a triangle, below 2^124 for 2^32 of them.
    volume += int128(a) * p[0] + int128(b) * p[1] + int128(c) * p[2];
    return true;
  }
};

/// Moves the items begin .. end - 1 of a list down by some places.
template <class T>
void move_down(Array<T>& list, std::size_t begin, std::size_t end, std::size_t places) {
  std::copy(list.data() + begin, list.data() + end, list.data() + begin - places);
}

/// Stretch by stretch; where triangles are nothing, those behind them move up.
Collected add_triangles(const Faces& f, const Array<std::uint32_t>& ids, bool wants_sources, ImportedMesh& mesh) {
  const std::size_t length = stretch(std::size_t{1} << 15);
  mesh.triangles.resize(f.count());
  if (wants_sources) mesh.sources.resize(f.count());
  Array<Collected> parts(f.count() / length + 1);

  in_stretches(f.count(), length, [&](std::size_t s, std::size_t begin, std::size_t end) {
    std::size_t next = begin;
    for (std::size_t i = begin; i < end; ++i) {
      Triangle t{f.corners[3 * i], f.corners[3 * i + 1], f.corners[3 * i + 2]};
      if (!ids.empty()) t = {ids[t[0]], ids[t[1]], ids[t[2]]};
      if (!parts[s].add(mesh.points, t, next)) continue;
      if (wants_sources) mesh.sources[next] = static_cast<std::uint32_t>(i);
      mesh.triangles[next++] = t;
    }
  });

  Collected all;
  for (std::size_t s = 0; s < parts.size(); ++s) {
    const std::size_t begin = s * length, end = std::min(begin + length, f.count()) - parts[s].zero_area;
    if (all.zero_area > 0) move_down(mesh.triangles, begin, end, all.zero_area);
    if (all.zero_area > 0 && wants_sources) move_down(mesh.sources, begin, end, all.zero_area);
    for (const std::uint32_t i : parts[s].slivers) all.slivers.push_back(i - static_cast<std::uint32_t>(all.zero_area));
    all.zero_area += parts[s].zero_area;
    all.volume += parts[s].volume;
  }
  mesh.triangles.resize(f.count() - all.zero_area);
  if (wants_sources) mesh.sources.resize(mesh.triangles.size());
  return all;
}

/// The face's corners as point ids, without repetitions of neighbours.
void distinct_corners(std::span<const std::uint32_t> face, const Array<std::uint32_t>& ids,
                      Array<std::uint32_t>& loop) {
  loop.clear();
  for (std::uint32_t v : face) {
    const std::uint32_t id = ids.empty() ? v : ids[v];
    if (loop.empty() || loop.back() != id) loop.push_back(id);
  }
  while (loop.size() > 1 && loop.back() == loop.front()) loop.pop_back();
}

Collected add_polygons(const Faces& f, const Array<std::uint32_t>& ids, bool wants_sources, ImportedMesh& mesh) {
  mesh.triangles.reserve(f.corners.size() - std::min(f.corners.size(), 2 * f.count()));
  Cutter cutter(mesh.points);
  Array<std::uint32_t> loop;
  Array<Triangle> pieces;
  Collected all;

  for (std::size_t i = 0; i < f.count(); ++i) {
    distinct_corners(f.face(i), ids, loop);
    pieces.clear();
    if (loop.size() < 3)
      ++all.zero_area;
    else if (loop.size() == 3)
      pieces.push_back({loop[0], loop[1], loop[2]});
    else if (!cutter.cut(loop, pieces))
      ++mesh.nonplanar_polygons;
    for (const Triangle& t : pieces)
      if (all.add(mesh.points, t, mesh.triangles.size())) mesh.triangles.push_back(t);
    if (wants_sources) mesh.sources.resize(mesh.triangles.size(), static_cast<std::uint32_t>(i));
  }
  return all;
}

/// The first face, in input order, with an edge that is open.
std::string first_open_face(const Faces& f, const Array<std::uint32_t>& ids, const Array<OpenEdge>& open) {
  const auto key = [](std::uint32_t a, std::uint32_t b) { return std::pair{std::min(a, b), std::max(a, b)}; };
  const auto is_open = [&](std::uint32_t a, std::uint32_t b) {
    const auto found =
        std::lower_bound(open.begin(), open.end(), key(a, b),
                         [&](const OpenEdge& e, const auto& wanted) { return key(e.from, e.to) < wanted; });
    return found != open.end() && found->from == a && found->to == b;
  };

  for (std::size_t i = 0; i < f.count(); ++i) {
    const auto face = f.face(i);
    for (std::size_t j = 0; j < face.size(); ++j) {
      const std::uint32_t a = face[j], b = face[next_in_loop(j, face.size())];
      if (!(ids.empty() ? is_open(a, b) : is_open(ids[a], ids[b]))) continue;
      return "face " + std::to_string(i) + ", edge " + describe_point(&f.points[3 * std::size_t{a}]) + " - " +
             describe_point(&f.points[3 * std::size_t{b}]);
    }
  }
  assert(false);
  return {};
}

/// "the surface is not closed: ...: what is wrong first (what would cure it)".
Error open_boundary(std::uint64_t edges, std::string where, const std::vector<Finding>& findings) {
  std::string message = "the surface is not closed: " + std::to_string(edges) +
                        (edges == 1 ? " edge is" : " edges are") +
                        " not balanced by the reverse edge of a neighbouring face";
  if (!findings.empty()) {
    message += ": " + findings[0].sentence;
    if (!findings[0].cure.empty()) message += " (repair " + findings[0].cure + ")";
    if (where.empty()) where = findings[0].where;
  }
  return {ErrorCode::open_boundary, std::move(message), {}, std::move(where)};
}

std::uint64_t edge_count(const Array<OpenEdge>& open) {
  std::uint64_t count = 0;
  for (const OpenEdge& e : open) count += e.excess;
  return count;
}

/// Takes triangles without area out, and lets vertices that lie exactly on open edges close them; changes nothing where
/// the mesh is not closed then.
bool seal_exactly(ImportedMesh& mesh) {
  Array<Triangle> triangles = mesh.triangles;
  Sources sources = mesh.sources;
  drop_triangles(triangles, sources,
                 [&](const Triangle& t) { return collinear(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]); });
  // Closed by this alone it is not: triangles without area count in the proof.
  if (is_balanced(corners_of(triangles), mesh.points.size())) return false;
  const std::uint64_t sealed = seal_t_junctions(mesh.points, triangles, sources, Pairing::opposite);
  if (!is_balanced(corners_of(triangles), mesh.points.size())) return false;

  mesh.triangles = std::move(triangles);
  mesh.sources = std::move(sources);
  mesh.sealed_t_junctions = sealed;
  return true;
}

int128 enclosed_six_volumes(const ImportedMesh& mesh) {
  int128 sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const GridPoint &p = mesh.points[t[0]], &q = mesh.points[t[1]], &r = mesh.points[t[2]];
    const auto minor = [&](int i, int j) { return std::int64_t{q[i]} * r[j] - std::int64_t{q[j]} * r[i]; };
    sum += int128(p[0]) * minor(1, 2) + int128(p[1]) * minor(2, 0) + int128(p[2]) * minor(0, 1);
  }
  return sum;
}

/// Cures as asked; whether the mesh is closed then.
bool cure(ImportedMesh& mesh, Curing& curing, const Lattice& lattice) {
  Surface surface{std::move(mesh.points), std::move(mesh.triangles), std::move(mesh.sources)};
  const Repaired repaired = repair(surface, curing.cures, lattice);
  mesh.points = std::move(surface.points);
  mesh.triangles = std::move(surface.triangles);
  mesh.sources = std::move(surface.sources);
  mesh.sealed_t_junctions += repaired.sealed_t_junctions;
  curing.repairs = repairs_of(repaired.damages, lattice);
  return is_balanced(corners_of(mesh.triangles), mesh.points.size());
}

/// Names the shell of the most negative volume.
Error inside_out(const ImportedMesh& mesh, const Lattice& lattice) {
  const Shells parts = shells(mesh.points, mesh.triangles);
  const auto worst = std::min_element(parts.six_volumes.begin(), parts.six_volumes.end());
  const auto shell = static_cast<std::uint32_t>(worst - parts.six_volumes.begin());
  const GridPoint corner = lowest_corner(parts, shell, mesh.points, mesh.triangles);

  return {ErrorCode::inside_out,
          "the enclosed volume is negative: the faces must be counter-clockwise seen from outside",
          {},
          "shell at " + describe_point(lattice, corner)};
}

/// Snaps, welds and collects. `ids`: what the input's points became, empty when they are as they were.
Result<Collected> gather(const Faces& f, const Lattice& lattice, bool wants_sources, ImportedMesh& mesh,
                         Array<std::uint32_t>& ids) {
  auto snapped = snap(f.points, lattice);
  if (!snapped) return snapped.error();
  mesh.points = std::move(snapped.value().points);
  mesh.max_snap = snapped.value().max_snap;
  // A closed mesh has about half as many points as triangles.
  Weld welded = weld(mesh.points, f.points, f.corners.size() / 5 + 16);
  mesh.merged_points = welded.merged;
  ids = std::move(welded.ids);
  return f.triangles ? add_triangles(f, ids, wants_sources, mesh) : add_polygons(f, ids, wants_sources, mesh);
}

Result<ImportedMesh> import(const Faces& f, const Lattice& lattice, Facing facing, Curing* curing) {
  if (const auto checked = check_indices(f); !checked) return checked.error();

  ImportedMesh mesh;
  Array<std::uint32_t> ids;
  std::optional<Result<Collected>> gathered;
  // Welding and sealing keep the balance of edges, so the input may be asked meanwhile.
  bool balanced = false;
  in_tasks(2, f.corners.size(), [&](std::size_t task) {
    if (task == 0)
      balanced = f.may_be_balanced() && is_balanced(f.corners, f.points.size() / 3);
    else
      gathered = gather(f, lattice, curing != nullptr && curing->wants_sources, mesh, ids);
  });
  if (!*gathered) return gathered->error();
  if (facing == Facing::out && f.count() > 0 && !has_areas(f)) return no_areas(f);

  const Collected& all = gathered->value();
  mesh.zero_area_triangles = all.zero_area + all.slivers.size();
  int128 volume = all.volume;
  bool is_closed = seal(mesh.points, mesh.triangles, mesh.sources, all.slivers) &&
                   (balanced || is_balanced(corners_of(mesh.triangles), mesh.points.size()));
  // Until here the sum of the directed edges is that of the input.
  Array<OpenEdge> open;
  if (!is_closed) {
    open = open_edges(mesh.triangles);
    is_closed = seal_exactly(mesh);
  }
  const bool is_cured = curing != nullptr && curing->cures.any();
  if (is_cured) {
    is_closed = cure(mesh, *curing, lattice);
    volume = enclosed_six_volumes(mesh);
  }
  const bool is_sound = is_closed && (volume >= 0 || facing == Facing::any);
  if (is_sound) return Result<ImportedMesh>(std::move(mesh));

  std::vector<Finding> findings = findings_of(diagnose({mesh.points, mesh.triangles}), lattice);
  if (curing != nullptr) curing->findings = findings;
  if (is_closed) return inside_out(mesh, lattice);
  return is_cured ? open_boundary(edge_count(open_edges(mesh.triangles)), {}, findings)
                  : open_boundary(edge_count(open), first_open_face(f, ids, open), findings);
}

}  // namespace

Result<ImportedMesh> import_polygons(std::span<const double> points, std::span<const std::uint32_t> starts,
                                     std::span<const std::uint32_t> corners, const Lattice& lattice, Curing* curing) {
  return import({points, starts, corners, false}, lattice, Facing::out, curing);
}

Result<ImportedMesh> import_triangles(std::span<const double> points, std::span<const std::uint32_t> triangles,
                                      const Lattice& lattice, Facing facing, Curing* curing) {
  return import({points, {}, triangles, true}, lattice, facing, curing);
}

}  // namespace quoin::grid
