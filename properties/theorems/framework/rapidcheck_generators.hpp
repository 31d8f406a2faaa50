// From a plain generator and a plain shrinker to what RapidCheck wants.
#pragma once

#include <rapidcheck.h>

#include "../../domains/generators/goals.hpp"
#include "../../domains/generators/lattice_domain.hpp"
#include "../../domains/generators/random.hpp"

namespace pardel::generators {

/// `make(Random&, int size)` makes a value, larger ones for larger sizes (0 to 100); `shrinks(value)` lists simpler
/// ones, the simplest first. Both must be pure.
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

/// Valid domains of all families, evenly.
[[nodiscard]] inline auto domains() { return generator(any_domain, shrinks_of); }
/// Valid domains with this family's trait; shrinking may lose it.
[[nodiscard]] inline auto domains(Family family) {
  return generator([family](Random& random, int size) { return generate(family, random, size); }, shrinks_of);
}
/// Domains of all families with goals.
[[nodiscard]] inline auto cases() { return generator(any_case, shrinks_of); }

}  // namespace pardel::generators
