// Lattice: the engine's decomposition `paper`, compared with the reference, in which each cell is refined to the end.
#include <algorithm>
#include <limits>
#include <vector>

#include "../framework/shares.hpp"
#include "meshing.hpp"
#include "refined_channels.hpp"

namespace pardel::properties {
namespace {

double largest_circumradius(const Mesh& mesh) {
  return std::sqrt(CGAL::to_double(squared_circumradius_bound(ref::to_plain_mesh(mesh))));
}

/// The shorter side of the cells of a sweep, in a direction in which there are several; infinite for one cell.
double side_of_cells(const Tiling& tiling, const Sweep& sweep) {
  constexpr double none = std::numeric_limits<double>::infinity();
  return std::min(sweep.columns > 1 ? (tiling.high.x - tiling.low.x) / sweep.columns : none,
                  sweep.rows > 1 ? (tiling.high.y - tiling.low.y) / sweep.rows : none);
}

PARDEL_PROPERTY(
    EngineAgainstReference, on_the_papers_lattice_neither_hands_on_a_circumcentre,
    {.statement = "Refine a domain on the paper's lattice with the engine, and with the reference, which refines each "
                  "cell of a phase to the end. If all circumradii are at most a quarter of the side of a cell before "
                  "and after a sweep of the engine, it hands no triangle on to a larger box: no cavity of a point of a "
                  "cell leaves the box of the cell. Both meshes are certified without exempt triangles. The engine "
                  "makes at most twice as many triangles as the reference, and the reference at most 1.5 times as many "
                  "as the engine. (The most in 4,000 cases: 1.74 and 1.4 times.)",
     .source = "[CC], the uniform lattice; properties/THEORY.md, Lattice (c)",
     .families = "channels; meshes of 24 triangles or more"}) {
  const Channel channel = some_channel(exhibit);
  const Pslg pslg = to_pslg(channel);
  const Goal goal = goal_of(channel);
  const ref::LatticeRefinement reference = refined_in_turns(channel, ref::one_after_the_other);
  std::vector<double> radii;  // the largest after each sweep
  Options options{.placement = Placement::circumcentre,
                  .threads = 1,
                  .decomposition = Decomposition::paper,
                  .triangles_per_tile = 1};
  options.after_sweep = [&](const Mesh& after, const Sweep&) {
    radii.push_back(largest_circumradius(after));
    return Status(Done{});
  };
  const Meshed engine = value_of(mesh(pslg, goal, options));
  exhibit.show(pslg, engine.mesh);
  const std::vector<Sweep>& sweeps = engine.report.tiling.sweeps;
  RC_ASSERT(radii.size() == sweeps.size());
  Index judged = 0;  // the cells of the largest lattice whose circumradii were small
  bool is_square = false;
  for (std::size_t k = 1; k < sweeps.size(); ++k) {
    if (4 * std::max(radii[k - 1], radii[k]) > side_of_cells(engine.report.tiling, sweeps[k])) continue;
    RC_ASSERT(sweeps[k].beyond_box == 0U);
    if (sweeps[k].inserted == 0) continue;
    judged = std::max(judged, sweeps[k].columns * sweeps[k].rows);
    is_square |= sweeps[k].columns >= 3 && sweeps[k].rows >= 3;
  }
  for (const Mesh& result : {engine.mesh, reference.mesh}) {
    const Certificate certificate = check(pslg, result, goal);
    require_valid(certificate);
    RC_ASSERT(certificate.justified.empty());
  }
  const std::size_t ours = engine.mesh.triangles.size(), theirs = reference.mesh.triangles.size();
  RC_PRE(theirs >= 24U);
  RC_ASSERT(ours <= 2 * theirs);
  RC_ASSERT(2 * theirs <= 3 * ours);
  classify(judged >= 4, "circumradii allow the cells of a sweep with four cells or more that inserts points", 10);
  classify(is_square, "the same, with three by three cells or more", 1);
}

}  // namespace
}  // namespace pardel::properties
