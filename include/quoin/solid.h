/// \file
/// Solids: what they are made from, what they answer, what they become, and the operations.
#pragma once

#include "quoin/export.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "quoin/arrays.h"
#include "quoin/grid.h"
#include "quoin/import.h"
#include "quoin/options.h"
#include "quoin/report.h"
#include "quoin/result.h"
#include "quoin/triangles.h"

namespace quoin {

namespace booleans {
struct Body;
}

class Boundary;
struct ExactPolygons;

/// A box by its low and high corner, model units.
using Box = std::array<std::array<double, 3>, 2>;

/// Of a solid in canonical form (see docs/overview.md).
struct Counts {
  std::uint64_t vertices = 0, edges = 0, faces = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
};

/// Counts and measures of a solid in canonical form (see docs/overview.md); `triangles` alone counts what export
/// writes.
struct Info {
  std::uint64_t vertices = 0, edges = 0, faces = 0, triangles = 0;
  /// Connected components and genus of the separated (manifold) boundary.
  std::uint64_t shells = 0;
  std::int64_t genus = 0;
  bool closed = true, manifold = true, bounded = true;
  /// Exact, "p/q" in cubic model units; empty when unbounded, not asked for, or long (Volume::exact_if_short).
  std::string volume;
  double volume_approx = 0;  // correctly rounded
  double area_approx = 0;
  /// Of the boundary; nothing when there is none.
  std::optional<Box> box = {};
};

/// What `Info` says of the volume: everything, or what rounding leaves of it, or everything where that takes little
/// time. The exact volume of a solid of 100,000 faces may have millions of digits and take seconds.
enum class Volume { exact, rounded, exact_if_short };

/// Where a point lies.
enum class Location { inside, boundary, outside };

/// The faces of a boundary: those of the point set, or cut where what they carry changes (quoin/labels.h).
enum class Faces { maximal, by_label };

/// A closed regular point set bounded by finitely many plane faces; possibly empty, possibly unbounded.
class QUOIN_API Solid {
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
  /// `points`: 3 doubles or floats per vertex, model units. `triangles`: 3 indices each, unsigned or signed,
  /// counter-clockwise from outside.
  /// The surface must be closed (every directed edge balanced by its reverse) and not inside out; it may overlap and
  /// touch itself. No triangles, whatever the points, are the empty solid; triangles of which none has an area are
  /// "no-faces". Errors: that, "open-boundary", "inside-out", "non-finite", "out-of-range", "bad-index", "too-large",
  /// "cancelled".
  static Result<Solid> from_triangles(Coordinates points, Indices triangles, const ImportOptions& options = {},
                                      ImportReport* report = nullptr);
  static Result<Solid> from_triangles(Coordinates points, Indices triangles, const Grid& grid);
  /// The same from polygons: polygon i has the corners `corners[starts[i]] .. corners[starts[i + 1] - 1]`.
  static Result<Solid> from_polygons(Coordinates points, Indices starts, Indices corners,
                                     const ImportOptions& options = {}, ImportReport* report = nullptr);
  /// A solid from the text of a .quoin file (docs/format.md). Errors: "bad-quoin" with the line, or with the vertex or
  /// face that does not fit. `Trust::embedded` skips the proof that faces do not cross and bound a solid.
  static Result<Solid> from_quoin(std::string_view text, Trust trust = Trust::nothing);
  /// A solid from its exact boundary as arrays (quoin/boundary.h), checked as the text of a .quoin file is: faces must
  /// be maximal; their order, and that of vertices and loops, is free. Errors: "bad-number", "bad-index", "bad-quoin";
  /// `where` is the vertex or face.
  static Result<Solid> from_boundary(const ExactPolygons& polygons, Trust trust = Trust::nothing);

  const Grid& grid() const;
  /// The same point set on another grid. Errors: "inexact-grid" (naming a step that would work), "out-of-range";
  /// `where` is a vertex or a face that does not fit, by its coordinates.
  Result<Solid> on_grid(const Grid& grid) const;

  bool is_empty() const;
  bool is_bounded() const;
  /// Everything that can be counted or measured at once. `surface`: what an export of this very solid counted; given
  /// that, nothing is triangulated.
  Info info(const Options& options = {}, const SurfaceCounts* surface = nullptr, Volume volume = Volume::exact) const;
  /// Those of `info`, each by itself: these need no triangulation.
  std::optional<Box> box() const;
  Counts counts() const;
  /// Square model units, computed in doubles.
  double area() const;
  /// Exact volume, "p/q" in cubic model units; nothing when unbounded.
  std::optional<std::string> volume() const;
  /// Exact, for any three finite doubles in model units.
  Location classify(const std::array<double, 3>& point) const;

  /// The exact boundary in canonical order (quoin/boundary.h); made anew at each call.
  Boundary boundary(Faces faces = Faces::maximal) const;
  /// Triangles, correctly rounded, and mended where that is not valid (ExportOptions::validity). `report` and
  /// `surface`, when given, receive what else there is to say of them.
  /// Errors: "unbounded", "out-of-range", "cancelled".
  Result<Mesh> to_triangles(const ExportOptions& options = {}, ExportReport* report = nullptr,
                            SurfaceCounts* surface = nullptr) const;
  /// The exact solid as text in canonical order: equal point sets on one grid give equal bytes.
  std::string to_quoin() const;
  /// Writes .stl, .obj, .off, .ply or .quoin, by the extension; the file appears whole or not at all.
  /// Errors: those of `to_triangles` and `write_bytes`, "unknown-format".
  Result<void> write(const std::string& path, const ExportOptions& options = {}) const;

  /// The three operations, symmetric difference and complement; exact and total on one grid. Operands of different
  /// grids are put on a common one, as by the named functions below, whose report says what that took.
  /// What those return as an error is thrown as `Exception`: an operand that was trusted wrongly ("inconsistent").
  friend QUOIN_API Solid operator+(const Solid& a, const Solid& b);
  friend QUOIN_API Solid operator-(const Solid& a, const Solid& b);
  friend QUOIN_API Solid operator&(const Solid& a, const Solid& b);
  friend QUOIN_API Solid operator^(const Solid& a, const Solid& b);
  friend QUOIN_API Solid operator~(const Solid& a);
  /// Equality of point sets, across grids too.
  friend QUOIN_API bool operator==(const Solid& a, const Solid& b);

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

/// Operands of any grids go to a common one, a function of the operands as a set: exact where one is found on which all
/// are; else what is not exact is rounded once, by less than 2^-28 of the size of all operands together
/// (docs/doors.md). `report`, when given, receives what was rounded.
/// Errors of all: "cancelled", "inconsistent" (an operand trusted wrongly); with GridRule::exact "inexact-grid",
/// `where` being the number of the operand, "operand 3", from 0; of no operands, "no-operand".
QUOIN_API Result<Solid> unite(const std::vector<Solid>& solids, const Options& options = {},
                              OperationReport* report = nullptr);
QUOIN_API Result<Solid> intersect(const std::vector<Solid>& solids, const Options& options = {},
                                  OperationReport* report = nullptr);
/// `minuend` minus all of `subtrahends`.
QUOIN_API Result<Solid> difference(const Solid& minuend, const std::vector<Solid>& subtrahends,
                                   const Options& options = {}, OperationReport* report = nullptr);
/// Points in an odd number of the solids.
QUOIN_API Result<Solid> symmetric_difference(const std::vector<Solid>& solids, const Options& options = {},
                                             OperationReport* report = nullptr);
/// The points outside, and the boundary.
QUOIN_API Solid complement(const Solid& solid);
/// The parts of `solid` above and below a plane. One whose numbers are longer than the grid's planes, as from floating
/// point, is rounded, and reported. Errors: "bad-plane" (no normal, no numbers, too far away; with GridRule::exact also
/// one that would be rounded).
QUOIN_API Result<std::array<Solid, 2>> split(const Solid& solid, const HalfSpace& half_space,
                                             const Options& options = {}, OperationReport* report = nullptr);

}  // namespace quoin
