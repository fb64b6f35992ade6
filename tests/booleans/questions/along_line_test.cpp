#include "booleans/questions/along_line.h"

#include <gtest/gtest.h>

#include "tests/booleans/questions/places.h"

namespace quoin::booleans::testing {
namespace {

/// A solid of the family, one time in two a result with derived points, one time in four unbounded.
Body any_solid(Random& random, Family family) {
  Solids solids(random, family);
  for (;;) {
    Body body = solids.next();
    if (random.one_in(2)) body = odd(body, solids.next());
    if (random.one_in(4)) body = complement(body);
    if (packed(body).face_count() > 0) return body;
  }
}

/// check(body, index, random) for solids of all families.
template <class Check>
void for_solids(std::uint64_t salt, std::uint64_t count, Check&& check) {
  for (const Family family : families)
    for (std::uint64_t number = 0; number < case_count(count); ++number) {
      SCOPED_TRACE(std::string(name_of(family)) + " " + case_name(number));
      Random random(salt, number);
      const Body body = any_solid(random, family);
      check(packed(body), Index(body), random);  // an operation may leave it patched
    }
}

/// One direction in four along an axis, half of all towards another place at the body.
RationalPlace any_direction(Random& random, const Body& body, const RationalPlace& from) {
  RationalPlace d{0, 0, 0};
  while (d == RationalPlace{0, 0, 0}) {
    const std::uint64_t kind = random.below(4);
    const RationalPlace to = any_place(random, body);
    for (std::size_t k = 0; k < 3; ++k) d[k] = kind < 2 ? Rational(to[k] - from[k]) : Rational(random.between(-2, 2));
    if (kind == 3) d = {0, 0, 0}, d[random.below(3)] = random.one_in(2) ? 1 : -1;
  }
  return d;
}

// Against the sum over all faces of the solid as it is stored.
TEST(AlongLine, LocateAgreesWithTheScanOfAllFaces) {
  std::array<int, 3> seen{};
  for_solids(0x9E51, 40, [&](const Body& body, const Index& index, Random& random) {
    for (int i = 0; i < 12; ++i) {
      const RationalPlace p = any_place(random, body);
      const int where = locate(index, QueryPoint(p));
      ASSERT_EQ(where, locate(body, p));
      ++seen[static_cast<std::size_t>(where + 1)];
    }
  });
  for (const int count : seen) EXPECT_GT(count, 0);
}

/// What holds of the points of a passage from 0 to `last`, by the scan of all faces.
void expect_pieces(const Body& body, const Passage& passage, const RationalPlace& p, const RationalPlace& d,
                   const std::optional<Rational>& last) {
  const auto where = [&](const Rational& t) { return locate(body, point_along(p, d, t)); };
  EXPECT_EQ(passage.start, where(0));
  Rational at = 0;
  int side = passage.start;
  for (const Contact& c : passage.contacts) {
    ASSERT_LE(c.begin, c.end);
    if (c.begin > 0 || c.before != 0) {
      if (c.begin > at) {
        ASSERT_EQ(where((at + c.begin) / 2), side);
        ASSERT_EQ(c.before, side);
      } else {
        ASSERT_EQ(c.begin, 0);  // only the first begins where something else ends
        ASSERT_EQ(at, 0);
      }
    }
    for (const Rational& t : {c.begin, Rational((c.begin + c.end) / 2), c.end}) ASSERT_EQ(where(t), 0);
    at = c.end;
    side = c.behind;
  }
  const Rational end = last ? *last : Rational(at + 1000000000);
  if (end > at) {
    ASSERT_EQ(where((at + end) / 2), side);
    ASSERT_EQ(where(end), side);
  }
}

/// Where the line meets the planes of faces there is a contact exactly where that is on the boundary; the faces of
/// points are those that hold them.
void expect_all(const Body& body, const Passage& passage, const RationalPlace& p, const RationalPlace& d,
                const std::optional<Rational>& last) {
  const Canonical form = canonical(body);
  for (const exact::Plane& plane : form.planes) {
    const Rational slope = slope_along(plane, d);
    if (slope == 0) continue;
    const Rational t = -value_at(plane, p) / slope;
    if (t < 0 || (last && t > *last)) continue;
    const bool is_in_contact = std::any_of(passage.contacts.begin(), passage.contacts.end(),
                                           [&](const Contact& c) { return c.begin <= t && t <= c.end; });
    ASSERT_EQ(is_in_contact, locate(body, point_along(p, d, t)) == 0);
  }
  for (const Contact& c : passage.contacts)
    for (const Rational& t : {c.begin, Rational((c.begin + c.end) / 2), c.end})
      for (std::uint32_t f = 0; f < form.face_count(); ++f) {
        const bool is_named = std::binary_search(c.faces.begin(), c.faces.end(), f);
        const bool holds = face_holds(form, f, point_along(p, d, t));
        ASSERT_TRUE(c.begin == c.end ? is_named == holds : is_named || !holds);
      }
}

/// Just before and just behind a contact, where it does not go on.
void expect_sides(const Body& body, const Contact& c, const RationalPlace& p, const RationalPlace& d) {
  const Rational hair(1, exact::Integer(exact::Integer(1) << 200));
  ASSERT_EQ(locate(body, point_along(p, d, c.begin - hair)), c.before);
  ASSERT_EQ(locate(body, point_along(p, d, c.end + hair)), c.behind);
}

TEST(AlongLine, PassagesAgreeWithTheScanOfAllFaces) {
  std::size_t touched = 0, crossed = 0, along = 0, cut = 0;
  for_solids(0x9E52, 14, [&](const Body& body, const Index& index, Random& random) {
    for (int i = 0; i < 5; ++i) {
      const RationalPlace p = any_place(random, body), d = any_direction(random, body, p);
      const std::optional<Rational> last =
          random.one_in(2) ? std::optional<Rational>(Rational(random.between(0, 4)) / 2) : std::nullopt;
      const Passage found = passage(index, Line(QueryPoint(p), d), last);
      expect_pieces(body, found, p, d, last);
      expect_all(body, found, p, d, last);
      for (const Contact& c : found.contacts) {
        expect_sides(body, c, p, d);
        ++(c.before == 0 || c.behind == 0 ? cut : c.begin < c.end ? along : c.before == c.behind ? touched : crossed);
      }
      if (HasFatalFailure()) return;
    }
  });
  EXPECT_GT(touched, 0u);
  EXPECT_GT(crossed, 0u);
  EXPECT_GT(along, 0u);
  EXPECT_GT(cut, 0u);
}

// From the other end of a segment the same contacts, in the other order.
TEST(AlongLine, SegmentsThereAndBack) {
  for_solids(0x9E53, 20, [&](const Body& body, const Index& index, Random& random) {
    const RationalPlace p = any_place(random, body), q = any_place(random, body);
    if (p == q) return;
    const auto from = [&](const RationalPlace& a, const RationalPlace& b) {
      return passage(index, Line(QueryPoint(a), {Rational(b[0] - a[0]), Rational(b[1] - a[1]), Rational(b[2] - a[2])}),
                     Rational(1))
          .contacts;
    };
    const auto there = from(p, q), back = from(q, p);
    ASSERT_EQ(there.size(), back.size());
    for (std::size_t i = 0; i < there.size(); ++i) {
      const Contact &a = there[i], &b = back[back.size() - 1 - i];
      EXPECT_EQ(a.begin, Rational(1 - b.end));
      EXPECT_EQ(a.end, Rational(1 - b.begin));
      EXPECT_EQ(a.before, b.behind);
      EXPECT_EQ(a.behind, b.before);
      EXPECT_EQ(a.faces, b.faces);
    }
  });
}

// Doubles in model units, through intervals, and the same numbers as rationals.
TEST(AlongLine, PlacesInModelUnits) {
  for_solids(0x9E54, 20, [&](const Body& body, const Index& index, Random& random) {
    const Rational step = random.one_in(2) ? Rational(1, std::int64_t{1} << random.below(20))
                                           : Rational(1 + random.between(0, 9), 1 + random.between(0, 9));
    const grid::Lattice lattice{step, {Rational(random.between(-2, 2), 3), 0, Rational(random.between(-9, 9))}};
    const ModelFrame frame(lattice);
    for (int i = 0; i < 10; ++i) {
      const RationalPlace wanted = any_place(random, body);
      std::array<double, 3> model{};
      RationalPlace p{};
      for (std::size_t k = 0; k < 3; ++k) {
        model[k] = exact::to_double(wanted[k] * step + lattice.origin[k]);
        p[k] = (exact::to_rational(model[k]) - lattice.origin[k]) / step;
      }
      EXPECT_EQ(locate(index, QueryPoint(frame, model)), locate(body, p));
    }
  });
}

TEST(AlongLine, OfNothingAndOfAllSpace) {
  const QueryPoint origin(RationalPlace{0, 0, 0});
  Body nothing, all;
  all.full_at_infinity = true;
  EXPECT_EQ(locate(Index(nothing), origin), -1);
  EXPECT_EQ(locate(Index(all), origin), 1);
  const Line line(origin, RationalPlace{1, 2, 3});
  EXPECT_EQ(passage(Index(nothing), line, std::nullopt).start, -1);
  EXPECT_EQ(passage(Index(all), line, std::nullopt).start, 1);
  EXPECT_TRUE(passage(Index(all), line, std::nullopt).contacts.empty());
}

// Answers do not depend on how the solid is stored.
TEST(AlongLine, StorageDoesNotMatter) {
  for_solids(0x9E55, 10, [&](const Body& body, const Index& index, Random& random) {
    const Index other(body_of(canonical(body)));
    EXPECT_EQ(index.face_count(), other.face_count());
    const RationalPlace p = any_place(random, body), d = any_direction(random, body, p);
    const auto a = passage(index, Line(QueryPoint(p), d), std::nullopt),
               b = passage(other, Line(QueryPoint(p), d), std::nullopt);
    ASSERT_EQ(a.contacts.size(), b.contacts.size());
    for (std::size_t i = 0; i < a.contacts.size(); ++i) EXPECT_EQ(a.contacts[i].faces, b.contacts[i].faces);
  });
}

}  // namespace
}  // namespace quoin::booleans::testing
