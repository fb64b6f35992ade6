/// \file
/// Naming: which of the faces that cover a facet together gives it its name.
#pragma once

#include <span>

#include "booleans/classify/expression.h"
#include "booleans/classify/sides.h"

namespace quoin::booleans {

/// By facet: the touched face that names it where it is kept.
///
/// A leaf of the expression changes at a facet where its value in front differs from that behind; it is named by the
/// first of its faces there that look the way of the change. An inner node whose value changes is named by the first of
/// its children that change (Origins::comes_before). So a face names what it bounds alone, whatever else lies there;
/// and groups of children of a union or an intersection may be evaluated by themselves.
class Naming {
 public:
  /// Precondition: some operand has labels.
  Naming(const Arrangement& a, const Expression& expression);

  /// Names a facet. `winding`: the operands' winding numbers in front of it.
  void name(NodeId facet, std::span<const int> winding);
  ById<NodeId, TouchedId> take() { return std::move(named_); }

 private:
  struct Node {
    bool front, back;
    TouchedId name;  // of the change
    std::uint32_t children, true_front, true_back;
  };
  /// What the covers of one operand do.
  struct Change {
    OperandId operand;
    int jump;
    TouchedId forward, backward;  // the first of each jump, none where there is none
  };

  TouchedId first(TouchedId t, TouchedId u) const;
  void list_changes(NodeId facet);
  void give_to_parent(std::uint32_t i);

  const Arrangement& a_;
  const Expression& expression_;
  ById<NodeId, TouchedId> named_;
  Array<Change> changes_;  // of one facet, by operand
  Array<Node> nodes_;
};

/// What a kept facet carries. `kept`: as in Selection. Precondition: some operand has labels.
Provenance provenance_of(const Arrangement& a, TouchedId named_by, int kept);

}  // namespace quoin::booleans
