// The interpolation of attributes of points that are divided among ranks.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "../delaunay/curve_division.hpp"
#include "../distributed.hpp"
#include "kept_by_readers.hpp"
#include "part_of_domain.hpp"

namespace pardel::engine {

/// The triangles of a domain before its refinement, as a Background for the vertices that are inserted. Each rank has
/// those that may contain a place that it owns by the division of the points.
class DividedBackground {
 public:
  /// Collective. `part` has not been refined yet. `division` has to outlive the object.
  DividedBackground(const PartOfDomain& part, const CurveDivision& division, Ranks& ranks, const Threads& threads);

  /// Gives the vertices of a piece their attributes, with the values that one process gives them. Uses up the
  /// triangles. Collective. O(n log n) for n points and vertices of this rank.
  void add_attributes(MeshPiece& piece, const KeptDomain& kept, Ranks& ranks) &&;

 private:
  void add_triangles_at_home(const PartOfDomain& part, Ranks& ranks);
  static void add_along_segments(Mesh& mesh, const KeptDomain& kept, Ranks& ranks);
  void add_points_of(const PartOfDomain& part, Ranks& ranks);

  const CurveDivision& division_;
  Threads threads_;
  std::uint64_t inputs_;  ///< the number of points of all ranks
  std::vector<Point> points_;
  std::vector<std::uint64_t> number_;  ///< of the points, in the input
  std::vector<std::array<Index, 3>> triangles_;
};

}  // namespace pardel::engine
