// Options of the checker.
#pragma once

#include <cstddef>
#include <functional>

namespace pardel {

struct CheckOptions {
  /// How many violations of each kind the certificate lists. All are counted.
  std::size_t max_violations = 1'000;
  /// An upper bound on circumradii, in the unit of the coordinates; compared exactly. A value that is
  /// zero, negative, NaN or infinite means: no bound.
  double max_circumradius = 0;
  /// The mesh comes from a file or from another program. Then input points are matched with vertices by equal
  /// coordinates, unless the vertices begin with the input points in their order. The arrays that
  /// files may lack (`origin`, `region`, `point_markers`, `point_attributes` with attributes_per_point 0, neighbours,
  /// `constrained_edges`) may be empty as a whole: the checker skips the rules about them. If they are not empty, they
  /// must have their full length. Attributes are skipped, too, if the input has none. False: a mesh of this mesher.
  /// Then `origin` is always required, `region` if the input has regions, `point_markers` if it has point markers,
  /// attributes if it has attributes.
  bool foreign = false;
  /// Called in the calling thread from time to time, about every 4 ms. Return false to end the check at once. The
  /// certificate is then `cancelled`.
  std::function<bool()> go_on{};
};

}  // namespace pardel
