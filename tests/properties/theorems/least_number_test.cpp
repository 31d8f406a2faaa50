// The least number of triangles, for meshes that another mesher made.
#include "../../../properties/theorems/size/least_number.hpp"

#include "../../../parallel/mesher.hpp"
#include "../../../properties/theorems/refinement/refined_channels.hpp"
#include "../checker/cgal_meshes.hpp"

namespace pardel::properties {
namespace {

PARDEL_PROPERTY(
    LeastNumber, of_triangles_is_undercut_by_no_mesh_of_cgal,
    {.statement = "No mesh that CGAL's Mesh_2 makes for an angle bound of 20.7 degrees has fewer triangles than the "
                  "least number of triangles, whether that is computed on the cells of this mesh or of pardel's mesh.",
     .source = "properties/THEORY.md, LeastNumber",
     .families = "channels: bars, bends, rings and slants, with walls, cracks and moved corners"}) {
  const Pslg pslg = to_pslg(some_channel(exhibit));
  const Goal goal;  // an angle bound of 20.7 degrees, no bound on areas
  const auto no_bound = [&](std::size_t) { return goal.max_area; };
  const auto domain = triangulate(pslg), ours = mesh(pslg, goal);
  RC_ASSERT(domain.ok() && ours.ok());
  const Mesh theirs = testing::refined_by_cgal(pslg, 0);
  for (const Mesh& cells : {ours->mesh, theirs}) {
    const double least = least_number_of_triangles(domain->mesh, cells, goal.min_angle_deg, no_bound);
    RC_ASSERT(least <= static_cast<double>(theirs.triangles.size()) * (1 + 1e-9));
  }
}

}  // namespace
}  // namespace pardel::properties
