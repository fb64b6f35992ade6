#include "booleans/places.h"

#include <algorithm>
#include <cstdio>

namespace quoin::booleans {

std::string in_grid_steps(const std::array<double, 3>& p) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "(%.15g, %.15g, %.15g) grid steps", p[0], p[1], p[2]);
  return text.data();
}

NodePlace place_of(const Arrangement& a, NodeId n) {
  if (a.sheets.is_facet(n)) {
    const TouchedId t = a.sheets[a.sheets.sheet_of(n)].covers(a.sheets.facet_of(n))[0];
    const TouchedFace& face = a.touched.faces[t];
    return {a.operands.face(face.operand, face.source), a.names.vertices.approximation(a.touched.edges_of(t)[0].from)};
  }

  FaceId face = none;
  a.for_untouched([&](FaceId f, NodeId patch) {
    if (patch == n && face == none) face = f;
  });
  const OwnFace own = a.operands.own(face);
  const Body& body = a.operands[own.operand];
  return {face, body.approximation(body.corners_of(own.face).back())};
}

}  // namespace quoin::booleans
