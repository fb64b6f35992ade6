#include "booleans/embedding.h"

#include <algorithm>

#include "booleans/pairs/own_pairs.h"
#include "booleans/places.h"
#include "booleans/stages.h"

namespace quoin::booleans {
namespace {

/// An edge of a face, the lower vertex first; or a vertex of a face, twice.
struct FacePart {
  VertexId u, v;
  TouchedId face;

  FacePart(VertexId a, VertexId b, TouchedId f) : u(std::min(a, b)), v(std::max(a, b)), face(f) {}
  friend auto operator<=>(const FacePart&, const FacePart&) = default;
};

/// A vertex where something was added or lost, and a face that has it, or has it not, as a part; none where no single
/// one does.
struct Disturbance {
  VertexId at;
  TouchedId face;
};

/// Compares one sheet with the boundaries that were drawn on it.
class SheetProof {
 public:
  /// `faces`: those of this sheet, ascending.
  SheetProof(const Touched& touched, const Sheet& sheet, const Array<TouchedId>& faces)
      : touched_(touched), sheet_(sheet), faces_(faces) {}

  std::optional<Disturbance> disturbance() const {
    if (auto d = in_parts()) return d;
    return in_facets();
  }

 private:
  /// A face has its edges, on the one side that it lies on or on both, and its touching vertices; and it has no others.
  std::optional<Disturbance> in_parts() const {
    Array<FacePart> own, drawn;
    for (const TouchedId f : faces_) {
      for (const BoundaryEdge& e : touched_.edges_of(f)) own.emplace_back(e.from, e.to, f);
      for (const VertexId v : touched_.isolated_of(f)) own.emplace_back(v, v, f);
    }
    for (std::uint32_t h = 0; h < sheet_.half_edges(); ++h)
      if (sheet_.facet[h] != none)
        for (const TouchedId f : sheet_.covers(sheet_.facet[h]))
          drawn.emplace_back(sheet_.origin(h), sheet_.target(h), f);
    for (const auto& i : sheet_.isolated)
      for (const TouchedId f : sheet_.covers(i.facet)) drawn.emplace_back(i.vertex, i.vertex, f);

    std::sort(own.begin(), own.end());
    std::sort(drawn.begin(), drawn.end());
    const auto [d, o] = std::mismatch(drawn.begin(), drawn.end(), own.begin(), own.end());
    if (d == drawn.end() && o == own.end()) return std::nullopt;
    // The smaller one is in one list only.
    const FacePart& odd = d == drawn.end() || (o != own.end() && *o < *d) ? *o : *d;
    return Disturbance{odd.u, odd.face};
  }

  /// Every facet is one whole face, and every edge bounds one.
  std::optional<Disturbance> in_facets() const {
    for (std::uint32_t h = 0; h < sheet_.half_edges(); ++h) {
      const FacetId f = sheet_.facet[h];
      const bool bounds_nothing = f == none && sheet_.facet[h ^ 1] == none;
      if (bounds_nothing || (f != none && sheet_.covers(f).size() != 1)) return Disturbance{sheet_.origin(h), none};
    }

    Array<TouchedId> covers(sheet_.cover.begin(), sheet_.cover.end());
    std::sort(covers.begin(), covers.end());
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (i >= covers.size() || covers[i] != faces_[i]) return at(faces_[i]);
    if (covers.size() > faces_.size()) return at(covers.back());
    return std::nullopt;
  }

  Disturbance at(TouchedId face) const { return {touched_.edges_of(face)[0].from, face}; }

  const Touched& touched_;
  const Sheet& sheet_;
  const Array<TouchedId>& faces_;
};

/// Two faces that meet out of place on a sheet; nothing where none do. In embedded faces a contact is an edge or a
/// vertex of both.
class MeetingFaces {
 public:
  /// New points get names.
  MeetingFaces(Arrangement& a, const FacePairs& pairs) : a_(a), pairs_(touched_pairs(a.touched, pairs)) {
    for (const TouchedId t : Ids<TouchedId>(a.touched.faces.size())) {
      for (const BoundaryEdge& e : a.touched.edges_of(t)) {
        parts_.emplace_back(e.from, e.to, t);
        parts_.emplace_back(e.from, e.from, t);
      }
      for (const VertexId v : a.touched.isolated_of(t)) parts_.emplace_back(v, v, t);
    }
    std::sort(parts_.begin(), parts_.end());
  }

  Array<TouchedId> on(const Sheet& sheet) {
    const auto is_here = [&](TouchedId t) { return a_.touched.faces[t].plane == sheet.plane; };
    for (const auto& [f, g] : pairs_)
      if ((is_here(f) || is_here(g)) && have_strange_contact(f, g)) return {f, g};

    for (FacetId f = 0; f < sheet.facet_count(); ++f)
      if (const auto covers = sheet.covers(f); covers.size() > 1) return {covers[0], covers[1]};
    return {};
  }

 private:
  bool have_strange_contact(TouchedId f, TouchedId g) {
    const auto has = [&](TouchedId t, VertexId u, VertexId v) {
      return std::binary_search(parts_.begin(), parts_.end(), FacePart(u, v, t));
    };
    const auto is_strange = [&](VertexId u, VertexId v) { return !has(f, u, v) || !has(g, u, v); };
    const Contacts contacts = find_contacts(a_.touched, {{f, g}}, a_.names);
    return std::any_of(contacts.segments.begin(), contacts.segments.end(),
                       [&](const ContactSegment& s) { return is_strange(s.a, s.b); }) ||
           std::any_of(contacts.points.begin(), contacts.points.end(),
                       [&](const ContactPoint& p) { return is_strange(p.vertex, p.vertex); });
  }

  Arrangement& a_;
  Array<TouchedPair> pairs_;
  Array<FacePart> parts_;
};

/// Distinct and ascending, by their numbers in the body.
Array<std::uint32_t> own_numbers(const Touched& touched, const Array<TouchedId>& faces) {
  Array<std::uint32_t> r;
  for (const TouchedId t : faces) r.push_back(touched.faces[t].source);
  std::sort(r.begin(), r.end());
  r.erase(std::unique(r.begin(), r.end()), r.end());
  return r;
}

/// `culprits`: nullptr, or where the faces go; new points then get names.
std::optional<std::string> crossing(Arrangement& a, const FacePairs& pairs, Array<std::uint32_t>* culprits) {
  ById<PlaneId, Array<TouchedId>> faces(a.names.planes.size());
  for (const TouchedId t : Ids<TouchedId>(a.touched.faces.size())) faces[a.touched.faces[t].plane].push_back(t);

  for (const Sheet& sheet : a.sheets) {
    const auto d = SheetProof(a.touched, sheet, faces[sheet.plane]).disturbance();
    if (!d) continue;

    if (culprits) {
      auto found = MeetingFaces(a, pairs).on(sheet);
      if (found.empty() && d->face != none) found = {d->face};
      *culprits = own_numbers(a.touched, found);
    }
    return "faces cross, overlap, touch without a common vertex, or fall into several pieces at " +
           in_grid_steps(a.names.vertices.approximation(d->at));
  }
  return std::nullopt;
}

/// A node with labels other than 0 in front and 1 behind; none where all are right.
NodeId wrong_node(const Arrangement& a, const Selection& selection) {
  for (const SheetId s : a.sheets.ids())
    for (const NodeId n : a.sheets.nodes(s)) {
      const TouchedId t = a.sheets[s].covers(a.sheets.facet_of(n))[0];
      if (selection.kept[n] != a.touched.faces[t].jump()) return n;
    }
  NodeId wrong = none;
  a.for_untouched([&](FaceId, NodeId patch) {
    if (wrong == none && selection.kept[patch] != 1) wrong = patch;
  });
  return wrong;
}

/// `culprits`: nullptr, or where the face goes.
std::optional<std::string> wrong_label(const Arrangement& a, Array<std::uint32_t>* culprits) {
  const std::string message = "faces do not separate inside from outside";
  const Selection selection = select(a, find_cells(a), Expression::itself());
  const NodeId n = selection.is_consistent ? wrong_node(a, selection) : selection.contradiction;
  if (n == none) return selection.is_consistent ? std::nullopt : std::optional(message);

  const NodePlace place = place_of(a, n);
  if (culprits) *culprits = {a.operands.own(place.face).face};
  return selection.is_consistent ? message + " at " + in_grid_steps(place.corner) : message;
}

}  // namespace

std::optional<std::string> embedding_fault(const Body& body, Array<std::uint32_t>* faces) {
  if (faces) faces->clear();
  if (!body.is_packed) return embedding_fault(packed(body), faces);

  // A clean body adds nothing to the drawing of its own doubtful faces with all that meets them.
  Operands operands({&body}, false);
  operands.are_proved = false;
  const FacePairs pairs = doubtful_pairs(body);
  Result<Arrangement> a = arrange(std::move(operands), pairs);
  if (auto message = crossing(a.value(), pairs, faces)) return message;
  return wrong_label(a.value(), faces);
}

}  // namespace quoin::booleans
