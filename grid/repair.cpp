#include "grid/repair.h"

#include <utility>

#include "grid/balance.h"
#include "grid/repair/cures.h"

namespace quoin::grid {

using exact::Rational;

namespace {

bool is_closed(const Surface& surface) { return is_balanced(corners_of(surface.triangles), surface.points.size()); }

/// The cures one after the other, each on a surface in canonical order.
class Course {
 public:
  /// Before welding nothing is sealed: along a crack that runs in its own direction edges overlap by chance.
  explicit Course(Surface& surface) : surface_(surface) {
    surface_.drop_flat();
    surface_.sort();
  }

  void seal() {
    done_.sealed_t_junctions += surface_.seal();
    surface_.sort();
  }
  void weld(const Reach& reach) { note(weld_boundary(surface_, reach)); }
  void join(const Reach& reach) { note(join_t_junctions(surface_, reach)); }
  void drop_copies() {
    note(drop_duplicates(surface_));
    note(drop_flaps(surface_));
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

}  // namespace

Repaired repair(Surface& surface, const Cures& cures, const Lattice& lattice) {
  Course course(surface);
  const auto steps = [&](const Rational& distance) { return Reach(distance / lattice.step); };

  if (cures.weld) course.weld(steps(*cures.weld));
  if (cures.all) course.weld(Reach::careful(surface.points));
  course.seal();
  if (cures.t_junctions) course.join(steps(*cures.t_junctions));
  if (cures.all) course.join(Reach::careful(surface.points));
  if (cures.duplicates || cures.all) course.drop_copies();
  if (cures.orient != Orient::as_is || cures.all) course.orient();

  Caps caps{cures.caps, std::nullopt, cures.all};
  if (cures.caps_up_to) caps.up_to = steps(*cures.caps_up_to);
  if (caps.planar || caps.up_to || caps.careful) course.close(caps);

  if (cures.orient == Orient::nested) course.turn(Turning::nested);
  if (cures.orient == Orient::solid) course.turn(Turning::solid);
  if (cures.orient == Orient::as_is && (cures.invert_shells || cures.all)) course.turn(Turning::inside_out);
  return course.result();
}

Array<Damage> diagnose(Surface surface) {
  Course course(surface);
  course.weld(Reach::careful(surface.points));
  course.seal();
  course.join(Reach::careful(surface.points));
  course.drop_copies();
  course.orient();
  course.look_at_holes();
  course.turn(Turning::inside_out);
  return course.result().damages;
}

}  // namespace quoin::grid
