#include "booleans/drawing.h"

#include <numeric>
#include <set>
#include <tuple>

namespace quoin::booleans {

void Drawing::add_face(std::uint32_t face) {
  const TouchedFace& f = touched_.faces[face];
  for (std::uint32_t e = f.edges_begin; e < f.edges_end; ++e) {
    const BoundaryEdge& edge = touched_.edges[e];
    const bool forward = before(edge.from, edge.to);
    segments_.push_back(
        {forward ? edge.from : edge.to, forward ? edge.to : edge.from, edge.other, face, forward == f.along ? 1 : -1});
  }
  for (std::uint32_t i = f.isolated_begin; i < f.isolated_end; ++i) points_.push_back(touched_.isolated[i]);
}

void Drawing::add_segment(const SheetSegment& s) {
  const bool forward = before(s.a, s.b);
  segments_.push_back({forward ? s.a : s.b, forward ? s.b : s.a, s.line, none, 0});
}

void Drawing::unite_equal_segments() {
  std::sort(segments_.begin(), segments_.end(), [](const Segment& s, const Segment& t) {
    return std::tie(s.a, s.b, s.face, s.change, s.line) < std::tie(t.a, t.b, t.face, t.change, t.line);
  });
  std::uint32_t n = 0;
  for (const Segment& s : segments_) {
    if (n == 0 || segments_[n - 1].a != s.a || segments_[n - 1].b != s.b) segments_[n++] = s;
    if (s.face != none) segment_changes_.push_back({n - 1, s.face, s.change});
  }
  segments_.resize(n);
  std::sort(points_.begin(), points_.end());
  points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
}

/// visit(i, j) for pairs of segments whose boxes meet, and visit(i, segment count + k) for points k near segment i.
template <class Visit>
void Drawing::close_pairs(Visit visit) const {
  struct Extent {
    double ul, uh, vl, vh;
  };
  const auto n = static_cast<std::uint32_t>(segments_.size());
  const auto total = n + static_cast<std::uint32_t>(points_.size());
  const auto ends = [&](std::uint32_t i) {
    return i < n ? std::pair(segments_[i].a, segments_[i].b) : std::pair(points_[i - n], points_[i - n]);
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
  const auto n = static_cast<std::uint32_t>(segments_.size());
  close_pairs([&](std::uint32_t i, std::uint32_t j) {
    if (j < n)
      split_pair(i, j);
    else
      split_by_point(i, points_[j - n]);
  });
}

void Drawing::split_by_point(std::uint32_t s, std::uint32_t v) {
  const Segment& seg = segments_[s];
  if (v != seg.a && v != seg.b && side(v, seg.line) == 0 && strictly_inside(v, seg)) splits_.push_back({s, v});
}

void Drawing::split_collinear(std::uint32_t s, std::uint32_t t) {
  const Segment &p = segments_[s], &q = segments_[t];
  for (std::uint32_t v : {q.a, q.b})
    if (v != p.a && v != p.b && strictly_inside(v, p)) splits_.push_back({s, v});
  for (std::uint32_t v : {p.a, p.b})
    if (v != q.a && v != q.b && strictly_inside(v, q)) splits_.push_back({t, v});
}

void Drawing::split_pair(std::uint32_t s, std::uint32_t t) {
  const Segment &p = segments_[s], &q = segments_[t];
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
    if (qa * qb < 0) splits_.push_back({t, pa == 0 ? p.a : p.b});
    return;  // both zero: two ends at one point would be one vertex, so nothing is inside
  }
  if (qa * qb == 0) {
    splits_.push_back({s, qa == 0 ? q.a : q.b});
    return;
  }
  const auto crossing = exact::meet(planes_[plane_], planes_[p.line], planes_[q.line]);
  assert(crossing);
  const std::uint32_t name = static_cast<std::uint32_t>(new_points_.size()) | local_bit;
  new_points_.push_back(*crossing);
  splits_.push_back({s, name});
  splits_.push_back({t, name});
}

void Drawing::name_points(VertexTable& vertices) {
  std::vector<std::uint32_t> names;
  names.reserve(new_points_.size());
  for (const exact::Point& p : new_points_) names.push_back(vertices.id(p));
  for (Split& s : splits_)
    if (s.vertex & local_bit) s.vertex = names[s.vertex & ~local_bit];
  new_points_ = {};
}

void Drawing::make_elements(Sheet& sheet) {
  std::sort(splits_.begin(), splits_.end(), [&](const Split& s, const Split& t) {
    if (s.segment != t.segment) return s.segment < t.segment;
    return s.vertex != t.vertex && before(s.vertex, t.vertex);
  });
  struct Piece {
    std::uint32_t a, b, line, segment;
  };
  std::vector<Piece> pieces;
  std::size_t at = 0;
  for (std::uint32_t s = 0; s < segments_.size(); ++s) {
    std::uint32_t from = segments_[s].a;
    for (; at < splits_.size() && splits_[at].segment == s; ++at) {
      if (splits_[at].vertex == from) continue;
      pieces.push_back({from, splits_[at].vertex, segments_[s].line, s});
      from = splits_[at].vertex;
    }
    pieces.push_back({from, segments_[s].b, segments_[s].line, s});
  }
  // Pieces of overlapping segments coincide; each becomes one element with the changes of all.
  std::vector<std::uint32_t> change_start(segments_.size() + 1);
  for (const Change& c : segment_changes_) ++change_start[c.element + 1];
  std::partial_sum(change_start.begin(), change_start.end(), change_start.begin());
  std::sort(pieces.begin(), pieces.end(), [](const Piece& p, const Piece& q) {
    return std::tie(p.a, p.b, p.segment) < std::tie(q.a, q.b, q.segment);
  });
  for (const Piece& p : pieces) {
    if (sheet.elements.empty() || sheet.elements.back().a != p.a || sheet.elements.back().b != p.b)
      sheet.elements.push_back({p.a, p.b, p.line});
    for (std::uint32_t c = change_start[p.segment]; c < change_start[p.segment + 1]; ++c)
      changes_.push_back(
          {static_cast<std::uint32_t>(sheet.elements.size() - 1), segment_changes_[c].face, segment_changes_[c].by});
  }
  direction_.reserve(sheet.elements.size());
  for (const auto& e : sheet.elements) direction_.push_back(frame_.direction(planes_[plane_], planes_[e.line]));
}

void Drawing::collect_vertices(const Sheet& sheet) {
  for (const auto& e : sheet.elements) {
    vertex_ids_.push_back(e.a);
    vertex_ids_.push_back(e.b);
  }
  vertex_ids_.insert(vertex_ids_.end(), points_.begin(), points_.end());
  std::sort(vertex_ids_.begin(), vertex_ids_.end());
  vertex_ids_.erase(std::unique(vertex_ids_.begin(), vertex_ids_.end()), vertex_ids_.end());
  std::vector<std::uint32_t> by_id = vertex_ids_;
  std::sort(vertex_ids_.begin(), vertex_ids_.end(), [&](std::uint32_t a, std::uint32_t b) { return before(a, b); });
  std::vector<std::uint32_t> rank_by_id(by_id.size());
  const auto index = [&](std::uint32_t v) {
    return static_cast<std::size_t>(std::lower_bound(by_id.begin(), by_id.end(), v) - by_id.begin());
  };
  for (std::uint32_t i = 0; i < vertex_ids_.size(); ++i) rank_by_id[index(vertex_ids_[i])] = i;
  rank_.resize(2 * sheet.elements.size());
  for (std::uint32_t h = 0; h < rank_.size(); ++h) rank_[h] = rank_by_id[index(sheet.origin(h))];
}

void Drawing::sort_around_vertices(Sheet& sheet) {
  first_out_.assign(vertex_ids_.size() + 1, 0);
  for (std::uint32_t r : rank_) ++first_out_[r + 1];
  std::partial_sum(first_out_.begin(), first_out_.end(), first_out_.begin());
  out_.resize(rank_.size());
  std::vector<std::uint32_t> at(first_out_.begin(), first_out_.end() - 1);
  for (std::uint32_t h = 0; h < rank_.size(); ++h) out_[at[rank_[h]]++] = h;
  // Counter-clockwise from straight down: first the half-edges that run forward (to the right), then the others. Within
  // a half the turn of the directions direction * (n x n_line) decides, as det(n, n_line, n_line').
  const auto earlier = [&](std::uint32_t g, std::uint32_t h) {
    if ((g & 1) != (h & 1)) return (g & 1) == 0;
    const std::uint32_t e = g / 2, f = h / 2;
    return direction_[e] * direction_[f] *
               exact::turn(planes_[plane_], planes_[sheet.elements[e].line], planes_[sheet.elements[f].line]) >
           0;
  };
  sheet.clockwise.resize(rank_.size());
  for (std::size_t v = 0; v + 1 < first_out_.size(); ++v) {
    const std::uint32_t begin = first_out_[v], end = first_out_[v + 1];
    if (end - begin > 1) std::sort(out_.begin() + begin, out_.begin() + end, earlier);
    for (std::uint32_t i = begin; i < end; ++i) sheet.clockwise[out_[i]] = out_[i > begin ? i - 1 : end - 1];
  }
}

void Drawing::trace_loops(const Sheet& sheet) {
  loop_.assign(rank_.size(), none);
  for (std::uint32_t h = 0; h < loop_.size(); ++h) {
    if (loop_[h] != none) continue;
    for (std::uint32_t g = h; loop_[g] == none; g = sheet.clockwise[g ^ 1]) loop_[g] = loop_count_;
    ++loop_count_;
  }
}

void Drawing::find_components() {
  component_.assign(vertex_ids_.size(), none);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t v = 0; v < component_.size(); ++v) {
    if (component_[v] != none) continue;
    const auto c = static_cast<std::uint32_t>(leftmost_.size());
    leftmost_.push_back(v);
    component_[v] = c;
    stack.push_back(v);
    while (!stack.empty()) {
      const std::uint32_t w = stack.back();
      stack.pop_back();
      for (std::uint32_t i = first_out_[w]; i < first_out_[w + 1]; ++i) {
        const std::uint32_t x = rank_[out_[i] ^ 1];
        if (component_[x] != none) continue;
        component_[x] = c;
        stack.push_back(x);
      }
    }
  }
}

/// +1 when the vertex lies above (left of) the element's line, 0 on it, -1 below. Left of n x n_line is where the
/// line's plane is negative.
int Drawing::above(const Sheet& sheet, std::uint32_t vertex, std::uint32_t e) const {
  return -direction_[e] * side(vertex, sheet.elements[e].line);
}

/// Order of two elements that a vertical line crosses: no two elements cross.
bool Drawing::element_lower(const Sheet& sheet, std::uint32_t e, std::uint32_t f) const {
  if (e == f) return false;
  const auto &p = sheet.elements[e], &q = sheet.elements[f];
  if (p.a == q.a)
    return direction_[e] * direction_[f] * exact::turn(planes_[plane_], planes_[p.line], planes_[q.line]) > 0;
  if (before(p.a, q.a)) return above(sheet, q.a, e) > 0;
  return above(sheet, p.a, f) < 0;
}

/// The sweep's order of elements, and of a vertex among them.
struct Drawing::Lower {
  struct Vertex {
    std::uint32_t id;
  };
  using is_transparent = void;
  const Drawing* drawing;
  const Sheet* sheet;
  bool operator()(std::uint32_t e, std::uint32_t f) const { return drawing->element_lower(*sheet, e, f); }
  bool operator()(std::uint32_t e, Vertex v) const { return drawing->above(*sheet, v.id, e) > 0; }
  bool operator()(Vertex v, std::uint32_t e) const { return drawing->above(*sheet, v.id, e) < 0; }
};

/// Assigns facets to loops. Each component has one loop that looks outward: the one that sees "left" at its leftmost
/// vertex. It belongs to the facet above the element below that vertex, found by one sweep; every other loop bounds a
/// facet of its own.
void Drawing::nest_components(const Sheet& sheet) {
  std::vector<std::uint32_t> outward(leftmost_.size(), none);
  for (std::size_t c = 0; c < leftmost_.size(); ++c) {
    const std::uint32_t v = leftmost_[c];
    if (first_out_[v] != first_out_[v + 1]) outward[c] = loop_[out_[first_out_[v + 1] - 1]];
  }
  facet_total_ = 1;
  facet_of_loop_.assign(loop_count_, none);
  for (std::uint32_t l : outward)
    if (l != none) facet_of_loop_[l] = 0;
  for (std::uint32_t& f : facet_of_loop_)
    if (f == none) f = facet_total_++;
  facet_of_component_.assign(leftmost_.size(), 0);
  if (leftmost_.size() == 1) return;

  using Status = std::set<std::uint32_t, Lower>;
  Status status(Lower{this, &sheet});
  std::vector<Status::iterator> place(sheet.elements.size());
  for (std::uint32_t v = 0; v < vertex_ids_.size(); ++v) {
    const std::uint32_t c = component_[v];
    if (leftmost_[c] == v && !status.empty()) {
      // The highest element below v: the last one that v is above. Nothing passes through the vertex.
      const auto at = status.lower_bound(Lower::Vertex{vertex_ids_[v]});
      if (at != status.begin()) {
        facet_of_component_[c] = facet_of_loop_[loop_[2 * *std::prev(at)]];
        if (outward[c] != none) facet_of_loop_[outward[c]] = facet_of_component_[c];
      }
    }
    for (std::uint32_t i = first_out_[v]; i < first_out_[v + 1]; ++i)
      if (out_[i] & 1) status.erase(place[out_[i] / 2]);
    for (std::uint32_t i = first_out_[v]; i < first_out_[v + 1]; ++i)
      if (!(out_[i] & 1)) place[out_[i] / 2] = status.insert(out_[i] / 2).first;
  }
}

/// Walks from the unbounded facet over the elements and keeps the set of faces that cover each facet.
void Drawing::cover_facets(Sheet& sheet) {
  const std::size_t n = sheet.elements.size();
  std::vector<std::uint32_t> change_start(n + 1);
  for (const Change& c : changes_) ++change_start[c.element + 1];
  std::partial_sum(change_start.begin(), change_start.end(), change_start.begin());

  // Elements by the facets on their two sides.
  std::vector<std::uint32_t> start(facet_total_ + 1), sides(2 * n);
  const auto left = [&](std::uint32_t h) { return facet_of_loop_[loop_[h]]; };
  for (std::uint32_t h = 0; h < 2 * n; ++h) ++start[left(h) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::uint32_t> at(start.begin(), start.end() - 1);
  for (std::uint32_t h = 0; h < 2 * n; ++h) sides[at[left(h)]++] = h;

  std::vector<std::vector<std::pair<std::uint32_t, int>>> cover(facet_total_);  // (face, multiplicity)
  std::vector<std::uint8_t> seen(facet_total_);
  std::vector<std::uint32_t> queue{0};
  seen[0] = 1;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (std::uint32_t s = start[queue[i]]; s < start[queue[i] + 1]; ++s) {
      const std::uint32_t h = sides[s], to = left(h ^ 1);
      if (seen[to]) continue;
      seen[to] = 1;
      queue.push_back(to);
      cover[to] = cover[queue[i]];
      // Half-edge 2e has the left side here, so going to the right takes the change away.
      const int sign = h & 1 ? 1 : -1;
      for (std::uint32_t c = change_start[h / 2]; c < change_start[h / 2 + 1]; ++c) {
        const auto same = std::find_if(cover[to].begin(), cover[to].end(),
                                       [&](const auto& x) { return x.first == changes_[c].face; });
        if (same == cover[to].end())
          cover[to].push_back({changes_[c].face, sign * changes_[c].by});
        else
          same->second += sign * changes_[c].by;
      }
      std::erase_if(cover[to], [](const auto& x) { return x.second == 0; });
    }
  }
  std::vector<std::uint32_t> name(facet_total_, none);
  for (std::uint32_t f = 0; f < facet_total_; ++f) {
    if (cover[f].empty()) continue;
    name[f] = static_cast<std::uint32_t>(sheet.facet_count());
    std::sort(cover[f].begin(), cover[f].end());
    // A face lies on the left of its boundary, so no count is negative; of bad input the labels show it (`select`).
    for (const auto& [face, times] : cover[f])
      sheet.cover.insert(sheet.cover.end(), static_cast<std::size_t>(std::max(times, 0)), face);
    sheet.cover_start.push_back(static_cast<std::uint32_t>(sheet.cover.size()));
  }
  sheet.facet.resize(2 * n);
  for (std::uint32_t h = 0; h < 2 * n; ++h) sheet.facet[h] = name[left(h)];
  for (std::size_t c = 0; c < leftmost_.size(); ++c) {
    const std::uint32_t v = leftmost_[c];
    if (first_out_[v] != first_out_[v + 1]) continue;
    const std::uint32_t f = name[facet_of_component_[c]];
    if (f != none) sheet.isolated.push_back({vertex_ids_[v], f});
  }
}

Sheet Drawing::draw() {
  Sheet sheet;
  sheet.plane = plane_;
  make_elements(sheet);
  collect_vertices(sheet);
  sort_around_vertices(sheet);
  trace_loops(sheet);
  find_components();
  nest_components(sheet);
  cover_facets(sheet);
  return sheet;
}

}  // namespace quoin::booleans
