// Shrinks a case that fails to a small case that fails in the same way.
#pragma once

#include <cstddef>
#include <functional>

#include "../../core/result.hpp"
#include "case.hpp"

namespace pardel::harness {

struct Shrunk {
  LatticeDomain domain;
  std::size_t runs = 0;   ///< how many times the mesher ran
  bool smallest = false;  ///< no simpler domain fails; false if the runs were used up
};

/// Replaces the domain by the first of its simpler domains that fails, and repeats this until no simpler domain fails
/// or `fails` was called max_runs times. If `fails` returns an error, shrink() returns this error.
[[nodiscard]] Result<Shrunk> shrink(LatticeDomain domain, std::size_t max_runs,
                                    const std::function<Result<bool>(const LatticeDomain&)>& fails);

}  // namespace pardel::harness
