/// \file
/// Where one way of computing gives way to another.
///
/// No threshold changes a result: two ways differ in time only. In checked builds (QUOIN_CHECKED) the environment may
/// set them all, QUOIN_THRESHOLDS=smallest, =largest or =patched, so that small tests see the ways of large inputs too,
/// and tests may set single ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace quoin::grid {

struct Thresholds {
  /// Less work than this stays in the calling thread (elements).
  std::size_t small_work = 4096;
  /// Stretches of parallel work, whose results are put together, have at most so many elements.
  std::size_t stretch = std::size_t{1} << 15;
  /// Faces a chunk has at most.
  std::uint32_t chunk = 32;
  /// More operands than this are not compared one by one.
  std::size_t few_operands = 8;
  /// Fewer boxes than this are searched without cells.
  std::size_t few_boxes = 256;
  /// Pairs of blocks with more pairs of boxes that meet are compared by slabs first.
  int crowded_blocks = 24;
  /// More pairs of faces left between two slabs than this are compared along the slabs' line.
  int crowded_slabs = 16;
  /// Fewer keys than this are sorted by comparison, others by digits or into buckets.
  std::size_t few_keys = 500;
  /// Faces with more boundary edges than this are searched through a tree over their edges.
  std::uint32_t large_face = 48;
  /// A face of more corners than this is not looked for among the other's in a proof.
  std::size_t small_face = 16;
  /// So many segments and points of a sheet are compared in pairs, more through a tree.
  std::uint32_t few_segments = 24;
  /// So many components ask for the farthest of them each time, more of them once in a while.
  std::size_t few_components = 8;
  /// More rays than this are shot through a tree.
  std::size_t few_rays = 4;
  /// An operand of at least so many times the faces of all that meets it lends its lists to the result.
  std::size_t host = 8;
  /// Crowded operands are combined in groups of so many (at least 2).
  std::size_t group = 4;
  /// Spokes of vertices with more than this are sorted.
  std::size_t few_spokes = 16;
  /// Fans whose squared size is more than this times the number of all triangles are compared as a whole.
  std::size_t large_fan = 4;
  /// Operands of which more pairs than this for each of them have boxes that meet are combined in groups.
  std::size_t neighbours = 2;
  /// Shared lists with less than so many live faces, or corners, for each one that is gone are packed.
  std::size_t live_per_gone = 4;
  /// Longer lists of vertices of a face, and of edges at one of them, are sorted by merging, others by insertion.
  int few_sorted = 16;
  /// Points whose table has more collisions for each of them are welded by sorting.
  std::size_t collisions = 32;
  /// A term that stands in several places and has more leaves than this is evaluated by itself.
  std::size_t few_leaves = 256;
  /// Subtrees of at most so many leaves, of an expression that has more, are evaluated by themselves.
  std::size_t subtree = 16;
  /// Nodes of a tree of boxes with more pairs of parts than this whose boxes meet are compared as a whole first.
  int crowded_nodes = 48;
  /// Edges of more faces than this are looked at once for all of them.
  std::uint32_t few_faces_at_edge = 8;
  /// Blocks of more faces than this in all are compared as a whole before their faces are.
  std::size_t few_faces = 64;

  static constexpr Thresholds smallest() {
    return {1, 2, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 2, 0, 0, 0};
  }
  static constexpr Thresholds largest() {
    constexpr std::uint32_t all = 1u << 30;
    return {all, all, all, all, all, 64,  64, all, all,     all, 24, all, all,
            all, all, all, all, all, all, 64, all, 1 << 12, all, 64, all, all};
  }
  /// The smallest, but few enough operands for an operand to lend its lists to the result, however small it is.
  static constexpr Thresholds patched() {
    Thresholds t = smallest();
    t.few_operands = largest().few_operands;
    return t;
  }
};

#ifdef QUOIN_CHECKED

/// What the environment says, once.
inline Thresholds& settable_thresholds() {
  static Thresholds value = [] {
    const char* text = std::getenv("QUOIN_THRESHOLDS");
    const std::string_view name = text != nullptr ? text : "";
    return name == "smallest"  ? Thresholds::smallest()
           : name == "largest" ? Thresholds::largest()
           : name == "patched" ? Thresholds::patched()
                               : Thresholds{};
  }();
  return value;
}
inline const Thresholds& thresholds() { return settable_thresholds(); }

#else

inline constexpr Thresholds usual_thresholds{};
constexpr const Thresholds& thresholds() { return usual_thresholds; }

#endif

}  // namespace quoin::grid
