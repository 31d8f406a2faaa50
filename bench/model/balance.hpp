// How evenly a division among ranks spreads the work of a traced run.
#pragma once

#include <span>
#include <vector>

#include "trace.hpp"

namespace pardel::bench {

/// The work of the rank with the most, divided by the mean over ranks; 1 if the work is even.
struct Balance {
  double promised = 0;  ///< of the work by which the mesh was divided
  double inserted = 0;  ///< of the vertices inserted
  double seconds = 0;   ///< of processor time
  /// The vertices that the slowest rank of each phase inserts, summed over phases, divided by the mean: ranks wait for
  /// each other after every phase.
  double phases = 0;
};

/// `work`: per cell, what the tiles are divided by.
[[nodiscard]] Balance balance(const Trace& trace, std::span<const double> work, int ranks);

/// Per cell: the number of vertices that its tasks inserted. A division by it is as even as a division by measured work
/// can be.
[[nodiscard]] std::vector<double> inserted_per_cell(const Trace& trace);

}  // namespace pardel::bench
