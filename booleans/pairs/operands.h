/// \file
/// The operands of one operation, side by side.
#pragma once

#include <utility>
#include <vector>

#include "booleans/body/body.h"
#include "booleans/body/ids.h"
#include "grid/lists/thresholds.h"

namespace quoin::booleans {

/// A chunk of one operand.
struct OperandChunk {
  FaceId begin, end;
  Box box;  // holds them all
  OperandId operand;
  bool far;  // meets the bounds of no other operand: all its faces lie where the others are as they are at infinity
};

/// A face of an operand, by its own number.
struct OwnFace {
  OperandId operand;
  std::uint32_t face;
};

/// Two faces, smaller id first.
using FacePair = std::array<FaceId, 2>;
/// Pairs, and points that faces of pairs that were passed over have in common.
struct FacePairs : Array<FacePair> {
  using Array<FacePair>::Array;
  Array<exact::GridPoint> hubs = {};
};

/// The bodies that an operation combines. They must outlive it.
struct Operands {
  ById<OperandId, const Body*> bodies;
  ById<OperandId, FaceId> base;  // first face of each operand, plus the total
  Array<OperandChunk> chunks;
  ById<OperandId, std::uint32_t> first_chunk;  // of each operand, plus the total
  ById<OperandId, Box> bounds;                 // of each operand

  /// Are the bodies known to be clean (body.h)?
  bool are_clean;
  /// Were they proved to be?
  bool are_proved = true;

  /// The origins of all faces, null where none has labels; and of each operand the numbers of its own origins there,
  /// nothing where they are their own, of one without labels that of null.
  std::shared_ptr<const Origins> origins;
  ById<OperandId, Array<std::uint32_t>> origins_of;

  /// `joint`: origins of these bodies and perhaps others; null: those of these (`joint_origins`).
  explicit Operands(std::vector<const Body*> list, bool clean = true, std::shared_ptr<const Origins> joint = nullptr);

  Ids<OperandId> ids() const { return bodies.size(); }
  const Body& operator[](OperandId o) const { return *bodies[o]; }
  std::uint32_t face_count() const { return base.back().value; }

  FaceId face(OperandId o, std::uint32_t own) const { return base[o].value + own; }
  std::uint32_t own(OperandId o, FaceId face) const { return face.value - base[o].value; }
  /// Whose face that is.
  OwnFace own(FaceId face) const {
    if (bodies.size() == 2) return face < base[1] ? OwnFace{0, face.value} : OwnFace{1, face.value - base[1].value};
    const auto at = std::upper_bound(base.begin(), base.end(), face) - 1;
    return {static_cast<std::uint32_t>(at - base.begin()), face.value - at->value};
  }

  /// What a face of an operand carries, among all origins. Precondition: some operand has labels.
  Provenance provenance(OperandId o, std::uint32_t own) const {
    const Body& body = *bodies[o];
    if (!body.labels) return {origins_of[o][0], 0};
    const Provenance& p = body.provenance(own);
    return origins_of[o].empty() ? p : p.in(origins_of[o][p.origin()]);
  }
  /// False when the box, of faces of that operand, meets no other operand's bounds; of many operands not all are asked.
  bool may_be_near(OperandId operand, const Box& box) const {
    bool near = bodies.size() > grid::thresholds().few_operands;
    for (OperandId o = 0; o < bodies.size() && !near; ++o) near = o != operand && box.meets(bounds[o]);
    return near;
  }
  std::span<const OperandChunk> chunks_of(OperandId o) const {
    return std::span(chunks).subspan(first_chunk[o], first_chunk[o.value + 1] - first_chunk[o]);
  }
  /// The chunks of one operand, in its own face numbers, that meet one of the boxes.
  Array<Chunk> chunks_meeting(OperandId operand, std::span<const Box> boxes) const;
};

/// The origins of all bodies, ordered as these name them first; null where no body has labels. Those of the body with
/// most faces keep their numbers.
std::shared_ptr<const Origins> joint_origins(std::span<const Body* const> bodies);

}  // namespace quoin::booleans
