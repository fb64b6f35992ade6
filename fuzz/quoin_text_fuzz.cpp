/// \file
/// Laws of .quoin texts, checked on valid ones that were damaged in their structure, and on any text.
///
/// Bytes that begin as a text does are one. Others choose a valid text by the first byte, and a change by each four
/// that follow.
#include <span>
#include <string_view>

#include "fuzz/law.h"
#include "io/quoin.h"
#include "tests/api/doors/quoin_damage.h"

namespace quoin::fuzz {
namespace {

constexpr std::size_t most_changes = 4;

std::string damaged_text(std::span<const std::uint8_t> bytes) {
  static const std::vector<std::string> texts = damage::valid_texts();
  damage::Document document = damage::opened(texts[bytes.empty() ? 0 : bytes[0] % texts.size()]);
  for (std::size_t i = 0; i < most_changes && 4 * i + 4 < bytes.size(); ++i) {
    const auto change = bytes.subspan(4 * i + 1, 4);
    damage::damage(document, change[0], change[1], change[2], change[3]);
  }
  return damage::closed(document);
}

/// The text as Quoin would write it: without comments and carriage returns.
std::string plain_text(std::string_view text) {
  const auto document = io::read_quoin(text);
  return document ? io::write_quoin(document.value()) : std::string(text);
}

void run(std::span<const std::uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::string plain = text.starts_with("quoin") ? plain_text(text) : damaged_text(bytes);
  if (const auto law = damage::broken_law(plain)) fail(law->c_str(), plain);
  const auto trusted = Solid::from_quoin(plain, Trust::embedded);
  if (!trusted) return;
  require(!trusted.value().to_quoin().empty(), "a trusted text can be written");
  const Boundary boundary = trusted.value().boundary();
  require(boundary.components().size() == boundary.component_count(), "a trusted boundary has components");
}

}  // namespace
}  // namespace quoin::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  quoin::fuzz::run({data, size});
  return 0;
}
