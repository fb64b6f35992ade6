# Proves the slack of `within` in booleans/pairs/block_slabs.cpp: from s to r a line crosses the end of a slab at
# s + t (r - s), t = n / h. What is computed, crossing_slack added or taken away, is not below or not above that.
#
# Coordinates along the line and heights over the slab's end are integers, s and r below 2^61, n and h below 2^62; the
# crossing lies between s and r. Rounding is odd, so n and h stand for their magnitudes. A corner in the slab is the
# case t = 0: its coordinate alone is rounded, and the sum with the slack. Zeros are exact.

@double = float<ieee_64, ne>;
S = double(s);
R = double(r);
T double= double(n) / double(h);
P double= T * double(R - S);
X double= S + P;
high double= X + @crossing_slack@;
low double= X - @crossing_slack@;
t = n / h;
crossing = s + t * (r - s);

{
  s in [-0x1p61, 0x1p61] /\ r in [-0x1p61, 0x1p61] /\ n in [1, 0x1p62] /\ h in [1, 0x1p62] /\ t in [0, 1] /\
  crossing in [-0x1p61, 0x1p61]
  -> high - crossing >= 0 /\ low - crossing <= 0
}

high - crossing -> (high - (X + @crossing_slack@)) + ((X - crossing) + @crossing_slack@);
low - crossing -> (low - (X - @crossing_slack@)) + ((X - crossing) - @crossing_slack@);
