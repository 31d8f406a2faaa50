// repair() makes a valid Pslg where the problem is one of topology: duplicates, crossings, points on segments.
#pragma once

#include <string>
#include <vector>

#include "../core/pslg.hpp"
#include "../core/result.hpp"

namespace pardel {

struct Repaired {
  Pslg pslg;
  std::vector<Index> point_map;    ///< old point -> new point
  std::vector<Index> segment_map;  ///< new segment -> old segment it is a part of (the first, where they overlap)
  std::vector<std::string> log;    ///< what was done, a line each; ids are those of the old Pslg, from `base` on
};

/// Merges equal points (and those closer than `snap`), drops zero-length and duplicate segments, splits
/// crossing and overlapping segments and segments with points in their interior, and drops holes and
/// regions that lie outside or on a segment. Crossing points are rounded, so splitting repeats until
/// validate() finds nothing; fails where it does not converge, where coordinates are unusable, or where
/// nothing encloses a domain. `base` is what the log and the messages of errors call the first of everything.
[[nodiscard]] Result<Repaired> repair(const Pslg& pslg, double snap = 0, int base = 0);

}  // namespace pardel
