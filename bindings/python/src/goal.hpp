// The bounds of a call from Python: a Goal, and lengths that depend on the place.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <pardel/core/goal.hpp>
#include <pardel/core/raster.hpp>
#include <pardel/parallel/options.hpp>
#include <pardel/parallel/validate.hpp>
#include <vector>

#include "held_mesh.hpp"
#include "places.hpp"
#include "size_function.hpp"

namespace pardel::python {

/// Where lengths are given: nowhere; at the points of the domain; at the points of another mesh; by a function; on a
/// raster. And places from which lengths grow, or none.
struct Sizes {
  std::vector<double> lengths{};  ///< one per point
  std::shared_ptr<HeldMesh> mesh{};
  pybind11::object function{};
  Takes takes = Takes::arrays;
  std::shared_ptr<const Raster> raster{};
  std::shared_ptr<const Places> places{};
};

/// The function of the sizes, if they have one. Call it with the interpreter lock.
[[nodiscard]] std::unique_ptr<SizeFunction> function_of(const Sizes& sizes, Call& call, bool is_asked_by_one_thread);

/// The goal with these sizes. Without the interpreter lock. `domain`: null if the sizes are not at its points.
/// Throws Failure. `function`: that of the sizes, or null; it has to outlive the goal.
[[nodiscard]] Goal with_sizes(Goal goal, const Sizes& sizes, SizeFunction* function, const ValidPslg* domain,
                              const Options& options);

}  // namespace pardel::python
