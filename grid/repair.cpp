#include "grid/repair.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "grid/balance.h"
#include "grid/repair/cures.h"
#include "grid/shells.h"

namespace quoin::grid {

using exact::Rational;

namespace {

bool is_closed(const Surface& surface) { return is_balanced(corners_of(surface.triangles), surface.points.size()); }

/// The cures one after the other, each on a surface in canonical order.
class Course {
 public:
  /// Before welding nothing is sealed: along a crack that runs in its own direction edges overlap by chance.
  explicit Course(Surface& surface) : surface_(surface) { surface_.sort(); }

  void seal() {
    done_.sealed_t_junctions += surface_.seal();
    surface_.sort();
  }
  void weld(const Reach& reach) { note(weld_boundary(surface_, reach)); }
  void join(const Reach& reach) { note(join_t_junctions(surface_, reach)); }
  void drop_copies(bool careful) {
    note(drop_duplicates(surface_));
    note(drop_flaps(surface_, careful));
  }
  void orient() {
    if (!is_closed(surface_)) note(orient_coherently(surface_));
  }
  void close(const Caps& caps) { note(close_holes(surface_, caps, false)); }
  void turn(Turning turning) {
    if (is_closed(surface_)) note(turn_shells(surface_, turning));
  }

  /// What no cure touches.
  void look_at_holes() {
    for (const Damage& damage : close_holes(surface_, {}, true)) note(damage);
    note(branches(surface_));
    note(disagreements(surface_));
  }

  Repaired result() { return std::move(done_); }

 private:
  void note(const Damage& damage) {
    if (damage.count == 0) return;
    done_.damages.push_back(damage);
    surface_.drop_flat();
    if (damage.kind == Defect::crack)
      surface_.sort();
    else
      seal();
  }
  void note(const std::array<Damage, 2>& damages) {
    for (const Damage& damage : damages) note(damage);
  }
  Surface& surface_;
  Repaired done_;
};

/// How shells are asked to turn.
std::optional<Turning> turning_of(const Cures& cures) {
  if (cures.orient == Orient::nested) return Turning::nested;
  if (cures.orient == Orient::solid) return Turning::solid;
  if (cures.invert_shells || cures.all) return Turning::inside_out;
  return std::nullopt;
}

/// Whether no shell of a closed surface is to turn, whatever its order.
bool has_no_turn(const Surface& surface, Turning turning) {
  if (turning == Turning::nested) return false;
  const Shells all = shells(surface.points, surface.triangles);
  return !all.has_crowded_edges &&
         std::none_of(all.six_volumes.begin(), all.six_volumes.end(), [](const auto& volume) { return volume < 0; });
}

/// All cures of what is open.
void cure_boundary(Course& course, const Cures& cures, const Surface& surface, const Lattice& lattice) {
  const auto steps = [&](const Rational& distance) { return Reach(distance / lattice.step); };

  if (cures.weld) course.weld(steps(*cures.weld));
  if (cures.all) course.weld(Reach::careful(surface.points));
  course.seal();
  if (cures.t_junctions) course.join(steps(*cures.t_junctions));
  if (cures.all) course.join(Reach::careful(surface.points));
  if (cures.duplicates || cures.all) course.drop_copies(!cures.duplicates);
  if (cures.orient != Orient::as_is || cures.all) course.orient();

  Caps caps{cures.caps, std::nullopt, cures.all};
  if (cures.caps_up_to) caps.up_to = steps(*cures.caps_up_to);
  if (caps.planar || caps.up_to || caps.careful) course.close(caps);
}

}  // namespace

// What is closed has no boundary: nothing but its shells may change.
Repaired repair(Surface& surface, const Cures& cures, const Lattice& lattice) {
  surface.drop_flat();
  const bool closed = is_closed(surface);
  const std::optional<Turning> turning = turning_of(cures);
  if (closed && (!turning || has_no_turn(surface, *turning))) return {};

  Course course(surface);
  if (!closed) cure_boundary(course, cures, surface, lattice);
  if (turning) course.turn(*turning);
  return course.result();
}

Array<Damage> diagnose(Surface surface) {
  surface.drop_flat();
  Course course(surface);
  course.weld(Reach::careful(surface.points));
  course.seal();
  course.join(Reach::careful(surface.points));
  course.drop_copies(true);
  course.orient();
  course.look_at_holes();
  course.turn(Turning::inside_out);
  return course.result().damages;
}

}  // namespace quoin::grid
