/// \file
/// Segments whose boxes overlap by the square of their number.
#pragma once

#include <cmath>

#include "tests/booleans/arrangement/sketch.h"

namespace quoin::booleans::testing {

/// Distinct segments with coordinates from -size to size: from few points; side by side; between two circles, as the
/// edges of stars; any. Of one kind, or of all. Some lie on one line.
inline std::vector<std::array<Sketch::Place, 2>> any_bundles(Random& random, std::int64_t size,
                                                             std::size_t most = 250) {
  using Place = Sketch::Place;
  const auto place = [&] { return Place{random.between(-size, size), random.between(-size, size)}; };
  const std::array<Place, 2> hubs{place(), place()};
  const std::int64_t kind = random.between(0, 4);
  const Place from = place(), to = place();
  const std::size_t count = 2 + random.below(most);

  std::vector<std::array<Place, 2>> all;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t this_kind = kind == 4 ? random.between(0, 3) : kind;
    std::array<Place, 2> s{place(), place()};
    if (this_kind == 0) {
      s[0] = hubs[random.one_in(4)];
      const std::int64_t length = random.between(1, 1 + size / 8);
      if (random.one_in(4)) s[1] = {s[0][0] + length * random.between(-2, 2), s[0][1] + length * random.between(-2, 2)};
    }
    if (this_kind == 1) {
      const std::int64_t at = random.between(0, size / 4), more = random.between(0, 1);
      s = {Place{from[0] / 2 + at, from[1] / 2 - at}, Place{to[0] / 2 + at + more, to[1] / 2 - at}};
    }
    if (this_kind == 2) {
      const double angle = 6.2831853 * double(i) / double(count), turned = angle + 3.1415927 / double(count);
      const auto around = [&](double a, double r) {
        return Place{std::llround(r * double(size) * std::cos(a)), std::llround(r * double(size) * std::sin(a))};
      };
      s = {around(angle, 1), around(turned, 0.5)};
      if (random.one_in(2)) std::swap(s[0], s[1]);
    }
    if (s[0] != s[1]) all.push_back(s);
  }
  if (all.empty()) all.push_back({Place{0, 0}, Place{1, 1}});
  return all;
}

}  // namespace quoin::booleans::testing
