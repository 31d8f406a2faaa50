// Makes a RapidCheck generator from a function that generates a value and a function that shrinks it.
#pragma once

#include <rapidcheck.h>

#include "../../domains/generators/goals.hpp"
#include "../../domains/generators/lattice_domain.hpp"
#include "../../domains/generators/random.hpp"

namespace pardel::generators {

/// `make(Random&, int size)` makes a value; sizes are 0 to 100, and larger sizes make larger values. `shrinks(value)`
/// lists simpler values, the simplest first. Both must be pure functions.
template <class Make, class Shrinks>
[[nodiscard]] auto generator(Make make, Shrinks shrinks) {
  using Value = decltype(make(std::declval<Random&>(), 0));
  return rc::Gen<Value>([make, shrinks](const rc::Random& random, int size) {
    rc::Random source = random;
    Random mine(source.next());
    return rc::shrinkable::shrinkRecur(
        make(mine, size), [shrinks](const Value& value) { return rc::seq::fromContainer(shrinks(value)); });
  });
}

inline constexpr auto shrinks_of = [](const auto& value) { return shrinks(value); };

/// Valid domains; all families are equally likely.
[[nodiscard]] inline auto domains() { return generator(any_domain, shrinks_of); }
/// Valid domains of one family. Shrunk domains may lose the trait of the family.
[[nodiscard]] inline auto domains(Family family) {
  return generator([family](Random& random, int size) { return generate(family, random, size); }, shrinks_of);
}
/// Valid domains of all families, each with a goal.
[[nodiscard]] inline auto cases() { return generator(any_case, shrinks_of); }

}  // namespace pardel::generators
