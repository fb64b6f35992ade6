/// \file
/// The vertices of a result in the making: which have their names already, and which wait until all faces are known.
#pragma once

#include <unordered_map>

#include "booleans/classify/selection.h"

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

/// A vertex of faces that are not written yet.
using PlaceId = grid::Id<struct PlaceKind>;

/// A vertex of no touched face stays or goes with all its faces: faces of such vertices are copied, and vertices get
/// their names at once. While other faces are collected a corner is a place. The result of a small change of a large
/// operand, its host, shares the host's lists: the host's vertices keep their ids.
class ResultVertices {
 public:
  struct Place {
    OperandId operand;  // none: a vertex of the table, by its name there
    std::uint32_t vertex;
    ResultName name;  // if it has one
    std::array<PlaceId, 2> neighbours = {};
    bool fixed;  // it has a name, or more than two neighbours
    bool used;   // it has a name, or is on a loop of at least two corners
  };

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
  ResultName name_of_table(VertexId v) const { return name_of_table_[v]; }

  /// By own vertex of an operand that is no host: the name's bits, none, or where else the name is. Copying whole
  /// meshes fills these side by side.
  Array<std::uint32_t>& own_names(OperandId operand) { return own_names_[operand]; }
  static constexpr std::uint32_t by_table = none - 1;  // that of its vertex of the table
  static constexpr std::uint32_t listed = none - 2;    // the same, of one that copied raw triangles of its operand have

  PlaceId place_of_table(VertexId v);
  PlaceId place(OperandId operand, std::uint32_t v);
  ById<PlaceId, Place>& places() { return places_; }
  bool is_grid(const Place& p) const {
    return p.operand == none ? a_.names.vertices.is_grid(VertexId(p.vertex)) : a_.operands[p.operand].is_grid(p.vertex);
  }
  /// Its name, or none.
  ResultName known_name(const Place& p) const;
  /// Appends the place's point to the body.
  ResultName add_point(const Place& p);

 private:
  ResultName name_in_host(std::uint32_t v) const;
  ResultName host_name(std::uint32_t v);
  ResultName new_name(OperandId operand, std::uint32_t v);
  PlaceId new_place(OperandId operand, std::uint32_t v, ResultName name);

  const Arrangement& a_;
  const OperandId host_;
  Body& body_;
  ById<PlaceId, Place> places_;
  ById<VertexId, PlaceId> place_of_table_;
  ById<VertexId, ResultName> name_of_table_;
  ById<VertexId, ResultName> host_name_of_table_;  // none where the host has no such vertex
  ById<OperandId, Array<PlaceId>> place_;          // by own vertex, outside the table
  ById<OperandId, Array<std::uint32_t>> own_names_;
  std::unordered_map<std::uint32_t, PlaceId> place_in_host_;  // of vertices outside the table
};

}  // namespace quoin::booleans
