// The paper's cells: what a task gets, and that no task needs more.
#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <set>

#include "../../off_the_shelf/own_mesher.hpp"
#include "../../off_the_shelf/schemes/schemes.hpp"
#include "../../parallel/triangulation/triangle_shape.hpp"
#include "some_part.hpp"

namespace pardel::engine {
namespace {

constexpr const char* cells_source = "[CC] Theorem 1; properties/THEORY.md, T1, Lattice and Quadtree";
constexpr const char* cells_families =
    "lattice domains of every family, with meshes of some hundred triangles, uniform or graded";

/// pardel's own refiner, and the points of each subdomain, by phase.
class RecordingMesher final : public SubdomainMesher {
 public:
  RecordingMesher(const MesherReport& report, const Triangulation& t) : report_(report), t_(t) {}
  [[nodiscard]] MesherAbilities abilities() const override { return own_->abilities(); }
  [[nodiscard]] RefinedSubdomain refine(const Subdomain& subdomain) override {
    {
      const std::scoped_lock lock(mutex_);
      auto& seen = points_[{report_.phases, subdomain.cell->low.x, subdomain.cell->low.y}];
      for (const Point p : subdomain.points) seen.emplace(p.x, p.y);
      lacks_triangles_ = lacks_triangles_ || lacks_triangle(*subdomain.cell, seen);
    }
    return own_->refine(subdomain);
  }

  /// True if a task lacked a triangle whose circumdisk meets its cell.
  [[nodiscard]] bool lacks_triangles() const { return lacks_triangles_; }
  /// True if two tasks of one phase had a point in common.
  [[nodiscard]] bool any_shared() const {
    std::set<std::tuple<std::uint32_t, double, double>> all;
    for (const auto& [task, points] : points_)
      for (const auto& [x, y] : points)
        if (!all.emplace(std::get<0>(task), x, y).second) return true;
    return false;
  }

 private:
  /// The mesh does not change while the tasks of a phase run.
  [[nodiscard]] bool lacks_triangle(const SubdomainCell& cell, const std::set<std::pair<double, double>>& seen) const {
    for (const Slot& slot : t_.slots) {
      const Shape shape(t_, slot);
      const Point p = shape.p[0];
      const Point to_centre = to_circumcentre({shape.p[1].x - p.x, shape.p[1].y - p.y},
                                              {shape.p[2].x - p.x, shape.p[2].y - p.y}, shape.twice_area);
      const Point centre{p.x + to_centre.x, p.y + to_centre.y};
      const double dx = centre.x - std::clamp(centre.x, cell.low.x, cell.high.x);
      const double dy = centre.y - std::clamp(centre.y, cell.low.y, cell.high.y);
      if (std::hypot(dx, dy) < (1 - 1e-9) * std::hypot(to_centre.x, to_centre.y))
        for (const Point corner : shape.p)
          if (!seen.contains({corner.x, corner.y})) return true;
    }
    return false;
  }

  const MesherReport& report_;
  const Triangulation& t_;
  bool lacks_triangles_ = false;
  std::mutex mutex_;
  std::map<std::tuple<std::uint32_t, double, double>, std::set<std::pair<double, double>>> points_;
  std::unique_ptr<SubdomainMesher> own_ = own_mesher();
};

struct CellsRun {
  std::unique_ptr<WorkedDomain> worked;
  MesherReport report;
  bool any_shared = false, lacks_triangles = false;
};

/// Sweeps over cells on a mesh that is refined already, but for a goal with twice the lengths.
CellsRun some_run_over_cells(properties::Exhibit& exhibit) {
  properties::Problem problem = properties::some_problem(exhibit);
  const double extent = properties::extent_of(problem.pslg);
  Goal coarse{.min_angle_deg = *rc::gen::element(0.0, 0.0, 20.0)}, goal{.min_angle_deg = problem.goal.min_angle_deg};
  if (*rc::gen::arbitrary<bool>()) {
    goal.max_area = extent * extent / *rc::gen::inRange(400, 1500);
    coarse.max_area = 4 * goal.max_area;
  } else {
    const Point centre = problem.pslg.points[*rc::gen::inRange<std::size_t>(0, problem.pslg.points.size())];
    const double least = extent / *rc::gen::inRange(40, 400), slope = 0.1 * *rc::gen::inRange(1, 20);
    goal.size = [=](Point p) { return least + slope * std::hypot(p.x - centre.x, p.y - centre.y); };
    coarse.size = [size = goal.size](Point p) { return 2 * size(p); };
  }
  CellsRun result{std::make_unique<WorkedDomain>(std::move(problem.pslg), coarse, goal), {}};
  RecordingMesher mesher(result.report, result.worked->domain().triangulation);
  const MesherOptions how{.scheme = Scheme::cells, .triangles_per_task = *rc::gen::element(10U, 40U)};
  const std::vector<double> no_caps;
  const Watcher no_watcher;
  MesherCaller caller(mesher, mesher.abilities());
  MesherRun run{result.worked->mesh(),
                result.worked->goal(),
                result.worked->criteria(),
                result.worked->options(),
                how,
                no_caps,
                caller,
                nullptr,
                Threads(*rc::gen::inRange(1, 4)),
                result.report,
                no_watcher};
  sweep_over_cells(run);
  result.any_shared = mesher.any_shared();
  result.lacks_triangles = mesher.lacks_triangles();
  RC_TAG(result.report.phases > 3 ? "four phases and more" : "fewer phases");
  return result;
}

PARDEL_PROPERTY(Cells, need_no_flip,
                {.statement = "All edges between cells are Delaunay when the answers of a phase are glued in: all "
                              "triangles that an insertion in a cell can change belong to the task of the cell.",
                 .source = cells_source,
                 .families = cells_families}) {
  const CellsRun run = some_run_over_cells(exhibit);
  RC_ASSERT(run.report.breaches.total() == 0U);
  RC_ASSERT(run.report.flipped == 0U);
  exhibit.show(run.worked->pslg(), run.worked->exported());
  properties::require_valid(check(run.worked->pslg(), run.worked->exported(), {.min_angle_deg = 0}));
}

PARDEL_PROPERTY(Cells, of_one_colour_share_no_vertex,
                {.statement = "No two tasks of a phase have a vertex in common.",
                 .source = cells_source,
                 .families = cells_families}) {
  RC_ASSERT(!some_run_over_cells(exhibit).any_shared);
}

PARDEL_PROPERTY(Cells, get_every_triangle_that_an_insertion_can_change,
                {.statement = "A task gets all triangles whose circumdisks meet its cell; a cell for which they do not "
                              "fit its box has no task.",
                 .source = cells_source,
                 .families = cells_families}) {
  RC_ASSERT(!some_run_over_cells(exhibit).lacks_triangles);
}

}  // namespace
}  // namespace pardel::engine
