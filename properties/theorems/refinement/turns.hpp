// Random turns: which cells of a phase of the reference take the next step.
#pragma once

#include <optional>
#include <vector>

#include "../../../ref/decomposition/turns.hpp"
#include "../../domains/generators/random.hpp"

namespace pardel::properties {

/// One cell after the other is refined to the end, in random order.
[[nodiscard]] inline ref::Turns in_random_order(std::uint64_t seed) {
  return [random = generators::Random(seed),
          at_work = std::optional<ref::Cell>()](const std::set<ref::Cell>& unfinished) mutable -> std::set<ref::Cell> {
    if (!at_work || !unfinished.contains(*at_work))
      at_work = random.one_of(std::vector<ref::Cell>(unfinished.begin(), unfinished.end()));
    return {*at_work};
  };
}

/// In each step, any of the cells work.
[[nodiscard]] inline ref::Turns interleaved_at_random(std::uint64_t seed) {
  return [random = generators::Random(seed)](const std::set<ref::Cell>& unfinished) mutable {
    std::vector<ref::Cell> cells(unfinished.begin(), unfinished.end());
    random.shuffle(cells);
    cells.resize(1 + random.below(cells.size()));
    return std::set<ref::Cell>(cells.begin(), cells.end());
  };
}

}  // namespace pardel::properties
