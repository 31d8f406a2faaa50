// The numbers of triangles of the engine and the reference, compared with a number that no mesh undercuts.
#include <algorithm>
#include <limits>

#include "../../../ref/ruppert.hpp"
#include "../framework/shares.hpp"
#include "../refinement/meshing.hpp"
#include "../refinement/refined_channels.hpp"
#include "least_number.hpp"

namespace pardel::properties {
namespace {

double triangles_of(const Mesh& mesh) { return static_cast<double>(mesh.triangles.size()); }

double least_number(const Pslg& pslg, const Goal& goal, const Mesh& cells) {
  const Mesh domain = value_of(triangulate(pslg)).mesh;
  return least_number_of_triangles(domain, cells, goal.min_angle_deg, [&](std::size_t t) {
    const bool has_cap = goal.region_caps && !cells.region.empty() && cells.region[t] != no_index;
    return has_cap ? std::min(goal.max_area, pslg.regions[cells.region[t]].max_area) : goal.max_area;
  });
}

/// Tags the case with the ratio of a number of triangles and the least number, rounded down to a power of two.
void tag_ratio(double ratio) {
  int power = 1;
  while (2 * power <= ratio) power *= 2;
  RC_TAG(std::to_string(power) + " times the least number or more");
}

constexpr double rounding = 1 + 1e-9;

PARDEL_PROPERTY(
    LeastNumber, of_triangles_is_undercut_by_no_mesh_and_the_engine_makes_few_more,
    {.statement = "No mesh of a domain whose angles are at least alpha has fewer triangles than the triangulation "
                  "without further vertices, nor fewer than the integral of 1 / min(area bound, K rho^2). Here K = "
                  "2 cot(alpha/2) + tan(alpha), and rho at x is the largest distance of a point c from all vertices "
                  "and segments such that x is within 1 / sin(alpha/2) times this distance of c. If no triangle is "
                  "exempt, the engine makes at most 160 times as many triangles. (The most in 10,000 cases: less than "
                  "128 times; in 95 % of the cases less than 16 times.)",
     .source = "properties/THEORY.md, LeastNumber; the factor as measured",
     .families =
         "lattice domains of every family, random goals with a bound on angles; meshes of 16 triangles or more"}) {
  const Problem problem = some_problem(exhibit);
  RC_PRE(problem.goal.min_angle_deg > 0);
  const Meshed result = meshed(problem, exhibit, some_options());
  RC_PRE(result.report.exempt.empty());
  RC_PRE(result.mesh.triangles.size() >= 16U);
  const double least = least_number(problem.pslg, problem.goal, result.mesh);
  RC_ASSERT(least <= triangles_of(result.mesh) * rounding);
  tag_ratio(triangles_of(result.mesh) / least);
  classify(triangles_of(result.mesh) < 16 * least, "fewer than 16 times the least number", 93);
  RC_ASSERT(triangles_of(result.mesh) <= 160 * least);
}

PARDEL_PROPERTY(
    LeastNumber, of_one_refiner_bounds_the_meshes_of_both,
    {.statement = "The least number of triangles, computed on the cells of the engine's mesh or on those of the mesh "
                  "of Ruppert's algorithm, is at most the number of triangles of either mesh. The engine makes at most "
                  "5 times as many. (In 2,000 cases less than 4 times.)",
     .source = "properties/THEORY.md, LeastNumber; ref/ruppert.hpp",
     .families = "channels: bars, bends, rings and slants, with walls, cracks and moved corners"}) {
  const Channel channel = some_channel(exhibit);
  const Pslg pslg = to_pslg(channel);
  const Goal goal = coarse_goal_of(channel);
  const Result<Mesh> reference = ref::ruppert(pslg, goal);
  RC_ASSERT(reference.ok());
  const Mesh engine = value_of(mesh(pslg, goal)).mesh;
  exhibit.show(pslg, engine);
  for (const Mesh& cells : {engine, *reference}) {
    const double least = least_number(pslg, goal, cells);
    RC_ASSERT(least <= std::min(triangles_of(engine), triangles_of(*reference)) * rounding);
    tag_ratio(triangles_of(engine) / least);
    RC_ASSERT(triangles_of(engine) <= 5 * least);
  }
}

}  // namespace
}  // namespace pardel::properties
