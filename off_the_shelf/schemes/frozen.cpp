#include "portions.hpp"
#include "schemes.hpp"

namespace pardel::engine {

void sweep_with_frozen_borders(MesherRun& run) {
  // Along a frozen edge that is much longer than the triangles wanted, a mesher leaves what would encroach upon it. The
  // next sweep takes these triangles and some rings around them, so that its own borders are short.
  constexpr int rings = 5;
  constexpr double largest_share_left = 0.7;
  repeat_sweeps(run, largest_share_left, [&](const ToSplit& to_split, unsigned number) {
    const std::vector<TriangleId> taken =
        number == 0 ? all_triangles(run.mesh.t) : with_rings(run.mesh.t, to_split.triangles, rings);
    show(run, run_tasks(run, divide_among_leaves(run, taken, to_split, number % 3)));
  });
}

}  // namespace pardel::engine
