#include "exact/rational.h"

#include <algorithm>
#include <cmath>

namespace quoin::exact {

Integer to_integer(int128 v) {
  const bool negative = v < 0;
  const uint128 m = negative ? ~static_cast<uint128>(v) + 1 : static_cast<uint128>(v);
  Integer r = static_cast<std::uint64_t>(m >> 64);
  r <<= 64;
  r += static_cast<std::uint64_t>(m);
  return negative ? Integer(-r) : r;
}

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

Integer power_of_ten(unsigned e) { return boost::multiprecision::pow(Integer(10), e); }

/// [+-]digits[.digits][(e|E)[+-]digits]
std::optional<Rational> parse_decimal(std::string_view text, std::size_t most_digits) {
  std::size_t i = 0;
  bool negative = false;
  if (i < text.size() && (text[i] == '+' || text[i] == '-')) negative = text[i++] == '-';

  std::string digits;
  long scale = 0;
  bool any = false;
  for (; i < text.size() && is_digit(text[i]); ++i, any = true) digits += text[i];
  if (i < text.size() && text[i] == '.')
    for (++i; i < text.size() && is_digit(text[i]); ++i, any = true, --scale) digits += text[i];
  if (!any) return std::nullopt;

  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    bool minus = false;
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) minus = text[i++] == '-';
    long e = 0;
    if (i == text.size()) return std::nullopt;
    for (; i < text.size() && is_digit(text[i]); ++i)
      if ((e = e * 10 + (text[i] - '0')) > 400) return std::nullopt;
    scale += minus ? -e : e;
  }
  if (i != text.size() || digits.size() > most_digits) return std::nullopt;

  const std::size_t first = digits.find_first_not_of('0');  // a leading 0 would mean octal
  Integer n = first == std::string::npos ? Integer(0) : Integer(digits.substr(first));
  if (negative) n = -n;
  if (scale >= 0) return Rational(n * power_of_ten(static_cast<unsigned>(scale)));
  return Rational(n, power_of_ten(static_cast<unsigned>(-scale)));
}

/// Of up to 18 digits and nothing else; such numbers need no memory.
std::optional<std::int64_t> parse_short(std::string_view text) {
  constexpr std::size_t most_digits = 18;
  if (text.empty() || text.size() > most_digits || !std::all_of(text.begin(), text.end(), is_digit))
    return std::nullopt;
  std::int64_t n = 0;
  for (const char c : text) n = n * 10 + (c - '0');
  return n;
}

/// v rounded to `precision` bits, ties to even, with the least exponent of the format.
double rounded(const Rational& v, int precision, int least_exponent) {
  if (v == 0) return 0.0;
  const bool negative = v < 0;
  const Integer n = abs(numerator(v)), d = denominator(v);
  // 2^e <= n / d < 2^(e + 2)
  const long e = static_cast<long>(mpz_sizeinbase(n.backend().data(), 2)) -
                 static_cast<long>(mpz_sizeinbase(d.backend().data(), 2)) - 1;

  for (long top = e + 1; top >= e; --top) {  // try exponents until the quotient has its leading bit there
    const long unit = std::max<long>(top - precision + 1, least_exponent);  // weight of the last kept bit
    Integer a = n, b = d;
    if (unit >= 0)
      b <<= static_cast<unsigned long>(unit);
    else
      a <<= static_cast<unsigned long>(-unit);

    Integer q, r;
    divide_qr(a, b, q, r);
    if (top > e && top - precision + 1 > least_exponent &&
        mpz_sizeinbase(q.backend().data(), 2) < static_cast<std::size_t>(precision))
      continue;

    const Integer twice = r * 2;
    if (twice > b || (twice == b && bit_test(q, 0))) ++q;
    const double m = static_cast<double>(static_cast<std::uint64_t>(q));
    const double result = unit > 1100 ? HUGE_VAL : std::ldexp(m, static_cast<int>(unit));
    return negative ? -result : result;
  }
  return 0.0;  // not reached: the second round always returns
}

}  // namespace

std::optional<Rational> parse_rational(std::string_view text, std::size_t most_digits) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return parse_decimal(text, most_digits);
  const std::string_view above = text.substr(0, slash), below = text.substr(slash + 1);
  if (const auto n = parse_short(above), d = parse_short(below); n && d && *d != 0) return Rational(*n, *d);

  const auto n = parse_decimal(above, most_digits), d = parse_decimal(below, most_digits);
  if (!n || !d || *d == 0) return std::nullopt;
  return Rational(*n / *d);
}

std::string to_string(const Rational& v) { return v.str(); }

Rational to_rational(double v) {
  if (v == 0) return 0;
  int e = 0;
  const double m = std::frexp(v, &e);  // |m| in [1/2, 1)
  Integer n = static_cast<std::int64_t>(std::ldexp(m, 53));
  e -= 53;
  if (e >= 0) return Rational(n << static_cast<unsigned>(e));
  return Rational(n, Integer(1) << static_cast<unsigned>(-e));
}

double to_double(const Rational& v) {
  const auto n = mpq_numref(v.backend().data());
  if (mpz_cmp_ui(mpq_denref(v.backend().data()), 1) == 0 && mpz_sizeinbase(n, 2) <= 53) return mpz_get_d(n);
  return rounded(v, 53, -1074);
}

double double_above(const Rational& v) {
  const double r = to_double(v);
  return std::isinf(r) || to_rational(r) >= v ? r : std::nextafter(r, HUGE_VAL);
}

float to_float(const Rational& v) {
  const double r = rounded(v, 24, -149);
  return static_cast<float>(r);  // exact, or infinite beyond the range
}

Rational common_divisor(const Rational& a, const Rational& b) {
  return Rational(gcd(Integer(numerator(a) * denominator(b)), Integer(numerator(b) * denominator(a))),
                  denominator(a) * denominator(b));
}

Rational coordinate(const Point& u, int k) {
  return Rational(to_integer(u.x[static_cast<std::size_t>(k)]), to_integer(u.w));
}

}  // namespace quoin::exact
