// A random part of the mesh of a random domain, as a task gets it.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "../../off_the_shelf/subdomains/part.hpp"
#include "../../parallel/construction/domain_triangulation.hpp"
#include "../../parallel/scheduling/refine_by_sweeps.hpp"
#include "../../parallel/scheduling/refine_domain.hpp"
#include "../../properties/theorems/refinement/meshing.hpp"

namespace pardel::engine {

/// A mesh in work, and all that its tasks refer to. It stays where it is.
class WorkedDomain {
 public:
  /// The mesh is refined for `coarse`, and has to meet `goal`.
  WorkedDomain(Pslg pslg, const Goal& coarse, Goal goal)
      : pslg_(std::move(pslg)),
        goal_(std::move(goal)),
        domain_(*triangulate_domain(pslg_, pslg_.segments.empty())),
        input_(input_data(pslg_, domain_, Threads(1))),
        criteria_(goal_, Placement::off_centre, {}),
        assessor_(domain_.triangulation, domain_.segments, criteria_, options_) {
    ProgressMonitor progress(options_);
    const Criteria criteria(coarse, Placement::off_centre, {});
    if (!refine_by_sweeps(domain_.triangulation, domain_.segments, criteria, options_, progress)) std::abort();
  }
  WorkedDomain(const WorkedDomain&) = delete;
  WorkedDomain& operator=(const WorkedDomain&) = delete;

  [[nodiscard]] const Pslg& pslg() const { return pslg_; }
  [[nodiscard]] const Goal& goal() const { return goal_; }
  [[nodiscard]] DomainTriangulation& domain() { return domain_; }
  [[nodiscard]] MeshInWork& mesh() { return mesh_; }
  [[nodiscard]] const Criteria& criteria() const { return criteria_; }
  [[nodiscard]] const Options& options() const { return options_; }
  /// The mesh as it is now, with all its data.
  [[nodiscard]] Mesh exported() const {
    return to_mesh({domain_.triangulation, domain_.segments, domain_.input_of_vertex, domain_.input_segment,
                    domain_.subsegments, domain_.given_origin},
                   input_, Threads(1));
  }

  /// The part with these triangles, with its goal and generous limits.
  [[nodiscard]] Part part(const std::vector<TriangleId>& triangles, bool splits_segments = true) {
    std::vector<Index> portion_of(domain_.triangulation.slots.size(), no_index);
    for (const TriangleId id : triangles) portion_of[id] = 0;
    Part part = PartMaker(mesh_, portion_of).take_out({triangles, {}}, splits_segments);
    part.subdomain.goal = goal_;
    part.subdomain.most_new_points = 100'000;
    part.subdomain.seconds = 100;
    return part;
  }

 private:
  Pslg pslg_;
  Goal goal_;
  Options options_{.threads = 1};
  DomainTriangulation domain_;
  InputData input_;
  Criteria criteria_;
  Assessor assessor_;
  MeshInWork mesh_{domain_.triangulation, domain_.segments, assessor_};
};

/// A random domain with a random goal. Its mesh is the constrained Delaunay triangulation, or keeps the angles of the
/// goal already.
inline std::unique_ptr<WorkedDomain> some_worked_domain(properties::Exhibit& exhibit) {
  properties::Problem problem = properties::some_problem(exhibit);
  problem.goal.region_caps = problem.goal.conforming = false;
  Goal coarse{.min_angle_deg = *rc::gen::element(0.0, problem.goal.min_angle_deg)};
  return std::make_unique<WorkedDomain>(std::move(problem.pslg), coarse, std::move(problem.goal));
}

/// Some triangles of the mesh, at least one, ascending: those on one side of a random line, or a random choice.
inline std::vector<TriangleId> some_triangles(const Triangulation& t) {
  const auto count = static_cast<TriangleId>(t.slots.size());
  std::vector<TriangleId> found;
  if (*rc::gen::inRange(0, 4) == 0) {
    const auto chosen = *rc::gen::container<std::vector<bool>>(count, rc::gen::arbitrary<bool>());
    for (TriangleId id = 0; id < count; ++id)
      if (chosen[id]) found.push_back(id);
  } else {
    const TriangleId middle = *rc::gen::inRange<TriangleId>(0, count);
    const double angle = *rc::gen::inRange(0, 360) * 0.017453292519943295;
    const auto along = [&](TriangleId id) {
      const Point p = t.points[t.slots[id].v[0]];
      return p.x * std::cos(angle) + p.y * std::sin(angle);
    };
    for (TriangleId id = 0; id < count; ++id)
      if (along(id) <= along(middle)) found.push_back(id);
  }
  if (found.empty()) found.push_back(0);
  return found;
}

}  // namespace pardel::engine
