#include "booleans/arrangement/subdivision.h"

#include <bit>
#include <numeric>
#include <set>

namespace quoin::booleans {
namespace {

/// Where vertices lie on the sheet, and beside its elements.
struct View {
  const Names& names;
  const Outline& outline;
  const Drawing::Elements& elements;

  bool before(VertexId a, VertexId b) const { return outline.frame.compare(names.vertices, a, b) < 0; }
  /// +1 when the vertex lies above (left of) the element's line, 0 on it, -1 below. Left of n x n_line is where the
  /// line's plane is negative.
  int above(VertexId v, std::uint32_t e) const {
    const PlaneId line = elements.list[e].line;
    return -outline.frame.direction(names.planes[outline.plane], names.planes[line]) * names.side(v, line);
  }
  /// Of two half-edges of one vertex that run forward both, or backward both: does g come first counter-clockwise from
  /// straight down? They span less than a straight angle, so it does when h ends on its left.
  bool earlier_around(std::uint32_t g, std::uint32_t h) const {
    const int up = above(elements.origin(h ^ 1), g / 2);
    return (g & 1 ? -up : up) > 0;
  }
};

/// By segment, then along it.
void sort_splits(const View& view, std::vector<Outline::Split>& splits) {
  std::sort(splits.begin(), splits.end(), [&](const Outline::Split& s, const Outline::Split& t) {
    if (s.segment != t.segment) return s.segment < t.segment;
    return s.vertex != t.vertex && view.before(s.vertex.named(), t.vertex.named());
  });
}

/// The segments, cut at their splits; equal pieces stand together.
const std::vector<Drawing::Piece>& cut_segments(const Outline& outline, std::vector<Drawing::Piece>& pieces) {
  pieces.resize(outline.segments.size() + outline.splits.size());
  auto piece = pieces.begin();
  auto split = outline.splits.begin();
  std::uint32_t i = 0;
  for (const Outline::Segment& s : outline.segments) {
    VertexId from = s.a;
    for (; split != outline.splits.end() && split->segment == i; ++split) {
      const VertexId v = split->vertex.named();
      if (v != from) *piece++ = {std::exchange(from, v), v, s.line, i};
    }
    *piece++ = {from, s.b, s.line, i++};
  }
  pieces.erase(piece, pieces.end());

  std::sort(pieces.begin(), pieces.end(), [](const Drawing::Piece& p, const Drawing::Piece& q) {
    return p.a != q.a ? p.a < q.a : p.b != q.b ? p.b < q.b : p.segment < q.segment;
  });
  return pieces;
}

/// Equal pieces become one element.
const Drawing::Elements& unite_pieces(const std::vector<Drawing::Piece>& pieces, Array<Sheet::Element>& list,
                                      Drawing::Elements& elements) {
  const std::size_t begin = list.size();
  list.resize(begin + pieces.size());
  elements.first_piece.resize(pieces.size() + 1);
  auto element = list.begin() + static_cast<std::ptrdiff_t>(begin);
  auto first = elements.first_piece.begin();
  Sheet::Element last{};
  std::uint32_t i = 0;
  for (const Drawing::Piece& p : pieces) {
    if (p.a != last.a || p.b != last.b) {
      *element++ = last = {p.a, p.b, p.line};
      *first++ = i;
    }
    ++i;
  }
  *first = i;
  list.erase(element, list.end());
  elements.list = std::span(list).subspan(begin);
  return elements;
}

const Drawing::Vertices& number_vertices(const std::vector<VertexId>& points, const Drawing::Elements& elements,
                                         Drawing::Vertices& vertices) {
  auto& list = vertices.list;
  auto& slots = vertices.slots;
  const std::size_t most = points.size() + elements.half_edges();
  const int bits = std::bit_width(2 * most);
  slots.assign(std::size_t{1} << bits, none);
  list.resize(most);
  std::uint32_t n = 0;
  const auto number = [&](VertexId v) {
    std::size_t i = (v.value * 0x9E3779B97F4A7C15u) >> (64 - bits);
    for (std::uint32_t w; (w = slots[i]) != none; i = (i + 1) & (slots.size() - 1))
      if (list[w] == v) return w;
    list[n] = v;
    return slots[i] = n++;
  };

  vertices.origin.resize(elements.half_edges());
  auto origin = vertices.origin.begin();
  VertexId last = none;
  std::uint32_t of_last = none;
  for (const Sheet::Element& e : elements.list) {
    if (e.a != last) of_last = number(last = e.a);
    *origin++ = of_last;
    *origin++ = number(e.b);
  }
  for (const VertexId v : points) number(v);
  list.resize(n);
  return vertices;
}

/// Sorts half-edges that run forward all, or backward all, from one vertex.
void sort_half(const View& view, std::span<std::uint32_t> half) {
  if (half.size() == 2) {
    if (view.earlier_around(half[1], half[0])) std::swap(half[0], half[1]);
  } else if (half.size() > 2) {
    std::sort(half.begin(), half.end(),
              [&](std::uint32_t g, std::uint32_t h) { return g != h && view.earlier_around(g, h); });
  }
}

/// The half-edges of each vertex as lists: those that run forward (to the right), then the others.
void list_around_vertices(const Drawing::Vertices& vertices, Drawing::Rotation& rotation) {
  auto& first = rotation.first;
  auto& next = rotation.next;
  const auto& origin = vertices.origin;
  const auto half_edges = static_cast<std::uint32_t>(origin.size());
  first.assign(vertices.list.size(), none);
  next.resize(half_edges);
  for (std::uint32_t h = half_edges; h > 0; h -= 2) next[h - 1] = std::exchange(first[origin[h - 1]], h - 1);
  for (std::uint32_t h = half_edges; h > 0; h -= 2) next[h - 2] = std::exchange(first[origin[h - 2]], h - 2);
}

/// Counter-clockwise from straight down those that run forward come first.
const Drawing::Rotation& sort_around_vertices(const View& view, const Drawing::Vertices& vertices,
                                              std::span<std::uint32_t> clockwise, Drawing::Rotation& rotation) {
  list_around_vertices(vertices, rotation);
  rotation.clockwise = clockwise;

  const auto& next = rotation.next;
  auto& around = rotation.around;
  for (std::uint32_t& start : rotation.first) {
    if (start == none) continue;
    const std::uint32_t second = next[start];
    if (second != none && next[second] == none) {
      // Which of two comes first matters at a component's leftmost vertex only.
      clockwise[start] = second;
      clockwise[second] = start;
      if (!(second & 1) && view.earlier_around(second, start)) start = second;
      continue;
    }

    around.clear();
    std::size_t forward = 0;
    for (std::uint32_t h = start; h != none; h = next[h]) {
      around.push_back(h);
      forward += (h & 1) == 0;
    }
    if (forward > 1) sort_half(view, std::span(around).first(forward));
    if (around.size() - forward > 1) sort_half(view, std::span(around).subspan(forward));
    start = around[0];
    std::uint32_t last = around.back();
    for (const std::uint32_t h : around) clockwise[h] = std::exchange(last, h);
  }
  return rotation;
}

/// Of the leftmost vertex of each component all half-edges run forward; the loop that looks outward is that of the last
/// one, which sees "left".
const Drawing::Components& find_components(const View& view, const Drawing::Vertices& vertices,
                                           const Drawing::Rotation& rotation, Drawing::Components& components) {
  auto& list = components.list;
  list.clear();
  for (std::uint32_t v = 0, n = static_cast<std::uint32_t>(vertices.list.size()); v < n; ++v)
    if (!rotation.has_backward(v)) list.push_back({v, rotation.last(v)});
  if (list.size() < 2) return components;

  auto& together = components.together;
  together.reset(vertices.list.size());
  for (std::size_t h = 0; h < vertices.origin.size(); h += 2)
    together.unite(vertices.origin[h], vertices.origin[h + 1]);

  std::sort(list.begin(), list.end(), [&](const auto& c, const auto& d) {
    return view.before(vertices.list[c.leftmost], vertices.list[d.leftmost]);
  });
  auto& listed = components.listed;
  listed.assign(vertices.list.size(), 0);
  std::erase_if(list, [&](const auto& c) { return std::exchange(listed[together.find(c.leftmost)], 1) != 0; });
  return components;
}

/// A chain that a vertical line crosses, at one of its half-edges, which run forward. Where a chain ends, one that
/// begins takes its place.
struct Crossed {
  mutable std::uint32_t half_edge;
};

/// The sweep's order of chains from below, and of a vertex among them: no two elements cross.
struct Lower {
  using is_transparent = void;
  const View& view;
  const Drawing::Rotation& rotation;

  /// The chain's element that the line through a vertex crosses; the line moves to the right.
  std::uint32_t element_at(const Crossed& c, VertexId v) const {
    while (view.before(view.elements.origin(c.half_edge ^ 1), v)) c.half_edge = rotation.onward(c.half_edge);
    return c.half_edge / 2;
  }
  bool operator()(const Crossed& c, const Crossed& d) const {
    const VertexId p = view.elements.origin(c.half_edge), q = view.elements.origin(d.half_edge);
    if (p == q) return view.above(view.elements.origin(d.half_edge ^ 1), c.half_edge / 2) > 0;
    return view.before(p, q) ? (*this)(c, q) : (*this)(p, d);
  }
  bool operator()(const Crossed& c, VertexId v) const { return view.above(v, element_at(c, v)) > 0; }
  bool operator()(VertexId v, const Crossed& c) const { return view.above(v, element_at(c, v)) < 0; }
};

/// One sweep over the vertices in which chains begin or end. It looks up places only where none ends, which is so at
/// each component's leftmost vertex.
void sweep(const View& view, const Drawing::Vertices& vertices, const Drawing::Rotation& rotation,
           const Drawing::Components& components, std::vector<std::uint32_t>& below) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t v = 0; v < vertices.list.size(); ++v)
    if (!rotation.is_within_chain(v)) order.push_back(v);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t v, std::uint32_t w) { return view.before(vertices.list[v], vertices.list[w]); });

  using Status = std::multiset<Crossed, Lower>;
  const Lower lower{view, rotation};
  Status status(lower);
  std::vector<Status::iterator> place(view.elements.list.size()), ended;  // by the last element of a chain
  std::size_t c = 0;
  for (const std::uint32_t v : order) {
    Status::iterator at;
    if (!rotation.has_backward(v)) {
      at = status.lower_bound(vertices.list[v]);
      if (c < below.size() && components.list[c].leftmost == v) {
        // The highest element below v: the last one that v is above. Nothing passes through the vertex.
        if (at != status.begin()) below[c] = lower.element_at(*std::prev(at), vertices.list[v]);
        ++c;
      }
    }

    // Clockwise from straight down: what ends here from below, then what begins here from above.
    rotation.visit_around(v, [&](std::uint32_t h) {
      if (h & 1) {
        ended.push_back(place[h / 2]);
        return;
      }
      if (ended.empty()) {
        at = status.insert(at, Crossed{h});
      } else {
        at = ended.back();
        at->half_edge = h;
        ended.pop_back();
      }
      place[rotation.end_of_chain(h) / 2] = at;
    });
    for (const Status::iterator i : ended) status.erase(i);
    ended.clear();
  }
}

/// The element below the leftmost vertex of each component, none where there is none.
const std::vector<std::uint32_t>& find_elements_below(const View& view, const Drawing::Vertices& vertices,
                                                      const Drawing::Rotation& rotation,
                                                      const Drawing::Components& components,
                                                      std::vector<std::uint32_t>& below) {
  below.assign(components.list.size(), none);
  if (below.size() > 1) sweep(view, vertices, rotation, components, below);
  return below;
}

/// Facets on the left of half-edges. The outward loop of a component belongs to the facet above the element below its
/// leftmost vertex; every other loop bounds a facet of its own.
const Drawing::Facets& trace_facets(const Drawing::Rotation& rotation, const Drawing::Components& components,
                                    const std::vector<std::uint32_t>& below, Drawing::Facets& facets) {
  auto& of = facets.of;
  const auto fill_loop = [&](std::uint32_t start, std::uint32_t facet) {
    rotation.visit_loop(start, [&](std::uint32_t h) { of[h] = facet; });
  };
  const auto half_edges = static_cast<std::uint32_t>(rotation.clockwise.size());
  of.assign(half_edges, none);
  for (const auto& c : components.list)
    if (c.outward != none) fill_loop(c.outward, 0);

  std::uint32_t count = 1;
  for (std::uint32_t h = 0; h < half_edges; ++h)
    if (of[h] == none) fill_loop(h, count++);
  facets.count = count;

  // From left to right: the element below belongs to a component that is nested already.
  facets.of_component.assign(components.list.size(), 0);
  for (std::size_t c = 0; c < below.size(); ++c) {
    if (below[c] == none) continue;
    const std::uint32_t around = facets.of_component[c] = of[2 * below[c]];
    if (const std::uint32_t h = components.list[c].outward; h != none && around != 0) fill_loop(h, around);
  }
  return facets;
}

/// Appends the cover of a facet: that of the one on the left of the half-edge, which is given, turned into that on its
/// right.
std::array<std::uint32_t, 2> cross(const Outline& outline, const Drawing& drawing, std::uint32_t h,
                                   std::array<std::uint32_t, 2> left, std::vector<Drawing::Covers::Cover>& list) {
  const auto begin = static_cast<std::uint32_t>(list.size());
  for (std::uint32_t i = left[0]; i < left[1]; ++i) list.push_back(Drawing::Covers::Cover(list[i]));

  // Half-edge 2e has the left side here, so going to the right takes the change away.
  const int sign = h & 1 ? 1 : -1;
  const auto& first_piece = drawing.elements.first_piece;
  for (std::uint32_t p = first_piece[h / 2]; p < first_piece[h / 2 + 1]; ++p)
    for (const Outline::Change& change : outline.changes_of(drawing.pieces[p].segment)) {
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
  return {begin, static_cast<std::uint32_t>(list.size())};
}

/// Walks from the outward loop of each component over its elements. From left to right: the facet around a component is
/// covered already.
const Drawing::Covers& cover_facets(const Outline& outline, const Drawing& drawing, Drawing::Covers& covers) {
  const auto& facets = drawing.facets;
  auto& of = covers.of;
  auto& stack = covers.stack;
  covers.list.clear();
  of.assign(facets.count, {none, none});
  of[0] = {0, 0};
  std::uint32_t covered = 1;
  for (const auto& component : drawing.components.list) {
    if (component.outward != none) stack.assign(1, component.outward);
    while (!stack.empty() && covered < facets.count) {
      const std::uint32_t start = stack.back();
      stack.pop_back();
      const auto from = of[facets.of[start]];
      drawing.rotation.visit_loop(start, [&](std::uint32_t h) {
        const std::uint32_t to = facets.of[h ^ 1];
        if (of[to][0] != none) return;
        of[to] = cross(outline, drawing, h, from, covers.list);
        stack.push_back(h ^ 1);
        ++covered;
      });
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
    for (std::uint32_t i = begin; i < end; ++i)
      for (int k = 0; k < covers.list[i].times; ++k) lists.cover.push_back(covers.list[i].face);
    lists.cover_start.push_back(static_cast<std::uint32_t>(lists.cover.size() - first));
  }
  return names;
}

void list_facets(const Drawing::Facets& facets, const std::vector<FacetId>& names, Array<FacetId>& list) {
  list.resize(list.size() + facets.of.size());
  auto facet = list.end() - static_cast<std::ptrdiff_t>(facets.of.size());
  for (const std::uint32_t f : facets.of) *facet++ = names[f];
}

void list_isolated(const Drawing::Vertices& vertices, const Drawing::Components& components,
                   const Drawing::Facets& facets, const std::vector<FacetId>& names, Array<Sheet::Isolated>& list) {
  for (std::size_t c = 0; c < components.list.size(); ++c) {
    if (components.list[c].outward != none) continue;
    const FacetId f = names[facets.of_component[c]];
    if (f != none) list.push_back({vertices.list[components.list[c].leftmost], f});
  }
}

}  // namespace

void draw(const Names& names, Outline& outline, Drawing& drawing, SheetLists& lists) {
  const View view{names, outline, drawing.elements};
  sort_splits(view, outline.splits);
  const auto& pieces = cut_segments(outline, drawing.pieces);
  const auto& elements = unite_pieces(pieces, lists.elements, drawing.elements);

  const auto& vertices = number_vertices(outline.points, elements, drawing.vertices);
  lists.clockwise.resize(lists.clockwise.size() + elements.half_edges());
  const auto clockwise = std::span(lists.clockwise).last(elements.half_edges());
  const auto& rotation = sort_around_vertices(view, vertices, clockwise, drawing.rotation);

  const auto& components = find_components(view, vertices, rotation, drawing.components);
  const auto& below = find_elements_below(view, vertices, rotation, components, drawing.below);
  const auto& facets = trace_facets(rotation, components, below, drawing.facets);
  const auto& covers = cover_facets(outline, drawing, drawing.covers);

  const auto& facet_names = list_covers(covers, lists, drawing.names);
  list_facets(facets, facet_names, lists.facet);
  list_isolated(vertices, components, facets, facet_names, lists.isolated);
}

}  // namespace quoin::booleans
