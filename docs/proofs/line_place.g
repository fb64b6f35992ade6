# Proves the slack of `place_of_crossing` in booleans/pairs/proper_pairs.cpp: an edge from a to b, whose ends have the
# values n and -m at a plane, crosses it at a + t (b - a), t = n / (n + m). What is computed is off by line_slack at
# most. That n and m may be off themselves is told beside the filter.
#
# Coordinates a and b are rounded, at most 2^30; n and m, magnitudes of floating-point values, are not tiny.

@double = float<ieee_64, ne>;
n = double(N);
m = double(M);
a = double(A);
b = double(B);
D double= n + m;
T double= n / D;
L double= b - a;
P double= T * L;
X double= a + P;
t = n / (n + m);
place = A + t * (B - A);

{
  A in [-0x1p30, 0x1p30] /\ B in [-0x1p30, 0x1p30] /\ n in [0x1p-300, 0x1p127] /\ m in [0x1p-300, 0x1p127] /\ t in [0, 1]
  -> X - place in [-@line_slack@, @line_slack@]
}

X - place -> (X - (a + P)) + (a - A) + (P - T * L) + (T - t) * L + t * (L - (b - a)) + t * ((b - B) - (a - A));
T - t -> ((T - t) / t) * t;
(T - t) / t -> (T - n / D) / (n / D) * (1 + (n / D - t) / t) + (n / D - t) / t;
(n / D - t) / t -> ((n + m) - D) / D;
((n + m) - D) / D -> - ((D - (n + m)) / (n + m)) / (1 + (D - (n + m)) / (n + m));
