# is_outside_circle() and has_no_larger_circumradius() of properties/checker/arithmetic/filter.hpp: the products of sums of
# squared lengths up to largest_square do not overflow. (A sum beyond it is not tame: infinity and NaN answer `no`.)
@rnd = float<ieee_64, ne>;
dot = rnd(dot_);
cross = rnd(cross_);
area = rnd(area_);
shape_dot = rnd(shape_dot_);
sum = rnd(sum_);
squares = rnd(squares_);
sine rnd= area * dot + shape_dot * cross;
sine_error rnd= @circle_bound@ * sum * squares;
s0 = rnd(s0_);
s1 = rnd(s1_);
s2 = rnd(s2_);
radius rnd= s0 * s1 * s2 * @radius_slack@;

{ |dot| <= NUMBER_largest_square /\ |cross| <= NUMBER_largest_square /\ |area| <= NUMBER_largest_square /\
  |shape_dot| <= NUMBER_largest_square /\ |sum| <= NUMBER_largest_square /\ |squares| <= NUMBER_largest_square /\
  |s0| <= NUMBER_largest_square /\ |s1| <= NUMBER_largest_square /\ |s2| <= NUMBER_largest_square ->
  |sine| <= 1b1023 /\ |sine_error| <= 1b1023 /\ |radius| <= 1b1023 }
