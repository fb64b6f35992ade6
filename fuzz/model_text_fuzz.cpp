/// \file
/// Laws of model files, checked on any text: what is read, what is refused and how, what is written again.
#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <sstream>
#include <string_view>

#include "api/model/formula.h"
#include "api/model/node.h"
#include "fuzz/law.h"
#include "io/json.h"

namespace quoin::fuzz {
namespace {

using Node = Access::ModelNode;
using io::Json;

/// Below what is no folder, no file can be read; from "/" on any could.
constexpr const char* folder = "/dev/null/nowhere";
bool names_absolute_file(const Json& json) {
  const Json* file = json.member("file");
  if (file && file->text.starts_with('/')) return true;
  const auto within = [](const auto& member) { return names_absolute_file(member.second); };
  return std::any_of(json.items.begin(), json.items.end(), names_absolute_file) ||
         std::any_of(json.members.begin(), json.members.end(), within);
}

/// "line L, column C", both from 1, in characters of UTF-8. The end of a line or text may be where an error is.
void check_place(const std::string& place, std::string_view text) {
  unsigned long line = 0, column = 0;
  int length = 0;
  const int read = std::sscanf(place.c_str(), "line %lu, column %lu%n", &line, &column, &length);
  require(read == 2 && static_cast<std::size_t>(length) == place.size(), "a place is a line and a column:", place);
  require(line >= 1 && column >= 1, "lines and columns count from 1:", place);
  for (unsigned long n = 1; n < line; ++n) {
    const auto end = text.find('\n');
    require(end != std::string_view::npos, "a place is on a line of the text:", place);
    text.remove_prefix(end + 1);
  }
  text = text.substr(0, text.find('\n'));
  const auto begins_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; };
  const auto width = static_cast<unsigned long>(std::count_if(text.begin(), text.end(), begins_character));
  require(column <= std::max(width, 1ul), "a place is within its line:", place);
}

void check_refusal(const Error& error, std::string_view text) {
  require(error.code != ErrorCode::internal_defect, "an error has a code");
  require(!error.message.empty(), "an error has a message:", to_string(error.code));
  if (error.code == ErrorCode::bad_model) check_place(error.where, text);
}

void add_texts(const ModelValue& value, std::vector<std::string>& texts) {
  if (value.items.empty()) texts.push_back(value.text);
  for (const ModelValue& item : value.items) add_texts(item, texts);
}

/// The nodes of a model in the order in which they are met, each once and with all that it says.
struct Contents {
  std::vector<std::string> nodes;     // what each is, its children by their places in this list
  std::vector<std::string> formulas;  // of all fields and parameters
  std::map<std::string, std::string> parameters;
};

Contents contents(const Model& model) {
  Contents c;
  std::map<const Node*, std::size_t> known;
  std::vector<const Node*> order;
  const auto number = [&](const Node* node) {
    const auto [at, fresh] = known.try_emplace(node, order.size());
    if (fresh) order.push_back(node);
    return at->second;
  };
  number(Access::node(model).get());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Node& node = *order[i];
    std::ostringstream s;
    s << rule_of(node.kind).word << "\nnamed " << node.name << "\nstep " << node.step;
    std::vector<std::string> texts;
    for (const ModelValue& value : node.values) add_texts(value, texts);
    for (const auto& [name, definition] : node.parameters) {
      s << "\nparameter " << name;
      c.parameters[name] = definition;
      texts.push_back(definition);
    }
    for (const std::string& text : texts) s << "\n" << text;
    if (node.solid) s << "\n" << node.solid->to_quoin();
    for (const Model& child : node.children) s << "\nof " << number(Access::node(child).get());
    c.nodes.push_back(s.str());
    c.formulas.insert(c.formulas.end(), texts.begin(), texts.end());
  }
  return c;
}

/// Values as texts; of what has none, the code of its error. Few formulas, since each may have 2^16 bits.
std::vector<std::string> values(const Contents& c) {
  constexpr std::size_t most = 100, longest = 200;
  std::size_t size = 0;
  for (const auto& [name, definition] : c.parameters) size += definition.size();
  std::vector<std::string> r;
  if (size > 5 * longest) return r;
  Parameters parameters(c.parameters);
  for (const std::string& formula : c.formulas) {
    if (formula.size() > longest) continue;
    if (r.size() == most) break;
    const auto value = parameters.value(formula);
    if (!value) {
      require(!value.error().message.empty(), "an error of a formula has a message:", formula);
      require(value.error().code == ErrorCode::bad_number || value.error().code == ErrorCode::bad_parameter,
              "an error of a formula has one of two codes:", to_string(value.error().code));
    }
    r.push_back(value ? exact::to_string(value.value()) : to_string(value.error().code));
  }
  return r;
}

void run(std::span<const std::uint8_t> bytes) {
  const std::string text(bytes.begin(), bytes.end());
  const auto json = io::read_json(text);
  if (json && names_absolute_file(json.value())) return;
  const auto model = Model::from_json(text, folder);
  if (!model) return check_refusal(model.error(), text);
  require(static_cast<bool>(json), "a model is JSON");
  const std::string written = model.value().to_json();
  const auto again = Model::from_json(written, folder);
  require(static_cast<bool>(again), "what is written is accepted:", again ? "" : again.error().message + written);
  const std::string rewritten = again.value().to_json();
  require(rewritten == written, "what is written stays as it is:", written + rewritten);
  const Contents before = contents(model.value()), after = contents(again.value());
  require(before.nodes == after.nodes, "what is written says the same:", written);
  require(values(before) == values(after), "formulas keep their values:", written);
}

}  // namespace
}  // namespace quoin::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  quoin::fuzz::run({data, size});
  return 0;
}
