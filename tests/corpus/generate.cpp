/// \file
/// quoin-corpus: writes the inputs and the list of operations whose results tests/corpus/run hashes.
///
/// The same bytes at every run: seeds are fixed. Inputs are meshes and texts that no Boolean has made, but for solids
/// within some model scripts; so a folder is written once and serves the builds before and after a change.
#include <cstdio>
#include <cstdlib>

#include "tests/corpus/folder.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: quoin-corpus FOLDER\n");
    return 2;
  }
  unsetenv("QUOIN_SEED");  // the random solids are those of the default seed
  using namespace quoin::corpus;
  const std::filesystem::path sources = QUOIN_SOURCES;
  Folder folder(argv[1]);
  add_random_solids(folder);
  add_fuzz_corpora(folder, sources);
  add_models(folder, sources);
  add_meshes(folder);
  add_doors(folder);
  std::printf("%zu operations\n", folder.close());
}
