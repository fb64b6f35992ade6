#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

#include "api/doors/stated_unit.h"
#include "api/model/formula.h"
#include "api/model/node.h"
#include "io/json.h"
#include "io/too_large.h"

namespace quoin {

using io::Json;
using ModelNode = Access::ModelNode;

namespace {

constexpr const char* version_key = "quoin-model";
constexpr const char* version = "1";

Error bad(const Json& at, std::string message) { return {ErrorCode::bad_model, std::move(message), {}, at.place()}; }

// Writing.

bool is_number(const std::string& text) {
  // What JSON itself calls a number.
  std::size_t i = 0;
  const auto digits = [&] {
    const std::size_t begin = i;
    while (i < text.size() && text[i] >= '0' && text[i] <= '9') ++i;
    return i - begin;
  };

  if (i < text.size() && text[i] == '-') ++i;
  const std::size_t first = i, whole = digits();
  if (whole == 0 || whole > 15 || (whole > 1 && text[first] == '0') || text == "-0") return false;
  if (i < text.size() && text[i] == '.') {
    ++i;
    const std::size_t fraction = digits();
    if (fraction == 0) return false;
  }
  return i == text.size();
}

Json json_of(const std::string& text) { return is_number(text) ? io::json_number(text) : io::json_text(text); }

/// `lists`: within how many lists the formulas are.
Json json_of(const ModelValue& value, int lists) {
  if (lists == 0) return json_of(value.text);
  Json list = io::json_list();
  for (const ModelValue& item : value.items) list.items.push_back(json_of(item, lists - 1));
  return list;
}

Json json_of(const std::map<std::string, std::string>& parameters) {
  Json object = io::json_object();
  for (const auto& [name, text] : parameters) object.members.emplace_back(name, json_of(text));
  return object;
}

/// Writes shared nodes once, as parts.
class ModelWriter {
 public:
  std::string run(const Model& model) {
    Json document = io::json_object({{version_key, io::json_number(version)}});
    const ModelNode* root = Access::node(model).get();
    // One that says nothing would be lost.
    if (root && root->kind == ModelKind::scope && root->name.empty() &&
        !(root->step.empty() && root->parameters.empty())) {
      add_scope(*root, document);
      root = Access::node(root->children[0]).get();
    }

    find_parts(root);
    name_parts();
    Json parts = io::json_object();
    for (const ModelNode* part : order_) parts.members.emplace_back(part_name_[part], written(part));
    if (!parts.members.empty()) document.members.emplace_back("parts", std::move(parts));
    document.members.emplace_back("model", reference(root));
    return io::write_json(document);
  }

 private:
  static void add_scope(const ModelNode& scope, Json& object) {
    if (!scope.step.empty()) object.members.emplace_back("step", json_of(scope.step));
    if (!scope.parameters.empty()) object.members.emplace_back("parameters", json_of(scope.parameters));
  }

  /// Nodes with more than one parent, and every twentieth level, so that no text is nested deeply; children first.
  void find_parts(const ModelNode* root) {
    struct Visit {
      const ModelNode* node;
      std::size_t next = 0;
      int height = 0;
    };
    std::map<const ModelNode*, int> height;
    std::set<const ModelNode*> shared;
    std::vector<Visit> stack;

    const auto enter = [&](const ModelNode* node) {
      if (node == nullptr) return;
      if (const auto known = height.find(node); known != height.end()) {
        shared.insert(node);
        if (!stack.empty()) stack.back().height = std::max(stack.back().height, 1);
        return;
      }
      stack.push_back({node});
    };

    std::vector<const ModelNode*> all;
    enter(root);
    while (!stack.empty()) {
      Visit& visit = stack.back();
      if (visit.next < visit.node->children.size()) {
        enter(Access::node(visit.node->children[visit.next++]).get());
        continue;
      }

      const Visit done = visit;
      stack.pop_back();
      int h = done.height + 1;
      if (h >= 20) {
        shared.insert(done.node);
        h = 0;
      }
      height[done.node] = h;
      all.push_back(done.node);
      if (!stack.empty()) stack.back().height = std::max(stack.back().height, h);
    }

    for (const ModelNode* node : all)
      if (shared.count(node) && node != root) order_.push_back(node);
  }

  void name_parts() {
    std::set<std::string> taken;
    std::map<std::string, int> count;
    for (const ModelNode* node : order_) {
      const bool named = !node->name.empty() && is_text(node->name);
      const std::string base = named ? node->name : rule_of(node->kind).word;
      std::string name = base;
      for (int& i = count[base]; !taken.insert(name).second;) name = base + " " + std::to_string(++i + 1);
      part_name_[node] = name;
    }
  }

  /// Whether JSON can hold it: UTF-8.
  static bool is_text(const std::string& name) {
    const auto back = io::read_json(io::write_json(io::json_text(name)));
    return back && back.value().text == name;
  }

  Json reference(const ModelNode* node) {
    if (!node) return io::json_object({{rule_of(ModelKind::any).word, io::json_list()}});
    if (const auto part = part_name_.find(node); part != part_name_.end())
      return io::json_object({{"part", io::json_text(part->second)}});
    return written(node);
  }

  Json written(const ModelNode* node) {
    const ModelRule& rule = rule_of(node->kind);
    Json body = io::json_object();
    for (std::size_t i = 0; i < rule.fields.size(); ++i) {
      const ModelField& field = rule.fields[i];
      body.members.emplace_back(field.name, json_of(node->values[i], field.lists + (field.count > 1 ? 1 : 0)));
    }
    if (node->kind == ModelKind::scope) add_scope(*node, body);
    if (node->kind == ModelKind::solid) body.members.emplace_back("quoin", io::json_text(node->solid->to_quoin()));

    if (rule.children == ModelChildren::many) {
      body = io::json_list();
      for (const Model& child : node->children) body.items.push_back(reference(Access::node(child).get()));
    } else if (rule.children == ModelChildren::one) {
      Json child = reference(Access::node(node->children[0]).get());
      if (node->kind == ModelKind::complement)
        body = std::move(child);
      else
        body.members.emplace_back("of", std::move(child));
    }

    Json object = io::json_object({{rule.word, std::move(body)}});
    if (!node->name.empty()) object.members.emplace_back("name", io::json_text(node->name));
    return object;
  }

  std::vector<const ModelNode*> order_;
  std::map<const ModelNode*, std::string> part_name_;
};

// Reading. Errors name the place of the value that is wrong.

/// A document that is being read.
struct Reading {
  const std::string& folder;  // of the files that it names
  const ModelReadOptions& options;
  std::vector<MeshImport>* imports;         // nullptr, or where files that are read are added
  const Json* parts;                        // nullptr where it has none
  std::map<std::string, Model> known = {};  // parts that are read
  std::set<std::string> open = {};          // parts that are being read
  StatedUnit unit = {};                     // of the files that are read
  std::uint64_t depth = 0;                  // of nodes within each other
  static constexpr std::uint64_t deepest = Limits{}.depth;
};

Result<Model> read_node(const Json& json, Reading& reading);

/// Names may be long.
std::string quoted(const std::string& word) { return "\"" + word.substr(0, 80) + "\""; }

bool is_scalar(const Json& json) { return json.kind == Json::Kind::number || json.kind == Json::Kind::text; }

std::shared_ptr<ModelNode> node_at(const Json& json, ModelKind kind) {
  auto node = std::make_shared<ModelNode>();
  node->kind = kind;
  node->place = json.place();
  return node;
}

std::optional<Error> unknown_member(const Json& object, std::initializer_list<std::string_view> known) {
  for (const auto& [name, value] : object.members)
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      std::string list;
      for (const auto word : known) list += (list.empty() ? "" : ", ") + std::string(word);
      return bad(value, quoted(name) + " is not known here; known are: " + list);
    }
  return std::nullopt;
}

// Scopes.

std::optional<Error> read_step(const Json& json, ModelNode& scope) {
  if (!is_scalar(json)) return bad(json, "the step is a number");
  if (auto grid = Grid::with_step(json.text); !grid) return bad(json, grid.error().message);
  scope.step = json.text;
  return std::nullopt;
}

std::optional<Error> read_parameters(const Json& json, ModelNode& scope) {
  if (json.kind != Json::Kind::object) return bad(json, "\"parameters\" is an object of numbers");
  for (const auto& [name, value] : json.members) {
    if (!is_parameter_name(name))
      return bad(value, quoted(name) + " is no name for a parameter: a letter, then letters and digits");
    if (!is_scalar(value)) return bad(value, "a parameter is a number, or a formula in quotes");
    scope.parameters[name] = value.text;
  }
  return std::nullopt;
}

/// A scope around a model, as "step" and "parameters" of an object say.
Result<Model> scoped(const Json& object, Model model) {
  auto scope = node_at(object, ModelKind::scope);
  scope->children.push_back(std::move(model));
  if (const Json* step = object.member("step"))
    if (auto fault = read_step(*step, *scope)) return *fault;
  if (const Json* parameters = object.member("parameters"))
    if (auto fault = read_parameters(*parameters, *scope)) return *fault;
  return Access::model(std::move(scope));
}

// Fields.

Result<ModelValue> read_formula(const Json& json, const ModelField& field) {
  if (!is_scalar(json)) return bad(json, quoted(field.name) + " wants a number, or a formula in quotes");
  return ModelValue{json.text};
}

/// A vector that is no list: "x", "y", "z" are directions; one factor is that of all directions.
std::optional<ModelValue> shorthand(const Json& json, const ModelField& field) {
  const std::string_view name = field.name;
  ModelValue v;
  if ((name == "axis" || name == "normal") && (json.text == "x" || json.text == "y" || json.text == "z"))
    for (const char* axis : {"x", "y", "z"}) v.items.push_back({json.text == axis ? "1" : "0"});
  if (name == "factors" && is_scalar(json)) v.items.assign(3, {json.text});
  if (v.items.empty()) return std::nullopt;
  return v;
}

/// `lists`: within how many lists the vectors are.
Result<ModelValue> read_value(const Json& json, const ModelField& field, int lists) {
  if (lists == 0 && field.count == 1) return read_formula(json, field);
  if (lists == 0 && json.kind != Json::Kind::list)
    if (auto v = shorthand(json, field)) return *std::move(v);

  if (json.kind != Json::Kind::list || (lists == 0 && json.items.size() != field.count))
    return bad(json, quoted(field.name) + " wants a list" +
                         (lists == 0 ? " of " + std::to_string(field.count) + " numbers" : ""));
  ModelValue v;
  for (const Json& item : json.items) {
    auto inner = lists > 0 ? read_value(item, field, lists - 1) : read_formula(item, field);
    if (!inner) return inner.error();
    v.items.push_back(std::move(inner).value());
  }
  return v;
}

/// A member of a node's body that is neither a field nor what the kind has besides.
std::optional<Error> unknown_field(const ModelRule& rule, const Json& body) {
  for (const auto& [name, value] : body.members) {
    const auto known = [&word = name](const ModelField& f) { return word == f.name; };
    const bool is_scope = rule.kind == ModelKind::scope && (name == "step" || name == "parameters");
    if (std::any_of(rule.fields.begin(), rule.fields.end(), known) || is_scope ||
        (rule.children == ModelChildren::one && name == "of") || (rule.kind == ModelKind::solid && name == "quoin"))
      continue;
    std::string list;
    for (const ModelField& f : rule.fields) list += (list.empty() ? "" : ", ") + std::string(f.name);
    return bad(value, quoted(name) + " is not known in \"" + rule.word + "\"; known are: " + list +
                          (rule.children == ModelChildren::one ? ", of" : ""));
  }
  return std::nullopt;
}

std::optional<Error> read_fields(const ModelRule& rule, const Json& body, ModelNode& made) {
  if (auto fault = unknown_field(rule, body)) return fault;
  for (const ModelField& field : rule.fields) {
    const Json* json = body.member(field.name);
    if (!json && !field.fallback) return bad(body, quoted(rule.word) + " lacks \"" + field.name + "\"");
    auto value = json ? read_value(*json, field, field.lists) : Result<ModelValue>(ModelValue{field.fallback});
    if (!value) return value.error();
    made.values.push_back(std::move(value).value());
  }
  // A matrix is not any list of rows.
  if (rule.kind == ModelKind::transform && made.values[0].items.size() != 3)
    return bad(body, "a matrix has three rows");
  return std::nullopt;
}

// Solids.

/// A solid that stands in the text.
std::optional<Error> read_solid(const Json& body, ModelNode& made) {
  const Json* text = body.member("quoin");
  if (!text || text->kind != Json::Kind::text) return bad(body, "\"solid\" lacks \"quoin\", the text of a .quoin file");
  auto solid = Solid::from_quoin(text->text);
  if (!solid) return bad(*text, solid.error().message + " (" + solid.error().where + ")");
  made.solid = std::move(solid).value();
  return std::nullopt;
}

/// A file that is named again is the same again.
void note_import(const std::string& path, const ImportReport& report, Unit unit, Reading& reading) {
  if (!reading.imports) return;
  auto& imports = *reading.imports;
  const auto is_known = [&](const MeshImport& known) { return known.file == path; };
  if (std::none_of(imports.begin(), imports.end(), is_known)) imports.push_back({path, report, unit});
}

/// Whether a name leads out of the folder: by its own words, or by links. What does not exist leads nowhere.
bool leads_out(const std::string& folder, const std::string& name) {
  namespace fs = std::filesystem;
  const fs::path words = name;
  if (words.is_absolute() || std::find(words.begin(), words.end(), "..") != words.end()) return true;

  std::error_code missing;
  const fs::path home = fs::canonical(folder, missing);
  const fs::path file = missing ? fs::path() : fs::canonical(home / words, missing);
  if (missing) return false;
  return std::mismatch(home.begin(), home.end(), file.begin(), file.end()).first != home.end();
}

/// A solid from a file.
Result<Model> read_mesh(const Json& json, const Json& body, Reading& reading) {
  const Json* file = body.member("file");
  if (!file || file->kind != Json::Kind::text) return bad(body, "a mesh has the member \"file\", a text");
  if (auto fault = unknown_member(body, {"file"})) return *fault;

  const std::string& name = file->text;
  if (name.find('\0') != std::string::npos) return bad(*file, "the name of a file holds a byte 0");
  const std::string path = name.starts_with('/') ? name : reading.folder + "/" + name;
  if (reading.options.files == ModelFiles::below && leads_out(reading.folder, name))
    return bad(*file, "a model may name files of its folder and below only, not " + quoted(name) +
                          ": --any-path, or ModelFiles::anywhere, allows others");

  const Limits& limits = reading.options.limits;
  auto source = read_source(path, {}, Trust::nothing, reading.options.unit, limits);
  if (!source) return source.error();
  const Unit unit = source.value().unit;
  if (const auto added = reading.unit.add(unit, path); !added) return added.error();
  std::vector<Source> one;
  one.push_back(std::move(source).value());
  std::vector<ImportReport> reports;
  auto solids = build(std::move(one), {.repair = reading.options.repair, .limits = limits}, &reports);
  if (!reports.empty()) note_import(path, reports[0], unit, reading);
  if (!solids) return solids.error();

  auto made = node_at(json, ModelKind::solid);
  made->solid = std::move(solids.value()[0]);
  return Access::model(std::move(made));
}

// Parts.

Result<Model> read_part(const std::string& name, const Json& json, Reading& reading) {
  if (const auto known = reading.known.find(name); known != reading.known.end()) return known->second;
  if (!reading.open.insert(name).second) return bad(json, "the part \"" + name + "\" contains itself");
  auto model = read_node(json, reading);
  reading.open.erase(name);
  if (model) reading.known.emplace(name, model.value());
  return model;
}

Result<Model> read_part_named(const Json& json, Reading& reading) {
  const auto fault = bad(json, "there is no part " + quoted(json.text));
  const Json* found = reading.parts && json.kind == Json::Kind::text ? reading.parts->member(json.text) : nullptr;
  return found ? read_part(json.text, *found, reading) : fault;
}

// Primitives, motions, scopes, operations.

std::optional<Error> read_child(const Json& json, ModelNode& made, Reading& reading) {
  auto child = read_node(json, reading);
  if (!child) return child.error();
  made.children.push_back(std::move(child).value());
  return std::nullopt;
}

/// The terms of an operation.
std::optional<Error> read_terms(const ModelRule& rule, const Json& body, ModelNode& made, Reading& reading) {
  if (body.kind != Json::Kind::list) return bad(body, quoted(rule.word) + " is a list of nodes");
  for (const Json& item : body.items)
    if (auto fault = read_child(item, made, reading)) return fault;
  return std::nullopt;
}

/// What stands by name: a primitive's fields, a solid, a motion's or scope's fields and what it is of.
std::optional<Error> read_members(const ModelRule& rule, const Json& body, ModelNode& made, Reading& reading) {
  if (body.kind != Json::Kind::object) return bad(body, quoted(rule.word) + " is an object {..}");
  if (auto fault = read_fields(rule, body, made)) return fault;
  if (rule.kind == ModelKind::solid) return read_solid(body, made);
  if (rule.children != ModelChildren::one) return std::nullopt;

  const Json* of = body.member("of");
  if (!of) return bad(body, quoted(rule.word) + " lacks \"of\"");
  return read_child(*of, made, reading);
}

Result<Model> read_known_node(const Json& json, const std::string& word, const Json& body, Reading& reading) {
  const ModelRule* rule = rule_of(word);
  if (!rule) return bad(json, quoted(word) + " is no kind of node");

  auto made = node_at(json, rule->kind);
  const auto fault = rule->children == ModelChildren::many ? read_terms(*rule, body, *made, reading)
                     : rule->kind == ModelKind::complement ? read_child(body, *made, reading)
                                                           : read_members(*rule, body, *made, reading);
  if (fault) return *fault;
  if (rule->kind == ModelKind::scope) return scoped(body, made->children[0]);
  return Access::model(std::move(made));
}

Result<Model> read_node(const Json& json, Reading& reading) {
  if (json.kind != Json::Kind::object)
    return bad(json, "a node is an object such as {\"block\": {\"size\": [1, 2, 3]}}");
  if (const auto most = std::min(reading.options.limits.depth, Reading::deepest); reading.depth == most)
    return io::too_large("nodes are nested more deeply", "depth", most, json.place());
  const Json* name = json.member("name");
  if (name && name->kind != Json::Kind::text) return bad(*name, "a name is a text");
  if (json.members.size() != (name ? 2U : 1U))
    return bad(json, "a node has one member that says what it is, and perhaps a \"name\"");

  const auto& [word, body] = json.members[json.members[0].first == "name" ? 1 : 0];
  ++reading.depth;
  auto model = word == "part"   ? read_part_named(body, reading)
               : word == "mesh" ? read_mesh(json, body, reading)
                                : read_known_node(json, word, body, reading);
  --reading.depth;
  if (model && name) return model.value().named(name->text);
  return model;
}

// The document.

/// Whether the document is a model of this version.
std::optional<Error> version_fault(const Json& document) {
  if (document.kind != Json::Kind::object) return bad(document, "a model is an object {..}");
  const Json* stated = document.member(version_key);
  if (!stated) return bad(document, "the member \"quoin-model\": 1 is missing: this is no model of Quoin's");
  if (stated->kind != Json::Kind::number) return bad(*stated, "the version is a number, without quotes");
  if (stated->text != version)
    return bad(*stated, "this is version " + stated->text + " of the format; this program reads version " + version);
  return std::nullopt;
}

Result<Model> read_document(const Json& document, Reading& reading) {
  if (auto fault = version_fault(document)) return *fault;
  if (auto fault = unknown_member(document, {version_key, "step", "parameters", "parts", "model"})) return *fault;
  const Json *parts = reading.parts, *root = document.member("model");
  if (parts && parts->kind != Json::Kind::object) return bad(*parts, "\"parts\" is an object of named nodes");
  if (!root) return bad(document, "the member \"model\" is missing");

  // In the order of the text, so that parts made of earlier ones are no deep recursion.
  if (parts)
    for (const auto& [name, json] : parts->members)
      if (auto part = read_part(name, json, reading); !part) return part.error();
  auto model = read_node(*root, reading);
  if (!model || !(document.member("step") || document.member("parameters"))) return model;
  return scoped(document, std::move(model).value());
}

}  // namespace

namespace {

/// The first run of digits that is longer than the limit, as an error.
std::optional<Error> long_number(std::string_view text, std::uint64_t most_digits) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  for (auto at = text.begin(); at != text.end();) {
    const auto begin = std::find_if(at, text.end(), is_digit);
    at = std::find_if_not(begin, text.end(), is_digit);
    const auto digits = static_cast<std::uint64_t>(at - begin);
    if (digits <= most_digits) continue;
    Error error = too_many_digits(digits, most_digits);
    error.where = "line " + std::to_string(1 + std::count(text.begin(), begin, '\n'));
    return error;
  }
  return std::nullopt;
}

}  // namespace

std::string Model::to_json() const { return ModelWriter().run(*this); }

Result<Model> Model::from_json(std::string_view text, const std::string& folder, std::vector<MeshImport>* imports,
                               const ModelReadOptions& options) {
  if (imports) imports->clear();
  if (auto fault = long_number(text, options.limits.digits)) return *fault;
  const auto document = io::read_json(text);
  if (!document) return document.error();
  Reading reading{folder, options, imports, document.value().member("parts")};
  return read_document(document.value(), reading);
}

}  // namespace quoin
