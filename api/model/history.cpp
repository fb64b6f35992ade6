#include "quoin/quoin.h"

namespace quoin {

History::History(Model root, std::string name)
    : versions_{{{}, {}, std::move(name), std::move(root)}}, parent_{0}, redo_{0}, count_{1} {}

History::Index History::add(Model model, std::string name) {
  const Index parent = current().index;
  const std::uint32_t depth = parent.depth + 1;
  if (count_.size() == depth) count_.push_back(0);
  const Index index{depth, count_[depth]++};
  parent_.push_back(current_);
  redo_.push_back(0);
  redo_[current_] = versions_.size();
  current_ = versions_.size();
  versions_.push_back({index, parent, std::move(name), std::move(model)});
  return index;
}

const History::Version& History::current() const { return versions_[current_]; }

bool History::undo() {
  if (current_ == 0) return false;
  redo_[parent_[current_]] = current_;
  current_ = parent_[current_];
  return true;
}

bool History::redo() {
  if (redo_[current_] == 0) return false;
  current_ = redo_[current_];
  return true;
}

bool History::go_to(Index index) {
  for (std::size_t i = 0; i < versions_.size(); ++i)
    if (versions_[i].index == index) {
      current_ = i;
      return true;
    }
  return false;
}

bool History::go_to(std::string_view name) {
  if (name.empty()) return false;
  for (std::size_t i = versions_.size(); i-- > 0;)
    if (versions_[i].name == name) {
      current_ = i;
      return true;
    }
  return false;
}

}  // namespace quoin
