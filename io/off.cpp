// OFF in text form, three-dimensional: one vertex or face a line, or numbers that run on over the ends of lines.
#include <algorithm>

#include "io/formats.h"
#include "io/scanner.h"
#include "io/text_output.h"

namespace quoin::io {
namespace {

/// Bytes of the shortest line that is not empty.
constexpr std::uint64_t min_line_size = 2;
constexpr ScannerOptions off_options = {.hash_comments = true};

/// The length of OFF, with any of ST, C, N before it, at the start of `word`; 0 when it is not there.
/// A digit may follow at once: "OFF8 6 12".
std::size_t header_length(std::string_view word) {
  std::size_t at = 0;
  while (!word.substr(at).starts_with("OFF")) {
    const std::string_view rest = word.substr(at);
    if (!rest.starts_with("ST") && !rest.starts_with('C') && !rest.starts_with('N')) return 0;
    at += rest.starts_with("ST") ? 2 : 1;
  }
  at += 3;
  return at == word.size() || (word[at] >= '0' && word[at] <= '9') ? at : 0;
}

enum class Layout {
  lines,   // a vertex or face a line; what stands behind its numbers (normals, colours) is passed over
  running  // lines end anywhere, and nothing stands behind the numbers
};

class OffReader {
 public:
  OffReader(std::string_view text, Layout layout) : in_(text, off_options), layout_(layout) {}

  Result<PolygonMesh> read() {
    if (!header() || !counts() || !vertices() || !faces() || !end()) return in_.take_error();
    mesh_.pass_over(vertex_extras_, "colour, normal or texture coordinate of a vertex",
                    "colours, normals or texture coordinates of vertices");
    mesh_.pass_over(face_extras_, "colour of a face", "colours of faces");
    return std::move(mesh_);
  }

 private:
  bool header() {
    in_.skip_space();
    const std::string_view word = in_.word();
    const std::size_t length = header_length(word);
    if (length == 0) return in_.fail(ErrorCode::unknown_format, "OFF, COFF, NOFF, STOFF or the like is due here");
    in_.move_to(word.data() + length);
    const char* behind = in_.position();
    if (in_.word() == "BINARY") return in_.fail(ErrorCode::unknown_format, "binary OFF is not read; write it as text");
    in_.move_to(behind);
    return true;
  }

  /// Between the numbers of a vertex or face.
  void skip_within() {
    if (layout_ == Layout::running) in_.skip_space();
  }
  /// Behind them; counts what is there.
  void skip_rest(std::uint64_t& extras) {
    if (layout_ == Layout::running) return;
    in_.skip_blanks();
    if (!in_.at_line_end()) ++extras;
    in_.skip_line();
  }

  bool count(std::uint64_t& out) {
    std::int64_t value = 0;
    if (!in_.integer(value)) return false;
    if (value < 0 || static_cast<std::uint64_t>(value) > max_count) {
      return in_.fail(ErrorCode::absurd_count, "this count is negative or beyond 32 bits");
    }
    out = static_cast<std::uint64_t>(value);
    return true;
  }

  /// vertices faces [edges]; refuses counts that the rest of the text cannot hold.
  bool counts() {
    in_.skip_space();
    if (!count(vertex_count_) || !count(face_count_)) return false;
    in_.skip_line();

    // The last line may lack its end.
    if ((vertex_count_ + face_count_) * min_line_size > in_.remaining() + 1) {
      return in_.fail(ErrorCode::absurd_count, "the file is too short for " + std::to_string(vertex_count_) +
                                                   " vertices and " + std::to_string(face_count_) +
                                                   " faces: truncated, or the counts are wrong");
    }

    // Every number takes a digit and a separator.
    const std::uint64_t max_numbers = in_.remaining() / 2 + 1;
    mesh_.points.reserve(std::min(vertex_count_ * 3, max_numbers));
    mesh_.starts.reserve(face_count_ + 1);
    mesh_.corners.reserve(std::min(face_count_ * 3, max_numbers));
    return true;
  }

  /// x y z; normals, colours and texture coordinates behind them are passed over.
  bool vertices() {
    for (std::uint64_t i = 0; i < vertex_count_; ++i) {
      in_.skip_space();
      for (int k = 0; k < 3; ++k) {
        double coordinate = 0;
        skip_within();
        if (!in_.number(coordinate)) return false;
        mesh_.points.push_back(coordinate);
      }
      skip_rest(vertex_extras_);
    }
    return true;
  }

  bool faces() {
    for (std::uint64_t i = 0; i < face_count_; ++i) {
      in_.skip_space();
      if (!face()) return false;
      skip_rest(face_extras_);
    }
    return true;
  }

  /// n, then n indices; colours behind them are passed over.
  bool face() {
    std::uint64_t corner_count = 0;
    if (!count(corner_count)) return false;
    if (corner_count < 3) return in_.fail(ErrorCode::bad_syntax, "a face needs at least 3 corners");
    if (corner_count > in_.remaining() / 2 || mesh_.corners.size() + corner_count > max_count) {
      return in_.fail(ErrorCode::absurd_count, "the file is too short for a face of so many corners");
    }

    for (std::uint64_t i = 0; i < corner_count; ++i) {
      std::int64_t index = 0;
      skip_within();
      if (!in_.integer(index)) return false;
      if (index < 0 || static_cast<std::uint64_t>(index) >= vertex_count_) {
        return in_.fail(ErrorCode::bad_index, "a face names a vertex that does not exist");
      }
      mesh_.corners.push_back(static_cast<std::uint32_t>(index));
    }
    mesh_.starts.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
    return true;
  }

  /// More lines mean that the counts are wrong.
  bool end() {
    in_.skip_space();
    in_.mark();
    return in_.at_end() || in_.fail(ErrorCode::bad_syntax, "the file goes on behind the last declared face");
  }

  Scanner in_;
  Layout layout_;
  PolygonMesh mesh_;
  std::uint64_t vertex_count_ = 0;
  std::uint64_t face_count_ = 0;
  std::uint64_t vertex_extras_ = 0, face_extras_ = 0;
};

}  // namespace

bool looks_like_off(std::string_view bytes) {
  Scanner scanner(bytes, off_options);
  scanner.skip_space();
  return header_length(scanner.word()) != 0;
}

Result<PolygonMesh> read_off(std::string_view bytes) {
  Result<PolygonMesh> mesh = OffReader(bytes, Layout::lines).read();
  if (mesh) return mesh;

  // A text that fits the counts to its last number was meant so; otherwise the error is that of its lines.
  Result<PolygonMesh> running = OffReader(bytes, Layout::running).read();
  return running ? running : mesh;
}

std::string write_off(std::span<const double> points, std::span<const std::uint32_t> triangles) {
  std::string out = "OFF\n";
  append_line<std::size_t>(out, "", points.size() / 3, triangles.size() / 3, 0);
  for (std::size_t i = 0; i < points.size(); i += 3) append_line(out, "", points[i], points[i + 1], points[i + 2]);
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    append_line(out, "3 ", triangles[i], triangles[i + 1], triangles[i + 2]);
  }
  return out;
}

}  // namespace quoin::io
