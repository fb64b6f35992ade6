// Meshes are checked by a second way: exact areas, orientations and the balance of directed edges. All triangles turn
// left and their directed edges sum to the boundary, so they cover each interior point once and no other point.
#include "booleans/surface/triangulate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <set>

namespace quoin::booleans {
namespace {

using Coordinates = std::array<std::int64_t, 2>;

/// |coordinate| <= 2^29, so that orientations fit 64 bits.
struct IntegerPoints {
  std::vector<Coordinates> at;
  mutable std::size_t compares = 0, orientations = 0;

  int compare(std::uint32_t a, std::uint32_t b) const {
    ++compares;
    return at[a] < at[b] ? -1 : at[b] < at[a] ? 1 : 0;
  }
  std::int64_t area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return (at[b][0] - at[a][0]) * (at[c][1] - at[a][1]) - (at[b][1] - at[a][1]) * (at[c][0] - at[a][0]);
  }
  int orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    ++orientations;
    const std::int64_t twice = area(a, b, c);
    return twice > 0 ? 1 : twice < 0 ? -1 : 0;
  }
};

struct Face {
  IntegerPoints points;
  std::vector<FaceEdge> edges;
  std::vector<std::uint32_t> isolated;

  std::uint32_t count() const { return static_cast<std::uint32_t>(points.at.size()); }
  std::uint32_t add(std::int64_t x, std::int64_t y) {
    points.at.push_back({x, y});
    return count() - 1;
  }
  void add_loop(const std::vector<std::uint32_t>& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) edges.push_back({loop[i], loop[(i + 1) % loop.size()]});
  }
  void add_loop(const std::vector<Coordinates>& corners) {
    std::vector<std::uint32_t> loop;
    for (const auto& [x, y] : corners) loop.push_back(add(x, y));
    add_loop(loop);
  }
  /// Makes those of `inner` isolated that are on no edge.
  void isolate(const std::set<std::uint32_t>& inner) {
    std::set<std::uint32_t> used;
    for (const auto& [a, b] : edges) used.insert({a, b});
    std::set_difference(inner.begin(), inner.end(), used.begin(), used.end(), std::back_inserter(isolated));
  }
  void add_slit(std::uint32_t a, std::uint32_t b) {
    edges.push_back({a, b});
    edges.push_back({b, a});
  }
};

using Random = std::mt19937_64;

/// The seed of random tests: QUOIN_SEED, or 1.
std::uint64_t seed() {
  const char* text = std::getenv("QUOIN_SEED");
  const std::uint64_t value = text == nullptr ? 1 : std::strtoull(text, nullptr, 10);
  std::cout << "QUOIN_SEED=" << value << "\n";
  return value;
}

std::int64_t pick(Random& random, std::int64_t low, std::int64_t high) {
  return low + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(high - low + 1));
}

template <class T>
void shuffle(Random& random, std::vector<T>& items) {
  for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random() % i]);
}

/// Runs `body` with seeds from `seed()` on, until a round fails: QUOIN_SEED set to the traced seed starts with it.
template <class Body>
void for_seeds(std::uint64_t rounds, const Body& body) {
  const std::uint64_t start = seed();
  for (std::uint64_t round = 0; round < rounds && !testing::Test::HasFailure(); ++round) {
    SCOPED_TRACE(start + round);
    Random random(start + round);
    body(random);
  }
}

/// Applies a random unimodular matrix with small entries.
void skew(Random& random, Face& face) {
  for (int step = 0; step < 4; ++step) {
    const std::int64_t factor = pick(random, -2, 2);
    for (Coordinates& p : face.points.at) p = {p[1] + factor * p[0], -p[0]};
  }
}

/// Renumbers the vertices and reorders the edges.
void scramble(Random& random, Face& face) {
  std::vector<std::uint32_t> name(face.points.at.size());
  for (std::uint32_t i = 0; i < name.size(); ++i) name[i] = i;
  shuffle(random, name);
  std::vector<Coordinates> at(name.size());
  for (std::size_t i = 0; i < name.size(); ++i) at[name[i]] = face.points.at[i];
  face.points.at = at;
  for (FaceEdge& edge : face.edges) edge = {name[edge[0]], name[edge[1]]};
  for (std::uint32_t& v : face.isolated) v = name[v];
  shuffle(random, face.edges);
  shuffle(random, face.isolated);
}

/// Everything `triangulate` promises; says what is wrong, or nothing.
std::string fault(const Face& face, const std::vector<FaceTriangle>& triangles) {
  std::vector<FaceEdge> used;
  __int128 covered = 0, enclosed = 0;
  std::vector<char> is_corner(face.points.at.size(), 0);
  for (const auto& [a, b, c] : triangles) {
    if (face.points.area(a, b, c) <= 0) return "a triangle does not turn left";
    covered += face.points.area(a, b, c);
    for (const FaceEdge& edge : {FaceEdge{a, b}, FaceEdge{b, c}, FaceEdge{c, a}}) used.push_back(edge);
    is_corner[a] = is_corner[b] = is_corner[c] = 1;
  }
  for (const auto& [a, b] : face.edges) {
    const Coordinates &p = face.points.at[a], &q = face.points.at[b];
    enclosed += p[0] * q[1] - p[1] * q[0];
  }
  const auto missing = [&is_corner](std::uint32_t v) { return !is_corner[v]; };
  if (std::any_of(face.isolated.begin(), face.isolated.end(), missing)) return "an isolated vertex is missing";
  if (covered != enclosed) return "the area differs";
  std::sort(used.begin(), used.end());
  if (std::adjacent_find(used.begin(), used.end()) != used.end()) return "a directed edge is used twice";
  std::vector<FaceEdge> boundary = face.edges;
  std::sort(boundary.begin(), boundary.end());
  std::vector<FaceEdge> inner;
  std::set_difference(used.begin(), used.end(), boundary.begin(), boundary.end(), std::back_inserter(inner));
  if (inner.size() + boundary.size() != used.size()) return "a boundary edge is not used";
  std::vector<FaceEdge> reversed;
  for (const auto& [a, b] : inner) reversed.push_back({b, a});
  std::sort(reversed.begin(), reversed.end());
  return inner == reversed ? "" : "an edge is not balanced";
}

std::vector<std::array<double, 2>> doubles(const Face& face) {
  std::vector<std::array<double, 2>> all;
  for (const auto& [x, y] : face.points.at) all.push_back({static_cast<double>(x), static_cast<double>(y)});
  return all;
}

void improve(const Face& face, const std::vector<std::array<double, 2>>& approximate,
             std::vector<FaceTriangle>& triangles) {
  FaceCutter<IntegerPoints>(face.points, triangles).improve(face.edges, approximate);
}

/// The triangles of a face after all checks, improvement included.
std::vector<FaceTriangle> checked(const Face& face) {
  std::vector<FaceTriangle> triangles;
  EXPECT_TRUE(triangulate(face.points, face.count(), face.edges, face.isolated, triangles));
  EXPECT_EQ(fault(face, triangles), "");
  std::vector<FaceTriangle> improved = triangles;
  improve(face, doubles(face), improved);
  EXPECT_EQ(fault(face, improved), "");
  return triangles;
}

/// How many {comparisons, orientations} one triangulation asks.
std::array<std::size_t, 2> predicates(const Face& face) {
  face.points.compares = face.points.orientations = 0;
  std::vector<FaceTriangle> triangles;
  EXPECT_TRUE(triangulate(face.points, face.count(), face.edges, face.isolated, triangles));
  return {face.points.compares, face.points.orientations};
}

/// One triangulation asks at most `factor` n log2 n predicates.
void expect_few_predicates(const Face& face, double factor) {
  const auto [compares, orientations] = predicates(face);
  const double n = face.count(), unit = n * std::log2(n);
  std::cout << "n " << n << " compares " << compares << " orientations " << orientations << "\n";
  EXPECT_LE(static_cast<double>(compares), 1.1 * unit);
  EXPECT_LE(static_cast<double>(compares + orientations), factor * unit);
}

TEST(Triangulate, TriangleAsksNothing) {
  Face face;
  EXPECT_EQ(checked(face).size(), 0u);
  face.add_loop(std::vector<Coordinates>{{0, 0}, {4, 1}, {1, 3}});
  std::sort(face.edges.begin(), face.edges.end());
  do {
    EXPECT_EQ(checked(face).size(), 1u);
    EXPECT_EQ(predicates(face), (std::array<std::size_t, 2>{0, 0}));
  } while (std::next_permutation(face.edges.begin(), face.edges.end()));
  std::vector<FaceTriangle> triangles = {{7, 8, 9}};
  EXPECT_TRUE(triangulate(face.points, 3, face.edges, {}, triangles));
  EXPECT_EQ(triangles.size(), 2u) << "appends";
}

TEST(Triangulate, CollinearVerticesOnAllSides) {
  for (int with = 0; with < 256; ++with) {
    Face face;
    std::vector<Coordinates> loop;
    const std::array<Coordinates, 12> around = {
        {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {3, 3}, {2, 3}, {1, 3}, {0, 3}, {0, 2}, {0, 1}}};
    int bit = 0;
    for (std::size_t i = 0; i < 12; ++i) {
      if (i % 3 == 0 || (with >> bit++ & 1)) loop.push_back(around[i]);
    }
    face.add_loop(loop);
    EXPECT_EQ(checked(face).size(), loop.size() - 2);
  }
  Face corner;
  corner.add_loop(std::vector<Coordinates>{{0, 0}, {2, 0}, {4, 0}, {6, 0}, {4, 2}, {3, 3}, {0, 6}, {0, 5}, {0, 1}});
  EXPECT_EQ(checked(corner).size(), 7u);
}

TEST(Triangulate, SlitsAndIsolatedVertices) {
  Face face;
  face.add_loop(std::vector<Coordinates>{{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  const auto a = face.add(3, 3), b = face.add(7, 3), c = face.add(5, 3), d = face.add(5, 8);
  face.add_slit(a, c);
  face.add_slit(c, b);
  EXPECT_EQ(checked(Face{face.points, face.edges, {d}}).size(), 10u);
  face.add_slit(c, d);
  EXPECT_EQ(checked(face).size(), 10u);
  face.add_slit(0, a);
  EXPECT_EQ(checked(face).size(), 10u);
  face.add_slit(d, 2);
  EXPECT_EQ(checked(face).size(), 10u);
  Face cross;
  cross.add_loop(std::vector<Coordinates>{{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  for (const std::int64_t i : {1, 2, 3, 4, 6, 7, 8, 9}) {
    cross.isolated.insert(cross.isolated.end(), {cross.add(5, i), cross.add(i, 5)});
  }
  EXPECT_EQ(checked(cross).size(), 2u + 2 * 16);
}

TEST(Triangulate, LoopsThatTouch) {
  Face face;
  const auto a = face.add(0, 0), b = face.add(12, 0), c = face.add(12, 12), d = face.add(0, 12);
  const auto p = face.add(4, 4), q = face.add(8, 4), r = face.add(6, 6), s = face.add(4, 8), t = face.add(8, 8);
  face.add_loop({a, b, c, d});
  face.add_loop({p, r, q});
  EXPECT_EQ(checked(face).size(), 7u);
  face.add_loop({r, s, t});
  checked(face);
  // A hole between the first hole and two corners of the outer loop.
  face.add_loop({a, p, face.add(3, 2)});
  checked(face);
  face.add_loop({q, b, face.add(9, 1)});
  checked(face);
  Face thrice;
  const auto o = thrice.add(0, 0);
  thrice.add_loop({o, thrice.add(4, -1), thrice.add(4, 1), o, thrice.add(1, 4), thrice.add(-1, 4), o,
                   thrice.add(-4, -1), thrice.add(-3, -3)});
  EXPECT_EQ(checked(thrice).size(), 3u);
}

/// A face of unit cells: each kept with probability keep/100; slits with probability slit/100.
Face random_cells(Random& random, std::int64_t width, std::int64_t height, std::int64_t keep, std::int64_t slit) {
  Face face;
  std::vector<char> kept(static_cast<std::size_t>(width * height));
  for (char& cell : kept) cell = pick(random, 0, 99) < keep;
  const auto inside = [&](std::int64_t x, std::int64_t y) {
    return x >= 0 && y >= 0 && x < width && y < height && kept[static_cast<std::size_t>(y * width + x)] != 0;
  };
  const auto id = [&](std::int64_t x, std::int64_t y) { return static_cast<std::uint32_t>(y * (width + 1) + x); };
  for (std::int64_t y = 0; y <= height; ++y) {
    for (std::int64_t x = 0; x <= width; ++x) face.add(x, y);
  }
  const auto side = [&](bool left, bool right, std::uint32_t from, std::uint32_t to) {
    const bool both = left && right && pick(random, 0, 99) < slit;
    if (left && (!right || both)) face.edges.push_back({from, to});
    if (right && (!left || both)) face.edges.push_back({to, from});
  };
  for (std::int64_t y = 0; y <= height; ++y) {
    for (std::int64_t x = 0; x <= width; ++x) {
      if (x < width) side(inside(x, y), inside(x, y - 1), id(x, y), id(x + 1, y));
      if (y < height) side(inside(x - 1, y), inside(x, y), id(x, y), id(x, y + 1));
    }
  }
  std::set<std::uint32_t> inner;
  for (std::int64_t y = 1; y < height; ++y) {
    for (std::int64_t x = 1; x < width; ++x) {
      if (inside(x, y) && inside(x - 1, y - 1) && pick(random, 0, 1)) inner.insert(id(x, y));
    }
  }
  face.isolate(inner);
  return face;
}

TEST(Triangulate, RandomCells) {
  for_seeds(3000, [](Random& random) {
    const std::int64_t size = pick(random, 0, 49) == 0 ? 30 : 8;
    const std::int64_t width = pick(random, 1, size), height = pick(random, 1, size), keep = pick(random, 20, 100);
    Face face = random_cells(random, width, height, keep, std::max<std::int64_t>(0, pick(random, -100, 100)));
    if (pick(random, 0, 1)) skew(random, face);
    scramble(random, face);
    checked(face);
  });
}

/// Random points in a box with random slits that cross nothing.
Face random_slits(Random& random, std::int64_t size, std::int64_t points, std::int64_t tries) {
  Face face;
  face.add_loop(std::vector<Coordinates>{{0, 0}, {size, 0}, {size, size}, {0, size}});
  std::set<Coordinates> taken;
  for (std::int64_t i = 0; i < points; ++i) {
    const Coordinates p = {pick(random, 1, size - 1), pick(random, 1, size - 1)};
    if (taken.insert(p).second) face.add(p[0], p[1]);
  }
  const auto crosses = [&p = face.points](std::uint32_t a, std::uint32_t b, const auto& edge) {
    const auto [c, d] = edge;
    return (a == c && b == d) ||
           (p.orientation(a, b, c) * p.orientation(a, b, d) < 0 && p.orientation(c, d, a) * p.orientation(c, d, b) < 0);
  };
  const auto contains = [&face](std::uint32_t a, std::uint32_t b, const Coordinates& r) {
    const Coordinates &p = face.points.at[a], &q = face.points.at[b];
    return std::min(p, q) < r && r < std::max(p, q) && (q[0] - p[0]) * (r[1] - p[1]) == (q[1] - p[1]) * (r[0] - p[0]);
  };
  const std::vector<Coordinates>& at = face.points.at;
  for (std::int64_t i = 0; i < tries; ++i) {
    const auto a = static_cast<std::uint32_t>(pick(random, 0, face.count() - 1));
    const auto b = static_cast<std::uint32_t>(pick(random, 0, face.count() - 1));
    if (a == b || std::any_of(at.begin(), at.end(), [&](const Coordinates& r) { return contains(a, b, r); })) continue;
    const auto blocks = [&](const FaceEdge& edge) { return crosses(a, b, edge) || edge == FaceEdge{b, a}; };
    if (std::none_of(face.edges.begin(), face.edges.end(), blocks)) face.add_slit(a, b);
  }
  std::set<std::uint32_t> all;
  for (std::uint32_t v = 0; v < face.count(); ++v) all.insert(v);
  face.isolate(all);
  return face;
}

/// The boundary of a random subset of triangles, with some of their common edges as slits.
Face random_subset(Random& random, const Face& whole, const std::vector<FaceTriangle>& triangles, std::int64_t keep,
                   std::int64_t slit) {
  Face face;
  face.points = whole.points;
  std::set<FaceEdge> directed;
  for (const auto& [a, b, c] : triangles) {
    if (pick(random, 0, 99) >= keep) continue;
    for (const FaceEdge& edge : {FaceEdge{a, b}, FaceEdge{b, c}, FaceEdge{c, a}}) directed.insert(edge);
  }
  for (const auto& [a, b] : directed) {
    if (!directed.count({b, a})) {
      face.edges.push_back({a, b});
    } else if (a < b && pick(random, 0, 99) < slit) {
      face.add_slit(a, b);
    }
  }
  std::set<std::uint32_t> corners;
  for (const FaceEdge& edge : directed) corners.insert(edge[0]);
  face.isolate(corners);
  return face;
}

TEST(Triangulate, RandomSlitsAndSubsets) {
  for_seeds(1500, [](Random& random) {
    const std::int64_t size = std::int64_t{1} << (pick(random, 0, 2) == 0 ? 28 : pick(random, 2, 6));
    const std::int64_t points = pick(random, 0, 40);
    Face face = random_slits(random, size, points, pick(random, 0, 60));
    if (size <= 1 << 20) skew(random, face);
    scramble(random, face);
    const std::vector<FaceTriangle> triangles = checked(face);
    const std::int64_t keep = pick(random, 20, 100);
    Face part = random_subset(random, face, triangles, keep, std::max<std::int64_t>(0, pick(random, -60, 60)));
    scramble(random, part);
    checked(part);
  });
}

/// A loop that every ray from the origin meets once.
Face random_star(Random& random, std::int64_t corners, std::int64_t radius) {
  const auto half = [](const Coordinates& p) { return p[1] > 0 || (p[1] == 0 && p[0] > 0) ? 0 : 1; };
  const auto before = [&half](const Coordinates& p, const Coordinates& q) {
    return half(p) != half(q) ? half(p) < half(q) : p[0] * q[1] - p[1] * q[0] > 0;
  };
  std::set<Coordinates, decltype(before)> directions({{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, before);
  for (std::int64_t i = 0; i < corners; ++i) {
    const Coordinates p = {pick(random, -radius, radius), pick(random, -radius, radius)};
    if (p != Coordinates{0, 0}) directions.insert(p);
  }
  Face face;
  face.add_loop(std::vector<Coordinates>(directions.begin(), directions.end()));
  return face;
}

/// Whether segments p q and r s have a point in common. Not of two that lie on one line and share just an end.
bool meet(const Face& face, std::uint32_t p, std::uint32_t q, std::uint32_t r, std::uint32_t s) {
  const auto side = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) { return face.points.orientation(a, b, c); };
  const int sides[] = {side(p, q, r), side(p, q, s), side(r, s, p), side(r, s, q)};
  if (sides[0] != 0 || sides[1] != 0) return sides[0] * sides[1] <= 0 && sides[2] * sides[3] <= 0;
  const auto& at = face.points.at;
  return std::max(std::min(at[p], at[q]), std::min(at[r], at[s])) <=
         std::min(std::max(at[p], at[q]), std::max(at[r], at[s]));
}

/// A loop that does not touch itself: from a triangle on, corners are put between two others where that is possible.
std::vector<std::uint32_t> random_loop(Random& random, Face& face, std::size_t corners, std::int64_t size) {
  face.add(0, 0), face.add(size, 0), face.add(0, size);
  std::vector<std::uint32_t> loop = {0, 1, 2};
  for (std::int64_t tries = 0; tries < 200 && loop.size() < corners; ++tries) {
    const std::uint32_t p = face.add(pick(random, 0, size), pick(random, 0, size));
    const std::size_t place = random() % loop.size(), n = loop.size();
    const std::uint32_t before = loop[place], after = loop[(place + 1) % n];
    bool fits = face.points.orientation(before, p, after) != 0;
    for (std::size_t i = 0; fits && i < n; ++i) {
      const std::uint32_t a = loop[i], b = loop[(i + 1) % n];
      if (i == place) continue;
      // At the ends of the edge that is replaced the next edges begin: only their far ends may not be met.
      const bool ends = b == before, begins = a == after;
      fits = (ends ? face.points.orientation(a, b, p) != 0 : !meet(face, before, p, a, b)) &&
             (begins ? face.points.orientation(a, b, p) != 0 : !meet(face, p, after, a, b));
    }
    if (fits)
      loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(place) + 1, p);
    else
      face.points.at.pop_back();
  }
  return loop;
}

/// Two ways to the same triangles.
TEST(Triangulate, LoopsOfFewCornersAsAnyFace) {
  std::size_t cut = 0;
  for_seeds(5000, [&cut](Random& random) {
    Face face;
    const auto corners = static_cast<std::size_t>(pick(random, 4, LoopSweep<IntegerPoints>::most_corners));
    std::vector<std::uint32_t> loop = random_loop(random, face, corners, pick(random, 3, 40));
    face.add_loop(loop);
    skew(random, face);
    std::vector<FaceTriangle> by_loop, by_face;
    ASSERT_TRUE(LoopSweep<IntegerPoints>(face.points, by_loop).run(loop));
    ASSERT_TRUE(FaceSweep<IntegerPoints>(face.points, by_face).run(face.count(), face.edges, {}));
    EXPECT_EQ(by_loop, by_face);
    EXPECT_EQ(fault(face, by_loop), "");
    EXPECT_EQ(by_loop.size() + 2, loop.size());
    cut += by_loop.size();
  });
  EXPECT_GT(cut, 20000u);
}

TEST(Triangulate, LoopsThatBoundNothingEndWithoutACrash) {
  std::size_t refused = 0;
  for_seeds(20000, [&refused](Random& random) {
    Face face;
    std::vector<std::uint32_t> loop;
    for (std::int64_t i = pick(random, 3, 16); i-- > 0;)
      loop.push_back(face.add(pick(random, 0, 6), pick(random, 0, 6)));
    std::vector<FaceTriangle> triangles;
    refused += LoopSweep<IntegerPoints>(face.points, triangles).run(loop) ? 0 : 1;
  });
  EXPECT_GT(refused, 10000u);
}

TEST(Triangulate, OneCutterForManyFaces) {
  for_seeds(100, [](Random& random) {
    IntegerPoints points;
    std::vector<FaceTriangle> triangles;
    FaceCutter<IntegerPoints> cutter(points, triangles);
    for (int i = 0; i < 20; ++i) {
      const std::int64_t count = pick(random, 0, 40);
      Face face = pick(random, 0, 1) ? random_slits(random, 64, count, 20) : random_star(random, count, 64);
      scramble(random, face);
      points = face.points;
      triangles.clear();
      ASSERT_TRUE(cutter.cut(face.count(), face.edges, face.isolated));
      EXPECT_EQ(fault(face, triangles), "");
      std::vector<FaceTriangle> fresh;
      ASSERT_TRUE(FaceSweep<IntegerPoints>(points, fresh).run(face.count(), face.edges, face.isolated));
      EXPECT_EQ(triangles, fresh);
      cutter.improve(face.edges, doubles(face));
      improve(face, doubles(face), fresh);
      EXPECT_EQ(triangles, fresh);
    }
  });
}

TEST(Triangulate, RandomStars) {
  for_seeds(1000, [](Random& random) {
    const std::int64_t corners = pick(random, 0, 60);
    Face face = random_star(random, corners, std::int64_t{1} << pick(random, 1, 28));
    scramble(random, face);
    EXPECT_EQ(checked(face).size(), face.points.at.size() - 2);
  });
  Random random(seed());
  Face large = random_star(random, 20000, 1 << 28);
  scramble(random, large);
  checked(large);
  expect_few_predicates(large, 1.5);
}

TEST(Triangulate, Combs) {
  Random random(seed());
  for (const bool slanted : {false, true}) {
    for (int turn = 0; turn < 4; ++turn) {
      for (const int teeth : {1, 2, 7, 5000}) {
        std::vector<Coordinates> loop = {{0, 0}, {4 * teeth, 0}};
        for (int i = teeth; i-- > 0;) {
          const Coordinates tip = {4 * i + 2, 1000 + (slanted ? i : 0)};
          loop.insert(loop.end(), {{tip[0] + 1, 2}, tip, {tip[0] - 1, 2}});
        }
        for (int i = 0; i < turn; ++i) {
          for (Coordinates& p : loop) p = {-p[1], p[0]};
        }
        Face face;
        face.add_loop(loop);
        scramble(random, face);
        EXPECT_EQ(checked(face).size(), face.points.at.size() - 2);
        if (teeth > 1000) expect_few_predicates(face, 1.4);
      }
    }
  }
}

/// side x side holes in a plate; a gap of 0 lets neighbours touch in corners.
Face plate(std::int64_t side, std::int64_t gap) {
  Face face;
  const std::int64_t pitch = 4 + gap, end = pitch * side + 4;
  face.add_loop(std::vector<Coordinates>{{-4, -4}, {end, -4}, {end, end}, {-4, end}});
  std::map<Coordinates, std::uint32_t> ids;
  const auto id = [&](std::int64_t x, std::int64_t y) {
    const auto [place, fresh] = ids.try_emplace({x, y}, face.count());
    return fresh ? face.add(x, y) : place->second;
  };
  for (std::int64_t i = 0; i < side; ++i) {
    for (std::int64_t j = 0; j < side; ++j) {
      const std::int64_t x = i * pitch, y = j * pitch;
      face.add_loop({id(x, y + 2), id(x + 2, y + 4), id(x + 4, y + 2), id(x + 2, y)});
    }
  }
  return face;
}

TEST(Triangulate, PlateWithTenThousandHoles) {
  Random random(seed());
  for (const std::int64_t gap : {1, 0}) {
    Face face = plate(100, gap);
    scramble(random, face);
    const std::size_t triangles = checked(face).size();
    EXPECT_EQ(triangles, gap > 0 ? 40004u + 2 * 10000 - 2 : 800u + 2 * 99 * 99);
    expect_few_predicates(face, 1.5);
    skew(random, face);
    checked(face);
    expect_few_predicates(face, 1.5);
  }
}

TEST(Triangulate, CloudAndFan) {
  Random random(seed());
  for (const std::int64_t size : {150, 1 << 20}) {
    const Face face = random_slits(random, size, 10000, 0);
    EXPECT_EQ(checked(face).size(), 2 * face.points.at.size() - 6);
    expect_few_predicates(face, 1.5);
  }
  Face face = random_star(random, 3000, 1 << 20);
  for (Coordinates& p : face.points.at) p = {3 * p[0], 3 * p[1]};
  const std::uint32_t corners = face.count(), middle = face.add(0, 0);
  for (std::uint32_t v = 0; v < corners; v += 2) face.add_slit(v, middle);
  scramble(random, face);
  checked(face);
  expect_few_predicates(face, 1.6);
}

TEST(Triangulate, PredicatesGrowLikeNLogN) {
  Random random(seed());
  for (const std::int64_t size : {10, 20, 40, 80, 160}) {
    Face face = random_cells(random, size, size, 70, 20);
    scramble(random, face);
    expect_few_predicates(face, 1.2);
  }
}

TEST(Triangulate, AsksNothingBeyondDoubt) {
  Face convex;
  std::vector<Coordinates> loop;
  for (std::int64_t x = -50; x < 50; ++x) loop.push_back({x, x * x});
  convex.add_loop(loop);
  EXPECT_EQ(checked(convex).size(), 98u);
  EXPECT_EQ(predicates(convex), (std::array<std::size_t, 2>{0, 100}));
  Face face;
  face.add_loop(std::vector<Coordinates>{{0, 0}, {30, 0}, {20, 10}, {0, 10}});
  face.isolated = {face.add(1, 5)};
  EXPECT_EQ(checked(face).size(), 4u);
  // One sorts the edges in (0, 0), two place (1, 5), one asks for (0, 0) (0, 10) from there, one for (0, 0) (1, 5) from
  // (20, 10), which sees (1, 5) (0, 10) beyond doubt.
  EXPECT_EQ(predicates(face)[1], 5u);
}

TEST(Triangulate, RefusesWhatBoundsNoFace) {
  Face square;
  square.add_loop(std::vector<Coordinates>{{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const auto out = square.add(9, 9), in = square.add(1, 1);
  EXPECT_EQ(checked(square).size(), 2u);
  std::vector<std::pair<const char*, Face>> cases = {{"isolated vertex outside", {square.points, square.edges, {out}}},
                                                     {"index out of range", {square.points, square.edges, {17}}}};
  for (const FaceEdge& extra : {square.edges[0], FaceEdge{out, out}, FaceEdge{0, 17}, FaceEdge{0, out}}) {
    cases.push_back({"edge twice, without length, out of range, open", square});
    cases.back().second.edges.push_back(extra);
  }
  cases.push_back({"slit outside", square});
  cases.back().second.add_slit(2, out);
  for (unsigned subset = 1; subset < 15; ++subset) {
    cases.push_back({"open loop", square});
    std::erase_if(cases.back().second.edges, [subset](const FaceEdge& e) { return (subset >> e[0] & 1) == 0; });
  }
  cases.push_back({"slit twice in one direction", square});
  cases.back().second.edges.insert(cases.back().second.edges.end(), 2, {2, in});
  cases.push_back({"inside out", square});
  for (FaceEdge& edge : cases.back().second.edges) std::swap(edge[0], edge[1]);
  for (const auto& [name, face] : cases) {
    std::vector<FaceTriangle> triangles = {{7, 8, 9}};
    EXPECT_FALSE(triangulate(face.points, face.count(), face.edges, face.isolated, triangles)) << name;
    EXPECT_EQ(triangles.size(), 1u) << name;
  }
}

TEST(Triangulate, GarbageEndsWithoutACrash) {
  std::size_t refused = 0;
  for_seeds(20000, [&refused](Random& random) {
    Face face;
    const std::int64_t count = pick(random, 3, 12);
    for (std::int64_t i = 0; i < count; ++i) face.points.at.push_back({pick(random, 0, 6), pick(random, 0, 6)});
    const auto any = [&] { return static_cast<std::uint32_t>(pick(random, 0, count - 1)); };
    for (std::int64_t i = pick(random, 0, 3); i-- > 0;) {
      std::vector<std::uint32_t> loop;
      for (std::int64_t j = pick(random, 2, 9); j-- > 0;) loop.push_back(any());
      face.add_loop(loop);
    }
    for (std::int64_t i = pick(random, 0, 2); i-- > 0;) face.isolated.push_back(any());
    std::vector<FaceTriangle> triangles;
    refused += triangulate(face.points, face.count(), face.edges, face.isolated, triangles) ? 0 : 1;
    improve(face, doubles(face), triangles);
  });
  EXPECT_GT(refused, 10000u);
}

/// Six times the volume under the triangles lifted to z = x^2 + y^2: every Delaunay flip makes it smaller.
std::int64_t lifted_volume(const Face& face, const std::vector<FaceTriangle>& triangles) {
  std::int64_t sum = 0;
  const auto height = [&at = face.points.at](std::uint32_t v) { return at[v][0] * at[v][0] + at[v][1] * at[v][1]; };
  for (const auto& [a, b, c] : triangles) sum += (height(a) + height(b) + height(c)) * face.points.area(a, b, c);
  return sum;
}

TEST(ImproveTriangles, FlipsTheLongDiagonal) {
  Face face;
  face.add_loop(std::vector<Coordinates>{{0, 0}, {5, -1}, {10, 0}, {5, 1}});
  std::vector<FaceTriangle> triangles = {{0, 1, 2}, {0, 2, 3}};
  improve(face, doubles(face), triangles);
  EXPECT_EQ(fault(face, triangles), "");
  for (const auto& [a, b, c] : triangles) EXPECT_EQ((std::set{a, b, c, 1u, 3u}).size(), 3u);
  face.add_slit(0, 2);  // A slit stays.
  triangles = {{0, 1, 2}, {0, 2, 3}};
  improve(face, doubles(face), triangles);
  EXPECT_EQ(triangles, (std::vector<FaceTriangle>{{0, 1, 2}, {0, 2, 3}}));
}

/// Few vertices find their neighbours otherwise than many.
TEST(ImproveTriangles, UnusedVerticesChangeNothing) {
  for_seeds(1000, [](Random& random) {
    Face face = random_slits(random, 32, pick(random, 0, 12), pick(random, 0, 9));
    scramble(random, face);
    std::vector<FaceTriangle> few;
    ASSERT_TRUE(triangulate(face.points, face.count(), face.edges, face.isolated, few));
    std::vector<FaceTriangle> many = few;
    std::vector<std::array<double, 2>> padded = doubles(face);
    improve(face, padded, few);
    padded.resize(100);
    improve(face, padded, many);
    EXPECT_EQ(few, many);
    EXPECT_EQ(fault(face, few), "");
  });
}

TEST(ImproveTriangles, ExactOrientationHasTheLastWord) {
  Face face;
  face.add_loop(std::vector<Coordinates>{{0, 0}, {5, 0}, {10, 0}, {5, 9}});
  std::vector<FaceTriangle> triangles = {{1, 2, 3}, {0, 1, 3}};
  const std::vector<FaceTriangle> before = triangles;
  const std::vector<std::array<double, 2>> wrong = {{0, 0}, {5, -30}, {10, 0}, {5, 1}};
  improve(face, wrong, triangles);
  EXPECT_EQ(triangles, before);
  face.points.at[1] = {5, -30};
  improve(face, wrong, triangles);
  EXPECT_TRUE(triangles != before && fault(face, triangles).empty());
}

TEST(ImproveTriangles, LowersTheLiftedSurface) {
  for_seeds(300, [](Random& random) {
    const std::int64_t points = pick(random, 50, 300);
    const Face face = random_slits(random, 400, points, pick(random, 0, 9));
    std::vector<FaceTriangle> triangles;
    ASSERT_TRUE(triangulate(face.points, face.count(), face.edges, face.isolated, triangles));
    std::vector<FaceTriangle> improved = triangles, again = triangles;
    improve(face, doubles(face), improved);
    EXPECT_EQ(fault(face, improved), "");
    EXPECT_LT(lifted_volume(face, improved), lifted_volume(face, triangles));
    improve(face, doubles(face), again);
    EXPECT_EQ(improved, again);
  });
}

}  // namespace
}  // namespace quoin::booleans
