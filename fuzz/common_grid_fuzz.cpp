/// \file
/// Laws of solids that meet on a common grid: of steps and origins that are rationals, of far places, sizes and long
/// numbers, through every door. All equalities are exact.
///
/// The first byte says how many operands there are; each is read as its grid, its shape and its motion.
#include <algorithm>
#include <span>

#include "api/access.h"
#include "api/doors/common_grid.h"
#include "booleans/resolve.h"
#include "exact/rational.h"
#include "fuzz/law.h"
#include "tests/booleans/shapes.h"
#include "tests/booleans/surface/position.h"

namespace quoin::fuzz {
namespace {

using booleans::testing::Vector;
using exact::Rational;
using Point = std::array<Rational, 3>;

std::string told(const Error& e) { return to_string(e.code) + ": " + e.message + " (" + e.where + ")"; }

template <class T>
T value_of(Result<T> result) {
  if (!result) fail("operations succeed:", told(result.error()));
  return std::move(result).value();
}

/// Reads any bytes; those that are missing count as 0.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::vector<Solid> read() {
    std::vector<Solid> solids(2 + next() % 3);
    for (Solid& s : solids) s = solid();
    return solids;
  }

 private:
  std::uint8_t next() { return at_ < bytes_.size() ? bytes_[at_++] : std::uint8_t{0}; }

  Grid grid() {
    static constexpr std::array<std::array<int, 2>, 12> odd{
        {{1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 1000}, {1, 3}, {1, 7}, {5, 1}, {3, 64}, {10, 1}, {25, 16}, {7, 9}}};
    const auto [p, q] = odd[next() % odd.size()];
    const int shift = next() % 41 - 20;
    grid::Lattice lattice{Rational(p, q) * power(2, shift)};
    const std::uint8_t b = next();
    if (b % 4 == 0) return Access::grid(lattice);
    // Whole steps, or third ones, near or far.
    const Rational unit = (b % 4 == 3 ? Rational(1, 3) : Rational(1)) * lattice.step * power(10, b / 4 % 12);
    for (Rational& x : lattice.origin) x = unit * (next() % 19 - 9);
    return Access::grid(lattice);
  }

  static Rational power(int base, int exponent) {
    Rational r = 1;
    for (int i = 0; i < std::abs(exponent); ++i) r *= base;
    return exponent < 0 ? Rational(1 / r) : r;
  }

  Vector point() {
    Vector v{};
    for (std::int64_t& x : v) x = next() % 9 - 4;
    return v;
  }

  booleans::Body shape() {
    using namespace booleans::testing;
    std::optional<booleans::Body> body;
    const std::uint8_t kind = next();
    if (kind % 4 == 0) {
      const std::array<Vector, 4> p{point(), point(), point(), point()};
      body = tetrahedron(p);
    } else if (kind % 4 == 1) {
      const Vector corner = point(), u = point(), v = point();
      body = block(corner, u, v, point());
    } else if (kind % 4 == 2) {
      const Vector centre = point(), u = point(), v = point();
      body = octahedron(centre, u, v, point());
    } else {
      body = l_shape({1 + kind / 4 % 2, 1 + kind / 8 % 2}, {3, 4}, -1, 1 + kind / 16 % 3);
    }
    return body ? std::move(*body) : box({-1, -2, -1}, {2, 1, 1});
  }

  /// Within 2^28 steps of the origin, and small or large.
  Solid at_rest() {
    const Grid where = grid();
    const booleans::Body small = shape();
    const std::int64_t factor = std::int64_t{1} << next() % 24;
    Vector origin = point();
    for (std::int64_t& x : origin) x <<= next() % 25;
    const auto mesh = booleans::testing::scaled(small, factor, origin);
    require(mesh.has_value(), "shapes fit the world");
    std::uint64_t crossings = 0;
    return Access::solid(where, value_of(booleans::resolve(*mesh, crossings)));
  }

  /// Turned about the middle of its box, by planes of 62 bits or by vertices.
  Solid solid() {
    Solid s = at_rest();
    const std::uint8_t b = next();
    if (b % 4 == 0) return s;
    const grid::ModelBox box = model_box(s);
    Text3 there, back;
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational middle = (box.low[k] + box.high[k]) / 2;
      there[k] = exact::to_string(middle);
      back[k] = exact::to_string(Rational(-middle));
    }
    const Vector axis = point();
    if (axis == Vector{}) return ~s;
    const auto turn = value_of(Motion::rotation(
        {std::to_string(axis[0]), std::to_string(axis[1]), std::to_string(axis[2])}, std::to_string(b)));
    const auto motion = value_of(Motion::translation(back)).then(turn).then(value_of(Motion::translation(there)));
    const auto turned = moved(s, motion, {.rounding = b % 4 == 3 ? Rounding::vertices : Rounding::best});
    return turned ? turned.value() : s;
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

Rational volume_of(const Solid& solid) { return *exact::parse_rational(*solid.volume()); }

using Corners = std::array<Point, 3>;

/// The triangles of a surface, in model units.
std::vector<Corners> triangles_of(const Solid& solid) {
  const booleans::Body& body = Access::body(solid);
  const booleans::Triangulated mesh = booleans::triangulated(body);
  const grid::Lattice& lattice = Access::lattice(solid);
  std::vector<Corners> triangles(mesh.triangle_count());
  for (std::size_t n = 0; n < triangles.size(); ++n)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto p = booleans::testing::position(body, mesh, mesh.triangle(n)[i]);
      for (std::size_t k = 0; k < 3; ++k) triangles[n][i][k] = lattice.origin[k] + lattice.step * p[k];
    }
  return triangles;
}

Point operator-(const Point& p, const Point& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }
Rational dot(const Point& p, const Point& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
Point cross(const Point& p, const Point& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

Rational squared_distance_to_edge(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a, to = p - a;
  const Rational place = std::clamp<Rational>(dot(along, to) / dot(along, along), 0, 1);
  const Point off{to[0] - place * along[0], to[1] - place * along[1], to[2] - place * along[2]};
  return dot(off, off);
}

Rational squared_distance(const Point& p, const Corners& t) {
  const Point normal = cross(t[1] - t[0], t[2] - t[0]);
  bool is_over = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point &a = t[k], &b = t[(k + 1) % 3];
    is_over = is_over && dot(cross(b - a, p - a), normal) >= 0;
  }
  if (is_over) {
    const Rational height = dot(p - t[0], normal);
    return height * height / dot(normal, normal);
  }
  return std::min({squared_distance_to_edge(p, t[0], t[1]), squared_distance_to_edge(p, t[1], t[2]),
                   squared_distance_to_edge(p, t[2], t[0])});
}

/// Whether all vertices of a surface lie within a distance of another one.
bool is_near(const std::vector<Corners>& from, const std::vector<Corners>& to, const Rational& squared) {
  return std::all_of(from.begin(), from.end(), [&](const Corners& t) {
    return std::all_of(t.begin(), t.end(), [&](const Point& p) {
      return std::any_of(to.begin(), to.end(), [&](const Corners& u) { return squared_distance(p, u) <= squared; });
    });
  });
}

/// A solid as it is carried to the common grid, and nothing where it is so exactly.
struct Carried {
  Solid solid;
  std::optional<Rounded> rounded = {};
};

std::vector<Carried> carried(const std::vector<Solid>& solids) {
  const CommonGrid common = common_grid(solids);
  std::vector<Carried> there;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (common.exact.empty() || common.exact[i]) {
      there.push_back({common.exact.empty() ? solids[i] : *common.exact[i]});
      continue;
    }
    const Rounded rounded = value_of(rounded_to(solids[i], common.grid, nullptr));
    there.push_back({rounded.solid, rounded});
  }
  return there;
}

/// Rounding moves every point of a surface by no more than it says, and that is little beside all solids together.
void check_movement(const std::vector<Solid>& solids, const std::vector<Carried>& there,
                    const OperationReport& report) {
  grid::ModelBox box;
  for (const Solid& s : solids) box.add(model_box(s));
  const Rational all = *exact::parse_rational(report.max_snap_bound);
  require(report.max_snap == exact::to_double(all), "both bounds of the report are one number");
  require(all == 0 || all * (1 << 28) < box.size(), "what is rounded moves by less than 2^-28 of the size of all");

  std::uint64_t rounded = 0;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (!there[i].rounded) {
      require(there[i].solid == solids[i], "what is carried exactly is the same solid");
      continue;
    }
    ++rounded;
    const Rounded& r = *there[i].rounded;
    require(r.displacement <= all, "the report's bound is that of all operands");
    require(8 * r.displacement <= 7 * Access::lattice(r.solid).step, "nothing moves by more than 7/8 of a step");
    const auto before = triangles_of(solids[i]), after = triangles_of(r.solid);
    const Rational squared = r.displacement * r.displacement;
    require(is_near(after, before, squared), "what is rounded lies within the bound of what was there");
    if (r.resolved_crossings == 0 && !r.vanished)
      require(is_near(before, after, squared), "what was there lies within the bound of what is rounded");
  }
  require(report.rounded_operands == rounded, "the report counts what is rounded");
  require(report.by_planes + report.by_vertices == rounded, "operands are rounded in one of two ways");
}

/// The second way to see that a grid is there: all own grids, and powers of two times the finest about the coarsest.
bool is_exact_somewhere(const std::vector<Solid>& solids) {
  std::vector<grid::Lattice> lattices;
  for (const Solid& s : solids) lattices.push_back(Access::lattice(s));
  const auto [finest, coarsest] = std::minmax_element(lattices.begin(), lattices.end(),
                                                      [](const auto& a, const auto& b) { return a.step < b.step; });
  grid::Lattice at{finest->step, coarsest->origin};
  const Rational most = coarsest->step * 8;
  for (; at.step <= most; at.step *= 2) lattices.push_back(at);
  return std::any_of(lattices.begin(), lattices.end(), [&](const grid::Lattice& lattice) {
    const Grid grid = Access::grid(lattice);
    return std::all_of(solids.begin(), solids.end(), [&](const Solid& s) { return s.on_grid(grid).has_value(); });
  });
}

/// Unions through every door are the same bytes.
void check_doors(const std::vector<Solid>& solids, const std::vector<Carried>& there, const std::string& expected) {
  std::vector<Solid> turned(solids.rbegin(), solids.rend());
  require(value_of(unite(turned)).to_quoin() == expected, "the order of operands changes nothing");
  std::rotate(turned.begin(), turned.begin() + 1, turned.end());
  std::vector<Expression> terms(turned.begin(), turned.end());
  require(value_of(evaluate(Expression::unite(terms))).to_quoin() == expected, "expressions are put together alike");

  Solid folded = there[0].solid;
  for (std::size_t i = 1; i < there.size(); ++i) folded = folded + there[i].solid;
  require(folded.to_quoin() == expected, "operands that were carried are combined alike");
  if (solids.size() == 2) require((solids[1] + solids[0]).to_quoin() == expected, "operators are put together alike");

  std::vector<Source> sources;
  for (const Solid& s : solids) sources.push_back({.name = "s", .exact = s});
  require(value_of(unite(value_of(build(sources)))).to_quoin() == expected, "files are put together alike");

  std::vector<Model> models;
  for (const Solid& s : solids) models.push_back(Model::solid(s));
  require(value_of(evaluate(Model::unite(models))).to_quoin() == expected, "models are put together alike");
}

void check_booleans(const std::vector<Solid>& solids, const std::vector<Carried>& there) {
  const Solid &a = there[0].solid, &b = there[1].solid;
  const std::vector<Solid> two{solids[0], solids[1]};
  if (there.size() == 2) {
    require(value_of(intersect(two)).to_quoin() == (a & b).to_quoin(), "intersections are those of what was carried");
    require((solids[0] - solids[1]).to_quoin() == (a - b).to_quoin(), "differences are those of what was carried");
  }
  require((a - b) + (a & b) == a, "difference and intersection make the whole");
  require(((a ^ b) ^ b) == a, "symmetric differences undo each other");
  require(~(~a & ~b) == a + b, "complements turn intersections into unions");
  if (a.is_bounded() && b.is_bounded())
    require(volume_of(a) + volume_of(b) == volume_of(a + b) + volume_of(a & b), "volumes add up");
}

void run(std::span<const std::uint8_t> bytes) {
  const std::vector<Solid> solids = Reader(bytes).read();
  const std::vector<Carried> there = carried(solids);
  OperationReport report;
  const Solid all = value_of(unite(solids, {}, &report));
  const std::string text = all.to_quoin();
  require(value_of(Solid::from_quoin(text)) == all, "results are valid solids");

  check_movement(solids, there, report);
  const bool is_exact = report.rounded_operands == 0;
  require(is_exact || !is_exact_somewhere(solids), "where a grid holds all operands, none is rounded");
  const auto refused = unite(solids, {.grid_rule = GridRule::exact});
  require(refused.has_value() == is_exact, "the exact rule refuses what would be rounded");
  if (!refused) require(refused.error().code == ErrorCode::inexact_grid, "and says so:", told(refused.error()));

  check_doors(solids, there, text);
  check_booleans(solids, there);
}

}  // namespace
}  // namespace quoin::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  quoin::fuzz::run({data, size});
  return 0;
}
