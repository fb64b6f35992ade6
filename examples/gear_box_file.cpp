/// \file
/// quoin-gear-box: writes the gear box of examples/gear_box.h as a model file.
#include <fstream>
#include <iostream>

#include "examples/gear_box.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: quoin-gear-box OUT.json\n";
    return 2;
  }
  std::ofstream file(argv[1], std::ios::binary);
  file << quoin::examples::gear_box().to_json() << '\n';
  file.close();
  if (file) return 0;
  std::cerr << "quoin-gear-box: " << argv[1] << ": The file cannot be written.\n";
  return 1;
}
