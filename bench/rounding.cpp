/// \file
/// How far each method of rounding moves faces, and how far it turns their planes, against the bound L of the
/// coefficients: the table of docs/motions.md.
/// Entries are log2 of grid steps, mean and worst, and log2 of the worst angle in radians.
///
/// usage: quoin-rounding [FACES] (300 of each kind)
/// A face is a random triangle on a plane that a random rational rotation has carried away from the grid. The world
/// shrinks with L as the square root, as it does for L = 2^62: 2^29.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#include "rounding/motions/quaternion.h"
#include "rounding/planes/plane_rounding.h"

namespace {

using namespace quoin::rounding;

struct Kind {
  const char* name;
  int size, place;  // of the face and of its place: 2^-size, 2^-place of the world; place 0 is the origin
};
constexpr Kind kinds[] = {{"large, at the origin", 1, 0}, {"small, at the origin", 7, 0}, {"small, far away", 7, 1}};
constexpr std::pair<const char*, Method> methods[] = {{"naive", Method::naive},
                                                      {"continued-fraction", Method::continued_fraction},
                                                      {"lattice", Method::lattice},
                                                      {"best", Method::best},
                                                      {"face-local", Method::face_local}};

struct Face {
  WidePlane plane;
  std::vector<Vector> points;
};

class Faces {
 public:
  explicit Faces(std::uint64_t seed) : random_(seed) {}

  Face next(long world, const Kind& kind) {
    const long size = std::max(world >> kind.size, 8L);
    for (;;) {
      const Vector centre = kind.place == 0 ? Vector{0, 0, 0} : point(world >> kind.place);
      std::vector<Vector> p;
      for (int i = 0; i < 3; ++i) p.push_back(centre + point(size));
      const Vector e = p[1] - p[0], f = p[2] - p[0];
      const Vector n{e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
      // No needles: they say more about themselves than about planes.
      if (dot(n, n) * 100 < dot(e, e) * dot(f, f)) continue;
      const AffineMap turn{matrix(quaternion(integer(1 << 30), integer(1 << 30), integer(1 << 30), 1)), {0, 0, 0}};
      const WidePlane plane = moved(wide_plane(n, -dot(n, p[0])), inverse(turn));
      for (Vector& v : p) v = turn(v);
      return {plane, p};
    }
  }

 private:
  long integer(long limit) {
    return static_cast<long>(random_() % (2 * static_cast<unsigned long>(limit) + 1)) - limit;
  }
  Vector point(long limit) { return {integer(limit), integer(limit), integer(limit)}; }
  std::mt19937_64 random_;
};

/// log2 of the square root.
double logarithm(const Rational& squared) {
  return squared == 0 ? -HUGE_VAL : std::log2(quoin::exact::to_double(squared)) / 2;
}

struct Outcome {
  double mean = 0, worst = -HUGE_VAL, angle = -HUGE_VAL;  // log2 of grid steps; of radians
};

Outcome measure(int bits, const Kind& kind, Method method, int count) {
  const Integer limit = (Integer(1) << static_cast<unsigned>(bits)) - 1;
  const PlaneRounder rounder(limit, limit * limit);
  Faces faces(7);
  Outcome outcome;
  for (int i = 0; i < count; ++i) {
    const Face face = faces.next(1L << (bits / 2 - 2), kind);
    const auto p =
        method == Method::face_local ? rounder.round_near(face.plane, face.points) : rounder.round(face.plane, method);
    if (!p) return {HUGE_VAL, HUGE_VAL, HUGE_VAL};
    const double moved = logarithm(squared_displacement(*p, face.points));
    outcome.mean += moved / count;
    outcome.worst = std::max(outcome.worst, moved);
    outcome.angle = std::max(outcome.angle, logarithm(squared_sine({p->n[0], p->n[1], p->n[2]}, face.plane.n)));
  }
  return outcome;
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 300;
  std::printf("| L | face |");
  for (const auto& method : methods) std::printf(" %s |", method.first);
  std::printf(
      " angle: naive | continued-fraction | lattice | face-local |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const int bits : {16, 24, 32, 40, 48, 56, 62})
    for (const Kind& kind : kinds) {
      std::printf("| 2^%d | %s |", bits, kind.name);
      std::vector<double> angles;
      for (const auto& [name, method] : methods) {
        const Outcome outcome = measure(bits, kind, method, count);
        std::printf(" %.1f, %.1f |", outcome.mean, outcome.worst);
        if (method != Method::best) angles.push_back(outcome.angle);
      }
      for (const double angle : angles) std::printf(" %.1f |", angle);
      std::printf("\n");
      std::fflush(stdout);
    }
}
