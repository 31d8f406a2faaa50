// Random numbers for the cases of a run, which are counted.
#pragma once

#include <cstdint>

#include "../properties/domains/generators/random.hpp"

namespace pardel::fuzz {

/// The sequence of a case depends on the seed and its number only. Neighbouring numbers have unrelated sequences: the
/// state is made of one step from each of the two.
[[nodiscard]] inline generators::Random random_of(std::uint64_t seed, std::uint64_t number) {
  return generators::Random(generators::Random(seed).next() ^ generators::Random(~number).next());
}

}  // namespace pardel::fuzz
