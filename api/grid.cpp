#include <algorithm>
#include <cassert>
#include <cmath>

#include "api/access.h"
#include "exact/rational.h"
#include "io/quoin.h"

namespace quoin {

using exact::Rational;

namespace {

/// Whether files can state the number.
bool is_short(const Rational& v) {
  const auto fits = [](mpz_srcptr n) {
    const std::size_t digits = mpz_sizeinbase(n, 10);  // perhaps one too many
    if (digits <= io::max_lattice_digits) return true;
    return digits == io::max_lattice_digits + 1 &&
           exact::Integer(abs(exact::Integer(n))).str().size() <= io::max_lattice_digits;
  };
  return fits(mpq_numref(v.backend().data())) && fits(mpq_denref(v.backend().data()));
}

Error bad_number(std::string message, std::string where) {
  return {ErrorCode::bad_number, std::move(message), {}, std::move(where)};
}

Result<Rational> number(std::string_view text, const std::string& name, const std::string& where) {
  auto value = exact::parse_rational(text);
  if (!value)
    return bad_number(
        "the " + name + " \"" + std::string(text.substr(0, 80)) + "\" is neither a decimal nor a rational p/q", where);
  if (!is_short(*value))
    return bad_number("the " + name + " has more than " + std::to_string(io::max_lattice_digits) + " digits", where);
  return *std::move(value);
}

Result<Rational> positive_step(std::string_view text) {
  auto step = number(text, "grid step", "step");
  if (step && step.value() <= 0)
    return bad_number("the grid step \"" + std::string(text) + "\" is not positive", "step");
  return step;
}

}  // namespace

Grid Access::grid(grid::Lattice lattice) {
  assert(lattice.step > 0);
  Grid result;
  result.data_ = std::make_shared<const Grid::Data>(Grid::Data{std::move(lattice)});
  return result;
}

Grid::Grid() {
  // Never destroyed, as every static object of the library.
  static const auto& unit = *new auto(std::make_shared<const Data>());
  data_ = unit;
}

Grid::~Grid() = default;
Grid::Grid(const Grid&) = default;
Grid& Grid::operator=(const Grid&) = default;

Result<Grid> Grid::with_step(std::string_view step) {
  auto s = positive_step(step);
  if (!s) return s.error();
  return Access::grid({std::move(s).value()});
}

Result<Grid> Grid::with_step_and_origin(std::string_view step, const std::array<std::string, 3>& origin) {
  const auto s = positive_step(step);
  if (!s) return s.error();

  grid::Lattice lattice{s.value()};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto o = number(origin[k], "grid origin", std::string("origin, ") + "xyz"[k]);
    if (!o) return o.error();
    lattice.origin[k] = o.value();
  }
  return Access::grid(std::move(lattice));
}

Result<Grid> Grid::fitting(const std::array<double, 3>& low, const std::array<double, 3>& high) {
  auto l = low, h = high;
  for (std::size_t k = 0; k < 3; ++k)
    if (high[k] < low[k]) std::swap(l[k], h[k]);
  auto lattice = grid::fitting_lattice(l, h);
  if (!lattice) return lattice.error();
  return Access::grid(std::move(lattice).value());
}

std::string Grid::step() const { return exact::to_string(data_->lattice.step); }

std::array<std::string, 3> Grid::origin() const {
  const auto& o = data_->lattice.origin;
  return {exact::to_string(o[0]), exact::to_string(o[1]), exact::to_string(o[2])};
}

bool Grid::operator==(const Grid& other) const {
  return data_ == other.data_ || data_->lattice == other.data_->lattice;
}

}  // namespace quoin
