# cotangent_below() of properties/checker/arithmetic/filter.hpp is at most the cotangent of the angle with this cosine.
# For a cosine of 0 it is 0. Below 2^-27 the root is 1, the quotient is the cosine, and the product is not above it.
@rnd = float<ieee_64, ne>;
cosine = rnd(cosine_);
slack = @cotangent_slack@;
a rnd= 1 - cosine;
b rnd= 1 + cosine;
p rnd= a * b;
s rnd= sqrt(p);
q rnd= cosine / s;
cotangent rnd= q * slack;
exact = cosine / sqrt((1 - cosine) * (1 + cosine));

{ cosine in [1b-900, 1] /\ 1 - cosine in [1b-53, 1] -> cotangent -/ exact in [-1b-49, 0] }

(cotangent - exact) / exact -> (1 + (cotangent - exact * slack) / (exact * slack)) * slack - 1
  { exact <> 0, exact * slack <> 0, slack <> 0 };
