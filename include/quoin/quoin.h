/// \file
/// Quoin: exact Boolean operations on polyhedral solids. This header is the whole C++ API.
///
/// Units. A `Grid` has a step (model units per grid step) and an origin. Doors (files, arrays) speak model units;
/// exact quantities are rationals written as strings "p/q" or "p".
/// Errors. Doors and long operations return `Result`; operators between solids of different grids throw
/// `std::invalid_argument`; memory exhaustion throws `std::bad_alloc`. Nothing else throws.
/// Threads. A `Solid` is an immutable value, cheap to copy and safe to read from many threads.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "quoin/result.h"
#include "quoin/version.h"

namespace quoin {

class Solid;
class Expression;
namespace booleans {
struct Body;
}

/// The lattice that carries all vertices of imported meshes: point = origin + step * (i, j, k), |i|,|j|,|k| <= 2^29.
/// Step and origin are exact rationals.
class Grid {
 public:
  /// Step 1, origin 0.
  Grid();
  ~Grid();
  Grid(const Grid&);
  Grid& operator=(const Grid&);
  /// A grid of the given step: "1/1000", "0.001" or "1e-3" model units; positive.
  /// Errors: "bad-number".
  static Result<Grid> with_step(std::string_view step);
  /// A grid of the given step whose origin is (x, y, z), each a rational or decimal in model units.
  static Result<Grid> with_step_and_origin(std::string_view step, const std::array<std::string, 3>& origin);
  /// The default grid for a box in model units: the smallest power-of-two step at which it fits |i| <= 2^26; the
  /// origin is 0 unless the box lies far from it for its size, then a multiple of the step near its centre.
  /// Errors: "non-finite", "out-of-range".
  static Result<Grid> fitting(const std::array<double, 3>& low, const std::array<double, 3>& high);

  /// Model units per grid step, reduced "p/q" (or "p").
  std::string step() const;
  std::array<std::string, 3> origin() const;
  bool operator==(const Grid& other) const;

 private:
  friend struct Access;
  struct Data;
  std::shared_ptr<const Data> data_;
};

/// What import may take for granted.
enum class Trust {
  /// Prove that the surface does not cross itself; resolve it where it does.
  nothing,
  /// Skip that proof. An operand that does cross itself then gives an unspecified result, never a crash.
  embedded,
};

/// Called with a fraction in [0, 1] from the thread that called the operation.
using Progress = std::function<void(double)>;
/// Set to true, from any thread or signal handler, to make the operation return the error "cancelled".
using Cancel = std::atomic<bool>;

struct Options {
  Progress progress = {};
  const Cancel* cancel = nullptr;
  /// Called in the calling thread with the name of each stage as it begins; for profiles.
  std::function<void(const char*)> stage = {};
  /// Worker threads; 0 takes what the machine has. Results are the same bytes for any number.
  unsigned threads = 0;
};

struct ImportOptions {
  /// The grid to snap to; default: the one that fits the input.
  std::optional<Grid> grid = {};
  Trust trust = Trust::nothing;
  Options run = {};
};

/// What import did to the input. Counts are of points and triangles of the input.
struct ImportReport {
  /// The largest move of a point, model units.
  double max_snap = 0;
  /// Distinct input points that became one grid point.
  std::uint64_t merged_points = 0;
  /// Triangles of zero area after snapping: gone, their points now on their neighbours' edges.
  std::uint64_t zero_area_triangles = 0;
  /// Polygons that were not planar after snapping and were triangulated.
  std::uint64_t nonplanar_polygons = 0;
  /// Pairs of faces that crossed, overlapped or touched out of place, all resolved (inside is winding number > 0).
  std::uint64_t resolved_crossings = 0;
};

/// A triangle mesh as arrays: `points` is x, y, z per vertex in model units, `triangles` three vertex indices each,
/// counter-clockwise seen from outside.
struct Mesh {
  std::vector<double> points;
  std::vector<std::uint32_t> triangles;
};

enum class Topology {
  /// Vertices and edges where parts only touch are separated combinatorially: every edge has exactly two triangles.
  manifold,
  /// Vertices are shared wherever they coincide; an edge may carry 4, 6, ... triangles.
  indexed,
};

struct ExportOptions {
  Topology topology = Topology::manifold;
  /// Round coordinates to float32 (what binary STL stores) instead of double before the check.
  bool float32 = false;
  Options run = {};
};

/// What rounding to floating point did to the exported triangles.
struct ExportReport {
  std::uint64_t triangles = 0;
  /// Triangles whose rounded normal points against the exact one.
  std::uint64_t flipped = 0;
  /// Triangles whose rounded area is exactly zero.
  std::uint64_t collapsed = 0;
  /// Every directed edge of the written mesh is balanced by its reverse.
  bool closed = true;
};

/// Counts and measures of a solid in canonical form (see docs/overview.md); `triangles` alone counts what export
/// writes.
struct Info {
  std::uint64_t vertices = 0, edges = 0, faces = 0, triangles = 0;
  /// Connected components and genus of the separated (manifold) boundary.
  std::uint64_t shells = 0;
  std::int64_t genus = 0;
  bool closed = true, manifold = true, bounded = true;
  /// Exact, "p/q" in cubic model units; empty when unbounded.
  std::string volume;
  double volume_approx = 0, area_approx = 0;
  /// Low and high corner in model units; nothing when there is no boundary.
  std::optional<std::array<std::array<double, 3>, 2>> box = {};
};

/// Where a point lies.
enum class Location { inside, boundary, outside };

/// A closed regular point set bounded by finitely many plane faces; possibly empty, possibly unbounded.
class Solid {
 public:
  /// The empty solid on the default Grid.
  Solid();
  ~Solid();
  Solid(const Solid&);
  Solid(Solid&&) noexcept;
  Solid& operator=(const Solid&);
  Solid& operator=(Solid&&) noexcept;

  static Solid empty(const Grid& grid);
  /// All of space.
  static Solid full(const Grid& grid);

  /// A solid from a triangle mesh.
  /// `points`: 3 doubles per vertex, model units. `triangles`: 3 indices each, counter-clockwise from outside.
  /// The surface must be closed (every directed edge balanced by its reverse) and not inside out; it may overlap and
  /// touch itself. Errors: "open-boundary", "inside-out", "non-finite", "out-of-range", "bad-index", "cancelled".
  static Result<Solid> from_triangles(std::span<const double> points, std::span<const std::uint32_t> triangles,
                                      const ImportOptions& options = {}, ImportReport* report = nullptr);
  static Result<Solid> from_triangles(std::span<const double> points, std::span<const std::uint32_t> triangles,
                                      const Grid& grid);
  /// The same from polygons: polygon i has the corners `corners[starts[i]] .. corners[starts[i + 1] - 1]`.
  static Result<Solid> from_polygons(std::span<const double> points, std::span<const std::uint32_t> starts,
                                     std::span<const std::uint32_t> corners, const ImportOptions& options = {},
                                     ImportReport* report = nullptr);
  /// A solid from the text of a .quoin file (docs/format.md). Errors: "bad-quoin" with the line, or with the vertex or
  /// face that does not fit. `Trust::embedded` skips the proof that faces do not cross and bound a solid.
  static Result<Solid> from_quoin(std::string_view text, Trust trust = Trust::nothing);

  const Grid& grid() const;
  /// The same point set on another grid. Errors: "inexact-grid" (naming a step that would work), "out-of-range".
  Result<Solid> on_grid(const Grid& grid) const;

  bool is_empty() const;
  bool is_bounded() const;
  Info info(const Options& options = {}) const;
  /// Exact volume, "p/q" in cubic model units; nothing when unbounded.
  std::optional<std::string> volume() const;
  /// Exact, for any three finite doubles in model units.
  Location classify(const std::array<double, 3>& point) const;

  /// Triangles, correctly rounded. Errors: "unbounded", "out-of-range", "cancelled".
  Result<Mesh> to_triangles(const ExportOptions& options = {}, ExportReport* report = nullptr) const;
  /// The exact solid as text in canonical order: equal point sets on one grid give equal bytes.
  std::string to_quoin() const;
  /// Writes .stl, .obj, .off, .ply or .quoin, by the extension; the file appears whole or not at all.
  Result<void> write(const std::string& path, const ExportOptions& options = {}) const;

  /// The three operations, symmetric difference and complement; exact and total on one grid.
  /// Precondition: equal grids, otherwise std::invalid_argument.
  friend Solid operator+(const Solid& a, const Solid& b);
  friend Solid operator-(const Solid& a, const Solid& b);
  friend Solid operator&(const Solid& a, const Solid& b);
  friend Solid operator^(const Solid& a, const Solid& b);
  friend Solid operator~(const Solid& a);
  /// Equality of point sets, across grids too.
  friend bool operator==(const Solid& a, const Solid& b);

 private:
  friend struct Access;
  Solid(Grid grid, std::shared_ptr<const booleans::Body> body);
  Grid grid_;
  std::shared_ptr<const booleans::Body> body_;
};

/// A plane a x + b y + c z + d = 0 in model units; each coefficient a decimal or rational.
/// Above is where a x + b y + c z + d > 0.
struct HalfSpace {
  std::array<std::string, 4> plane;
};

/// A Boolean expression over solids, evaluated as one operation.
class Expression {
 public:
  Expression(const Solid& solid);           // NOLINT: implicit by design
  Expression(const HalfSpace& half_space);  // NOLINT: the points with a x + b y + c z + d <= 0
  static Expression union_of(std::vector<Expression> terms);
  static Expression intersection_of(std::vector<Expression> terms);
  /// Points in an odd number of terms.
  static Expression symmetric_difference_of(std::vector<Expression> terms);
  static Expression complement_of(Expression term);

  friend Expression operator+(Expression a, Expression b);
  friend Expression operator-(Expression a, Expression b);
  friend Expression operator&(Expression a, Expression b);
  friend Expression operator^(Expression a, Expression b);
  friend Expression operator~(Expression a);

 private:
  friend struct Access;
  struct Node;
  explicit Expression(std::shared_ptr<const Node> node);
  std::shared_ptr<const Node> node_;
};

/// Evaluates an expression in one arrangement. Operands of different grids go to the finest one if that is exact.
/// Errors: "inexact-grid", "cancelled", "inconsistent" (an operand trusted wrongly), "no-operand", "bad-plane".
Result<Solid> evaluate(const Expression& expression, const Options& options = {});
Result<Solid> unite(const std::vector<Solid>& solids, const Options& options = {});
Result<Solid> intersect(const std::vector<Solid>& solids, const Options& options = {});
/// `minuend` minus all of `subtrahends`.
Result<Solid> difference(const Solid& minuend, const std::vector<Solid>& subtrahends, const Options& options = {});
/// Points in an odd number of the solids.
Result<Solid> symmetric_difference(const std::vector<Solid>& solids, const Options& options = {});
/// The parts of `solid` above and below a plane. Errors: "bad-plane" (not a plane of the solid's grid).
Result<std::array<Solid, 2>> split(const Solid& solid, const HalfSpace& half_space, const Options& options = {});

/// File formats. `stl` and `ply` are the binary variants when written; reading takes either for either.
enum class Format { stl, stl_ascii, obj, off, ply, ply_ascii, quoin };

/// The format that the extension of a file name says (.stl, .obj, .off, .ply, .quoin; any case).
/// Errors: "unknown-format".
Result<Format> format_of(std::string_view file_name);

/// Polygons as arrays: `points` is x, y, z per vertex in model units, polygon i has the corners
/// `corners[starts[i]] .. corners[starts[i + 1] - 1]`, counter-clockwise seen from outside.
struct PolygonMesh {
  std::vector<double> points;
  std::vector<std::uint32_t> starts = {0};
  std::vector<std::uint32_t> corners;
};

/// What a file holds, parsed but not yet on a common grid.
struct Source {
  /// Names the file in errors.
  std::string name;
  /// As the file states it; empty when `exact` is set.
  PolygonMesh mesh = {};
  /// The solid of a .quoin file.
  std::optional<Solid> exact = {};
};

/// Reads and parses one file; "-" is standard input. Content decides the format where it can, then `format` if given,
/// then the extension. `trust` is for .quoin files; meshes are proved by `build`. Errors: "missing-file", "unreadable",
/// "unknown-format", "truncated", "bad-syntax", "bad-number", "non-finite", "bad-index", "absurd-count", "bad-quoin";
/// `file` is the path.
Result<Source> read_source(const std::string& path, std::optional<Format> format = {}, Trust trust = Trust::nothing);

/// Solids of sources on one common grid, in their order: `options.grid` if given, else that of the exact sources (the
/// finest one), else the one that fits all meshes together. Exact sources are re-expressed only where that is exact.
/// `reports`, when given, receives one report a source (all zero for an exact one).
/// Errors: those of `Solid::from_polygons`, "inexact-grid"; `file` is the source's name.
Result<std::vector<Solid>> build(std::vector<Source> sources, const ImportOptions& options = {},
                                 std::vector<ImportReport>* reports = nullptr);

/// A triangle mesh as the bytes of a file; decimals are the shortest that read back to the same double, and binary STL
/// rounds to float32 (see ExportOptions). Precondition: `format` is not Format::quoin (for which see Solid::to_quoin).
std::string to_bytes(const Mesh& mesh, Format format);

/// Writes a file that appears whole or not at all: written beside `path`, then renamed. "-" is standard output.
/// Errors: "unwritable"; `file` is the path.
Result<void> write_bytes(const std::string& path, std::string_view bytes);

/// Removes what an unfinished `write_bytes` or `Solid::write` has put on disk so far. Async-signal-safe: for a handler
/// that is about to end the process.
void abandon_temporary_files();

/// Reads files (.stl, .obj, .off, .ply, .quoin; content decides where it can) onto one common grid.
/// `reports`, when given, receives one report a file.
Result<std::vector<Solid>> read(const std::vector<std::string>& paths, const ImportOptions& options = {},
                                std::vector<ImportReport>* reports = nullptr);

/// How many signs each rung of the arithmetic decided since the process began.
struct Statistics {
  std::uint64_t symbolic = 0, filter = 0, fixed_width = 0, rational = 0;
};
Statistics statistics();

}  // namespace quoin

#include "quoin/model.h"
