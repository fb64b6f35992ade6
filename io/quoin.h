/// \file
/// The exact text format .quoin <-> plain arrays of decimals and indices. The format: docs/format.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "quoin/result.h"

namespace quoin::io {

/// Longest integers of a .quoin file, decimal digits without the sign.
inline constexpr std::size_t max_lattice_digits = 1000;    // numerators and denominators of step and origin
inline constexpr std::size_t max_coordinate_digits = 80;   // x, y, z, w
inline constexpr std::size_t max_coefficient_digits = 40;  // a, b, c, d

/// The content of a .quoin file, numbers as decimals: pieces of a text that must live as long.
/// Integers have an optional '-' and no superfluous zeros, nor is there a "-0"; a rational is an integer p or "p/q"
/// with p not 0 and q at least 2.
struct ExactDocument {
  /// Model coordinate = origin + step * grid coordinate; step > 0.
  std::string_view step = "1";
  std::array<std::string_view, 3> origin = {"0", "0", "0"};
  bool full_at_infinity = false;
  /// x, y, z, w with w > 0: the point (x, y, z) / w in grid steps.
  std::vector<std::array<std::string_view, 4>> vertices;
  /// a, b, c, d of a x + b y + c z + d = 0 in grid steps; one a face.
  std::vector<std::array<std::string_view, 4>> planes;
  /// Face i has the loops face_loops[i] .. face_loops[i + 1] - 1, at least one;
  /// loop j the corners corners[loop_corners[j]] .. corners[loop_corners[j + 1] - 1], at least one.
  std::vector<std::uint32_t> face_loops = {0};
  std::vector<std::uint32_t> loop_corners = {0};
  /// Indices of vertices.
  std::vector<std::uint32_t> corners;

  friend bool operator==(const ExactDocument&, const ExactDocument&) = default;
};

/// Whether the bytes begin as .quoin files of any version do.
bool looks_like_quoin(std::string_view bytes);

/// Writes the text of a file, lines ended by \n, piece by piece in the order of the methods: a vertex for each that was
/// announced, a face for each, and a face's loops behind it. Equal contents give equal bytes.
/// Precondition: numbers are as in an ExactDocument and no longer than the limits above; fewer than 2^32 - 1 vertices,
/// faces, loops and corners.
class QuoinWriter {
 public:
  /// Writes into the memory of a string, whatever that holds.
  explicit QuoinWriter(std::string room) : out_(std::move(room)) { out_.clear(); }

  void begin(std::string_view step, const std::array<std::string_view, 3>& origin, bool full_at_infinity);
  void vertices(std::size_t count);
  void vertex(const std::array<std::string_view, 4>& point);
  void faces(std::size_t count);
  void face(const std::array<std::string_view, 4>& plane, std::size_t loops);
  /// Precondition: not empty.
  void loop(std::span<const std::uint32_t> corners);
  std::string end();

 private:
  std::string out_;
};

/// The document as text; `read_quoin` gives the document back.
/// Precondition: the document is as its comments say.
std::string write_quoin(const ExactDocument& document);

/// Reads a whole text, lines ended by \n or \r\n, lines that begin with '#' being comments. Numbers are pieces of it.
/// The document is as its comments say; geometry is not looked at, nor whether rationals, points and planes are
/// reduced. Every proper prefix of a file is refused. Without comments and \r the text is what `write_quoin` gives.
/// Never throws but std::bad_alloc; never allocates more than a small multiple of `text`.
/// Errors: "bad-quoin", with `where` = "line N".
Result<ExactDocument> read_quoin(std::string_view text);

}  // namespace quoin::io
