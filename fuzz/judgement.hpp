// The judgement of a mesh: the exact checker finds nothing but bounds that may be missed, and the report lists the
// triangles that miss one, and no other triangles.
#pragma once

#include <functional>
#include <string>

#include "../core/goal.hpp"
#include "../core/pslg.hpp"
#include "../parallel/mesher.hpp"
#include "../parallel/sizes.hpp"

namespace pardel::fuzz {

/// What a mesh is compared with.
struct Expected {
  const Pslg& pslg;
  const Goal& goal;
  const Options& options;
  /// Bounds may be missed although the limit on vertices was not reached, in triangles that the report lists.
  bool may_miss = false;
  bool foreign = false;  ///< CheckOptions::foreign
  /// The longest edge that the mesher allows at a place, if this depends on the place. See allowed_size().
  std::function<double(Point)> longest_edge{};
  /// There are caps on the areas of triangles that are not known here, so any triangle may be listed.
  bool has_other_caps = false;
};

/// The first fault of the mesh or of its report, as one line; empty if there is none.
[[nodiscard]] std::string fault_of(const Meshed& meshed, const Expected& expected);

/// Refines a mesh, with a bound on the area of every second triangle, as `pardel mesh --refine` does with a file, and
/// judges the result against the domain of the mesh. Uses those bounds of the goal that refine() accepts.
[[nodiscard]] std::string fault_of_refining(Mesh coarse, const Goal& goal, const Options& options, bool may_miss);

}  // namespace pardel::fuzz
