// Compares Booleans with the exact Nef polyhedra of CGAL: the symmetric difference of both results is empty.
// Arguments: the number of random pairs (each is one case a binary operation); QUOIN_SEED as in all random tests.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>

#include <set>

#include "booleans/surface/separated.h"
#include "grid/lists/partition.h"
#include "tests/booleans/support.h"
#include "tests/booleans/surface/position.h"

namespace quoin::booleans::testing {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Surface = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Point = Kernel::Point_3;

Kernel::FT number(const exact::Integer& v) {
  exact::Integer rest = abs(v);
  std::vector<double> limbs;
  for (; rest != 0; rest >>= 32) limbs.push_back(static_cast<double>(static_cast<std::uint32_t>(rest & 0xFFFFFFFFu)));
  Kernel::FT r = 0;
  while (!limbs.empty()) {
    r = r * Kernel::FT(4294967296.0) + Kernel::FT(limbs.back());
    limbs.pop_back();
  }
  return v < 0 ? Kernel::FT(-r) : r;
}
Kernel::FT number(const exact::Rational& v) { return number(numerator(v)) / number(denominator(v)); }
Point point(const RationalPoint& p) { return {number(p[0]), number(p[1]), number(p[2])}; }

struct Mesh {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

class Builder : public CGAL::Modifier_base<Surface::HalfedgeDS> {
 public:
  explicit Builder(const Mesh& mesh) : mesh_(mesh) {}
  void operator()(Surface::HalfedgeDS& surface) override {
    CGAL::Polyhedron_incremental_builder_3<Surface::HalfedgeDS> builder(surface, true);
    builder.begin_surface(mesh_.points.size(), mesh_.triangles.size());
    for (const Point& p : mesh_.points) builder.add_vertex(p);
    for (const Triangle& t : mesh_.triangles) builder.add_facet(t.begin(), t.end());
    builder.end_surface();
  }

 private:
  const Mesh& mesh_;
};

Nef nef_of_surface(const Mesh& mesh) {
  Surface surface;
  Builder builder(mesh);
  surface.delegate(builder);
  return Nef(surface);
}

/// The cones from one point over the triangles: odd parity is what they enclose.
Nef nef_of_cones(const Mesh& mesh) {
  const Point apex = mesh.points[mesh.triangles[0][0]];
  Nef sum;
  for (const Triangle& t : mesh.triangles) {
    std::array<Point, 4> p{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], apex};
    const auto side = CGAL::orientation(p[0], p[1], p[2], p[3]);
    if (side == CGAL::COPLANAR) continue;
    if (side == CGAL::NEGATIVE) std::swap(p[1], p[2]);
    Surface tetrahedron;
    tetrahedron.make_tetrahedron(p[0], p[1], p[2], p[3]);
    sum = sum.symmetric_difference(Nef(tetrahedron));
  }
  return sum;
}

/// A bounded body, shell by shell; a point is inside when an odd number of shells enclose it.
Nef nef(const Body& body) {
  const Triangulated mesh = separated(body, triangulated(body));
  grid::Partition parts(mesh.vertex_count());
  for (std::size_t n = 0; n < mesh.triangle_count(); ++n) {
    const auto t = mesh.triangle(n);
    parts.unite(t[0], t[1]);
    parts.unite(t[0], t[2]);
  }
  std::map<std::uint32_t, std::vector<Triangle>> shells;
  for (std::size_t n = 0; n < mesh.triangle_count(); ++n)
    shells[parts.find(mesh.triangle(n)[0])].push_back(mesh.triangle(n));
  Nef sum;
  for (const auto& [root, triangles] : shells) {
    Mesh shell;
    std::map<std::uint32_t, std::uint32_t> ids;
    std::set<RationalPoint> places;
    for (const Triangle& t : triangles) {
      Triangle local{};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [at, fresh] = ids.try_emplace(t[i], static_cast<std::uint32_t>(ids.size()));
        if (fresh) {
          const RationalPoint place = position(body, mesh, t[i]);
          shell.points.push_back(point(place));
          places.insert(place);
        }
        local[i] = at->second;
      }
      shell.triangles.push_back(local);
    }
    // A shell that touches itself is no manifold as a point set.
    const bool simple = places.size() == shell.points.size();
    sum = sum.symmetric_difference(simple ? nef_of_surface(shell) : nef_of_cones(shell));
  }
  return sum;
}

/// Equal up to points of no volume, which is all that regular sets can differ in when their interiors agree.
bool agree(const Body& ours, const Nef& theirs) { return nef(ours).symmetric_difference(theirs).interior().is_empty(); }

int run(std::uint64_t pairs) {
  // Mostly where things coincide.
  static constexpr std::array<Family, 10> worlds{Family::tiny,    Family::lattice, Family::tiny,    Family::skew,
                                                 Family::lattice, Family::far,     Family::lattice, Family::world,
                                                 Family::lattice, Family::skew};
  std::uint64_t cases = 0, wrong = 0, undecided = 0;
  const auto expect = [&](bool right, const char* operation, Family family, std::uint64_t i) {
    ++cases;
    if (right) return;
    ++wrong;
    std::printf("%s differs from CGAL: %s, %s\n", operation, name_of(family), case_name(i).c_str());
  };
  for (std::uint64_t i = 0; i < pairs; ++i) {
    const Family family = i % 40 == 39 ? Family::spheres : worlds[i % worlds.size()];
    Random random(900, i);
    Solids solids(random, family);
    const Body a = solids.next(), b = solids.next();
    try {
      const Nef na = nef(a), nb = nef(b);
      expect(agree(any(a, b), na + nb), "union", family, i);
      expect(agree(all(a, b), na * nb), "intersection", family, i);
      expect(agree(minus(a, b), na - nb), "difference", family, i);
      expect(agree(odd(a, b), na.symmetric_difference(nb)), "symmetric difference", family, i);
    } catch (const CGAL::Failure_exception& failure) {
      ++undecided;
      std::printf("CGAL gives up: %s, %s: %s\n", name_of(family), case_name(i).c_str(), failure.expression().c_str());
    }
  }
  // The comparison sees a missing unit cell.
  const Body block = box({0, 0, 0}, {3, 3, 3}), notched = minus(block, box({0, 0, 0}, {1, 1, 1}));
  expect(!agree(notched, nef(block)), "the self-check", Family::lattice, 0);
  const auto n = [](std::uint64_t x) { return static_cast<unsigned long long>(x); };
  std::printf("%llu cases, %llu wrong, %llu pairs undecided\n", n(cases), n(wrong), n(undecided));
  // Nef polyhedra of sums of touching shells break an assertion of CGAL's once in some hundred pairs.
  return wrong == 0 && 25 * undecided <= pairs ? 0 : 1;
}

}  // namespace
}  // namespace quoin::booleans::testing

int main(int count, char** arguments) {
  return quoin::booleans::testing::run(count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 150);
}
