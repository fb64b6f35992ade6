# Proves the rounding error of the determinants of `MovingPlane` in booleans/surface/moving_triangles.cpp: with
# u = 2^-53 and rows whose largest components are A, B and C,
#   |value - det| <= (moving_bound u) A B C.
# The unit is A B C: components are at most 1. a .. f: the products of the second and the third row, whose roundings are
# p1 .. p6; d1 .. d3: differences, q1 .. q3: products by the first row, s1, s2: sums; each by rounding.g.

error1 = (a * p1 - b * p2) + ((a - b) + (a * p1 - b * p2)) * d1;
error2 = (c * p3 - d * p4) + ((c - d) + (c * p3 - d * p4)) * d2;
error3 = (e * p5 - f * p6) + ((e - f) + (e * p5 - f * p6)) * d3;
term1 = x1 * (error1 + ((a - b) + error1) * q1);
term2 = x2 * (error2 + ((c - d) + error2) * q2);
term3 = x3 * (error3 + ((e - f) + error3) * q3);
sum = (term1 + term2) + ((x1 * (a - b) + x2 * (c - d)) + (term1 + term2)) * s1;
error = (sum + term3) + ((x1 * (a - b) + x2 * (c - d) + x3 * (e - f)) + (sum + term3)) * s2;

{
  |x1| <= 1 /\ |x2| <= 1 /\ |x3| <= 1 /\
  |a| <= 1 /\ |b| <= 1 /\ |c| <= 1 /\ |d| <= 1 /\ |e| <= 1 /\ |f| <= 1 /\
  |p1| <= 1b-53 /\ |p2| <= 1b-53 /\ |p3| <= 1b-53 /\ |p4| <= 1b-53 /\ |p5| <= 1b-53 /\ |p6| <= 1b-53 /\
  |d1| <= 1b-53 /\ |d2| <= 1b-53 /\ |d3| <= 1b-53 /\ |q1| <= 1b-53 /\ |q2| <= 1b-53 /\ |q3| <= 1b-53 /\
  |s1| <= 1b-53 /\ |s2| <= 1b-53
  -> |error| - @moving_bound@ * @unit_roundoff@ <= 0
}
