#include "examples/mesh_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace quoin::examples {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is written as the machine stores it");

constexpr std::size_t stl_header = 80, stl_record = 50;

// Collects bytes and hands them to the file a megabyte at a time.
class ByteSink {
 public:
  explicit ByteSink(const std::string& path) : file_(path, std::ios::binary) { buffer_.reserve(limit + 256); }

  void text(std::string_view bytes) {
    buffer_.append(bytes);
    if (buffer_.size() >= limit) flush();
  }
  template <class Number>
  void number(Number value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    text({digits.data(), static_cast<std::size_t>(end - digits.data())});
  }
  void raw(const void* bytes, std::size_t size) { text({static_cast<const char*>(bytes), size}); }

  /// Whether everything was written.
  bool close() {
    flush();
    file_.close();
    return !file_.fail();
  }

 private:
  static constexpr std::size_t limit = std::size_t{1} << 20;
  void flush() {
    file_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
  }

  std::ofstream file_;
  std::string buffer_;
};

void put_off(ByteSink& sink, const Mesh& mesh) {
  sink.text("OFF\n");
  sink.number(mesh.points.size() / 3);
  sink.text(" ");
  sink.number(mesh.triangles.size() / 3);
  sink.text(" 0\n");
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    sink.number(mesh.points[i]);
    sink.text(i % 3 == 2 ? "\n" : " ");
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i % 3 == 0) sink.text("3 ");
    sink.number(mesh.triangles[i]);
    sink.text(i % 3 == 2 ? "\n" : " ");
  }
}

void put_stl(ByteSink& sink, const Mesh& mesh) {
  std::array<char, stl_header> header{};
  constexpr std::string_view title = "binary STL of a generated model";
  std::copy(title.begin(), title.end(), header.begin());
  sink.raw(header.data(), header.size());
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size() / 3);
  sink.raw(&count, sizeof count);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    std::array<std::array<double, 3>, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t a = 0; a < 3; ++a) p[i][a] = mesh.points[3 * std::size_t{mesh.triangles[t + i]} + a];
    }
    std::array<double, 3> n{};
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
      n[a] = (p[1][b] - p[0][b]) * (p[2][c] - p[0][c]) - (p[1][c] - p[0][c]) * (p[2][b] - p[0][b]);
    }
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    std::array<float, 12> values{};
    for (std::size_t a = 0; a < 3; ++a) {
      values[a] = length > 0 ? static_cast<float>(n[a] / length) : 0.0f;
      for (std::size_t i = 0; i < 3; ++i) values[3 + 3 * i + a] = static_cast<float>(p[i][a]);
    }
    std::array<char, stl_record> record{};
    std::memcpy(record.data(), values.data(), sizeof values);
    sink.raw(record.data(), record.size());
  }
}

bool ends_with(std::string_view name, std::string_view extension) {
  if (name.size() < extension.size()) return false;
  return std::equal(extension.begin(), extension.end(), name.end() - static_cast<std::ptrdiff_t>(extension.size()),
                    [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? static_cast<char>(b + 32) : b); });
}

Error unknown_format(const std::string& path) {
  return {ErrorCode::unknown_format, "The file's name must end in .off or .stl.", path};
}

// Numbers and words separated by white space; '#' begins a comment.
class Words {
 public:
  explicit Words(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

  template <class Number>
  bool number(Number& value) {
    skip();
    if (at_ != end_ && *at_ == '+') ++at_;
    const auto result = std::from_chars(at_, end_, value);
    at_ = result.ptr;
    return result.ec == std::errc{};
  }
  bool word(std::string_view expected) {
    skip();
    if (std::string_view(at_, static_cast<std::size_t>(end_ - at_)).substr(0, expected.size()) != expected)
      return false;
    at_ += expected.size();
    return true;
  }
  void skip_line() { at_ = std::find(at_, end_, '\n'); }

 private:
  void skip() {
    while (at_ != end_ && (*at_ == ' ' || *at_ == '\t' || *at_ == '\r' || *at_ == '\n' || *at_ == '#')) {
      if (*at_ == '#') {
        skip_line();
      } else {
        ++at_;
      }
    }
  }

  const char* at_;
  const char* end_;
};

Result<Mesh> parse_off(std::string_view bytes, const std::string& path) {
  const Error bad{ErrorCode::bad_syntax, "This is not an OFF file of points and faces.", path};
  Words words(bytes);
  std::size_t points = 0, faces = 0, edges = 0;
  if (!words.word("OFF") || !words.number(points) || !words.number(faces) || !words.number(edges)) return bad;
  if (points > bytes.size() || faces > bytes.size()) return bad;
  Mesh mesh;
  mesh.points.resize(3 * points);
  for (double& value : mesh.points) {
    if (!words.number(value)) return bad;
  }
  for (std::size_t f = 0; f < faces; ++f) {
    std::size_t corners = 0;
    std::uint32_t first = 0, previous = 0, corner = 0;
    if (!words.number(corners)) return bad;
    for (std::size_t i = 0; i < corners; ++i, previous = corner) {
      if (!words.number(corner)) return bad;
      if (corner >= points) return Error{ErrorCode::bad_index, "A face names a point that does not exist.", path};
      if (i == 0) first = corner;
      if (i >= 2) mesh.triangles.insert(mesh.triangles.end(), {first, previous, corner});
    }
    words.skip_line();
  }
  return mesh;
}

struct CornerHash {
  std::size_t operator()(const std::array<float, 3>& p) const {
    std::uint64_t hash = 0;
    for (const float value : p) hash = (hash ^ std::bit_cast<std::uint32_t>(value)) * 0x9e3779b97f4a7c15u;
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};

Result<Mesh> parse_stl(std::string_view bytes, const std::string& path) {
  const Error bad{ErrorCode::bad_syntax, "This is not a binary STL file.", path};
  std::uint32_t count = 0;
  if (bytes.size() < stl_header + sizeof count) return bad;
  std::memcpy(&count, bytes.data() + stl_header, sizeof count);
  if (bytes.size() < stl_header + sizeof count + stl_record * std::size_t{count}) return bad;
  Mesh mesh;
  mesh.triangles.reserve(3 * std::size_t{count});
  std::unordered_map<std::array<float, 3>, std::uint32_t, CornerHash> index_of(count);
  const char* record = bytes.data() + stl_header + sizeof count;
  for (std::uint32_t t = 0; t < count; ++t, record += stl_record) {
    for (std::size_t i = 1; i <= 3; ++i) {
      std::array<float, 3> p{};
      std::memcpy(p.data(), record + i * sizeof p, sizeof p);
      for (float& value : p) value += 0.0f;  // -0 and 0 are one point.
      const auto next = static_cast<std::uint32_t>(mesh.points.size() / 3);
      const auto [place, fresh] = index_of.try_emplace(p, next);
      if (fresh) mesh.points.insert(mesh.points.end(), p.begin(), p.end());
      mesh.triangles.push_back(place->second);
    }
  }
  return mesh;
}

}  // namespace

Result<void> write_mesh_file(const std::string& path, const Mesh& mesh) {
  const bool off = ends_with(path, ".off");
  if (!off && !ends_with(path, ".stl")) return unknown_format(path);
  ByteSink sink(path);
  if (off) {
    put_off(sink, mesh);
  } else {
    put_stl(sink, mesh);
  }
  if (!sink.close()) return Error{ErrorCode::unwritable, "The file cannot be written.", path};
  return {};
}

Result<Mesh> read_mesh_file(const std::string& path) {
  const bool off = ends_with(path, ".off");
  if (!off && !ends_with(path, ".stl")) return unknown_format(path);
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{ErrorCode::missing_file, "The file cannot be opened.", path};
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return off ? parse_off(bytes, path) : parse_stl(bytes, path);
}

}  // namespace quoin::examples
