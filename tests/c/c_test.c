/* The functions for C, called from C. Without arguments: all tests. "memory": a course of work that may run out of it.
 */
#include <math.h>
#include <quoin/quoin_c.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

#define CHECK(condition)                                              \
  do {                                                                \
    if (!(condition)) {                                               \
      fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
      ++failures;                                                     \
    }                                                                 \
  } while (0)

/* The call succeeds, or says why not. */
#define DONE(call)                                                                                               \
  do {                                                                                                           \
    const quoin_code code_ = (call);                                                                             \
    if (code_ != QUOIN_OK) {                                                                                     \
      fprintf(stderr, "%s:%d: %s: %s %s %s\n", __FILE__, __LINE__, #call, quoin_code_name(code_), error.message, \
              error.where);                                                                                      \
      ++failures;                                                                                                \
    }                                                                                                            \
  } while (0)

/* The call fails with this code, at this place. */
#define REFUSED(call, expected, place)                                                                           \
  do {                                                                                                           \
    const quoin_code code_ = (call);                                                                             \
    if (code_ != (expected) || error.code != (expected) || strcmp(error.where, (place)) != 0 ||                  \
        error.message[0] == '\0') {                                                                              \
      fprintf(stderr, "%s:%d: %s: %s, %s, %s\n", __FILE__, __LINE__, #call, quoin_code_name(code_), error.where, \
              error.message);                                                                                    \
      ++failures;                                                                                                \
    }                                                                                                            \
  } while (0)

static quoin_error error;

static quoin_array doubles(const double* data, size_t count) {
  const quoin_array array = {data, count, QUOIN_FLOAT64};
  return array;
}

static const uint32_t box_triangles[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                           2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};

static void box_points(double low, double high, double points[24]) {
  for (int i = 0; i < 24; ++i) points[i] = (i / 3) >> (i % 3) & 1 ? high : low;
}

/* [low, high]^3 on the grid of step 1/4. */
static quoin_solid* cube(double low, double high) {
  double points[24];
  const quoin_array triangles = {box_triangles, 36, QUOIN_UINT32};
  quoin_grid* grid = NULL;
  quoin_solid* solid = NULL;
  quoin_import_options options = QUOIN_INIT(quoin_import_options);
  box_points(low, high, points);
  DONE(quoin_grid_with_step("1/4", NULL, &grid, &error));
  options.grid = grid;
  DONE(quoin_solid_from_triangles(doubles(points, 24), triangles, &options, NULL, &solid, &error));
  quoin_grid_free(grid);
  return solid;
}

static int has_volume(const quoin_solid* solid, const char* expected) {
  char* volume = NULL;
  DONE(quoin_solid_volume(solid, &volume, &error));
  const int equal = volume != NULL && strcmp(volume, expected) == 0;
  if (!equal) fprintf(stderr, "volume %s, expected %s\n", volume ? volume : "none", expected);
  quoin_text_free(volume);
  return equal;
}

static int same(const quoin_solid* a, const quoin_solid* b) {
  int equal = 0;
  DONE(quoin_solid_equal(a, b, &equal, &error));
  return equal;
}

static int text_is(char* text, const char* expected) {
  const int equal = text != NULL && strcmp(text, expected) == 0;
  if (!equal) fprintf(stderr, "\"%s\", expected \"%s\"\n", text ? text : "", expected);
  quoin_text_free(text);
  return equal;
}

static void test_versions(void) {
  CHECK(quoin_c_version() == QUOIN_C_VERSION);
  CHECK(strlen(quoin_version()) >= 5 && strlen(quoin_commit()) > 0 && quoin_format_version() >= 1);
  CHECK(strcmp(quoin_code_name(QUOIN_OK), "ok") == 0);
  CHECK(strcmp(quoin_code_name(QUOIN_OPEN_BOUNDARY), "open-boundary") == 0);
  CHECK(strcmp(quoin_code_name(QUOIN_BAD_ARGUMENT), "bad-argument") == 0);
  CHECK(strcmp(quoin_code_name((quoin_code)999), "unknown") == 0);
}

static void test_grids(void) {
  const char* const origin[3] = {"1/3", "-2", "0"};
  const double low[3] = {0, 0, 0}, high[3] = {1, 2, 3};
  quoin_grid *a = NULL, *b = NULL, *c = NULL;
  char* text = NULL;
  int equal = 2;
  DONE(quoin_grid_with_step("0.25", origin, &a, &error));
  DONE(quoin_grid_step(a, &text, &error));
  CHECK(text_is(text, "1/4"));
  DONE(quoin_grid_origin(a, 0, &text, &error));
  CHECK(text_is(text, "1/3"));
  DONE(quoin_grid_new(&b, &error));
  DONE(quoin_grid_equal(a, b, &equal, &error));
  CHECK(equal == 0);
  DONE(quoin_grid_equal(a, a, &equal, &error));
  CHECK(equal == 1);
  DONE(quoin_grid_fitting(low, high, &c, &error));
  DONE(quoin_grid_step(c, &text, &error));
  CHECK(text_is(text, "1/16777216"));
  REFUSED(quoin_grid_origin(a, 3, &text, &error), QUOIN_BAD_ARGUMENT, "axis");
  CHECK(text == NULL);
  quoin_grid_free(a);
  quoin_grid_free(b);
  REFUSED(quoin_grid_with_step("0", NULL, &a, &error), QUOIN_BAD_NUMBER, "step");
  CHECK(a == NULL);
  REFUSED(quoin_grid_with_step(NULL, NULL, &a, &error), QUOIN_BAD_ARGUMENT, "step");
  quoin_grid_free(c);
}

/* All types of numbers give one solid. */
static void test_arrays(void) {
  double points[24];
  float floats[24];
  int32_t whole[36];
  uint64_t longs[36];
  uint32_t starts[13];
  quoin_solid *expected = cube(0, 3), *solid = NULL;
  quoin_import_report report = QUOIN_INIT(quoin_import_report);
  box_points(0, 3, points);
  for (int i = 0; i < 24; ++i) floats[i] = (float)points[i];
  for (int i = 0; i < 36; ++i) longs[i] = (uint64_t)(whole[i] = (int32_t)box_triangles[i]);
  for (uint32_t i = 0; i < 13; ++i) starts[i] = 3 * i;

  const quoin_array coordinates[2] = {{points, 24, QUOIN_FLOAT64}, {floats, 24, QUOIN_FLOAT32}};
  const quoin_array indices[3] = {
      {box_triangles, 36, QUOIN_UINT32}, {whole, 36, QUOIN_INT32}, {longs, 36, QUOIN_UINT64}};
  const quoin_array polygon_starts = {starts, 13, QUOIN_UINT32};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 3; ++j) {
      DONE(quoin_solid_from_triangles(coordinates[i], indices[j], NULL, &report, &solid, &error));
      CHECK(same(solid, expected));
      quoin_solid_free(solid);
      DONE(quoin_solid_from_polygons(coordinates[i], polygon_starts, indices[j], NULL, &report, &solid, &error));
      CHECK(same(solid, expected));
      quoin_solid_free(solid);
    }
  CHECK(report.size == sizeof report && report.max_snap == 0 && report.resolved_crossings == 0);

  REFUSED(quoin_solid_from_triangles(indices[0], indices[0], NULL, NULL, &solid, &error), QUOIN_BAD_ARGUMENT, "points");
  CHECK(solid == NULL);
  REFUSED(quoin_solid_from_triangles(coordinates[0], coordinates[0], NULL, NULL, &solid, &error), QUOIN_BAD_ARGUMENT,
          "triangles");
  const quoin_array nothing = {NULL, 3, QUOIN_UINT32};
  REFUSED(quoin_solid_from_triangles(coordinates[0], nothing, NULL, NULL, &solid, &error), QUOIN_BAD_ARGUMENT,
          "triangles");
  longs[4] = UINT64_C(1) << 40;
  REFUSED(quoin_solid_from_triangles(coordinates[0], indices[2], NULL, NULL, &solid, &error), QUOIN_BAD_INDEX,
          "triangles 4");
  whole[4] = -1;
  CHECK(quoin_solid_from_triangles(coordinates[0], indices[1], NULL, NULL, &solid, &error) == QUOIN_BAD_INDEX);
  points[5] = NAN;
  CHECK(quoin_solid_from_triangles(coordinates[0], indices[0], NULL, NULL, &solid, &error) == QUOIN_NON_FINITE);
  const quoin_array open = {box_triangles, 33, QUOIN_UINT32};
  CHECK(quoin_solid_from_triangles(coordinates[1], open, NULL, &report, &solid, &error) == QUOIN_OPEN_BOUNDARY);
  CHECK(error.code == QUOIN_OPEN_BOUNDARY && strlen(error.message) > 10 && report.findings == 1);
  CHECK(quoin_solid_from_triangles(coordinates[1], open, NULL, NULL, &solid, NULL) == QUOIN_OPEN_BOUNDARY);

  quoin_import_options options = QUOIN_INIT(quoin_import_options);
  options.repair = "caps";
  DONE(quoin_solid_from_triangles(coordinates[1], open, &options, &report, &solid, &error));
  CHECK(same(solid, expected) && report.repairs == 1);
  quoin_solid_free(solid);
  options.repair = "magic";
  CHECK(quoin_solid_from_triangles(coordinates[1], open, &options, NULL, &solid, &error) == QUOIN_USAGE);
  options.repair = NULL;
  options.trust = (quoin_trust)2;
  REFUSED(quoin_solid_from_triangles(coordinates[1], indices[0], &options, NULL, &solid, &error), QUOIN_BAD_ARGUMENT,
          "options.trust");
  options.size = 0;
  REFUSED(quoin_solid_from_triangles(coordinates[1], indices[0], &options, NULL, &solid, &error), QUOIN_BAD_ARGUMENT,
          "options");
  report.size = 0;
  REFUSED(quoin_solid_from_triangles(coordinates[1], indices[0], NULL, &report, &solid, &error), QUOIN_BAD_ARGUMENT,
          "report");
  REFUSED(quoin_solid_from_triangles(coordinates[1], indices[0], NULL, NULL, NULL, &error), QUOIN_BAD_ARGUMENT, "out");
  quoin_solid_free(expected);
}

static void test_operations(void) {
  quoin_solid *a = cube(0, 4), *b = cube(1, 5), *c = cube(2, 6), *r = NULL, *s = NULL, *t = NULL;
  const quoin_solid* all[3] = {a, b, c};
  const char* const plane[4] = {"0", "0", "1", "-1"};
  quoin_operation_report report = QUOIN_INIT(quoin_operation_report);
  DONE(quoin_unite(all, 3, NULL, &report, &r, &error));
  CHECK(has_volume(r, "138")); /* 3 * 64 - 2 * 27 - 8 + 8 */
  CHECK(report.max_snap == 0 && report.rounded_operands == 0);
  DONE(quoin_intersect(all, 3, NULL, NULL, &s, &error));
  CHECK(has_volume(s, "8"));
  quoin_solid_free(s);
  DONE(quoin_symmetric_difference(all, 2, NULL, NULL, &s, &error));
  CHECK(has_volume(s, "74"));
  quoin_solid_free(s);
  DONE(quoin_difference(a, all + 1, 2, NULL, NULL, &s, &error));
  CHECK(has_volume(s, "37"));
  quoin_solid_free(s);
  DONE(quoin_difference(a, NULL, 0, NULL, NULL, &s, &error));
  CHECK(same(s, a));
  quoin_solid_free(s);

  DONE(quoin_split(a, plane, NULL, &report, &s, &t, &error));
  CHECK(has_volume(s, "48") && has_volume(t, "16"));
  const quoin_solid* parts[2] = {s, t};
  quoin_solid* whole = NULL;
  DONE(quoin_unite(parts, 2, NULL, NULL, &whole, &error));
  CHECK(same(whole, a));
  quoin_solid_free(whole);
  quoin_solid_free(s);
  quoin_solid_free(t);

  DONE(quoin_complement(a, &s, &error));
  int bounded = 1;
  DONE(quoin_solid_is_bounded(s, &bounded, &error));
  CHECK(bounded == 0);
  char* volume = NULL;
  CHECK(quoin_solid_volume(s, &volume, &error) == QUOIN_UNBOUNDED && volume == NULL);
  DONE(quoin_complement(s, &t, &error));
  CHECK(same(t, a));
  quoin_solid_free(s);
  quoin_solid_free(t);

  CHECK(quoin_unite(NULL, 0, NULL, NULL, &s, &error) == QUOIN_NO_OPERAND);
  all[1] = NULL;
  REFUSED(quoin_unite(all, 3, NULL, NULL, &s, &error), QUOIN_BAD_ARGUMENT, "solids");
  CHECK(s == NULL);
  REFUSED(quoin_unite(NULL, 3, NULL, NULL, &s, &error), QUOIN_BAD_ARGUMENT, "solids");
  REFUSED(quoin_difference(NULL, NULL, 0, NULL, NULL, &s, &error), QUOIN_BAD_ARGUMENT, "minuend");
  REFUSED(quoin_split(a, NULL, NULL, NULL, &s, &t, &error), QUOIN_BAD_ARGUMENT, "plane");
  REFUSED(quoin_split(a, plane, NULL, NULL, &s, NULL, &error), QUOIN_BAD_ARGUMENT, "below");
  const char* const flat[4] = {"0", "0", "0", "1"};
  CHECK(quoin_split(a, flat, NULL, NULL, &s, &t, &error) == QUOIN_BAD_PLANE && s == NULL && t == NULL);
  const char* const holed[4] = {"0", NULL, "0", "1"};
  REFUSED(quoin_split(a, holed, NULL, NULL, &s, &t, &error), QUOIN_BAD_ARGUMENT, "plane");

  quoin_options options = QUOIN_INIT(quoin_options);
  options.grid_rule = (quoin_grid_rule)7;
  all[1] = b;
  REFUSED(quoin_unite(all, 3, &options, NULL, &s, &error), QUOIN_BAD_ARGUMENT, "options.grid_rule");
  quoin_solid_free(a);
  quoin_solid_free(b);
  quoin_solid_free(c);
  quoin_solid_free(r);
}

/* A solid from arrays on a grid of its own. */
static quoin_solid* on_grid(const double* points, const uint32_t* triangles, size_t points_count, size_t corners,
                            const char* step, const char* const origin[3]) {
  const quoin_array indices = {triangles, corners, QUOIN_UINT32};
  quoin_import_options options = QUOIN_INIT(quoin_import_options);
  quoin_import_report report = QUOIN_INIT(quoin_import_report);
  quoin_solid* solid = NULL;
  quoin_grid* grid = NULL;
  DONE(quoin_grid_with_step(step, origin, &grid, &error));
  options.grid = grid;
  DONE(quoin_solid_from_triangles(doubles(points, points_count), indices, &options, &report, &solid, &error));
  CHECK(report.max_snap == 0);
  quoin_grid_free(grid);
  return solid;
}

/* A tetrahedron with long normals, and a box so far away that no grid holds both exactly. */
static void test_reports(void) {
  static const double corners[] = {-536870911, 1,         2,          536870909, -536870912, 7,
                                   12345,      536870911, -536870912, 3,         5,          536870911};
  static const uint32_t outwards[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  static const char* const origin[3] = {"0", "0", "1e11"};
  double points[24];
  box_points(0, 1024, points);
  for (int i = 2; i < 24; i += 3) points[i] += 1e11;
  quoin_solid *fine = on_grid(corners, outwards, 12, 12, "1", NULL), *r = NULL, *above = NULL, *below = NULL;
  quoin_solid* wide = on_grid(points, box_triangles, 24, 36, "1024", origin);
  const quoin_solid* const both[2] = {wide, fine};

  quoin_operation_report report = QUOIN_INIT(quoin_operation_report);
  quoin_options options = QUOIN_INIT(quoin_options);
  DONE(quoin_unite(both, 2, NULL, &report, &r, &error));
  CHECK(report.rounded_operands > 0 && report.max_snap > 0);
  quoin_solid_free(r);
  options.grid_rule = QUOIN_GRID_EXACT;
  REFUSED(quoin_unite(both, 2, &options, &report, &r, &error), QUOIN_INEXACT_GRID, "operand 1");
  CHECK(r == NULL);

  const char* const plane[4] = {"0.1234567890123456789", "0.9876543210987654321", "0.5555555555555555557", "-7"};
  DONE(quoin_split(fine, plane, NULL, &report, &above, &below, &error));
  CHECK(report.rounded_planes == 1 && report.rounded_operands == 0);
  quoin_solid_free(above);
  quoin_solid_free(below);
  quoin_solid_free(fine);
  quoin_solid_free(wide);
}

struct course {
  double last;
  int calls, stages, stop_after;
};
static int on_progress(double done, void* user) {
  struct course* course = user;
  CHECK(done >= course->last && done <= 1);
  course->last = done;
  return ++course->calls == course->stop_after;
}
static void on_stage(const char* name, void* user) {
  CHECK(strlen(name) > 0);
  ++((struct course*)user)->stages;
}

static void test_running(void) {
  quoin_solid *a = cube(0, 4), *b = cube(1, 5), *r = NULL;
  const quoin_solid* both[2] = {a, b};
  struct course course = {0, 0, 0, 0};
  quoin_cancel* cancel = NULL;
  quoin_options options = QUOIN_INIT(quoin_options);
  options.progress = on_progress;
  options.stage = on_stage;
  options.user = &course;
  options.threads = 1;
  DONE(quoin_unite(both, 2, &options, NULL, &r, &error));
  CHECK(course.last == 1 && course.calls > 2 && course.stages > 2);
  quoin_solid_free(r);

  const struct course stopped = {0, 0, 0, 2};
  course = stopped;
  CHECK(quoin_unite(both, 2, &options, NULL, &r, &error) == QUOIN_CANCELLED && r == NULL);
  CHECK(course.calls == 2);

  const struct course free_course = {0, 0, 0, 0};
  course = free_course;
  DONE(quoin_cancel_new(&cancel, &error));
  options.cancel = cancel;
  quoin_cancel_request(cancel);
  CHECK(quoin_unite(both, 2, &options, NULL, &r, &error) == QUOIN_CANCELLED && r == NULL);
  quoin_cancel_reset(cancel);
  course = free_course;
  DONE(quoin_unite(both, 2, &options, NULL, &r, &error));
  quoin_solid_free(r);
  quoin_cancel_request(NULL);
  quoin_cancel_free(cancel);
  quoin_solid_free(a);
  quoin_solid_free(b);
}

static void test_answers(void) {
  quoin_solid *a = cube(0, 4), *b = cube(1, 3), *holed = NULL, *copy = NULL, *nothing = NULL, *everything = NULL;
  const quoin_solid* inner[1] = {b};
  DONE(quoin_difference(a, inner, 1, NULL, NULL, &holed, &error));

  quoin_location where = QUOIN_BOUNDARY;
  const double points[3][3] = {{0.5, 0.5, 0.5}, {1, 2, 2}, {2, 2, 2}};
  for (int i = 0; i < 3; ++i) {
    DONE(quoin_solid_classify(holed, points[i], &where, &error));
    CHECK(where == (quoin_location)i);
  }
  const double nowhere[3] = {0, INFINITY, 0};
  REFUSED(quoin_solid_classify(holed, nowhere, &where, &error), QUOIN_NON_FINITE, "point");

  quoin_info info = QUOIN_INIT(quoin_info);
  DONE(quoin_solid_info(holed, NULL, &info, &error));
  CHECK(info.vertices == 16 && info.edges == 24 && info.faces == 12 && info.shells == 2 && info.genus == 0);
  CHECK(info.closed && info.manifold && info.bounded && info.has_box && info.volume == 56 && info.area == 120);
  CHECK(info.low[0] == 0 && info.high[2] == 4);
  quoin_counts counts = QUOIN_INIT(quoin_counts);
  DONE(quoin_solid_counts(holed, &counts, &error));
  CHECK(counts.vertices == 16 && counts.edges == 24 && counts.faces == 12);
  double area = 0, low[3], high[3];
  int has_box = 0;
  DONE(quoin_solid_area(holed, &area, &error));
  DONE(quoin_solid_box(holed, &has_box, low, high, &error));
  CHECK(area == 120 && has_box && low[1] == 0 && high[1] == 4);

  /* A caller that knows less of a struct gets less. */
  quoin_info less;
  memset(&less, 7, sizeof less);
  less.size = offsetof(quoin_info, edges);
  const uint64_t before = less.edges;
  DONE(quoin_solid_info(holed, NULL, &less, &error));
  CHECK(less.vertices == 16 && less.edges == before && less.size == offsetof(quoin_info, edges));

  DONE(quoin_solid_copy(holed, &copy, &error));
  quoin_solid_free(holed);
  CHECK(has_volume(copy, "56"));
  quoin_grid *grid = NULL, *coarse = NULL;
  char* step = NULL;
  DONE(quoin_solid_grid(copy, &grid, &error));
  DONE(quoin_grid_step(grid, &step, &error));
  CHECK(text_is(step, "1/4"));
  DONE(quoin_grid_with_step("1000000000000000000000/7", NULL, &coarse, &error));
  CHECK(quoin_solid_on_grid(copy, coarse, &holed, &error) == QUOIN_INEXACT_GRID && holed == NULL);
  CHECK(strlen(error.where) > 0);
  quoin_grid_free(coarse);
  DONE(quoin_grid_with_step("1/8", NULL, &coarse, &error));
  DONE(quoin_solid_on_grid(copy, coarse, &holed, &error));
  CHECK(same(copy, holed));

  int empty = 0;
  DONE(quoin_solid_empty(NULL, &nothing, &error));
  DONE(quoin_solid_is_empty(nothing, &empty, &error));
  CHECK(empty == 1);
  DONE(quoin_solid_box(nothing, &has_box, low, high, &error));
  CHECK(!has_box && low[0] == 0 && high[0] == 0);
  DONE(quoin_solid_full(grid, &everything, &error));
  DONE(quoin_solid_is_empty(everything, &empty, &error));
  CHECK(empty == 0);
  REFUSED(quoin_solid_is_empty(NULL, &empty, &error), QUOIN_BAD_ARGUMENT, "solid");
  REFUSED(quoin_solid_info(copy, NULL, NULL, &error), QUOIN_BAD_ARGUMENT, "out");

  quoin_grid_free(grid);
  quoin_grid_free(coarse);
  quoin_solid_free(a);
  quoin_solid_free(b);
  quoin_solid_free(copy);
  quoin_solid_free(holed);
  quoin_solid_free(nothing);
  quoin_solid_free(everything);
}

static void test_text_and_files(void) {
  quoin_solid *a = cube(0, 4), *r = NULL;
  char *text = NULL, *again = NULL;
  size_t length = 0;
  DONE(quoin_solid_to_quoin(a, &text, &length, &error));
  CHECK(length == strlen(text));
  DONE(quoin_solid_from_quoin(text, length, QUOIN_TRUST_NOTHING, &r, &error));
  DONE(quoin_solid_to_quoin(r, &again, NULL, &error));
  CHECK(strcmp(text, again) == 0);
  quoin_solid_free(r);
  CHECK(quoin_solid_from_quoin(text, length - 1, QUOIN_TRUST_NOTHING, &r, &error) == QUOIN_BAD_QUOIN && r == NULL);
  quoin_text_free(text);
  quoin_text_free(again);

  DONE(quoin_solid_write(a, "c_test.stl", NULL, &error));
  quoin_import_report report = QUOIN_INIT(quoin_import_report);
  DONE(quoin_solid_read("c_test.stl", NULL, &report, &r, &error));
  CHECK(same(a, r));
  quoin_solid_free(r);
  remove("c_test.stl");
  CHECK(quoin_solid_read("c_test.stl", NULL, NULL, &r, &error) == QUOIN_MISSING_FILE);
  CHECK(strcmp(error.file, "c_test.stl") == 0 && r == NULL);
  CHECK(quoin_solid_write(a, "c_test.xyz", NULL, &error) == QUOIN_UNKNOWN_FORMAT);
  REFUSED(quoin_solid_write(a, NULL, NULL, &error), QUOIN_BAD_ARGUMENT, "path");

  /* What is longer than the error holds is cut off. */
  char path[4000];
  memset(path, 'x', sizeof path - 1);
  path[sizeof path - 1] = '\0';
  CHECK(quoin_solid_read(path, NULL, NULL, &r, &error) != QUOIN_OK);
  CHECK(strlen(error.file) == sizeof error.file - 1);
  for (size_t i = 0; i + 1 < sizeof path; i += 2) memcpy(path + i, "\xc3\xa9", 2);
  path[sizeof path - 2] = '\0';
  CHECK(quoin_solid_read(path, NULL, NULL, &r, &error) != QUOIN_OK);
  CHECK(strlen(error.file) == sizeof error.file - 2);
  quoin_solid_free(a);
}

static void test_triangles(void) {
  quoin_solid *a = cube(0, 4), *outside = NULL, *again = NULL;
  quoin_mesh* mesh = NULL;
  quoin_export_report report = QUOIN_INIT(quoin_export_report);
  quoin_export_options options = QUOIN_INIT(quoin_export_options);
  DONE(quoin_solid_to_triangles(a, NULL, &report, &mesh, &error));
  CHECK(quoin_mesh_point_count(mesh) == 8 && quoin_mesh_triangle_count(mesh) == 12);
  CHECK(report.triangles == 12 && report.closed && report.valid && quoin_mesh_points_float32(mesh) == NULL);
  quoin_mesh_free(mesh);

  options.float32 = 1;
  DONE(quoin_solid_to_triangles(a, &options, NULL, &mesh, &error));
  const quoin_array points = {quoin_mesh_points_float32(mesh), 3 * quoin_mesh_point_count(mesh), QUOIN_FLOAT32};
  const quoin_array triangles = {quoin_mesh_triangles(mesh), 3 * quoin_mesh_triangle_count(mesh), QUOIN_UINT32};
  CHECK(points.data != NULL && quoin_mesh_points(mesh)[0] == quoin_mesh_points_float32(mesh)[0]);
  DONE(quoin_solid_from_triangles(points, triangles, NULL, NULL, &again, &error));
  CHECK(same(a, again));
  quoin_mesh_free(mesh);

  DONE(quoin_complement(a, &outside, &error));
  CHECK(quoin_solid_to_triangles(outside, NULL, NULL, &mesh, &error) == QUOIN_UNBOUNDED && mesh == NULL);
  options.validity = (quoin_validity)2;
  REFUSED(quoin_solid_to_triangles(a, &options, NULL, &mesh, &error), QUOIN_BAD_ARGUMENT, "options.validity");
  CHECK(quoin_mesh_points(NULL) == NULL && quoin_mesh_point_count(NULL) == 0);
  quoin_solid_free(a);
  quoin_solid_free(outside);
  quoin_solid_free(again);
}

static void test_labels(void) {
  double low[24], high[24];
  const uint64_t labels[12] = {0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5};
  double channels[36];
  box_points(0, 4, low);
  box_points(1, 5, high);
  for (int i = 0; i < 36; ++i) channels[i] = low[3 * box_triangles[i]] + 10 * low[3 * box_triangles[i] + 1];

  const quoin_array points = {low, 24, QUOIN_FLOAT64}, others = {high, 24, QUOIN_FLOAT64},
                    triangles = {box_triangles, 36, QUOIN_UINT32};
  quoin_import_options options = QUOIN_INIT(quoin_import_options);
  quoin_solid *a = NULL, *b = NULL, *part = NULL, *plain = NULL, *named = NULL;
  quoin_grid* grid = NULL;
  DONE(quoin_grid_with_step("1", NULL, &grid, &error));
  options.grid = grid;
  options.labels = (quoin_array){labels, 12, QUOIN_UINT64};
  options.id = 7;
  options.name = "box";
  options.channels = (quoin_array){channels, 36, QUOIN_FLOAT64};
  DONE(quoin_solid_from_triangles(points, triangles, &options, NULL, &a, &error));
  options.labels.count = 11;
  REFUSED(quoin_solid_from_triangles(points, triangles, &options, NULL, &b, &error), QUOIN_BAD_INDEX, "face 11");
  quoin_import_options bare = QUOIN_INIT(quoin_import_options);
  bare.grid = grid;
  bare.id = 8;
  DONE(quoin_solid_from_triangles(others, triangles, &bare, NULL, &b, &error));

  const quoin_solid* knives[1] = {b};
  DONE(quoin_difference(a, knives, 1, NULL, NULL, &part, &error));
  quoin_mesh* mesh = NULL;
  quoin_export_options as = QUOIN_INIT(quoin_export_options);
  DONE(quoin_solid_to_triangles(part, &as, NULL, &mesh, &error));
  CHECK(quoin_mesh_labels(mesh) == NULL && quoin_mesh_channels(mesh) == NULL && quoin_mesh_original_count(mesh) == 0);
  quoin_mesh_free(mesh);
  as.labels = 1;
  DONE(quoin_solid_to_triangles(part, &as, NULL, &mesh, &error));
  CHECK(quoin_mesh_original_count(mesh) == 2 && quoin_mesh_channel_count(mesh) == 1);
  uint32_t id = 0, seen = 0, turned = 0;
  const char* name = NULL;
  DONE(quoin_mesh_original(mesh, 0, &id, &name, &error));
  CHECK(id == 7 && strcmp(name, "box") == 0);
  DONE(quoin_mesh_original(mesh, 1, &id, NULL, &error));
  CHECK(id == 8);
  REFUSED(quoin_mesh_original(mesh, 2, &id, &name, &error), QUOIN_BAD_ARGUMENT, "original");
  for (size_t t = 0; t < quoin_mesh_triangle_count(mesh); ++t) {
    const quoin_face_label* l = quoin_mesh_labels(mesh) + t;
    CHECK(l->original < 2 && l->turned == (l->original == 1));
    turned += (uint32_t)l->turned;
    if (l->original == 1) continue;
    seen |= 1u << l->label;
    for (size_t i = 3 * t; i < 3 * t + 3; ++i) {
      const double* p = quoin_mesh_points(mesh) + 3 * quoin_mesh_triangles(mesh)[i];
      CHECK(quoin_mesh_channels(mesh)[i] == p[0] + 10 * p[1]);
    }
  }
  CHECK(seen == 63 && turned == 6);
  quoin_mesh_free(mesh);

  quoin_boundary* boundary = NULL;
  quoin_boundary_counts counts = QUOIN_INIT(quoin_boundary_counts);
  DONE(quoin_solid_boundary_by_label(part, &boundary, &error));
  DONE(quoin_boundary_count(boundary, &counts, &error));
  CHECK(counts.faces == 9);
  for (uint32_t f = 0; f < counts.faces; ++f) {
    quoin_face_label label;
    DONE(quoin_boundary_label(boundary, f, &label, &error));
    DONE(quoin_boundary_original(boundary, label.original, &id, &name, &error));
    CHECK(label.turned == (id == 8) && strcmp(name, id == 7 ? "box" : "") == 0);
  }
  quoin_boundary_free(boundary);

  int yes = 0;
  DONE(quoin_solid_has_labels(part, &yes, &error));
  CHECK(yes == 1);
  DONE(quoin_solid_unlabelled(part, &plain, &error));
  DONE(quoin_solid_has_labels(plain, &yes, &error));
  CHECK(yes == 0 && same(plain, part));
  DONE(quoin_same_faces(plain, part, &yes, &error));
  CHECK(yes == 0);
  const uint32_t faces[9] = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  DONE(quoin_solid_labelled(plain, 3, NULL, (quoin_array){faces, 9, QUOIN_UINT32}, &named, &error));
  DONE(quoin_same_faces(named, named, &yes, &error));
  CHECK(yes == 1);
  quoin_solid_free(a);
  quoin_solid_free(b);
  quoin_solid_free(part);
  quoin_solid_free(plain);
  quoin_solid_free(named);
  quoin_grid_free(grid);
}

static void test_motions(void) {
  const char* const axis[3] = {"0", "0", "1"};
  const char* const by[3] = {"1", "1/2", "0"};
  const char* const zero[3] = {"0", "0", "0"};
  const char* const half_turn[4] = {"0", "0", "0", "1"};
  const char* const rows[9] = {"0", "-1", "0", "1", "0", "0", "0", "0", "1"};
  quoin_motion *turn = NULL, *shift = NULL, *both = NULL, *back = NULL, *none = NULL, *m = NULL;
  double deviation = 1;
  int equal = 0;
  char* entry = NULL;
  DONE(quoin_motion_rotation(axis, "90", &turn, &error));
  DONE(quoin_motion_matrix(rows, &deviation, &m, &error));
  CHECK(deviation == 0);
  DONE(quoin_motion_entry(m, 1, 0, &entry, &error));
  CHECK(text_is(entry, "1"));
  DONE(quoin_motion_equal(turn, turn, &equal, &error));
  CHECK(equal == 1);
  quoin_motion_free(m);
  DONE(quoin_motion_translation(by, &shift, &error));
  DONE(quoin_motion_then(turn, shift, &both, &error));
  DONE(quoin_motion_entry(both, 0, 1, &entry, &error));
  CHECK(text_is(entry, "-1"));
  DONE(quoin_motion_entry(both, 1, 3, &entry, &error));
  CHECK(text_is(entry, "1/2"));
  DONE(quoin_motion_inverse(both, &back, &error));
  DONE(quoin_motion_then(both, back, &m, &error));
  DONE(quoin_motion_new(&none, &error));
  DONE(quoin_motion_equal(m, none, &equal, &error));
  CHECK(equal == 1);
  quoin_motion_free(m);

  quoin_solid *a = cube(0, 4), *moved = NULL, *again = NULL;
  quoin_motion_report report = QUOIN_INIT(quoin_motion_report);
  DONE(quoin_moved(a, both, QUOIN_ROUNDING_BEST, NULL, &report, &moved, &error));
  double low[3], high[3];
  int has_box = 0;
  DONE(quoin_solid_box(moved, &has_box, low, high, &error));
  CHECK(low[0] == -3 && low[1] == 0.5 && high[2] == 4 && report.displacement == 0 && report.primitives == 1);
  DONE(quoin_moved(moved, back, QUOIN_ROUNDING_BEST, NULL, NULL, &again, &error));
  CHECK(same(a, again));
  quoin_solid_free(moved);
  REFUSED(quoin_moved(a, both, (quoin_rounding)6, NULL, NULL, &moved, &error), QUOIN_BAD_ARGUMENT, "rounding");

  DONE(quoin_motion_quaternion(half_turn, &m, &error));
  quoin_motion_free(m);
  DONE(quoin_motion_mirror(axis, &m, &error));
  quoin_motion_free(m);
  CHECK(quoin_motion_scaling(zero, &m, &error) == QUOIN_BAD_FACTOR && m == NULL);
  CHECK(quoin_motion_rotation(zero, "90", &m, &error) == QUOIN_BAD_AXIS);
  REFUSED(quoin_motion_rotation(axis, NULL, &m, &error), QUOIN_BAD_ARGUMENT, "degrees");
  REFUSED(quoin_motion_translation(NULL, &m, &error), QUOIN_BAD_ARGUMENT, "by");
  quoin_motion_free(turn);
  quoin_motion_free(shift);
  quoin_motion_free(both);
  quoin_motion_free(back);
  quoin_motion_free(none);
  quoin_solid_free(a);
  quoin_solid_free(again);
}

static void test_models(void) {
  static const char json[] =
      "{\"quoin-model\": 1, \"parameters\": {\"w\": \"4\"},"
      " \"model\": {\"union\": [{\"block\": {\"size\": [\"w\", 4, 4]}}]}}";
  const char *names[1] = {"w"}, *values[1] = {"6"};
  quoin_model *model = NULL, *again = NULL;
  quoin_solid *a = NULL, *expected = cube(0, 4);
  quoin_motion_report report = QUOIN_INIT(quoin_motion_report);
  quoin_model_options options = QUOIN_INIT(quoin_model_options);
  char* text = NULL;
  DONE(quoin_model_from_json(json, strlen(json), NULL, &model, &error));
  DONE(quoin_evaluate(model, NULL, &report, &a, &error));
  CHECK(same(a, expected) && report.primitives == 1);
  quoin_solid_free(a);
  options.names = names;
  options.values = values;
  options.parameters = 1;
  DONE(quoin_evaluate(model, &options, NULL, &a, &error));
  CHECK(has_volume(a, "96"));
  quoin_solid_free(a);
  names[0] = "v";
  CHECK(quoin_evaluate(model, &options, NULL, &a, &error) == QUOIN_BAD_PARAMETER);
  names[0] = NULL;
  REFUSED(quoin_evaluate(model, &options, NULL, &a, &error), QUOIN_BAD_ARGUMENT, "options.names");
  DONE(quoin_model_to_json(model, &text, &error));
  DONE(quoin_model_from_json(text, strlen(text), ".", &again, &error));
  DONE(quoin_evaluate(again, NULL, NULL, &a, &error));
  CHECK(same(a, expected));
  quoin_text_free(text);
  quoin_model_free(model);
  quoin_model_free(again);
  CHECK(quoin_model_from_json("{", 1, NULL, &model, &error) == QUOIN_BAD_MODEL && model == NULL);
  CHECK(strncmp(error.where, "line 1", 6) == 0);
  CHECK(quoin_model_read("c_test.json", &model, &error) == QUOIN_MISSING_FILE);
  quoin_solid_free(a);
  quoin_solid_free(expected);
}

static void test_boundary(void) {
  quoin_solid *a = cube(0, 4), *b = cube(1, 3), *c = cube(6, 7), *solid = NULL, *part = NULL;
  const quoin_solid *inner[1] = {b}, *both[2] = {NULL, c};
  quoin_solid* holed = NULL;
  DONE(quoin_difference(a, inner, 1, NULL, NULL, &holed, &error));
  both[0] = holed;
  DONE(quoin_unite(both, 2, NULL, NULL, &solid, &error));

  quoin_boundary* boundary = NULL;
  DONE(quoin_solid_boundary(solid, &boundary, &error));
  quoin_boundary_counts counts = QUOIN_INIT(quoin_boundary_counts);
  DONE(quoin_boundary_count(boundary, &counts, &error));
  CHECK(counts.vertices == 24 && counts.faces == 18 && counts.loops == 18 && counts.corners == 72);
  CHECK(counts.edges == 36 && counts.shells == 3 && counts.components == 2);

  uint32_t corners = 0, voids = 0;
  for (uint32_t f = 0; f < counts.faces; ++f) {
    quoin_face face = QUOIN_INIT(quoin_face);
    double face_area = 0;
    DONE(quoin_boundary_face(boundary, f, &face, &error));
    DONE(quoin_boundary_face_area(boundary, f, &face_area, &error));
    CHECK(face.loops == 1 && face.corners == 4 && face.starts[1] - face.starts[0] == 4 && face_area > 0);
    uint32_t at = face.first_corner;
    for (uint32_t i = 0; i < face.corners; ++i) {
      quoin_corner corner = QUOIN_INIT(quoin_corner), other = QUOIN_INIT(quoin_corner);
      DONE(quoin_boundary_corner(boundary, at, &corner, &error));
      CHECK(corner.face == f && corner.vertex == face.vertices[i] && corner.edge < counts.edges);
      DONE(quoin_boundary_corner(boundary, corner.opposite, &other, &error));
      CHECK(other.opposite == at && other.edge == corner.edge && other.face != f);
      at = corner.next;
      ++corners;
    }
    CHECK(at == face.first_corner);
  }
  CHECK(corners == counts.corners);
  for (uint32_t e = 0; e < counts.edges; ++e) {
    uint32_t ends[2], fan = 0, use = 0;
    int forward = -1, sum = 0;
    DONE(quoin_boundary_edge(boundary, e, ends, &fan, &error));
    CHECK(fan == 2 && ends[0] < ends[1]);
    for (uint32_t i = 0; i < fan; ++i) {
      DONE(quoin_boundary_fan(boundary, e, i, &use, &forward, &error));
      sum += forward;
    }
    CHECK(sum == 1);
    REFUSED(quoin_boundary_fan(boundary, e, fan, &use, NULL, &error), QUOIN_BAD_ARGUMENT, "place");
  }

  double sum = 0;
  for (uint32_t s = 0; s < counts.shells; ++s) {
    quoin_shell shell = QUOIN_INIT(quoin_shell);
    char* volume = NULL;
    DONE(quoin_boundary_shell(boundary, s, &shell, &error));
    DONE(quoin_boundary_shell_volume(boundary, s, &volume, &error));
    CHECK(shell.genus == 0 && shell.face_count == 6 && shell.component < 2);
    CHECK((shell.parent == QUOIN_NONE) == !shell.is_void);
    voids += shell.is_void != 0;
    sum += (shell.is_void ? -1 : 1) * atof(volume);
    quoin_text_free(volume);
  }
  CHECK(voids == 1 && sum == 64 - 8 + 1);
  DONE(quoin_boundary_component(boundary, 0, &part, &error));
  CHECK(same(part, holed));
  quoin_solid_free(part);
  DONE(quoin_boundary_component(boundary, 1, &part, &error));
  CHECK(same(part, c));
  quoin_solid_free(part);
  REFUSED(quoin_boundary_component(boundary, 2, &part, &error), QUOIN_BAD_ARGUMENT, "component");
  double point[3] = {9, 9, 9};
  DONE(quoin_boundary_point(boundary, 0, point, &error));
  CHECK(point[0] == 0 && point[1] == 0 && point[2] == 0);
  REFUSED(quoin_boundary_point(boundary, 24, point, &error), QUOIN_BAD_ARGUMENT, "vertex");
  REFUSED(quoin_boundary_point(NULL, 0, point, &error), QUOIN_BAD_ARGUMENT, "boundary");
  quoin_boundary_free(boundary);
  REFUSED(quoin_solid_boundary(NULL, &boundary, &error), QUOIN_BAD_ARGUMENT, "solid");
  CHECK(boundary == NULL);

  /* Out as text, and back. */
  DONE(quoin_solid_boundary(holed, &boundary, &error));
  DONE(quoin_boundary_count(boundary, &counts, &error));
  char *points[4 * 16], *planes[4 * 12];
  uint32_t faces[13] = {0}, loops[13] = {0}, all[48];
  for (uint32_t i = 0; i < 4 * counts.vertices; ++i)
    DONE(quoin_boundary_homogeneous(boundary, i / 4, i % 4, points + i, &error));
  for (uint32_t f = 0; f < counts.faces; ++f) {
    quoin_face face = QUOIN_INIT(quoin_face);
    DONE(quoin_boundary_face(boundary, f, &face, &error));
    memcpy(all + 4 * f, face.vertices, 4 * sizeof *all);
    faces[f + 1] = f + 1;
    loops[f + 1] = 4 * (f + 1);
    for (uint32_t k = 0; k < 4; ++k) DONE(quoin_boundary_plane(boundary, f, k, planes + 4 * f + k, &error));
  }
  quoin_grid* grid = NULL;
  DONE(quoin_solid_grid(holed, &grid, &error));
  quoin_exact_polygons polygons = QUOIN_INIT(quoin_exact_polygons);
  polygons.grid = grid;
  polygons.points = (const char* const*)points;
  polygons.planes = (const char* const*)planes;
  polygons.point_count = counts.vertices;
  polygons.face_count = counts.faces;
  const quoin_array face_starts = {faces, 13, QUOIN_UINT32}, loop_starts = {loops, 13, QUOIN_UINT32},
                    corner_list = {all, 48, QUOIN_UINT32};
  polygons.face_starts = face_starts;
  polygons.loop_starts = loop_starts;
  polygons.corners = corner_list;
  DONE(quoin_solid_from_boundary(&polygons, QUOIN_TRUST_NOTHING, &part, &error));
  CHECK(same(part, holed));
  quoin_solid_free(part);
  all[5] = 99;
  REFUSED(quoin_solid_from_boundary(&polygons, QUOIN_TRUST_NOTHING, &part, &error), QUOIN_BAD_INDEX, "corner 5");
  polygons.points = NULL;
  REFUSED(quoin_solid_from_boundary(&polygons, QUOIN_TRUST_NOTHING, &part, &error), QUOIN_BAD_ARGUMENT,
          "polygons.points");
  char* text = NULL;
  DONE(quoin_boundary_coordinate(boundary, 0, 0, &text, &error));
  CHECK(text_is(text, "0"));
  DONE(quoin_boundary_model_plane(boundary, 0, 0, &text, &error));
  CHECK(text_is(text, "-1"));
  for (uint32_t i = 0; i < 64; ++i) quoin_text_free(points[i]);
  for (uint32_t i = 0; i < 48; ++i) quoin_text_free(planes[i]);

  quoin_grid_free(grid);
  quoin_boundary_free(boundary);
  quoin_solid_free(a);
  quoin_solid_free(b);
  quoin_solid_free(c);
  quoin_solid_free(holed);
  quoin_solid_free(solid);
}

/* Frees what a failed course of work leaves. 0: done; 3: out of memory, as the error says; 1: anything else. */
static int course_of_work(void) {
  static const double points[] = {0, 0, 0, 9, 1, 0, 1, 8, 0, 2, 3, 7}, others[] = {1, 1, 1, 9, 1, 2, 1, 8, 3, 2, 3, 9};
  static const uint32_t triangles[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  const quoin_array indices = {triangles, 12, QUOIN_UINT32};
  quoin_solid *a = NULL, *b = NULL, *r = NULL, *part = NULL;
  quoin_boundary* boundary = NULL;
  quoin_mesh* mesh = NULL;
  char *volume = NULL, *text = NULL;
  const quoin_solid* both[2];
  quoin_code code = quoin_solid_from_triangles(doubles(points, 12), indices, NULL, NULL, &a, &error);
  if (code == QUOIN_OK) code = quoin_solid_from_triangles(doubles(others, 12), indices, NULL, NULL, &b, &error);
  both[0] = a;
  both[1] = b;
  quoin_options options = QUOIN_INIT(quoin_options);
  options.threads = 1;
  if (code == QUOIN_OK) code = quoin_symmetric_difference(both, 2, &options, NULL, &r, &error);
  if (code == QUOIN_OK) code = quoin_solid_volume(r, &volume, &error);
  if (code == QUOIN_OK) code = quoin_solid_boundary(r, &boundary, &error);
  if (code == QUOIN_OK) code = quoin_boundary_component(boundary, 0, &part, &error);
  if (code == QUOIN_OK) code = quoin_solid_to_quoin(part, &text, NULL, &error);
  if (code == QUOIN_OK) code = quoin_solid_to_triangles(part, NULL, NULL, &mesh, &error);

  if (code == QUOIN_OUT_OF_MEMORY && (error.code != code || error.message[0] == '\0')) code = QUOIN_INTERNAL_DEFECT;
  quoin_text_free(volume);
  quoin_text_free(text);
  quoin_mesh_free(mesh);
  quoin_boundary_free(boundary);
  quoin_solid_free(a);
  quoin_solid_free(b);
  quoin_solid_free(r);
  quoin_solid_free(part);
  if (code != QUOIN_OK && code != QUOIN_OUT_OF_MEMORY) fprintf(stderr, "%s %s\n", quoin_code_name(code), error.message);
  return code == QUOIN_OK ? 0 : code == QUOIN_OUT_OF_MEMORY ? 3 : 1;
}

int main(int argc, char** argv) {
  if (argc > 1 && strcmp(argv[1], "memory") == 0) {
    const quoin_code code = argc > 2 ? quoin_reserve_for_gmp(1 << 20, &error) : QUOIN_OK;
    return code == QUOIN_OK ? course_of_work() : code == QUOIN_OUT_OF_MEMORY ? 3 : 1;
  }
  DONE(quoin_reserve_for_gmp(0, &error));
  REFUSED(quoin_reserve_for_gmp(1 << 20, &error), QUOIN_BAD_ARGUMENT, "bytes");
  test_versions();
  test_grids();
  test_arrays();
  test_operations();
  test_reports();
  test_running();
  test_answers();
  test_text_and_files();
  test_triangles();
  test_labels();
  test_motions();
  test_models();
  test_boundary();
  CHECK(course_of_work() == 0);
  quoin_solid_free(NULL);
  printf("%d failures\n", failures);
  return failures != 0;
}
