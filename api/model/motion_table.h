/// \file
/// The motions of a model, each once: a node's own motion, then those of the nodes above it.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "rounding/motions/realize.h"

namespace quoin {

/// Motions by number; 0 is the identity. Equal motions have one number, by whatever path they are reached.
class MotionTable {
 public:
  using Id = std::size_t;

  MotionTable() : motions_(1), is_shared_(1, false) {}

  /// The number of `own`, a motion of one step or none, and `then` after it.
  Id preceded(const rounding::Motion& own, Id then);
  /// Several nodes are moved by it: it is realized for all of them once.
  void share(Id motion) { is_shared_[motion] = true; }
  /// The reference stays valid.
  const rounding::RealizedMotion& realized(Id motion);

 private:
  /// A motion's first step and the motion after it: those of nested nodes share their ends.
  struct Link {
    rounding::Motion first = {};  // of one step
    Id rest = 0;
  };

  std::vector<Link> motions_;
  std::vector<bool> is_shared_;
  std::map<std::pair<Id, std::string>, Id> ids_;
  std::map<Id, rounding::RealizedMotion> realized_;
};

}  // namespace quoin
