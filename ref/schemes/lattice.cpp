#include "lattice.hpp"

#include <cmath>

#include "cells/circumradius.hpp"
#include "cells/uniform_cells.hpp"
#include "mesh/extent.hpp"

namespace pardel::schemes {
namespace {

double radii_per_side(CellSide side) { return side == CellSide::four_radii ? 4 : 2; }

}  // namespace

cells::Division lattice_over(const LinkedMesh& mesh, double radius, double radii_per_side, cells::Assignment assignment,
                             const Territory& territory) {
  // A side that is a little longer makes up for the rounding of the cells' borders.
  const double side = radii_per_side * radius * (1 + cells::rounding);
  cells::Division division = cells::uniform_cells(extent_of(mesh.points), side, assignment, territory);
  if (division.colour.size() > 1)
    division.allows = [=](Point, double r) { return radii_per_side * r * (1 + cells::rounding) <= side; };
  return division;
}

Result<Outcome> lattice(const Problem& problem, const LatticeOptions& options) {
  Result<Start> start = start_of(problem);
  if (!start) return start.error();
  cells::Refinement r{problem, std::move(*start), options.turns, options.watch};
  LinkedMesh& mesh = r.start.mesh;
  const Extent extent = extent_of(mesh.points);
  const double radii = radii_per_side(options.side);
  const double wanted =
      options.cells > 0 ? options.cells : static_cast<double>(options.cells_per_worker) * problem.workers;
  const double target = std::sqrt(extent.width() * extent.height() / wanted) / radii;
  // The preprocessing [CC] has a coarser goal; here it is the goal for triangles with large circumdisks.
  const std::uint64_t work = refine_where(
      mesh, r.start.bounds, all_triangles(mesh), [&](Index t) { return cells::circumradius(mesh, t) > target; },
      problem.most_points);
  r.start.account.sequential += work;
  r.start.account.critical += work;

  const Territory territory(mesh, r.start.bounds, problem.workers);
  cells::assess_all(r);
  const auto divide = [&] {
    return lattice_over(mesh, cells::largest_circumradius(mesh), radii, options.assignment, territory);
  };
  const cells::Division last = cells::sweep_to_fixpoint(r, divide, INFINITY);
  r.start.account.most_held = cells::most_held(mesh, last, problem.workers);
  return cells::outcome_of(std::move(r));
}

}  // namespace pardel::schemes
