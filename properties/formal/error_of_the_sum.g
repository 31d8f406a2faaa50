# The sum of three squared lengths, properties/checker/arithmetic/filter.hpp: the relative error is below 6.01 u with
# u = 2^-53. s0, s1 and s2 are the squared lengths (errors_of_lengths.g), with exact values e0, e1 and e2. The bound is
# 6.0098 u, as a multiple of 2^-64.
@rnd = float<ieee_64, ne>;
s0 = rnd(s0_);
s1 = rnd(s1_);
s2 = rnd(s2_);
sum rnd= s0 + s1 + s2;

{ s0 -/ e0 in [-8200b-64, 8200b-64] /\ s1 -/ e1 in [-8200b-64, 8200b-64] /\ s2 -/ e2 in [-8200b-64, 8200b-64] /\
  s0 in [1b-500, 1b500] /\ s1 in [1b-500, 1b500] /\ s2 in [1b-500, 1b500] /\
  e0 / (e0 + e1) in [0, 1] /\ (e0 + e1) / (e0 + e1 + e2) in [0, 1] ->
  sum -/ (e0 + e1 + e2) in [-12308b-64, 12308b-64] }
