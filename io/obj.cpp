// Wavefront OBJ: v, f and fo; every other statement is passed over, and counted where it says more than a name.
#include <algorithm>
#include <array>

#include "io/formats.h"
#include "io/scanner.h"
#include "io/text_output.h"

namespace quoin::io {
namespace {

/// Statements that may stand in an OBJ without any vertex.
bool is_common_statement(std::string_view keyword) {
  constexpr std::array<std::string_view, 9> common = {"o", "g", "s", "vt", "vn", "vp", "mtllib", "usemtl", "usemap"};
  return std::find(common.begin(), common.end(), keyword) != common.end();
}

class ObjReader {
 public:
  explicit ObjReader(std::string_view text)
      : in_(text, {.hash_comments = true, .line_continuation = true}), has_zero_(text.find('\0') != text.npos) {}

  Result<PolygonMesh> read() {
    if (has_zero_)
      return Error{ErrorCode::unknown_format, "this is not an OBJ text: it holds zero bytes", {}, "line 1"};
    for (in_.skip_space(); !in_.at_end(); in_.skip_space()) {
      if (!statement()) return in_.take_error();
      in_.skip_line();
    }
    if (!check_largest_index() || !check_is_obj()) return in_.take_error();
    for (const Passed& kind : passed_) mesh_.pass_over(kind.count, kind.one, kind.many);
    return std::move(mesh_);
  }

 private:
  std::uint64_t point_count() const { return mesh_.points.size() / 3; }

  bool statement() {
    const char* place = in_.position();
    const std::string_view keyword = in_.word();
    if (keyword == "v") return vertex();
    if (keyword == "f" || keyword == "fo") return face(place);
    for (Passed& kind : passed_)
      if (kind.keyword == keyword) ++kind.count;
    if (foreign_ == nullptr && !is_common_statement(keyword)) foreign_ = place;
    return true;
  }

  /// x y z; a weight and colours behind them are passed over with the rest of the line.
  bool vertex() {
    for (int i = 0; i < 3; ++i) {
      double coordinate = 0;
      if (!in_.number(coordinate)) return false;
      mesh_.points.push_back(coordinate);
    }
    note_colour();
    return point_count() <= max_count || in_.fail(ErrorCode::absurd_count, "the file has too many vertices");
  }

  /// A weight is one number, a colour three or four.
  void note_colour() {
    std::size_t words = 0;
    for (in_.skip_blanks(); !in_.at_line_end(); in_.skip_blanks(), ++words) (void)in_.word();
    if (words >= 3) ++passed_[0].count;
  }

  bool face(const char* place) {
    const std::size_t start = mesh_.corners.size();
    for (in_.skip_blanks(); !in_.at_line_end(); in_.skip_blanks()) {
      if (!corner()) return false;
    }
    in_.mark_at(place);
    if (mesh_.corners.size() - start < 3) return in_.fail(ErrorCode::bad_syntax, "a face needs at least 3 corners");
    if (mesh_.corners.size() > max_count) return in_.fail(ErrorCode::absurd_count, "the faces have too many corners");
    mesh_.starts.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
    return true;
  }

  /// v, v/vt, v//vn or v/vt/vn; v counts from 1, or back from -1, the latest vertex.
  bool corner() {
    const char* place = in_.position();
    std::int64_t index = 0;
    if (!in_.leading_integer(index)) return false;
    if (in_.inside_word() && in_.peek() != '/') return bad_corner();
    for (; in_.inside_word(); in_.advance()) {
      if (std::string_view("0123456789+-/").find(in_.peek()) == std::string_view::npos) return bad_corner();
    }
    return add_corner(index, place);
  }

  /// Positive indices may name vertices that follow, so they are checked at the end.
  bool add_corner(std::int64_t index, const char* place) {
    const auto known = static_cast<std::int64_t>(point_count());
    const std::int64_t at = index < 0 ? (index < -known ? -1 : known + index) : index - 1;
    if (at < 0 || at >= static_cast<std::int64_t>(max_count)) return bad_index(place);
    if (at > largest_ || largest_place_ == nullptr) {
      largest_ = at;
      largest_place_ = place;
    }
    mesh_.corners.push_back(static_cast<std::uint32_t>(at));
    return true;
  }

  bool bad_corner() { return in_.fail(ErrorCode::bad_syntax, "a corner is written v, v/vt, v//vn or v/vt/vn"); }

  bool bad_index(const char* place) {
    in_.mark_at(place);
    return in_.fail(ErrorCode::bad_index, "a face names a vertex that does not exist");
  }

  bool check_largest_index() {
    const bool good = largest_place_ == nullptr || largest_ < static_cast<std::int64_t>(point_count());
    return good || bad_index(largest_place_);
  }

  /// A text of strange statements only is no empty mesh.
  bool check_is_obj() {
    if (foreign_ == nullptr || !mesh_.points.empty()) return true;
    in_.mark_at(foreign_);
    return in_.fail(ErrorCode::unknown_format,
                    "this is not an OBJ text: it has no vertex and a statement OBJ does not know");
  }

  /// What is counted: by its statement, a colour of a vertex by none.
  struct Passed {
    std::string_view keyword, one, many;
    std::uint64_t count = 0;
  };

  Scanner in_;
  PolygonMesh mesh_;
  std::array<Passed, 9> passed_ = {{{"", "colour of a vertex", "colours of vertices"},
                                    {"vn", "normal", "normals"},
                                    {"vt", "texture coordinate", "texture coordinates"},
                                    {"usemtl", "use of a material", "uses of materials"},
                                    {"l", "line", "lines"},
                                    {"p", "point", "points"},
                                    {"curv", "curve", "curves"},
                                    {"curv2", "curve in a surface", "curves in surfaces"},
                                    {"surf", "free-form surface", "free-form surfaces"}}};
  bool has_zero_;
  std::int64_t largest_ = 0;
  const char* largest_place_ = nullptr;
  const char* foreign_ = nullptr;
};

}  // namespace

Result<PolygonMesh> read_obj(std::string_view bytes) { return ObjReader(bytes).read(); }

std::string write_obj(std::span<const double> points, std::span<const std::uint32_t> triangles) {
  std::string out = "# Quoin OBJ, counter-clockwise seen from outside, units of the model\n";
  for (std::size_t i = 0; i < points.size(); i += 3) append_line(out, "v ", points[i], points[i + 1], points[i + 2]);
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    append_line<std::uint64_t>(out, "f ", std::uint64_t{triangles[i]} + 1, std::uint64_t{triangles[i + 1]} + 1,
                               std::uint64_t{triangles[i + 2]} + 1);
  }
  return out;
}

}  // namespace quoin::io
