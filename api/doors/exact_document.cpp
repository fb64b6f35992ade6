#include "api/doors/exact_document.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace quoin {
namespace {

/// An optional '-' and digits, without superfluous zeros; no "-0".
bool is_whole(std::string_view text) {
  if (text == "0") return true;
  if (text.starts_with('-')) text.remove_prefix(1);
  return !text.empty() && text[0] != '0' &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// The records of four numbers as pieces of them. `longest`: digits of each.
Result<std::vector<std::array<std::string_view, 4>>> records(const std::vector<std::array<std::string, 4>>& numbers,
                                                             std::size_t longest, const std::string& kind) {
  std::vector<std::array<std::string_view, 4>> r;
  r.reserve(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (const std::string& text : numbers[i])
      if (text.size() > longest + 1 || !is_whole(text))
        return Error{ErrorCode::bad_number,
                     "\"" + text.substr(0, 80) + "\" is no whole number, or too long a one, or has superfluous zeros",
                     {},
                     kind + " " + std::to_string(i)};
    r.push_back({numbers[i][0], numbers[i][1], numbers[i][2], numbers[i][3]});
  }
  return r;
}

/// Whether starts begin at 0, ascend, and end at the number of what they divide: no piece is empty.
bool divide(const std::vector<std::uint32_t>& starts, std::size_t count) {
  return !starts.empty() && starts.front() == 0 && starts.back() == count &&
         std::adjacent_find(starts.begin(), starts.end(), std::greater_equal<>()) == starts.end();
}

std::optional<Error> index_fault(const ExactPolygons& polygons) {
  const auto bad = [](std::string message, std::string where) {
    return Error{ErrorCode::bad_index, std::move(message), {}, std::move(where)};
  };
  if (!divide(polygons.loop_starts, polygons.corners.size()))
    return bad("the loop starts do not begin at 0, ascend, and end at the number of corners", "loop_starts");
  if (!divide(polygons.face_starts, polygons.loop_starts.size() - 1))
    return bad("the face starts do not begin at 0, ascend, and end at the number of loops", "face_starts");
  if (polygons.planes.size() != polygons.face_starts.size() - 1)
    return bad("there are not as many planes as faces", "planes");

  const auto beyond = std::find_if(polygons.corners.begin(), polygons.corners.end(),
                                   [&](std::uint32_t v) { return v >= polygons.points.size(); });
  if (beyond == polygons.corners.end()) return std::nullopt;
  return bad("vertex " + std::to_string(*beyond) + " does not exist",
             "corner " + std::to_string(beyond - polygons.corners.begin()));
}

}  // namespace

Result<io::ExactDocument> document_of(const ExactPolygons& polygons, const GridText& grid) {
  if (auto fault = index_fault(polygons)) return *fault;
  auto points = records(polygons.points, io::max_coordinate_digits, "vertex");
  if (!points) return points.error();
  auto planes = records(polygons.planes, io::max_coefficient_digits, "face");
  if (!planes) return planes.error();
  for (std::size_t v = 0; v < polygons.points.size(); ++v)
    if (const std::string& w = polygons.points[v][3]; w == "0" || w.starts_with('-'))
      return Error{ErrorCode::bad_number, "the denominator is not positive", {}, "vertex " + std::to_string(v)};

  io::ExactDocument document;
  document.step = grid.step;
  for (std::size_t k = 0; k < 3; ++k) document.origin[k] = grid.origin[k];
  document.full_at_infinity = polygons.full_at_infinity;
  document.vertices = std::move(points).value();
  document.planes = std::move(planes).value();
  document.face_loops = polygons.face_starts;
  document.loop_corners = polygons.loop_starts;
  document.corners = polygons.corners;
  return document;
}

}  // namespace quoin
