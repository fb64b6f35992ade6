# The errors that the filters build on, in IEEE doubles with their underflow; u = 2^-53.
# What the other proofs call 1b-53 is proved here of the filters' unit_roundoff.
# Rounding to nearest is odd, so signs of factors do not matter: a, b, x, d stand for the magnitudes of any non-zero
# component, component, coordinate, offset. Zeros are exact. y stands for any number that does not underflow, z for one
# that does.

@double = float<ieee_64, ne>;
A = double(a);
B = double(b);
X = double(x);
D = double(d);
AX = double(A * X);
AB = double(A * B);
sum = double(v1 + v2);
difference = double(v1 - v2);
AI = double(A * i);
product = double(w1 * w2);
not_small = double(y);
small = double(z);

{
  # v1, v2: any doubles, so multiples of 2^-1074. i: an integer.
  # w1, w2: differences of coordinates, so multiples of 2^-240.
  a in [1, 0x1p62] /\ b in [1, 0x1p62] /\ x in [0x1p-188, 0x1p250] /\ d in [1, 0x1p124] /\
  y in [0x1p-1021, 0x1p1023] /\ z in [0, 0x1p-1021] /\
  @FIX(a, 0) /\ @FIX(i, 0) /\ @FIX(v1, -1074) /\ @FIX(v2, -1074) /\ @FIX(w1, -240) /\ @FIX(w2, -240)
  ->
  A -/ a in [-@unit_roundoff@, @unit_roundoff@] /\ X -/ x in [-@unit_roundoff@, @unit_roundoff@] /\
  D -/ d in [-@unit_roundoff@, @unit_roundoff@] /\
  AX -/ (a * x) in [-0x3.001p-53, 0x3.001p-53] /\ AB -/ (a * b) in [-0x3.001p-53, 0x3.001p-53] /\
  sum -/ (v1 + v2) in [-@unit_roundoff@, @unit_roundoff@] /\
  difference -/ (v1 - v2) in [-@unit_roundoff@, @unit_roundoff@] /\
  AI -/ (A * i) in [-@unit_roundoff@, @unit_roundoff@] /\ product -/ (w1 * w2) in [-@unit_roundoff@, @unit_roundoff@] /\
  not_small -/ y in [-@unit_roundoff@, @unit_roundoff@] /\ small - z in [-0x1p-1075, 0x1p-1075]
}
