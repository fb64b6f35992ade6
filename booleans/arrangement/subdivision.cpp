#include "booleans/arrangement/subdivision.h"

#include <set>

namespace quoin::booleans {
namespace {

bool before(const Names& names, const Outline& outline, VertexId a, VertexId b) {
  return outline.frame.compare(names.vertices, a, b) < 0;
}

/// +1 when the vertex lies above (left of) the element's line, 0 on it, -1 below. Left of n x n_line is where the
/// line's plane is negative.
int above(const Names& names, const Drawing::Elements& elements, VertexId v, std::uint32_t e) {
  return -elements.direction[e] * names.side(v, elements.list[e].line);
}

/// +1 when the vertex lies on the left of the half-edge, 0 on its line, -1 on the right.
int left_of(const Names& names, const Drawing::Elements& elements, std::uint32_t h, VertexId v) {
  return h & 1 ? -above(names, elements, v, h / 2) : above(names, elements, v, h / 2);
}

std::uint32_t facet_left_of(const Drawing::LoopIds& loops, const Drawing::Facets& facets, std::uint32_t h) {
  return facets.of_loop[loops.of[h]];
}

/// By segment, then along it.
void sort_splits(const Names& names, Outline& outline) {
  std::sort(outline.splits.begin(), outline.splits.end(), [&](const Outline::Split& s, const Outline::Split& t) {
    if (s.segment != t.segment) return s.segment < t.segment;
    return s.vertex != t.vertex && before(names, outline, s.vertex.named(), t.vertex.named());
  });
}

/// The segments, cut at their splits; equal pieces stand together.
const std::vector<Drawing::Piece>& cut_segments(const Outline& outline, std::vector<Drawing::Piece>& pieces) {
  const auto& splits = outline.splits;
  pieces.clear();
  std::size_t at = 0;
  for (std::uint32_t i = 0; i < outline.segments.size(); ++i) {
    const Outline::Segment& s = outline.segments[i];
    VertexId from = s.a;
    for (; at < splits.size() && splits[at].segment == i; ++at) {
      const VertexId v = splits[at].vertex.named();
      if (v == from) continue;
      pieces.push_back({from, v, s.line, i});
      from = v;
    }
    pieces.push_back({from, s.b, s.line, i});
  }

  std::sort(pieces.begin(), pieces.end(), [](const Drawing::Piece& p, const Drawing::Piece& q) {
    return p.a != q.a ? p.a < q.a : p.b != q.b ? p.b < q.b : p.segment < q.segment;
  });
  return pieces;
}

/// Equal pieces become one element with the changes of all.
const Drawing::Elements& unite_pieces(const Names& names, const Outline& outline,
                                      const std::vector<Drawing::Piece>& pieces, Drawing::Elements& elements) {
  auto& list = elements.list;
  auto& changes = elements.changes;
  list.clear();
  elements.direction.clear();
  elements.change_start.clear();
  changes.clear();

  for (const Drawing::Piece& p : pieces) {
    if (list.empty() || list.back().a != p.a || list.back().b != p.b) {
      list.push_back({p.a, p.b, p.line});
      elements.direction.push_back(outline.frame.direction(names.planes[outline.plane], names.planes[p.line]));
      elements.change_start.push_back(static_cast<std::uint32_t>(changes.size()));
    }
    for (std::uint32_t c = outline.change_start[p.segment]; c < outline.change_start[p.segment + 1]; ++c)
      changes.push_back(outline.changes[c]);
  }
  elements.change_start.push_back(static_cast<std::uint32_t>(changes.size()));
  return elements;
}

const Drawing::Order& order_vertices(const Names& names, const Outline& outline, const Drawing::Elements& elements,
                                     Drawing::Order& order) {
  auto& vertices = order.vertices;
  auto& rank_of = order.rank_of;
  for (const VertexId v : vertices) rank_of[v] = none;  // those of the sheet before
  vertices.clear();
  if (rank_of.size() < names.vertices.size()) rank_of.resize(names.vertices.size(), none);
  const auto add = [&](VertexId v) {
    if (rank_of[v] != none) return;
    vertices.push_back(v);
    rank_of[v] = 0;
  };
  for (const VertexId v : outline.points) add(v);
  for (const auto& e : elements.list) {
    add(e.a);
    add(e.b);
  }
  std::sort(vertices.begin(), vertices.end(), [&](VertexId a, VertexId b) { return before(names, outline, a, b); });

  for (std::uint32_t i = 0; i < vertices.size(); ++i) rank_of[vertices[i]] = i;
  order.rank.resize(elements.half_edges());
  for (std::uint32_t h = 0; h < order.rank.size(); ++h) order.rank[h] = rank_of[elements.origin(h)];
  return order;
}

const Drawing::Rotation& sort_around_vertices(const Names& names, const Drawing::Elements& elements,
                                              const Drawing::Order& order, Drawing::Rotation& rotation) {
  auto& out = rotation.out;
  auto& clockwise = rotation.clockwise;
  const auto& rank = order.rank;
  out.assign(order.vertices.size(), [&](auto&& visit) {
    for (std::uint32_t h = 0; h < rank.size(); ++h) visit(rank[h], h);
  });

  // Counter-clockwise from straight down: first the half-edges that run forward (to the right), then the others. Within
  // a half, which spans less than a straight angle, the later one ends on the left of the earlier one.
  const auto earlier = [&](std::uint32_t g, std::uint32_t h) {
    if ((g & 1) != (h & 1)) return (g & 1) == 0;
    return g != h && left_of(names, elements, g, elements.origin(h ^ 1)) > 0;
  };
  clockwise.resize(rank.size());
  for (std::size_t v = 0; v < out.size(); ++v) {
    const std::span<std::uint32_t> around = out[v];
    if (around.size() == 2) {
      if (earlier(around[1], around[0])) std::swap(around[0], around[1]);
    } else if (around.size() > 2) {
      std::sort(around.begin(), around.end(), earlier);
    }
    for (std::size_t i = 0; i < around.size(); ++i) clockwise[around[i]] = around[(i > 0 ? i : around.size()) - 1];
  }
  return rotation;
}

const Drawing::LoopIds& trace_loops(const Drawing::Rotation& rotation, Drawing::LoopIds& loops) {
  auto& of = loops.of;
  loops.count = 0;
  of.assign(rotation.clockwise.size(), none);
  for (std::uint32_t h = 0; h < of.size(); ++h) {
    if (of[h] != none) continue;
    for (std::uint32_t g = h; of[g] == none; g = rotation.clockwise[g ^ 1]) of[g] = loops.count;
    ++loops.count;
  }
  return loops;
}

/// The loop that looks outward is the one that sees "left" at the leftmost vertex.
const Drawing::Components& find_components(const Drawing::Order& order, const Drawing::Rotation& rotation,
                                           const Drawing::LoopIds& loops, Drawing::Components& components) {
  auto& of = components.of;
  auto& stack = components.stack;
  of.assign(order.vertices.size(), none);
  components.leftmost.clear();
  components.outward.clear();
  for (std::uint32_t v = 0; v < of.size(); ++v) {
    if (of[v] != none) continue;
    const auto c = static_cast<std::uint32_t>(components.leftmost.size());
    const auto around = rotation.out[v];
    components.leftmost.push_back(v);
    components.outward.push_back(around.empty() ? none : loops.of[around.back()]);
    of[v] = c;

    stack.assign(1, v);
    while (!stack.empty()) {
      const std::uint32_t w = stack.back();
      stack.pop_back();
      for (const std::uint32_t h : rotation.out[w]) {
        const std::uint32_t x = order.rank[h ^ 1];
        if (of[x] != none) continue;
        of[x] = c;
        stack.push_back(x);
      }
    }
  }
  return components;
}

/// The sweep's order of elements that a vertical line crosses, and of a vertex among them: no two elements cross.
struct Lower {
  struct Vertex {
    VertexId id;
  };
  using is_transparent = void;
  const Names& names;
  const Outline& outline;
  const Drawing::Elements& elements;

  bool operator()(std::uint32_t e, std::uint32_t f) const {
    if (e == f) return false;
    const auto &p = elements.list[e], &q = elements.list[f];
    if (p.a == q.a) return above(names, elements, q.b, e) > 0;
    if (before(names, outline, p.a, q.a)) return above(names, elements, q.a, e) > 0;
    return above(names, elements, p.a, f) < 0;
  }
  bool operator()(std::uint32_t e, Vertex v) const { return above(names, elements, v.id, e) > 0; }
  bool operator()(Vertex v, std::uint32_t e) const { return above(names, elements, v.id, e) < 0; }
};

/// The element below the leftmost vertex of each component, none where there is none: by one sweep over the vertices.
const std::vector<std::uint32_t>& find_elements_below(const Lower& lower, const Drawing::Order& order,
                                                      const Drawing::Rotation& rotation,
                                                      const Drawing::Components& components,
                                                      std::vector<std::uint32_t>& below) {
  below.assign(components.leftmost.size(), none);
  if (below.size() == 1) return below;

  using Status = std::set<std::uint32_t, Lower>;
  Status status(lower);
  std::vector<Status::iterator> place(lower.elements.list.size());
  for (std::uint32_t v = 0; v < order.vertices.size(); ++v) {
    const std::uint32_t c = components.of[v];
    if (components.leftmost[c] == v && !status.empty()) {
      // The highest element below v: the last one that v is above. Nothing passes through the vertex.
      const auto at = status.lower_bound(Lower::Vertex{order.vertices[v]});
      if (at != status.begin()) below[c] = *std::prev(at);
    }
    for (const std::uint32_t h : rotation.out[v])
      if (h & 1) status.erase(place[h / 2]);
    for (const std::uint32_t h : rotation.out[v])
      if (!(h & 1)) place[h / 2] = status.insert(h / 2).first;
  }
  return below;
}

/// Assigns facets to loops. A component's outward loop belongs to the facet above the element below its leftmost
/// vertex; every other loop bounds a facet of its own.
const Drawing::Facets& nest_components(const Drawing::LoopIds& loops, const Drawing::Components& components,
                                       const std::vector<std::uint32_t>& below, Drawing::Facets& facets) {
  const auto& outward = components.outward;
  facets.count = 1;
  facets.of_loop.assign(loops.count, none);
  for (const std::uint32_t l : outward)
    if (l != none) facets.of_loop[l] = 0;
  for (std::uint32_t& f : facets.of_loop)
    if (f == none) f = facets.count++;

  // From left to right: the element below belongs to a component that is nested already.
  facets.of_component.assign(outward.size(), 0);
  for (std::size_t c = 0; c < outward.size(); ++c) {
    if (below[c] == none) continue;
    facets.of_component[c] = facet_left_of(loops, facets, 2 * below[c]);
    if (outward[c] != none) facets.of_loop[outward[c]] = facets.of_component[c];
  }
  return facets;
}

const grid::Buckets<>& collect_sides(const Drawing::LoopIds& loops, const Drawing::Facets& facets,
                                     grid::Buckets<>& sides) {
  sides.assign(facets.count, [&](auto&& visit) {
    for (std::uint32_t h = 0; h < loops.of.size(); ++h) visit(facet_left_of(loops, facets, h), h);
  });
  return sides;
}

/// Turns list[begin] .., the cover on the left of the half-edge, into that on its right.
void cross(const Drawing::Elements& elements, std::uint32_t h, std::uint32_t begin,
           std::vector<Drawing::Covers::Cover>& list) {
  // Half-edge 2e has the left side here, so going to the right takes the change away.
  const int sign = h & 1 ? 1 : -1;
  for (std::uint32_t c = elements.change_start[h / 2]; c < elements.change_start[h / 2 + 1]; ++c) {
    const Outline::Change& change = elements.changes[c];
    std::uint32_t i = begin;
    while (i < list.size() && list[i].face != change.face) ++i;
    if (i == list.size()) list.push_back({change.face, 0});
    list[i].times += sign * change.by;
    if (list[i].times != 0) continue;
    list[i] = list.back();
    list.pop_back();
  }
  std::sort(list.begin() + begin, list.end(),
            [](const Drawing::Covers::Cover& x, const Drawing::Covers::Cover& y) { return x.face < y.face; });
}

/// Walks from the unbounded facet over the elements.
const Drawing::Covers& cover_facets(const Drawing::Elements& elements, const Drawing::LoopIds& loops,
                                    const Drawing::Facets& facets, const grid::Buckets<>& sides,
                                    Drawing::Covers& covers) {
  auto& list = covers.list;
  auto& of = covers.of;
  auto& stack = covers.stack;
  list.clear();
  of.assign(facets.count, {none, none});
  of[0] = {0, 0};
  stack.assign(1, 0u);
  while (!stack.empty()) {
    const std::uint32_t from = stack.back();
    stack.pop_back();
    for (const std::uint32_t h : sides[from]) {
      const std::uint32_t to = facet_left_of(loops, facets, h ^ 1);
      if (of[to][0] != none) continue;
      stack.push_back(to);

      const auto begin = static_cast<std::uint32_t>(list.size());
      for (std::uint32_t i = of[from][0]; i < of[from][1]; ++i) list.push_back(Drawing::Covers::Cover(list[i]));
      cross(elements, h, begin, list);
      of[to] = {begin, static_cast<std::uint32_t>(list.size())};
    }
  }
  return covers;
}

/// Names the covered facets and lists their covers.
const std::vector<FacetId>& list_covers(const Drawing::Covers& covers, SheetLists& lists, std::vector<FacetId>& names) {
  names.assign(covers.of.size(), none);
  std::uint32_t count = 0;
  const std::size_t first = lists.cover.size();
  lists.cover_start.push_back(0);
  for (std::size_t f = 0; f < covers.of.size(); ++f) {
    const auto [begin, end] = covers.of[f];
    if (begin == end) continue;
    names[f] = count++;

    // A face lies on the left of its boundary, so no count is negative; of bad input the labels show it (selection.h).
    for (std::uint32_t i = begin; i < end; ++i) {
      const Drawing::Covers::Cover& c = covers.list[i];
      lists.cover.insert(lists.cover.end(), static_cast<std::size_t>(std::max(c.times, 0)), c.face);
    }
    lists.cover_start.push_back(static_cast<std::uint32_t>(lists.cover.size() - first));
  }
  return names;
}

void list_half_edges(const Drawing::Elements& elements, const Drawing::Rotation& rotation,
                     const Drawing::LoopIds& loops, const Drawing::Facets& facets, const std::vector<FacetId>& names,
                     SheetLists& lists) {
  for (std::uint32_t h = 0; h < elements.half_edges(); ++h)
    lists.facet.push_back(names[facet_left_of(loops, facets, h)]);
  lists.elements.insert(lists.elements.end(), elements.list.begin(), elements.list.end());
  lists.clockwise.insert(lists.clockwise.end(), rotation.clockwise.begin(), rotation.clockwise.end());
}

void list_isolated(const Drawing::Order& order, const Drawing::Components& components, const Drawing::Facets& facets,
                   const std::vector<FacetId>& names, SheetLists& lists) {
  for (std::size_t c = 0; c < components.leftmost.size(); ++c) {
    if (components.outward[c] != none) continue;
    const FacetId f = names[facets.of_component[c]];
    if (f != none) lists.isolated.push_back({order.vertices[components.leftmost[c]], f});
  }
}

}  // namespace

void draw(const Names& names, Outline& outline, Drawing& drawing, SheetLists& lists) {
  sort_splits(names, outline);
  const auto& pieces = cut_segments(outline, drawing.pieces);
  const auto& elements = unite_pieces(names, outline, pieces, drawing.elements);

  const auto& order = order_vertices(names, outline, elements, drawing.order);
  const auto& rotation = sort_around_vertices(names, elements, order, drawing.rotation);
  const auto& loops = trace_loops(rotation, drawing.loops);

  const auto& components = find_components(order, rotation, loops, drawing.components);
  const auto& below = find_elements_below({names, outline, elements}, order, rotation, components, drawing.below);
  const auto& facets = nest_components(loops, components, below, drawing.facets);

  const auto& sides = collect_sides(loops, facets, drawing.sides);
  const auto& covers = cover_facets(elements, loops, facets, sides, drawing.covers);

  const auto& facet_names = list_covers(covers, lists, drawing.names);
  list_half_edges(elements, rotation, loops, facets, facet_names, lists);
  list_isolated(order, components, facets, facet_names, lists);
}

}  // namespace quoin::booleans
