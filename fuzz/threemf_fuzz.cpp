/// \file
/// Laws of 3MF files. Bytes that begin as XML does are the model of a package, others the package itself.
#include "fuzz/scene_law.h"
#include "tests/io/packages/package.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  quoin::fuzz::require_scene_or_refusal(bytes.starts_with('<') ? quoin::io::test::package(bytes) : bytes,
                                        quoin::Format::threemf);
  return 0;
}
