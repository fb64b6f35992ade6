// The words for units of length.
#include <algorithm>
#include <array>

#include "quoin/format.h"

namespace quoin {
namespace {

struct UnitWords {
  std::string_view name, abbreviation;
};

/// In the order of the enumerators.
constexpr std::array<UnitWords, 7> words = {{{"none", ""},
                                             {"micron", "um"},
                                             {"millimeter", "mm"},
                                             {"centimeter", "cm"},
                                             {"inch", "in"},
                                             {"foot", "ft"},
                                             {"meter", "m"}}};

}  // namespace

std::string_view name_of(Unit unit) { return words[static_cast<std::size_t>(unit)].name; }

std::optional<Unit> unit_called(std::string_view word) {
  const auto* found = std::find_if(words.begin() + 1, words.end(), [&](const UnitWords& unit) {
    return unit.name == word || unit.abbreviation == word;
  });
  if (found == words.end()) return std::nullopt;
  return static_cast<Unit>(found - words.begin());
}

}  // namespace quoin
