# Proves the rounding error of `moving_turn` in booleans/surface/moving_triangles.cpp: with u = 2^-53 and
# rows whose largest components are A and B,
#   |value - det| <= (moving_turn_bound u) A B.
# The unit is A B: components are at most 1. a, b: the products, whose roundings are p1, p2; d: the difference; each by
# rounding.g.

error = (a * p1 - b * p2) + ((a - b) + (a * p1 - b * p2)) * d;

{
  |a| <= 1 /\ |b| <= 1 /\ |p1| <= 1b-53 /\ |p2| <= 1b-53 /\ |d| <= 1b-53
  -> |error| - @moving_turn_bound@ * @unit_roundoff@ <= 0
}
