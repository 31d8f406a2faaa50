// The paper's quadtree: circumradii in the buffer zone of a leaf are small enough that cavities of points in the leaf
// fit its box, and the engine checks this as it runs.
#include "../../../parallel/mesher.hpp"
#include "../../../parallel/sizes.hpp"
#include "many_tasks.hpp"

namespace pardel::engine::samples {
namespace {

TEST(PaperQuadtree, hands_on_no_point_inside_a_face_whose_cavity_fits_by_its_circumradii) {
  for (const Case& c : cases())
    for (const int threads : {1, 2}) {
      const Case graded_case = graded(c);
      const Result<Meshed> meshed =
          mesh(graded_case.pslg, graded_case.goal, options_for_leaves(c, threads, Decomposition::paper_quadtree));
      ASSERT_TRUE(meshed) << c.name << ": " << meshed.error().message;
      EXPECT_GT(meshed->report.tiling.leaves.size(), 15U) << c.name;
      for (const Sweep& sweep : meshed->report.tiling.sweeps) EXPECT_EQ(sweep.against_promise, 0U) << c.name;
    }
}

/// All triangles of this domain can be split. So when a level ends, all circumradii in the buffer zones of the next
/// finer leaves fit them, and no cavity reaches beyond a box.
TEST(PaperQuadtree, has_boxes_that_contain_all_cavities_if_every_large_triangle_can_be_split) {
  for (const int decades : {2, 4, 6}) {
    const Pslg pslg = domains::radial(decades);
    Goal goal{.min_angle_deg = 25};
    goal.size = *interpolated_size(pslg, domains::radial_sizes(pslg, 0.05));
    for (const std::uint32_t triangles : {300U, 3000U}) {
      const Options options{.decomposition = Decomposition::paper_quadtree, .triangles_per_tile = triangles};
      const Result<Meshed> meshed = mesh(pslg, goal, options);
      ASSERT_TRUE(meshed) << meshed.error().message;
      EXPECT_GT(meshed->report.tiling.leaves.size(), 15U);
      std::uint64_t to_other_leaves = 0;
      for (const Sweep& sweep : meshed->report.tiling.sweeps) {
        EXPECT_EQ(sweep.beyond_box, 0U) << decades << " decades, tiles of " << triangles;
        to_other_leaves += sweep.to_other_cells;
      }
      EXPECT_GT(to_other_leaves, 0U) << "tasks insert points only in their own leaves";
    }
  }
}

}  // namespace
}  // namespace pardel::engine::samples
