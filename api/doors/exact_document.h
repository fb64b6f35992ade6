/// \file
/// Exact solids between their numbers as text and what they are.
#pragma once

#include <array>
#include <string>

#include "io/quoin.h"
#include "quoin/quoin.h"

namespace quoin {

/// The numbers of a grid as text.
struct GridText {
  explicit GridText(const Grid& grid) : step(grid.step()), origin(grid.origin()) {}
  std::string step;
  std::array<std::string, 3> origin;
};

/// Arrays as a document, whose numbers are pieces of both arguments. Errors: "bad-number", "bad-index".
Result<io::ExactDocument> document_of(const ExactPolygons& polygons, const GridText& grid);

/// What a document says, within the bounds of its numbers, proved to be a solid but for what is trusted.
/// Errors: "bad-quoin".
Result<Solid> solid_of(const io::ExactDocument& document, Trust trust);

}  // namespace quoin
