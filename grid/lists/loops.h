/// \file
/// Faces with loops of corners: the one form in which faces are kept.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "grid/lists/array.h"

namespace quoin::grid {

/// The place after place i of a closed loop of n corners; that after the last is 0. Precondition: i < n.
template <std::unsigned_integral Index>
constexpr Index next_in_loop(Index i, Index n) {
  return i + 1 < n ? i + 1 : 0;
}
/// The place before place i; that before 0 is the last. Precondition: i < n.
template <std::unsigned_integral Index>
constexpr Index previous_in_loop(Index i, Index n) {
  return i > 0 ? i - 1 : n - 1;
}

/// visit(u, v) for every directed edge of a closed loop, a list of corners; a loop of one corner has none.
template <class Loop, class Visit>
void for_loop_edges(const Loop& loop, Visit&& visit) {
  if (loop.size() < 2) return;
  for (std::size_t i = 0; i + 1 < loop.size(); ++i) visit(loop[i], loop[i + 1]);
  visit(loop.back(), loop.front());
}

/// Faces that follow each other, each with its loops, each with its corners. A loop of one corner is a point inside its
/// face. `List` is Array or a list like it (SharedList).
template <class Corner, template <class...> class List = Array>
struct Loops {
  List<std::uint32_t> face_start = {0};  // face i has the loops face_start[i] .. face_start[i + 1] - 1
  List<std::uint32_t> loop_start = {0};  // loop j has the corners loop_start[j] .. loop_start[j + 1] - 1
  List<Corner> corners;

  friend bool operator==(const Loops&, const Loops&) = default;

  std::size_t loop_count() const { return loop_start.size() - 1; }
  std::span<const Corner> loop(std::size_t j) const {
    return std::span<const Corner>(corners).subspan(loop_start[j], loop_start[j + 1] - loop_start[j]);
  }
  /// How many loops a face has.
  std::size_t loop_count(std::size_t face) const { return face_start[face + 1] - face_start[face]; }
  /// The corners of all loops of a face, one after the other.
  std::span<const Corner> corners_of(std::size_t face) const {
    const std::uint32_t begin = loop_start[face_start[face]], end = loop_start[face_start[face + 1]];
    return std::span<const Corner>(corners).subspan(begin, end - begin);
  }
  /// Of a face or loop, in the list of corners.
  struct Range {
    std::uint32_t begin, end;
  };
  Range corner_range(std::size_t face) const {
    return {loop_start[face_start[face]], loop_start[face_start[face + 1]]};
  }
  std::uint32_t corner_count(std::size_t face) const {
    return loop_start[face_start[face + 1]] - loop_start[face_start[face]];
  }

  /// visit(loop) for every loop of a face.
  template <class Visit>
  void for_loops(std::size_t face, Visit&& visit) const {
    for (std::uint32_t j = face_start[face]; j < face_start[face + 1]; ++j) visit(loop(j));
  }
  /// visit(u, v) for every directed edge of a face.
  template <class Visit>
  void for_edges(std::size_t face, Visit&& visit) const {
    for (std::uint32_t j = face_start[face]; j < face_start[face + 1]; ++j) for_loop_edges(loop(j), visit);
  }
  /// visit(corner) for the loops of one corner of a face.
  template <class Visit>
  void for_points(std::size_t face, Visit&& visit) const {
    for (std::uint32_t j = face_start[face]; j < face_start[face + 1]; ++j)
      if (loop_start[j + 1] - loop_start[j] == 1) visit(corners[loop_start[j]]);
  }

  /// Closes the loop of the corners that were added since the last one.
  void end_loop() { loop_start.push_back(static_cast<std::uint32_t>(corners.size())); }
  /// Closes the face of the loops that were added since the last one.
  void end_face() { face_start.push_back(static_cast<std::uint32_t>(loop_count())); }
  void add_loop(std::span<const Corner> loop) {
    for (const Corner& c : loop) corners.push_back(c);
    end_loop();
  }
  void reserve(std::size_t faces, std::size_t loops, std::size_t corner_count) {
    face_start.reserve(faces + 1);
    loop_start.reserve(loops + 1);
    corners.reserve(corner_count);
  }
  /// Adds loops first .. last - 1 of another list, each corner c as corner_of(c).
  template <template <class...> class OtherList, class CornerOf>
  void append_loops(const Loops<Corner, OtherList>& more, std::size_t first, std::size_t last, CornerOf corner_of) {
    const std::uint32_t begin = more.loop_start[first], end = more.loop_start[last];
    const std::uint32_t shift = static_cast<std::uint32_t>(corners.size()) - begin;
    const auto from = std::span<const Corner>(more.corners).subspan(begin, end - begin);
    std::transform(from.begin(), from.end(), grown(corners, from.size()).begin(), corner_of);

    const auto starts = std::span<const std::uint32_t>(more.loop_start).subspan(first + 1, last - first);
    std::transform(starts.begin(), starts.end(), grown(loop_start, starts.size()).begin(),
                   [&](std::uint32_t start) { return start + shift; });
  }
  /// Adds faces first .. last - 1 of another list, each corner c as corner_of(c).
  template <template <class...> class OtherList, class CornerOf>
  void append_faces(const Loops<Corner, OtherList>& more, std::size_t first, std::size_t last, CornerOf corner_of) {
    const std::uint32_t shift = static_cast<std::uint32_t>(loop_count()) - more.face_start[first];
    append_loops(more, more.face_start[first], more.face_start[last], corner_of);
    for (std::size_t i = first; i < last; ++i) face_start.push_back(more.face_start[i + 1] + shift);
  }
  /// Adds all faces of another list.
  template <template <class...> class OtherList>
  void append(const Loops<Corner, OtherList>& more) {
    append_faces(more, 0, more.face_start.size() - 1, [](const Corner& c) { return c; });
  }

 private:
  /// n more items of a list, to be written.
  template <class Items>
  static auto grown(Items& items, std::size_t n) {
    if constexpr (requires { items.grow(n); }) {
      return items.grow(n);
    } else {
      items.resize(items.size() + n);
      return std::span(items).last(n);
    }
  }
};

}  // namespace quoin::grid
