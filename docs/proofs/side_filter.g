# Proves the bound of side_filter in exact/predicates.h: with u = 2^-53 and S the computed sum of the terms' magnitudes,
#   |value - (a x + b y + c z + d)| <= (side_bound u) S, the rounding of this product included.
# The unit is the sum of the true magnitudes. Two pairs of sizes q and 1 - q; w: the pairs' errors by pair.g, n: the
# errors of their sums of magnitudes; h: the exact value; r1, r2: the last additions, r3: the product, by rounding.g.

W = q * w1 + (1 - q) * w2;
error_of_value = W + (h + W) * r1;
N = q * n1 + (1 - q) * n2;
bound = @side_bound@ * @unit_roundoff@ * (1 + N + (1 + N) * r2) * (1 + r3);

{
  q in [0, 1] /\ |h| <= 1 /\ |r1| <= 1b-53 /\ |r2| <= 1b-53 /\ |r3| <= 1b-53 /\
  |w1| <= 0x4.2p-53 /\ |w2| <= 0x4.2p-53 /\ |n1| <= 0x4.2p-53 /\ |n2| <= 0x4.2p-53
  -> error_of_value / bound in [-1, 1]
}

$ q in 32;
