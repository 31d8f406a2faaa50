// Several ranks make the mesh of one process.
#include <cmath>
#include <functional>
#include <string>

#include "../framework/mesh_of_ranks.hpp"
#include "../framework/shares.hpp"
#include "meshing.hpp"

namespace pardel::properties {
namespace {

/// Sizes that grow with the distance from a point of the domain, from about the size that the bound on areas allows.
std::function<double(Point)> growing_sizes(const Problem& problem) {
  const Point centre = problem.pslg.points.front();
  const double least = std::sqrt(std::min(problem.goal.max_area, 1.0)), slope = *rc::gen::element(0.05, 0.2, 1.0);
  return [=](Point p) { return least + slope * std::hypot(p.x - centre.x, p.y - centre.y); };
}

PARDEL_PROPERTY(
    Ranks, make_the_mesh_of_one_process,
    {.statement = "For every domain, goal and field of sizes, on tiles of every kind, with random delays of "
                  "messages, two to six ranks make the mesh that one process makes, triangle by triangle, with the "
                  "same markers, "
                  "attributes and origins of points.",
     .source = "properties/THEORY_OF_RANKS.md, Ranks",
     .families = "lattice domains of every family, random goals, fields of sizes, and options"}) {
  Problem problem = some_problem(exhibit);
  if (*rc::gen::inRange(0, 3) == 0) problem.goal.size = growing_sizes(problem);
  Options options = some_options();
  options.triangles_per_tile = *rc::gen::inRange(10U, 80U);
  if (problem.goal.size && *rc::gen::arbitrary<bool>()) options.decomposition = Decomposition::quadtree;
  const int count = *rc::gen::inRange(2, 7);
  const bool with_delays = *rc::gen::inRange(0, 10) == 0;

  const Meshed whole = meshed(problem, exhibit, options);
  const ValidPslg domain = std::move(validate(problem.pslg)).value();
  std::uint64_t other_ranks_triangles = 0;
  const auto make = [&](pardel::Ranks& ranks) {
    Result<MeshPiece> piece = mesh(domain, problem.goal, options, ranks);
    if (piece && ranks.rank() == 0) other_ranks_triangles = piece->triangles - piece->mesh.triangles.size();
    return piece;
  };
  const std::string difference = difference_on_ranks(whole.mesh, count, make, with_delays ? 1 : 0);
  classify(other_ranks_triangles > whole.mesh.triangles.size() / 4, "divided among ranks", 20);
  RC_ASSERT(difference == "");
}

}  // namespace
}  // namespace pardel::properties
