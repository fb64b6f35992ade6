# Proves the error that MapFilter in rounding/motions/map_filter.cpp gives: with u = 2^-53, S the computed sum of the
# terms' magnitudes and F the computed 1 + sum of the factors' magnitudes, |value - exact| is at most the computed
#   map_bound u S + map_floor F.
#
# A term carries six roundings at most (a1 .. a6): two numbers, their product, three sums. The error of a sum is at most
# the largest relative one of its terms times s, the true sum of magnitudes. The same holds of S (b1 .. b6). F is f,
# exactly computed, with four roundings (c1 .. c4); d1 .. d3: the two products and their sum. All by rounding.g, but for
# numbers and products that underflow: each is wrong by 2^-1075, a number times the other factor, all together by less
# than 2^-1072 f, what they take from the bound included.

error = (1 + a1) * (1 + a2) * (1 + a3) * (1 + a4) * (1 + a5) * (1 + a6) - 1;
size = (1 + b1) * (1 + b2) * (1 + b3) * (1 + b4) * (1 + b5) * (1 + b6);
factors = (1 + c1) * (1 + c2) * (1 + c3) * (1 + c4);

{
  s in [0, 0x1p1026] /\ f in [1, 0x1p1027] /\ underflow in [0, 0x1p-1072] /\
  |a1| <= 1b-53 /\ |a2| <= 1b-53 /\ |a3| <= 1b-53 /\ |a4| <= 1b-53 /\ |a5| <= 1b-53 /\ |a6| <= 1b-53 /\
  |b1| <= 1b-53 /\ |b2| <= 1b-53 /\ |b3| <= 1b-53 /\ |b4| <= 1b-53 /\ |b5| <= 1b-53 /\ |b6| <= 1b-53 /\
  |c1| <= 1b-53 /\ |c2| <= 1b-53 /\ |c3| <= 1b-53 /\ |c4| <= 1b-53 /\
  |d1| <= 1b-53 /\ |d2| <= 1b-53 /\ |d3| <= 1b-53
  -> s * (@map_bound@ * @unit_roundoff@ * ((1 + d1) * (1 + d3)) * size - |error|)
     + f * (@map_floor@ * ((1 + d2) * (1 + d3)) * factors - underflow) >= 0
}
