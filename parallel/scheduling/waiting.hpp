// Triangles that wait, on their way between the parts of a refinement.
#pragma once

#include <vector>

#include "../refinement/deferral.hpp"

namespace pardel::engine {

/// Triangles that wait on this rank: for the next pass, and for a larger box.
struct Waiting {
  std::vector<Deferred> deferred;
  std::vector<QueuedTriangle> needing_larger_box;
};

}  // namespace pardel::engine
