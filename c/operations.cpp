// Booleans, motions, models.
#include <string>

#include "c/handles.h"

using namespace quoin::c;

namespace {

/// operation(run, report), reported.
template <class Operation>
quoin::Solid operated(const quoin_options* options, quoin_operation_report* report, Operation&& operation) {
  demand_size(report, "report");
  const Running run(options);
  quoin::OperationReport said;
  auto solid = operation(run.options(), &said);
  give(said, report);
  return std::move(solid).value();
}

using OfMany = quoin::Result<quoin::Solid> (*)(const std::vector<quoin::Solid>&, const quoin::Options&,
                                               quoin::OperationReport*);

quoin_code of_many(OfMany operation, const quoin_solid* const* given, std::size_t count, const quoin_options* options,
                   quoin_operation_report* report, quoin_solid** out, quoin_error* error) {
  return guarded(out, error, [&] {
    const std::vector<quoin::Solid> operands = solids(given, count, "solids");
    *out = new quoin_solid{operated(options, report, [&](const quoin::Options& run, quoin::OperationReport* said) {
      return operation(operands, run, said);
    })};
  });
}

/// A motion that make() gives or refuses.
template <class Make>
quoin_code motion_of(quoin_motion** out, quoin_error* error, Make&& make) {
  return guarded(out, error, [&] { *out = new quoin_motion{make().value()}; });
}

quoin::Rounding rounding_of(quoin_rounding rounding, const char* where) {
  return enumerator<quoin::Rounding>(rounding, 6, where);
}

}  // namespace

quoin_code quoin_unite(const quoin_solid* const* solids, size_t count, const quoin_options* options,
                       quoin_operation_report* report, quoin_solid** out, quoin_error* error) {
  return of_many(quoin::unite, solids, count, options, report, out, error);
}

quoin_code quoin_intersect(const quoin_solid* const* solids, size_t count, const quoin_options* options,
                           quoin_operation_report* report, quoin_solid** out, quoin_error* error) {
  return of_many(quoin::intersect, solids, count, options, report, out, error);
}

quoin_code quoin_symmetric_difference(const quoin_solid* const* solids, size_t count, const quoin_options* options,
                                      quoin_operation_report* report, quoin_solid** out, quoin_error* error) {
  return of_many(quoin::symmetric_difference, solids, count, options, report, out, error);
}

quoin_code quoin_difference(const quoin_solid* minuend, const quoin_solid* const* subtrahends, size_t count,
                            const quoin_options* options, quoin_operation_report* report, quoin_solid** out,
                            quoin_error* error) {
  return guarded(out, error, [&] {
    demand(minuend, "minuend");
    const std::vector<quoin::Solid> others = solids(subtrahends, count, "subtrahends");
    *out = new quoin_solid{operated(options, report, [&](const quoin::Options& run, quoin::OperationReport* said) {
      return quoin::difference(minuend->value, others, run, said);
    })};
  });
}

quoin_code quoin_complement(const quoin_solid* solid, quoin_solid** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(solid, "solid");
    *out = new quoin_solid{quoin::complement(solid->value)};
  });
}

quoin_code quoin_split(const quoin_solid* solid, const char* const plane[4], const quoin_options* options,
                       quoin_operation_report* report, quoin_solid** above, quoin_solid** below, quoin_error* error) {
  if (below) *below = nullptr;
  return guarded(above, error, [&] {
    demand(below, "below");
    demand(solid, "solid");
    demand_size(report, "report");
    const Running run(options);
    quoin::OperationReport said;
    auto parts = quoin::split(solid->value, {texts<4>(plane, "plane")}, run.options(), &said);
    give(said, report);

    auto upper = std::make_unique<quoin_solid>(quoin_solid{std::move(parts.value()[0])});
    *below = new quoin_solid{std::move(parts.value()[1])};
    *above = upper.release();
  });
}

quoin_code quoin_motion_new(quoin_motion** out, quoin_error* error) {
  return guarded(out, error, [&] { *out = new quoin_motion; });
}

quoin_code quoin_motion_rotation(const char* const axis[3], const char* degrees, quoin_motion** out,
                                 quoin_error* error) {
  return motion_of(out, error, [&] {
    demand(degrees, "degrees");
    return quoin::Motion::rotation(texts<3>(axis, "axis"), degrees);
  });
}

quoin_code quoin_motion_translation(const char* const by[3], quoin_motion** out, quoin_error* error) {
  return motion_of(out, error, [&] { return quoin::Motion::translation(texts<3>(by, "by")); });
}

quoin_code quoin_motion_quaternion(const char* const wxyz[4], quoin_motion** out, quoin_error* error) {
  return motion_of(out, error, [&] { return quoin::Motion::quaternion(texts<4>(wxyz, "wxyz")); });
}

quoin_code quoin_motion_matrix(const char* const rows[9], double* deviation, quoin_motion** out, quoin_error* error) {
  return motion_of(out, error, [&] {
    const auto entries = texts<9>(rows, "rows");
    std::array<quoin::Text3, 3> matrix;
    for (std::size_t i = 0; i < 9; ++i) matrix[i / 3][i % 3] = entries[i];
    return quoin::Motion::matrix(matrix, deviation);
  });
}

quoin_code quoin_motion_mirror(const char* const normal[3], quoin_motion** out, quoin_error* error) {
  return motion_of(out, error, [&] { return quoin::Motion::mirror(texts<3>(normal, "normal")); });
}

quoin_code quoin_motion_scaling(const char* const by[3], quoin_motion** out, quoin_error* error) {
  return motion_of(out, error, [&] { return quoin::Motion::scaling(texts<3>(by, "by")); });
}

quoin_code quoin_motion_then(const quoin_motion* first, const quoin_motion* second, quoin_motion** out,
                             quoin_error* error) {
  return guarded(out, error, [&] {
    demand(first, "first");
    demand(second, "second");
    *out = new quoin_motion{first->value.then(second->value)};
  });
}

quoin_code quoin_motion_inverse(const quoin_motion* motion, quoin_motion** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(motion, "motion");
    *out = new quoin_motion{motion->value.inverse()};
  });
}

quoin_code quoin_motion_equal(const quoin_motion* a, const quoin_motion* b, int* out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(a, "a");
    demand(b, "b");
    *out = a->value == b->value;
  });
}

quoin_code quoin_motion_entry(const quoin_motion* motion, uint32_t row, uint32_t column, char** out,
                              quoin_error* error) {
  return guarded(out, error, [&] {
    demand(motion, "motion");
    demand_below(row, 3, "row");
    demand_below(column, 4, "column");
    const quoin::MotionInfo info = motion->value.info();
    *out = text(column < 3 ? info.linear[row][column] : info.shift[row]);
  });
}

quoin_code quoin_moved(const quoin_solid* solid, const quoin_motion* motion, quoin_rounding rounding,
                       const quoin_options* options, quoin_motion_report* report, quoin_solid** out,
                       quoin_error* error) {
  return guarded(out, error, [&] {
    demand(solid, "solid");
    demand(motion, "motion");
    demand_size(report, "report");
    const Running run(options);
    quoin::MotionReport said;
    auto result = quoin::moved(solid->value, motion->value,
                               {.rounding = rounding_of(rounding, "rounding"), .run = run.options()}, &said);
    give(said, report);
    *out = new quoin_solid{std::move(result).value()};
  });
}

quoin_code quoin_model_from_json(const char* text, size_t length, const char* folder, quoin_model** out,
                                 quoin_error* error) {
  return guarded(out, error, [&] {
    demand(text, "text");
    *out = new quoin_model{quoin::Model::from_json({text, length}, folder ? folder : ".").value()};
  });
}

quoin_code quoin_model_read(const char* path, quoin_model** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(path, "path");
    *out = new quoin_model{quoin::Model::read(path).value()};
  });
}

quoin_code quoin_model_to_json(const quoin_model* model, char** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(model, "model");
    *out = text(model->value.to_json());
  });
}

quoin_code quoin_evaluate(const quoin_model* model, const quoin_model_options* options, quoin_motion_report* report,
                          quoin_solid** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(model, "model");
    demand_size(report, "report");
    const quoin_model_options given = taken(options, "options");
    const Running run(given.run);

    quoin::ModelOptions own;
    if (given.grid) own.grid = given.grid->value;
    own.rounding = rounding_of(given.rounding, "options.rounding");
    own.run = run.options();
    for (std::size_t i = 0; i < given.parameters; ++i) {
      demand(given.names != nullptr && given.names[i] != nullptr, "the argument is NULL", "options.names");
      demand(given.values != nullptr && given.values[i] != nullptr, "the argument is NULL", "options.values");
      own.parameters[given.names[i]] = given.values[i];
    }

    quoin::MotionReport said;
    auto solid = quoin::evaluate(model->value, own, &said);
    give(said, report);
    *out = new quoin_solid{std::move(solid).value()};
  });
}
