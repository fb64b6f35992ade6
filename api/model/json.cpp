#include <algorithm>
#include <set>

#include "api/model/formula.h"
#include "api/model/node.h"
#include "io/json.h"

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

// Reading.

class ModelReader {
 public:
  /// `imports`: nullptr, or where files that are read are added.
  ModelReader(const std::string& folder, std::vector<MeshImport>* imports) : folder_(folder), imports_(imports) {}

  Result<Model> run(const Json& document) {
    if (document.kind != Json::Kind::object) return bad(document, "a model is an object {..}");
    const Json* stated = document.member(version_key);
    if (!stated) return bad(document, "the member \"quoin-model\": 1 is missing: this is no model of Quoin's");
    if (stated->kind != Json::Kind::number) return bad(*stated, "the version is a number, without quotes");
    if (stated->text != version)
      return bad(*stated, "this is version " + stated->text + " of the format; this program reads version " + version);
    if (auto fault = unknown_member(document, {version_key, "step", "parameters", "parts", "model"})) return *fault;
    if (const Json* parts = document.member("parts")) {
      if (parts->kind != Json::Kind::object) return bad(*parts, "\"parts\" is an object of named nodes");
      parts_ = parts;
    }
    const Json* root = document.member("model");
    if (!root) return bad(document, "the member \"model\" is missing");
    // In the order of the text, so that parts made of earlier ones are no deep recursion.
    if (parts_)
      for (const auto& [name, json] : parts_->members)
        if (auto part = this->part(name, json); !part) return part.error();
    auto model = node(*root);
    if (!model || !(document.member("step") || document.member("parameters"))) return model;
    return scoped(document, std::move(model).value());
  }

 private:
  static std::optional<Error> unknown_member(const Json& object, std::initializer_list<std::string_view> known) {
    for (const auto& [name, value] : object.members)
      if (std::find(known.begin(), known.end(), name) == known.end()) {
        std::string list;
        for (const auto word : known) list += (list.empty() ? "" : ", ") + std::string(word);
        return bad(value, "\"" + name.substr(0, 80) + "\" is not known here; known are: " + list);
      }
    return std::nullopt;
  }

  /// A scope around a model, as "step" and "parameters" of an object say.
  Result<Model> scoped(const Json& object, Model model) {
    auto scope = std::make_shared<ModelNode>();
    scope->kind = ModelKind::scope;
    scope->place = object.place();
    scope->children.push_back(std::move(model));
    if (const Json* step = object.member("step")) {
      if (step->kind != Json::Kind::number && step->kind != Json::Kind::text) return bad(*step, "the step is a number");
      if (auto grid = Grid::with_step(step->text); !grid) return bad(*step, grid.error().message);
      scope->step = step->text;
    }
    if (const Json* parameters = object.member("parameters")) {
      if (parameters->kind != Json::Kind::object) return bad(*parameters, "\"parameters\" is an object of numbers");
      for (const auto& [name, value] : parameters->members) {
        if (!is_parameter_name(name))
          return bad(value,
                     "\"" + name.substr(0, 80) + "\" is no name for a parameter: a letter, then letters and digits");
        if (value.kind != Json::Kind::number && value.kind != Json::Kind::text)
          return bad(value, "a parameter is a number, or a formula in quotes");
        scope->parameters[name] = value.text;
      }
    }
    return Access::model(std::move(scope));
  }

  Result<Model> part(const std::string& name, const Json& json) {
    if (const auto known = known_parts_.find(name); known != known_parts_.end()) return known->second;
    if (!open_.insert(name).second) return bad(json, "the part \"" + name + "\" contains itself");
    auto model = node(json);
    open_.erase(name);
    if (model) known_parts_.emplace(name, model.value());
    return model;
  }

  Result<Model> part_named(const Json& json) {
    const auto fault = bad(json, "there is no part \"" + json.text.substr(0, 80) + "\"");
    const Json* found = parts_ && json.kind == Json::Kind::text ? parts_->member(json.text) : nullptr;
    return found ? part(json.text, *found) : fault;
  }

  Result<Model> node(const Json& json) {
    if (json.kind != Json::Kind::object)
      return bad(json, "a node is an object such as {\"block\": {\"size\": [1, 2, 3]}}");
    if (depth_ == deepest) return bad(json, "parts are nested too deeply");
    const Json* name = json.member("name");
    if (name && name->kind != Json::Kind::text) return bad(*name, "a name is a text");
    if (json.members.size() != (name ? 2U : 1U))
      return bad(json, "a node has one member that says what it is, and perhaps a \"name\"");
    const auto& [word, body] = json.members[json.members[0].first == "name" ? 1 : 0];
    ++depth_;
    auto model = word == "part" ? part_named(body) : word == "mesh" ? mesh(json, body) : known_node(json, word, body);
    --depth_;
    if (model && name) return model.value().named(name->text);
    return model;
  }

  /// A solid from a file.
  Result<Model> mesh(const Json& json, const Json& body) {
    const Json* file = body.member("file");
    if (!file || file->kind != Json::Kind::text) return bad(body, "a mesh has the member \"file\", a text");
    if (auto fault = unknown_member(body, {"file"})) return *fault;

    const std::string path = file->text.starts_with('/') ? file->text : folder_ + "/" + file->text;
    ImportReport report;
    auto solid = quoin::read_solid(path, {}, &report);
    if (!solid) return solid.error();
    note_import(path, report);

    auto made = std::make_shared<ModelNode>();
    made->kind = ModelKind::solid;
    made->place = json.place();
    made->solid = std::move(solid).value();
    return Access::model(std::move(made));
  }

  /// A file that is named again is the same again.
  void note_import(const std::string& path, const ImportReport& report) {
    if (!imports_) return;
    const auto is_known = [&](const MeshImport& known) { return known.file == path; };
    if (std::none_of(imports_->begin(), imports_->end(), is_known)) imports_->push_back({path, report});
  }

  Result<Model> known_node(const Json& json, const std::string& word, const Json& body) {
    const ModelRule* rule = rule_of(word);
    if (!rule) return bad(json, "\"" + word.substr(0, 80) + "\" is no kind of node");
    auto made = std::make_shared<ModelNode>();
    made->kind = rule->kind;
    made->place = json.place();
    if (rule->children == ModelChildren::many) {
      if (body.kind != Json::Kind::list) return bad(body, "\"" + word + "\" is a list of nodes");
      for (const Json& item : body.items) {
        auto child = node(item);
        if (!child) return child.error();
        made->children.push_back(std::move(child).value());
      }
      return Access::model(std::move(made));
    }
    if (rule->kind == ModelKind::complement) {
      auto child = node(body);
      if (!child) return child.error();
      made->children.push_back(std::move(child).value());
      return Access::model(std::move(made));
    }
    if (body.kind != Json::Kind::object) return bad(body, "\"" + word + "\" is an object {..}");
    if (auto fault = read_fields(*rule, body, *made)) return *fault;
    if (rule->kind == ModelKind::scope) return scoped(body, made->children[0]);
    return Access::model(std::move(made));
  }

  std::optional<Error> read_fields(const ModelRule& rule, const Json& body, ModelNode& made) {
    for (const auto& [name, value] : body.members) {
      const auto known = [&word = name](const ModelField& f) { return word == f.name; };
      const bool is_scope = rule.kind == ModelKind::scope && (name == "step" || name == "parameters");
      if (std::any_of(rule.fields.begin(), rule.fields.end(), known) || is_scope ||
          (rule.children == ModelChildren::one && name == "of") || (rule.kind == ModelKind::solid && name == "quoin"))
        continue;
      std::string list;
      for (const ModelField& f : rule.fields) list += (list.empty() ? "" : ", ") + std::string(f.name);
      return bad(value, "\"" + name.substr(0, 80) + "\" is not known in \"" + rule.word + "\"; known are: " + list +
                            (rule.children == ModelChildren::one ? ", of" : ""));
    }
    for (const ModelField& field : rule.fields) {
      const Json* json = body.member(field.name);
      if (!json && !field.fallback) return bad(body, "\"" + std::string(rule.word) + "\" lacks \"" + field.name + "\"");
      auto value = json ? read_value(*json, field, field.lists) : Result<ModelValue>(ModelValue{field.fallback});
      if (!value) return value.error();
      made.values.push_back(std::move(value).value());
    }
    // A matrix is not any list of rows.
    if (rule.kind == ModelKind::transform && made.values[0].items.size() != 3)
      return bad(body, "a matrix has three rows");
    if (rule.kind == ModelKind::solid) return read_solid(body, made);
    if (rule.children == ModelChildren::one) {
      const Json* of = body.member("of");
      if (!of) return bad(body, "\"" + std::string(rule.word) + "\" lacks \"of\"");
      auto child = node(*of);
      if (!child) return child.error();
      made.children.push_back(std::move(child).value());
    }
    return std::nullopt;
  }

  static std::optional<Error> read_solid(const Json& body, ModelNode& made) {
    const Json* text = body.member("quoin");
    if (!text || text->kind != Json::Kind::text)
      return bad(body, "\"solid\" lacks \"quoin\", the text of a .quoin file");
    auto solid = Solid::from_quoin(text->text);
    if (!solid) return bad(*text, solid.error().message + " (" + solid.error().where + ")");
    made.solid = std::move(solid).value();
    return std::nullopt;
  }

  static Result<ModelValue> read_value(const Json& json, const ModelField& field, int lists) {
    const auto scalar = [&](const Json& v) -> Result<ModelValue> {
      if (v.kind != Json::Kind::number && v.kind != Json::Kind::text)
        return bad(v, "\"" + std::string(field.name) + "\" wants a number, or a formula in quotes");
      return ModelValue{v.text};
    };
    if (lists == 0 && field.count == 1) return scalar(json);
    if (lists == 0 && json.kind != Json::Kind::list) {
      // "x", "y", "z" are directions; one factor is that of all directions.
      const std::string_view name = field.name;
      ModelValue v;
      if ((name == "axis" || name == "normal") && (json.text == "x" || json.text == "y" || json.text == "z"))
        for (const char* axis : {"x", "y", "z"}) v.items.push_back({json.text == axis ? "1" : "0"});
      if (name == "factors" && (json.kind == Json::Kind::number || json.kind == Json::Kind::text))
        v.items.assign(3, {json.text});
      if (!v.items.empty()) return v;
    }
    if (json.kind != Json::Kind::list || (lists == 0 && json.items.size() != field.count))
      return bad(json, "\"" + std::string(field.name) + "\" wants a list" +
                           (lists == 0 ? " of " + std::to_string(field.count) + " numbers" : ""));
    ModelValue v;
    for (const Json& item : json.items) {
      auto inner = lists > 0 ? read_value(item, field, lists - 1) : scalar(item);
      if (!inner) return inner.error();
      v.items.push_back(std::move(inner).value());
    }
    return v;
  }

  static constexpr int deepest = 500;
  const std::string& folder_;
  std::vector<MeshImport>* imports_;
  const Json* parts_ = nullptr;
  std::map<std::string, Model> known_parts_;
  std::set<std::string> open_;
  int depth_ = 0;
};

}  // namespace

std::string Model::to_json() const { return ModelWriter().run(*this); }

Result<Model> Model::from_json(std::string_view text, const std::string& folder, std::vector<MeshImport>* imports) {
  if (imports) imports->clear();
  const auto document = io::read_json(text);
  if (!document) return document.error();
  return ModelReader(folder, imports).run(document.value());
}

}  // namespace quoin
