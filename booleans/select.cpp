#include "booleans/around_edge.h"
#include "booleans/arrangement.h"
#include "booleans/expression.h"
#include "booleans/seeds.h"

namespace quoin::booleans {
namespace {

/// A well-mixed 64-bit constant per operand: labels are compared as sums of these.
std::uint64_t label_weight(std::uint32_t operand) {
  std::uint64_t x = (operand + 1) * 0x9E3779B97F4A7C15u;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

class Selector {
 public:
  Selector(const Arrangement& a, const Expression& expression)
      : a_(a), expression_(expression), cells_(2 * std::size_t{a.node_count()} + 1), infinity_(2 * a.node_count()) {}

  Selection run() {
    spread_over_fans();
    link_components();
    evaluate_cells();
    keep();
    return std::move(selection_);
  }

 private:
  static Side front(const Use& u) { return 2 * u.facet + (u.turned ? 1 : 0); }  // on the canonical normal's side
  static Side back(const Use& u) { return front(u) ^ 1; }
  /// The side met counter-clockwise after (before) the facet around the edge low -> high.
  static Side after(const Use& u) { return u.left ? front(u) : back(u); }
  static Side before(const Use& u) { return u.left ? back(u) : front(u); }

  template <class Visit>
  void for_fans(Visit&& visit) const {
    const auto& uses = a_.uses;
    for (std::size_t i = 0, j = 0; i < uses.size(); i = j) {
      while (j < uses.size() && uses[j].low == uses[i].low && uses[j].high == uses[i].high) ++j;
      visit(i, j);
    }
  }

  /// Sorts the facets around each edge and unites the sides that look at each other.
  void spread_over_fans() {
    std::vector<std::uint32_t> order;
    for_fans([&](std::size_t begin, std::size_t end) {
      order.clear();
      for (std::size_t i = begin; i < end; ++i) order.push_back(static_cast<std::uint32_t>(i));
      if (order.size() > 2) sort_around_edge(order);
      for (std::size_t i = 0; i < order.size(); ++i) {
        const Use &u = a_.uses[order[i]], &v = a_.uses[order[i + 1 < order.size() ? i + 1 : 0]];
        cells_.unite(after(u), before(v));
      }
    });
  }

  /// Counter-clockwise around low -> high, starting from the first facet.
  void sort_around_edge(std::vector<std::uint32_t>& order) {
    const Use& first = a_.uses[order[0]];
    int k = -1, forward = 0;  // an axis in which the edge runs, and its direction there
    while (forward == 0) forward = a_.vertices.compare_along(++k, first.high, first.low);
    sort_around(
        order, k, forward, [&](std::uint32_t i) -> const exact::Plane& { return a_.planes[a_.uses[i].plane]; },
        [&](std::uint32_t i) { return a_.uses[i].left; });
  }

  /// Components hang together over fans and through facets; each gets its place from a far patch, or else from one ray.
  void link_components() {
    Partition parts(a_.node_count());
    for_fans([&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin + 1; i < end; ++i) parts.unite(a_.uses[begin].facet, a_.uses[i].facet);
    });
    // Facets also hang together over their sheet: all sides of one facet are one node already.
    std::vector<std::uint32_t> component(a_.node_count(), none);
    std::uint32_t count = 0;
    for (std::uint32_t n = 0; n < a_.node_count(); ++n) {
      const std::uint32_t root = parts.find(n);
      if (root == n) component[n] = count++;
      component[n] = component[root];
    }
    std::vector<std::uint8_t> placed(count);
    for (std::uint32_t o = 0; o < a_.far_patch.size(); ++o) {
      const std::uint32_t far = a_.far_patch[o];
      if (far == none) continue;
      cells_.unite(2 * far + (a_.operands.bodies[o]->full_at_infinity ? 1 : 0), infinity_);
      placed[component[far]] = 1;
    }
    for (const Seed& s : find_seeds(a_, component, placed))
      cells_.unite(s.outer, s.beyond == none ? infinity_ : s.beyond);
  }

  /// visit(operand, by) for the change of labels from the front (canonical, or outward for patches) to the back.
  template <class Visit>
  void jump(std::uint32_t node, Visit&& visit) const {
    if (node >= a_.facet_count()) return visit(a_.patch_operand[node - a_.facet_count()], 1);
    const std::uint32_t s = sheet_of_[node];
    const Sheet& sheet = a_.sheets[s];
    const std::uint32_t f = node - a_.facet_base[s];
    for (std::uint32_t c = sheet.cover_start[f]; c < sheet.cover_start[f + 1]; ++c) {
      const TouchedFace& face = a_.touched.faces[sheet.cover[c]];
      visit(face.operand, face.along ? 1 : -1);
    }
  }

  /// Walks from infinity through all facets, changing one evaluator as it goes; labels are never stored, only a sum
  /// of weights per cell that shows whether every way to a cell agrees.
  void evaluate_cells() {
    sheet_of_.resize(a_.facet_count());
    for (std::uint32_t s = 0; s < a_.sheets.size(); ++s)
      for (std::uint32_t f = a_.facet_base[s]; f < a_.facet_base[s + 1]; ++f) sheet_of_[f] = s;

    const std::uint32_t nodes = a_.node_count();
    std::vector<std::uint32_t> start(cells_size() + 1), sides(2 * std::size_t{nodes});
    cell_.resize(2 * std::size_t{nodes} + 1);
    for (Side s = 0; s < cell_.size(); ++s) cell_[s] = cells_.find(s);
    for (Side s = 0; s < 2 * nodes; ++s) ++start[cell_[s] + 1];
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    std::vector<std::uint32_t> at(start.begin(), start.end() - 1);
    for (Side s = 0; s < 2 * nodes; ++s) sides[at[cell_[s]]++] = s;

    Evaluator evaluator(expression_, static_cast<std::uint32_t>(a_.operands.bodies.size()));
    std::uint64_t sum = 0;
    const auto cross = [&](Side from, int sign) {
      const int way = (from & 1 ? -1 : 1) * sign;  // from front to back adds the jump
      jump(from / 2, [&](std::uint32_t operand, int by) {
        evaluator.add(operand, way * by);
        sum += label_weight(operand) * static_cast<std::uint64_t>(std::int64_t{way} * by);
      });
    };
    for (std::uint32_t o = 0; o < a_.operands.bodies.size(); ++o) {
      if (!a_.operands.bodies[o]->full_at_infinity) continue;
      evaluator.add(o, 1);
      sum += label_weight(o);
    }
    inside_.assign(cells_size(), 0);
    sum_.assign(cells_size(), 0);
    std::vector<std::uint8_t> seen(cells_size());
    struct Frame {
      std::uint32_t next;  // into sides
      Side entered;        // none at infinity
    };
    std::vector<Frame> stack;
    const auto enter = [&](std::uint32_t cell, Side through) {
      seen[cell] = 1;
      inside_[cell] = evaluator.value();
      sum_[cell] = sum;
      stack.push_back({start[cell], through});
    };
    const std::uint32_t root = cell_[infinity_];
    enter(root, none);
    while (!stack.empty()) {
      Frame& top = stack.back();
      const std::uint32_t cell = top.entered == none ? root : cell_[top.entered ^ 1];
      if (top.next == start[cell + 1]) {
        if (top.entered != none) cross(top.entered, -1);
        stack.pop_back();
        continue;
      }
      const Side s = sides[top.next++];
      if (seen[cell_[s ^ 1]]) continue;
      cross(s, 1);
      enter(cell_[s ^ 1], s);
    }
    for (std::uint32_t n = 0; n < nodes; ++n) {
      std::uint64_t expected = sum_[cell_[2 * n]];
      jump(n, [&](std::uint32_t operand, int by) {
        expected += label_weight(operand) * static_cast<std::uint64_t>(std::int64_t{by});
      });
      if (!seen[cell_[2 * n]] || !seen[cell_[2 * n + 1]] || sum_[cell_[2 * n + 1]] != expected)
        selection_.consistent = false;
    }
  }

  void keep() {
    selection_.full_at_infinity = inside_[cell_[infinity_]];
    selection_.kept.resize(a_.node_count());
    for (std::uint32_t n = 0; n < a_.node_count(); ++n)
      selection_.kept[n] = static_cast<std::int8_t>(inside_[cell_[2 * n + 1]] - inside_[cell_[2 * n]]);
    selection_.kept_at.assign(a_.element_base.back(), 0);
    for_fans([&](std::size_t begin, std::size_t end) {
      std::size_t count = 0;
      for (std::size_t i = begin; i < end; ++i) count += selection_.kept[a_.uses[i].facet] != 0;
      for (std::size_t i = begin; i < end; ++i)
        if (a_.uses[i].element != none)
          selection_.kept_at[a_.uses[i].element] = static_cast<std::uint8_t>(std::min<std::size_t>(count, 255));
    });
  }

  std::size_t cells_size() const { return 2 * std::size_t{a_.node_count()} + 1; }

  const Arrangement& a_;
  const Expression& expression_;
  Partition cells_;
  const Side infinity_;
  std::vector<std::uint32_t> sheet_of_;  // per facet
  std::vector<std::uint32_t> cell_;      // per side
  std::vector<std::uint8_t> inside_;     // per cell root
  std::vector<std::uint64_t> sum_;
  Selection selection_;
};

}  // namespace

Selection select(const Arrangement& a, const Expression& expression) { return Selector(a, expression).run(); }

}  // namespace quoin::booleans
