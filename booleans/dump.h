/// \file
/// The stages of a Boolean as text: for tests, and to see where a result goes wrong (docs/where.md).
///
/// Points are written by their coordinates, rounded to six digits, planes as "[a b c d]"; every line is one thing, so
/// that two dumps compare line by line. Developer builds write the stages that the environment names to stderr:
/// QUOIN_DUMP=contacts,sheets.
#pragma once

#include <cstdio>
#include <string>

#include "booleans/classify/selection.h"

namespace quoin::booleans {

/// "operand.face - operand.face"
std::string dump(const FacePairs& pairs, const Operands& operands);
/// A face with its plane, then its boundary edges and isolated points.
std::string dump(const Touched& touched, const Names& names);
/// "on [plane]: a - b", or a single point.
std::string dump(const Contacts& contacts, const Names& names);
/// A sheet with its plane; its facets with the faces that cover them and their boundary; isolated points.
std::string dump(const Sheets& sheets, const Names& names);
/// An edge and what meets at it.
std::string dump(const Uses& uses, const Names& names);
/// "node: front cell, back cell"
std::string dump(const Cells& cells);
/// "node: +1, 0 or -1"
std::string dump(const Selection& selection);
/// Vertices, then faces with their loops.
std::string dump(const Body& body);

#ifdef QUOIN_CHECKED
/// Does the environment ask for a stage?
bool is_dump_asked(const char* stage);
/// Writes text() to stderr if the environment asks for it.
template <class Text>
void dump_if_asked(const char* stage, Text&& text) {
  if (is_dump_asked(stage)) std::fprintf(stderr, "== %s\n%s", stage, text().c_str());
}
#else
template <class Text>
void dump_if_asked(const char*, Text&&) {}
#endif

}  // namespace quoin::booleans
