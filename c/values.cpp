// Versions, codes, text, cancelling, grids.
#include <cstdlib>

#include "c/handles.h"

using namespace quoin::c;

uint32_t quoin_c_version(void) { return QUOIN_C_VERSION; }
const char* quoin_version(void) { return QUOIN_VERSION_STRING; }
const char* quoin_commit(void) { return quoin::commit(); }
int quoin_format_version(void) { return quoin::format_version(); }

const char* quoin_code_name(quoin_code code) {
  switch (code) {
    case QUOIN_OK:
      return "ok";
    case QUOIN_MISSING_FILE:
      return "missing-file";
    case QUOIN_UNREADABLE:
      return "unreadable";
    case QUOIN_UNKNOWN_FORMAT:
      return "unknown-format";
    case QUOIN_TRUNCATED:
      return "truncated";
    case QUOIN_BAD_SYNTAX:
      return "bad-syntax";
    case QUOIN_BAD_NUMBER:
      return "bad-number";
    case QUOIN_NON_FINITE:
      return "non-finite";
    case QUOIN_BAD_INDEX:
      return "bad-index";
    case QUOIN_ABSURD_COUNT:
      return "absurd-count";
    case QUOIN_NO_FACES:
      return "no-faces";
    case QUOIN_BAD_QUOIN:
      return "bad-quoin";
    case QUOIN_UNWRITABLE:
      return "unwritable";
    case QUOIN_TOO_LARGE:
      return "too-large";
    case QUOIN_OPEN_BOUNDARY:
      return "open-boundary";
    case QUOIN_INSIDE_OUT:
      return "inside-out";
    case QUOIN_OUT_OF_RANGE:
      return "out-of-range";
    case QUOIN_INEXACT_GRID:
      return "inexact-grid";
    case QUOIN_MIXED_UNITS:
      return "mixed-units";
    case QUOIN_BAD_PLANE:
      return "bad-plane";
    case QUOIN_NO_OPERAND:
      return "no-operand";
    case QUOIN_TOO_MANY_TERMS:
      return "too-many-terms";
    case QUOIN_UNBOUNDED:
      return "unbounded";
    case QUOIN_INCONSISTENT:
      return "inconsistent";
    case QUOIN_CANCELLED:
      return "cancelled";
    case QUOIN_BAD_MODEL:
      return "bad-model";
    case QUOIN_BAD_PARAMETER:
      return "bad-parameter";
    case QUOIN_BAD_PRIMITIVE:
      return "bad-primitive";
    case QUOIN_BAD_AXIS:
      return "bad-axis";
    case QUOIN_BAD_FACTOR:
      return "bad-factor";
    case QUOIN_NOT_A_ROTATION:
      return "not-a-rotation";
    case QUOIN_INCONSISTENT_MOTION:
      return "inconsistent-motion";
    case QUOIN_USAGE:
      return "usage";
    case QUOIN_OUT_OF_MEMORY:
      return "out-of-memory";
    case QUOIN_INTERNAL_DEFECT:
      return "internal-defect";
    case QUOIN_BAD_ARGUMENT:
      return "bad-argument";
  }
  return "unknown";
}

void quoin_text_free(char* text) { std::free(text); }

void quoin_grid_free(quoin_grid* grid) { delete grid; }
void quoin_solid_free(quoin_solid* solid) { delete solid; }
void quoin_mesh_free(quoin_mesh* mesh) { delete mesh; }
void quoin_boundary_free(quoin_boundary* boundary) { delete boundary; }
void quoin_motion_free(quoin_motion* motion) { delete motion; }
void quoin_model_free(quoin_model* model) { delete model; }
void quoin_cancel_free(quoin_cancel* cancel) { delete cancel; }

quoin_code quoin_cancel_new(quoin_cancel** out, quoin_error* error) {
  return guarded(out, error, [&] { *out = new quoin_cancel; });
}
void quoin_cancel_request(quoin_cancel* cancel) {
  if (cancel) cancel->value = true;
}
void quoin_cancel_reset(quoin_cancel* cancel) {
  if (cancel) cancel->value = false;
}

quoin_code quoin_grid_new(quoin_grid** out, quoin_error* error) {
  return guarded(out, error, [&] { *out = new quoin_grid; });
}

quoin_code quoin_grid_with_step(const char* step, const char* const origin[3], quoin_grid** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(step, "step");
    const auto grid =
        origin ? quoin::Grid::with_step_and_origin(step, texts<3>(origin, "origin")) : quoin::Grid::with_step(step);
    *out = new quoin_grid{grid.value()};
  });
}

quoin_code quoin_grid_fitting(const double low[3], const double high[3], quoin_grid** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(low, "low");
    demand(high, "high");
    *out = new quoin_grid{quoin::Grid::fitting({low[0], low[1], low[2]}, {high[0], high[1], high[2]}).value()};
  });
}

quoin_code quoin_grid_step(const quoin_grid* grid, char** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(grid, "grid");
    *out = text(grid->value.step());
  });
}

quoin_code quoin_grid_origin(const quoin_grid* grid, uint32_t axis, char** out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(grid, "grid");
    demand_below(axis, 3, "axis");
    *out = text(grid->value.origin()[axis]);
  });
}

quoin_code quoin_grid_equal(const quoin_grid* a, const quoin_grid* b, int* out, quoin_error* error) {
  return guarded(out, error, [&] {
    demand(a, "a");
    demand(b, "b");
    *out = a->value == b->value;
  });
}
