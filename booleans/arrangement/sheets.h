/// \file
/// Sheets: all touched faces on one plane, drawn together as one planar subdivision.
#pragma once

#include "booleans/arrangement/contacts.h"

namespace quoin::booleans {

/// An element of any sheet: the elements of all sheets are numbered through.
using ElementId = grid::Id<struct ElementKind>;

/// The subdivision. Half-edge 2e runs from a to b of element e, half-edge 2e + 1 back; facets lie on the left seen from
/// the canonical normal. What it lists is kept by `Sheets`.
struct Sheet {
  struct Element {
    VertexId a, b;  // a before b in the plane's frame
    PlaneId line;   // another plane through both
  };
  struct Isolated {
    VertexId vertex;
    FacetId facet;
  };
  PlaneId plane;
  std::span<const Element> elements;
  std::span<const std::uint32_t> clockwise;  // per half-edge: the next one clockwise around its origin
  std::span<const FacetId> facet;            // per half-edge: the facet on its left, none where no face covers
  // Facet i is covered by the touched faces cover[cover_start[i]] .., one that overlaps itself listed repeatedly.
  std::span<const std::uint32_t> cover_start;
  std::span<const TouchedId> cover;
  std::span<const Isolated> isolated;

  std::size_t facet_count() const { return cover_start.size() - 1; }
  std::uint32_t half_edges() const { return static_cast<std::uint32_t>(facet.size()); }
  std::span<const TouchedId> covers(FacetId f) const {
    return cover.subspan(cover_start[f.value], cover_start[f.value + 1] - cover_start[f.value]);
  }
  VertexId origin(std::uint32_t h) const { return h & 1 ? elements[h / 2].b : elements[h / 2].a; }
  VertexId target(std::uint32_t h) const { return h & 1 ? elements[h / 2].a : elements[h / 2].b; }
};

/// The lists of many sheets, one after the other.
struct SheetLists {
  Array<Sheet::Element> elements;
  Array<std::uint32_t> clockwise;
  Array<FacetId> facet;
  Array<std::uint32_t> cover_start;
  Array<TouchedId> cover;
  Array<Sheet::Isolated> isolated;
};

/// A touched face with spared loops, and the facet of its outer loop, in which they lie; none where a trusted operand
/// crosses itself there.
struct SparedFace {
  NodeId facet;
  TouchedId face;
};

/// All sheets of an arrangement. Facets of all sheets are numbered through as nodes, elements too.
class Sheets {
 public:
  Sheets() = default;
  /// `sheets` refer to `lists`; `sheet_of`: by plane.
  Sheets(ById<SheetId, Sheet> sheets, Array<SheetLists> lists, const Touched& touched,
         const ById<PlaneId, SheetId>& sheet_of);

  std::size_t size() const { return sheets_.size(); }
  Ids<SheetId> ids() const { return sheets_.size(); }
  const Sheet& operator[](SheetId s) const { return sheets_[s]; }
  auto begin() const { return sheets_.begin(); }
  auto end() const { return sheets_.end(); }

  std::uint32_t facet_count() const { return static_cast<std::uint32_t>(sheet_of_.size()); }
  std::uint32_t element_count() const { return first_element_.back().value; }
  NodeId node(SheetId s, FacetId f) const { return first_node_[s].value + f.value; }
  /// The nodes of a sheet's facets.
  Ids<NodeId> nodes(SheetId s) const { return {first_node_[s], first_node_[s.value + 1]}; }
  ElementId element(SheetId s, std::uint32_t e) const { return first_element_[s].value + e; }

  /// All faces that have spared loops, by facet; those of one sheet; those whose loops lie in a facet.
  std::span<const SparedFace> spared() const { return spared_; }
  std::span<const SparedFace> spared(SheetId s) const;
  std::span<const SparedFace> spared(NodeId facet) const;

  bool is_facet(NodeId n) const { return n < facet_count(); }
  /// Preconditions: is_facet(n).
  SheetId sheet_of(NodeId n) const { return sheet_of_[n]; }
  FacetId facet_of(NodeId n) const { return n.value - first_node_[sheet_of_[n]].value; }

 private:
  ById<SheetId, Sheet> sheets_;
  Array<SheetLists> lists_;
  ById<SheetId, NodeId> first_node_ = {NodeId(0)};           // plus the total
  ById<SheetId, ElementId> first_element_ = {ElementId(0)};  // plus the total
  ById<NodeId, SheetId> sheet_of_;
  Array<SparedFace> spared_;  // by facet
};

/// Draws a sheet for each plane that has touched faces. New crossing points get names in the order of the sheets.
Sheets draw_sheets(const Touched& touched, const Contacts& contacts, Names& names);

}  // namespace quoin::booleans
