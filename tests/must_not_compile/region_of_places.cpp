// Law: a place of a vertex that has no id yet is no vertex of the table.
#include "booleans/assemble/making.h"

using namespace quoin::booleans;

void wait(Making& making, const Regions<VertexId>& merged, const Regions<PlaceId>& waiting) {
#ifdef CONTROL
  making.waiting = waiting;
#else
  making.waiting = merged;
#endif
}
