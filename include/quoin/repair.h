/// \file
/// What can be wrong with the surface of a mesh, and the cures that may be asked for.
#pragma once

#include "quoin/export.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "quoin/result.h"

namespace quoin {

enum class Defect : std::uint8_t {
  crack,        // two boundaries run along each other, a short way apart
  t_junction,   // a vertex lies near a neighbour's edge, not at its ends
  duplicate,    // a face is there more often than the surface needs it
  flap,         // faces hang on a surface that is closed without them, or lie loose
  orientation,  // a face looks the other way than its neighbours
  hole,         // a loop of boundary edges
  branch,       // an odd number of faces meet at an edge, and none of them is a flap
  inside_out,   // a shell looks inwards and lies in no other one
};

/// The word in kebab-case: "t-junction".
QUOIN_API std::string to_string(Defect kind);

/// One kind of damage, or of cure, with all its places.
struct Finding {
  Defect kind = Defect::hole;
  /// Of places: vertices of a crack or T-junction, faces, loops, edges, shells.
  std::uint64_t count = 0;
  /// Model units, of the largest place: the width of a crack, the distance from an edge, how far a hole reaches (the
  /// diagonal of its box); 0 where there is nothing to measure. An upper bound.
  double size = 0;
  /// The largest place: "near (x, y, z)" in model units.
  std::string where = {};
  /// What Repair::parse takes and --repair: "weld=0.002"; empty where nothing helps.
  std::string cure = {};
  /// All of it for people, without the place.
  std::string sentence = {};
};

/// What is wrong with a surface; nothing where it is closed and no shell of it is inside out.
struct Diagnosis {
  std::vector<Finding> findings;
};

/// How shells are to look.
enum class Orient : std::uint8_t {
  as_is,
  nested,  // neighbours alike; out where a shell lies in an even number of others, inwards in an odd one: a void
  solid,   // neighbours alike, all shells outwards
};

/// Cures, done in this order; none is done unless it is asked for. Each counts in ImportReport::repairs what it did.
/// Tolerances are decimals or rationals in model units; empty: not asked for.
struct Repair {
  /// Boundary vertices within this distance become one; all others stay. The two ends of an edge never do.
  std::string weld = {};
  /// Boundary edges bend to boundary vertices within this distance, where that closes a part of them.
  std::string t_junctions = {};
  /// Exact duplicates of faces at which the surface is not closed go, and so do flaps of any size.
  bool duplicates = false;
  Orient orient = Orient::as_is;
  /// Planar holes (within 4 grid steps) are closed, whatever their size.
  bool caps = false;
  /// Holes whose box has at most this diagonal are closed, planar or not.
  std::string caps_size = {};
  /// Shells that look inwards and lie in no other one are turned round, with those directly inside that look outwards.
  bool invert_shells = false;
  /// Everything, with tolerances taken from the mesh. A gap is closed where it is at most 1/8 of the shortest edge at
  /// its ends and 1/128 of the mesh's extent; a hole where its cap has at most half of the area of the surface around
  /// it (areas by |x| + |y| + |z|), 1/64 if its rim bends out of a plane by more than 1/32 of its size, and that
  /// surface is no terrain over it. A flap goes where it has at most half of the area of what it hangs on. Neighbours
  /// are oriented alike, as most of them are; closed shells are only turned as `invert_shells` does.
  bool all = false;

  bool is_asked() const;
  /// "weld=0.01,orient": NAME[=VALUE], separated by commas. Names: all, weld=TOL, t-junctions=TOL, duplicates, orient,
  /// orient=solid, caps, caps=SIZE, invert-shells. Errors: "usage".
  QUOIN_API static Result<Repair> parse(std::string_view text);
};

inline bool Repair::is_asked() const {
  return all || duplicates || caps || invert_shells || orient != Orient::as_is || !weld.empty() ||
         !t_junctions.empty() || !caps_size.empty();
}

}  // namespace quoin
