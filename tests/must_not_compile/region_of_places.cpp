// Law: a place of a vertex that has no id yet is no vertex of the table.
#include "booleans/assemble/making.h"

using namespace quoin::booleans;

void wait(Making& making, const Regions& merged, const quoin::grid::Loops<PlaceId>& waiting) {
#ifdef CONTROL
  making.waiting_loops = waiting;
#else
  making.waiting_loops = merged.loops;
#endif
}
