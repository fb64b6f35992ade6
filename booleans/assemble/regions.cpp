#include "booleans/assemble/regions.h"

#include <algorithm>

#include "booleans/classify/naming.h"
#include "grid/lists/partition.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {
namespace {

/// Merges one sheet after the other, each with the memory of those before.
class Merger {
 public:
  Merger(const Arrangement& a, const Selection& selection)
      : a_(a), s_(selection), has_labels_(a.operands.origins != nullptr) {}

  Regions regions;

  /// Room for what sheets may leave; what is not written costs no memory.
  void reserve(Ids<SheetId> sheets) {
    std::size_t facets = 0, half_edges = 0, most = 0;
    for (const SheetId s : sheets) {
      facets += a_.sheets[s].facet_count();
      half_edges += a_.sheets[s].half_edges();
      most = std::max<std::size_t>(most, a_.sheets[s].half_edges());
    }
    corners_.reserve(most);
    parts_.reserve(most);
    loops_.reserve(most / 2);
    regions.planes.reserve(facets);
    regions.loops.reserve(facets, facets, half_edges);
  }

  void merge(SheetId sheet) {
    sheet_ = &a_.sheets[sheet];
    kept_ = s_.kept.data() + a_.sheets.node(sheet, 0).value;
    kept_at_ = s_.kept_at.data() + a_.sheets.element(sheet, 0).value;
    if (std::none_of(kept_, kept_ + sheet_->facet_count(), [](int kept) { return kept != 0; })) return;

    count_ = 0;
    loops_.clear();
    corners_.clear();
    lines_.clear();
    if (has_labels_) {
      is_border_ = s_.is_border.data() + a_.sheets.element(sheet, 0).value;
      name_facets(sheet);
    }
    group_facets();
    trace_loops();
    add_touching_points();
    add_spared(sheet);
    add_regions();
  }

 private:
  struct Loop {
    std::uint32_t region;
    FacetId facet;           // of the region
    std::size_t begin, end;  // in corners_
  };
  /// What a half-edge is: of no kept facet, or done; inside a region, or at its border.
  enum class Part : std::uint8_t { gone, inside, border };

  std::uint32_t half_edges() const { return sheet_->half_edges(); }
  int kept(std::uint32_t h) const { return sheet_->facet[h] == none ? 0 : int{kept_[sheet_->facet[h].value]}; }

  /// Exactly two kept facets meet there, both in this plane and equally oriented.
  bool is_flat(std::uint32_t h) const { return kept(h) == kept(h ^ 1) && kept_at_[h / 2] == 2; }
  /// Another face goes on behind it on this plane.
  bool is_border(std::uint32_t h) const { return is_flat(h) || is_border_[h / 2] != 0; }
  bool is_same_surface(std::uint32_t h) const {
    return !has_labels_ ||
           a_.operands.origins->is_same_surface(names_[sheet_->facet[h].value], names_[sheet_->facet[h ^ 1].value]);
  }
  /// A flat element vanishes, unless the facets carry something different.
  Part part_of(std::uint32_t h) const {
    if (kept(h) == 0) return Part::gone;
    return is_flat(h) && is_same_surface(h) ? Part::inside : Part::border;
  }

  /// What the kept facets carry.
  void name_facets(SheetId sheet) {
    names_.resize(sheet_->facet_count());
    for (const FacetId f : Ids<FacetId>(sheet_->facet_count()))
      if (kept_[f.value] != 0)
        names_[f.value] = provenance_of(a_, s_.named_by[a_.sheets.node(sheet, f)], kept_[f.value]);
  }

  void group_facets() {
    groups_.reset(sheet_->facet_count());
    region_of_.assign(sheet_->facet_count(), none);
    has_inside_ = false;
    parts_.resize(half_edges());
    for (std::uint32_t h = 0; h < half_edges(); ++h) {
      parts_[h] = part_of(h);
      if (parts_[h] != Part::inside) continue;
      has_inside_ = true;
      groups_.unite(sheet_->facet[h].value, sheet_->facet[h ^ 1].value);
    }
    if (has_labels_ && has_inside_) name_groups();
  }
  /// Of what facets of one group carry the first one counts.
  void name_groups() {
    for (std::uint32_t f = 0; f < sheet_->facet_count(); ++f) {
      if (kept_[f] == 0) continue;
      Provenance& first = names_[groups_.find(f)];
      if (a_.operands.origins->comes_before(names_[f], first)) first = names_[f];
    }
  }
  /// Takes the corners from `begin` on for a loop of the facet's region.
  void close_loop(FacetId facet, std::size_t begin) {
    std::uint32_t& region = region_of_[groups_.find(facet.value)];
    if (region == none) region = count_++;
    loops_.push_back({region, facet, begin, corners_.size()});
  }

  /// Turns the loop of the corners from `begin` on round; the edge that began at its last corner still does.
  void reverse_loop(std::size_t begin) {
    std::reverse(corners_.begin() + static_cast<std::ptrdiff_t>(begin), corners_.end());
    if (has_labels_) std::reverse(lines_.begin() + static_cast<std::ptrdiff_t>(begin), lines_.end() - 1);
  }

  void trace_loops() {
    for (std::uint32_t h = 0; h < half_edges(); ++h) {
      if (parts_[h] != Part::border) continue;
      const std::size_t begin = corners_.size();
      for (std::uint32_t g = h; parts_[g] == Part::border;) {
        if (has_labels_) lines_.push_back(is_border(g) ? &a_.names.planes[sheet_->elements[g / 2].line] : nullptr);
        parts_[g] = Part::gone;
        corners_.push_back(sheet_->origin(g));
        g = sheet_->clockwise[g ^ 1];
        while (parts_[g] == Part::inside) g = sheet_->clockwise[g];
      }
      if (kept(h) < 0) reverse_loop(begin);
      close_loop(sheet_->facet[h], begin);
    }
  }

  /// Vertices inside a kept region that it does not list: they stay where other faces end in them.
  void add_touching_points() {
    const auto add = [&](FacetId facet, VertexId vertex) {
      corners_.push_back(vertex);
      if (has_labels_) lines_.push_back(nullptr);
      close_loop(facet, corners_.size() - 1);
    };
    for (const Sheet::Isolated& i : sheet_->isolated)
      if (kept_[i.facet.value] != 0) add(i.facet, i.vertex);
    if (!has_inside_) return;

    for (std::uint32_t h = 0; h < half_edges(); ++h) {
      if (parts_[h] != Part::inside) continue;
      std::uint32_t g = h;
      for (; parts_[g] == Part::inside; g = sheet_->clockwise[g]) parts_[g] = Part::gone;
      if (g == h) add(sheet_->facet[h], sheet_->origin(h));
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

  /// Loops of one region follow each other.
  void add_regions() {
    const auto comes_before = [](const Loop& x, const Loop& y) {
      return x.region != y.region ? x.region < y.region : x.begin < y.begin;
    };
    if (!std::is_sorted(loops_.begin(), loops_.end(), comes_before))
      std::sort(loops_.begin(), loops_.end(), comes_before);

    for (std::size_t i = 0; i < loops_.size(); ++i) {
      const Loop& l = loops_[i];
      regions.loops.add_loop(std::span<const VertexId>(corners_).subspan(l.begin, l.end - l.begin));
      if (has_labels_)
        regions.lines.insert(regions.lines.end(), lines_.begin() + static_cast<std::ptrdiff_t>(l.begin),
                             lines_.begin() + static_cast<std::ptrdiff_t>(l.end));
      if (i + 1 < loops_.size() && loops_[i + 1].region == l.region) continue;
      regions.loops.end_face();
      regions.planes.push_back({sheet_->plane, kept_[l.facet.value] < 0});
      if (has_labels_) regions.provenance.push_back(names_[groups_.find(l.facet.value)]);
    }
  }

  const Arrangement& a_;
  const Selection& s_;
  const Sheet* sheet_ = nullptr;
  const std::int8_t* kept_ = nullptr;      // of the sheet's facets
  const std::uint8_t* kept_at_ = nullptr;  // of its elements
  Array<Part> parts_;                      // per half-edge
  bool has_inside_ = false;                // one of them is inside
  grid::Partition groups_{0};              // of facets
  Array<std::uint32_t> region_of_;         // per group
  std::uint32_t count_ = 0;                // of regions
  Array<Loop> loops_;
  Array<VertexId> corners_;
  const bool has_labels_;
  const std::uint8_t* is_border_ = nullptr;  // of the sheet's elements
  Array<Provenance> names_;                  // of kept facets; at the root of a group that of all of it
  Array<const exact::Plane*> lines_;         // by corner, as Regions::lines
};

}  // namespace

Array<Regions> merged_regions(const Arrangement& a, const Selection& selection) {
  const std::size_t length = grid::long_stretch(a.sheets.size(), 256);
  Array<Regions> parts((a.sheets.size() + length - 1) / length);
  grid::in_stretches(a.sheets.size(), length, [&](std::size_t s, std::size_t begin, std::size_t end) {
    Merger merger(a, selection);
    const Ids<SheetId> sheets(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end));
    merger.reserve(sheets);
    for (const SheetId i : sheets) merger.merge(i);
    parts[s] = std::move(merger.regions);
  });
  return parts;
}

}  // namespace quoin::booleans
