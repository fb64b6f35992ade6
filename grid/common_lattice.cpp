#include "grid/common_lattice.h"

#include <algorithm>
#include <cassert>

namespace quoin::grid {

using exact::Integer;
using exact::Rational;

namespace {

constexpr std::size_t most_odd_parts = 16;
/// Of numerators and denominators: files state 1000 digits.
constexpr std::size_t most_bits = 3300;

bool is_short(const Rational& v) {
  const mpq_t& q = v.backend().data();
  return mpz_sizeinbase(mpq_numref(q), 2) <= most_bits && mpz_sizeinbase(mpq_denref(q), 2) <= most_bits;
}

bool is_short(const Lattice& lattice) {
  return is_short(lattice.step) &&
         std::all_of(lattice.origin.begin(), lattice.origin.end(), [](const Rational& x) { return is_short(x); });
}

/// The least integer that is not below v.
Integer ceiling(const Rational& v) {
  Integer q;
  mpz_cdiv_q(q.backend().data(), mpq_numref(v.backend().data()), mpq_denref(v.backend().data()));
  return q;
}

Rational greatest_common_divisor(const std::vector<Lattice>& lattices) {
  Rational g = 0;
  for (const Lattice& lattice : lattices) {
    g = exact::common_divisor(g, lattice.step);
    for (std::size_t k = 0; k < 3; ++k)
      g = exact::common_divisor(g, Rational(lattice.origin[k] - lattices[0].origin[k]));
  }
  return g;
}

/// The point nearest to the centre of the box that is whole steps away from the lattice's origin becomes its origin.
Lattice centred(Lattice lattice, const ModelBox& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational steps = ((box.low[k] + box.high[k]) / 2 - lattice.origin[k]) / lattice.step;
    lattice.origin[k] += Rational(ceiling(steps - Rational(1, 2))) * lattice.step;
  }
  return lattice;
}

/// Whether the box lies within so many steps of the lattice's origin.
bool within(const Lattice& lattice, const ModelBox& box, const Rational& steps) {
  const Rational reach = steps * lattice.step;
  for (std::size_t k = 0; k < 3; ++k)
    if (box.high[k] - lattice.origin[k] > reach || lattice.origin[k] - box.low[k] > reach) return false;
  return true;
}

/// Of the two origins the one about which the box lies in the world.
std::optional<Lattice> holding(const Lattice& lattice, const ModelBox& box) {
  if (in_world(lattice, box)) return lattice;
  const Lattice moved = centred(lattice, box);
  return in_world(moved, box) ? std::optional(moved) : std::nullopt;
}

/// The lattices of the steps m g 2^k, k >= 0, with the two least k at which the box fits.
void add_powers(const Lattice& base, const Integer& m, const ModelBox& box, std::vector<Lattice>& out) {
  Lattice lattice = base;
  lattice.step *= m;
  // Half the box, in steps, over the world: below, nothing fits.
  const Integer least = ceiling(Rational(box.size() / (2 * lattice.step * exact::world)));
  while (Rational(lattice.step / base.step) < Rational(m * least)) lattice.step *= 2;

  for (int found = 0; found < 2; lattice.step *= 2)
    if (const auto fits = holding(lattice, box)) {
      out.push_back(*fits);
      ++found;
    }
}

/// The lattice of the step c g with the least c at which the box surely fits: rounding the origin takes half a step.
void add_least(const Lattice& base, const ModelBox& box, std::vector<Lattice>& out) {
  const Rational world = exact::world - Rational(1, 2);
  Lattice lattice = base;
  lattice.step *= std::max<Integer>(1, ceiling(Rational(box.size() / (2 * base.step * world))));
  out.push_back(*holding(lattice, box));
}

/// The odd parts of the steps' multiples of g but 1, ascending.
std::vector<Integer> odd_parts(const std::vector<Lattice>& lattices, const Rational& g) {
  std::vector<Integer> parts;
  for (const Lattice& lattice : lattices) {
    const Integer a = numerator(Rational(lattice.step / g));
    const Integer odd = a >> lsb(a);
    if (odd != 1) parts.push_back(odd);
  }
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  parts.resize(std::min(parts.size(), most_odd_parts));
  return parts;
}

}  // namespace

void ModelBox::add(const std::array<Rational, 3>& point) { add(ModelBox{point, point}); }

void ModelBox::add(const ModelBox& box) {
  if (box.is_empty()) return;
  const bool was_empty = is_empty();
  for (std::size_t k = 0; k < 3; ++k) {
    if (was_empty || box.low[k] < low[k]) low[k] = box.low[k];
    if (was_empty || box.high[k] > high[k]) high[k] = box.high[k];
  }
}

Rational ModelBox::size() const {
  Rational most = 0;
  for (std::size_t k = 0; k < 3; ++k) most = std::max<Rational>(most, high[k] - low[k]);
  return most;
}

bool finer(const Lattice& a, const Lattice& b) { return a.step != b.step ? a.step < b.step : a.origin < b.origin; }

void sort_distinct(std::vector<Lattice>& lattices) {
  std::sort(lattices.begin(), lattices.end(), finer);
  lattices.erase(std::unique(lattices.begin(), lattices.end()), lattices.end());
}

bool in_world(const Lattice& lattice, const ModelBox& box, const Rational& slack) {
  if (box.is_empty()) return true;
  return within(lattice, box, Rational(exact::world + slack / lattice.step));
}

std::vector<Lattice> lattices_between(const std::vector<Lattice>& own, const ModelBox& box) {
  assert(!own.empty() && !box.is_empty());
  std::vector<Lattice> between;
  Lattice base = own.back();
  base.step = greatest_common_divisor(own);
  if (!is_short(base)) return {};

  add_powers(base, 1, box, between);
  for (const Integer& m : odd_parts(own, base.step)) add_powers(base, m, box, between);
  add_least(base, box, between);

  sort_distinct(between);
  std::erase_if(between, [](const Lattice& lattice) { return !is_short(lattice); });
  return between;
}

Lattice rounding_lattice(const std::vector<Lattice>& own, const ModelBox& box) {
  assert(!own.empty() && box.size() > 0);
  // Where its numbers are too long for a file the powers of two serve.
  for (Lattice lattice : {own.back(), Lattice{}}) {
    const auto fits = [&] { return within(centred(lattice, box), box, rounding_bound); };
    while (fits()) lattice.step /= 2;
    while (!fits()) lattice.step *= 2;

    if (!in_world(lattice, box)) lattice = centred(lattice, box);
    if (is_short(lattice)) return lattice;
  }
  assert(false);
  return {};
}

}  // namespace quoin::grid
