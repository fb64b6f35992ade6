# Proves the bound of turn_filter in exact/predicates.cpp: with u = 2^-53 and S the computed permanent of magnitudes,
#   |value - det(n_p, n_q, n_r)| <= (turn_bound u) S, the rounding of this product included.
# The unit is the true permanent. Three terms of sizes s q, s (1 - q), 1 - s; the first two have the exact sum s k, all
# three h. g: the terms' errors by turn_term.g, n: the errors of their magnitudes; r1 .. r4: additions, r5: the product,
# by rounding.g.

G = q * g1 + (1 - q) * g2;
H = s * (G + (k + G) * r1) + (1 - s) * g3;
error_of_value = H + (h + H) * r2;
N = q * n1 + (1 - q) * n2;
M = s * (N + (1 + N) * r3) + (1 - s) * n3;
bound = @turn_bound@ * @unit_roundoff@ * (1 + M + (1 + M) * r4) * (1 + r5);

{
  q in [0, 1] /\ s in [0, 1] /\ |k| <= 1 /\ |h| <= 1 /\
  |g1| <= 0x6.3p-53 /\ |g2| <= 0x6.3p-53 /\ |g3| <= 0x6.3p-53 /\
  |n1| <= 0x6.3p-53 /\ |n2| <= 0x6.3p-53 /\ |n3| <= 0x6.3p-53 /\
  |r1| <= 1b-53 /\ |r2| <= 1b-53 /\ |r3| <= 1b-53 /\ |r4| <= 1b-53 /\ |r5| <= 1b-53
  -> error_of_value / bound in [-1, 1]
}

$ q in 8, s in 8;
