#include "booleans/assemble/result_vertices.h"

namespace quoin::booleans {

ResultVertices::ResultVertices(const Arrangement& a, OperandId host, Body& body)
    : a_(a),
      host_(host),
      body_(body),
      places_(a.names.vertices.size()),
      place_of_(a.operands.bodies.size()),
      own_names_(a.operands.bodies.size()) {
  for (const OperandId o : a.operands.ids()) {
    if (o == host) continue;
    own_names_[o].assign(a.operands[o].vertex_count(), none);
    for (const std::uint32_t v : a.names.operands[o].listed) own_names_[o][v] = by_table;
  }
  if (host == none) return;

  host_name_of_table_.resize(a.names.vertices.size());
  for (const std::uint32_t v : a.names.operands[host].listed)
    host_name_of_table_[table_vertex(host, v)] = name_in_host(v);
}

ResultName ResultVertices::name_in_host(std::uint32_t v) const {
  const Body& host = a_.operands[host_];
  return host.is_grid(v) ? ResultName::grid(v) : ResultName::derived(v - host.derived_base());
}

/// A vertex of the host has its own name; that is known to the table from now on.
ResultName ResultVertices::host_name(std::uint32_t v) {
  const ResultName name = name_in_host(v);
  if (in_table(host_, v)) places_[place(table_vertex(host_, v))].name = name;
  return name;
}

ResultName ResultVertices::named(OperandId operand, std::uint32_t v) {
  if (operand == host_) return host_name(v);
  const std::uint32_t bits = own_names_[operand][v];
  return bits < listed ? ResultName::of_corner(bits) : new_name(operand, v);
}

ResultName ResultVertices::new_name(OperandId operand, std::uint32_t v) {
  const bool is_in_table = in_table(operand, v);
  if (is_in_table)
    if (const ResultName known = name_of_table(table_vertex(operand, v)); !known.is_none()) return known;

  const Body& body = a_.operands[operand];
  ResultName name;
  if (body.is_grid(v)) {
    name = ResultName::grid(body_.grid_points.size());
    body_.grid_points.push_back(body.grid_points[v]);
  } else {
    name = ResultName::derived(body_.points.size());
    body_.points.push_back(body.derived(v));
  }

  if (is_in_table)
    places_[place(table_vertex(operand, v))].name = name;
  else
    own_names_[operand][v] = name.as_corner();
  return name;
}

PlaceId ResultVertices::place(OperandId operand, std::uint32_t v) {
  if (in_table(operand, v)) return place(table_vertex(operand, v));

  auto& own = place_of_[operand];
  if (own.size() == 0) own = grid::Paged<PlaceId>(a_.operands[operand].vertex_count());
  if (own[v] == none) {
    const bool is_host = operand == host_;
    own.at(v) = places_.add({is_host ? name_in_host(v) : ResultName::of_corner(own_names_[operand][v])});
    outside_.push_back({operand, v});
  }
  return own[v];
}

bool ResultVertices::is_grid(PlaceId p) const {
  if (in_table(p)) return a_.names.vertices.is_grid(p.value);
  return a_.operands[outside(p).operand].is_grid(outside(p).vertex);
}

void ResultVertices::add_neighbours(PlaceId p, PlaceId before, PlaceId next) {
  Place& place = places_[p];
  auto& n = place.neighbours;
  if (n[1] == many) return;
  if (!place.name.is_none()) n[1] = many;

  for (const PlaceId q : {before, next}) {
    if (n[0] == none || n[0] == q)
      n[0] = q;
    else if (n[1] == none || n[1] == q)
      n[1] = q;
    else
      n[1] = many;
  }
}

int ResultVertices::side(PlaceId p, const exact::Plane& plane) const {
  if (!in_table(p)) return exact::side(plane, a_.operands[outside(p).operand].point(outside(p).vertex));
  const auto& vertices = a_.names.vertices;
  return vertices.is_grid(p.value) ? exact::side(plane, vertices.grid_point(p.value))
                                   : exact::side(plane, vertices.point(p.value));
}

ResultName ResultVertices::named(PlaceId p) {
  ResultName& name = places_[p].name;
  if (name.is_none() && host_ != none && in_table(p)) name = host_name_of_table_[VertexId(p.value)];
  if (name.is_none()) name = add_point(p);
  return name;
}

/// Appends the place's point to the body.
ResultName ResultVertices::add_point(PlaceId p) {
  const bool is_known = in_table(p);
  if (is_grid(p)) {
    body_.grid_points.push_back(is_known ? a_.names.vertices.grid_point(p.value)
                                         : a_.operands[outside(p).operand].grid_points[outside(p).vertex]);
    return ResultName::grid(body_.grid_points.size() - 1);
  }
  body_.points.push_back(is_known ? a_.names.vertices.point(p.value)
                                  : a_.operands[outside(p).operand].point(outside(p).vertex));
  return ResultName::derived(body_.points.size() - 1);
}

}  // namespace quoin::booleans
