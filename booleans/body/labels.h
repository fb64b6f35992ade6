/// \file
/// What faces carry besides their planes: where they come from.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "exact/geometry.h"
#include "grid/lists/array.h"
#include "grid/lists/shared_list.h"

namespace quoin::booleans {

struct Channels;

/// A mesh or a primitive as it entered, with what its faces carry. It never changes: bodies share it.
struct Origin {
  std::uint32_t id = 0;
  std::string name = {};
  std::uint32_t faces = 0;            // source faces are below
  grid::Array<std::uint32_t> labels;  // by source face; empty: all 0
  /// By source face; equal numbers where faces carry the same. Empty: where labels are equal.
  grid::Array<std::uint32_t> surfaces;

  std::shared_ptr<const Channels> channels = nullptr;  // one function a surface (channels.h)

  std::uint32_t label(std::uint32_t face) const { return labels.empty() ? 0 : labels[face]; }
  std::uint32_t surface(std::uint32_t face) const { return surfaces.empty() ? label(face) : surfaces[face]; }
  friend bool operator==(const Origin& a, const Origin& b);
};

/// Where a face comes from.
class Provenance {
 public:
  /// Source faces are below this.
  static constexpr std::uint32_t most_faces = std::uint32_t{1} << 31;

  Provenance() = default;  // face 0 of the first origin
  Provenance(std::uint32_t origin, std::uint32_t face, bool is_turned = false)
      : origin_(origin), face_(face << 1 | std::uint32_t{is_turned}) {}

  /// In the Origins of its body.
  std::uint32_t origin() const { return origin_; }
  /// Of the origin.
  std::uint32_t face() const { return face_ >> 1; }
  /// It looks the other way than there.
  bool is_turned() const { return (face_ & 1) != 0; }
  Provenance turned() const { return {origin_, face(), !is_turned()}; }
  Provenance in(std::uint32_t origin) const { return {origin, face(), is_turned()}; }

  /// By origin, then face.
  friend auto operator<=>(const Provenance&, const Provenance&) = default;

 private:
  std::uint32_t origin_ = 0;
  std::uint32_t face_ = 0;  // twice the face, and whether turned
};

/// The origins of a body's faces, in an order: where faces of several coincide, the first of those that contribute to
/// the boundary names it.
class Origins {
 public:
  using Pointer = std::shared_ptr<const Origin>;  // null: the origin of faces without labels

  std::size_t size() const { return list_.size(); }
  const Pointer& operator[](std::uint32_t origin) const { return list_[origin]; }
  /// Its place in the order.
  std::uint32_t rank(std::uint32_t origin) const { return rank_[origin]; }
  /// All of them in order.
  grid::Array<std::uint32_t> in_order() const;
  /// The number of an equal origin; size() where there is none.
  std::uint32_t find(const Pointer& origin) const;
  /// Adds one that is not there, as the last one in the order.
  void add(const Pointer& origin);
  /// Another order: all of them once, the first one first.
  void set_order(std::span<const std::uint32_t> order);

  std::uint32_t label(const Provenance& p) const {
    const Pointer& origin = list_[p.origin()];
    return origin ? origin->label(p.face()) : 0;
  }
  /// Do faces carry the same, so that neighbours on one plane are one face?
  bool is_same_surface(const Provenance& p, const Provenance& q) const {
    if (p == q) return true;
    if (p.origin() != q.origin() || p.is_turned() != q.is_turned()) return false;
    const Pointer& origin = list_[p.origin()];
    return !origin || origin->surface(p.face()) == origin->surface(q.face());
  }
  /// Does p name what p and q cover together?
  bool comes_before(const Provenance& p, const Provenance& q) const {
    return p.origin() != q.origin() ? rank(p.origin()) < rank(q.origin()) : p < q;
  }

 private:
  struct Entry {
    std::size_t hash;  // of what tells most origins apart
    std::uint32_t origin;
  };
  std::vector<Pointer> list_;
  std::vector<std::uint32_t> rank_;
  std::vector<Entry> by_hash_;
};

/// Of an edge at which a polygon meets another face on its own plane, one that carries something else: another plane
/// through that edge, so that it stays the meeting of two planes of bounded numbers.
struct Border {
  std::uint32_t corner;  // in the list of all polygons' corners: the edge begins there
  exact::Plane other;
};

/// What the faces of a body carry.
struct Labels {
  std::shared_ptr<const Origins> origins;            // null: nothing, and the lists are empty
  grid::SharedList<Provenance> triangles, polygons;  // one a face
  grid::SharedList<Border> borders;                  // by corner

  explicit operator bool() const { return origins != nullptr; }
  /// Those of the corners begin .. end - 1.
  std::span<const Border> borders_within(std::uint32_t begin, std::uint32_t end) const;
  /// Adds borders of other labels, those of the corners begin .. end - 1, which have become `to` and the following.
  void append_borders(const Labels& from, std::uint32_t begin, std::uint32_t end, std::uint32_t to);
  /// The same, of one loop whose corners have been reversed.
  void append_reversed_borders(const Labels& from, std::uint32_t begin, std::uint32_t end, std::uint32_t to);
  /// The corners of all loops, which begin at loop_start[0] and so on, have been reversed.
  void reverse_loops(std::span<const std::uint32_t> loop_start);
  /// Nothing is added for now.
  void settle();
};

/// Where the edge that begins at a corner of the loop `begin .. end - 1` begins when that loop is reversed.
inline std::uint32_t reversed_corner(std::uint32_t corner, std::uint32_t begin, std::uint32_t end) {
  return corner + 1 == end ? corner : begin + end - 2 - corner;
}

}  // namespace quoin::booleans
