/// \file
/// Labels between the public values and the bodies.
#pragma once

#include <memory>

#include "booleans/body/labels.h"
#include "quoin/labels.h"

namespace quoin {

/// A solid that enters. `labels`: one for each of its faces, or none.
std::shared_ptr<const booleans::Origin> origin_of(const Original& original, std::size_t faces, const Indices& labels);

/// What faces carry, for the outside; originals in order, those alone that are named. Faces without labels where
/// `origins` is null.
struct PublicLabels {
  std::vector<Original> originals;
  std::vector<FaceLabel> labels;
};
PublicLabels public_labels(const booleans::Origins* origins, std::span<const booleans::Provenance> faces,
                           std::size_t face_count);

}  // namespace quoin
