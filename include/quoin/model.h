/// \file
/// Models: construction histories of primitives, motions and Booleans.
///
/// Numbers are text: a decimal ("-1.25e-3"), a rational ("1/3") or a formula over the model's parameters
/// ("2 * (width + 1) / 3"). They are read exactly, when the model is evaluated. Lengths are in model units, angles in
/// degrees, right-handed.
#pragma once

#include "quoin/export.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "quoin/format.h"
#include "quoin/grid.h"
#include "quoin/import.h"
#include "quoin/limits.h"
#include "quoin/motion.h"
#include "quoin/options.h"
#include "quoin/repair.h"
#include "quoin/result.h"
#include "quoin/solid.h"

namespace quoin {

/// How a polygon approximates a circle: with its corners on it, its sides touching it, or the same area.
enum class Fit { inscribed, circumscribed, equal_area };

/// A file that a model's text names, what import did to its mesh (all zero for an exact solid), and the unit of its
/// numbers.
struct MeshImport {
  std::string file;
  ImportReport report;
  Unit unit = Unit::none;
};

struct ModelOptions {
  /// The grid of the result. Default: the model's, else the common grid of its solids and of the box of its primitives
  /// (docs/doors.md), without solids one that fits the primitives. Solids are rounded to a grid that nobody asked for,
  /// where they have to be, and counted among the primitives of the report.
  std::optional<Grid> grid = {};
  /// Values of parameters, instead of their defaults. A name that the model does not know is "bad-parameter".
  std::map<std::string, std::string> parameters = {};
  Rounding rounding = Rounding::best;
  Options run = {};
  Limits limits = {};
};

/// Which files a model's text may name.
enum class ModelFiles {
  /// Those in its folder and below, wherever links lead: a model of a stranger opens nothing else.
  below,
  anywhere,
};

struct ModelReadOptions {
  ModelFiles files = ModelFiles::below;
  /// What the numbers of files are converted to that state another unit (quoin/files.h, `read_source`). Without it
  /// files that state different units are refused. Numbers of the model are in it, or in the unit of the files.
  std::optional<Unit> unit = {};
  /// Cures of the meshes that the text names; none by default.
  Repair repair = {};
  Limits limits = {};
};

/// A construction history: an immutable graph of primitives, motions and Booleans whose subtrees may be shared.
/// Nothing is computed, and no number read, before it is evaluated.
class QUOIN_API Model {
 public:
  /// The empty set.
  Model();
  ~Model();
  Model(const Model&);
  Model(Model&&) noexcept;
  Model& operator=(const Model&);
  Model& operator=(Model&&) noexcept;

  /// [0, a] x [0, b] x [0, c].
  static Model block(const Text3& size);
  /// A block's base, and above its middle an edge of length `top` along x at height c.
  static Model wedge(const Text3& size, const std::string& top);
  /// About the z-axis, from z = 0 up; its corners lie on a circle.
  static Model prism(const std::string& sides, const std::string& radius, const std::string& height);
  static Model cylinder(const std::string& radius, const std::string& height, const std::string& sides = "64",
                        Fit fit = Fit::inscribed);
  static Model frustum(const std::string& bottom, const std::string& top, const std::string& height,
                       const std::string& sides = "64", Fit fit = Fit::inscribed);
  static Model cone(const std::string& radius, const std::string& height, const std::string& sides = "64",
                    Fit fit = Fit::inscribed);
  /// About the origin, with vertices on the sphere; `sides` meridians (even) and half as many bands.
  static Model sphere(const std::string& radius, const std::string& sides = "64");
  /// About the origin, with so many planes that touch the sphere: it stays flat-faced under motions.
  static Model tangent_sphere(const std::string& radius, const std::string& planes = "200");
  /// About the z-axis.
  static Model torus(const std::string& major, const std::string& minor, const std::string& sides = "64",
                     const std::string& minor_sides = "32");
  /// The points with a x + b y + c z + d <= 0.
  static Model half_space(const std::array<std::string, 4>& plane);
  /// The intersection of half-spaces; it must be bounded.
  static Model convex(const std::vector<std::array<std::string, 4>>& planes);
  /// The convex hull of points.
  static Model hull(const std::vector<Text3>& points);
  /// Polygons of the plane z = 0 (each an outline, then its holes; any orientation), swept along a vector.
  using Outline = std::vector<std::array<std::string, 2>>;
  static Model extrusion(const std::vector<std::vector<Outline>>& polygons, const Text3& along);
  /// Any solid; without history it is itself one primitive.
  static Model solid(const Solid& solid);

  /// This model moved; the numbers are formulas of the model's parameters.
  Model rotated(const Text3& axis, const std::string& degrees) const;
  Model translated(const Text3& by) const;
  Model turned(const std::array<std::string, 4>& wxyz) const;
  Model transformed(const std::array<Text3, 3>& rows) const;
  Model mirrored(const Text3& normal) const;
  Model scaled(const Text3& by) const;
  /// The same model under a name, which errors and files carry.
  Model named(const std::string& name) const;
  /// With defaults for the parameters that formulas below name, and perhaps a grid step.
  Model with_parameters(const std::map<std::string, std::string>& defaults) const;
  Model with_step(const std::string& step) const;

  static Model unite(std::vector<Model> terms);
  static Model intersect(std::vector<Model> terms);
  /// The first minus all others.
  static Model difference(Model minuend, std::vector<Model> subtrahends);
  /// Points in an odd number of terms.
  static Model symmetric_difference(std::vector<Model> terms);
  static Model complement(Model term);
  friend QUOIN_API Model operator+(Model a, Model b);
  friend QUOIN_API Model operator-(Model a, Model b);
  friend QUOIN_API Model operator&(Model a, Model b);
  friend QUOIN_API Model operator^(Model a, Model b);
  friend QUOIN_API Model operator~(Model a);

  /// The model as JSON text (docs/model-format.md), without loss: shared subtrees stay shared.
  std::string to_json() const;
  /// Meshes that the text names are read relative to `folder`; `imports`, when given, receives each of their files
  /// once, in the order of the text: one that is refused is the last, with what is wrong with it. Errors: "bad-model"
  /// (`where` is "line L, column C"), "too-large", "mixed-units", and those of `read`.
  static Result<Model> from_json(std::string_view text, const std::string& folder = ".",
                                 std::vector<MeshImport>* imports = nullptr, const ModelReadOptions& options = {});
  /// A file of such text, whose meshes are beside it; "-" is standard input. Errors: those of `from_json` and `read`,
  /// naming the file.
  static Result<Model> read(const std::string& path, std::vector<MeshImport>* imports = nullptr,
                            const ModelReadOptions& options = {});

 private:
  friend struct Access;
  struct Node;
  explicit Model(std::shared_ptr<const Node> node);
  std::shared_ptr<const Node> node_;
};

/// Every primitive is moved by all motions above it at once, exactly, and rounded once; then one Boolean of all.
/// Errors: "bad-number", "bad-parameter", "bad-primitive", "bad-axis", "bad-factor", "not-a-rotation", "unbounded",
/// "too-large"; those of `moved` and `evaluate`. `where` names the node.
QUOIN_API Result<Solid> evaluate(const Model& model, const ModelOptions& options = {}, MotionReport* report = nullptr);

}  // namespace quoin
