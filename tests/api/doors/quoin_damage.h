/// \file
/// Valid .quoin texts, what can be done to them, and the laws of what is still accepted. Shared by the tests and the
/// fuzz target.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exact/rational.h"
#include "quoin/quoin.h"
#include "tests/io/exact_document.h"

namespace quoin::damage {

/// A document whose faces are lists of lists.
struct Document {
  io::test::ExactDocument numbers;  // without faces
  std::vector<std::vector<std::vector<std::uint32_t>>> faces;
};

inline Document opened(const std::string& text) {
  Document d{io::test::read_quoin(text).value(), {}};
  io::test::ExactDocument& n = d.numbers;
  for (std::size_t f = 0; f < n.planes.size(); ++f) {
    auto& face = d.faces.emplace_back();
    for (std::uint32_t j = n.face_loops[f]; j < n.face_loops[f + 1]; ++j)
      face.emplace_back(n.corners.begin() + n.loop_corners[j], n.corners.begin() + n.loop_corners[j + 1]);
  }
  n.face_loops = n.loop_corners = {0};
  n.corners.clear();
  return d;
}

/// Faces without loops and loops without corners, which no text can hold, are left out.
inline std::string closed(const Document& d) {
  io::test::ExactDocument n = d.numbers;
  n.planes.clear();
  for (std::size_t f = 0; f < d.faces.size(); ++f) {
    for (const auto& loop : d.faces[f]) {
      if (loop.empty()) continue;
      n.corners.insert(n.corners.end(), loop.begin(), loop.end());
      n.loop_corners.push_back(static_cast<std::uint32_t>(n.corners.size()));
    }

    const auto loops = static_cast<std::uint32_t>(n.loop_corners.size() - 1);
    if (loops == n.face_loops.back()) continue;
    n.face_loops.push_back(loops);
    n.planes.push_back(d.numbers.planes[f]);
  }
  return io::test::write_quoin(n);
}

inline long long number(const std::string& text) { return std::strtoll(text.c_str(), nullptr, 10) % 1'000'000'000; }

inline constexpr std::uint32_t kinds = 22;

/// One of `kinds` changes, at places that the numbers a, b, c choose. Corners stay below the number of vertices.
inline void damage(Document& d, std::uint32_t kind, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  auto& vertices = d.numbers.vertices;
  if (d.faces.empty() || vertices.empty()) return;
  const auto vertex = [&](std::uint32_t i) { return static_cast<std::uint32_t>(i % vertices.size()); };
  const std::size_t f = a % d.faces.size(), g = b % d.faces.size();
  auto& face = d.faces[f];
  if (face.empty()) return;
  const std::size_t l = b % face.size();
  auto& loop = face[l];
  if (loop.empty()) return;
  const std::size_t i = c % loop.size(), j = (c + 1) % loop.size();

  const auto at = [](std::size_t k) { return static_cast<std::ptrdiff_t>(k); };
  const auto repeat_plane = [&] {
    const std::array<std::string, 4> plane = d.numbers.planes[f];
    d.numbers.planes.insert(d.numbers.planes.begin() + at(f), plane);
  };

  switch (kind % kinds) {
    case 0:  // a loop twice
      face.push_back(std::vector(loop));
      break;
    case 1:  // a loop less
      face.erase(face.begin() + at(l));
      break;
    case 2:  // another start
      std::rotate(loop.begin(), loop.begin() + at(i), loop.end());
      break;
    case 3:  // the other way round
      std::reverse(loop.begin(), loop.end());
      break;
    case 4:  // a slit along an edge of the face
      face.push_back({loop[i], loop[j]});
      break;
    case 5:  // an edge run three times
      loop.insert(loop.begin() + at(i), {loop[i], loop[j]});
      break;
    case 6:  // a slit between any vertices
      d.faces[g].push_back({vertex(c), vertex(c / 7)});
      break;
    case 7:  // a point inside a face
      d.faces[g].push_back({vertex(c)});
      break;
    case 8:  // two points change places
      std::swap(vertices[vertex(b)], vertices[vertex(c)]);
      break;
    case 9: {  // two vertices change numbers
      const std::uint32_t u = vertex(b), v = vertex(c);
      std::swap(vertices[u], vertices[v]);
      for (auto& x : d.faces)
        for (auto& y : x)
          for (auto& z : y) z = z == u ? v : z == v ? u : z;
      break;
    }
    case 10:  // two faces change places
      std::swap(d.faces[f], d.faces[g]);
      std::swap(d.numbers.planes[f], d.numbers.planes[g]);
      break;
    case 11: {  // a plane turned round
      for (auto& x : d.numbers.planes[f])
        if (x != "0") x = x[0] == '-' ? x.substr(1) : "-" + x;
      break;
    }
    case 12:  // another plane
      d.numbers.planes[f][c % 4] = std::to_string(static_cast<int>(b % 5) - 2);
      break;
    case 13:  // a loop in another face
      if (f != g) {
        d.faces[g].push_back(loop);
        face.erase(face.begin() + at(l));
      }
      break;
    case 14:  // a face less
      d.faces.erase(d.faces.begin() + at(f));
      d.numbers.planes.erase(d.numbers.planes.begin() + at(f));
      break;
    case 15:  // a face twice
      d.faces.insert(d.faces.begin() + at(f), std::vector(face));
      repeat_plane();
      break;
    case 16:  // two faces of one plane as one
      for (std::size_t h = 0; h < d.faces.size(); ++h)
        if (h != f && d.numbers.planes[h] == d.numbers.planes[f]) {
          face.insert(face.end(), d.faces[h].begin(), d.faces[h].end());
          d.faces.erase(d.faces.begin() + at(h));
          d.numbers.planes.erase(d.numbers.planes.begin() + at(h));
          break;
        }
      break;
    case 17:
      d.numbers.full_at_infinity = !d.numbers.full_at_infinity;
      break;
    case 18:  // a coordinate one step aside
      vertices[vertex(b)][c % 3] = std::to_string(number(vertices[vertex(b)][c % 3]) + (c % 2 ? 1 : -1));
      break;
    case 19: {  // a vertex in the middle of an edge, in all faces that have it
      const auto &p = vertices[loop[i]], &q = vertices[loop[j]];
      if (loop[i] == loop[j] || p[3] != "1" || q[3] != "1") break;
      std::array<std::string, 4> middle;
      for (std::size_t k = 0; k < 3; ++k) middle[k] = std::to_string((number(p[k]) + number(q[k])) / 2);
      middle[3] = "1";

      const auto place =
          static_cast<std::uint32_t>(c % 2 ? vertices.size() : static_cast<std::size_t>(std::max(loop[i], loop[j])));
      const std::uint32_t u = loop[i], v = loop[j];
      for (auto& x : d.faces)
        for (auto& y : x)
          for (std::size_t k = 0; k < y.size(); ++k) {
            const std::uint32_t s = y[k], e = y[(k + 1) % y.size()];
            if ((s == u && e == v) || (s == v && e == u)) y.insert(y.begin() + at(++k), ~0u);
          }
      for (auto& x : d.faces)
        for (auto& y : x)
          for (auto& z : y) z = z == ~0u ? place : z >= place ? z + 1 : z;
      vertices.insert(vertices.begin() + at(place), middle);
      break;
    }
    case 20:  // two loops that share a vertex as one, or the tails of one exchanged
      for (std::size_t m = 0; m < face.size(); ++m)
        for (std::size_t k = 0; k < face[m].size(); ++k) {
          if (face[m][k] != loop[i] || (m == l && k == i)) continue;
          if (m == l) {
            const auto [first, last] = std::minmax(i, k);
            face.push_back(std::vector(loop.begin() + at(first), loop.begin() + at(last)));
            face[l].erase(face[l].begin() + at(first), face[l].begin() + at(last));
          } else {
            std::vector<std::uint32_t> other = face[m];
            std::rotate(other.begin(), other.begin() + at(k), other.end());
            loop.insert(loop.begin() + at(i), other.begin(), other.end());
            face.erase(face.begin() + at(m));
          }
          return;
        }
      break;
    case 21: {  // a face cut along a diagonal
      if (loop.size() < 4) break;
      std::rotate(loop.begin(), loop.begin() + at(i), loop.end());
      const std::vector<std::uint32_t> part(loop.begin(), loop.begin() + 3);
      loop.erase(loop.begin() + 1);
      d.faces.insert(d.faces.begin() + at(f), std::vector<std::vector<std::uint32_t>>{part});
      repeat_plane();
      break;
    }
    default:
      break;
  }
}

inline Solid from_mesh(const std::vector<double>& points, const std::vector<std::uint32_t>& triangles,
                       const Grid& grid = {}) {
  return Solid::from_triangles(points, triangles, grid).value();
}
inline Solid block(const std::array<int, 3>& low, const std::array<int, 3>& high, const Grid& grid = {}) {
  std::vector<double> points;
  for (unsigned corner = 0; corner < 8; ++corner)
    for (std::size_t k = 0; k < 3; ++k) points.push_back((corner >> k & 1) != 0 ? high[k] : low[k]);
  return from_mesh(points, {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                            2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5},
                   grid);
}
/// Precondition: d is on the positive side of a, b, c.
inline Solid tetrahedron(const std::array<std::array<int, 3>, 4>& p, const Grid& grid = {}) {
  std::vector<double> points;
  for (const auto& q : p) points.insert(points.end(), q.begin(), q.end());
  return from_mesh(points, {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}, grid);
}

/// Solids with all that a text may have: holes, pinched faces, slits, points, derived vertices, voids, edges of four
/// faces, several shells, unbounded ones.
inline std::vector<std::string> valid_texts() {
  const Solid cube = block({0, 0, 0}, {4, 4, 4});
  const Solid needle = tetrahedron({{{1, 1, 4}, {2, 1, 4}, {1, 2, 6}, {1, 0, 6}}});  // stands on an edge
  const Solid spike = tetrahedron({{{2, 2, 4}, {3, 2, 6}, {2, 3, 6}, {1, 1, 6}}});   // stands on a corner
  const Solid skew = tetrahedron({{{-1, -1, -1}, {6, 0, 1}, {0, 7, 1}, {1, 1, 5}}});

  const std::vector<Solid> solids{
      cube,
      skew,
      cube - block({1, 1, 0}, {3, 3, 4}),                                                       // a hole through
      cube - block({1, 1, 1}, {3, 3, 3}),                                                       // a void
      cube - block({0, 0, 2}, {2, 2, 4}),                                                       // a notch
      cube + block({4, 4, 0}, {6, 6, 4}),                                                       // an edge of four faces
      block({0, 0, 0}, {4, 4, 1}) - block({0, 0, 0}, {2, 2, 1}) - block({2, 2, 0}, {4, 4, 1}),  // a pinched edge
      (block({0, 0, 0}, {6, 6, 1}) - block({1, 1, 0}, {3, 3, 1})) - block({3, 3, 0}, {5, 5, 1}),  // pinched faces
      cube + needle,
      cube + spike,
      cube + needle + spike,
      (cube + needle + spike) - block({1, 1, 2}, {2, 3, 4}),
      cube - skew,
      skew ^ tetrahedron({{{0, 0, 0}, {5, 1, 0}, {1, 5, 2}, {2, 1, 6}}}),
      ~(cube + spike),
      cube.on_grid(Grid::with_step("1/3").value()).value(),
      block({0, 0, 0}, {1, 1, 1}) + block({3, 0, 0}, {4, 1, 1}),  // faces of one plane
  };

  std::vector<std::string> texts;
  for (const Solid& s : solids) texts.push_back(s.to_quoin());
  return texts;
}

inline exact::Rational volume(const Solid& solid) { return *exact::parse_rational(solid.volume().value()); }

inline bool is_closed(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t u = mesh.triangles[t + k], v = mesh.triangles[t + (k + 1) % 3];
      balance[{std::min(u, v), std::max(u, v)}] += u < v ? 1 : -1;
    }
  return std::all_of(balance.begin(), balance.end(), [](const auto& e) { return e.second == 0; });
}

/// The law that a text breaks, if it breaks one: it is refused with a place, or it is written again as it is, exported
/// closed, and united with cubes that touch and cross it has the volume that it should.
inline std::optional<std::string> broken_law(const std::string& text) {
  const auto read = Solid::from_quoin(text);
  if (!read) {
    if (read.error().code != ErrorCode::bad_quoin) return "a refusal is of the text: " + to_string(read.error().code);
    if (read.error().where.empty() || read.error().message.empty()) return "a refusal says what and where";
    return std::nullopt;
  }
  const std::string written = read.value().to_quoin();
  const auto again = Solid::from_quoin(written);
  if (!again || again.value().to_quoin() != written) return "what is accepted is written and read back";
  if (!(again.value() == read.value())) return "what is read back is the same solid";

  const Solid solid = read.value().is_bounded() ? read.value() : ~read.value();
  if (solid.is_empty()) return std::nullopt;
  const auto mesh = solid.to_triangles();
  if (!mesh || !is_closed(mesh.value())) return "what is accepted is exported closed";

  const Info info = solid.info();
  const double step = exact::parse_rational(solid.grid().step())->convert_to<double>();
  if (step < 1e-6 || step > 1e6 || solid.grid().origin() != std::array<std::string, 3>{"0", "0", "0"})
    return std::nullopt;
  std::array<double, 3> low{}, high{};
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = info.box.value()[0][k] / step;
    high[k] = info.box.value()[1][k] / step;
  }
  const auto whole = [](double x) { return static_cast<int>(x); };
  if (*std::min_element(low.begin(), low.end()) < -1e6 || *std::max_element(high.begin(), high.end()) > 1e6)
    return std::nullopt;

  for (int side = 0; side < 4; ++side) {
    std::array<int, 3> at{whole(low[0]), whole(low[1]), whole(low[2])};
    const int size = whole(high[0] - low[0]) + 1;
    if (side < 3)
      at[static_cast<std::size_t>(side)] = whole(high[static_cast<std::size_t>(side)]);  // beyond a face
    else
      at = {at[0] + 1, at[1] + 1, at[2] + 1};  // across
    std::vector<double> points;
    for (unsigned corner = 0; corner < 8; ++corner)
      for (std::size_t k = 0; k < 3; ++k) points.push_back((at[k] + ((corner >> k & 1) != 0 ? size : 0)) * step);
    const Solid cube = from_mesh(points, {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                          2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5},
                                 solid.grid());

    if (volume(solid + cube) + volume(solid & cube) != volume(solid) + volume(cube))
      return "volumes of union and intersection add up to those of the operands";
    if (!(((solid + cube) - cube) + (solid & cube) == solid)) return "a solid is what is beyond a cube and in it";
  }
  return std::nullopt;
}

}  // namespace quoin::damage
