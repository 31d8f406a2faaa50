// The input of pardel triangle, as Triangle's switches select it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "input.hpp"
#include "triangle_switches.hpp"

namespace pardel::cli {

/// The input: a valid domain, or with r a mesh.
struct TriangleInput {
  Source source;
  std::optional<Pslg> original;  ///< the domain as read, if it had to be repaired
  std::vector<Index> point_map;  ///< if repaired: maps points of the original to points of the domain
  bool node_was_read = true;     ///< the points come from a .node, not from the .poly
  std::vector<Point> holes;      ///< the holes of the .poly, also if the switch O ignores them
  std::vector<Region> regions;   ///< the regions of the .poly, if the switches A and a use them

  [[nodiscard]] const Pslg& pslg() const { return pslg_of(source); }
};

/// Reads the files. Triangle accepts coinciding points and crossing segments, so this function repairs an invalid
/// domain. It prints the names of the files and the repairs, unless the switch Q is set.
[[nodiscard]] Result<TriangleInput> read_triangle_input(const TriangleSwitches& switches);

}  // namespace pardel::cli
