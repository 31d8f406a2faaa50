// Expansions compared with rational arithmetic. Their values are exact, and their terms are non-zero and in order.
#include "../../../parallel/arithmetic/expansion.hpp"

#include <cmath>
#include <cstdint>

#include "../../../properties/theorems/framework/property.hpp"
#include "predicate_inputs.hpp"

namespace pardel::engine::exact {
namespace {

using CGAL::Gmpq;

rc::Gen<double> number() {
  return rc::gen::apply([](std::int64_t k, int exponent) { return std::ldexp(static_cast<double>(k), exponent); },
                        rc::gen::inRange<std::int64_t>(-(1LL << 53), 1LL << 53), rc::gen::inRange(-60, 60));
}
rc::Gen<Expansion<2>> difference() {
  return rc::gen::apply([](double a, double b) { return Expansion<2>(two_difference(a, b)); }, number(), number());
}

template <std::size_t N>
Gmpq value(const Expansion<N>& e) {
  Gmpq sum = 0;
  for (std::size_t i = 0; i < e.size(); ++i) sum += Gmpq(e[i]);
  return sum;
}

/// True if the terms are non-zero and each is smaller than the last non-zero bit of the next term.
template <std::size_t N>
bool is_well_formed(const Expansion<N>& e) {
  for (std::size_t i = 0; i < e.size(); ++i) {
    if (e[i] == 0) return false;
    if (i == 0) continue;
    int trailing = 0;
    double mantissa = std::ldexp(std::frexp(e[i], &trailing), 53);
    trailing -= 53;
    while (std::fmod(mantissa, 2) == 0) {
      mantissa /= 2;
      ++trailing;
    }
    if (std::abs(e[i - 1]) >= std::ldexp(1.0, trailing)) return false;
  }
  return true;
}

PARDEL_PROPERTY(Two, a_sum_loses_nothing,
                {.statement = "head + tail = a + b, and head is a + b rounded; the fast sum gives the same",
                 .source = "parallel/arithmetic/expansion.hpp",
                 .families = "doubles of 120 octaves"}) {
  const double a = *number(), b = *number();
  const Two sum = two_sum(a, b);
  RC_ASSERT(sum.head == a + b);
  RC_ASSERT(Gmpq(sum.head) + Gmpq(sum.tail) == Gmpq(a) + Gmpq(b));
  const Two fast = std::abs(a) >= std::abs(b) ? fast_two_sum(a, b) : fast_two_sum(b, a);
  RC_ASSERT(fast.head == sum.head);
  RC_ASSERT(fast.tail == sum.tail);
}

PARDEL_PROPERTY(Two, a_difference_loses_nothing,
                {.statement = "head + tail = a - b, and head is a - b rounded",
                 .source = "parallel/arithmetic/expansion.hpp",
                 .families = "doubles of 120 octaves"}) {
  const double a = *number(), b = *number();
  const Two difference = two_difference(a, b);
  RC_ASSERT(difference.head == a - b);
  RC_ASSERT(Gmpq(difference.head) + Gmpq(difference.tail) == Gmpq(a) - Gmpq(b));
}

PARDEL_PROPERTY(Two, a_product_loses_nothing_and_both_ways_to_it_agree,
                {.statement = "head + tail = a b, by splitting and by fused multiplication",
                 .source = "parallel/arithmetic/expansion.hpp",
                 .families = "doubles of 120 octaves"}) {
  const double a = *number(), b = *number();
  const Two split = two_product_by_splitting(a, b), fused = two_product_by_fma(a, b);
  RC_ASSERT(Gmpq(split.head) + Gmpq(split.tail) == Gmpq(a) * Gmpq(b));
  RC_ASSERT(split.head == fused.head);
  RC_ASSERT(split.tail == fused.tail);
}

PARDEL_PROPERTY(
    Expansion, sums_and_differences_are_exact_and_well_formed,
    {.statement = "the terms of e + f and e - f sum to the exact value; none is zero, none overlaps the next",
     .source = "parallel/arithmetic/expansion.hpp",
     .families = "doubles of 120 octaves"}) {
  const auto e = *difference() * *difference(), f = *difference() * *difference();
  const auto sum = e + f, difference_of_both = e - f;
  RC_ASSERT(value(sum) == value(e) + value(f));
  RC_ASSERT(value(difference_of_both) == value(e) - value(f));
  RC_ASSERT(is_well_formed(sum));
  RC_ASSERT(is_well_formed(difference_of_both));
}

PARDEL_PROPERTY(Expansion, scaling_is_exact_and_well_formed,
                {.statement = "the terms of e b sum to the exact value; none is zero, none overlaps the next",
                 .source = "parallel/arithmetic/expansion.hpp",
                 .families = "doubles of 120 octaves"}) {
  const auto e = *difference() + *difference();
  const double b = *number();
  RC_ASSERT(value(e * b) == value(e) * Gmpq(b));
  RC_ASSERT(is_well_formed(e * b));
}

PARDEL_PROPERTY(Expansion, products_are_exact_and_well_formed,
                {.statement = "the terms of e f sum to the exact value; none is zero, none overlaps the next",
                 .source = "parallel/arithmetic/expansion.hpp",
                 .families = "doubles of 120 octaves"}) {
  const auto e = *difference() + *difference() * *difference();
  const auto f = *difference() * *difference() - *difference();
  RC_ASSERT(value(e * f) == value(e) * value(f));
  RC_ASSERT(is_well_formed(e * f));
}

PARDEL_PROPERTY(Expansion, the_estimate_has_the_sign_and_is_near,
                {.statement = "the estimate of an expansion has its sign and is off by at most 1e-15 of it",
                 .source = "parallel/arithmetic/expansion.hpp",
                 .families = "doubles of 120 octaves"}) {
  const auto e = *difference() * *difference() - *difference() * *difference();
  const Gmpq exact = value(e);
  RC_ASSERT(Gmpq(e.estimate()).sign() == exact.sign());
  RC_ASSERT(CGAL::abs(Gmpq(e.estimate()) - exact) <= CGAL::abs(exact) * Gmpq(1e-15));
}

PARDEL_PROPERTY(Expansion, what_cancels_leaves_no_term,
                {.statement = "e - e has no term, nor has any multiple of it",
                 .source = "parallel/arithmetic/expansion.hpp",
                 .families = "doubles of 120 octaves"}) {
  const auto e = *difference() * *difference();
  RC_ASSERT((e - e).size() == 0);
  RC_ASSERT((e - e).estimate() == 0);
  RC_ASSERT(((e - e) * *number()).size() == 0);
}

TEST(Expansion, of_an_integer_has_one_term) {
  const Expansion<2> three(two_sum(1, 2)), zero(two_sum(1, -1));
  EXPECT_EQ(three.size(), 1);
  EXPECT_EQ((three * three).size(), 1);
  EXPECT_EQ((three * three).estimate(), 9);
  EXPECT_EQ(zero.size(), 0);
  EXPECT_EQ((three * zero).size(), 0);
}

}  // namespace
}  // namespace pardel::engine::exact
