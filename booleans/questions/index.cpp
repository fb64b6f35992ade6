#include "booleans/questions/index.h"

#include "booleans/body/canonical.h"
#include "booleans/surface/triangulated.h"

namespace quoin::booleans {
namespace {

Box triangle_box_in(const Body& body, const std::array<std::uint32_t, 3>& corners) {
  Box box;
  for (const std::uint32_t v : corners) body.add_to(box, v);
  return box;
}

}  // namespace

Index::Index(const Body& body, bool by_label) : tree_({}) {
  const Boundary form = by_label ? labelled_boundary(body) : canonical(body);
  body_ = body_of(form);
  number_ = faces_in_order_of_body(form);

  Triangulated triangles = triangulated(body_);
  face_ = std::move(triangles.face);
  corners_.reserve(face_.size());
  Array<BoxTree::Item> items;
  items.reserve(face_.size());
  for (std::uint32_t t = 0; t < face_.size(); ++t) {
    auto corners = triangles.triangle(t);
    for (std::uint32_t& v : corners) v = triangles.source[v];
    corners_.push_back(corners);
    items.push_back({triangle_box_in(body_, corners), t, 0});
    box_.add(items.back().box);
  }
  tree_ = BoxTree(items);
}

}  // namespace quoin::booleans
