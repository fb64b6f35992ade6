// Solids: from arrays, text and files, what they answer, and triangles.
#include <cmath>
#include <string>

#include <memory>

#include "c/handles.h"

using namespace quoin::c;

quoin_code quoin_solid_from_triangles(quoin_array points, quoin_array triangles, const quoin_import_options* options,
                                      quoin_import_report* report, quoin_solid** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand_size(report, "report");
    const Importing import(options);
    std::vector<std::uint32_t> room;
    quoin::ImportReport said;
    auto solid = quoin::Solid::from_triangles(coordinates(points, "points"), indices(triangles, room, "triangles"),
                                              import.options(), &said);
    give(said, report);
    *out = new quoin_solid{std::move(solid).value()};
  });
}

quoin_code quoin_solid_from_polygons(quoin_array points, quoin_array starts, quoin_array corners,
                                     const quoin_import_options* options, quoin_import_report* report,
                                     quoin_solid** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand_size(report, "report");
    const Importing import(options);
    std::vector<std::uint32_t> starts_room, corners_room;
    quoin::ImportReport said;
    auto solid = quoin::Solid::from_polygons(coordinates(points, "points"), indices(starts, starts_room, "starts"),
                                             indices(corners, corners_room, "corners"), import.options(), &said);
    give(said, report);
    *out = new quoin_solid{std::move(solid).value()};
  });
}

quoin_code quoin_solid_from_quoin(const char* text, size_t length, quoin_trust trust, quoin_solid** out,
                                  quoin_error* error) {
  return guarded(out, error, [&] {
    demand(text, "text");
    *out =
        new quoin_solid{quoin::Solid::from_quoin({text, length}, enumerator<quoin::Trust>(trust, 2, "trust")).value()};
  });
}

quoin_code quoin_solid_to_quoin(const quoin_solid* solid, char** out, size_t* length, quoin_error* error) {
  if (length) *length = 0;
  return guarded(out, error, [&] {
    demand(solid, "solid");
    const std::string written = solid->value.to_quoin();
    *out = text(written);
    if (length) *length = written.size();
  });
}

quoin_code quoin_solid_read(const char* path, const quoin_import_options* options, quoin_import_report* report,
                            quoin_solid** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(path, "path");
    demand_size(report, "report");
    const Importing import(options);
    quoin::ImportReport said;
    auto solid = quoin::read_solid(path, import.options(), &said);
    give(said, report);
    *out = new quoin_solid{std::move(solid).value()};
  });
}

quoin_code quoin_solid_write(const quoin_solid* solid, const char* path, const quoin_export_options* options,
                             quoin_error* error) {
  return guarded(error, [&] {
    demand(solid, "solid");
    demand(path, "path");
    const Exporting exporting(options);
    solid->value.write(path, exporting.options()).value();
  });
}

quoin_code quoin_solid_empty(const quoin_grid* grid, quoin_solid** out, quoin_error* error) {
  return guarded(out, error, [&] { *out = new quoin_solid{quoin::Solid::empty(grid_or_default(grid))}; });
}

quoin_code quoin_solid_full(const quoin_grid* grid, quoin_solid** out, quoin_error* error) {
  return guarded(out, error, [&] { *out = new quoin_solid{quoin::Solid::full(grid_or_default(grid))}; });
}

quoin_code quoin_solid_copy(const quoin_solid* solid, quoin_solid** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(solid, "solid");
    *out = new quoin_solid{solid->value};
  });
}

quoin_code quoin_solid_grid(const quoin_solid* solid, quoin_grid** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(solid, "solid");
    *out = new quoin_grid{solid->value.grid()};
  });
}

quoin_code quoin_solid_on_grid(const quoin_solid* solid, const quoin_grid* grid, quoin_solid** out,
                               quoin_error* error) {
  return guarded(out, error, [&] {
    demand(solid, "solid");
    demand(grid, "grid");
    *out = new quoin_solid{solid->value.on_grid(grid->value).value()};
  });
}

quoin_code quoin_solid_is_empty(const quoin_solid* solid, int* out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(solid, "solid");
    *out = solid->value.is_empty();
  });
}

quoin_code quoin_solid_is_bounded(const quoin_solid* solid, int* out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(solid, "solid");
    *out = solid->value.is_bounded();
  });
}

quoin_code quoin_solid_equal(const quoin_solid* a, const quoin_solid* b, int* out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(a, "a");
    demand(b, "b");
    *out = a->value == b->value;
  });
}

quoin_code quoin_solid_classify(const quoin_solid* solid, const double point[3], quoin_location* out,
                                quoin_error* error) {
  return guarded(out, error, [&] {
    demand(solid, "solid");
    demand(point, "point");
    for (int k = 0; k < 3; ++k)
      if (!std::isfinite(point[k]))
        throw quoin::Exception({quoin::ErrorCode::non_finite, "a coordinate is not finite", {}, "point"});
    *out = static_cast<quoin_location>(solid->value.classify({point[0], point[1], point[2]}));
  });
}
static_assert(static_cast<int>(quoin::Location::outside) == QUOIN_OUTSIDE);

quoin_code quoin_solid_volume(const quoin_solid* solid, char** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(solid, "solid");
    const auto volume = solid->value.volume();
    if (!volume) throw quoin::Exception({quoin::ErrorCode::unbounded, "the solid is unbounded", {}, {}});
    *out = text(*volume);
  });
}

quoin_code quoin_solid_counts(const quoin_solid* solid, struct quoin_counts* out, quoin_error* error) {
  return guarded(error, [&] {
    demand(out, "out");
    demand_size(out, "out");
    demand(solid, "solid");
    const quoin::Counts counts = solid->value.counts();
    give({0, counts.vertices, counts.edges, counts.faces}, out);
  });
}

quoin_code quoin_solid_info(const quoin_solid* solid, const quoin_options* options, struct quoin_info* out,
                            quoin_error* error) {
  return guarded(error, [&] {
    demand(out, "out");
    demand_size(out, "out");
    demand(solid, "solid");
    const Running run(options);
    const quoin::Info info = solid->value.info(run.options(), nullptr, quoin::Volume::rounded);
    const quoin::Box box = info.box.value_or(quoin::Box{});
    give({0,
          info.vertices,
          info.edges,
          info.faces,
          info.triangles,
          info.shells,
          info.genus,
          info.closed,
          info.manifold,
          info.bounded,
          info.box.has_value(),
          info.volume_approx,
          info.area_approx,
          {box[0][0], box[0][1], box[0][2]},
          {box[1][0], box[1][1], box[1][2]}},
         out);
  });
}

quoin_code quoin_solid_box(const quoin_solid* solid, int* has_box, double low[3], double high[3], quoin_error* error) {
  return guarded(has_box, error, [&] {
    demand(solid, "solid");
    demand(low, "low");
    demand(high, "high");
    const auto box = solid->value.box();
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = box ? (*box)[0][k] : 0;
      high[k] = box ? (*box)[1][k] : 0;
    }
    *has_box = box.has_value();
  });
}

quoin_code quoin_solid_area(const quoin_solid* solid, double* out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(solid, "solid");
    *out = solid->value.area();
  });
}

quoin_code quoin_solid_to_triangles(const quoin_solid* solid, const quoin_export_options* options,
                                    quoin_export_report* report, quoin_mesh** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(solid, "solid");
    demand_size(report, "report");
    const Exporting exporting(options);
    quoin::ExportReport said;
    auto mesh = std::make_unique<quoin_mesh>();
    if (exporting.wants_labels())
      mesh->value = to_labelled_triangles(solid->value, exporting.options(), &said).value();
    else
      static_cast<quoin::Mesh&>(mesh->value) = solid->value.to_triangles(exporting.options(), &said).value();
    give(said, report);

    const auto& points = mesh->value.points;
    if (exporting.options().float32) mesh->float32.assign(points.begin(), points.end());
    for (const quoin::FaceLabel& l : mesh->value.labels) mesh->labels.push_back(face_label(l));
    *out = mesh.release();
  });
}

size_t quoin_mesh_point_count(const quoin_mesh* mesh) { return mesh ? mesh->value.points.size() / 3 : 0; }
size_t quoin_mesh_triangle_count(const quoin_mesh* mesh) { return mesh ? mesh->value.triangles.size() / 3 : 0; }
const double* quoin_mesh_points(const quoin_mesh* mesh) { return mesh ? mesh->value.points.data() : nullptr; }
const float* quoin_mesh_points_float32(const quoin_mesh* mesh) {
  return mesh && !mesh->float32.empty() ? mesh->float32.data() : nullptr;
}
const uint32_t* quoin_mesh_triangles(const quoin_mesh* mesh) { return mesh ? mesh->value.triangles.data() : nullptr; }

const quoin_face_label* quoin_mesh_labels(const quoin_mesh* mesh) {
  return mesh && !mesh->labels.empty() ? mesh->labels.data() : nullptr;
}
size_t quoin_mesh_original_count(const quoin_mesh* mesh) { return mesh ? mesh->value.originals.size() : 0; }

quoin_code quoin_mesh_original(const quoin_mesh* mesh, uint32_t original, uint32_t* id, const char** name,
                               quoin_error* error) {
  if (name) *name = nullptr;
  return guarded(id, error, [&] {
    demand(mesh, "mesh");
    give_original(mesh->value.originals, original, id, name);
  });
}

size_t quoin_mesh_channel_count(const quoin_mesh* mesh) { return mesh ? mesh->value.channel_count : 0; }
const double* quoin_mesh_channels(const quoin_mesh* mesh) {
  return mesh && !mesh->value.channels.empty() ? mesh->value.channels.data() : nullptr;
}

quoin_code quoin_solid_labelled(const quoin_solid* solid, uint32_t id, const char* name, quoin_array labels,
                                quoin_solid** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(solid, "solid");
    std::vector<std::uint32_t> room;
    const quoin::Indices list = labels.count > 0 ? indices(labels, room, "labels") : quoin::Indices();
    *out = new quoin_solid{labelled(solid->value, {id, name ? name : ""}, list).value()};
  });
}

quoin_code quoin_solid_unlabelled(const quoin_solid* solid, quoin_solid** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(solid, "solid");
    *out = new quoin_solid{unlabelled(solid->value)};
  });
}

quoin_code quoin_solid_has_labels(const quoin_solid* solid, int* out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(solid, "solid");
    *out = has_labels(solid->value) ? 1 : 0;
  });
}

quoin_code quoin_same_faces(const quoin_solid* a, const quoin_solid* b, int* out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(a, "a");
    demand(b, "b");
    *out = same_faces(a->value, b->value) ? 1 : 0;
  });
}
