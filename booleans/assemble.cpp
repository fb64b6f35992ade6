#include "booleans/assemble.h"

#include <unordered_map>

#include "booleans/regions.h"
#include "grid/stretches.h"

namespace quoin::booleans {
namespace {

class Assembler {
 public:
  Assembler(const Arrangement& a, const Selection& selection) : a_(a), s_(selection) {}

  Body run() {
    place_of_.resize(a_.operands.bodies.size());
    name_of_.resize(a_.operands.bodies.size());
    name_of_table_.assign(a_.vertices.size(), none);
    table_place_.assign(a_.vertices.size(), none);
    host_ = find_host();
    for (std::uint32_t o = 0; o < a_.operands.bodies.size(); ++o) {
      if (o == host_) continue;
      name_of_[o].assign(a_.operands.bodies[o]->vertex_count(), none);
      for (const std::uint32_t v : a_.touched.table_vertices[o]) name_of_[o][v] = by_table;
    }
    if (host_ == none)
      reserve();
    else
      keep_host();
    body_.full_at_infinity = s_.full_at_infinity;
    keep_raw();
    keep_polygons();
    add_regions();
    drop_vertices();
    emit();
    list_chunks();
    if (host_ != none && !is_tight()) body_ = packed(body_);
    body_.settle();
    return std::move(body_);
  }

 private:
  // A vertex of no touched face stays or goes with all its faces: faces of such vertices are copied, and vertices get
  // their names at once: a grid point its id, a derived one its index with local_bit. While other faces are collected a
  // corner is an index into places_.
  // The result of a small change of a large operand, its host, shares the host's lists: the host's vertices keep their
  // ids, and faces of it that stay are not even copied.
  static constexpr std::uint32_t by_table = none - 1;  // the name of a table vertex is in name_of_table_
  static constexpr std::uint32_t listed = none - 2;    // the same, of one that raw triangles of its operand have
  struct Place {
    std::uint32_t operand;  // none: a table vertex
    std::uint32_t vertex;
    std::uint32_t name;  // if it has one
    std::uint32_t neighbours[2] = {none, none};
    bool fixed;  // it has a name, or more than two neighbours
    bool used;   // it has a name, or is on a loop of at least two corners
  };
  std::uint32_t new_place(std::uint32_t operand, std::uint32_t v, std::uint32_t name) {
    places_.push_back({operand, v, name, {none, none}, name != none, name != none});
    return static_cast<std::uint32_t>(places_.size() - 1);
  }

  std::uint32_t table_place(std::uint32_t v) {
    std::uint32_t& p = table_place_[v];
    if (p == none) p = new_place(none, v, name_of_table_[v]);
    return p;
  }
  bool in_table(std::uint32_t operand, std::uint32_t v) const {
    if (operand != host_) return name_of_[operand][v] == by_table || name_of_[operand][v] == listed;
    const auto& table = a_.touched.vertex_of[operand];
    return !table.empty() && table[v] != none;
  }
  std::uint32_t named(std::uint32_t operand, std::uint32_t v) {
    if (operand == host_) return host_name(v);
    const std::uint32_t name = name_of_[operand][v];
    return name < listed ? name : new_name(operand, v);
  }
  /// A vertex of the host has its own name; that is known to the table from now on.
  std::uint32_t host_name(std::uint32_t v) {
    const std::uint32_t name = name_in_host(v);
    if (in_table(host_, v)) name_of_table_[a_.touched.vertex_of[host_][v]] = name;
    return name;
  }
  std::uint32_t name_in_host(std::uint32_t v) const {
    const Body& host = *a_.operands.bodies[host_];
    return host.is_grid(v) ? v : (v - static_cast<std::uint32_t>(host.derived_base())) | local_bit;
  }
  std::uint32_t new_name(std::uint32_t operand, std::uint32_t v) {
    std::uint32_t& name =
        in_table(operand, v) ? name_of_table_[a_.touched.vertex_of[operand][v]] : name_of_[operand][v];
    if (name != none) return name;
    const Body& body = *a_.operands.bodies[operand];
    if (body.is_grid(v)) {
      name = static_cast<std::uint32_t>(body_.grid_points.size());
      body_.grid_points.push_back(body.grid_points[v]);
    } else {
      name = static_cast<std::uint32_t>(body_.points.size()) | local_bit;
      body_.points.push_back(body.derived(v));
    }
    return name;
  }
  std::uint32_t place(std::uint32_t operand, std::uint32_t v) {
    if (in_table(operand, v)) return table_place(a_.touched.vertex_of[operand][v]);
    if (operand == host_) {
      const auto [at, is_new] = place_in_host_.try_emplace(v, none);
      if (is_new) at->second = new_place(operand, v, name_in_host(v));
      return at->second;
    }
    auto& own = place_of_[operand];
    if (own.empty()) own.assign(a_.operands.bodies[operand]->vertex_count(), none);
    if (own[v] == none) own[v] = new_place(operand, v, name_of_[operand][v]);
    return own[v];
  }

  /// An operand whose lists the result may share: all of it but little lies far from the others and stays.
  std::uint32_t find_host() const {
    const Operands& all = a_.operands;
    for (std::uint32_t o = 0; o < all.bodies.size(); ++o) {
      const std::size_t own = all.base[o + 1] - all.base[o], others = all.face_count() - own + a_.touched.faces.size();
      if (own >= 8 * others && a_.far_patch[o] != none && s_.kept[a_.far_patch[o]] > 0) return o;
    }
    return none;
  }
  /// Shares the host's lists. Of its chunks remains what stays as it is; other faces of it are seen to later.
  void keep_host() {
    const Body& host = *a_.operands.bodies[host_];
    body_ = host;
    body_.is_packed = false;
    body_.chunks.clear();
    std::size_t new_points = a_.vertices.size();
    for (const Body* other : a_.operands.bodies) new_points += other == &host ? 0 : other->grid_points.size();
    if (host.grid_points.size() + new_points > host.derived_base()) move_derived(new_points);
    Box table;
    host_name_of_table_.assign(a_.vertices.size(), none);
    for (const std::uint32_t v : a_.touched.table_vertices[host_]) {
      table.add(host.approximation(v));
      host_name_of_table_[a_.touched.vertex_of[host_][v]] = name_in_host(v);
    }
    for (const OperandChunk& c : a_.operands.chunks_of(host_)) {
      const std::uint32_t base = a_.operands.base[host_];
      if (c.far && !c.box.meets(table))
        keep_run(c, c.begin - base, c.end - base);
      else
        keep_near_host(c, base);
    }
  }
  /// Gives derived points new ids, so that there is room for new grid points and for some more.
  void move_derived(std::size_t new_points) {
    const auto from = static_cast<std::uint32_t>(body_.derived_base());
    const std::size_t grid = body_.grid_points.size();
    body_.room = static_cast<std::uint32_t>(grid + grid / 4 + 2 * new_points);
    for (std::uint32_t& v : body_.corners.edit())
      if (v >= from) v += body_.room - from;
  }
  /// A run of faces of a chunk of the host stays; own ids.
  void keep_run(const Chunk& c, std::uint32_t begin, std::uint32_t end) {
    const auto raw = static_cast<std::uint32_t>(a_.operands.bodies[host_]->triangles.size());
    if (begin < raw)
      keep_chunk(raw_chunks_, begin, end, c.box);
    else
      keep_chunk(polygon_chunks_, begin - raw, end - raw, c.box);
  }
  void keep_near_host(const OperandChunk& c, std::uint32_t base) {
    const Body& host = *a_.operands.bodies[host_];
    const auto raw = static_cast<std::uint32_t>(host.triangles.size());
    std::uint32_t begin = c.begin;
    for (std::uint32_t f = c.begin; f < c.end; ++f) {
      const std::uint32_t patch = a_.patch_of[f];
      const int kept = patch == none ? 0 : s_.kept[patch];
      bool stays = kept > 0;
      if (stays && f - base < raw) {
        for (const std::uint32_t v : host.triangles[f - base]) host_name(v);
      } else if (stays) {
        host.for_corners(f - base, [&](std::uint32_t v) { stays = stays && !in_table(host_, v); });
      }
      if (stays) continue;
      keep_run(c, begin - base, f - base);
      begin = f + 1;
      if (kept != 0) changed_.push_back(f - base);
      if (f - base >= raw) body_.gone_corners += host.corner_count(f - base);
    }
    keep_run(c, begin - base, c.end - base);
  }
  bool is_tight() const {
    std::size_t live = 0;
    for (const Chunk& c : body_.chunks) live += c.end - c.begin;
    return 4 * (body_.face_count() - live) <= live && 5 * body_.gone_corners <= body_.corners.size();
  }
  /// A name as a corner; as an id, if ids of derived points are known already.
  std::uint32_t corner(std::uint32_t name) const { return host_ == none ? name : final_id(name); }

  /// Room for what may stay of the operands; what is not written costs no memory.
  void reserve() {
    std::size_t points = 0, corners = 0, loops = 0, planes = 0;
    for (const Body* body : a_.operands.bodies) {
      points += body->points.size();
      corners += body->corners.size();
      loops += body->loop_corners.size();
      planes += body->planes.size();
    }
    body_.points.reserve(points);
    body_.corners.reserve(corners);
    body_.loop_corners.reserve(loops);
    body_.polygon_loops.reserve(planes + 1);
    body_.planes.reserve(planes);
  }

  bool stays(std::uint32_t face) const { return a_.patch_of[face] != none && s_.kept[a_.patch_of[face]] != 0; }
  /// Copies of raw triangles of one operand. Their corners are `points` of their own, counted from 0, or table
  /// vertices, with local_bit.
  struct RawCopies {
    std::vector<exact::GridPoint> points;
    std::vector<std::uint32_t> table;                     // own ids of the table vertices
    std::vector<std::array<std::uint32_t, 3>*> at_table;  // triangles that have such
    std::span<std::array<std::uint32_t, 3>> triangles;
    std::uint32_t first = 0;  // the name of the first point
  };

  /// The untouched raw triangles that stay: operand by operand, side by side.
  void keep_raw() {
    const auto& chunks = a_.operands.chunks;
    const std::size_t n = a_.operands.bodies.size();
    std::vector<std::uint32_t> start(chunks.size() + 1, static_cast<std::uint32_t>(body_.triangles.size()));
    grid::in_stretches(chunks.size(), 512, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) start[i + 1] = count_raw(chunks[i]);
    });
    for (std::size_t i = 0; i < chunks.size(); ++i) start[i + 1] += start[i];
    body_.triangles.reserve(start.back() + changed_.size() + a_.facet_count());
    const auto out = body_.triangles.grow(start.back() - start.front());

    std::vector<RawCopies> raw(n);
    grid::in_tasks(n, out.size(), [&](std::size_t o) {
      const std::uint32_t begin = a_.operands.first_chunk[o], end = a_.operands.first_chunk[o + 1];
      raw[o].triangles = out.subspan(start[begin] - start.front(), start[end] - start[begin]);
      raw[o].points.reserve(std::min(a_.operands.bodies[o]->grid_points.size(), 3 * raw[o].triangles.size()));
      auto next = raw[o].triangles.data();
      for (std::uint32_t i = begin; i < end; ++i)
        if (start[i] < start[i + 1]) next = copy_raw(chunks[i], next, raw[o]);
    });
    name_raw(raw);
    for (std::size_t i = 0; i < chunks.size(); ++i) keep_chunk(raw_chunks_, start[i], start[i + 1], chunks[i].box);
    listed_triangles_ = static_cast<std::uint32_t>(body_.triangles.size());
    for (const std::uint32_t f : changed_) {
      if (f >= a_.operands.bodies[host_]->triangles.size()) continue;
      const auto& t = a_.operands.bodies[host_]->triangles[f];
      body_.triangles.push_back({host_name(t[0]), host_name(t[2]), host_name(t[1])});
    }
  }
  std::uint32_t count_raw(const OperandChunk& c) const {
    std::uint32_t count = 0;
    if (c.operand != host_ && c.begin - a_.operands.base[c.operand] < a_.operands.bodies[c.operand]->triangles.size())
      for (std::uint32_t f = c.begin; f < c.end; ++f) count += stays(f);
    return count;
  }
  std::array<std::uint32_t, 3>* copy_raw(const OperandChunk& c, std::array<std::uint32_t, 3>* next, RawCopies& copies) {
    const Body& body = *a_.operands.bodies[c.operand];
    auto& names = name_of_[c.operand];
    bool at_table = false;
    const auto corner = [&](std::uint32_t v) {
      std::uint32_t& name = names[v];
      if (name < listed) return name;
      if (name == none) {
        name = static_cast<std::uint32_t>(copies.points.size());
        copies.points.push_back(body.grid_points[v]);
        return name;
      }
      if (name == by_table) copies.table.push_back(v), name = listed;
      at_table = true;
      return a_.touched.vertex_of[c.operand][v] | local_bit;
    };
    for (std::uint32_t f = c.begin; f < c.end; ++f) {
      if (!stays(f)) continue;
      auto t = body.triangles[f - a_.operands.base[c.operand]];
      if (s_.kept[a_.patch_of[f]] < 0) std::swap(t[1], t[2]);
      at_table = false;
      *next = {corner(t[0]), corner(t[1]), corner(t[2])};
      if (at_table) copies.at_table.push_back(next);
      ++next;
    }
    return next;
  }
  /// Gives the corners of copied triangles their names.
  void name_raw(std::vector<RawCopies>& raw) {
    std::size_t points = body_.grid_points.size() + a_.vertices.size();
    for (const RawCopies& r : raw) points += r.points.size();
    body_.grid_points.reserve(points);
    for (RawCopies& r : raw) {
      r.first = static_cast<std::uint32_t>(body_.grid_points.size());
      body_.grid_points.append(r.points.begin(), r.points.end());
    }
    for (std::uint32_t o = 0; o < raw.size(); ++o)
      for (const std::uint32_t v : raw[o].table) new_name(o, v);
    grid::in_tasks(raw.size(), points, [&](std::size_t o) {
      const RawCopies& r = raw[o];
      const auto shift = [&](std::uint32_t& name) {
        if (name < local_bit) name += r.first;
      };
      if (r.first > 0 && !r.points.empty()) {
        for (auto& t : r.triangles) std::for_each(t.begin(), t.end(), shift);
        std::for_each(name_of_[o].begin(), name_of_[o].end(), shift);
      }
      for (auto* t : r.at_table)
        for (std::uint32_t& v : *t)
          if (v & local_bit) v = name_of_table_[v & ~local_bit];
    });
  }

  /// The faces begin .. end - 1, those that stay of one chunk; short chunks that follow each other become one.
  static void keep_chunk(std::vector<Chunk>& chunks, std::uint32_t begin, std::uint32_t end, const Box& box) {
    if (begin == end) return;
    if (!chunks.empty() && chunks.back().end == begin && end - chunks.back().begin <= Chunk::most &&
        chunks.back().box.meets(box)) {
      chunks.back().end = end;
      chunks.back().box.add(box);
    } else {
      chunks.push_back({begin, end, box});
    }
  }

  /// Untouched polygons: those without a vertex of the table are copied, and named before the others.
  void keep_polygons() {
    std::vector<std::array<std::uint32_t, 2>> near;  // (operand, polygon)
    const auto keep = [&](std::uint32_t o, std::uint32_t f) {
      const Body& body = *a_.operands.bodies[o];
      const std::uint32_t p = f - static_cast<std::uint32_t>(body.triangles.size());
      bool far = true;
      body.for_corners(f, [&](std::uint32_t v) { far = far && !in_table(o, v); });
      if (!far) {
        near.push_back({o, p});
        return;
      }
      for_kept_loops(
          o, p, [&](std::uint32_t v) { return corner(named(o, v)); }, [&] { append_loop(loop_); });
      close_polygon(kept_plane(o, p));
    };
    for (const OperandChunk& c : a_.operands.chunks) {
      const std::uint32_t base = a_.operands.base[c.operand];
      if (c.operand == host_ || c.begin - base < a_.operands.bodies[c.operand]->triangles.size()) continue;
      const auto first = static_cast<std::uint32_t>(body_.planes.size());
      if (!copied_whole(c))
        for (std::uint32_t f = c.begin; f < c.end; ++f) {
          const std::uint32_t patch = a_.patch_of[f];
          if (patch != none && s_.kept[patch] != 0) keep(c.operand, f - base);
        }
      keep_chunk(polygon_chunks_, first, static_cast<std::uint32_t>(body_.planes.size()), c.box);
    }
    listed_polygons_ = static_cast<std::uint32_t>(body_.planes.size());
    for (const std::uint32_t f : changed_)
      if (f >= a_.operands.bodies[host_]->triangles.size()) keep(host_, f);
    for (const auto& [o, p] : near) {
      for_kept_loops(
          o, p, [&, o = o](std::uint32_t v) { return place(o, v); }, [&] { regions_.add_loop(loop_); });
      regions_.close(kept_plane(o, p));
    }
  }
  /// Copies the polygons of a chunk of which all stay as they are, far from the table; false when it is not such a one.
  bool copied_whole(const OperandChunk& c) {
    for (std::uint32_t f = c.begin; f < c.end; ++f)
      if (a_.patch_of[f] == none || s_.kept[a_.patch_of[f]] <= 0) return false;
    const Body& body = *a_.operands.bodies[c.operand];
    const std::size_t p = c.begin - a_.operands.base[c.operand] - body.triangles.size(), q = p + (c.end - c.begin);
    const std::uint32_t first_loop = body.polygon_loops[p], last_loop = body.polygon_loops[q];
    const auto corners =
        std::span(body.corners)
            .subspan(body.loop_corners[first_loop], body.loop_corners[last_loop] - body.loop_corners[first_loop]);
    for (const std::uint32_t v : corners)
      if (in_table(c.operand, v)) return false;
    const auto corner_shift = static_cast<std::uint32_t>(body_.corners.size()) - body.loop_corners[first_loop];
    const auto loop_shift = static_cast<std::uint32_t>(body_.loop_corners.size() - 1) - first_loop;
    for (const std::uint32_t v : corners) body_.corners.push_back(corner(named(c.operand, v)));
    for (std::uint32_t j = first_loop; j < last_loop; ++j)
      body_.loop_corners.push_back(body.loop_corners[j + 1] + corner_shift);
    for (std::size_t i = p; i < q; ++i) body_.polygon_loops.push_back(body.polygon_loops[i + 1] + loop_shift);
    body_.planes.append(body.planes.begin() + p, body.planes.begin() + q);
    return true;
  }
  bool is_turned(std::uint32_t o, std::uint32_t p) const {
    return s_.kept[a_.patch_of[a_.operands.base[o] + a_.operands.bodies[o]->triangles.size() + p]] < 0;
  }
  exact::Plane kept_plane(std::uint32_t o, std::uint32_t p) const {
    const exact::Plane& plane = a_.operands.bodies[o]->planes[p];
    return is_turned(o, p) ? plane.opposite() : plane;
  }
  /// visit() for every loop of a polygon that stays, with its corners in loop_, turned as it stays.
  template <class Corner, class Visit>
  void for_kept_loops(std::uint32_t o, std::uint32_t p, Corner corner, Visit visit) {
    const Body& body = *a_.operands.bodies[o];
    for (std::uint32_t j = body.polygon_loops[p]; j < body.polygon_loops[p + 1]; ++j) {
      loop_.clear();
      for (std::uint32_t v : body.loop(j)) loop_.push_back(corner(v));
      if (is_turned(o, p)) std::reverse(loop_.begin(), loop_.end());
      visit();
    }
  }

  /// A loop, then a polygon, of the body.
  void append_loop(std::span<const std::uint32_t> loop) {
    body_.corners.append(loop.begin(), loop.end());
    body_.loop_corners.push_back(static_cast<std::uint32_t>(body_.corners.size()));
  }
  void close_polygon(const exact::Plane& plane) {
    body_.planes.push_back(plane);
    body_.polygon_loops.push_back(static_cast<std::uint32_t>(body_.loop_corners.size() - 1));
  }

  /// Regions of sheets, their corners as places.
  void add_regions() {
    const Regions merged = merged_regions(a_, s_);
    for (std::size_t i = 0; i < merged.size(); ++i) {
      merged.for_loops(i, [&](std::span<const std::uint32_t> loop) {
        loop_.clear();
        for (const std::uint32_t v : loop) loop_.push_back(table_place(v));
        regions_.add_loop(loop_);
      });
      regions_.close(merged.planes[i]);
    }
  }

  /// A vertex with exactly two neighbours lies inside a straight edge: at least two faces that are not coplanar pass
  /// through both of its edges, so both lie on the line of their planes.
  void drop_vertices() {
    for (std::size_t r = 0; r < regions_.size(); ++r)
      regions_.for_loops(r, [&](std::span<const std::uint32_t> loop) {
        if (loop.size() == 1) return;
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const std::uint32_t next = loop[i + 1 < loop.size() ? i + 1 : 0];
          add_neighbour(loop[i], next);
          add_neighbour(next, loop[i]);
        }
      });
    Regions kept;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      regions_.for_loops(r, [&](std::span<const std::uint32_t> loop) {
        loop_.clear();
        for (const std::uint32_t p : loop)
          if (loop.size() == 1 ? places_[p].used : places_[p].fixed) loop_.push_back(p);
        if (!loop_.empty()) kept.add_loop(loop_);
      });
      kept.close(regions_.planes[r]);
    }
    regions_ = std::move(kept);
  }
  void add_neighbour(std::uint32_t p, std::uint32_t q) {
    Place& place = places_[p];
    place.used = true;
    if (place.neighbours[0] == none || place.neighbours[0] == q)
      place.neighbours[0] = q;
    else if (place.neighbours[1] == none || place.neighbours[1] == q)
      place.neighbours[1] = q;
    else
      place.fixed = true;
  }

  bool is_grid(const Place& p) const {
    return p.operand == none ? a_.vertices.is_grid(p.vertex) : a_.operands.bodies[p.operand]->is_grid(p.vertex);
  }

  /// Numbers the places that are left, grid points first, and writes the faces.
  void emit() {
    std::vector<std::uint32_t> id(places_.size(), none);
    std::vector<std::uint8_t> needed(places_.size());
    for (const std::uint32_t p : regions_.corners) needed[p] = 1;
    for (const bool grid : {true, false}) {
      for (std::uint32_t i = 0; i < places_.size(); ++i) {
        const Place& p = places_[i];
        if (!needed[i] || is_grid(p) != grid) continue;
        std::uint32_t name = p.name;
        if (name == none && p.operand == none && host_ != none) name = host_name_of_table_[p.vertex];
        const bool is_new = name == none;
        if (is_new)
          name = static_cast<std::uint32_t>(grid ? body_.grid_points.size() : body_.points.size() | local_bit);
        id[i] = final_id(name);
        if (!is_new) continue;
        if (grid) {
          body_.grid_points.push_back(p.operand == none ? a_.vertices.grid_point(p.vertex)
                                                        : a_.operands.bodies[p.operand]->grid_points[p.vertex]);
        } else {
          body_.points.push_back(p.operand == none ? a_.vertices.point(p.vertex)
                                                   : a_.operands.bodies[p.operand]->point(p.vertex));
        }
      }
    }
    if (host_ == none)
      for (std::uint32_t& c : body_.corners.edit()) c = final_id(c);
    const auto grid_count = static_cast<std::uint32_t>(body_.grid_points.size());
    for (std::size_t i = 0; i < regions_.size(); ++i) {
      const std::uint32_t first = regions_.loops[i];
      const auto corners = std::span(regions_.corners).subspan(regions_.starts[first]);
      if (regions_.loops[i + 1] == first + 1 && regions_.starts[first + 1] == regions_.starts[first] + 3 &&
          std::all_of(corners.begin(), corners.begin() + 3, [&](std::uint32_t p) { return id[p] < grid_count; })) {
        body_.triangles.push_back({id[corners[0]], id[corners[1]], id[corners[2]]});
        continue;
      }
      regions_.for_loops(i, [&](std::span<const std::uint32_t> loop) {
        loop_.clear();
        for (const std::uint32_t p : loop) loop_.push_back(id[p]);
        append_loop(loop_);
      });
      close_polygon(regions_.planes[i]);
    }
  }
  /// Copied faces keep their chunks' boxes.
  void list_chunks() {
    const auto triangles = static_cast<std::uint32_t>(body_.triangles.size());
    body_.chunks = std::move(raw_chunks_);
    add_chunks(body_, listed_triangles_, triangles, body_.chunks);
    for (const Chunk& c : polygon_chunks_) body_.chunks.push_back({triangles + c.begin, triangles + c.end, c.box});
    add_chunks(body_, triangles + listed_polygons_, static_cast<std::uint32_t>(body_.face_count()), body_.chunks);
  }
  /// Precondition: all grid points are there, or there is room for them.
  std::uint32_t final_id(std::uint32_t name) const {
    return name & local_bit ? static_cast<std::uint32_t>(body_.derived_base()) + (name & ~local_bit) : name;
  }

  const Arrangement& a_;
  const Selection& s_;
  Body body_;
  std::vector<Place> places_;
  std::vector<std::uint32_t> table_place_;
  std::vector<std::vector<std::uint32_t>> place_of_;  // per operand, for vertices outside the table
  std::vector<std::uint32_t> name_of_table_;
  std::vector<std::vector<std::uint32_t>> name_of_;  // per operand
  std::uint32_t host_ = none;
  std::unordered_map<std::uint32_t, std::uint32_t> place_in_host_;  // of vertices outside the table
  std::vector<std::uint32_t> host_name_of_table_;                   // none where the host has no such vertex
  std::vector<std::uint32_t> changed_;  // untouched faces of the host that stay, but not as they are; own ids
  std::uint32_t listed_triangles_ = 0, listed_polygons_ = 0;  // those before are in the chunks below
  std::vector<Chunk> raw_chunks_, polygon_chunks_;            // of copied faces; polygons count from 0
  Regions regions_;                                           // corners are places
  std::vector<std::uint32_t> loop_;
};

}  // namespace

Body assemble(const Arrangement& a, const Selection& selection) { return Assembler(a, selection).run(); }

}  // namespace quoin::booleans
