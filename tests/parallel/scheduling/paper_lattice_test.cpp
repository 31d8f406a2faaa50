// The paper's lattice: what T1 promises of its cells, the engine asserts as it runs.
#include "../../../parallel/mesher.hpp"
#include "many_tasks.hpp"

namespace pardel::engine::samples {
namespace {

TEST(PaperLattice, hands_on_no_point_inside_a_face_whose_cavity_fits_by_T1) {
  for (const Case& c : cases())
    for (const int threads : {1, 2}) {
      const Result<Meshed> meshed = mesh(c.pslg, c.goal, options_for(c, Decomposition::paper, threads));
      ASSERT_TRUE(meshed) << c.name << ": " << meshed.error().message;
      for (const Sweep& sweep : meshed->report.tiling.sweeps) EXPECT_EQ(sweep.against_promise, 0U) << c.name;
    }
}

/// Where there is no hypothesis to rely on, nothing is promised: the same boxes, and cavities that do leave them.
TEST(PaperLattice, promises_nothing_of_cavities_with_large_circumradii) {
  std::uint64_t beyond = 0;
  for (const Case& c : cases()) {
    const Result<Meshed> meshed = mesh(c.pslg, c.goal, options_for(c, Decomposition::automatic));
    ASSERT_TRUE(meshed) << c.name;
    for (const Sweep& sweep : meshed->report.tiling.sweeps) {
      EXPECT_EQ(sweep.against_promise, 0U) << c.name;
      beyond += sweep.beyond_box;
    }
  }
  EXPECT_GT(beyond, 0U);
}

TEST(PaperLattice, has_several_cells_here) {
  int cut = 0;
  for (const Case& c : cases()) {
    const Result<Meshed> meshed = mesh(c.pslg, c.goal, options_for(c, Decomposition::paper));
    ASSERT_TRUE(meshed) << c.name;
    if (meshed->report.tiling.columns > 2 && meshed->report.tiling.rows > 2) ++cut;
  }
  EXPECT_GE(cut, 3);
}

}  // namespace
}  // namespace pardel::engine::samples
