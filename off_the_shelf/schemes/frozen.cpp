#include <numeric>

#include "portions.hpp"
#include "schemes.hpp"

namespace pardel::engine {

void sweep_with_frozen_borders(MesherRun& run) {
  // Along a frozen edge that is much longer than the triangles wanted, a mesher leaves what would encroach upon it. The
  // next sweep takes these triangles and some rings around them, so that its own borders are short.
  constexpr int rings = 5;
  // A sweep that leaves more than this share of the work achieves little.
  constexpr double good_progress = 0.7;
  double before = INFINITY;
  for (std::uint32_t sweep = 0; sweep < run.how.most_sweeps; ++sweep) {
    run.threads.ask();
    const std::vector<TriangleId> to_split = triangles_to_split(run);
    const double left = work_on(run, to_split);
    if (to_split.empty() || left > good_progress * before) return;
    before = left;
    std::vector<TriangleId> taken;
    if (sweep == 0) {
      taken.resize(run.mesh.t.slots.size());
      std::iota(taken.begin(), taken.end(), TriangleId{0});
    } else {
      taken = with_rings(run.mesh.t, to_split, rings);
    }
    const Portions portions = divide_among_leaves(run, taken, to_split, sweep % 3);
    ++run.report.sweeps;
    const std::uint64_t made = run_tasks(run, portions.all, portions.portion_of);
    show(run, made);
    if (made == 0 && sweep > 0) return;
  }
}

}  // namespace pardel::engine
