// 3MF, core specification 1.4: a package of XML parts. Of the production extension the paths of parts are followed;
// colours, materials, textures and what other extensions add are counted.
#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <set>
#include <utility>

#include "io/formats.h"
#include "io/packages/assembly.h"
#include "io/packages/xml.h"
#include "io/packages/zip.h"
#include "io/text_output.h"

namespace quoin::io {
namespace {

constexpr std::string_view core_space = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
/// The draft of 2013 has the same meshes, components and items; its colours have other names.
constexpr std::string_view draft_space = "http://schemas.microsoft.com/3dmanufacturing/2013/01";
constexpr std::string_view production_space = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
constexpr std::string_view material_space = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";
constexpr std::string_view slice_space = "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07";
constexpr std::string_view set_space = "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07";
/// Extensions without which the meshes say the same.
constexpr std::array<std::string_view, 5> harmless_spaces = {core_space, production_space, material_space, slice_space,
                                                             set_space};
constexpr std::string_view model_relationship = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
constexpr std::string_view relationships_part = "_rels/.rels", model_part = "3D/3dmodel.model";

enum class ModelState {
  outside,
  model,
  resources,
  object,
  mesh,
  vertices,
  vertex,
  triangles,
  triangle,
  components,
  component,
  build,
  item,
  other
};

struct Transition {
  ModelState from;
  std::string_view name;
  ModelState to;
};
constexpr std::array<Transition, 12> transitions = {{{ModelState::outside, "model", ModelState::model},
                                                     {ModelState::model, "resources", ModelState::resources},
                                                     {ModelState::model, "build", ModelState::build},
                                                     {ModelState::resources, "object", ModelState::object},
                                                     {ModelState::object, "mesh", ModelState::mesh},
                                                     {ModelState::object, "components", ModelState::components},
                                                     {ModelState::mesh, "vertices", ModelState::vertices},
                                                     {ModelState::mesh, "triangles", ModelState::triangles},
                                                     {ModelState::vertices, "vertex", ModelState::vertex},
                                                     {ModelState::triangles, "triangle", ModelState::triangle},
                                                     {ModelState::components, "component", ModelState::component},
                                                     {ModelState::build, "item", ModelState::item}}};

/// Elements that are not of the core, or not where it has them, are passed over with what is in them.
ModelState state_within(ModelState from, const XmlElement& element) {
  if (element.space() != core_space && element.space() != draft_space) return ModelState::other;
  for (const Transition& transition : transitions)
    if (transition.from == from && transition.name == element.name()) return transition.to;
  return ModelState::other;
}

/// Whether an object or triangle has colours or materials.
bool is_painted(const XmlElement& element) {
  constexpr std::array<std::string_view, 4> names = {"pid", "p1", "materialid", "colorid"};
  return std::any_of(names.begin(), names.end(),
                     [&](std::string_view name) { return element.attribute(name).has_value(); });
}

/// An object by the part that holds it and its number there.
using ObjectId = std::pair<std::string, std::uint32_t>;

struct Reference {
  ObjectId id;
  Placing placing;
};

/// What all model parts of a package say together.
struct Package {
  Unit unit = Unit::millimeter;
  std::vector<PolygonMesh> meshes;
  std::vector<AssemblyNode> nodes;
  std::vector<std::vector<Reference>> components;  // of each node
  std::map<ObjectId, std::uint32_t> node_of;
  std::vector<Reference> items;
  std::uint64_t properties = 0, no_solids = 0, extensions = 0, unprinted = 0;
};

class ModelReader : public XmlHandler {
 public:
  ModelReader(Package& package, std::string part, bool is_root)
      : package_(package), part_(std::move(part)), is_root_(is_root) {}

  bool prefix(std::string_view prefix, std::string_view space) override {
    spaces_[std::string(prefix)] = space;
    return true;
  }

  bool open(const XmlElement& element) override {
    const ModelState from = states_.empty() ? ModelState::outside : states_.back();
    const ModelState state = from == ModelState::other ? ModelState::other : state_within(from, element);
    states_.push_back(state);
    switch (state) {
      case ModelState::model:
        return model(element);
      case ModelState::object:
        return object(element);
      case ModelState::mesh:
        return mesh();
      case ModelState::vertex:
        return vertex(element);
      case ModelState::triangle:
        return triangle(element);
      case ModelState::component:
        return reference(element, package_.components.back());
      case ModelState::item:
        // Only the part that the package names as its model builds.
        return !is_root_ || item(element);
      case ModelState::other:
        if (from != ModelState::other) extension(element);
        return from != ModelState::outside || fail(ErrorCode::bad_syntax, "this is no model of 3MF");
      default:
        return true;
    }
  }

  bool close() override {
    states_.pop_back();
    return true;
  }

 private:
  bool model(const XmlElement& element) {
    if (const auto unit = element.attribute("unit"); unit && is_root_) {
      const auto known = unit_called(*unit);
      if (!known || name_of(*known) != *unit)
        return fail(ErrorCode::bad_syntax, "\"" + std::string(*unit) + "\" is no unit of 3MF");
      package_.unit = *known;
    }
    const auto required = element.attribute("requiredextensions");
    return !required || extensions(*required);
  }

  /// The prefixes of extensions without which the model is something else.
  bool extensions(std::string_view words) {
    while (!words.empty()) {
      const std::size_t end = std::min(words.find(' '), words.size());
      const std::string prefix(words.substr(0, end));
      words.remove_prefix(std::min(end + 1, words.size()));
      const std::string& space = spaces_[prefix];
      if (!prefix.empty() && std::find(harmless_spaces.begin(), harmless_spaces.end(), space) == harmless_spaces.end())
        return fail(ErrorCode::unknown_format,
                    "the model requires the extension \"" + (space.empty() ? prefix : space) + "\", which is not read");
    }
    return true;
  }

  /// Counts what an extension adds to shapes.
  void extension(const XmlElement& element) {
    const auto space = element.space();
    if (space != core_space && space != draft_space && space != material_space && space != set_space)
      ++package_.extensions;
  }

  bool object(const XmlElement& element) {
    std::uint32_t id = 0;
    if (!needed_index(element, "id", id)) return false;
    const auto node = static_cast<std::uint32_t>(package_.nodes.size());
    if (!package_.node_of.emplace(ObjectId{part_, id}, node).second)
      return fail(ErrorCode::bad_syntax, "two objects have the id " + std::to_string(id));

    if (element.attribute("meshresolution", slice_space) == "lowres")
      return fail(ErrorCode::unknown_format, "the mesh of object " + std::to_string(id) +
                                                 " is a rough one (\"lowres\") beside slices, which are not read");

    const auto type = element.attribute("type").value_or("model");
    is_solid_ = type == "model" || type == "solidsupport";
    if (!is_solid_) ++package_.no_solids;
    if (is_painted(element)) ++package_.properties;
    AssemblyNode made;
    made.name = element.attribute("name").value_or("");
    made.place = (is_root_ ? "" : part_ + ", ") + "object " + std::to_string(id);
    package_.nodes.push_back(std::move(made));
    package_.components.emplace_back();
    return true;
  }

  bool mesh() {
    // Supports and surfaces bound nothing: they are read, and belong to no solid.
    if (is_solid_) package_.nodes.back().meshes.push_back({static_cast<std::uint32_t>(package_.meshes.size()), {}});
    package_.meshes.emplace_back();
    return true;
  }

  bool vertex(const XmlElement& element) {
    for (const std::string_view name : {"x", "y", "z"}) {
      const auto text = element.attribute(name);
      double value = 0;
      if (!text) return fail(ErrorCode::bad_syntax, "a vertex lacks " + std::string(name));
      if (!number(*text, value)) return false;
      package_.meshes.back().points.push_back(value);
    }
    return true;
  }

  bool triangle(const XmlElement& element) {
    PolygonMesh& mesh = package_.meshes.back();
    for (const std::string_view name : {"v1", "v2", "v3"}) {
      std::uint32_t vertex = 0;
      if (!needed_index(element, name, vertex)) return false;
      if (vertex >= mesh.points.size() / 3)
        return fail(ErrorCode::bad_index, "a triangle names a vertex that does not exist");
      mesh.corners.push_back(vertex);
    }
    mesh.starts.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    if (is_painted(element)) ++package_.properties;
    return true;
  }

  /// Programs that print mark what they are to leave out.
  bool item(const XmlElement& element) {
    if (element.attribute("printable") == "0") ++package_.unprinted;
    return reference(element, package_.items);
  }

  /// A component or an item.
  bool reference(const XmlElement& element, std::vector<Reference>& list) {
    std::uint32_t id = 0;
    if (!needed_index(element, "objectid", id)) return false;
    Reference made{{part_, id}, {}};
    if (const auto path = element.attribute("path", production_space)) made.id.first = *path;
    if (const auto text = element.attribute("transform"); text && !transform(*text, made.placing)) return false;
    list.push_back(std::move(made));
    return true;
  }

  /// Twelve numbers, column by column of the map: points are rows there, and the translation is last.
  bool transform(std::string_view text, Placing& placing) {
    MatrixStep step = {};
    for (std::size_t i = 0; i < 12; ++i) {
      text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
      const std::size_t end = std::min(text.find_first_of(" \t\r\n"), text.size());
      if (end == 0) return fail(ErrorCode::bad_syntax, "a transform has twelve numbers");
      if (!number(text.substr(0, end), step.rows[i % 3 * 4 + i / 3])) return false;
      text.remove_prefix(end);
    }
    if (text.find_first_not_of(" \t\r\n") != std::string_view::npos)
      return fail(ErrorCode::bad_syntax, "a transform has twelve numbers");
    if (step != identity_step) placing.emplace_back(step);
    return true;
  }

  bool needed_index(const XmlElement& element, std::string_view name, std::uint32_t& out) {
    const auto text = element.attribute(name);
    if (text) return index(*text, out);
    return fail(ErrorCode::bad_syntax, std::string(element.name()) + " lacks the attribute " + std::string(name));
  }

  Package& package_;
  std::string part_;
  bool is_root_;
  bool is_solid_ = true;
  std::vector<ModelState> states_;
  std::map<std::string, std::string> spaces_;
};

/// The target of the relationship that names the model.
class RelationshipReader : public XmlHandler {
 public:
  std::string model;

  bool open(const XmlElement& element) override {
    if (element.name() == "Relationship" && element.attribute("Type") == model_relationship && model.empty())
      model = element.attribute("Target").value_or("");
    return true;
  }
  bool close() override { return true; }
};

Error lacks(std::string_view part, std::string message) {
  return {ErrorCode::bad_syntax, std::move(message), {}, std::string(part)};
}

Result<void> read_part(const ZipArchive& archive, std::string_view part, XmlHandler& handler) {
  const ZipEntry* entry = archive.find(part);
  if (entry == nullptr) return lacks(part, "the package lacks this part");
  const auto text = archive.content(*entry);
  if (!text) return text.error();
  return read_xml(text.value(), handler, entry->name);
}

/// The model that the package names, and all parts that it names in turn.
Result<void> read_models(const ZipArchive& archive, const std::string& root, Package& package) {
  std::deque<std::string> waiting = {root};
  std::set<std::string> known = {root};
  for (; !waiting.empty(); waiting.pop_front()) {
    const std::string part = waiting.front();
    const std::size_t old_items = package.items.size(), old_nodes = package.nodes.size();
    ModelReader reader(package, part, part == root);
    if (auto read = read_part(archive, part, reader); !read) return read;

    const auto follow = [&](const Reference& reference) {
      if (known.insert(reference.id.first).second) waiting.push_back(reference.id.first);
    };
    std::for_each(package.items.begin() + static_cast<std::ptrdiff_t>(old_items), package.items.end(), follow);
    for (std::size_t i = old_nodes; i < package.components.size(); ++i)
      std::for_each(package.components[i].begin(), package.components[i].end(), follow);
  }
  return {};
}

Result<PlacedNode> resolved(Reference& reference, const Package& package, const std::string& place) {
  const auto found = package.node_of.find(reference.id);
  if (found != package.node_of.end()) return PlacedNode{found->second, std::move(reference.placing)};
  return Error{ErrorCode::bad_index,
               "there is no object " + std::to_string(reference.id.second) + ", which is named here",
               {},
               place};
}

Result<void> resolve_components(Package& package) {
  for (std::size_t i = 0; i < package.nodes.size(); ++i)
    for (Reference& reference : package.components[i]) {
      auto child = resolved(reference, package, package.nodes[i].place);
      if (!child) return child.error();
      package.nodes[i].children.push_back(std::move(child).value());
    }
  return {};
}

Notice read_although_unprinted(std::uint64_t count) {
  return {count, count == 1 ? "1 item is marked as not to be printed, and read all the same"
                            : std::to_string(count) + " items are marked as not to be printed, and read all the same"};
}

Result<Scene> scene_of(Package package) {
  if (auto done = resolve_components(package); !done) return done.error();
  if (package.items.empty()) return Error{ErrorCode::no_faces, "the model builds nothing: it has no item", {}, "build"};

  Scene scene;
  scene.unit = package.unit;
  AssemblyWalk walk(package.nodes, package.meshes);
  for (std::size_t i = 0; i < package.items.size(); ++i) {
    const std::string place = "item " + std::to_string(i + 1);
    const auto root = resolved(package.items[i], package, place);
    if (!root) return root.error();
    Object object{package.nodes[root.value().node].name, {}};
    const auto walked = walk.visit(
        root.value(), [&](const AssemblyNode&, PlacedMesh placed) { object.meshes.push_back(std::move(placed)); });
    if (!walked) return walked.error();
    scene.objects.push_back(std::move(object));
  }
  scene.meshes = std::move(package.meshes);

  if (package.properties > 0)
    scene.notices.push_back(passed_over(package.properties, "group of colours and materials of faces",
                                        "groups of colours and materials of faces"));
  if (package.no_solids > 0)
    scene.notices.push_back(passed_over(package.no_solids, "object that is no solid (support, surface)",
                                        "objects that are no solids (supports, surfaces)"));
  if (package.extensions > 0)
    scene.notices.push_back(passed_over(package.extensions, "element of an extension (beams, slices, or others)",
                                        "elements of extensions (beams, slices, or others)"));
  if (package.unprinted > 0) scene.notices.push_back(read_although_unprinted(package.unprinted));
  return scene;
}

std::string model_text(std::span<const double> points, std::span<const std::uint32_t> triangles, Unit unit) {
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model";
  if (unit != Unit::none) out.append(" unit=\"").append(name_of(unit)).append("\"");
  out.append(" xml:lang=\"en-US\" xmlns=\"").append(core_space).append("\">\n<resources>\n");
  out.append("<object id=\"1\" type=\"model\">\n<mesh>\n<vertices>\n");
  for (std::size_t i = 0; i < points.size(); i += 3) {
    append_attributes(out, "<vertex", {" x=\"", " y=\"", " z=\""}, points.subspan(i, 3));
    out.append("/>\n");
  }
  out.append("</vertices>\n<triangles>\n");
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    append_attributes(out, "<triangle", {" v1=\"", " v2=\"", " v3=\""}, triangles.subspan(i, 3));
    out.append("/>\n");
  }
  out.append("</triangles>\n</mesh>\n</object>\n</resources>\n<build>\n<item objectid=\"1\"/>\n</build>\n</model>\n");
  return out;
}

}  // namespace

bool looks_like_threemf(std::string_view bytes) {
  if (!ZipArchive::looks_like(bytes)) return false;
  const auto archive = ZipArchive::open(bytes);
  return archive && archive.value().find(relationships_part) != nullptr;
}

Result<Scene> read_threemf(std::string_view bytes, const Beside&) {
  if (!ZipArchive::looks_like(bytes))
    return Error{ErrorCode::unknown_format, "a 3MF file is a ZIP archive, and this is none", {}, "byte 0"};
  const auto archive = ZipArchive::open(bytes);
  if (!archive) return archive.error();
  RelationshipReader relationships;
  if (const auto read = read_part(archive.value(), relationships_part, relationships); !read) return read.error();
  if (relationships.model.empty()) return lacks(relationships_part, "no relationship of the package names a 3D model");

  Package package;
  if (const auto read = read_models(archive.value(), relationships.model, package); !read) return read.error();
  return scene_of(std::move(package));
}

std::string write_threemf(std::span<const double> points, std::span<const std::uint32_t> triangles, Unit unit) {
  const std::string head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  const std::string types =
      head +
      "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
      "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
      "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n"
      "</Types>\n";
  const std::string relationships =
      head + "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n" +
      "<Relationship Id=\"rel0\" Target=\"/" + std::string(model_part) + "\" Type=\"" +
      std::string(model_relationship) + "\"/>\n</Relationships>\n";
  return write_zip({{"[Content_Types].xml", types},
                    {std::string(relationships_part), relationships},
                    {std::string(model_part), model_text(points, triangles, unit)}});
}

}  // namespace quoin::io
