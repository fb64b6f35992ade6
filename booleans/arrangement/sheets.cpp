#include "booleans/arrangement/sheets.h"

#include <tbb/enumerable_thread_specific.h>

#include <optional>

#include "booleans/arrangement/outline.h"
#include "booleans/arrangement/subdivision.h"
#include "grid/lists/buckets.h"
#include "grid/lists/kept.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {

namespace {

/// The facet on the inner side of the first edge of a face, which is on its outer loop. Of a clean operand it runs as
/// it did; none where other faces of a trusted one cut it.
FacetId outer_facet(const Sheet& sheet, const Touched& touched, TouchedId face) {
  const BoundaryEdge& e = touched.edges_of(face)[0];
  const auto find = [&](VertexId a, VertexId b) -> std::uint32_t {
    const auto at = std::lower_bound(
        sheet.elements.begin(), sheet.elements.end(), std::pair(a, b),
        [](const Sheet::Element& x, const std::pair<VertexId, VertexId>& key) { return std::pair(x.a, x.b) < key; });
    const bool found = at != sheet.elements.end() && at->a == a && at->b == b;
    return found ? static_cast<std::uint32_t>(at - sheet.elements.begin()) : none;
  };

  const bool along = touched.faces[face].along;
  if (const std::uint32_t i = find(e.from, e.to); i != none) return sheet.facet[2 * i + !along];
  const std::uint32_t i = find(e.to, e.from);
  return i != none ? sheet.facet[2 * i + along] : FacetId(none);
}

}  // namespace

Sheets::Sheets(ById<SheetId, Sheet> sheets, Array<SheetLists> lists, const Touched& touched,
               const ById<PlaneId, SheetId>& sheet_of)
    : sheets_(std::move(sheets)), lists_(std::move(lists)) {
  first_node_.reserve(sheets_.size() + 1);
  first_element_.reserve(sheets_.size() + 1);
  for (const Sheet& s : sheets_) {
    first_node_.push_back(first_node_.back().value + static_cast<std::uint32_t>(s.facet_count()));
    first_element_.push_back(first_element_.back().value + static_cast<std::uint32_t>(s.elements.size()));
  }
  sheet_of_.resize(first_node_.back().value);
  for (const SheetId s : ids())
    for (const NodeId n : nodes(s)) sheet_of_[n] = s;

  if (touched.spared.empty()) return;
  for (const TouchedId t : Ids<TouchedId>(touched.faces.size()))
    if (!touched.spared_of(t).empty()) {
      const SheetId s = sheet_of[touched.faces[t].plane];
      const FacetId facet = outer_facet(sheets_[s], touched, t);
      spared_.push_back({facet == none ? NodeId(none) : node(s, facet), t});
    }
  std::sort(spared_.begin(), spared_.end(), [](const SparedFace& x, const SparedFace& y) { return x.facet < y.facet; });
}

namespace {

/// Those of facets first .. last - 1.
std::span<const SparedFace> within(const Array<SparedFace>& spared, NodeId first, NodeId last) {
  const auto at = [&](NodeId n) {
    return std::lower_bound(spared.begin(), spared.end(), n,
                            [](const SparedFace& x, NodeId facet) { return x.facet < facet; });
  };
  return {at(first), at(last)};
}

}  // namespace

std::span<const SparedFace> Sheets::spared(SheetId s) const {
  return within(spared_, first_node_[s], first_node_[s.value + 1]);
}

std::span<const SparedFace> Sheets::spared(NodeId facet) const { return within(spared_, facet, facet.value + 1); }

namespace {

/// What is drawn on each sheet, before it is drawn.
struct Plan {
  ById<SheetId, PlaneId> plane;
  ById<PlaneId, SheetId> sheet_of;
  grid::Buckets<> faces, segments, points;  // by sheet

  Plan(const Touched& touched, const Contacts& contacts, std::size_t planes) : sheet_of(planes) {
    plane.reserve(touched.faces.size());
    for (const TouchedFace& f : touched.faces)
      if (sheet_of[f.plane] == none) sheet_of[f.plane] = plane.add(f.plane);

    const std::size_t n = plane.size();
    const auto sheet = [&](PlaneId p) { return sheet_of[p].value; };
    faces = grid::in_buckets(touched.faces.size(), n, [&](TouchedId t) { return sheet(touched.faces[t].plane); });
    segments = grid::in_buckets(contacts.segments.size(), n,
                                [&](std::uint32_t i) { return sheet(contacts.segments[i].plane); });
    points =
        grid::in_buckets(contacts.points.size(), n, [&](std::uint32_t i) { return sheet(contacts.points[i].plane); });
  }
};

/// Is a sheet one face of a clean operand, met by faces of others, clean too, in segments whose ends' places are known?
/// Faces of a clean operand meet in common edges and vertices only, so the segments of one operand meet in common ends
/// only, and end on the face's boundary or where another one goes on.
bool is_lone_face(const Touched& touched, const Contacts& contacts, std::span<const std::uint32_t> faces,
                  std::span<const std::uint32_t> segments, std::span<const std::uint32_t> points) {
  if (!touched.cover_once || faces.size() != 1 || !points.empty() || !touched.isolated_of(faces[0]).empty())
    return false;
  const OperandId own = touched.faces[faces[0]].operand;
  return std::all_of(segments.begin(), segments.end(), [&](std::uint32_t i) {
    const ContactSegment& s = contacts.segments[i];
    return s.other != own && s.at_a != unknown_place;
  });
}

/// Where a sheet's lists begin, until all that share the lists are drawn.
struct Extent {
  std::size_t element, cover_start, cover, isolated;
  explicit Extent(const SheetLists& l)
      : element(l.elements.size()),
        cover_start(l.cover_start.size()),
        cover(l.cover.size()),
        isolated(l.isolated.size()) {}
};

/// Sheets drawn into common lists.
struct Batch {
  struct Drawn {
    SheetId sheet;
    Extent begin;
  };
  struct Open {
    SheetId sheet;
    Outline outline;
  };
  SheetLists lists;
  Array<Drawn> drawn;
  Array<Open> open;  // sheets that wait for the names of new points

  /// Room for sheets of so many boundary edges and contact segments, enough where each is one face, cut by one line.
  void reserve(std::size_t sheets, std::size_t edges, std::size_t segments) {
    const std::size_t elements = edges + segments + 2 * sheets;
    lists.elements.reserve(elements);
    lists.clockwise.reserve(2 * elements);
    lists.facet.reserve(2 * elements);
    lists.cover_start.reserve(3 * sheets);
    lists.cover.reserve(2 * sheets);
    drawn.reserve(sheets);
  }
  void add(SheetId sheet, const Names& names, Outline& outline, Drawing& drawing) {
    drawn.push_back({sheet, Extent(lists)});
    draw(names, outline, drawing, lists);
  }
  void finish(ById<SheetId, Sheet>& sheets) const {
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      const Extent &at = drawn[i].begin, end = i + 1 < drawn.size() ? drawn[i + 1].begin : Extent(lists);
      Sheet& s = sheets[drawn[i].sheet];
      s.elements = std::span(lists.elements).subspan(at.element, end.element - at.element);
      s.clockwise = std::span(lists.clockwise).subspan(2 * at.element, 2 * s.elements.size());
      s.facet = std::span(lists.facet).subspan(2 * at.element, 2 * s.elements.size());
      s.cover_start = std::span(lists.cover_start).subspan(at.cover_start, end.cover_start - at.cover_start);
      s.cover = std::span(lists.cover).subspan(at.cover, end.cover - at.cover);
      s.isolated = std::span(lists.isolated).subspan(at.isolated, end.isolated - at.isolated);
    }
  }
};

/// What sheets are drawn in: memory that is kept from sheet to sheet.
struct Desk {
  Outline outline;
  Drawing drawing;
};

/// One for each thread. Those of small operations are kept for the next operation of the thread.
class Desks {
 public:
  explicit Desks(const Names& names) {
    if (names.vertices.size() >= few_vertices || !grid::kept_by_thread<Desk>()) own_.emplace();
  }

  Desk& local() { return own_ ? own_->local() : *grid::kept_by_thread<Desk>(); }

 private:
  static constexpr std::size_t few_vertices = 4096;
  std::optional<tbb::enumerable_thread_specific<Desk>> own_;
};

}  // namespace

Sheets draw_sheets(const Touched& touched, const Contacts& contacts, Names& names) {
  const Plan plan(touched, contacts, names.planes.size());
  const std::size_t n = plan.plane.size();
  Desks desks(names);
  ById<SheetId, Sheet> sheets(n);

  // Sheets whose segments cross in new points wait until these have names.
  const std::size_t length = grid::long_stretch(n, 64);
  Array<Batch> batches((n + length - 1) / length);
  grid::in_stretches(n, length, [&](std::size_t b, std::size_t begin, std::size_t end) {
    Desk& desk = desks.local();
    std::size_t edges = 0;
    for (std::size_t i = begin; i < end; ++i)
      for (const std::uint32_t f : plan.faces[i]) edges += touched.faces[f].edge_count();
    batches[b].reserve(end - begin, edges, plan.segments.start(end) - plan.segments.start(begin));

    for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
      sheets[i].plane = plan.plane[i];
      OutlineMaker maker(touched, names, plan.plane[i], desk.outline);
      if (is_lone_face(touched, contacts, plan.faces[i], plan.segments[i], plan.points[i])) {
        maker.draw_lone_face(plan.faces[i][0], contacts.segments, plan.segments[i]);
      } else {
        for (const std::uint32_t f : plan.faces[i]) maker.add_face(f);
        for (const std::uint32_t s : plan.segments[i]) maker.add_segment(contacts.segments[s]);
        for (const std::uint32_t p : plan.points[i]) maker.add_point(contacts.points[p].vertex);
        maker.find_splits();
      }
      if (desk.outline.new_points.empty())
        batches[b].add(i, names, desk.outline, desk.drawing);
      else
        batches[b].open.push_back({i, std::move(desk.outline)});
    }
  });

  // In the order of the sheets: the same ids for any number of threads.
  for (Batch& batch : batches)
    for (auto& open : batch.open) open.outline.name_points(names.vertices);

  grid::in_stretches(batches.size(), 1, [&](std::size_t b, std::size_t, std::size_t) {
    for (auto& open : batches[b].open) batches[b].add(open.sheet, names, open.outline, desks.local().drawing);
  });

  Array<SheetLists> lists;
  for (Batch& batch : batches) {
    batch.finish(sheets);
    lists.push_back(std::move(batch.lists));  // vectors keep their items where they are
  }
  return Sheets(std::move(sheets), std::move(lists), touched, plan.sheet_of);
}

}  // namespace quoin::booleans
