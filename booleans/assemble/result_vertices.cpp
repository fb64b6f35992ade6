#include "booleans/assemble/result_vertices.h"

namespace quoin::booleans {

ResultVertices::ResultVertices(const Arrangement& a, OperandId host, Body& body)
    : a_(a),
      host_(host),
      body_(body),
      place_of_table_(a.names.vertices.size()),
      name_of_table_(a.names.vertices.size()),
      place_(a.operands.bodies.size()),
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
  if (in_table(host_, v)) name_of_table_[table_vertex(host_, v)] = name;
  return name;
}

ResultName ResultVertices::named(OperandId operand, std::uint32_t v) {
  if (operand == host_) return host_name(v);
  const std::uint32_t bits = own_names_[operand][v];
  return bits < listed ? ResultName::of_corner(bits) : new_name(operand, v);
}

ResultName ResultVertices::new_name(OperandId operand, std::uint32_t v) {
  const bool is_in_table = in_table(operand, v);
  if (is_in_table && !name_of_table_[table_vertex(operand, v)].is_none())
    return name_of_table_[table_vertex(operand, v)];

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
    name_of_table_[table_vertex(operand, v)] = name;
  else
    own_names_[operand][v] = name.as_corner();
  return name;
}

PlaceId ResultVertices::new_place(OperandId operand, std::uint32_t v, ResultName name) {
  return places_.add({operand, v, name, {}, !name.is_none(), !name.is_none()});
}

PlaceId ResultVertices::place_of_table(VertexId v) {
  PlaceId& p = place_of_table_[v];
  if (p == none) p = new_place(none, v.value, name_of_table_[v]);
  return p;
}

PlaceId ResultVertices::place(OperandId operand, std::uint32_t v) {
  if (in_table(operand, v)) return place_of_table(table_vertex(operand, v));
  if (operand == host_) {
    const auto [at, is_new] = place_in_host_.try_emplace(v, none);
    if (is_new) at->second = new_place(operand, v, name_in_host(v));
    return at->second;
  }

  auto& own = place_[operand];
  if (own.empty()) own.assign(a_.operands[operand].vertex_count(), none);
  if (own[v] == none) own[v] = new_place(operand, v, ResultName::of_corner(own_names_[operand][v]));
  return own[v];
}

ResultName ResultVertices::known_name(const Place& p) const {
  if (p.name.is_none() && p.operand == none && host_ != none) return host_name_of_table_[VertexId(p.vertex)];
  return p.name;
}

ResultName ResultVertices::add_point(const Place& p) {
  const VertexTable& vertices = a_.names.vertices;
  if (is_grid(p)) {
    body_.grid_points.push_back(p.operand == none ? vertices.grid_point(p.vertex)
                                                  : a_.operands[p.operand].grid_points[p.vertex]);
    return ResultName::grid(body_.grid_points.size() - 1);
  }
  body_.points.push_back(p.operand == none ? vertices.point(p.vertex) : a_.operands[p.operand].point(p.vertex));
  return ResultName::derived(body_.points.size() - 1);
}

}  // namespace quoin::booleans
