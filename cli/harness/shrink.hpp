// From a case that fails to a small one that fails in the same way.
#pragma once

#include <cstddef>
#include <functional>

#include "../../core/result.hpp"
#include "case.hpp"

namespace pardel::harness {

struct Shrunk {
  LatticeDomain domain;
  std::size_t runs = 0;   ///< of the mesher
  bool smallest = false;  ///< nothing simpler fails; false where the runs were used up
};

/// Takes the first simpler domain that fails, again and again, with at most max_runs calls of `fails`. An error of
/// `fails` ends it and is returned.
[[nodiscard]] Result<Shrunk> shrink(LatticeDomain domain, std::size_t max_runs,
                                    const std::function<Result<bool>(const LatticeDomain&)>& fails);

}  // namespace pardel::harness
