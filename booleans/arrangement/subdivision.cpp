#include "booleans/arrangement/subdivision.h"

#include <set>

namespace quoin::booleans {

void Subdivider::draw(Outline& outline, SheetLists& lists) {
  make_elements(outline);
  order_vertices(outline);
  sort_around_vertices();
  trace_loops();
  find_components();
  nest_components(outline);
  cover_facets();
  write(lists);
}

void Subdivider::make_elements(Outline& outline) {
  auto& splits = outline.splits;
  std::sort(splits.begin(), splits.end(), [&](const Outline::Split& s, const Outline::Split& t) {
    if (s.segment != t.segment) return s.segment < t.segment;
    return s.vertex != t.vertex && before(outline, s.vertex.named(), t.vertex.named());
  });

  // The segments, cut at their splits.
  pieces_.clear();
  std::size_t at = 0;
  for (std::uint32_t i = 0; i < outline.segments.size(); ++i) {
    const Outline::Segment& s = outline.segments[i];
    VertexId from = s.a;
    for (; at < splits.size() && splits[at].segment == i; ++at) {
      const VertexId v = splits[at].vertex.named();
      if (v == from) continue;
      pieces_.push_back({from, v, s.line, i});
      from = v;
    }
    pieces_.push_back({from, s.b, s.line, i});
  }
  std::sort(pieces_.begin(), pieces_.end(), [](const Piece& p, const Piece& q) {
    return p.a != q.a ? p.a < q.a : p.b != q.b ? p.b < q.b : p.segment < q.segment;
  });

  // Equal pieces become one element with the changes of all.
  elements_.list.clear();
  elements_.direction.clear();
  elements_.change_start.clear();
  elements_.changes.clear();
  for (const Piece& p : pieces_) {
    auto& list = elements_.list;
    if (list.empty() || list.back().a != p.a || list.back().b != p.b) {
      list.push_back({p.a, p.b, p.line});
      elements_.direction.push_back(outline.frame.direction(names_.planes[outline.plane], names_.planes[p.line]));
      elements_.change_start.push_back(static_cast<std::uint32_t>(elements_.changes.size()));
    }
    for (std::uint32_t c = outline.change_start[p.segment]; c < outline.change_start[p.segment + 1]; ++c)
      elements_.changes.push_back(outline.changes[c]);
  }
  elements_.change_start.push_back(static_cast<std::uint32_t>(elements_.changes.size()));
}

void Subdivider::order_vertices(const Outline& outline) {
  auto& vertices = order_.vertices;
  if (rank_of_.size() < names_.vertices.size()) rank_of_.resize(names_.vertices.size(), none);
  vertices.clear();
  const auto add = [&](VertexId v) {
    if (rank_of_[v] != none) return;
    rank_of_[v] = 0;
    vertices.push_back(v);
  };
  for (const VertexId v : outline.points) add(v);
  for (const auto& e : elements_.list) {
    add(e.a);
    add(e.b);
  }
  std::sort(vertices.begin(), vertices.end(), [&](VertexId a, VertexId b) { return before(outline, a, b); });

  for (std::uint32_t i = 0; i < vertices.size(); ++i) rank_of_[vertices[i]] = i;
  order_.rank.resize(elements_.half_edges());
  for (std::uint32_t h = 0; h < order_.rank.size(); ++h) order_.rank[h] = rank_of_[elements_.origin(h)];
  for (const VertexId v : vertices) rank_of_[v] = none;
}

void Subdivider::sort_around_vertices() {
  auto& [out, clockwise] = rotation_;
  const auto& rank = order_.rank;
  out.assign(order_.vertices.size(), [&](auto&& visit) {
    for (std::uint32_t h = 0; h < rank.size(); ++h) visit(rank[h], h);
  });

  // Counter-clockwise from straight down: first the half-edges that run forward (to the right), then the others. Within
  // a half, which spans less than a straight angle, the later one ends on the left of the earlier one.
  const auto earlier = [&](std::uint32_t g, std::uint32_t h) {
    if ((g & 1) != (h & 1)) return (g & 1) == 0;
    return g != h && left_of(g, elements_.origin(h ^ 1)) > 0;
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
}

void Subdivider::trace_loops() {
  loops_.count = 0;
  loops_.of.assign(elements_.half_edges(), none);
  for (std::uint32_t h = 0; h < loops_.of.size(); ++h) {
    if (loops_.of[h] != none) continue;
    for (std::uint32_t g = h; loops_.of[g] == none; g = rotation_.clockwise[g ^ 1]) loops_.of[g] = loops_.count;
    ++loops_.count;
  }
}

void Subdivider::find_components() {
  auto& [of, leftmost] = components_;
  of.assign(order_.vertices.size(), none);
  leftmost.clear();
  for (std::uint32_t v = 0; v < of.size(); ++v) {
    if (of[v] != none) continue;
    const auto c = static_cast<std::uint32_t>(leftmost.size());
    leftmost.push_back(v);
    of[v] = c;

    stack_.assign(1, v);
    while (!stack_.empty()) {
      const std::uint32_t w = stack_.back();
      stack_.pop_back();
      for (const std::uint32_t h : rotation_.out[w]) {
        const std::uint32_t x = order_.rank[h ^ 1];
        if (of[x] != none) continue;
        of[x] = c;
        stack_.push_back(x);
      }
    }
  }
}

/// The sweep's order of elements that a vertical line crosses, and of a vertex among them: no two elements cross.
struct Subdivider::Lower {
  struct Vertex {
    VertexId id;
  };
  using is_transparent = void;
  const Subdivider* drawing;
  const Outline* outline;

  bool operator()(std::uint32_t e, std::uint32_t f) const {
    if (e == f) return false;
    const auto &p = drawing->elements_.list[e], &q = drawing->elements_.list[f];
    if (p.a == q.a) return drawing->above(q.b, e) > 0;
    if (drawing->before(*outline, p.a, q.a)) return drawing->above(q.a, e) > 0;
    return drawing->above(p.a, f) < 0;
  }
  bool operator()(std::uint32_t e, Vertex v) const { return drawing->above(v.id, e) > 0; }
  bool operator()(Vertex v, std::uint32_t e) const { return drawing->above(v.id, e) < 0; }
};

/// Assigns facets to loops. Each component has one loop that looks outward: the one that sees "left" at its leftmost
/// vertex. It belongs to the facet above the element below that vertex, found by one sweep; every other loop bounds a
/// facet of its own.
void Subdivider::nest_components(const Outline& outline) {
  const auto& out = rotation_.out;
  const auto& leftmost = components_.leftmost;
  outward_.assign(leftmost.size(), none);
  for (std::size_t c = 0; c < leftmost.size(); ++c) {
    const auto around = out[leftmost[c]];
    if (!around.empty()) outward_[c] = loops_.of[around.back()];
  }

  facets_.count = 1;
  facets_.of_loop.assign(loops_.count, none);
  for (const std::uint32_t l : outward_)
    if (l != none) facets_.of_loop[l] = 0;
  for (std::uint32_t& f : facets_.of_loop)
    if (f == none) f = facets_.count++;
  facets_.of_component.assign(leftmost.size(), 0);
  if (leftmost.size() == 1) return;

  using Status = std::set<std::uint32_t, Lower>;
  Status status(Lower{this, &outline});
  std::vector<Status::iterator> place(elements_.list.size());
  for (std::uint32_t v = 0; v < order_.vertices.size(); ++v) {
    const std::uint32_t c = components_.of[v];
    if (leftmost[c] == v && !status.empty()) {
      // The highest element below v: the last one that v is above. Nothing passes through the vertex.
      const auto at = status.lower_bound(Lower::Vertex{order_.vertices[v]});
      if (at != status.begin()) {
        facets_.of_component[c] = facet_left_of(2 * *std::prev(at));
        if (outward_[c] != none) facets_.of_loop[outward_[c]] = facets_.of_component[c];
      }
    }
    for (const std::uint32_t h : out[v])
      if (h & 1) status.erase(place[h / 2]);
    for (const std::uint32_t h : out[v])
      if (!(h & 1)) place[h / 2] = status.insert(h / 2).first;
  }
}

/// Walks from the unbounded facet over the elements and lists the faces that cover each facet.
void Subdivider::cover_facets() {
  sides_.assign(facets_.count, [&](auto&& visit) {
    for (std::uint32_t h = 0; h < elements_.half_edges(); ++h) visit(facet_left_of(h), h);
  });

  auto& [list, of] = covers_;
  list.clear();
  of.assign(facets_.count, {none, none});
  of[0] = {0, 0};
  stack_.assign(1, 0u);
  while (!stack_.empty()) {
    const std::uint32_t from = stack_.back();
    stack_.pop_back();
    for (const std::uint32_t h : sides_[from]) {
      const std::uint32_t to = facet_left_of(h ^ 1);
      if (of[to][0] != none) continue;
      stack_.push_back(to);

      const auto begin = static_cast<std::uint32_t>(list.size());
      for (std::uint32_t i = of[from][0]; i < of[from][1]; ++i) list.push_back(Covers::Cover(list[i]));
      // Half-edge 2e has the left side here, so going to the right takes the change away.
      const int sign = h & 1 ? 1 : -1;
      for (std::uint32_t c = elements_.change_start[h / 2]; c < elements_.change_start[h / 2 + 1]; ++c) {
        const Outline::Change& change = elements_.changes[c];
        std::uint32_t i = begin;
        while (i < list.size() && list[i].face != change.face) ++i;
        if (i == list.size()) list.push_back({change.face, 0});
        list[i].times += sign * change.by;
        if (list[i].times != 0) continue;
        list[i] = list.back();
        list.pop_back();
      }
      of[to] = {begin, static_cast<std::uint32_t>(list.size())};
    }
  }
}

/// Names the covered facets and adds everything to the lists.
void Subdivider::write(SheetLists& lists) {
  names_of_facets_.assign(facets_.count, none);
  std::uint32_t count = 0;
  const std::size_t first = lists.cover.size();
  lists.cover_start.push_back(0);
  for (std::uint32_t f = 0; f < facets_.count; ++f) {
    const auto [begin, end] = covers_.of[f];
    if (begin == end) continue;
    names_of_facets_[f] = count++;

    std::sort(covers_.list.begin() + begin, covers_.list.begin() + end,
              [](const Covers::Cover& x, const Covers::Cover& y) { return x.face < y.face; });
    // A face lies on the left of its boundary, so no count is negative; of bad input the labels show it (selection.h).
    for (std::uint32_t i = begin; i < end; ++i) {
      const Covers::Cover& c = covers_.list[i];
      lists.cover.insert(lists.cover.end(), static_cast<std::size_t>(std::max(c.times, 0)), c.face);
    }
    lists.cover_start.push_back(static_cast<std::uint32_t>(lists.cover.size() - first));
  }

  for (std::uint32_t h = 0; h < elements_.half_edges(); ++h) lists.facet.push_back(names_of_facets_[facet_left_of(h)]);
  lists.elements.insert(lists.elements.end(), elements_.list.begin(), elements_.list.end());
  lists.clockwise.insert(lists.clockwise.end(), rotation_.clockwise.begin(), rotation_.clockwise.end());

  for (std::size_t c = 0; c < components_.leftmost.size(); ++c) {
    const std::uint32_t v = components_.leftmost[c];
    if (!rotation_.out[v].empty()) continue;
    const FacetId f = names_of_facets_[facets_.of_component[c]];
    if (f != none) lists.isolated.push_back({order_.vertices[v], f});
  }
}

}  // namespace quoin::booleans
