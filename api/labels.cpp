#include "api/labels.h"

#include <algorithm>

#include "api/access.h"
#include "booleans/body/canonical.h"

namespace quoin {

using booleans::Boundary;
using booleans::Origins;
using booleans::Provenance;

std::shared_ptr<const booleans::Origin> origin_of(const Original& original, std::size_t faces, const Indices& labels) {
  booleans::Origin origin{original.id, original.name, static_cast<std::uint32_t>(faces), {}, {}};
  std::visit([&](const auto& list) { origin.labels.assign(list.begin(), list.end()); }, labels.values());
  return std::make_shared<const booleans::Origin>(std::move(origin));
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
    if ((*origins)[p.origin()])
      result.labels[f] = {number[p.origin()], origins->label(p), p.face(), p.is_turned()};
  }
  return result;
}

Result<Solid> labelled(const Solid& solid, const Original& original, Indices labels) {
  Boundary boundary = booleans::canonical(Access::body(solid));
  const std::size_t faces = boundary.face_count();
  if (labels.size() > 0 && labels.size() != faces)
    return Error{ErrorCode::bad_index,
                 "there are " + std::to_string(labels.size()) + " labels for " + std::to_string(faces) + " faces",
                 {},
                 "face " + std::to_string(std::min(labels.size(), faces))};

  Origins origins;
  origins.add(origin_of(original, faces, labels));
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
bool carry_the_same(const Boundary& a, const Boundary& b) {
  const std::size_t n = a.face_count();
  const auto list = [&](const Boundary& boundary) {
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
  const Boundary p = booleans::labelled_boundary(Access::body(a)), q = booleans::labelled_boundary(Access::body(b));
  return p == q && carry_the_same(p, q);
}

}  // namespace quoin
