#include "booleans/body/validity.h"

#include <gtest/gtest.h>

#include "booleans/body/canonical.h"
#include "booleans/embedding.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

TEST(Validity, CanonicalFormsHaveNoFault) {
  for (std::uint64_t number = 0; number < case_count(150); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xFA0, number);
    Solids solids(random, families[number % families.size()]);
    const Body body = odd(solids.next(), solids.next());
    for (const Body& b : {body, complement(body)}) {
      const auto found = fault(canonical(b));
      EXPECT_FALSE(found) << found->message << ", " << found->where;
    }
  }
}

// A wedge that stands on a face with its edge: the face has that edge in both directions.
TEST(Validity, ASlitIsNoFault) {
  const Body wedge = *prism({3, 4, 2}, {3, 5, 4}, {3, 3, 4}, {2, 0, 0});
  const Canonical form = canonical(any(box({0, 0, 0}, {8, 8, 2}), wedge));
  EXPECT_EQ(form.faces.loop_count(), form.face_count() + 1);
  const auto found = fault(form);
  EXPECT_FALSE(found) << found->message << ", " << found->where;
}

/// A boundary with a few of its corners, loops or planes changed.
Boundary changed(const Canonical& form, Random& random) {
  Boundary r = form;
  auto& corners = r.faces.corners;
  const auto corner = [&]() -> std::uint32_t& { return corners[random.below(corners.size())]; };
  switch (random.below(6)) {
    case 0:
      corner() = corner();
      break;
    case 1:
      std::swap(corner(), corner());
      break;
    case 2:
      std::swap(r.planes[random.below(r.planes.size())], r.planes[random.below(r.planes.size())]);
      break;
    case 3:
      std::swap(r.vertices[random.below(r.vertices.size())], r.vertices[random.below(r.vertices.size())]);
      break;
    case 4: {  // another start of a loop
      const std::size_t j = random.below(r.faces.loop_count());
      std::rotate(corners.begin() + r.faces.loop_start[j], corners.begin() + r.faces.loop_start[j] + 1,
                  corners.begin() + r.faces.loop_start[j + 1]);
      break;
    }
    default: {  // two faces change places
      if (r.face_count() < 2) break;
      grid::Loops<std::uint32_t> faces;
      const std::size_t first = random.below(r.face_count() - 1);
      for (std::size_t f = 0; f < r.face_count(); ++f) {
        r.faces.for_loops(f == first       ? f + 1
                          : f == first + 1 ? f - 1
                                           : f,
                          [&](std::span<const std::uint32_t> loop) { faces.add_loop(loop); });
        faces.end_face();
      }
      std::swap(r.planes[first], r.planes[first + 1]);
      r.faces = faces;
    }
  }
  return r;
}

// What has no fault and is embedded makes a clean body, whatever the order: its canonical form is its own, and it takes
// part in Booleans as that form does.
TEST(Validity, WhatIsValidAndEmbeddedIsASolid) {
  std::size_t valid = 0, refused = 0;
  for (std::uint64_t number = 0; number < case_count(600); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xFA1, number);
    Solids solids(random, families[number % families.size()]);
    const Canonical form = canonical(odd(solids.next(), solids.next()));
    if (form.face_count() == 0) continue;
    const Boundary other = changed(form, random);
    const Body body = body_of(other);
    if (fault(other) || embedding_fault(body)) {
      ++refused;
      EXPECT_FALSE(other == form);
      continue;
    }
    ++valid;
    const Body again = body_of(canonical(body));
    EXPECT_TRUE(canonical(again) == canonical(body));
    EXPECT_EQ(volume(again), volume(body));
    EXPECT_TRUE(empty(odd(again, body)));
  }
  EXPECT_GT(refused, 0u);
  EXPECT_GT(valid, 0u);
}

}  // namespace
}  // namespace quoin::booleans::testing
