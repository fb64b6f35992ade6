# One term of turn_filter.g: a minor of exact value m with the error w by pair.g (the unit is its true permanent), times
# a component with relative error r1, the product with relative error r2, both by rounding.g. m = 1 is the permanent
# itself.

error = (m + w) * (1 + r1) * (1 + r2) - m;

{
  |m| <= 1 /\ |w| <= 0x4.2p-53 /\ |r1| <= 1b-53 /\ |r2| <= 1b-53 -> |error| <= 0x6.3p-53
}

error -> m * (r1 + r2 + r1 * r2) + w * ((1 + r1) * (1 + r2));
