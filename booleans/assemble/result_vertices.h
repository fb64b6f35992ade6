/// \file
/// The vertices of a result in the making: which have their names already, and which wait until all faces are known.
#pragma once

#include "booleans/classify/selection.h"
#include "grid/lists/paged.h"

namespace quoin::booleans {

/// A vertex of the result while the number of its grid points is open: a grid point by its id, or a derived one by its
/// place among the derived ones.
class ResultName {
 public:
  ResultName() = default;  // none
  static ResultName grid(std::size_t i) { return ResultName(static_cast<std::uint32_t>(i)); }
  static ResultName derived(std::size_t i) { return ResultName(static_cast<std::uint32_t>(i) | derived_bit); }

  bool is_none() const { return bits_ == none; }
  bool is_derived() const { return (bits_ & derived_bit) != 0; }
  std::uint32_t index() const { return bits_ & ~derived_bit; }
  /// As a corner of a face that is written before the ids of derived points are known, and back.
  std::uint32_t as_corner() const { return bits_; }
  static ResultName of_corner(std::uint32_t bits) { return ResultName(bits); }

 private:
  explicit ResultName(std::uint32_t bits) : bits_(bits) {}
  static constexpr std::uint32_t derived_bit = 0x80000000u;
  std::uint32_t bits_ = none;
};

/// A vertex of faces that are not written yet: one of the table by its number there, others by numbers behind those.
using PlaceId = grid::Id<struct PlaceKind>;

/// A vertex of no touched face stays or goes with all its faces: faces of such vertices are copied, and vertices get
/// their names at once. While other faces are collected a corner is a place. The result of a small change of a large
/// operand, its host, shares the host's lists: the host's vertices keep their ids.
class ResultVertices {
 public:
  /// `host`: none when nothing is shared.
  ResultVertices(const Arrangement& a, OperandId host, Body& body);

  /// Is the operand's vertex in the table of the arrangement's vertices?
  bool in_table(OperandId operand, std::uint32_t v) const {
    if (operand == host_) return table_vertex(operand, v) != none;
    return own_names_[operand][v] == by_table || own_names_[operand][v] == listed;
  }
  VertexId table_vertex(OperandId operand, std::uint32_t v) const { return a_.names.operands[operand].of(v); }

  /// The name of an operand's vertex, which gets one if it has none, and with it a point of the body.
  ResultName named(OperandId operand, std::uint32_t v);
  ResultName name_of_table(VertexId v) const { return places_[place(v)].name; }

  /// By own vertex of an operand that is no host: the name's bits, none, or where else the name is. Copying whole
  /// meshes fills these side by side.
  Array<std::uint32_t>& own_names(OperandId operand) { return own_names_[operand]; }
  static constexpr std::uint32_t by_table = none - 1;  // that of its vertex of the table
  static constexpr std::uint32_t listed = none - 2;    // the same, of one that copied raw triangles of its operand have

  std::size_t place_count() const { return places_.size(); }
  static PlaceId place(VertexId v) { return v.value; }
  static PlaceId place(PlaceId p) { return p; }
  PlaceId place(OperandId operand, std::uint32_t v);
  bool is_grid(PlaceId p) const;

  /// A loop of at least two corners goes through a place, from one other to the next.
  void add_neighbours(PlaceId p, PlaceId before, PlaceId next);
  /// Edges need it, whatever its neighbours.
  void need(PlaceId p) { places_[p].neighbours = {p, many}; }
  /// On which side of a plane it lies.
  int side(PlaceId p, const exact::Plane& plane) const;
  /// Do edges need it? Between exactly two neighbours it lies inside a straight edge: at least two faces that are not
  /// coplanar pass through both of its edges, so both lie on the line of their planes.
  bool is_needed(PlaceId p) const { return places_[p].neighbours[1] == many; }
  /// Is it there, so that a face that it touches lists it?
  bool is_used(PlaceId p) const { return !places_[p].name.is_none() || places_[p].neighbours[0] != none; }
  /// The name of a place that stays, which gets one if it has none, and with it a point of the body.
  ResultName named(PlaceId p);

 private:
  static constexpr std::uint32_t many = none - 1;  // in place of the second neighbour: a name, or more than two of them

  struct Place {
    ResultName name;
    std::array<PlaceId, 2> neighbours = {};  // before it has a name
  };
  /// A vertex outside the table.
  struct Outside {
    OperandId operand;
    std::uint32_t vertex;
  };

  ResultName name_in_host(std::uint32_t v) const;
  ResultName host_name(std::uint32_t v);
  ResultName new_name(OperandId operand, std::uint32_t v);
  bool in_table(PlaceId p) const { return p < a_.names.vertices.size(); }
  const Outside& outside(PlaceId p) const { return outside_[p.value - a_.names.vertices.size()]; }
  ResultName add_point(PlaceId p);

  const Arrangement& a_;
  const OperandId host_;
  Body& body_;
  ById<PlaceId, Place> places_;
  Array<Outside> outside_;                          // of the places behind the table
  ById<OperandId, grid::Paged<PlaceId>> place_of_;  // by own vertex, outside the table; of no size before the first
  ById<VertexId, ResultName> host_name_of_table_;   // none where the host has no such vertex
  ById<OperandId, Array<std::uint32_t>> own_names_;
};

}  // namespace quoin::booleans
