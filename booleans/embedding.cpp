#include "booleans/embedding.h"

#include <cstdio>

#include "booleans/arrangement.h"
#include "booleans/candidates.h"
#include "booleans/expression.h"

namespace quoin::booleans {
namespace {

std::string at(const std::array<double, 3>& p) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), " at (%.15g, %.15g, %.15g) grid steps", p[0], p[1], p[2]);
  return text.data();
}

/// Compares one sheet with the boundaries that were drawn on it.
class SheetProof {
 public:
  SheetProof(const Arrangement& a, const Sheet& sheet, const std::vector<std::uint32_t>& faces)
      : touched_(a.touched), sheet_(sheet), faces_(faces) {}

  /// A vertex where something was added or lost.
  std::optional<std::uint32_t> disturbance() const {
    if (auto v = in_edges()) return v;
    if (auto v = in_points()) return v;
    return in_facets();
  }

 private:
  using Pair = std::array<std::uint32_t, 2>;

  static std::optional<std::uint32_t> difference(std::vector<Pair> drawn, std::vector<Pair> own) {
    std::sort(drawn.begin(), drawn.end());
    std::sort(own.begin(), own.end());
    const auto [d, o] = std::mismatch(drawn.begin(), drawn.end(), own.begin(), own.end());
    if (d != drawn.end()) return (*d)[0];
    if (o != own.end()) return (*o)[0];
    return std::nullopt;
  }

  std::optional<std::uint32_t> in_edges() const {
    std::vector<Pair> own, drawn;
    for (const std::uint32_t f : faces_)
      for (std::uint32_t e = touched_.faces[f].edges_begin; e < touched_.faces[f].edges_end; ++e) {
        const auto [low, high] = std::minmax(touched_.edges[e].from, touched_.edges[e].to);
        own.push_back({low, high});
      }
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    for (const auto& e : sheet_.elements) drawn.push_back({std::min(e.a, e.b), std::max(e.a, e.b)});
    return difference(std::move(drawn), std::move(own));
  }

  /// Touching vertices, each with the one face that it lies in.
  std::optional<std::uint32_t> in_points() const {
    std::vector<Pair> own, drawn;
    for (const std::uint32_t f : faces_)
      for (std::uint32_t i = touched_.faces[f].isolated_begin; i < touched_.faces[f].isolated_end; ++i)
        own.push_back({touched_.isolated[i], f});
    for (const auto& i : sheet_.isolated) drawn.push_back({i.vertex, sheet_.cover[sheet_.cover_start[i.facet]]});
    return difference(std::move(drawn), std::move(own));
  }

  /// Every facet is one whole face, and every edge bounds one: on one side, or on both where other faces touch it.
  std::optional<std::uint32_t> in_facets() const {
    for (std::uint32_t h = 0; h < sheet_.facet.size(); ++h) {
      const std::uint32_t f = sheet_.facet[h];
      if ((f == none && sheet_.facet[h ^ 1] == none) ||
          (f != none && sheet_.cover_start[f + 1] - sheet_.cover_start[f] != 1))
        return sheet_.origin(h);
    }
    std::vector<std::uint32_t> covers(sheet_.cover.begin(), sheet_.cover.end());
    std::sort(covers.begin(), covers.end());
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (i >= covers.size() || covers[i] != faces_[i])
        return touched_.edges[touched_.faces[faces_[i]].edges_begin].from;
    if (covers.size() > faces_.size()) return touched_.edges[touched_.faces[faces_[0]].edges_begin].from;
    return std::nullopt;
  }

  const TouchedFaces& touched_;
  const Sheet& sheet_;
  const std::vector<std::uint32_t>& faces_;  // of this sheet, ascending
};

/// Draws the doubtful faces with all their contacts.
void draw(Arrangement& a, const Body& body) {
  const std::vector<FaceIdPair> doubtful = doubtful_pairs(body);
  a.touched = collect_touched(a.operands, doubtful, a.vertices, a.planes);
  const Contacts contacts = find_contacts(a.touched, touched_pairs(a.touched, doubtful), a.vertices, a.planes);
  a.sheets = draw_sheets(a.touched, contacts, a.vertices, a.planes);
}

std::optional<std::string> crossing(const Arrangement& a) {
  std::vector<std::vector<std::uint32_t>> faces(a.planes.size());
  for (std::uint32_t f = 0; f < a.touched.faces.size(); ++f) faces[a.touched.faces[f].sheet].push_back(f);
  for (const Sheet& sheet : a.sheets)
    if (const auto v = SheetProof(a, sheet, faces[sheet.plane]).disturbance())
      return "faces cross, overlap, touch without a common vertex, or fall into several pieces" +
             at(a.vertices.approximation(*v));
  return std::nullopt;
}

/// Faces with labels other than 0 in front and 1 behind.
std::optional<std::string> wrong_label(const Arrangement& a, const Body& body) {
  Expression itself;
  itself.add({Rule::operand, false, 0, none});
  const Selection selection = select(a, itself);
  const std::string message = "faces do not separate inside from outside";
  if (!selection.consistent) return message;
  for (std::uint32_t s = 0; s < a.sheets.size(); ++s) {
    const Sheet& sheet = a.sheets[s];
    for (std::uint32_t f = 0; f < sheet.facet_count(); ++f) {
      const TouchedFace& face = a.touched.faces[sheet.cover[sheet.cover_start[f]]];
      if (selection.kept[a.facet_base[s] + f] != (face.along ? 1 : -1))
        return message + at(a.vertices.approximation(a.touched.edges[face.edges_begin].from));
    }
  }
  for (std::uint32_t f = 0; f < body.face_count(); ++f) {
    if (a.patch_of[f] == none || selection.kept[a.patch_of[f]] == 1) continue;
    std::uint32_t corner = none;
    body.for_corners(f, [&](std::uint32_t v) { corner = v; });
    return message + at(body.approximation(corner));
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> embedding_fault(const Body& body) {
  if (!body.is_packed) return embedding_fault(packed(body));
  Arrangement a({&body});
  draw(a, body);
  if (auto message = crossing(a)) return message;
  connect(a, Glue::edges);
  return wrong_label(a, body);
}

}  // namespace quoin::booleans
