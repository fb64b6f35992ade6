/// \file
/// What faces carry through every operation: labels, and the solid and face that they come from.
#pragma once

#include "quoin/export.h"

#include <cstdint>
#include <string>
#include <vector>

#include "quoin/solid.h"

namespace quoin {

/// A solid as it entered, by what its caller calls it. Results of operations name these, however long the chain.
struct Original {
  std::uint32_t id = 0;
  std::string name = {};
  friend bool operator==(const Original&, const Original&) = default;
};

/// What a face carries.
struct FaceLabel {
  /// Of a face without labels.
  static constexpr std::uint32_t unlabelled = 0xFFFFFFFFu;

  /// The solid that it comes from, as an index into the originals beside; or `unlabelled`.
  std::uint32_t original = unlabelled;
  std::uint32_t label = 0;
  /// A face of that solid as it was given, on the plane of this one: a triangle or polygon by its index.
  std::uint32_t source = 0;
  /// It looks the other way than there: a face of what was subtracted.
  bool turned = false;
  friend bool operator==(const FaceLabel&, const FaceLabel&) = default;
};

/// A triangle mesh with what its triangles carry.
struct LabelledMesh : Mesh {
  /// Those that triangles name, in the order in which they name a face that several cover.
  std::vector<Original> originals;
  std::vector<FaceLabel> labels;  // one a triangle
  /// Of the original that has most channels; where a face has fewer the others are 0.
  std::uint32_t channel_count = 0;
  /// The channels of each corner of each triangle, corner by corner: those of the face's functions in the exact point
  /// that the corner is, each correctly rounded; of a mesh that was mended, in the point that is written.
  std::vector<double> channels;
};

/// The same mesh with channels by vertex, as files and graphics libraries want them: a vertex is split where channels
/// of its corners differ. The vertex i of the result is vertex `merged[i]` of the mesh: that is how to sew it up again.
struct ChannelMesh : Mesh {
  std::uint32_t channel_count = 0;
  std::vector<double> channels;  // by vertex
  std::vector<std::uint32_t> merged;
};
QUOIN_API ChannelMesh split_by_channels(const LabelledMesh& mesh);

/// As Solid::to_triangles, with labels. Triangles of different labels share vertices.
QUOIN_API Result<LabelledMesh> to_labelled_triangles(const Solid& solid, const ExportOptions& options = {},
                                                     ExportReport* report = nullptr);

/// The same point set with labels of its own in place of those that it has: its faces are those of the canonical form
/// (Solid::to_quoin), in that order, and `labels` holds one each, or is empty (all are 0).
/// Errors: "bad-index" (a wrong number of labels).
QUOIN_API Result<Solid> labelled(const Solid& solid, const Original& original, Indices labels = {});
/// The same point set without labels.
QUOIN_API Solid unlabelled(const Solid& solid);
QUOIN_API bool has_labels(const Solid& solid);

/// Equality of labelled boundaries: equal point sets whose faces carry the same originals and labels, turned alike,
/// everywhere. Which source face a face names does not count.
QUOIN_API bool same_faces(const Solid& a, const Solid& b);

}  // namespace quoin
