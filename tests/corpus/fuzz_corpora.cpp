#include <algorithm>
#include <fstream>

#include "fuzz/model_script.h"
#include "fuzz/script.h"
#include "tests/corpus/folder.h"

namespace quoin::corpus {
namespace {

std::vector<std::filesystem::path> files_of(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<char> bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::span<const std::uint8_t> octets(const std::vector<char>& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

/// An expression over files as a node of a model.
std::string node(const booleans::Expression& e, const std::vector<std::string>& files, std::uint32_t at = 0) {
  const auto& n = e.nodes[at];
  std::string text;
  if (n.rule == booleans::Rule::operand) {
    text = "{\"mesh\": {\"file\": \"" + files[n.operand] + "\"}}";
  } else {
    for (std::uint32_t child = at + 1; child < e.nodes.size(); ++child)
      if (e.nodes[child].parent == at) text += (text.empty() ? "" : ", ") + node(e, files, child);
    const char* word = n.rule == booleans::Rule::any   ? "union"
                       : n.rule == booleans::Rule::all ? "intersection"
                                                       : "symmetric-difference";
    text = "{\"" + std::string(word) + "\": [" + text + "]}";
  }
  return n.negated ? "{\"complement\": " + text + "}" : text;
}

/// A whole expression, evaluated at once.
void add_boolean_script(Folder& folder, const std::string& name, const std::vector<char>& bytes) {
  const fuzz::Script script = fuzz::script(octets(bytes));
  std::vector<std::string> files;
  for (std::size_t i = 0; i < script.operands.size(); ++i)
    files.push_back(folder.body(name + "-" + std::to_string(i), script.operands[i]));
  const std::string text = "{\"quoin-model\": 1, \"step\": 1, \"model\": " + node(script.expression, files) + "}\n";
  folder.operation(name, "eval " + folder.text(name + ".json", text));
}

/// The model, and the model moved.
void add_model_script(Folder& folder, const std::string& name, const std::vector<char>& bytes) {
  const fuzz::ModelScript script = fuzz::model_script(octets(bytes));
  static constexpr std::array roundings{"best", "naive", "continued-fraction", "lattice", "face-local", "vertices"};
  std::string options = std::string(" --rounding ") + roundings[static_cast<std::size_t>(script.options.rounding)];
  if (script.options.grid) options += " --step " + script.options.grid->step();
  for (const auto& [parameter, value] : script.options.parameters) {
    std::string word = parameter + "=" + value;
    word.erase(std::remove(word.begin(), word.end(), ' '), word.end());
    options += " --set " + word;
  }

  folder.operation(name, "eval " + folder.text(name + ".json", script.model.to_json() + "\n") + options);
  const std::string moved = folder.text(name + "-moved.json", script.step(script.model).to_json() + "\n");
  folder.operation(name + "-moved", "eval " + moved + options);
}

}  // namespace

void add_fuzz_corpora(Folder& folder, const std::filesystem::path& sources) {
  const std::filesystem::path corpora = sources / "fuzz" / "corpus";
  // Ids follow the files' names, so that they stay when a corpus grows.
  const auto name_of = [](const std::filesystem::path& file) { return file.filename().string().substr(0, 12); };
  for (const auto& file : files_of(corpora / "boolean"))
    add_boolean_script(folder, "script-" + name_of(file), bytes_of(file));
  for (const auto& file : files_of(corpora / "model"))
    add_model_script(folder, "model_script-" + name_of(file), bytes_of(file));
  for (const auto& file : files_of(corpora / "model_text")) {
    const std::string name = "model_text-" + file.filename().string();
    const std::vector<char> bytes = bytes_of(file);
    folder.operation(name, "eval " + folder.text(name + ".json", {bytes.data(), bytes.size()}));
  }
}

}  // namespace quoin::corpus
