// The paper's lattice: cavities fit the boxes of its cells by theorem T1, and the engine checks this as it runs.
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

/// The automatic decomposition has no bound on circumradii that depends on the size of cells. With it, cavities do
/// leave the boxes, and this does not contradict T1.
TEST(PaperLattice, is_not_assumed_for_the_automatic_decomposition) {
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

TEST(PaperLattice, has_several_cells_in_some_of_these_domains) {
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
