#include "booleans/embedding.h"

#include <cstdio>

#include "booleans/pairs/own_pairs.h"
#include "booleans/stages.h"

namespace quoin::booleans {
namespace {

std::string at(const std::array<double, 3>& p) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), " at (%.15g, %.15g, %.15g) grid steps", p[0], p[1], p[2]);
  return text.data();
}

using Pair = std::array<std::uint32_t, 2>;

/// What one list has and the other has not; nothing when they are equal.
std::optional<VertexId> difference(std::vector<Pair> drawn, std::vector<Pair> own) {
  std::sort(drawn.begin(), drawn.end());
  std::sort(own.begin(), own.end());
  const auto [d, o] = std::mismatch(drawn.begin(), drawn.end(), own.begin(), own.end());
  if (d != drawn.end()) return VertexId((*d)[0]);
  if (o != own.end()) return VertexId((*o)[0]);
  return std::nullopt;
}

/// Compares one sheet with the boundaries that were drawn on it.
class SheetProof {
 public:
  /// `faces`: those of this sheet, ascending.
  SheetProof(const Touched& touched, const Sheet& sheet, const std::vector<TouchedId>& faces)
      : touched_(touched), sheet_(sheet), faces_(faces) {}

  /// A vertex where something was added or lost.
  std::optional<VertexId> disturbance() const {
    if (auto v = in_edges()) return v;
    if (auto v = in_facets()) return v;
    return in_points();
  }

 private:
  std::optional<VertexId> in_edges() const {
    std::vector<Pair> own, drawn;
    for (const TouchedId f : faces_)
      for (const BoundaryEdge& e : touched_.edges_of(f))
        own.push_back({std::min(e.from, e.to).value, std::max(e.from, e.to).value});
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());

    for (const auto& e : sheet_.elements) drawn.push_back({std::min(e.a, e.b).value, std::max(e.a, e.b).value});
    return difference(std::move(drawn), std::move(own));
  }

  /// Touching vertices, each with the one face that it lies in. Precondition: the facets are whole faces.
  std::optional<VertexId> in_points() const {
    std::vector<Pair> own, drawn;
    for (const TouchedId f : faces_)
      for (const VertexId v : touched_.isolated_of(f)) own.push_back({v.value, f.value});
    for (const auto& i : sheet_.isolated) drawn.push_back({i.vertex.value, sheet_.covers(i.facet)[0].value});
    return difference(std::move(drawn), std::move(own));
  }

  /// Every facet is one whole face, and every edge bounds one: on one side, or on both where other faces touch it.
  std::optional<VertexId> in_facets() const {
    for (std::uint32_t h = 0; h < sheet_.half_edges(); ++h) {
      const FacetId f = sheet_.facet[h];
      const bool bounds_nothing = f == none && sheet_.facet[h ^ 1] == none;
      if (bounds_nothing || (f != none && sheet_.covers(f).size() != 1)) return sheet_.origin(h);
    }

    std::vector<TouchedId> covers(sheet_.cover.begin(), sheet_.cover.end());
    std::sort(covers.begin(), covers.end());
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (i >= covers.size() || covers[i] != faces_[i]) return touched_.edges_of(faces_[i])[0].from;
    if (covers.size() > faces_.size()) return touched_.edges_of(faces_[0])[0].from;
    return std::nullopt;
  }

  const Touched& touched_;
  const Sheet& sheet_;
  const std::vector<TouchedId>& faces_;
};

std::optional<std::string> crossing(const Arrangement& a) {
  ById<PlaneId, std::vector<TouchedId>> faces(a.names.planes.size());
  for (const TouchedId t : Ids<TouchedId>(a.touched.faces.size())) faces[a.touched.faces[t].plane].push_back(t);

  for (const Sheet& sheet : a.sheets)
    if (const auto v = SheetProof(a.touched, sheet, faces[sheet.plane]).disturbance())
      return "faces cross, overlap, touch without a common vertex, or fall into several pieces" +
             at(a.names.vertices.approximation(*v));
  return std::nullopt;
}

/// Faces with labels other than 0 in front and 1 behind.
std::optional<std::string> wrong_label(const Arrangement& a, const Body& body) {
  const std::string message = "faces do not separate inside from outside";
  const Selection selection = select(a, find_cells(a), Expression::itself());
  if (!selection.is_consistent) return message;

  for (const SheetId s : a.sheets.ids())
    for (const NodeId n : a.sheets.nodes(s)) {
      const TouchedId t = a.sheets[s].covers(a.sheets.facet_of(n))[0];
      if (selection.kept[n] != a.touched.faces[t].jump())
        return message + at(a.names.vertices.approximation(a.touched.edges_of(t)[0].from));
    }
  for (std::uint32_t f = 0; f < body.face_count(); ++f)
    if (const NodeId patch = a.patches().of[FaceId(f)]; patch != none && selection.kept[patch] != 1)
      return message + at(body.approximation(body.corners_of(f).back()));
  return std::nullopt;
}

}  // namespace

std::optional<std::string> embedding_fault(const Body& body) {
  if (!body.is_packed) return embedding_fault(packed(body));
  // A clean body adds nothing to the drawing of its own doubtful faces with all that meets them.
  Operands operands({&body}, false);
  operands.are_proved = false;
  const Result<Arrangement> a = arrange(std::move(operands), doubtful_pairs(body));
  if (auto message = crossing(a.value())) return message;
  return wrong_label(a.value(), body);
}

}  // namespace quoin::booleans
