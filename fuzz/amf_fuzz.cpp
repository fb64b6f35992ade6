/// \file
/// Laws of AMF files, plain or zipped.
#include "fuzz/scene_law.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  quoin::fuzz::require_scene_or_refusal({reinterpret_cast<const char*>(data), size}, quoin::Format::amf);
  return 0;
}
