#include "api/doors/placed.h"

#include <algorithm>
#include <cmath>

#include "exact/rational.h"
#include "rounding/motions/realize.h"

namespace quoin {
namespace {

using exact::Rational;
using exact::to_double;
using exact::to_rational;
using rounding::AffineMap;

AffineMap map_of(const io::MatrixStep& step) {
  AffineMap map;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) map.linear[i][j] = to_rational(step.rows[4 * i + j]);
    map.shift[i] = to_rational(step.rows[4 * i + 3]);
  }
  return map;
}

AffineMap map_of(const io::DivisionStep& step) {
  AffineMap map;
  for (std::size_t k = 0; k < 3; ++k) map.linear[k][k] = Rational(1) / to_rational(step.by);
  return map;
}

AffineMap map_of(const io::AngleStep& step) {
  rounding::Vector axis = {0, 0, 0};
  axis[step.axis] = 1;
  return realize(rounding::Motion::rotation(axis, to_rational(step.degrees))).map;
}

/// a b as a sum of doubles without an error. Precondition: neither overflow nor underflow.
std::array<double, 2> product(double a, double b) {
  const double high = a * b;
  return {high, std::fma(a, b, -high)};
}

/// a + b as a sum of doubles without an error (D. Knuth).
std::array<double, 2> sum(double a, double b) {
  const double high = a + b, part = high - a;
  return {high, (a - (high - part)) + (b - part)};
}

/// Whether products of two such numbers stay far from the ends of the range of double.
bool is_tame(double v) { return v == 0 || (std::fabs(v) > 0x1p-300 && std::fabs(v) < 0x1p300); }

}  // namespace

Rational millimeters(Unit unit) {
  switch (unit) {
    case Unit::micron:
      return Rational(1, 1000);
    case Unit::centimeter:
      return 10;
    case Unit::inch:
      return Rational(254, 10);
    case Unit::foot:
      return Rational(3048, 10);
    case Unit::meter:
      return 1000;
    case Unit::none:
    case Unit::millimeter:
      break;
  }
  return 1;
}

Result<AffineMap> map_of(const io::Placing& placing) {
  AffineMap map;
  for (const auto& step : placing) {
    if (const auto* matrix = std::get_if<io::MatrixStep>(&step)) {
      map = composed(map, map_of(*matrix));
    } else if (const auto* angle = std::get_if<io::AngleStep>(&step)) {
      map = composed(map, map_of(*angle));
    } else if (const auto* division = std::get_if<io::DivisionStep>(&step)) {
      map = composed(map, map_of(*division));
    } else {
      const auto& [x, y, z, w] = std::get<io::QuaternionStep>(step).by;
      const auto along = rounding::quaternion_along({to_rational(w), to_rational(x), to_rational(y), to_rational(z)});
      if (!along) return Error{ErrorCode::non_finite, "a quaternion of length 0 names no rotation"};
      map = composed(map, AffineMap{rounding::matrix(*along), {0, 0, 0}});
    }
  }
  return map;
}

RoundedMap::RoundedMap(const AffineMap& map) : map_(map) {
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t j = 0; j < 4; ++j) {
      const Rational& entry = j < 3 ? map.linear[k][j] : map.shift[k];
      const double high = to_double(entry);
      is_tame_ = is_tame_ && is_tame(high);
      rows_[k][j] = {high, is_tame_ ? to_double(entry - to_rational(high)) : 0};
    }
}

double RoundedMap::exactly(std::size_t k, const std::array<double, 3>& p) const {
  return to_double(rounding::dot(map_.linear[k], {to_rational(p[0]), to_rational(p[1]), to_rational(p[2])}) +
                   map_.shift[k]);
}

std::array<double, 3> RoundedMap::operator()(const std::array<double, 3>& p) const {
  std::array<double, 3> image;
  const bool tame = is_tame_ && std::all_of(p.begin(), p.end(), is_tame);
  for (std::size_t k = 0; k < 3; ++k) {
    if (!tame) {
      image[k] = exactly(k, p);
      continue;
    }

    double high = 0, low = 0, size = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      const double factor = j < 3 ? p[j] : 1;
      const auto [term, rest] = product(rows_[k][j].high, factor);
      const auto [total, lost] = sum(high, term);
      high = total;
      low += lost + rest + rows_[k][j].low * factor;
      size += std::fabs(term);
    }
    // Law: high + low is within 2^-98 size of the image. Entries are off by 2^-105 of themselves; `low` is a sum of
    // twelve terms of at most 2^-51 size, each sum rounded: less than 2^-99 size together.
    // Trap: a sum of 0 is left to the rationals, since its sign is theirs.
    const double error = size * 0x1p-97;
    const double below = high + (low - error), above = high + (low + error);
    image[k] = below == above && below != 0 ? below : exactly(k, p);
  }
  return image;
}

Result<io::PolygonMesh> placed_mesh(io::PolygonMesh mesh, const AffineMap& map) {
  if (map == AffineMap{}) return mesh;
  const Rational size = rounding::determinant(map.linear);
  if (size == 0) return Error{ErrorCode::bad_syntax, "a transform flattens what it places"};

  const RoundedMap rounded(map);
  for (std::size_t i = 0; i < mesh.points.size(); i += 3) {
    const auto image = rounded({mesh.points[i], mesh.points[i + 1], mesh.points[i + 2]});
    if (!std::all_of(image.begin(), image.end(), [](double v) { return std::isfinite(v); }))
      return Error{ErrorCode::non_finite, "vertex " + std::to_string(i / 3) + " is not finite where it is placed"};
    std::copy(image.begin(), image.end(), mesh.points.begin() + static_cast<std::ptrdiff_t>(i));
  }
  if (size < 0)
    for (std::size_t i = 0; i + 1 < mesh.starts.size(); ++i)
      std::reverse(mesh.corners.begin() + mesh.starts[i], mesh.corners.begin() + mesh.starts[i + 1]);
  return mesh;
}

}  // namespace quoin
