// Finds the triangle in which a point lies: a tree whose branches divide the plane, and whose leaves list triangles.
//
// A branch is a grid, or a line (LocationSplit) where triangles are long and thin or where many meet at a vertex. A
// leaf lists all triangles that have points in its part of the plane, in ascending order. The first one that contains
// the point is the answer. So the answer needs nothing of the mesh but its triangles: no neighbours, no convexity.
#pragma once

#include <vector>

#include "../../core/array.hpp"
#include "../threads/threads.hpp"
#include "located_triangles.hpp"
#include "location_grid.hpp"
#include "location_split.hpp"

namespace pardel::engine {

/// Immutable, so several threads may use it at the same time. It keeps a view on the triangles.
class SearchTree {
 public:
  /// Flat triangles contain no point. O(n) on typical input, O(n log n) on others, on all threads. The tree does not
  /// depend on the number of threads. Throws an Error (resources) if there are too many triangles.
  explicit SearchTree(const LocatedTriangles& all, const Threads& threads = {});

  /// The first triangle that contains the point in its interior or on its boundary; no_index if there is none. Exact.
  /// A coordinate with a smaller magnitude than smallest_coordinate counts as 0. O(1) on typical input, O(log n) on
  /// most others.
  [[nodiscard]] Index first_around(Point p) const;
  [[nodiscard]] const LocatedTriangles& all() const { return all_; }
  /// Around all triangles.
  [[nodiscard]] const Box& bounds() const { return bounds_; }

 private:
  friend class TreeGrower;

  /// What a branch leads to: its upper two bits tell what it is.
  using Ref = Index;
  static constexpr unsigned tag_shift = 30;
  static constexpr Ref number_mask = (Ref{1} << tag_shift) - 1;
  enum Tag : Ref { list, grid, split, nothing };
  static constexpr Ref ref_to(Tag tag, std::size_t number) {
    return (Ref{tag} << tag_shift) | static_cast<Ref>(number);
  }
  static constexpr Index last_of_list = Index{1} << 31;  ///< a mark on the last triangle of a list

  struct SplitBranch {
    LocationSplit split;
    Ref parts[3] = {ref_to(nothing, 0), ref_to(nothing, 0), ref_to(nothing, 0)};  ///< by LocationSplit::Side
  };

  LocatedTriangles all_;
  Box bounds_ = empty_box;
  Ref root_ = ref_to(nothing, 0);
  std::vector<LocationGrid> grids_;
  std::vector<SplitBranch> splits_;
  Array<Ref> cells_;     ///< of all grids
  Array<Index> listed_;  ///< all lists
};

}  // namespace pardel::engine
