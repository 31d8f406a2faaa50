// The size function of a goal with Goal::grading and Goal::feature_edges.
#pragma once

#include <functional>

#include "../../core/goal.hpp"
#include "../threads/threads.hpp"

namespace pardel::engine {

/// True if the goal has one of the two bounds.
[[nodiscard]] bool is_graded(const Goal& goal);

/// Returns min(goal.size, the lengths that goal.grading and goal.feature_edges allow). Its target is
/// OnBackground<GradedValues> (local_bound.hpp). Preconditions: is_graded(goal); the Pslg is valid.
[[nodiscard]] std::function<double(Point)> graded_size(const Goal& goal, const Pslg& pslg, const Threads& threads);

}  // namespace pardel::engine
