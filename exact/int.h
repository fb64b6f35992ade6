/// \file
/// Signed integers whose width is their type.
///
/// `Int<Bits>` holds every integer v with |v| < 2^(Bits-1): Bits counts the sign. Ranges are symmetric, so negation
/// never overflows. Sums and products have the type that surely holds them:
///   Int<A> + Int<B> : Int<max(A, B) + 1>       Int<A> * Int<B> : Int<A + B - 1>
/// (|a| < 2^(A-1) and |b| < 2^(B-1) give |ab| < 2^(A+B-2)). Converting to a wider type is implicit; a narrower one does
/// not compile, except through `narrow<Bits>(v)`, which states that a sharper bound is known (proved where it is used)
/// and is checked at run time in developer builds (QUOIN_CHECKED).
#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace quoin::exact {

__extension__ using int128 = __int128;
__extension__ using uint128 = unsigned __int128;

#if defined(QUOIN_CHECKED) && QUOIN_CHECKED
inline constexpr bool checked = true;
#else
inline constexpr bool checked = false;
#endif

/// Stops the program: a bound of the word ladder was violated. Only developer builds call it.
[[noreturn]] inline void overflow_found(int bits) {
  std::fprintf(stderr, "quoin: a value exceeds its %d-bit type\n", bits);
  std::abort();
}

namespace limbs {

/// r = a + b + carry; returns the carry out.
inline unsigned char add_carry(unsigned char carry, std::uint64_t a, std::uint64_t b, std::uint64_t* r) {
#if defined(__x86_64__)
  unsigned long long sum;  // NOLINT: the intrinsic's type
  carry = _addcarry_u64(carry, a, b, &sum);
  *r = sum;
  return carry;
#else
  const uint128 sum = uint128(a) + b + carry;
  *r = static_cast<std::uint64_t>(sum);
  return static_cast<unsigned char>(sum >> 64);
#endif
}

/// r = a - b - borrow; returns the borrow out.
inline unsigned char subtract_borrow(unsigned char borrow, std::uint64_t a, std::uint64_t b, std::uint64_t* r) {
#if defined(__x86_64__)
  unsigned long long difference;  // NOLINT: the intrinsic's type
  borrow = _subborrow_u64(borrow, a, b, &difference);
  *r = difference;
  return borrow;
#else
  const uint128 difference = uint128(a) - b - borrow;
  *r = static_cast<std::uint64_t>(difference);
  return static_cast<unsigned char>((difference >> 64) & 1);
#endif
}

}  // namespace limbs

template <int Bits>
class Int {
  static_assert(Bits >= 2);

 public:
  static constexpr int bits = Bits;
  /// 64-bit limbs, two's complement, least significant first.
  static constexpr int words = (Bits + 63) / 64;

  Int() = default;

  /// From a built-in integer. Developer builds check that it is in range.
  explicit Int(int128 value) {
    limb_[0] = static_cast<std::uint64_t>(value);
    if constexpr (words > 1) limb_[1] = static_cast<std::uint64_t>(value >> 64);
    for (int i = 2; i < words; ++i) limb_[i] = value < 0 ? ~std::uint64_t{0} : 0;
    if constexpr (checked && Bits <= 128) {
      const uint128 size = value < 0 ? ~static_cast<uint128>(value) + 1 : static_cast<uint128>(value);
      if (size >> (Bits - 1) != 0) overflow_found(Bits);
    }
  }

  /// Widening: exact. A narrower target type is not accepted.
  template <int Other>
  Int(const Int<Other>& other) {  // NOLINT: implicit by design
    static_assert(Other <= Bits, "this conversion could lose bits: state the proved bound with narrow<Bits>()");
    extend_from(other);
  }

  std::uint64_t limb(int i) const { return limb_[i]; }
  bool negative() const { return static_cast<std::int64_t>(limb_[words - 1]) < 0; }

  /// -1, 0 or +1.
  int sign() const {
    if (negative()) return -1;
    std::uint64_t any = 0;
    for (int i = 0; i < words; ++i) any |= limb_[i];
    return any != 0 ? 1 : 0;
  }

  Int operator-() const {
    Int r;
    unsigned char borrow = 0;
#pragma GCC unroll 12
    for (int i = 0; i < words; ++i) borrow = limbs::subtract_borrow(borrow, 0, limb_[i], &r.limb_[i]);
    return r;
  }

  friend bool operator==(const Int& a, const Int& b) { return a.limb_ == b.limb_; }

  /// The low 128 bits; the value itself when Bits <= 128.
  int128 low() const {
    if constexpr (words == 1)
      return static_cast<std::int64_t>(limb_[0]);
    else
      return static_cast<int128>((uint128(limb_[1]) << 64) | limb_[0]);
  }

  /// Nearest double, ties to even. Bits < 1024, so it never overflows.
  double to_double() const;

 private:
  template <int>
  friend class Int;
  template <int A, int B>
  friend Int<(A > B ? A : B) + 1> operator+(const Int<A>&, const Int<B>&);
  template <int A, int B>
  friend Int<(A > B ? A : B) + 1> operator-(const Int<A>&, const Int<B>&);
  template <int A, int B>
  friend Int<A + B - 1> operator*(const Int<A>&, const Int<B>&);
  template <int To, int From>
  friend Int<To> narrow(const Int<From>&);
  template <int A>
  friend Int<A> shifted_left(const Int<A>&, int);

  template <int Other>
  void extend_from(const Int<Other>& other) {
    constexpr int n = Int<Other>::words < words ? Int<Other>::words : words;
    for (int i = 0; i < n; ++i) limb_[i] = other.limb_[i];
    for (int i = n; i < words; ++i) limb_[i] = other.negative() ? ~std::uint64_t{0} : 0;
  }

  std::array<std::uint64_t, words> limb_;
};

template <int A, int B>
inline Int<(A > B ? A : B) + 1> operator+(const Int<A>& a, const Int<B>& b) {
  using R = Int<(A > B ? A : B) + 1>;
  const R x = a, y = b;
  R r;
  unsigned char carry = 0;
#pragma GCC unroll 12
  for (int i = 0; i < R::words; ++i) carry = limbs::add_carry(carry, x.limb_[i], y.limb_[i], &r.limb_[i]);
  return r;
}

template <int A, int B>
inline Int<(A > B ? A : B) + 1> operator-(const Int<A>& a, const Int<B>& b) {
  using R = Int<(A > B ? A : B) + 1>;
  const R x = a, y = b;
  R r;
  unsigned char borrow = 0;
#pragma GCC unroll 12
  for (int i = 0; i < R::words; ++i) borrow = limbs::subtract_borrow(borrow, x.limb_[i], y.limb_[i], &r.limb_[i]);
  return r;
}

/// Schoolbook product of the limbs read as unsigned, modulo 2^(64 words), then one correction per negative factor:
/// a = a_u - 2^(64 Wa) [a < 0], so a b = a_u b_u - 2^(64 Wa) b_u [a < 0] - 2^(64 Wb) a_u [b < 0] (+ a multiple of
/// 2^(64 (Wa + Wb)), which is 0 modulo 2^(64 words) because words <= Wa + Wb).
template <int A, int B>
inline Int<A + B - 1> operator*(const Int<A>& a, const Int<B>& b) {
  using R = Int<A + B - 1>;
  constexpr int wa = Int<A>::words, wb = Int<B>::words;
  if constexpr (wa == 1 && wb == 1) {
    return R(int128(static_cast<std::int64_t>(a.limb_[0])) * static_cast<std::int64_t>(b.limb_[0]));
  } else {
    R r;
    for (int i = 0; i < R::words; ++i) r.limb_[i] = 0;

#pragma GCC unroll 12
    for (int i = 0; i < wa; ++i) {
      std::uint64_t carry = 0;
#pragma GCC unroll 12
      for (int j = 0; j < wb; ++j) {
        if (i + j >= R::words) break;
        const uint128 t = uint128(a.limb_[i]) * b.limb_[j] + r.limb_[i + j] + carry;
        r.limb_[i + j] = static_cast<std::uint64_t>(t);
        carry = static_cast<std::uint64_t>(t >> 64);
      }
      if (i + wb < R::words) r.limb_[i + wb] = carry;
    }

    if (a.negative()) {
      unsigned char borrow = 0;
#pragma GCC unroll 12
      for (int j = 0; wa + j < R::words; ++j)
        borrow = limbs::subtract_borrow(borrow, r.limb_[wa + j], b.limb_[j], &r.limb_[wa + j]);
    }
    if (b.negative()) {
      unsigned char borrow = 0;
#pragma GCC unroll 12
      for (int j = 0; wb + j < R::words; ++j)
        borrow = limbs::subtract_borrow(borrow, r.limb_[wb + j], a.limb_[j], &r.limb_[wb + j]);
    }
    return r;
  }
}

/// -1, 0, +1 as a is less than, equal to, greater than b.
template <int A, int B>
inline int compare(const Int<A>& a, const Int<B>& b) {
  constexpr int bits = A > B ? A : B;
  const Int<bits> x = a, y = b;
  if (x.negative() != y.negative()) return x.negative() ? -1 : 1;
  for (int i = Int<bits>::words - 1; i >= 0; --i)
    if (x.limb(i) != y.limb(i)) return x.limb(i) < y.limb(i) ? -1 : 1;
  return 0;
}

/// States that |v| < 2^(To-1) although the type of v allows more. Checked in developer builds.
template <int To, int From>
inline Int<To> narrow(const Int<From>& v) {
  static_assert(To <= From);
  Int<To> r;
  for (int i = 0; i < Int<To>::words; ++i) r.limb_[i] = v.limb_[i];

  if constexpr (checked) {
    const Int<From> back = r;
    bool fits = back == v;
    constexpr int top = (To - 1) % 64;  // the sign bit's place in the top limb
    const std::uint64_t high =
        static_cast<std::uint64_t>(static_cast<std::int64_t>(r.limb_[Int<To>::words - 1]) >> top);
    fits = fits && (high == 0 || high == ~std::uint64_t{0});
    const Int<From + 1> flipped = -Int<From + 1>(v);  // -2^(To-1) has the right bits but is out of the symmetric range
    fits = fits && (!v.negative() || ((flipped.limb_[Int<To>::words - 1] >> top) & 1) == 0);
    if (!fits) overflow_found(To);
  }
  return r;
}

/// |v| as top * 2^exponent with 2^63 <= top < 2^64 and the dropped bits below one unit of top.
struct Leading {
  std::uint64_t top = 0;  // 0 for v = 0
  int exponent = 0;
  bool sticky = false;  // some dropped bit is set
};

template <int A>
inline Leading leading(const Int<A>& v) {
  constexpr int n = Int<A>::words;
  const Int<A> m = v.negative() ? -v : v;
  int i = n - 1;
  while (i >= 0 && m.limb(i) == 0) --i;
  if (i < 0) return {};

  const int shift = __builtin_clzll(m.limb(i));
  Leading r;
  r.top = m.limb(i) << shift;
  std::uint64_t rest = 0;
  if (i > 0 && shift > 0) {
    r.top |= m.limb(i - 1) >> (64 - shift);
    rest = m.limb(i - 1) << shift;
  } else if (i > 0) {
    rest = m.limb(i - 1);
  }
  for (int j = 0; j + 1 < i; ++j) rest |= m.limb(j);

  r.exponent = 64 * i - shift;
  r.sticky = rest != 0;
  return r;
}

/// v * 2^count within the same type; the caller knows that it fits. Checked in developer builds.
template <int A>
inline Int<A> shifted_left(const Int<A>& v, int count) {
  constexpr int n = Int<A>::words;
  if constexpr (checked) {
    const Leading m = leading(v);
    if (m.top != 0 && m.exponent + 64 + count > A - 1) overflow_found(A);
  }

  Int<A> r;
  const int whole = count / 64, part = count % 64;
  for (int i = n - 1; i >= 0; --i) {
    const std::uint64_t high = i - whole >= 0 ? v.limb_[i - whole] : 0;
    const std::uint64_t low = i - whole - 1 >= 0 ? v.limb_[i - whole - 1] : 0;
    r.limb_[i] = part == 0 ? high : (high << part) | (low >> (64 - part));
  }
  return r;
}

template <int Bits>
inline double Int<Bits>::to_double() const {
  static_assert(Bits < 1024);
  const Leading m = leading(*this);
  const double value = __builtin_ldexp(static_cast<double>(m.top | (m.sticky ? 1U : 0U)), m.exponent);
  return negative() ? -value : value;
}

}  // namespace quoin::exact
