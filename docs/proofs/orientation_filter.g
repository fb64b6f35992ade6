# Proves the bound of projected_filter in exact/predicates.cpp: with u = 2^-53, M, N the largest magnitudes of x and y,
# E, F those of the computed differences in x and y,
#   |value - det| <= 15.9 u (E N + F M + 4 u M N).
# The computed bound, 16 u times the bracket with four roundings, is larger.
#
# M and N are the units. E = l j, F = l (1 - j), so E N + F M = l. One product of a difference e = E k1 in x and one
# f = F k2 in y: the true differences are e + u (2 h1 + E m1) and f + u (2 h2 + F m2), the product and the last
# subtraction round (r1, r2, by rounding.g). The product's error is l first + second; value has two such products.
# E, F <= 2 (1 + u).

E = l * j;
F = l * (1 - j);
first = j * k1 * (u * (2 * h2 + F * m2)) + (1 - j) * k2 * (u * (2 * h1 + E * m1))
      + l * (j * (1 - j)) * (k1 * k2) * (r1 + r2 + r1 * r2);
second = (u * (2 * h1 + E * m1)) * (u * (2 * h2 + F * m2));

{
  u in [1b-53, 1b-53] /\ j in [0, 1] /\ l in [0, 4.001] /\ E in [0, 2.001] /\ F in [0, 2.001] /\
  |k1| <= 1 /\ |k2| <= 1 /\ |h1| <= 1 /\ |h2| <= 1 /\ |m1| <= 1 /\ |m2| <= 1 /\ |r1| <= 1b-53 /\ |r2| <= 1b-53
  -> |first| <= 0x7.fp-53 /\ |second| <= 0x1f.8p-106
}

$ j in 64;
