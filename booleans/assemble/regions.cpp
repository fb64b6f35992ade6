#include "booleans/assemble/regions.h"

#include <algorithm>

#include "grid/lists/partition.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {
namespace {

/// Merges one sheet after the other, each with the memory of those before.
class Merger {
 public:
  Merger(const Arrangement& a, const Selection& selection) : a_(a), s_(selection) {}

  Regions<VertexId> regions;

  void merge(SheetId sheet) {
    sheet_ = &a_.sheets[sheet];
    kept_ = s_.kept.data() + a_.sheets.node(sheet, 0).value;
    kept_at_ = s_.kept_at.data() + a_.sheets.element(sheet, 0).value;
    if (!group_facets()) return;

    count_ = 0;
    region_of_.assign(sheet_->facet_count(), none);
    loops_.clear();
    corners_.clear();
    trace_loops();
    add_touching_points();

    add_spared(sheet);

    // Loops of one region follow each other.
    if (count_ > 1)
      std::sort(loops_.begin(), loops_.end(), [](const Loop& x, const Loop& y) {
        return x.region != y.region ? x.region < y.region : x.begin < y.begin;
      });
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      const Loop& l = loops_[i];
      regions.loops.add_loop(std::span<const VertexId>(corners_).subspan(l.begin, l.end - l.begin));
      if (i + 1 < loops_.size() && loops_[i + 1].region == l.region) continue;
      const exact::Plane& p = a_.names.planes[sheet_->plane];
      regions.close(kept_[l.facet.value] > 0 ? p : p.opposite());
    }
  }

 private:
  struct Loop {
    std::uint32_t region;
    FacetId facet;           // of the region
    std::size_t begin, end;  // in corners_
  };

  std::uint32_t half_edges() const { return sheet_->half_edges(); }
  int kept(std::uint32_t h) const { return sheet_->facet[h] == none ? 0 : int{kept_[sheet_->facet[h].value]}; }
  /// An element vanishes where exactly two kept facets meet, both in this plane and equally oriented.
  bool cancelled(std::uint32_t h) const { return kept(h) == kept(h ^ 1) && kept_at_[h / 2] == 2; }

  /// False when nothing is kept.
  bool group_facets() {
    groups_.reset(sheet_->facet_count());
    bool any = false;
    for (std::uint32_t h = 0; h < half_edges(); ++h) {
      if (kept(h) == 0) continue;
      any = true;
      if (cancelled(h)) groups_.unite(sheet_->facet[h].value, sheet_->facet[h ^ 1].value);
    }
    return any;
  }
  /// Takes the corners from `begin` on for a loop of the facet's region.
  void close_loop(FacetId facet, std::size_t begin) {
    std::uint32_t& region = region_of_[groups_.find(facet.value)];
    if (region == none) region = count_++;
    loops_.push_back({region, facet, begin, corners_.size()});
  }

  void trace_loops() {
    done_.assign(half_edges(), 0);
    for (std::uint32_t h = 0; h < half_edges(); ++h) {
      if (done_[h] || kept(h) == 0 || cancelled(h)) continue;
      const std::size_t begin = corners_.size();
      for (std::uint32_t g = h; !done_[g];) {
        done_[g] = 1;
        corners_.push_back(sheet_->origin(g));
        g = sheet_->clockwise[g ^ 1];
        while (kept(g) != 0 && cancelled(g)) g = sheet_->clockwise[g];
      }
      if (kept(h) < 0) std::reverse(corners_.begin() + static_cast<std::ptrdiff_t>(begin), corners_.end());
      close_loop(sheet_->facet[h], begin);
    }
  }

  void add_spared(SheetId sheet) {
    const std::size_t before = regions.spared.size();
    for (const auto& [facet, face] : a_.sheets.spared(sheet)) {
      const std::uint32_t f = a_.sheets.facet_of(facet).value;
      if (kept_[f] != 0) regions.spared.push_back({regions.size() + region_of_[groups_.find(f)], face});
    }
    std::sort(regions.spared.begin() + static_cast<std::ptrdiff_t>(before), regions.spared.end(),
              [](const SparedRegion& x, const SparedRegion& y) { return x.region < y.region; });
  }

  /// Vertices inside a kept region that it does not list: they stay where other faces end in them.
  void add_touching_points() {
    const auto add = [&](FacetId facet, VertexId vertex) {
      corners_.push_back(vertex);
      close_loop(facet, corners_.size() - 1);
    };
    for (const Sheet::Isolated& i : sheet_->isolated)
      if (kept_[i.facet.value] != 0) add(i.facet, i.vertex);
    done_.assign(half_edges(), 0);
    for (std::uint32_t h = 0; h < half_edges(); ++h) {
      if (done_[h]) continue;
      bool inside = true;
      for (std::uint32_t g = h; !done_[g]; g = sheet_->clockwise[g]) {
        done_[g] = 1;
        inside = inside && kept(g) != 0 && cancelled(g);
      }
      if (inside) add(sheet_->facet[h], sheet_->origin(h));
    }
  }

  const Arrangement& a_;
  const Selection& s_;
  const Sheet* sheet_ = nullptr;
  const std::int8_t* kept_ = nullptr;      // of the sheet's facets
  const std::uint8_t* kept_at_ = nullptr;  // of its elements
  grid::Partition groups_{0};              // of facets
  Array<std::uint32_t> region_of_;         // per group
  std::uint32_t count_ = 0;                // of regions
  Array<Loop> loops_;
  Array<VertexId> corners_;
  Array<std::uint8_t> done_;  // per half-edge
};

}  // namespace

Regions<VertexId> merged_regions(const Arrangement& a, const Selection& selection) {
  const std::size_t length = grid::long_stretch(a.sheets.size(), 256);
  Array<Regions<VertexId>> parts(a.sheets.size() / length + 1);
  grid::in_stretches(a.sheets.size(), length, [&](std::size_t s, std::size_t begin, std::size_t end) {
    Merger merger(a, selection);
    for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) merger.merge(i);
    parts[s] = std::move(merger.regions);
  });
  std::size_t count = 0, loops = 0, corners = 0;
  for (const auto& part : parts) {
    count += part.size();
    loops += part.loops.loop_count();
    corners += part.loops.corners.size();
  }

  Regions<VertexId> all = std::move(parts[0]);
  all.reserve(count, loops, corners);
  for (std::size_t s = 1; s < parts.size(); ++s) all.append(parts[s]);
  return all;
}

}  // namespace quoin::booleans
