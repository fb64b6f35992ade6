#include "api/labels.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "api/access.h"
#include "booleans/body/canonical.h"
#include "grid/lists/stretches.h"

namespace quoin {

using booleans::Origins;
using booleans::Provenance;

booleans::Origin origin_of(const Original& original, std::size_t faces, const Indices& labels) {
  booleans::Origin origin{original.id, original.name, static_cast<std::uint32_t>(faces), {}, {}, nullptr};
  std::visit([&](const auto& list) { origin.labels.assign(list.begin(), list.end()); }, labels.values());
  return origin;
}

Result<void> check_label_count(std::size_t labels, std::size_t faces) {
  if (labels == 0 || labels == faces) return {};
  return Error{ErrorCode::bad_index,
               "there are " + std::to_string(labels) + " labels for " + std::to_string(faces) + " faces",
               {},
               "face " + std::to_string(std::min(labels, faces))};
}

PublicLabels public_labels(const Origins* origins, std::span<const Provenance> faces, std::size_t face_count) {
  PublicLabels result;
  result.labels.resize(face_count);
  if (!origins) return result;

  std::vector<std::uint8_t> is_named(origins->size());
  for (const Provenance& p : faces) is_named[p.origin()] = 1;
  std::vector<std::uint32_t> number(origins->size(), FaceLabel::unlabelled);
  for (const std::uint32_t i : origins->in_order()) {
    if (!is_named[i] || !(*origins)[i]) continue;
    number[i] = static_cast<std::uint32_t>(result.originals.size());
    result.originals.push_back({(*origins)[i]->id, (*origins)[i]->name});
  }

  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Provenance& p = faces[f];
    if ((*origins)[p.origin()]) result.labels[f] = {number[p.origin()], origins->label(p), p.face(), p.is_turned()};
  }
  return result;
}

namespace {

/// The places of a mesh's corners in the steps of seeds.
class SeedPlaces {
 public:
  SeedPlaces(const booleans::Body& body, const booleans::Triangulated& mesh, const booleans::PositionMap& to_seeds)
      : body_(body), mesh_(mesh), to_seeds_(to_seeds), is_same_(booleans::is_identity(to_seeds)) {}

  void write(const booleans::Channels& channels, std::uint32_t surface, std::uint32_t vertex,
             std::span<double> out) const {
    const bool is_own = vertex < mesh_.source.size();
    if (is_same_ && is_own && body_.is_grid(mesh_.source[vertex]))
      return channels.at(surface, body_.grid_points[mesh_.source[vertex]], out);

    booleans::RationalPoint p;
    if (is_own)
      for (std::size_t k = 0; k < 3; ++k)
        p[k] = exact::coordinate(body_.point(mesh_.source[vertex]), static_cast<int>(k));
    else
      p = mesh_.added[vertex - mesh_.source.size()];
    booleans::RationalPoint q;
    for (std::size_t k = 0; k < 3; ++k)
      q[k] = to_seeds_[k][0] * p[0] + to_seeds_[k][1] * p[1] + to_seeds_[k][2] * p[2] + to_seeds_[k][3];
    channels.at(surface, q, out);
  }

 private:
  const booleans::Body& body_;
  const booleans::Triangulated& mesh_;
  const booleans::PositionMap to_seeds_;
  const bool is_same_;
};

}  // namespace

PublicChannels public_channels(const booleans::Body& body, const booleans::Triangulated& mesh,
                               const booleans::TriangleLabels& labels, const booleans::PositionMap& to_model) {
  PublicChannels result;
  std::vector<std::optional<SeedPlaces>> places(labels.origins ? labels.origins->size() : 0);
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    const Origins::Pointer& origin = (*labels.origins)[i];
    if (!origin || !origin->channels) continue;
    result.count = std::max(result.count, origin->channels->count);
    places[i].emplace(body, mesh, booleans::composed(to_model, origin->channels->to_seeds));
  }
  if (result.count == 0) return result;

  result.values.resize(mesh.corners.size() * result.count);
  grid::in_stretches(
      mesh.triangle_count(), grid::stretch(std::size_t{1} << 10), [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
          const Provenance& p = labels.of_triangle[t];
          if (!places[p.origin()]) continue;
          const booleans::Origin& origin = *(*labels.origins)[p.origin()];
          for (std::size_t i = 3 * t; i < 3 * t + 3; ++i)
            places[p.origin()]->write(*origin.channels, origin.surface(p.face()), mesh.corners[i],
                                      std::span(result.values).subspan(i * result.count, origin.channels->count));
        }
      });
  return result;
}

ChannelMesh split_by_channels(const LabelledMesh& mesh) {
  ChannelMesh result;
  result.channel_count = mesh.channel_count;
  result.triangles.reserve(mesh.triangles.size());
  const std::size_t vertices = mesh.points.size() / 3, n = mesh.channel_count;
  const auto values = [&](std::size_t corner) { return std::span(mesh.channels).subspan(corner * n, n); };

  // By vertex: the first vertex that was made of it, and after each the next one.
  constexpr std::uint32_t none = UINT32_MAX;
  std::vector<std::uint32_t> made(vertices, none), next;
  for (std::size_t corner = 0; corner < mesh.triangles.size(); ++corner) {
    const std::uint32_t v = mesh.triangles[corner];
    std::uint32_t at = made[v];
    while (at != none && !std::ranges::equal(values(corner), std::span(result.channels).subspan(at * n, n)))
      at = next[at];
    if (at == none) {
      at = static_cast<std::uint32_t>(result.merged.size());
      result.merged.push_back(v);
      next.push_back(std::exchange(made[v], at));
      for (const double x : values(corner)) result.channels.push_back(x);
      for (std::size_t k = 0; k < 3; ++k) result.points.push_back(mesh.points[3 * std::size_t{v} + k]);
    }
    result.triangles.push_back(at);
  }
  return result;
}

Result<Solid> labelled(const Solid& solid, const Original& original, Indices labels) {
  booleans::Boundary boundary = booleans::canonical(Access::body(solid));
  const std::size_t faces = boundary.face_count();
  if (const auto checked = check_label_count(labels.size(), faces); !checked) return checked.error();

  Origins origins;
  origins.add(std::make_shared<const booleans::Origin>(origin_of(original, faces, labels)));
  boundary.labels.origins = std::make_shared<const Origins>(std::move(origins));
  for (std::uint32_t f = 0; f < faces; ++f) boundary.labels.polygons.push_back({0, f});
  booleans::Body body = booleans::body_of(boundary);
  body.is_proved = Access::operand(solid).is_proved;
  return Access::solid(solid.grid(), std::move(body));
}

Solid unlabelled(const Solid& solid) {
  if (!has_labels(solid)) return solid;
  booleans::Body body = booleans::body_of(booleans::canonical(Access::body(solid)));
  body.is_proved = Access::operand(solid).is_proved;
  return Access::solid(solid.grid(), std::move(body));
}

bool has_labels(const Solid& solid) { return static_cast<bool>(Access::operand(solid).labels); }

namespace {

/// Do faces carry the same, apart from the source face?
bool carry_the_same(const booleans::Boundary& a, const booleans::Boundary& b) {
  const std::size_t n = a.face_count();
  const auto list = [&](const booleans::Boundary& boundary) {
    std::vector<std::tuple<bool, std::uint32_t, std::string, std::uint32_t, bool>> faces(n);
    for (std::size_t f = 0; f < n && boundary.labels; ++f) {
      const Provenance& p = boundary.labels.polygons[f];
      const Origins::Pointer& origin = (*boundary.labels.origins)[p.origin()];
      if (origin) faces[f] = {true, origin->id, origin->name, origin->label(p.face()), p.is_turned()};
    }
    return faces;
  };
  return list(a) == list(b);
}

}  // namespace

bool same_faces(const Solid& a, const Solid& b) {
  if (!(a.grid() == b.grid())) {
    const auto there = b.on_grid(a.grid());
    return there && same_faces(a, there.value());
  }
  const booleans::Boundary p = booleans::labelled_boundary(Access::body(a)),
                           q = booleans::labelled_boundary(Access::body(b));
  return p == q && carry_the_same(p, q);
}

}  // namespace quoin
