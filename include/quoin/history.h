/// \file
/// Versions of a model as a tree.
#pragma once

#include "quoin/export.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "quoin/model.h"

namespace quoin {

/// Versions of a model as a tree: a change after an undo begins a new branch and nothing is lost.
/// A version's index is (depth, order): the root has depth 0, a child one more than its parent; order counts the
/// versions of one depth in the order in which they were made, from 0.
class QUOIN_API History {
 public:
  struct Index {
    std::uint32_t depth = 0, order = 0;
    friend bool operator==(const Index&, const Index&) = default;
    friend auto operator<=>(const Index&, const Index&) = default;
  };
  struct Version {
    Index index;
    std::optional<Index> parent;
    std::string name;
    Model model;
  };

  explicit History(Model root, std::string name = {});
  /// Makes a version after the current one and goes there. A name may be given to several: the last one counts.
  Index add(Model model, std::string name = {});
  const Version& current() const;
  /// To the parent; false at the root.
  bool undo();
  /// To the child that an undo left last or, if none did since, that was made last; false where there is no child.
  bool redo();
  /// False where there is no such version.
  bool go_to(Index index);
  bool go_to(std::string_view name);
  /// All versions in the order in which they were made.
  const std::vector<Version>& versions() const { return versions_; }

 private:
  std::vector<Version> versions_;
  std::vector<std::size_t> parent_, redo_;
  std::vector<std::uint32_t> count_;  // by depth
  std::size_t current_ = 0;
};

}  // namespace quoin
