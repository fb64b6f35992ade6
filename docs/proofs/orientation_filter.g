# Proves the bound of projected_filter in exact/predicates.cpp: with u = 2^-53, M, N the largest magnitudes of x and y,
# E, F those of the computed differences in x and y, the computed bound is at least
#   |value - det| <= 2 (l |first| + |second|), in units of M and N.
#
# M and N are the units. E = l j, F = l (1 - j), so E N + F M = l. One product of a difference e = E k1 in x and one
# f = F k2 in y: the true differences are e + u (2 h1 + E m1) and f + u (2 h2 + F m2), the product and the last
# subtraction round (r1, r2, by rounding.g). The product's error is l first + second; value has two such products.
# E, F <= 2 (1 + u). The bound itself has five roundings (s1 .. s5), a part of it no more: one part, orientation_bound u
# times E N + F M = l, covers l first, the other, orientation_tail u times that factor, covers second.

E = l * j;
F = l * (1 - j);
first = j * k1 * (u * (2 * h2 + F * m2)) + (1 - j) * k2 * (u * (2 * h1 + E * m1))
      + l * (j * (1 - j)) * (k1 * k2) * (r1 + r2 + r1 * r2);
second = (u * (2 * h1 + E * m1)) * (u * (2 * h2 + F * m2));
factor = @orientation_bound@ * @unit_roundoff@ * (1 + s1) * (1 + s2) * (1 + s3) * (1 + s4) * (1 + s5);
tail = @orientation_tail@ * @unit_roundoff@;

{
  u in [1b-53, 1b-53] /\ j in [0, 1] /\ l in [0, 4.001] /\ E in [0, 2.001] /\ F in [0, 2.001] /\
  |k1| <= 1 /\ |k2| <= 1 /\ |h1| <= 1 /\ |h2| <= 1 /\ |m1| <= 1 /\ |m2| <= 1 /\ |r1| <= 1b-53 /\ |r2| <= 1b-53 /\
  |s1| <= 1b-53 /\ |s2| <= 1b-53 /\ |s3| <= 1b-53 /\ |s4| <= 1b-53 /\ |s5| <= 1b-53
  -> 2 * first / factor in [-1, 1] /\ 2 * second / (factor * tail) in [-1, 1]
}

$ j in 64;
