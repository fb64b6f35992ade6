#include "booleans/body/adjacency.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "booleans/body/canonical.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

using Uses = std::multiset<std::tuple<std::uint32_t, std::uint32_t, bool>>;

// Against a look at all faces; of some vertices only where these have numbers.
TEST(Adjacency, IsWhatTheFacesSay) {
  for (std::uint64_t number = 0; number < case_count(60); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xAD1, number);
    Solids solids(random, families[number % families.size()]);
    Body body = odd(solids.next(), solids.next());
    if (random.one_in(2)) body = body_of(canonical(body));
    body = packed(body);
    if (body.face_count() == 0) continue;

    Array<Uses> at_vertex(body.vertex_count());
    for (std::uint32_t f = 0; f < body.face_count(); ++f)
      body.for_edges(f, [&](std::uint32_t u, std::uint32_t v) {
        at_vertex[u].insert({f, v, true});
        at_vertex[v].insert({f, u, false});
      });

    grid::Numbering some_vertices(body.vertex_count());
    for (std::uint32_t v = 0; v < body.vertex_count(); ++v)
      if (random.one_in(2)) some_vertices.add(v);
    const Chunk all_faces{0, static_cast<std::uint32_t>(body.face_count()), {}};
    const Adjacency all(body), some(body, some_vertices, std::span(&all_faces, 1));
    for (const Adjacency* adjacency : {&all, &some})
      for (std::uint32_t v = 0; v < body.vertex_count(); ++v) {
        if (!adjacency->knows(v)) continue;
        for (const auto& [f, w, forward] : at_vertex[v]) {
          Uses along, expected;
          adjacency->faces_at_edge(v, w, [&, to = w](std::uint32_t g, bool way) { along.insert({g, to, way}); });
          for (const auto& use : at_vertex[v])
            if (std::get<1>(use) == w) expected.insert(use);
          EXPECT_EQ(along, expected);
        }
      }
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
