// What a random case has of many independent features. They are drawn at random and by pairs, because mistakes hide
// where two of them meet.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "random.hpp"

namespace pardel::generators {

/// Some of the n values of an enumeration, and a seed for what belongs to them. A function name(Enum) names the values.
template <class Enum, std::size_t n>
struct Switches {
  std::bitset<n> on;
  std::uint64_t seed = 0;

  [[nodiscard]] bool has(Enum one) const { return on[static_cast<std::size_t>(one)]; }
  friend bool operator==(const Switches&, const Switches&) = default;
};

/// None in one of four cases; two in one of four; otherwise each with a probability of 1/2. So each pair occurs in at
/// least one of eight cases.
template <class Drawn>
[[nodiscard]] Drawn any_switches(Random& random) {
  Drawn drawn{{}, random.next()};
  const std::size_t kind = random.below(4), n = drawn.on.size();
  if (kind == 1)
    while (drawn.on.count() < 2) drawn.on.set(random.below(n));
  if (kind >= 2)
    for (std::size_t i = 0; i < n; ++i) drawn.on[i] = random.chance(2);
  return drawn;
}

/// The same without one of them, for each of them.
template <class Enum, std::size_t n>
[[nodiscard]] std::vector<Switches<Enum, n>> shrinks(const Switches<Enum, n>& switches) {
  std::vector<Switches<Enum, n>> fewer;
  for (std::size_t i = 0; i < n; ++i)
    if (switches.on[i]) fewer.emplace_back(switches).on.reset(i);
  return fewer;
}

/// The names, separated by commas, and the seed. Empty if nothing is on.
template <class Enum, std::size_t n>
[[nodiscard]] std::string to_string(const Switches<Enum, n>& switches) {
  std::string text;
  for (std::size_t i = 0; i < n; ++i)
    if (switches.on[i]) text += (text.empty() ? "" : ", ") + std::string(name(static_cast<Enum>(i)));
  return text.empty() ? text : text + " of seed " + std::to_string(switches.seed);
}

}  // namespace pardel::generators
