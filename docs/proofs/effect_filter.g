# Proves the bound of `effect` in booleans/surface/rounded.cpp: with u = 2^-53, S the computed sum of the terms'
# magnitudes, E and F the largest components of the two edges, |dot - n . (e x f)| is at most the computed
#   effect_bound u (S + effect_floor E F).
#
# A term n (e f) carries eight roundings at most (a1 .. a8): the coefficient, two edge components, two products, the
# difference, two sums. The error of a sum is at most the largest relative one of its terms times s, the true sum of
# magnitudes. The same holds of S (b1 .. b8). c1 .. c3: the roundings of E F, of the sum with it and of the product with
# effect_bound u. All by rounding.g; products of edge components may underflow: six are wrong by 2^-1075 times n < 2^62
# each, less than 2^-1009 in dot and S together. n is whole, so its products do not. E F >= 2^-600.

error = (1 + a1) * (1 + a2) * (1 + a3) * (1 + a4) * (1 + a5) * (1 + a6) * (1 + a7) * (1 + a8) - 1;
size = (1 + b1) * (1 + b2) * (1 + b3) * (1 + b4) * (1 + b5) * (1 + b6) * (1 + b7) * (1 + b8);
scale = @effect_bound@ * @unit_roundoff@ * ((1 + c2) * (1 + c3));

{
  s in [0, 0x1p700] /\ EF in [0x1p-600, 0x1p600] /\ underflow in [0, 0x1p-1009] /\
  |a1| <= 1b-53 /\ |a2| <= 1b-53 /\ |a3| <= 1b-53 /\ |a4| <= 1b-53 /\
  |a5| <= 1b-53 /\ |a6| <= 1b-53 /\ |a7| <= 1b-53 /\ |a8| <= 1b-53 /\
  |b1| <= 1b-53 /\ |b2| <= 1b-53 /\ |b3| <= 1b-53 /\ |b4| <= 1b-53 /\
  |b5| <= 1b-53 /\ |b6| <= 1b-53 /\ |b7| <= 1b-53 /\ |b8| <= 1b-53 /\
  |c1| <= 1b-53 /\ |c2| <= 1b-53 /\ |c3| <= 1b-53
  -> s * (scale * size - |error|) + (scale * @effect_floor@ * (1 + c1) * EF - underflow) >= 0
}
