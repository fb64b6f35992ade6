# The sum of two products, used by side_filter.g and turn_filter.g: two terms of magnitudes p and 1 - p (the unit is
# the sum of their true magnitudes) and exact sum t, with relative errors e1 and e2 by rounding.g, then an addition with
# relative error r. t = 1 is the sum of the magnitudes themselves.

P = p * e1 + (1 - p) * e2;
error = P + (t + P) * r;

{
  p in [0, 1] /\ |t| <= 1 /\ |e1| <= 0x3.001p-53 /\ |e2| <= 0x3.001p-53 /\ |r| <= 1b-53 -> |error| <= 0x4.2p-53
}

$ p in 32;
