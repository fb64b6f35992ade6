/// \file
/// Has a face an area before it is snapped?
#pragma once

#include <cstdint>
#include <span>

namespace quoin::grid {

/// How closely to look. Signs of differences of coordinates tell of nearly every face and cost next to nothing, but may
/// miss an area; they never see one where there is none.
enum class Look { at_signs, exactly };

/// Whether a face has an area, that is, its corners do not all lie on one line. Exact for any finite `points`, 3
/// doubles a point.
bool has_area(std::span<const double> points, std::span<const std::uint32_t> face, Look look);

}  // namespace quoin::grid
