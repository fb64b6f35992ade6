# Proves where rounded_quotient in exact/geometry.cpp looks for the quotient: with x = 2^63 n.top / d.top, q = x - f its
# integer part, and the true operands larger than n.top and d.top by factors 1 + e1 and 1 + e2,
#   q - quotient_below <= x (1 + e1) / (1 + e2) <= q + quotient_above.
# A factor: what follows 64 bits whose first one is set is below one unit of the last, below 2^-63.

distance = x * ((e1 - e2) / (1 + e2)) + f;

{
  x in [0x1p62, 0x1p64] /\ e1 in [0, 0x1p-63] /\ e2 in [0, 0x1p-63] /\ f in [0, 1]
  -> distance in [-@quotient_below@, @quotient_above@]
}
