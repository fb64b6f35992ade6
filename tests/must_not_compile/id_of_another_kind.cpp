// Law: what is one vertex's name names no plane.
#include "booleans/arrangement/names.h"

using quoin::booleans::Names;
using quoin::booleans::PlaneId;
using quoin::booleans::VertexId;

int side(const Names& names, VertexId vertex, PlaneId plane) {
#ifdef CONTROL
  return names.side(vertex, plane);
#else
  return names.side(vertex, vertex);
#endif
}
