/// \file
/// Motions that compose exactly, and models: construction histories of primitives, motions and Booleans.
/// Part of quoin/quoin.h.
///
/// Numbers are text: a decimal ("-1.25e-3"), a rational ("1/3") or, in a Model, a formula over its parameters
/// ("2 * (width + 1) / 3"). They are read exactly, when the model is evaluated. Lengths are in model units, angles in
/// degrees, right-handed.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "quoin/quoin.h"
#include "quoin/result.h"

namespace quoin {

using Text3 = std::array<std::string, 3>;

/// How planes are rounded after a motion (docs/motions.md).
enum class Rounding {
  best,                // a function of the moved plane alone; the closest direction of the next three
  naive,               // every coefficient to the nearest integer
  continued_fraction,  // ratios by continued fractions
  lattice,             // direction by lattice reduction
  face_local,          // least movement of the faces' own vertices
  vertices,            // no planes: every vertex to the nearest grid point
};

/// What a motion amounts to.
struct MotionInfo {
  /// The rotation carried out, as integers w, x, y, z; nothing when the motion mirrors or scales.
  std::optional<std::array<std::string, 4>> quaternion;
  /// The exact linear part carried out (rows) and the translation after it, model units.
  std::array<Text3, 3> linear;
  Text3 shift;
  /// An upper bound of the sum of the differences between the stated angles and those carried out, degrees.
  double angle_error = 0;
};

/// A motion: rotations, translations, mirror images and scalings in a row, composed exactly. Angles about one axis that
/// follow each other are added as they were stated, so 360 rotations by 1 degree are the identity, as is a motion
/// followed by its inverse. An immutable value.
class Motion {
 public:
  /// The identity.
  Motion();
  ~Motion();
  Motion(const Motion&);
  Motion& operator=(const Motion&);

  /// About an axis through the origin. Where tan(angle / 2) / |axis| is irrational the closest fraction replaces it,
  /// with an error of the angle below 2^-86 degrees. Errors: "bad-number", "bad-axis" (no direction).
  static Result<Motion> rotation(const Text3& axis, std::string_view degrees);
  /// Errors: "bad-number".
  static Result<Motion> translation(const Text3& by);
  /// By a rational rotation: w + x i + y j + z k turns by 2 atan(|(x, y, z)| / w) about (x, y, z).
  /// Errors: "bad-number", "bad-axis" (all are 0).
  static Result<Motion> quaternion(const std::array<std::string, 4>& wxyz);
  /// By the rotation that a matrix is (rows), or else by the nearest rational one; `deviation` receives the largest
  /// difference of two entries. Errors: "bad-number", "not-a-rotation" (m m^T differs from 1 by more than 1e-6, or the
  /// determinant is negative).
  static Result<Motion> matrix(const std::array<Text3, 3>& rows, double* deviation = nullptr);
  /// The mirror image in the plane through the origin with this normal. Errors: "bad-number", "bad-axis".
  static Result<Motion> mirror(const Text3& normal);
  /// From the origin, by positive factors along x, y and z. Errors: "bad-number", "bad-factor".
  static Result<Motion> scaling(const Text3& by);

  /// This, then `next`.
  Motion then(const Motion& next) const;
  Motion inverse() const;
  MotionInfo info() const;
  /// Of what was stated, in lowest terms.
  friend bool operator==(const Motion& a, const Motion& b);

 private:
  friend struct Access;
  struct Data;
  explicit Motion(std::shared_ptr<const Data> data);
  std::shared_ptr<const Data> data_;  // nullptr: the identity
};

/// What rounding did to moved primitives.
struct MotionReport {
  /// An upper bound of the distance of any point of a primitive's surface from where the stated motion has it: what
  /// rotations by approximated angles and what rounding add. Exact, "p/q" in model units. Half-spaces do not count.
  std::string displacement_bound = "0";
  /// The same, rounded up.
  double displacement = 0;
  /// An upper bound of the differences between stated and realized angles; the largest of all primitives; degrees.
  double angle_error = 0;
  /// Primitives placed; those whose faces stayed flat (plane by plane); those rounded vertex by vertex.
  std::uint64_t primitives = 0, by_planes = 0, by_vertices = 0;
  /// Distinct planes of the former, those that needed no rounding, and those rounded face_local for a condition.
  std::uint64_t planes = 0, exact_planes = 0, face_local_planes = 0;
  /// Of primitives rounded vertex by vertex, as in ImportReport.
  std::uint64_t merged_points = 0, zero_area_triangles = 0, resolved_crossings = 0;
};

struct MoveOptions {
  Rounding rounding = Rounding::best;
  Options run = {};
};

/// A solid moved on its own grid. Where every moved plane is one of the grid's, exactly; else plane by plane if every
/// vertex lies on three planes and every edge on two faces, so that flat faces stay flat, else vertex by vertex.
/// Errors: "out-of-range" (naming the step that would do), "inconsistent-motion" (no rounding keeps the shape; naming
/// the vertex and the face), "cancelled".
Result<Solid> move(const Solid& solid, const Motion& motion, const MoveOptions& options = {},
                   MotionReport* report = nullptr);

/// How a polygon approximates a circle: with its corners on it, its sides touching it, or the same area.
enum class Fit { inscribed, circumscribed, equal_area };

struct ModelOptions {
  /// The grid of the result. Default: the model's, else the finest of its solids, else one that fits the primitives.
  std::optional<Grid> grid = {};
  /// Values of parameters, instead of their defaults. A name that the model does not know is "bad-parameter".
  std::map<std::string, std::string> parameters = {};
  Rounding rounding = Rounding::best;
  Options run = {};
};

/// A construction history: an immutable graph of primitives, motions and Booleans whose subtrees may be shared.
/// Nothing is computed, and no number read, before it is evaluated.
class Model {
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

  static Model union_of(std::vector<Model> terms);
  static Model intersection_of(std::vector<Model> terms);
  static Model symmetric_difference_of(std::vector<Model> terms);
  /// The first minus all others.
  static Model difference_of(std::vector<Model> terms);
  static Model complement_of(Model term);
  friend Model operator+(Model a, Model b);
  friend Model operator-(Model a, Model b);
  friend Model operator&(Model a, Model b);
  friend Model operator^(Model a, Model b);
  friend Model operator~(Model a);

  /// The model as JSON text (docs/model-format.md), without loss: shared subtrees stay shared.
  std::string to_json() const;
  /// Meshes that the text names are read relative to `folder`. Errors: "bad-model" (`where` is "line L, column C"), and
  /// those of `read`.
  static Result<Model> from_json(std::string_view text, const std::string& folder = ".");
  /// A file of such text, whose meshes are beside it; "-" is standard input. Errors: those of `from_json` and `read`,
  /// naming the file.
  static Result<Model> read(const std::string& path);

 private:
  friend struct Access;
  struct Node;
  explicit Model(std::shared_ptr<const Node> node);
  std::shared_ptr<const Node> node_;
};

/// Every primitive is moved by all motions above it at once, exactly, and rounded once; then one Boolean of all.
/// Errors: "bad-number", "bad-parameter", "bad-primitive", "bad-axis", "bad-factor", "not-a-rotation", "unbounded";
/// those of `move` and `evaluate`. `where` names the node.
Result<Solid> evaluate(const Model& model, const ModelOptions& options = {}, MotionReport* report = nullptr);

/// Versions of a model as a tree: a change after an undo begins a new branch and nothing is lost.
/// A version's index is (depth, order): the root has depth 0, a child one more than its parent; order counts the
/// versions of one depth in the order in which they were made, from 0.
class History {
 public:
  struct Index {
    std::uint32_t depth = 0, order = 0;
    friend bool operator==(const Index&, const Index&) = default;
    friend auto operator<=>(const Index&, const Index&) = default;
  };
  struct Version {
    Index index;
    std::optional<Index> parent;
    std::string name;
    Model model;
  };

  explicit History(Model root, std::string name = {});
  /// Makes a version after the current one and goes there. A name may be given to several: the last one counts.
  Index add(Model model, std::string name = {});
  const Version& current() const;
  /// To the parent; false at the root.
  bool undo();
  /// To the child that an undo left last or, if none did since, that was made last; false where there is no child.
  bool redo();
  /// False where there is no such version.
  bool go_to(Index index);
  bool go_to(std::string_view name);
  /// All versions in the order in which they were made.
  const std::vector<Version>& versions() const { return versions_; }

 private:
  std::vector<Version> versions_;
  std::vector<std::size_t> parent_, redo_;
  std::vector<std::uint32_t> count_;  // by depth
  std::size_t current_ = 0;
};

}  // namespace quoin
