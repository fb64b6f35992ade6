/// \file
/// The folder of a corpus while it is written: inputs, and the list of operations on them.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "booleans/body/body.h"
#include "quoin/quoin.h"

namespace quoin::corpus {

/// One line of the list `operations` is an id, then the words of the command line. A word that begins with "@" is a
/// file that an operation makes; all others that are files are inputs in the folder.
/// What cannot be written ends the program.
class Folder {
 public:
  explicit Folder(std::filesystem::path path);

  /// Writes an input, and says its name. Inputs of the same bytes and extension are one file, that of the first name.
  std::string text(const std::string& name, std::string_view content);
  /// As OFF, or as binary STL, by the extension of the name.
  std::string mesh(const std::string& name, const Mesh& mesh);
  /// A raw mesh in grid steps, as OFF: `name` has no extension.
  std::string body(const std::string& name, const booleans::Body& raw);
  /// All parts in files name-1.off, name-2.off, ..: their names in a row.
  std::string meshes(const std::string& name, const std::vector<Mesh>& parts);

  /// Adds an operation; where its words name no output it makes "@ID.quoin", which is returned.
  std::string operation(const std::string& id, const std::string& words);

  /// Writes the list, and says how many operations it has.
  std::size_t close() const;

 private:
  std::filesystem::path path_;
  std::map<std::string, std::string> names_;  // of inputs, by extension and content
  std::set<std::string> taken_;               // names of inputs, ids of operations
  std::vector<std::string> lines_;
};

/// Three digits.
std::string numbered(std::size_t number);

/// A raw mesh in grid steps as it is.
Mesh mesh_of(const booleans::Body& raw);

// The families: each adds inputs and operations. `sources` is the root of the source tree.

/// Random solids of the families of tests/booleans/support.h: Booleans, chains of them, cuts, soups.
void add_random_solids(Folder& folder);
/// What the fuzz targets know: Boolean scripts, model scripts and texts of models.
void add_fuzz_corpora(Folder& folder, const std::filesystem::path& sources);
/// Models: primitives, motions, ways to round, parameters, half-spaces, the gear box, refusals.
void add_models(Folder& folder, const std::filesystem::path& sources);
/// Meshes of examples/models.h of up to some 20,000 triangles: large faces, many operands, many components, hosts.
void add_meshes(Folder& folder);
/// What happens at the doors: grids, import, crossings, motions and cuts of solids, export, refusals.
void add_doors(Folder& folder);

}  // namespace quoin::corpus
