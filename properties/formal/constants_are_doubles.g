# The constants of the filters, computed in doubles, have exactly the values that the proofs use. That of the error of a
# shape is the only one that rounds.
@rnd = float<ieee_64, ne>;
c1 rnd= @orient2d_bound@;
c2 rnd= @incircle_bound@;
c3 rnd= @estimate_bound@;
c4 rnd= @orient2d_bound_b@;
c5 rnd= @orient2d_bound_c@;
c6 rnd= @incircle_bound_b@;
c7 rnd= @incircle_bound_c@;
c8 rnd= @circle_bound@;
c9 rnd= @cotangent_slack@;
c10 rnd= @angle_slack@;
c11 rnd= @length_slack@;
c12 rnd= @radius_slack@;
c13 rnd= @shape_error@;

{ c1 - @orient2d_bound@ in [0, 0] /\ c2 - @incircle_bound@ in [0, 0] /\ c3 - @estimate_bound@ in [0, 0] /\
  c4 - @orient2d_bound_b@ in [0, 0] /\ c5 - @orient2d_bound_c@ in [0, 0] /\ c6 - @incircle_bound_b@ in [0, 0] /\
  c7 - @incircle_bound_c@ in [0, 0] /\ c8 - @circle_bound@ in [0, 0] /\ c9 - @cotangent_slack@ in [0, 0] /\
  c10 - @angle_slack@ in [0, 0] /\ c11 - @length_slack@ in [0, 0] /\ c12 - @radius_slack@ in [0, 0] /\
  c13 -/ @shape_error@ in [-1b-53, 1b-53] }
