#include "api/model/motion_table.h"

#include <array>
#include <variant>

namespace quoin {
namespace {

/// Equal steps have equal texts.
std::string text(const rounding::Step& step) {
  std::string s = std::to_string(step.index());
  const auto add = [&](const auto& numbers) {
    for (const auto& x : numbers) {
      s += ' ';
      s += x.str();
    }
  };

  if (const auto* rotation = std::get_if<rounding::RotationStep>(&step)) {
    add(rotation->axis);
    add(std::array{rotation->degrees});
  } else if (const auto* translation = std::get_if<rounding::TranslationStep>(&step)) {
    add(translation->by);
  } else if (const auto* turn = std::get_if<rounding::TurnStep>(&step)) {
    add(std::array{turn->by.w, turn->by.x, turn->by.y, turn->by.z});
  } else if (const auto* mirror = std::get_if<rounding::MirrorStep>(&step)) {
    add(mirror->normal);
  } else {
    add(std::get<rounding::ScalingStep>(step).by);
  }
  return s;
}

}  // namespace

MotionTable::Id MotionTable::preceded(const rounding::Motion& own, Id then) {
  if (own.steps().empty()) return then;
  rounding::Motion head = own;
  if (then != 0) {
    head = head.then(motions_[then].first);
    // The two steps have become one, or none.
    if (head.steps().size() < 2) then = motions_[then].rest;
    if (head.steps().empty()) return then;
  }

  const auto [at, fresh] = ids_.try_emplace({then, text(head.steps()[0])}, motions_.size());
  if (!fresh) return at->second;
  if (head.steps().size() > 1) head = own;
  motions_.push_back({std::move(head), then});
  is_shared_.push_back(false);
  return at->second;
}

const rounding::RealizedMotion& MotionTable::realized(Id motion) {
  // The steps from one shared motion to the next, up to one that is known, or the identity.
  std::vector<std::pair<Id, rounding::Motion>> row;
  Id m = motion;
  while (m != 0 && !realized_.count(m)) {
    auto& own = row.emplace_back(m, rounding::Motion()).second;
    do {
      own.add(motions_[m].first.steps()[0]);
      m = motions_[m].rest;
    } while (m != 0 && !is_shared_[m]);
  }

  for (; !row.empty(); row.pop_back()) {
    auto& r = realized_[row.back().first] = rounding::realize(row.back().second);
    if (m != 0) r = composed(r, realized_.at(m));
    m = row.back().first;
  }
  return realized_[motion];
}

}  // namespace quoin
