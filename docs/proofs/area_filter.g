# Proves the bound of area_sign in booleans/body/validity.cpp: with u = 2^-53, m terms and S the computed sum of their
# magnitudes, |sum - area| is at most the computed area_bound (m + area_roundings) u S.
#
# A product carries three roundings (two coordinates and its own), the difference of two one more, and that passes
# through at most m - 1 sums that round: n = m + 3 factors 1 + d at most. The standard lemma: n of them are within
# 1.01 n u of 1 together where n u <= 0.01, since (1 + u)^n <= e^(n u). So this holds of every m below 2^33: corners are
# numbered by 32 bits.
# The unit is the true sum of magnitudes. g n u: the error of the sum; h n u: that of S; r1, r2: the roundings of the
# bound (m + area_roundings is exact), by rounding.g.

u = 1b-53;
scale = @area_bound@ * @unit_roundoff@ * (1 + h * (n * u)) * ((1 + r1) * (1 + r2));

{
  n in [4, 0x1.1p33] /\ |g| <= 1.01 /\ |h| <= 1.01 /\ |r1| <= 1b-53 /\ |r2| <= 1b-53
  -> n * (scale - |g| * u) + (@area_roundings@ - 3) * scale >= 0
}
