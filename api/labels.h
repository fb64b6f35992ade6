/// \file
/// Labels between the public values and the bodies.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "booleans/body/channels.h"
#include "booleans/mended.h"
#include "booleans/surface/triangulated.h"
#include "quoin/labels.h"

namespace quoin {

/// A solid that enters. `labels`: one for each of its faces, or none.
booleans::Origin origin_of(const Original& original, std::size_t faces, const Indices& labels);

/// The channels of all corners of triangles of a body; nothing where no origin has any. `to_model`: from its grid
/// steps.
struct PublicChannels {
  std::uint32_t count = 0;
  std::vector<double> values;
};
PublicChannels public_channels(const booleans::Body& body, const booleans::Triangulated& mesh,
                               const booleans::TriangleLabels& labels, const booleans::PositionMap& to_model);

/// Errors: "bad-index" where there are labels, but not one for each face.
Result<void> check_label_count(std::size_t labels, std::size_t faces);

/// What faces carry, for the outside; originals in order, those alone that are named. Faces without labels where
/// `origins` is null.
struct PublicLabels {
  std::vector<Original> originals;
  std::vector<FaceLabel> labels;
};
PublicLabels public_labels(const booleans::Origins* origins, std::span<const booleans::Provenance> faces,
                           std::size_t face_count);

}  // namespace quoin
