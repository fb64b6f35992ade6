/// \file
/// The stages of a Boolean one by one, for tests that look at a single one.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "booleans/arrangement/contacts.h"
#include "booleans/dump.h"
#include "booleans/pairs/foreign_pairs.h"
#include "booleans/stages.h"
#include "tests/booleans/support.h"
#include "tests/grid/with_thresholds.h"

namespace quoin::booleans::testing {

using grid::testing::WithThresholds;

/// check(solids, random) for `count` cases of each family (case_count). Ends with the first fatal failure.
template <class Check>
void for_families(std::uint64_t salt, std::uint64_t count, Check&& check) {
  for (const Family family : families)
    for (std::uint64_t number = 0; number < case_count(count); ++number) {
      SCOPED_TRACE(std::string(name_of(family)) + " " + case_name(number));
      Random random(salt, number);
      Solids solids(random, family);
      check(solids, random);
      if (::testing::Test::HasFatalFailure()) return;
    }
}

/// The values of the stages up to the sheets, of bodies that must outlive it.
struct Drawn {
  Operands operands;
  FacePairs pairs;
  Names names;
  Touched touched;
  Contacts contacts;
  Sheets sheets;

  explicit Drawn(std::span<const Body> bodies) : operands(pointers(bodies)), pairs(foreign_pairs(operands)) {
    touched = collect_touched(operands, pairs, names);
    contacts = find_contacts(touched, touched_pairs(touched, pairs), names);
    sheets = draw_sheets(touched, contacts, names);
  }
  static std::vector<const Body*> pointers(std::span<const Body> bodies) {
    std::vector<const Body*> list;
    for (const Body& b : bodies) list.push_back(&b);
    return list;
  }
};

/// All of them, up to the uses.
inline Arrangement arranged(std::span<const Body> bodies) {
  Operands operands(Drawn::pointers(bodies));
  const FacePairs pairs = foreign_pairs(operands);
  return std::move(arrange(std::move(operands), pairs)).value();
}

/// The lines of a dump.
inline std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(in, line);) all.push_back(line);
  return all;
}

/// In alphabetical order, which no numbering changes.
inline std::vector<std::string> sorted_lines(const std::string& text) {
  std::vector<std::string> all = lines_of(text);
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace quoin::booleans::testing
