#include "booleans/drawing.h"

#include <numeric>
#include <set>
#include <tuple>

namespace quoin::booleans {

void Outline::clear(std::uint32_t new_plane) {
  plane = new_plane;
  segments.clear();
  changes.clear();
  points.clear();
  splits.clear();
  new_points.clear();
}

void Outline::name_points(VertexTable& vertices) {
  std::vector<std::uint32_t> names;
  names.reserve(new_points.size());
  for (const exact::Point& p : new_points) names.push_back(vertices.id(p));
  for (Split& s : splits)
    if (s.vertex & local_bit) s.vertex = names[s.vertex & ~local_bit];
  new_points.clear();
}

void Drawing::add_face(std::uint32_t face) {
  const TouchedFace& f = touched_.faces[face];
  for (std::uint32_t e = f.edges_begin; e < f.edges_end; ++e) {
    const BoundaryEdge& edge = touched_.edges[e];
    const bool forward = before(edge.from, edge.to);
    outline_.segments.push_back(
        {forward ? edge.from : edge.to, forward ? edge.to : edge.from, edge.other, face, forward == f.along ? 1 : -1});
  }
  for (std::uint32_t i = f.isolated_begin; i < f.isolated_end; ++i) add_point(touched_.isolated[i]);
}

void Drawing::add_segment(const SheetSegment& s) {
  const bool forward = before(s.a, s.b);
  outline_.segments.push_back({forward ? s.a : s.b, forward ? s.b : s.a, s.line, none, 0});
}

void Drawing::unite_equal_segments() {
  auto& segments = outline_.segments;
  std::sort(segments.begin(), segments.end(), [](const Segment& s, const Segment& t) {
    return std::tie(s.a, s.b, s.face, s.change, s.line) < std::tie(t.a, t.b, t.face, t.change, t.line);
  });
  std::uint32_t n = 0;
  for (const Segment& s : segments) {
    if (n == 0 || segments[n - 1].a != s.a || segments[n - 1].b != s.b) segments[n++] = s;
    if (s.face != none) outline_.changes.push_back({n - 1, s.face, s.change});
  }
  segments.resize(n);
  std::sort(outline_.points.begin(), outline_.points.end());
  outline_.points.erase(std::unique(outline_.points.begin(), outline_.points.end()), outline_.points.end());
}

/// visit(i, j) for pairs of segments whose boxes meet, and visit(i, segment count + k) for points k near segment i.
template <class Visit>
void Drawing::close_pairs(Visit visit) const {
  struct Extent {
    double ul, uh, vl, vh;
  };
  const auto n = static_cast<std::uint32_t>(outline_.segments.size());
  const auto total = n + static_cast<std::uint32_t>(outline_.points.size());
  const auto ends = [&](std::uint32_t i) {
    return i < n ? std::pair(outline_.segments[i].a, outline_.segments[i].b)
                 : std::pair(outline_.points[i - n], outline_.points[i - n]);
  };
  if (total <= 24) {
    // Approximations are monotone, so strictly separated ones prove that the segments are.
    std::array<Extent, 24> box{};
    const auto u = static_cast<std::size_t>(frame_.u()), v = static_cast<std::size_t>(frame_.v());
    for (std::uint32_t i = 0; i < total; ++i) {
      const auto [a, b] = ends(i);
      const auto &p = vertices_.approximation(a), &q = vertices_.approximation(b);
      box[i] = {p[u], q[u], std::min(p[v], q[v]), std::max(p[v], q[v])};
    }
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = i + 1; j < total; ++j)
        if (box[i].ul <= box[j].uh && box[j].ul <= box[i].uh && box[i].vl <= box[j].vh && box[j].vl <= box[i].vh)
          visit(i, j);
    return;
  }
  std::vector<BoxTree::Item> items(total);
  for (std::uint32_t i = 0; i < total; ++i) {
    const auto [a, b] = ends(i);
    items[i].id = i;
    items[i].group = i;
    items[i].box.add(vertices_.approximation(a));
    items[i].box.add(vertices_.approximation(b));
  }
  BoxTree(items).pairs([&](std::uint32_t i, std::uint32_t j) {
    if (i > j) std::swap(i, j);
    if (i < n) visit(i, j);
  });
}

void Drawing::find_splits() {
  unite_equal_segments();
  const auto n = static_cast<std::uint32_t>(outline_.segments.size());
  close_pairs([&](std::uint32_t i, std::uint32_t j) {
    if (j < n)
      split_pair(i, j);
    else
      split_by_point(i, outline_.points[j - n]);
  });
}

void Drawing::split_by_point(std::uint32_t s, std::uint32_t v) {
  const Segment& seg = outline_.segments[s];
  if (v != seg.a && v != seg.b && side(v, seg.line) == 0 && strictly_inside(v, seg)) outline_.splits.push_back({s, v});
}

void Drawing::split_collinear(std::uint32_t s, std::uint32_t t) {
  const Segment &p = outline_.segments[s], &q = outline_.segments[t];
  for (std::uint32_t v : {q.a, q.b})
    if (v != p.a && v != p.b && strictly_inside(v, p)) outline_.splits.push_back({s, v});
  for (std::uint32_t v : {p.a, p.b})
    if (v != q.a && v != q.b && strictly_inside(v, q)) outline_.splits.push_back({t, v});
}

void Drawing::split_pair(std::uint32_t s, std::uint32_t t) {
  const Segment &p = outline_.segments[s], &q = outline_.segments[t];
  if (p.a == q.a || p.a == q.b || p.b == q.a || p.b == q.b) {
    // Lines that share a point meet nowhere else unless they are one line.
    ++exact::counters().symbolic;
    const std::uint32_t other = q.a == p.a || q.a == p.b ? q.b : q.a;
    if (side(other, p.line) == 0) split_collinear(s, t);
    return;
  }
  const int qa = side(q.a, p.line), qb = side(q.b, p.line);
  if (qa * qb > 0) return;
  if (qa == 0 && qb == 0) return split_collinear(s, t);
  const int pa = side(p.a, q.line), pb = side(p.b, q.line);
  if (pa * pb > 0) return;
  if (pa * pb == 0) {
    if (qa * qb < 0) outline_.splits.push_back({t, pa == 0 ? p.a : p.b});
    return;  // both zero: two ends at one point would be one vertex, so nothing is inside
  }
  if (qa * qb == 0) {
    outline_.splits.push_back({s, qa == 0 ? q.a : q.b});
    return;
  }
  const auto crossing = exact::meet(planes_[outline_.plane], planes_[p.line], planes_[q.line]);
  assert(crossing);
  const std::uint32_t name = static_cast<std::uint32_t>(outline_.new_points.size()) | local_bit;
  outline_.new_points.push_back(*crossing);
  outline_.splits.push_back({s, name});
  outline_.splits.push_back({t, name});
}

/// The segments, cut at their splits.
void Drawing::make_pieces() {
  auto& splits = outline_.splits;
  std::sort(splits.begin(), splits.end(), [&](const Split& s, const Split& t) {
    if (s.segment != t.segment) return s.segment < t.segment;
    return s.vertex != t.vertex && before(s.vertex, t.vertex);
  });
  pieces_.clear();
  std::size_t at = 0;
  for (std::uint32_t i = 0; i < outline_.segments.size(); ++i) {
    const Segment& s = outline_.segments[i];
    std::uint32_t from = s.a;
    for (; at < splits.size() && splits[at].segment == i; ++at) {
      if (splits[at].vertex == from) continue;
      pieces_.push_back({from, splits[at].vertex, s.line, i});
      from = splits[at].vertex;
    }
    pieces_.push_back({from, s.b, s.line, i});
  }
}

/// Pieces of overlapping segments coincide; each becomes one element with the changes of all.
void Drawing::make_elements() {
  make_pieces();
  change_start_.assign(outline_.segments.size() + 1, 0);
  for (const Change& c : outline_.changes) ++change_start_[c.element + 1];
  std::partial_sum(change_start_.begin(), change_start_.end(), change_start_.begin());
  std::sort(pieces_.begin(), pieces_.end(), [](const Piece& p, const Piece& q) {
    return p.a != q.a ? p.a < q.a : p.b != q.b ? p.b < q.b : p.segment < q.segment;
  });
  elements_.clear();
  changes_.clear();
  direction_.clear();
  for (const Piece& p : pieces_) {
    if (elements_.empty() || elements_.back().a != p.a || elements_.back().b != p.b) {
      elements_.push_back({p.a, p.b, p.line});
      direction_.push_back(frame_.direction(planes_[outline_.plane], planes_[p.line]));
    }
    for (std::uint32_t c = change_start_[p.segment]; c < change_start_[p.segment + 1]; ++c)
      changes_.push_back(
          {static_cast<std::uint32_t>(elements_.size() - 1), outline_.changes[c].face, outline_.changes[c].by});
  }
}

void Drawing::collect_vertices() {
  if (rank_of_.size() < vertices_.size()) rank_of_.resize(vertices_.size(), none);
  vertex_ids_.clear();
  const auto add = [&](std::uint32_t v) {
    if (rank_of_[v] != none) return;
    rank_of_[v] = 0;
    vertex_ids_.push_back(v);
  };
  for (const std::uint32_t v : outline_.points) add(v);
  for (const auto& e : elements_) {
    add(e.a);
    add(e.b);
  }
  std::sort(vertex_ids_.begin(), vertex_ids_.end(), [&](std::uint32_t a, std::uint32_t b) { return before(a, b); });
  for (std::uint32_t i = 0; i < vertex_ids_.size(); ++i) rank_of_[vertex_ids_[i]] = i;
  rank_.resize(half_edges());
  for (std::uint32_t h = 0; h < rank_.size(); ++h) rank_[h] = rank_of_[origin(h)];
  for (const std::uint32_t v : vertex_ids_) rank_of_[v] = none;
}

void Drawing::sort_around_vertices() {
  first_out_.assign(vertex_ids_.size() + 1, 0);
  for (std::uint32_t r : rank_) ++first_out_[r + 1];
  std::partial_sum(first_out_.begin(), first_out_.end(), first_out_.begin());
  out_.resize(rank_.size());
  at_.assign(first_out_.begin(), first_out_.end() - 1);
  for (std::uint32_t h = 0; h < rank_.size(); ++h) out_[at_[rank_[h]]++] = h;
  // Counter-clockwise from straight down: first the half-edges that run forward (to the right), then the others. Within
  // a half, which spans less than a straight angle, the later one ends on the left of the earlier one.
  const auto earlier = [&](std::uint32_t g, std::uint32_t h) {
    if ((g & 1) != (h & 1)) return (g & 1) == 0;
    return g != h && left_of(g, origin(h ^ 1)) > 0;
  };
  clockwise_.resize(rank_.size());
  for (std::size_t v = 0; v + 1 < first_out_.size(); ++v) {
    const std::uint32_t begin = first_out_[v], end = first_out_[v + 1];
    if (end - begin == 2) {
      if (earlier(out_[begin + 1], out_[begin])) std::swap(out_[begin], out_[begin + 1]);
    } else if (end - begin > 2) {
      std::sort(out_.begin() + begin, out_.begin() + end, earlier);
    }
    for (std::uint32_t i = begin; i < end; ++i) clockwise_[out_[i]] = out_[i > begin ? i - 1 : end - 1];
  }
}

void Drawing::trace_loops() {
  loop_count_ = 0;
  loop_.assign(rank_.size(), none);
  for (std::uint32_t h = 0; h < loop_.size(); ++h) {
    if (loop_[h] != none) continue;
    for (std::uint32_t g = h; loop_[g] == none; g = clockwise_[g ^ 1]) loop_[g] = loop_count_;
    ++loop_count_;
  }
}

void Drawing::find_components() {
  component_.assign(vertex_ids_.size(), none);
  leftmost_.clear();
  for (std::uint32_t v = 0; v < component_.size(); ++v) {
    if (component_[v] != none) continue;
    const auto c = static_cast<std::uint32_t>(leftmost_.size());
    leftmost_.push_back(v);
    component_[v] = c;
    stack_.assign(1, v);
    while (!stack_.empty()) {
      const std::uint32_t w = stack_.back();
      stack_.pop_back();
      for (std::uint32_t i = first_out_[w]; i < first_out_[w + 1]; ++i) {
        const std::uint32_t x = rank_[out_[i] ^ 1];
        if (component_[x] != none) continue;
        component_[x] = c;
        stack_.push_back(x);
      }
    }
  }
}

/// +1 when the vertex lies above (left of) the element's line, 0 on it, -1 below. Left of n x n_line is where the
/// line's plane is negative.
int Drawing::above(std::uint32_t vertex, std::uint32_t e) const {
  return -direction_[e] * side(vertex, elements_[e].line);
}

/// Order of two elements that a vertical line crosses: no two elements cross.
bool Drawing::element_lower(std::uint32_t e, std::uint32_t f) const {
  if (e == f) return false;
  const auto &p = elements_[e], &q = elements_[f];
  if (p.a == q.a) return above(q.b, e) > 0;
  if (before(p.a, q.a)) return above(q.a, e) > 0;
  return above(p.a, f) < 0;
}

/// The sweep's order of elements, and of a vertex among them.
struct Drawing::Lower {
  struct Vertex {
    std::uint32_t id;
  };
  using is_transparent = void;
  const Drawing* drawing;
  bool operator()(std::uint32_t e, std::uint32_t f) const { return drawing->element_lower(e, f); }
  bool operator()(std::uint32_t e, Vertex v) const { return drawing->above(v.id, e) > 0; }
  bool operator()(Vertex v, std::uint32_t e) const { return drawing->above(v.id, e) < 0; }
};

/// Assigns facets to loops. Each component has one loop that looks outward: the one that sees "left" at its leftmost
/// vertex. It belongs to the facet above the element below that vertex, found by one sweep; every other loop bounds a
/// facet of its own.
void Drawing::nest_components() {
  outward_.assign(leftmost_.size(), none);
  for (std::size_t c = 0; c < leftmost_.size(); ++c) {
    const std::uint32_t v = leftmost_[c];
    if (first_out_[v] != first_out_[v + 1]) outward_[c] = loop_[out_[first_out_[v + 1] - 1]];
  }
  facet_total_ = 1;
  facet_of_loop_.assign(loop_count_, none);
  for (std::uint32_t l : outward_)
    if (l != none) facet_of_loop_[l] = 0;
  for (std::uint32_t& f : facet_of_loop_)
    if (f == none) f = facet_total_++;
  facet_of_component_.assign(leftmost_.size(), 0);
  if (leftmost_.size() == 1) return;

  using Status = std::set<std::uint32_t, Lower>;
  Status status(Lower{this});
  std::vector<Status::iterator> place(elements_.size());
  for (std::uint32_t v = 0; v < vertex_ids_.size(); ++v) {
    const std::uint32_t c = component_[v];
    if (leftmost_[c] == v && !status.empty()) {
      // The highest element below v: the last one that v is above. Nothing passes through the vertex.
      const auto at = status.lower_bound(Lower::Vertex{vertex_ids_[v]});
      if (at != status.begin()) {
        facet_of_component_[c] = facet_of_loop_[loop_[2 * *std::prev(at)]];
        if (outward_[c] != none) facet_of_loop_[outward_[c]] = facet_of_component_[c];
      }
    }
    for (std::uint32_t i = first_out_[v]; i < first_out_[v + 1]; ++i)
      if (out_[i] & 1) status.erase(place[out_[i] / 2]);
    for (std::uint32_t i = first_out_[v]; i < first_out_[v + 1]; ++i)
      if (!(out_[i] & 1)) place[out_[i] / 2] = status.insert(out_[i] / 2).first;
  }
}

/// Walks from the unbounded facet over the elements and lists the faces that cover each facet.
void Drawing::cover_facets() {
  change_start_.assign(elements_.size() + 1, 0);
  for (const Change& c : changes_) ++change_start_[c.element + 1];
  std::partial_sum(change_start_.begin(), change_start_.end(), change_start_.begin());

  // Half-edges by the facet on their left.
  const auto left = [&](std::uint32_t h) { return facet_of_loop_[loop_[h]]; };
  start_.assign(facet_total_ + 1, 0);
  sides_.resize(half_edges());
  for (std::uint32_t h = 0; h < half_edges(); ++h) ++start_[left(h) + 1];
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  at_.assign(start_.begin(), start_.end() - 1);
  for (std::uint32_t h = 0; h < half_edges(); ++h) sides_[at_[left(h)]++] = h;

  covers_.clear();
  cover_of_.assign(facet_total_, {none, none});
  cover_of_[0] = {0, 0};
  stack_.assign(1, 0u);
  while (!stack_.empty()) {
    const std::uint32_t from = stack_.back();
    stack_.pop_back();
    for (std::uint32_t s = start_[from]; s < start_[from + 1]; ++s) {
      const std::uint32_t h = sides_[s], to = left(h ^ 1);
      if (cover_of_[to][0] != none) continue;
      stack_.push_back(to);
      const auto begin = static_cast<std::uint32_t>(covers_.size());
      for (std::uint32_t i = cover_of_[from][0]; i < cover_of_[from][1]; ++i) covers_.push_back(Cover(covers_[i]));
      // Half-edge 2e has the left side here, so going to the right takes the change away.
      const int sign = h & 1 ? 1 : -1;
      for (std::uint32_t c = change_start_[h / 2]; c < change_start_[h / 2 + 1]; ++c) {
        std::uint32_t i = begin;
        while (i < covers_.size() && covers_[i].face != changes_[c].face) ++i;
        if (i == covers_.size()) covers_.push_back({changes_[c].face, 0});
        covers_[i].times += sign * changes_[c].by;
        if (covers_[i].times != 0) continue;
        covers_[i] = covers_.back();
        covers_.pop_back();
      }
      cover_of_[to] = {begin, static_cast<std::uint32_t>(covers_.size())};
    }
  }
}

/// Names the covered facets and adds everything to the lists.
void Drawing::write(SheetLists& lists) {
  name_.assign(facet_total_, none);
  std::uint32_t count = 0;
  const std::size_t first = lists.cover.size();
  lists.cover_start.push_back(0);
  for (std::uint32_t f = 0; f < facet_total_; ++f) {
    const auto [begin, end] = cover_of_[f];
    if (begin == end) continue;
    name_[f] = count++;
    std::sort(covers_.begin() + begin, covers_.begin() + end,
              [](const Cover& x, const Cover& y) { return x.face < y.face; });
    // A face lies on the left of its boundary, so no count is negative; of bad input the labels show it (`select`).
    for (std::uint32_t i = begin; i < end; ++i)
      lists.cover.insert(lists.cover.end(), static_cast<std::size_t>(std::max(covers_[i].times, 0)), covers_[i].face);
    lists.cover_start.push_back(static_cast<std::uint32_t>(lists.cover.size() - first));
  }
  for (std::uint32_t h = 0; h < half_edges(); ++h) lists.facet.push_back(name_[facet_of_loop_[loop_[h]]]);
  lists.elements.insert(lists.elements.end(), elements_.begin(), elements_.end());
  lists.clockwise.insert(lists.clockwise.end(), clockwise_.begin(), clockwise_.end());
  for (std::size_t c = 0; c < leftmost_.size(); ++c) {
    const std::uint32_t v = leftmost_[c];
    if (first_out_[v] != first_out_[v + 1]) continue;
    const std::uint32_t f = name_[facet_of_component_[c]];
    if (f != none) lists.isolated.push_back({vertex_ids_[v], f});
  }
}

void Drawing::draw(SheetLists& lists) {
  make_elements();
  collect_vertices();
  sort_around_vertices();
  trace_loops();
  find_components();
  nest_components();
  cover_facets();
  write(lists);
}

}  // namespace quoin::booleans
