# The first sentences of properties/checker/arithmetic/filter.hpp, with u = 2^-53: a product of two differences has a
# relative error below 3.01 u, a squared length below 4.01 u. The bounds are multiples of 2^-64: 3.0098 u and 4.0039 u.
@rnd = float<ieee_64, ne>;
ax = rnd(ax_);
ay = rnd(ay_);
bx = rnd(bx_);
by = rnd(by_);
px rnd= ax - bx;
py rnd= ay - by;
product rnd= px * py;
xx rnd= px * px;
yy rnd= py * py;
square rnd= xx + yy;
exact_xx = (ax - bx) * (ax - bx);
exact_yy = (ay - by) * (ay - by);

{ |px| in [1b-500, 1b500] /\ |py| in [1b-500, 1b500] /\ exact_xx / (exact_xx + exact_yy) in [0, 1] ->
  product -/ ((ax - bx) * (ay - by)) in [-6164b-64, 6164b-64] /\
  square -/ (exact_xx + exact_yy) in [-8200b-64, 8200b-64] }
