#include "quadtree.hpp"

#include <algorithm>

#include "cells/circumradius.hpp"
#include "cells/quadtree_cells.hpp"
#include "mesh/triangle.hpp"

namespace pardel::schemes {
namespace {

/// The least leaf that a triangle with this circumradius permits is expected to get so many triangles.
double least_share(const LinkedMesh& mesh, Index t, const Bounds& bounds, double fraction) {
  const double side = cells::circumradius(mesh, t) / fraction;
  return side * side / bounds.wanted_area(centroid(mesh, t), mesh.faces[t].region);
}

/// Triangles of the wanted size permit no leaf with fewer triangles.
constexpr double least_leaf = 24;

/// The tree is made anew when the mesh has grown by this share.
constexpr double growth = 0.25;

}  // namespace

Result<Outcome> quadtree(const Problem& problem, const QuadtreeOptions& options) {
  Result<Start> start = start_of(problem);
  if (!start) return start.error();
  cells::Refinement r{problem, std::move(*start), options.turns, options.watch};
  LinkedMesh& mesh = r.start.mesh;
  const Bounds& bounds = r.start.bounds;
  const double wanted =
      options.cells > 0 ? options.cells : static_cast<double>(options.cells_per_worker) * problem.workers;
  double all = 0;
  for (Index t = 0; t < mesh.faces.size(); ++t) all += cells::expected_triangles(mesh, t, bounds);
  // The preprocessing refines the triangles that are too large for leaves with a fair share of the work.
  const double most = std::max(least_leaf, all / wanted);
  const std::uint64_t work = refine_where(
      mesh, bounds, all_triangles(mesh), [&](Index t) { return least_share(mesh, t, bounds, options.fraction) > most; },
      problem.most_points);
  r.start.account.sequential += work;
  r.start.account.critical += work;

  const Territory territory(mesh, bounds, problem.workers);
  cells::assess_all(r);
  const auto divide = [&] {
    return cells::quadtree_cells(mesh, bounds, wanted, options.fraction, options.assignment, territory);
  };
  const cells::Division last = cells::sweep_to_fixpoint(r, divide, growth);
  r.start.account.most_held = cells::most_held(mesh, last, problem.workers);
  return cells::outcome_of(std::move(r));
}

}  // namespace pardel::schemes
