// Lattice: each cell of a phase is refined to the end by Ruppert's loop, which decides anew in each step. The cells of
// a phase do not see each other. So their order does not matter, and no point of a cell is ever handed on.
#include <algorithm>

#include "../../../ref/independent.hpp"
#include "../../checker/check.hpp"
#include "../framework/shares.hpp"
#include "refined_channels.hpp"
#include "turns.hpp"

namespace pardel::properties {
namespace {

/// The points that each cell inserted, in order.
std::map<ref::Cell, std::vector<ref::ExactPoint>> insertions_of_cells(const ref::Phase& phase) {
  std::map<ref::Cell, std::vector<ref::ExactPoint>> points;
  for (const auto& [cell, point] : phase.insertions) points[cell].push_back(point);
  return points;
}

PARDEL_PROPERTY(
    Lattice, cells_of_a_phase_refined_to_the_end_give_one_mesh_in_every_order,
    {.statement = "In a phase, each cell of its colour runs Ruppert's loop until it has nothing left to insert. Every "
                  "point is decided anew, from the mesh as it is then. The cells run one after the other in random "
                  "order, or random cells take each step, or all cells do. Each order gives the same mesh after each "
                  "phase, the same points of each cell in the same order, and the same midpoints handed on.",
     .source = "[CC], the uniform lattice; properties/THEORY.md, Lattice (e)",
     .families = channel_families}) {
  const RefinedChannel rounds = refined_channel(exhibit);
  classify_inner_cells(rounds.result);
  const auto seed = *rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()).as("seed of the order");
  const ref::Turns turns = *rc::gen::arbitrary<bool>() ? in_random_order(seed) : interleaved_at_random(seed);
  const ref::LatticeRefinement other = refined_in_turns(rounds.channel, turns);

  std::vector<const ref::Phase*> expected;
  for_each_phase(rounds.result, [&](const auto&, const ref::Phase& phase, const auto&) { expected.push_back(&phase); });
  std::size_t next = 0, cells_at_once = 0;
  for_each_phase(other, [&](const auto&, const ref::Phase& phase, const auto&) {
    RC_ASSERT(next < expected.size());
    const ref::Phase& same = *expected[next++];
    RC_ASSERT(triangles_as_points(phase.after) == triangles_as_points(same.after));
    RC_ASSERT(insertions_of_cells(phase) == insertions_of_cells(same));
    RC_ASSERT(phase.handed_on == same.handed_on);
    cells_at_once = std::max(cells_at_once, insertions_of_cells(phase).size());
  });
  RC_ASSERT(next == expected.size());
  classify(cells_at_once >= 2, "two or more cells insert points in a phase", 35);
}

PARDEL_PROPERTY(
    Lattice, no_cavity_of_a_cell_reaches_half_a_side_beyond_it,
    {.statement = "Refine each cell of a phase to the end. All vertices of the cavities of the points that a cell "
                  "inserts or rejects lie in the cell with a margin of half a side. So no circumcentre is handed on; "
                  "only midpoints of subsegments are, which lie in other cells than the points that encroach. The "
                  "checker certifies the mesh.",
     .source = "properties/THEORY.md, Lattice (c)",
     .families = channel_families}) {
  const Channel channel = some_channel(exhibit);
  const ref::LatticeRefinement refined = refined_in_turns(channel, ref::one_after_the_other);
  exhibit.show(to_pslg(channel), refined.mesh);
  classify_inner_cells(refined);
  bool is_near_the_margin = false, is_handed_on = false;
  for_each_phase(refined, [&](const LatticeSweep& sweep, const ref::Phase& phase, const auto&) {
    const auto& [corner, side] = sweep.cells;
    for (const auto& [cell, touched] : phase.touched)
      for (const ref::ExactPoint& v : touched.vertices) {
        const ref::Number x = CGAL::abs((v.x() - corner.x()) / side - static_cast<double>(cell.i) - 0.5),
                          y = CGAL::abs((v.y() - corner.y()) / side - static_cast<double>(cell.j) - 0.5);
        RC_ASSERT(std::max(x, y) < 1);
        is_near_the_margin |= std::max(x, y) > 0.75;
      }
    is_handed_on |= !phase.handed_on.empty();
  });
  classify(is_near_the_margin, "a cavity reaches a quarter of a side beyond its cell", 5);
  classify(is_handed_on, "a midpoint is handed on", 5);
  const Certificate certificate = check(to_pslg(channel), refined.mesh, goal_of(channel));
  if (!certificate.valid) RC_FAIL(certificate.violations.at(0).message());
  RC_ASSERT(certificate.justified.empty());
}

}  // namespace
}  // namespace pardel::properties
