// The exact boundary.
#include <string>
#include <utility>

#include "c/handles.h"

using namespace quoin::c;
using quoin::Boundary;

namespace {

/// As guarded, with a boundary and an index that must be below a count of it.
template <class Out, class Work>
quoin_code at(const quoin_boundary* boundary, std::uint32_t index, std::uint32_t (Boundary::*count)() const,
              const char* name, Out* out, quoin_error* error, Work&& work) noexcept {
  return guarded(out, error, [&] {
    demand(boundary, "boundary");
    demand_below(index, (boundary->value.*count)(), name);
    work(boundary->value);
  });
}

/// The same for a versioned struct, which keeps its size.
template <class Struct, class Work>
quoin_code filled(const quoin_boundary* boundary, std::uint32_t index, std::uint32_t (Boundary::*count)() const,
                  const char* name, Struct* out, quoin_error* error, Work&& work) noexcept {
  return guarded(error, [&] {
    demand(out, "out");
    demand_size(out, "out");
    demand(boundary, "boundary");
    demand_below(index, (boundary->value.*count)(), name);
    give(work(boundary->value), out);
  });
}

/// Records of four numbers.
std::vector<std::array<std::string, 4>> records(const char* const* given, std::size_t count, const char* where) {
  std::vector<std::array<std::string, 4>> r;
  for (std::size_t i = 0; i < count; ++i) {
    demand(given, where);
    r.push_back(texts<4>(given + 4 * i, where));
  }
  return r;
}

/// Indices of any type, as a list. Throws what is negative or does not fit.
std::vector<std::uint32_t> index_list(const quoin_array& array, const char* where) {
  std::vector<std::uint32_t> list;
  const quoin::Indices given = indices(array, list, where);
  std::visit(
      [&](const auto& numbers) {
        if (!list.empty()) return;  // they are there
        for (const auto i : numbers) {
          if (std::cmp_less(i, 0))
            throw quoin::Exception({quoin::ErrorCode::bad_index,
                                    "the index is negative",
                                    {},
                                    where + (" " + std::to_string(list.size()))});
          list.push_back(static_cast<std::uint32_t>(i));
        }
      },
      given.values());
  return list;
}

}  // namespace

quoin_code quoin_solid_boundary(const quoin_solid* solid, quoin_boundary** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(solid, "solid");
    *out = new quoin_boundary{solid->value.boundary()};
  });
}

quoin_code quoin_boundary_count(const quoin_boundary* boundary, quoin_boundary_counts* out, quoin_error* error) {
  return guarded(error, [&] {
    demand(out, "out");
    demand_size(out, "out");
    demand(boundary, "boundary");
    const Boundary& b = boundary->value;
    give({0, b.vertex_count(), b.face_count(), b.loop_count(), b.corner_count(), b.edge_count(), b.shell_count(),
          b.component_count()},
         out);
  });
}

quoin_code quoin_boundary_point(const quoin_boundary* boundary, uint32_t vertex, double out[3], quoin_error* error) {
  return at(boundary, vertex, &Boundary::vertex_count, "vertex", out, error, [&](const Boundary& b) {
    const auto p = b.point(vertex);
    std::copy(p.begin(), p.end(), out);
  });
}

quoin_code quoin_boundary_coordinate(const quoin_boundary* boundary, uint32_t vertex, uint32_t axis, char** out,
                                     quoin_error* error) {
  return at(boundary, vertex, &Boundary::vertex_count, "vertex", out, error, [&](const Boundary& b) {
    demand_below(axis, 3, "axis");
    *out = text(b.coordinates(vertex)[axis]);
  });
}

quoin_code quoin_boundary_homogeneous(const quoin_boundary* boundary, uint32_t vertex, uint32_t which, char** out,
                                      quoin_error* error) {
  return at(boundary, vertex, &Boundary::vertex_count, "vertex", out, error, [&](const Boundary& b) {
    demand_below(which, 4, "which");
    *out = text(b.homogeneous(vertex)[which]);
  });
}

quoin_code quoin_boundary_plane(const quoin_boundary* boundary, uint32_t face, uint32_t which, char** out,
                                quoin_error* error) {
  return at(boundary, face, &Boundary::face_count, "face", out, error, [&](const Boundary& b) {
    demand_below(which, 4, "which");
    *out = text(b.plane(face)[which]);
  });
}

quoin_code quoin_boundary_model_plane(const quoin_boundary* boundary, uint32_t face, uint32_t which, char** out,
                                      quoin_error* error) {
  return at(boundary, face, &Boundary::face_count, "face", out, error, [&](const Boundary& b) {
    demand_below(which, 4, "which");
    *out = text(b.model_plane(face)[which]);
  });
}

quoin_code quoin_solid_boundary_by_label(const quoin_solid* solid, quoin_boundary** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(solid, "solid");
    *out = new quoin_boundary{solid->value.boundary(quoin::Faces::by_label)};
  });
}

quoin_code quoin_boundary_label(const quoin_boundary* boundary, uint32_t face, quoin_face_label* out,
                                quoin_error* error) {
  return at(boundary, face, &Boundary::face_count, "face", out, error,
            [&](const Boundary& b) { *out = face_label(b.label(face)); });
}

quoin_code quoin_boundary_original(const quoin_boundary* boundary, uint32_t original, uint32_t* id, const char** name,
                                   quoin_error* error) {
  if (name) *name = nullptr;
  return guarded(id, error, [&] {
    demand(boundary, "boundary");
    give_original(boundary->value.originals(), original, id, name);
  });
}

quoin_code quoin_boundary_face_area(const quoin_boundary* boundary, uint32_t face, double* out, quoin_error* error) {
  return at(boundary, face, &Boundary::face_count, "face", out, error, [&](const Boundary& b) { *out = b.area(face); });
}

quoin_code quoin_boundary_face(const quoin_boundary* boundary, uint32_t face, quoin_face* out, quoin_error* error) {
  return filled(boundary, face, &Boundary::face_count, "face", out, error, [&](const Boundary& b) {
    const Boundary::Face f = b.face(face);
    return quoin_face{0,
                      f.loop_count(),
                      static_cast<std::uint32_t>(f.vertices.size()),
                      b.shell_of(face),
                      f.first_corner(),
                      f.starts.data(),
                      f.vertices.data()};
  });
}

quoin_code quoin_boundary_corner(const quoin_boundary* boundary, uint32_t corner, quoin_corner* out,
                                 quoin_error* error) {
  return filled(boundary, corner, &Boundary::corner_count, "corner", out, error, [&](const Boundary& b) {
    return quoin_corner{0,
                        b.vertex_of(corner),
                        b.face_of(corner),
                        b.next(corner),
                        b.previous(corner),
                        b.edge_of(corner).value_or(QUOIN_NONE),
                        b.opposite(corner).value_or(QUOIN_NONE)};
  });
}

quoin_code quoin_boundary_edge(const quoin_boundary* boundary, uint32_t edge, uint32_t vertices[2], uint32_t* fan,
                               quoin_error* error) {
  return at(boundary, edge, &Boundary::edge_count, "edge", fan, error, [&](const Boundary& b) {
    demand(vertices, "vertices");
    const Boundary::Edge e = b.edge(edge);
    vertices[0] = e.vertices[0];
    vertices[1] = e.vertices[1];
    *fan = static_cast<std::uint32_t>(e.fan.size());
  });
}

quoin_code quoin_boundary_fan(const quoin_boundary* boundary, uint32_t edge, uint32_t place, uint32_t* corner,
                              int* forward, quoin_error* error) {
  return at(boundary, edge, &Boundary::edge_count, "edge", corner, error, [&](const Boundary& b) {
    const Boundary::Edge e = b.edge(edge);
    demand_below(place, e.fan.size(), "place");
    *corner = e.fan[place].corner;
    if (forward) *forward = e.fan[place].forward;
  });
}

quoin_code quoin_boundary_shell(const quoin_boundary* boundary, uint32_t shell, quoin_shell* out, quoin_error* error) {
  return filled(boundary, shell, &Boundary::shell_count, "shell", out, error, [&](const Boundary& b) {
    const auto faces = b.shell_faces(shell);
    return quoin_shell{0,
                       b.shell_genus(shell),
                       b.is_void(shell),
                       b.parent(shell).value_or(QUOIN_NONE),
                       b.component_of(shell),
                       static_cast<std::uint32_t>(faces.size()),
                       faces.data()};
  });
}

quoin_code quoin_boundary_shell_volume(const quoin_boundary* boundary, uint32_t shell, char** out, quoin_error* error) {
  return at(boundary, shell, &Boundary::shell_count, "shell", out, error,
            [&](const Boundary& b) { *out = text(b.shell_volume(shell)); });
}

quoin_code quoin_boundary_component(const quoin_boundary* boundary, uint32_t component, quoin_solid** out,
                                    quoin_error* error) {
  return at(boundary, component, &Boundary::component_count, "component", out, error,
            [&](const Boundary& b) { *out = new quoin_solid{b.component(component)}; });
}

quoin_code quoin_solid_from_boundary(const quoin_exact_polygons* polygons, quoin_trust trust, quoin_solid** out,
                                     quoin_error* error) {
  return guarded(out, error, [&] {
    demand(polygons, "polygons");
    const quoin_exact_polygons given = taken(polygons, "polygons");
    quoin::ExactPolygons own;
    own.grid = grid_or_default(given.grid);
    own.full_at_infinity = given.full_at_infinity != 0;
    own.points = records(given.points, given.point_count, "polygons.points");
    own.planes = records(given.planes, given.face_count, "polygons.planes");
    own.face_starts = index_list(given.face_starts, "polygons.face_starts");
    own.loop_starts = index_list(given.loop_starts, "polygons.loop_starts");
    own.corners = index_list(given.corners, "polygons.corners");
    *out = new quoin_solid{quoin::Solid::from_boundary(own, enumerator<quoin::Trust>(trust, 2, "trust")).value()};
  });
}
