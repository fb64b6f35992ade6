/// \file
/// Sheets: all touched faces on one plane, drawn together as one planar subdivision.
#pragma once

#include "booleans/contacts.h"

namespace quoin::booleans {

/// The plane's own view of its points: projected along the largest component of its canonical normal, with the two
/// other axes ordered so that counter-clockwise seen from the normal stays counter-clockwise.
class Frame {
 public:
  Frame() = default;
  explicit Frame(const exact::Plane& plane);
  int u() const { return u_; }
  int v() const { return v_; }
  /// Order of table vertices by (u, v): "left of, or below".
  int compare(const VertexTable& vertices, std::uint32_t a, std::uint32_t b) const {
    if (const int c = vertices.compare_along(u_, a, b)) return c;
    return vertices.compare_along(v_, a, b);
  }
  /// +1 when n_plane x n_line runs forward in that order, -1 when it runs backward. Precondition: not parallel.
  int direction(const exact::Plane& plane, const exact::Plane& line) const {
    if (const int c = exact::cross_sign(plane, line, u_)) return c;
    return exact::cross_sign(plane, line, v_);
  }

 private:
  int u_ = 0, v_ = 1;
};

/// The subdivision. Half-edge 2e runs from a to b of element e, half-edge 2e + 1 back; facets lie on the left seen from
/// the canonical normal. What it lists is kept by `Sheets`.
struct Sheet {
  struct Element {
    std::uint32_t a, b;  // table ids, a before b in the frame
    std::uint32_t line;  // plane id
  };
  struct Isolated {
    std::uint32_t vertex;
    std::uint32_t facet;
  };
  std::uint32_t plane = none;
  std::span<const Element> elements;
  std::span<const std::uint32_t> clockwise;  // per half-edge: the next one clockwise around its origin
  std::span<const std::uint32_t> facet;      // per half-edge: the facet on its left, none where no face covers
  // Facet i is covered by the touched faces cover[cover_start[i]] .., one that overlaps itself listed repeatedly.
  std::span<const std::uint32_t> cover_start;
  std::span<const std::uint32_t> cover;
  std::span<const Isolated> isolated;

  std::size_t facet_count() const { return cover_start.size() - 1; }
  std::uint32_t origin(std::uint32_t h) const { return h & 1 ? elements[h / 2].b : elements[h / 2].a; }
  std::uint32_t target(std::uint32_t h) const { return h & 1 ? elements[h / 2].a : elements[h / 2].b; }
};

/// The lists of many sheets, one after the other.
struct SheetLists {
  std::vector<Sheet::Element> elements;
  std::vector<std::uint32_t> clockwise, facet, cover_start, cover;
  std::vector<Sheet::Isolated> isolated;
};

/// All sheets of an arrangement.
class Sheets {
 public:
  Sheets() = default;
  explicit Sheets(std::size_t n) : sheets_(n) {}
  std::size_t size() const { return sheets_.size(); }
  const Sheet& operator[](std::size_t i) const { return sheets_[i]; }
  Sheet& operator[](std::size_t i) { return sheets_[i]; }
  auto begin() const { return sheets_.begin(); }
  auto end() const { return sheets_.end(); }
  /// Takes over what sheets refer to.
  void keep(SheetLists&& lists) { lists_.push_back(std::move(lists)); }

 private:
  std::vector<Sheet> sheets_;
  std::vector<SheetLists> lists_;
};

/// Draws a set of sheets. Every input is read only; new crossing points enter `vertices` in a fixed order.
Sheets draw_sheets(const TouchedFaces& touched, const Contacts& contacts, VertexTable& vertices,
                   const PlaneTable& planes);

}  // namespace quoin::booleans
