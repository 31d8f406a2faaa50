// Divides triangles among the tasks of a phase.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "../../parallel/arithmetic/box.hpp"
#include "../subdomains/run_tasks.hpp"

namespace pardel::engine {

/// The triangles that break the goal and may be split, and those with an encroached side.
struct ToSplit {
  std::vector<TriangleId> triangles;  ///< ascending
  std::vector<double> work;           ///< for each of them, about how many triangles will replace it
};
[[nodiscard]] ToSplit triangles_to_split(const MesherRun& run);

/// Repeats sweep(to_split, number), number = 0, 1, ..., as often as the options of the run allow. Ends when nothing has
/// to be split, or when a sweep leaves more than this share of the work: then it achieves little. After breaches of the
/// contract, one such sweep is repeated.
void repeat_sweeps(MesherRun& run, double largest_share_left,
                   const std::function<void(const ToSplit&, unsigned)>& sweep);

/// All triangles of the mesh, ascending.
[[nodiscard]] std::vector<TriangleId> all_triangles(const Triangulation& t);

/// These triangles, and those that are reached from them across at most `rings` edges, ascending.
[[nodiscard]] std::vector<TriangleId> with_rings(const Triangulation& t, std::span<const TriangleId> triangles,
                                                 int rings);

/// Divides triangles among the leaves of a quadtree, by their centroids. A leaf is divided until the work in it is at
/// most run.how.triangles_per_task. Only leaves with a triangle to split become portions. The tree of each shift, 0 to
/// 2, is moved by a third of its side: a place on the border of a leaf is at least a third of a leaf away from all
/// borders of the next tree. `triangles`, `to_split`: ascending; to_split is a part of triangles.
[[nodiscard]] Portions divide_among_leaves(const MesherRun& run, std::span<const TriangleId> triangles,
                                           const ToSplit& to_split, unsigned shift);

/// The least box around all triangles.
[[nodiscard]] Box bounds_of(const Triangulation& t, const Threads& threads);

}  // namespace pardel::engine
