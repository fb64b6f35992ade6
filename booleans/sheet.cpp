#include "booleans/sheet.h"

#include <tbb/enumerable_thread_specific.h>

#include <numeric>

#include "booleans/drawing.h"
#include "grid/stretches.h"

namespace quoin::booleans {

Frame::Frame(const exact::Plane& plane) {
  int k = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(plane.n[static_cast<std::size_t>(i)]) > std::abs(plane.n[static_cast<std::size_t>(k)])) k = i;
  u_ = (k + 1) % 3;
  v_ = (k + 2) % 3;
  if (plane.n[static_cast<std::size_t>(k)] < 0) std::swap(u_, v_);
}

namespace {

/// Items by the sheet they belong to, in their order.
class BySheet {
 public:
  template <class SheetOf>
  BySheet(std::size_t sheets, std::size_t items, SheetOf sheet_of) : start_(sheets + 2), item_(items) {
    for (std::size_t i = 0; i < items; ++i) ++start_[sheet_of(i) + 2];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    for (std::uint32_t i = 0; i < items; ++i) item_[start_[sheet_of(i) + 1]++] = i;
  }
  std::span<const std::uint32_t> operator[](std::size_t sheet) const {
    return std::span(item_).subspan(start_[sheet], start_[sheet + 1] - start_[sheet]);
  }

 private:
  std::vector<std::uint32_t> start_, item_;
};

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
  SheetLists lists;
  std::vector<std::pair<std::uint32_t, Extent>> drawn;  // sheets and where they begin
  std::vector<std::pair<std::uint32_t, Outline>> open;  // sheets that wait for the names of new points

  void draw(Drawing& drawing, std::uint32_t sheet) {
    drawn.emplace_back(sheet, Extent(lists));
    drawing.draw(lists);
  }
  void finish(Sheets& sheets) {
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      const auto& [sheet, at] = drawn[i];
      const Extent end = i + 1 < drawn.size() ? drawn[i + 1].second : Extent(lists);
      Sheet& s = sheets[sheet];
      s.elements = std::span(lists.elements).subspan(at.element, end.element - at.element);
      s.clockwise = std::span(lists.clockwise).subspan(2 * at.element, 2 * s.elements.size());
      s.facet = std::span(lists.facet).subspan(2 * at.element, 2 * s.elements.size());
      s.cover_start = std::span(lists.cover_start).subspan(at.cover_start, end.cover_start - at.cover_start);
      s.cover = std::span(lists.cover).subspan(at.cover, end.cover - at.cover);
      s.isolated = std::span(lists.isolated).subspan(at.isolated, end.isolated - at.isolated);
    }
    sheets.keep(std::move(lists));
  }
};

}  // namespace

Sheets draw_sheets(const TouchedFaces& touched, const Contacts& contacts, VertexTable& vertices,
                   const PlaneTable& planes) {
  std::vector<std::uint32_t> index(planes.size(), none), plane_of;
  for (const TouchedFace& f : touched.faces)
    if (index[f.sheet] == none) {
      index[f.sheet] = static_cast<std::uint32_t>(plane_of.size());
      plane_of.push_back(f.sheet);
    }
  const std::size_t n = plane_of.size();
  const BySheet faces(n, touched.faces.size(), [&](std::size_t i) { return index[touched.faces[i].sheet]; });
  const BySheet segments(n, contacts.segments.size(), [&](std::size_t i) { return index[contacts.segments[i].sheet]; });
  const BySheet points(n, contacts.points.size(), [&](std::size_t i) { return index[contacts.points[i].sheet]; });

  Sheets sheets(n);
  tbb::enumerable_thread_specific<Drawing> drawings([&] { return Drawing(touched, vertices, planes); });
  constexpr std::size_t batch_size = 64;
  std::vector<Batch> batches((n + batch_size - 1) / batch_size);
  grid::in_stretches(n, batch_size, [&](std::size_t b, std::size_t begin, std::size_t end) {
    Drawing& drawing = drawings.local();
    for (auto s = static_cast<std::uint32_t>(begin); s < end; ++s) {
      sheets[s].plane = plane_of[s];
      drawing.begin(plane_of[s]);
      for (std::uint32_t f : faces[s]) drawing.add_face(f);
      for (std::uint32_t i : segments[s]) drawing.add_segment(contacts.segments[i]);
      for (std::uint32_t i : points[s]) drawing.add_point(contacts.points[i].vertex);
      drawing.find_splits();
      if (drawing.outline().new_points.empty())
        batches[b].draw(drawing, s);
      else
        batches[b].open.emplace_back(s, std::move(drawing.outline()));
    }
  });
  // New points get their names in sheet order: the same ids for any number of threads.
  for (Batch& batch : batches)
    for (auto& [s, outline] : batch.open) outline.name_points(vertices);
  grid::in_stretches(batches.size(), 1, [&](std::size_t b, std::size_t, std::size_t) {
    Drawing& drawing = drawings.local();
    for (auto& [s, outline] : batches[b].open) {
      drawing.begin(std::move(outline));
      batches[b].draw(drawing, s);
    }
  });
  for (Batch& batch : batches) batch.finish(sheets);
  return sheets;
}

}  // namespace quoin::booleans
