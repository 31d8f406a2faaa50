#include "region_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cells/circumradius.hpp"
#include "cells/uniform_cells.hpp"
#include "mesh/extent.hpp"

namespace pardel::schemes {
namespace {

/// The levels: cells of level k have the side width / 2^k.
struct Levels {
  double width;
  int finest;
  double radii_per_side;

  [[nodiscard]] double side(int level) const { return std::ldexp(width, -level); }
  /// The level on which t is due.
  [[nodiscard]] int of(const LinkedMesh& mesh, Index t) const {
    const double needed = radii_per_side * cells::circumradius(mesh, t);
    int level = finest;
    while (level > 0 && !(side(level) >= needed)) --level;
    return level;
  }
};

/// Moves the entries that are due on the level, or have left boxes of a finer one, to `waiting`.
void take(cells::Refinement& r, const Levels& levels, int level, std::vector<std::vector<cells::Waiting>>& left_box) {
  r.waiting = std::exchange(left_box[static_cast<std::size_t>(level)], {});
  std::erase_if(r.later, [&](const cells::Waiting& w) {
    if (!is_current(r.start.mesh, w)) return true;
    if (levels.of(r.start.mesh, w.triangle) != level) return false;
    r.waiting.push_back(w);
    return true;
  });
}

}  // namespace

Result<Outcome> region_boxes(const Problem& problem, const RegionBoxesOptions& options) {
  Result<Start> start = start_of(problem);
  if (!start) return start.error();
  cells::Refinement r{problem, std::move(*start), options.turns, options.watch};
  LinkedMesh& mesh = r.start.mesh;
  const Extent extent = extent_of(mesh.points);
  const double wanted =
      options.cells > 0 ? options.cells : static_cast<double>(options.cells_per_worker) * problem.workers;
  const Levels levels{extent.side(), std::max(0, static_cast<int>(std::ceil(std::log2(wanted) / 2))),
                      options.radii_per_side};
  const Territory territory(mesh, r.start.bounds, problem.workers);
  const auto division_of = [&](int level) {
    // On level 0, one cell is all of the plane.
    const double side = level == 0 ? INFINITY : levels.side(level);
    cells::Division division = cells::uniform_cells(extent, side, options.assignment, territory);
    division.owns_box = true;
    division.is_due = [&levels, level](const LinkedMesh& m, Index t) { return levels.of(m, t) == level; };
    return division;
  };

  cells::assess_all(r);
  r.later = std::exchange(r.waiting, {});
  std::vector<std::vector<cells::Waiting>> left_box(static_cast<std::size_t>(levels.finest) + 1);
  const auto is_over = [&] {
    return r.later.empty() && std::ranges::all_of(left_box, [](auto& l) { return l.empty(); });
  };
  do {
    for (int level = 0; level <= levels.finest; ++level) {
      take(r, levels, level, left_box);
      if (r.waiting.empty()) continue;
      cells::sweep_to_fixpoint(
          r, [&] { return division_of(level); }, INFINITY);
      for (const cells::Waiting& w : std::exchange(r.left_box, {}))
        left_box[static_cast<std::size_t>(std::max(level - 1, 0))].push_back(w);
    }
  } while (!is_over() && mesh.points.size() <= problem.most_points);
  r.start.account.most_held = cells::most_held(mesh, division_of(levels.finest), problem.workers);
  return cells::outcome_of(std::move(r));
}

}  // namespace pardel::schemes
