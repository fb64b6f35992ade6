# Proves the bound of Snapper in grid/snap.cpp: with u = 2^-53, y computed at f from the nearest integer and Y exact,
# f + |y - Y| is at most the computed sum of f and the computed bound
#   snap_bound u |y| + snap_origin u |O / s| + snap_floor.
# Without f and the rounding of that sum: |y - Y| is at most the bound.
#
# A = |y|, q = |O / s|; f is k A, as 0 is an integer. The rounded origin is O (1 + d0), the reciprocal of the step
# (1 + d2) / s; the difference and the product round (d1, d3). So Y = y / P + d0 O / s with
# P = (1 + d1) (1 + d2) (1 + d3) = 1 + E. b1, b2: roundings of the bound's first product and of its sum with the rest,
# b3 .. b5: of that, b6: of the sum with f. All by rounding.g; underflow of products, 2^-1075 each, is below 2^-1072
# together.
# What stands beside A is no less than some -u^2: snap_floor covers that.

D = d1 + d2 + d1 * d2;
E = D + d3 + D * d3;
sums = (1 + b2) * (1 + b6);
rounded_q = (1 + d0) * (1 + d2) * ((1 + b3) * (1 + b4) * (1 + b5));
beside_A = k * b6 + @snap_bound@ * @unit_roundoff@ * ((1 + b1) * sums) - |E / (1 + E)|;
beside_q = @snap_origin@ * @unit_roundoff@ * (rounded_q * sums) - |d0|;
beside_1 = @snap_floor@ * ((1 + b5) * sums) - underflow;

{
  A in [0, 0x1p30] /\ k in [0, 1] /\ q in [0, 0x1p1801] /\ underflow in [0, 0x1p-1072] /\
  |d0| <= 1b-53 /\ |d1| <= 1b-53 /\ |d2| <= 1b-53 /\ |d3| <= 1b-53 /\
  |b1| <= 1b-53 /\ |b2| <= 1b-53 /\ |b3| <= 1b-53 /\ |b4| <= 1b-53 /\ |b5| <= 1b-53 /\ |b6| <= 1b-53
  -> A * beside_A + q * beside_q + beside_1 >= 0
}
