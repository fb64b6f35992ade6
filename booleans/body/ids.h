/// \file
/// The ids of an operation: one kind for each sort of thing that is numbered through all operands.
///
/// Within one body vertices and faces have plain numbers, as in the arrays they come from (body.h). Where several
/// bodies meet, meanings would mix; so whatever an operation numbers has a kind of its own.
#pragma once

#include "grid/lists/ids.h"

namespace quoin::booleans {

using grid::Array;
using grid::ById;
using grid::Ids;

/// One of the bodies that an operation combines.
using OperandId = grid::Id<struct OperandKind>;
/// A face of any operand: the operands' faces are numbered through.
using FaceId = grid::Id<struct FaceKind>;
/// A distinct point of an operation (names.h).
using VertexId = grid::Id<struct VertexKind>;
/// A distinct plane of an operation, whatever its orientation (names.h).
using PlaneId = grid::Id<struct PlaneKind>;
/// A touched face: a maximal plane region of one operand that something foreign meets (touched.h).
using TouchedId = grid::Id<struct TouchedKind>;
/// A sheet: all touched faces on one plane, drawn together (sheets.h).
using SheetId = grid::Id<struct SheetKind>;
/// A facet of one sheet.
using FacetId = grid::Id<struct FacetKind>;
/// A facet of any sheet, or a patch of untouched faces: facets are numbered through, then patches (patches.h).
using NodeId = grid::Id<struct NodeKind>;
/// A connected component of nodes (cells.h).
using ComponentId = grid::Id<struct ComponentKind>;
/// A class of sides that look into the same region of space (cells.h).
using CellId = grid::Id<struct CellKind>;

}  // namespace quoin::booleans
