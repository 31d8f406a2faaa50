// The orders in which the cells of a phase may work. Threads work in an order that nobody knows in advance; the
// reference tries several.
#pragma once

#include <functional>
#include <set>

#include "cell.hpp"

namespace pardel::ref {

/// Given the cells of a phase that have not finished, chooses those that take the next step, at least one. In a step,
/// each of them inserts one point; all cavities are found in the same mesh.
using Turns = std::function<std::set<Cell>(const std::set<Cell>& unfinished)>;

/// Each cell inserts one point in each step.
[[nodiscard]] inline std::set<Cell> in_rounds(const std::set<Cell>& unfinished) { return unfinished; }

/// One cell is refined to the end, then the next.
[[nodiscard]] inline std::set<Cell> one_after_the_other(const std::set<Cell>& unfinished) {
  return {*unfinished.begin()};
}

}  // namespace pardel::ref
