// AMF (ISO/ASTM 52915), plain or zipped: objects of volumes, and constellations that place them.
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

#include "io/formats.h"
#include "io/packages/assembly.h"
#include "io/packages/xml.h"
#include "io/packages/zip.h"
#include "io/text_output.h"

namespace quoin::io {
namespace {

/// The elements that say something; all others are passed over, and so is what is in them but for these.
enum class AmfState {
  outside,
  amf,
  object,
  mesh,
  vertices,
  vertex,
  coordinates,
  volume,
  triangle,
  constellation,
  instance,
  number,
  name,
  other
};

AmfState state_within(AmfState from, std::string_view name, std::string_view kind) {
  struct Rule {
    AmfState from;
    std::string_view name;
    AmfState to;
  };
  static constexpr std::array<Rule, 10> rules = {{{AmfState::outside, "amf", AmfState::amf},
                                                  {AmfState::amf, "object", AmfState::object},
                                                  {AmfState::amf, "constellation", AmfState::constellation},
                                                  {AmfState::object, "mesh", AmfState::mesh},
                                                  {AmfState::mesh, "vertices", AmfState::vertices},
                                                  {AmfState::mesh, "volume", AmfState::volume},
                                                  {AmfState::vertices, "vertex", AmfState::vertex},
                                                  {AmfState::vertex, "coordinates", AmfState::coordinates},
                                                  {AmfState::volume, "triangle", AmfState::triangle},
                                                  {AmfState::constellation, "instance", AmfState::instance}}};
  for (const Rule& rule : rules)
    if (rule.from == from && rule.name == name) return rule.to;
  // Numbers are elements of their own.
  const bool is_number = from == AmfState::coordinates || from == AmfState::triangle || from == AmfState::instance;
  if (is_number) return AmfState::number;
  if (name == "metadata" && kind == "name" && (from == AmfState::object || from == AmfState::constellation))
    return AmfState::name;
  return AmfState::other;
}

class AmfReader : public XmlHandler {
 public:
  bool open(const XmlElement& element) override {
    const AmfState from = states_.empty() ? AmfState::outside : states_.back();
    const std::string_view kind = element.attribute("type").value_or("");
    const AmfState state = from == AmfState::other ? AmfState::other : state_within(from, element.name(), kind);
    states_.push_back(state);
    text_.clear();
    switch (state) {
      case AmfState::amf:
        return unit(element);
      case AmfState::object:
      case AmfState::constellation:
        return node(element);
      case AmfState::mesh:
        points_.clear();
        first_mesh_ = meshes.size();
        return true;
      case AmfState::coordinates:
      case AmfState::triangle:
        values_.clear();
        return true;
      case AmfState::volume:
        meshes.emplace_back();
        nodes.back().meshes.push_back(static_cast<std::uint32_t>(meshes.size() - 1));
        return true;
      case AmfState::instance:
        return instance(element);
      case AmfState::number:
        number_name_ = element.name();
        return true;
      case AmfState::other:
        if (from == AmfState::outside) return fail(ErrorCode::unknown_format, "this is no AMF");
        if (element.name() == "color" || element.name() == "texmap") ++colours;
        return true;
      default:
        return true;
    }
  }

  bool text(std::string_view piece) override {
    const AmfState state = states_.back();
    if (state == AmfState::number || state == AmfState::name) text_ += piece;
    return true;
  }

  bool close() override {
    const AmfState state = states_.back();
    states_.pop_back();
    switch (state) {
      case AmfState::number:
        return read_number();
      case AmfState::name:
        nodes.back().name = text_;
        return true;
      case AmfState::coordinates:
        return coordinates();
      case AmfState::triangle:
        return triangle();
      case AmfState::instance:
        return place();
      case AmfState::mesh:
        // All volumes of an object share its vertices.
        for (std::size_t i = first_mesh_; i < meshes.size(); ++i) meshes[i].points = points_;
        return share();
      default:
        return true;
    }
  }

  Unit unit_of_file = Unit::millimeter;
  std::vector<PolygonMesh> meshes;
  std::vector<AssemblyNode> nodes;
  std::vector<std::vector<std::pair<std::string, Placing>>> instances;  // of each node, by name
  std::map<std::string, std::uint32_t> node_of;
  std::uint64_t colours = 0;

 private:
  bool unit(const XmlElement& element) {
    const auto word = element.attribute("unit");
    if (!word) return true;
    const auto known = unit_called(*word == "feet" ? "foot" : *word);
    if (!known) return fail(ErrorCode::bad_syntax, "\"" + std::string(*word) + "\" is no unit of AMF");
    unit_of_file = *known;
    return true;
  }

  bool node(const XmlElement& element) {
    const auto id = element.attribute("id");
    if (!id) return fail(ErrorCode::bad_syntax, "an object lacks its id");
    if (!node_of.emplace(*id, static_cast<std::uint32_t>(nodes.size())).second)
      return fail(ErrorCode::bad_syntax, "two objects have the id " + std::string(*id));
    nodes.push_back({{}, "object " + std::string(*id), {}, {}});
    instances.emplace_back();
    return true;
  }

  bool instance(const XmlElement& element) {
    const auto id = element.attribute("objectid");
    if (!id) return fail(ErrorCode::bad_syntax, "an instance lacks its objectid");
    instances.back().push_back({std::string(*id), {}});
    values_.clear();
    return true;
  }

  bool read_number() {
    double value = 0;
    if (number_name_.starts_with("v") && states_.back() == AmfState::triangle) {
      std::uint32_t vertex = 0;
      if (!index(text_, vertex)) return false;
      value = vertex;
    } else if (!wanted(number_name_)) {
      return true;
    } else if (!number(text_, value)) {
      return false;
    }
    values_[number_name_] = value;
    return true;
  }

  bool wanted(std::string_view name) const {
    static constexpr std::array<std::string_view, 9> names = {"x",      "y",  "z",  "deltax", "deltay",
                                                              "deltaz", "rx", "ry", "rz"};
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  bool coordinates() {
    for (const char* name : {"x", "y", "z"}) {
      const auto found = values_.find(name);
      if (found == values_.end()) return fail(ErrorCode::bad_syntax, "a vertex lacks " + std::string(name));
      points_.push_back(found->second);
    }
    return true;
  }

  bool triangle() {
    PolygonMesh& mesh = meshes.back();
    for (const char* name : {"v1", "v2", "v3"}) {
      const auto found = values_.find(name);
      if (found == values_.end()) return fail(ErrorCode::bad_syntax, "a triangle lacks " + std::string(name));
      if (found->second >= static_cast<double>(points_.size() / 3))
        return fail(ErrorCode::bad_index, "a triangle names a vertex that does not exist");
      mesh.corners.push_back(static_cast<std::uint32_t>(found->second));
    }
    mesh.starts.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    return true;
  }

  /// Rotations about x, y and z, then the shift.
  bool place() {
    Placing& placing = instances.back().back().second;
    MatrixStep shift = identity_step;
    for (std::size_t k = 0; k < 3; ++k) {
      const char axis = "xyz"[k];
      if (const double angle = values_[std::string("r") + axis]; angle != 0) placing.emplace_back(AngleStep{k, angle});
      shift.rows[4 * k + 3] = values_[std::string("delta") + axis];
    }
    if (shift != identity_step) placing.emplace_back(shift);
    return true;
  }

  /// A mesh of many volumes has its vertices once for each: the file does not bound that.
  bool share() {
    shared_ += points_.size() * (meshes.size() - first_mesh_);
    return shared_ <= max_placed_corners || fail(ErrorCode::absurd_count, "volumes share too many vertices");
  }

  std::vector<AmfState> states_;
  std::string text_, number_name_;
  std::vector<double> points_;
  std::size_t first_mesh_ = 0;
  std::uint64_t shared_ = 0;
  std::map<std::string, double> values_;
};

/// Objects of the scene: what no constellation places, in the order of the file.
Result<Scene> scene_of(AmfReader& reader) {
  std::vector<bool> is_child(reader.nodes.size(), false);
  for (std::size_t i = 0; i < reader.nodes.size(); ++i)
    for (auto& [id, placing] : reader.instances[i]) {
      const auto found = reader.node_of.find(id);
      if (found == reader.node_of.end())
        return Error{
            ErrorCode::bad_index, "there is no object " + id + ", which is named here", {}, reader.nodes[i].place};
      is_child[found->second] = true;
      reader.nodes[i].children.push_back({found->second, std::move(placing)});
    }

  Scene scene;
  scene.unit = reader.unit_of_file;
  AssemblyWalk walk(reader.nodes, reader.meshes);
  for (std::uint32_t i = 0; i < reader.nodes.size(); ++i) {
    if (is_child[i]) continue;
    const auto walked = walk.visit({i, {}}, [&](const AssemblyNode& node, PlacedMesh placed) {
      // All volumes of an object are one thing.
      if (placed.mesh == node.meshes.front()) scene.objects.push_back({node.name, {}});
      scene.objects.back().meshes.push_back(std::move(placed));
    });
    if (!walked) return walked.error();
  }
  // In a ring of constellations each is placed by another one.
  if (!reader.nodes.empty() && std::find(is_child.begin(), is_child.end(), false) == is_child.end())
    return Error{ErrorCode::bad_syntax, "every object is within another one", {}, reader.nodes[0].place};
  scene.meshes = std::move(reader.meshes);
  if (reader.colours > 0)
    scene.notices.push_back(passed_over(reader.colours, "colour or texture", "colours and textures"));
  return scene;
}

const ZipEntry* amf_entry(const ZipArchive& archive) {
  for (const ZipEntry& entry : archive.entries())
    if (entry.name.ends_with(".amf") || entry.name.ends_with(".AMF")) return &entry;
  return nullptr;
}

}  // namespace

bool looks_like_amf(std::string_view bytes) {
  if (!ZipArchive::looks_like(bytes)) return first_element(bytes) == "amf";
  const auto archive = ZipArchive::open(bytes);
  return archive && amf_entry(archive.value()) != nullptr;
}

Result<Scene> read_amf(std::string_view bytes, const Beside&) {
  std::string unpacked, part;
  if (ZipArchive::looks_like(bytes)) {
    const auto archive = ZipArchive::open(bytes);
    if (!archive) return archive.error();
    const ZipEntry* entry = amf_entry(archive.value());
    if (entry == nullptr) return Error{ErrorCode::unknown_format, "the archive holds no .amf file", {}, "byte 0"};
    auto content = archive.value().content(*entry);
    if (!content) return content.error();
    unpacked = std::move(content).value();
    part = entry->name;
    bytes = unpacked;
  }

  AmfReader reader;
  if (const auto read = read_xml(bytes, reader, part); !read) return read.error();
  return scene_of(reader);
}

std::string write_amf(std::span<const double> points, std::span<const std::uint32_t> triangles, Unit unit) {
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<amf version=\"1.1\"";
  // AMF knows no centimetre, which readers of the same words may take.
  if (unit != Unit::none) out.append(" unit=\"").append(unit == Unit::foot ? "feet" : name_of(unit)).append("\"");
  out += ">\n<object id=\"0\">\n<mesh>\n<vertices>\n";
  const auto append_element = [&](std::string_view name, auto value) {
    out.append("<").append(name).append(">");
    append_number(out, value);
    out.append("</").append(name).append(">");
  };
  for (std::size_t i = 0; i < points.size(); i += 3) {
    out += "<vertex><coordinates>";
    for (std::size_t k = 0; k < 3; ++k) append_element(std::string_view("xyz").substr(k, 1), points[i + k]);
    out += "</coordinates></vertex>\n";
  }
  out += "</vertices>\n<volume>\n";
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    out += "<triangle>";
    for (std::size_t k = 0; k < 3; ++k) append_element(std::array{"v1", "v2", "v3"}[k], triangles[i + k]);
    out += "</triangle>\n";
  }
  return out + "</volume>\n</mesh>\n</object>\n</amf>\n";
}

}  // namespace quoin::io
