#include "booleans/sheet.h"

#include <tbb/parallel_for.h>

#include "booleans/drawing.h"

namespace quoin::booleans {

Frame::Frame(const exact::Plane& plane) {
  int k = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(plane.n[static_cast<std::size_t>(i)]) > std::abs(plane.n[static_cast<std::size_t>(k)])) k = i;
  u_ = (k + 1) % 3;
  v_ = (k + 2) % 3;
  if (plane.n[static_cast<std::size_t>(k)] < 0) std::swap(u_, v_);
}

std::vector<Sheet> draw_sheets(const TouchedFaces& touched, const Contacts& contacts, VertexTable& vertices,
                               const PlaneTable& planes) {
  std::vector<std::uint32_t> index(planes.size(), none);
  std::vector<Drawing> drawings;
  for (std::uint32_t f = 0; f < touched.faces.size(); ++f) {
    std::uint32_t& i = index[touched.faces[f].sheet];
    if (i == none) {
      i = static_cast<std::uint32_t>(drawings.size());
      drawings.emplace_back(touched.faces[f].sheet, touched, vertices, planes);
    }
    drawings[i].add_face(f);
  }
  for (const SheetSegment& s : contacts.segments) drawings[index[s.sheet]].add_segment(s);
  for (const SheetPoint& p : contacts.points) drawings[index[p.sheet]].add_point(p.vertex);

  tbb::parallel_for(std::size_t{0}, drawings.size(), [&](std::size_t i) { drawings[i].find_splits(); });
  for (Drawing& d : drawings) d.name_points(vertices);  // in sheet order: the same ids for any number of threads
  std::vector<Sheet> sheets(drawings.size());
  tbb::parallel_for(std::size_t{0}, drawings.size(), [&](std::size_t i) { sheets[i] = drawings[i].draw(); });
  return sheets;
}

}  // namespace quoin::booleans
