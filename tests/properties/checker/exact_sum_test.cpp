// ExactSum is compared with rational arithmetic.
#include "../../../properties/checker/arithmetic/exact_sum.hpp"

#include <CGAL/Gmpq.h>

#include <cmath>

#include "../../../properties/domains/generators/random.hpp"
#include "../../../properties/theorems/framework/property.hpp"

namespace pardel::checker {
namespace {

PARDEL_PROPERTY(ExactSum, agrees_with_rational_arithmetic_at_all_magnitudes,
                {.statement = "a sum of products has the sign that rational arithmetic gives, and its rounded value is "
                              "off by at most 2^-50 of it",
                 .source = "properties/checker/arithmetic/exact_sum.hpp",
                 .families = "doubles of 600 octaves"}) {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  generators::Random random(seed);
  ExactSum sum;
  CGAL::Gmpq expected(0);
  for (int i = 0; i < 20; ++i) {
    const auto number = [&] {
      const auto mantissa = static_cast<double>(static_cast<std::int64_t>(random.next()));
      return std::ldexp(mantissa, random.between(-300, 299));
    };
    const double x = number(), y = number();
    if (random.chance(2)) {
      sum.add_product(x, y);
      expected += CGAL::Gmpq(x) * CGAL::Gmpq(y);
    } else {
      sum.subtract_product(x, y);
      expected -= CGAL::Gmpq(x) * CGAL::Gmpq(y);
    }
  }
  RC_ASSERT(sum.sign() == static_cast<int>(CGAL::sign(expected)));
  const double rounded = CGAL::to_double(expected);
  RC_ASSERT(std::abs(sum.rounded() - rounded) <= 0x1p-50 * std::abs(rounded));
}

}  // namespace
}  // namespace pardel::checker
