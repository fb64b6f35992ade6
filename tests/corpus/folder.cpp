#include "tests/corpus/folder.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <utility>

#include "examples/mesh_file.h"

namespace quoin::corpus {
namespace {

[[noreturn]] void fail(const std::string& what, const std::filesystem::path& path) {
  std::fprintf(stderr, "quoin-corpus: %s: %s\n", path.c_str(), what.c_str());
  std::exit(1);
}

std::string content_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

Folder::Folder(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error) fail(error.message(), path_);
  if (!std::filesystem::is_empty(path_)) fail("the folder is not empty", path_);
}

std::string Folder::text(const std::string& name, std::string_view content) {
  const std::string key = std::filesystem::path(name).extension().string() + '\n' + std::string(content);
  const auto [at, fresh] = names_.try_emplace(key, name);
  if (!fresh) return at->second;

  if (!taken_.insert(name).second) fail("two inputs have this name", name);
  std::ofstream out(path_ / name, std::ios::binary);
  out << content;
  out.close();
  if (!out) fail("cannot be written", path_ / name);
  return name;
}

std::string Folder::mesh(const std::string& name, const Mesh& mesh) {
  const std::filesystem::path draft = path_ / ("draft-" + name);
  if (const auto written = examples::write_mesh_file(draft.string(), mesh); !written)
    fail(written.error().message, draft);
  const std::string content = content_of(draft);
  std::filesystem::remove(draft);
  return text(name, content);
}

std::string Folder::body(const std::string& name, const booleans::Body& raw) {
  return mesh(name + ".off", mesh_of(raw));
}

std::string Folder::meshes(const std::string& name, const std::vector<Mesh>& parts) {
  std::string names;
  for (std::size_t i = 0; i < parts.size(); ++i)
    names += (i > 0 ? " " : "") + mesh(name + "-" + std::to_string(i + 1) + ".off", parts[i]);
  return names;
}

std::string Folder::operation(const std::string& id, const std::string& words) {
  if (!taken_.insert("@" + id).second) fail("two operations have this id", id);
  const std::string result = "@" + id + ".quoin";
  const bool names_output = words.find(" -o ") != std::string::npos;
  lines_.push_back(id + " " + words + (names_output ? "" : " -o " + result));
  return result;
}

std::size_t Folder::close() const {
  std::ofstream out(path_ / "operations", std::ios::binary);
  for (const std::string& line : lines_) out << line << '\n';
  out.close();
  if (!out) fail("cannot be written", path_ / "operations");
  return lines_.size();
}

std::string numbered(std::size_t number) {
  std::array<char, 24> digits{};
  std::snprintf(digits.data(), digits.size(), "%03zu", number);
  return digits.data();
}

Mesh mesh_of(const booleans::Body& raw) {
  Mesh mesh;
  for (const exact::GridPoint& p : raw.grid_points)
    for (const std::int32_t x : p.c) mesh.points.push_back(x);
  for (const auto& t : raw.triangles) mesh.triangles.insert(mesh.triangles.end(), t.begin(), t.end());
  return mesh;
}

}  // namespace quoin::corpus
