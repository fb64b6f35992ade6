/**
 * \file
 * Quoin for C and for whatever calls C: the whole of the library behind plain functions. C11; docs/c.md has an example.
 *
 * Errors. A function that can fail returns a quoin_code, QUOIN_OK being 0, and fills the caller's `error`, which may be
 * NULL. A handle, a text or a number that it hands out is then NULL or 0, a struct stays as it was; only reports may
 * say why an input was refused. Nothing is thrown through these functions. Memory exhaustion is
 * QUOIN_OUT_OF_MEMORY, but where GMP (see quoin_reserve_for_gmp) or the C library itself gets none: these end the
 * process. Callbacks must return to their caller.
 *
 * Arguments. A NULL where none is allowed, an index beyond its count, an enumerator that there is none of, and a struct
 * of size 0 are QUOIN_BAD_ARGUMENT. NULL is allowed for `error`, for options (the defaults), for reports (none), and
 * where a comment says so. `free` functions take NULL.
 *
 * Memory: who frees what.
 *   1. Handles that a function hands out through `out` are the caller's, who gives them to the free function of their
 *      type, once. No other handle depends on them: a solid may be freed before its boundary is.
 *   2. Text that a function hands out through `char** out` is the caller's, who gives it to quoin_text_free.
 *   3. Pointers to const that a function returns or hands out belong to the handle that it was asked about, and live
 *      as long as that does. Text of quoin_code_name and of versions lives for ever.
 *   4. Arrays, text and structs that the caller passes in are read or written during the call only, and never freed.
 *      Errors and reports hold their text themselves: nothing of them is freed.
 *   5. A quoin_cancel and whatever `user` points to must live until the call that was given it returns.
 *
 * Threads. Handles are immutable, but for quoin_cancel: any number of threads may read one handle at a time, and any
 * thread may free it when no other one uses it.
 *
 * Versions. A struct that begins with `size` is versioned by it: QUOIN_INIT sets the size that the caller was compiled
 * with, and all other members to their defaults, which are 0. Later versions only add members at the end and
 * enumerators and functions.
 *
 * Numbers are text wherever they are exact: "-1.25e-3", "1/3". Units, orders and meanings are those of the C++ headers.
 */
#ifndef QUOIN_QUOIN_C_H
#define QUOIN_QUOIN_C_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define QUOIN_C_API __attribute__((visibility("default")))
#else
#define QUOIN_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Of this header; raised when something is added. */
#define QUOIN_C_VERSION 1
/** Of the library. */
QUOIN_C_API uint32_t quoin_c_version(void);
/** "0.1.0"; the git commit that it was built from; the version of the .quoin format that it writes. */
QUOIN_C_API const char* quoin_version(void);
QUOIN_C_API const char* quoin_commit(void);
QUOIN_C_API int quoin_format_version(void);

/* Errors */

/** The codes of docs/errors.md; numbers stay. */
typedef enum quoin_code {
  QUOIN_OK = 0,
  QUOIN_MISSING_FILE = 1,
  QUOIN_UNREADABLE = 2,
  QUOIN_UNKNOWN_FORMAT = 3,
  QUOIN_TRUNCATED = 4,
  QUOIN_BAD_SYNTAX = 5,
  QUOIN_BAD_NUMBER = 6,
  QUOIN_NON_FINITE = 7,
  QUOIN_BAD_INDEX = 8,
  QUOIN_ABSURD_COUNT = 9,
  QUOIN_NO_FACES = 10,
  QUOIN_BAD_QUOIN = 11,
  QUOIN_UNWRITABLE = 12,
  QUOIN_TOO_LARGE = 13,
  QUOIN_OPEN_BOUNDARY = 14,
  QUOIN_INSIDE_OUT = 15,
  QUOIN_OUT_OF_RANGE = 16,
  QUOIN_INEXACT_GRID = 17,
  QUOIN_MIXED_UNITS = 18,
  QUOIN_BAD_PLANE = 19,
  QUOIN_NO_OPERAND = 20,
  QUOIN_TOO_MANY_TERMS = 21,
  QUOIN_UNBOUNDED = 22,
  QUOIN_INCONSISTENT = 23,
  QUOIN_CANCELLED = 24,
  QUOIN_BAD_MODEL = 25,
  QUOIN_BAD_PARAMETER = 26,
  QUOIN_BAD_PRIMITIVE = 27,
  QUOIN_BAD_AXIS = 28,
  QUOIN_BAD_FACTOR = 29,
  QUOIN_NOT_A_ROTATION = 30,
  QUOIN_INCONSISTENT_MOTION = 31,
  QUOIN_USAGE = 32,
  QUOIN_OUT_OF_MEMORY = 33,
  QUOIN_INTERNAL_DEFECT = 34,
  /** Of these functions alone: see "Arguments" above. */
  QUOIN_BAD_ARGUMENT = 1000
} quoin_code;

/** "open-boundary"; "ok" and "bad-argument" beside those of the page; "unknown" for any other number. */
QUOIN_C_API const char* quoin_code_name(quoin_code code);

/** Why something was refused. UTF-8, cut off at a whole character where it is longer; empty where there is nothing. */
typedef struct quoin_error {
  quoin_code code;
  /** One sentence. */
  char message[1024];
  /** The file concerned. */
  char file[1024];
  /** The place: a face, an edge, coordinates, a line, an argument. */
  char where[256];
} quoin_error;

/** quoin_options options = QUOIN_INIT(quoin_options); */
#ifdef __cplusplus
#define QUOIN_INIT(type)           \
  ([] {                            \
    type defaults_{};              \
    defaults_.size = sizeof(type); \
    return defaults_;              \
  }())
#else
#define QUOIN_INIT(type) \
  { .size = sizeof(type) }
#endif

QUOIN_C_API void quoin_text_free(char* text);

/**
 * GMP, which computes with long numbers, ends the process where it gets no memory. After this call it takes it from so
 * many bytes that are set aside now, until an allocation of Quoin's own fails and is an error; only what is longer than
 * these still ends the process. Sets GMP's functions for memory, which the whole process shares; once, while no other
 * thread uses GMP, and not where the process has set functions of its own.
 */
QUOIN_C_API quoin_code quoin_reserve_for_gmp(size_t bytes, quoin_error* error);

/* Handles */

typedef struct quoin_grid quoin_grid;
typedef struct quoin_solid quoin_solid;
typedef struct quoin_mesh quoin_mesh;
typedef struct quoin_boundary quoin_boundary;
typedef struct quoin_motion quoin_motion;
typedef struct quoin_model quoin_model;
typedef struct quoin_cancel quoin_cancel;

QUOIN_C_API void quoin_grid_free(quoin_grid* grid);
QUOIN_C_API void quoin_solid_free(quoin_solid* solid);
QUOIN_C_API void quoin_mesh_free(quoin_mesh* mesh);
QUOIN_C_API void quoin_boundary_free(quoin_boundary* boundary);
QUOIN_C_API void quoin_motion_free(quoin_motion* motion);
QUOIN_C_API void quoin_model_free(quoin_model* model);
QUOIN_C_API void quoin_cancel_free(quoin_cancel* cancel);

/* Running */

/** A flag that makes operations return QUOIN_CANCELLED. */
QUOIN_C_API quoin_code quoin_cancel_new(quoin_cancel** out, quoin_error* error);
/** From any thread or signal handler. NULL: nothing. */
QUOIN_C_API void quoin_cancel_request(quoin_cancel* cancel);
/** Lowers the flag. NULL: nothing. */
QUOIN_C_API void quoin_cancel_reset(quoin_cancel* cancel);

typedef enum quoin_grid_rule { QUOIN_GRID_COMMON = 0, QUOIN_GRID_EXACT = 1 } quoin_grid_rule;

typedef struct quoin_options {
  size_t size;
  /** Called in the calling thread with a fraction in [0, 1]; other than 0 makes the operation return QUOIN_CANCELLED.
   */
  int (*progress)(double done, void* user);
  /** Called in the calling thread with the name of each stage as it begins. */
  void (*stage)(const char* name, void* user);
  void* user;
  quoin_cancel* cancel;
  /** 0: what the machine has. Results are the same bytes for any number. */
  uint32_t threads;
  quoin_grid_rule grid_rule;
} quoin_options;

/* Grids */

/** Step 1, origin 0. */
QUOIN_C_API quoin_code quoin_grid_new(quoin_grid** out, quoin_error* error);
/** `origin`: three numbers; NULL for 0. */
QUOIN_C_API quoin_code quoin_grid_with_step(const char* step, const char* const origin[3], quoin_grid** out,
                                            quoin_error* error);
/** The default grid for a box in model units. */
QUOIN_C_API quoin_code quoin_grid_fitting(const double low[3], const double high[3], quoin_grid** out,
                                          quoin_error* error);
QUOIN_C_API quoin_code quoin_grid_step(const quoin_grid* grid, char** out, quoin_error* error);
/** `axis`: 0, 1, 2. */
QUOIN_C_API quoin_code quoin_grid_origin(const quoin_grid* grid, uint32_t axis, char** out, quoin_error* error);
QUOIN_C_API quoin_code quoin_grid_equal(const quoin_grid* a, const quoin_grid* b, int* out, quoin_error* error);

/* Solids from arrays */

typedef enum quoin_type {
  QUOIN_FLOAT64 = 0,
  QUOIN_FLOAT32 = 1,
  QUOIN_UINT32 = 2,
  QUOIN_INT32 = 3,
  QUOIN_UINT64 = 4
} quoin_type;

/** So many numbers side by side. `data` may be NULL where `count` is 0. */
typedef struct quoin_array {
  const void* data;
  size_t count;
  quoin_type type;
} quoin_array;

typedef enum quoin_trust { QUOIN_TRUST_NOTHING = 0, QUOIN_TRUST_EMBEDDED = 1 } quoin_trust;

typedef struct quoin_import_options {
  size_t size;
  /** NULL: the grid that fits the input. */
  const quoin_grid* grid;
  quoin_trust trust;
  /** Cures as the command's --repair has them: "weld=0.002,caps", "all". NULL: none. */
  const char* repair;
  const quoin_options* run;
  /** What faces carry (docs/attributes.md), all or nothing: a label for each triangle or polygon, whole; the solid's
      name, of which NULL is the empty one; numbers for each corner, floating, so many for each. */
  quoin_array labels;
  uint32_t id;
  const char* name;
  quoin_array channels;
  /** Of the range of a channel; 0: 2^-20. */
  double channel_tolerance;
} quoin_import_options;

/** quoin/import.h, ImportReport. */
typedef struct quoin_import_report {
  size_t size;
  double max_snap;
  uint64_t merged_points, zero_area_triangles, nonplanar_polygons, resolved_crossings, dropped_shells,
      sealed_t_junctions;
  /** How many kinds of defect are left, and how many kinds of cure were done. */
  uint64_t findings, repairs;
} quoin_import_report;

/** `points`: x, y, z per vertex, floating; `triangles`: three indices each, whole. */
QUOIN_C_API quoin_code quoin_solid_from_triangles(quoin_array points, quoin_array triangles,
                                                  const quoin_import_options* options, quoin_import_report* report,
                                                  quoin_solid** out, quoin_error* error);
/** Polygon i has the corners corners[starts[i]] .. corners[starts[i + 1] - 1]. */
QUOIN_C_API quoin_code quoin_solid_from_polygons(quoin_array points, quoin_array starts, quoin_array corners,
                                                 const quoin_import_options* options, quoin_import_report* report,
                                                 quoin_solid** out, quoin_error* error);

/* Solids from and to text and files */

QUOIN_C_API quoin_code quoin_solid_from_quoin(const char* text, size_t length, quoin_trust trust, quoin_solid** out,
                                              quoin_error* error);
/** Ends with a 0 that `length`, which may be NULL, does not count. */
QUOIN_C_API quoin_code quoin_solid_to_quoin(const quoin_solid* solid, char** out, size_t* length, quoin_error* error);
/** Any format that Quoin reads; "-" is standard input. */
QUOIN_C_API quoin_code quoin_solid_read(const char* path, const quoin_import_options* options,
                                        quoin_import_report* report, quoin_solid** out, quoin_error* error);

typedef enum quoin_topology { QUOIN_TOPOLOGY_MANIFOLD = 0, QUOIN_TOPOLOGY_INDEXED = 1 } quoin_topology;
typedef enum quoin_validity { QUOIN_VALID = 0, QUOIN_FAST = 1 } quoin_validity;

typedef struct quoin_export_options {
  size_t size;
  quoin_topology topology;
  quoin_validity validity;
  /** Other than 0: round to float32; subtract the box's centre. */
  int float32, recentre;
  const quoin_options* run;
  /** Other than 0: the mesh says what its triangles carry. */
  int labels;
} quoin_export_options;

/** quoin/triangles.h, ExportReport. */
typedef struct quoin_export_report {
  size_t size;
  uint64_t triangles, flipped, collapsed, split_edges, shared_edges;
  uint64_t mending_rounds, mended_crossings, merged_vertices, vanished_triangles;
  int closed, valid;
  double max_round, least_detail;
  double recentred[3];
} quoin_export_report;

/** The format is the extension's; the file appears whole or not at all. */
QUOIN_C_API quoin_code quoin_solid_write(const quoin_solid* solid, const char* path,
                                         const quoin_export_options* options, quoin_error* error);

/* Solids */

/** `grid`: NULL for the default one. */
QUOIN_C_API quoin_code quoin_solid_empty(const quoin_grid* grid, quoin_solid** out, quoin_error* error);
/** All of space. */
QUOIN_C_API quoin_code quoin_solid_full(const quoin_grid* grid, quoin_solid** out, quoin_error* error);
/** Another handle of the same solid, in constant time. */
QUOIN_C_API quoin_code quoin_solid_copy(const quoin_solid* solid, quoin_solid** out, quoin_error* error);
QUOIN_C_API quoin_code quoin_solid_grid(const quoin_solid* solid, quoin_grid** out, quoin_error* error);
QUOIN_C_API quoin_code quoin_solid_on_grid(const quoin_solid* solid, const quoin_grid* grid, quoin_solid** out,
                                           quoin_error* error);

QUOIN_C_API quoin_code quoin_solid_is_empty(const quoin_solid* solid, int* out, quoin_error* error);
QUOIN_C_API quoin_code quoin_solid_is_bounded(const quoin_solid* solid, int* out, quoin_error* error);
/** Equality of point sets, across grids too. */
QUOIN_C_API quoin_code quoin_solid_equal(const quoin_solid* a, const quoin_solid* b, int* out, quoin_error* error);

typedef enum quoin_location { QUOIN_INSIDE = 0, QUOIN_BOUNDARY = 1, QUOIN_OUTSIDE = 2 } quoin_location;
/** Exact. QUOIN_NON_FINITE for what is no point. */
QUOIN_C_API quoin_code quoin_solid_classify(const quoin_solid* solid, const double point[3], quoin_location* out,
                                            quoin_error* error);
/** Exact, "p/q" in cubic model units. QUOIN_UNBOUNDED where there is none. */
QUOIN_C_API quoin_code quoin_solid_volume(const quoin_solid* solid, char** out, quoin_error* error);

typedef struct quoin_counts {
  size_t size;
  uint64_t vertices, edges, faces;
} quoin_counts;
/** Of the canonical form. */
QUOIN_C_API quoin_code quoin_solid_counts(const quoin_solid* solid, quoin_counts* out, quoin_error* error);

/** quoin/solid.h, Info; the volume rounded. */
typedef struct quoin_info {
  size_t size;
  uint64_t vertices, edges, faces, triangles, shells;
  int64_t genus;
  int closed, manifold, bounded, has_box;
  double volume, area;
  /** All 0 where there is no boundary. */
  double low[3], high[3];
} quoin_info;
QUOIN_C_API quoin_code quoin_solid_info(const quoin_solid* solid, const quoin_options* options, quoin_info* out,
                                        quoin_error* error);
/** `has_box` is 0, and so are the corners, where there is no boundary. */
QUOIN_C_API quoin_code quoin_solid_box(const quoin_solid* solid, int* has_box, double low[3], double high[3],
                                       quoin_error* error);
/** Square model units, computed in doubles. */
QUOIN_C_API quoin_code quoin_solid_area(const quoin_solid* solid, double* out, quoin_error* error);

/* Operations */

/** quoin/report.h, OperationReport. */
typedef struct quoin_operation_report {
  size_t size;
  double max_snap;
  uint64_t rounded_operands, by_planes, by_vertices, resolved_crossings, rounded_planes, vanished_operands;
} quoin_operation_report;

/** Of any number of solids. */
QUOIN_C_API quoin_code quoin_unite(const quoin_solid* const* solids, size_t count, const quoin_options* options,
                                   quoin_operation_report* report, quoin_solid** out, quoin_error* error);
QUOIN_C_API quoin_code quoin_intersect(const quoin_solid* const* solids, size_t count, const quoin_options* options,
                                       quoin_operation_report* report, quoin_solid** out, quoin_error* error);
/** Points in an odd number of the solids. */
QUOIN_C_API quoin_code quoin_symmetric_difference(const quoin_solid* const* solids, size_t count,
                                                  const quoin_options* options, quoin_operation_report* report,
                                                  quoin_solid** out, quoin_error* error);
/** The first minus all of the others. */
QUOIN_C_API quoin_code quoin_difference(const quoin_solid* minuend, const quoin_solid* const* subtrahends, size_t count,
                                        const quoin_options* options, quoin_operation_report* report, quoin_solid** out,
                                        quoin_error* error);
QUOIN_C_API quoin_code quoin_complement(const quoin_solid* solid, quoin_solid** out, quoin_error* error);
/** The parts above and below a x + b y + c z + d = 0; `plane` has the four numbers. */
QUOIN_C_API quoin_code quoin_split(const quoin_solid* solid, const char* const plane[4], const quoin_options* options,
                                   quoin_operation_report* report, quoin_solid** above, quoin_solid** below,
                                   quoin_error* error);

/* Motions */

QUOIN_C_API quoin_code quoin_motion_new(quoin_motion** out, quoin_error* error);
QUOIN_C_API quoin_code quoin_motion_rotation(const char* const axis[3], const char* degrees, quoin_motion** out,
                                             quoin_error* error);
QUOIN_C_API quoin_code quoin_motion_translation(const char* const by[3], quoin_motion** out, quoin_error* error);
QUOIN_C_API quoin_code quoin_motion_quaternion(const char* const wxyz[4], quoin_motion** out, quoin_error* error);
/** Row by row; `deviation` may be NULL. */
QUOIN_C_API quoin_code quoin_motion_matrix(const char* const rows[9], double* deviation, quoin_motion** out,
                                           quoin_error* error);
QUOIN_C_API quoin_code quoin_motion_mirror(const char* const normal[3], quoin_motion** out, quoin_error* error);
QUOIN_C_API quoin_code quoin_motion_scaling(const char* const by[3], quoin_motion** out, quoin_error* error);
/** The first, then the second. */
QUOIN_C_API quoin_code quoin_motion_then(const quoin_motion* first, const quoin_motion* second, quoin_motion** out,
                                         quoin_error* error);
QUOIN_C_API quoin_code quoin_motion_inverse(const quoin_motion* motion, quoin_motion** out, quoin_error* error);
QUOIN_C_API quoin_code quoin_motion_equal(const quoin_motion* a, const quoin_motion* b, int* out, quoin_error* error);
/** The exact map: the entry of row 0 .. 2 and column 0 .. 2, and of column 3 the translation after it. */
QUOIN_C_API quoin_code quoin_motion_entry(const quoin_motion* motion, uint32_t row, uint32_t column, char** out,
                                          quoin_error* error);

typedef enum quoin_rounding {
  QUOIN_ROUNDING_BEST = 0,
  QUOIN_ROUNDING_NAIVE = 1,
  QUOIN_ROUNDING_CONTINUED_FRACTION = 2,
  QUOIN_ROUNDING_LATTICE = 3,
  QUOIN_ROUNDING_FACE_LOCAL = 4,
  QUOIN_ROUNDING_VERTICES = 5
} quoin_rounding;

/** quoin/motion.h, MotionReport. */
typedef struct quoin_motion_report {
  size_t size;
  double displacement, angle_error;
  uint64_t primitives, by_planes, by_vertices, planes, exact_planes, face_local_planes;
  uint64_t merged_points, zero_area_triangles, resolved_crossings, vanished_primitives;
} quoin_motion_report;

QUOIN_C_API quoin_code quoin_moved(const quoin_solid* solid, const quoin_motion* motion, quoin_rounding rounding,
                                   const quoin_options* options, quoin_motion_report* report, quoin_solid** out,
                                   quoin_error* error);

/* Models */

/** The text of a model (docs/model-format.md); files that it names are below `folder`, NULL for the current one. */
QUOIN_C_API quoin_code quoin_model_from_json(const char* text, size_t length, const char* folder, quoin_model** out,
                                             quoin_error* error);
/** A file of such text. */
QUOIN_C_API quoin_code quoin_model_read(const char* path, quoin_model** out, quoin_error* error);
QUOIN_C_API quoin_code quoin_model_to_json(const quoin_model* model, char** out, quoin_error* error);

typedef struct quoin_model_options {
  size_t size;
  /** NULL: the model's, or one that fits. */
  const quoin_grid* grid;
  /** So many parameters and their values. */
  const char* const* names;
  const char* const* values;
  size_t parameters;
  quoin_rounding rounding;
  const quoin_options* run;
} quoin_model_options;

QUOIN_C_API quoin_code quoin_evaluate(const quoin_model* model, const quoin_model_options* options,
                                      quoin_motion_report* report, quoin_solid** out, quoin_error* error);

/* Triangles */

QUOIN_C_API quoin_code quoin_solid_to_triangles(const quoin_solid* solid, const quoin_export_options* options,
                                                quoin_export_report* report, quoin_mesh** out, quoin_error* error);
/** 0 of NULL. */
QUOIN_C_API size_t quoin_mesh_point_count(const quoin_mesh* mesh);
QUOIN_C_API size_t quoin_mesh_triangle_count(const quoin_mesh* mesh);
/** x, y, z per point; three indices per triangle. NULL of NULL. */
QUOIN_C_API const double* quoin_mesh_points(const quoin_mesh* mesh);
/** The same numbers where the export was asked for float32; else NULL. */
QUOIN_C_API const float* quoin_mesh_points_float32(const quoin_mesh* mesh);
QUOIN_C_API const uint32_t* quoin_mesh_triangles(const quoin_mesh* mesh);

/* What faces carry (docs/attributes.md) */

/** quoin/labels.h, FaceLabel. `original` is QUOIN_NONE of a face that carries nothing. */
typedef struct quoin_face_label {
  uint32_t original, label, source;
  int32_t turned;
} quoin_face_label;

/** One per triangle; NULL where the export was not asked for them. */
QUOIN_C_API const quoin_face_label* quoin_mesh_labels(const quoin_mesh* mesh);
/** The solids that labels name. `name` may be NULL; it lives as long as the mesh. */
QUOIN_C_API size_t quoin_mesh_original_count(const quoin_mesh* mesh);
QUOIN_C_API quoin_code quoin_mesh_original(const quoin_mesh* mesh, uint32_t original, uint32_t* id, const char** name,
                                           quoin_error* error);
/** Channels of each corner of each triangle, so many numbers for each corner; NULL where there are none. */
QUOIN_C_API size_t quoin_mesh_channel_count(const quoin_mesh* mesh);
QUOIN_C_API const double* quoin_mesh_channels(const quoin_mesh* mesh);

/** `labels`: one for each face of the canonical form, in its order, or none. */
QUOIN_C_API quoin_code quoin_solid_labelled(const quoin_solid* solid, uint32_t id, const char* name, quoin_array labels,
                                            quoin_solid** out, quoin_error* error);
QUOIN_C_API quoin_code quoin_solid_unlabelled(const quoin_solid* solid, quoin_solid** out, quoin_error* error);
/** 1 or 0: is any face labelled; do equal point sets carry the same everywhere? */
QUOIN_C_API quoin_code quoin_solid_has_labels(const quoin_solid* solid, int* out, quoin_error* error);
QUOIN_C_API quoin_code quoin_same_faces(const quoin_solid* a, const quoin_solid* b, int* out, quoin_error* error);

/* The exact boundary (docs/boundary.md) */

/** Where there is no such edge, half-edge or shell. */
#define QUOIN_NONE UINT32_MAX

QUOIN_C_API quoin_code quoin_solid_boundary(const quoin_solid* solid, quoin_boundary** out, quoin_error* error);
/** Its faces cut where what they carry changes. */
QUOIN_C_API quoin_code quoin_solid_boundary_by_label(const quoin_solid* solid, quoin_boundary** out,
                                                     quoin_error* error);
/** Of a boundary by label. */
QUOIN_C_API quoin_code quoin_boundary_label(const quoin_boundary* boundary, uint32_t face, quoin_face_label* out,
                                            quoin_error* error);
/** As quoin_mesh_original. */
QUOIN_C_API quoin_code quoin_boundary_original(const quoin_boundary* boundary, uint32_t original, uint32_t* id,
                                               const char** name, quoin_error* error);

typedef struct quoin_boundary_counts {
  size_t size;
  uint32_t vertices, faces, loops, corners, edges, shells, components;
} quoin_boundary_counts;
QUOIN_C_API quoin_code quoin_boundary_count(const quoin_boundary* boundary, quoin_boundary_counts* out,
                                            quoin_error* error);

/** Correctly rounded, in model units. */
QUOIN_C_API quoin_code quoin_boundary_point(const quoin_boundary* boundary, uint32_t vertex, double out[3],
                                            quoin_error* error);
/** `axis`: 0, 1, 2. In model units, "p/q". */
QUOIN_C_API quoin_code quoin_boundary_coordinate(const quoin_boundary* boundary, uint32_t vertex, uint32_t axis,
                                                 char** out, quoin_error* error);
/** x, y, z, w in grid steps, by 0, 1, 2, 3: whole. */
QUOIN_C_API quoin_code quoin_boundary_homogeneous(const quoin_boundary* boundary, uint32_t vertex, uint32_t which,
                                                  char** out, quoin_error* error);

/** Of a face's plane a, b, c, d, by 0, 1, 2, 3: whole, in grid steps. */
QUOIN_C_API quoin_code quoin_boundary_plane(const quoin_boundary* boundary, uint32_t face, uint32_t which, char** out,
                                            quoin_error* error);
/** The same in model units, d being "p/q". */
QUOIN_C_API quoin_code quoin_boundary_model_plane(const quoin_boundary* boundary, uint32_t face, uint32_t which,
                                                  char** out, quoin_error* error);
QUOIN_C_API quoin_code quoin_boundary_face_area(const quoin_boundary* boundary, uint32_t face, double* out,
                                                quoin_error* error);
/** `starts` has `loops` + 1 numbers of corners: those of all loops of the face, one behind the other. */
typedef struct quoin_face {
  size_t size;
  uint32_t loops, corners, shell;
  /** The number of its first corner among those of all faces. */
  uint32_t first_corner;
  /** Loop j has the vertices vertices[starts[j] - first_corner] .. vertices[starts[j + 1] - first_corner - 1]. */
  const uint32_t* starts;
  const uint32_t* vertices;
} quoin_face;
QUOIN_C_API quoin_code quoin_boundary_face(const quoin_boundary* boundary, uint32_t face, quoin_face* out,
                                           quoin_error* error);

/** A corner, and the half-edge that begins there. */
typedef struct quoin_corner {
  size_t size;
  uint32_t vertex, face, next, previous;
  /** QUOIN_NONE in a loop of one corner. */
  uint32_t edge, opposite;
} quoin_corner;
QUOIN_C_API quoin_code quoin_boundary_corner(const quoin_boundary* boundary, uint32_t corner, quoin_corner* out,
                                             quoin_error* error);

/** The lower vertex and the higher one, and how many half-edges are around. */
QUOIN_C_API quoin_code quoin_boundary_edge(const quoin_boundary* boundary, uint32_t edge, uint32_t vertices[2],
                                           uint32_t* fan, quoin_error* error);
/** The half-edge at a place of the edge's fan, by its corner; `forward` may be NULL. */
QUOIN_C_API quoin_code quoin_boundary_fan(const quoin_boundary* boundary, uint32_t edge, uint32_t place,
                                          uint32_t* corner, int* forward, quoin_error* error);

typedef struct quoin_shell {
  size_t size;
  int64_t genus;
  int is_void;
  /** QUOIN_NONE for none. */
  uint32_t parent;
  uint32_t component, face_count;
  const uint32_t* faces;
} quoin_shell;
QUOIN_C_API quoin_code quoin_boundary_shell(const quoin_boundary* boundary, uint32_t shell, quoin_shell* out,
                                            quoin_error* error);
/** What it encloses, exact. */
QUOIN_C_API quoin_code quoin_boundary_shell_volume(const quoin_boundary* boundary, uint32_t shell, char** out,
                                                   quoin_error* error);
QUOIN_C_API quoin_code quoin_boundary_component(const quoin_boundary* boundary, uint32_t component, quoin_solid** out,
                                                quoin_error* error);

/** Exact polygons. */
typedef struct quoin_exact_polygons {
  size_t size;
  /** NULL for the default one. */
  const quoin_grid* grid;
  /** Other than 0: the solid is what lies outside. */
  int full_at_infinity;
  /** x, y, z, w per vertex; a, b, c, d per face. */
  const char* const* points;
  const char* const* planes;
  size_t point_count, face_count;
  /** As in quoin/boundary.h: face_count + 1 starts of faces, and of loops one more than there are. */
  quoin_array face_starts, loop_starts, corners;
} quoin_exact_polygons;
QUOIN_C_API quoin_code quoin_solid_from_boundary(const quoin_exact_polygons* polygons, quoin_trust trust,
                                                 quoin_solid** out, quoin_error* error);

#ifdef __cplusplus
}
#endif

#endif
