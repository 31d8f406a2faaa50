# orient2d() and incircle() of parallel/arithmetic/predicates.hpp: nothing overflows for coordinates up to
# largest_coordinate. (OrientationFilter.v and InCircleFilter.v prove that nothing underflows.)
@rnd = float<ieee_64, ne>;
ux rnd= rnd(ux_) - rnd(dx_);
uy rnd= rnd(uy_) - rnd(dy_);
vx rnd= rnd(vx_) - rnd(dx_);
vy rnd= rnd(vy_) - rnd(dy_);
wx rnd= rnd(wx_) - rnd(dx_);
wy rnd= rnd(wy_) - rnd(dy_);

left rnd= ux * vy;
right rnd= uy * vx;
turn rnd= left - right;
turn_error rnd= @orient2d_bound@ * (|left| + |right|);

u2 rnd= ux * ux + uy * uy;
v2 rnd= vx * vx + vy * vy;
w2 rnd= wx * wx + wy * wy;
circle rnd= w2 * (vx * uy - vy * ux) + (wx * (u2 * vy - v2 * uy) - wy * (u2 * vx - v2 * ux));
circle_error rnd= @incircle_bound@ * (u2 * v2 + w2 * (u2 + v2));

{ |ux_| <= NUMBER_largest_coordinate /\ |uy_| <= NUMBER_largest_coordinate /\ |vx_| <= NUMBER_largest_coordinate /\
  |vy_| <= NUMBER_largest_coordinate /\ |wx_| <= NUMBER_largest_coordinate /\ |wy_| <= NUMBER_largest_coordinate /\
  |dx_| <= NUMBER_largest_coordinate /\ |dy_| <= NUMBER_largest_coordinate ->
  |turn| <= 1b1023 /\ turn_error <= 1b1023 /\ |circle| <= 1b1023 /\ circle_error <= 1b1023 }
