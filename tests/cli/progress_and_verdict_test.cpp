// Parts of the program by themselves, where the whole would have to be broken first.
#include <gtest/gtest.h>

#include <algorithm>

#include "../../cli/paranoid.hpp"
#include "../../cli/progress_bar.hpp"
#include "../../cli/verdict.hpp"
#include "../../properties/defects/defects.hpp"
#include "../../properties/domains/domains.hpp"

namespace pardel::cli {
namespace {

Mesh mesh_of(const Pslg& pslg, const Goal& goal) {
  Result<Meshed> meshed = mesh(pslg, goal);
  EXPECT_TRUE(meshed);
  return std::move(meshed->mesh);
}

TEST(SweepCheck, asks_for_no_bounds_yet) {
  for (const Pslg& pslg : {domains::cracks(), domains::regions()}) {
    const Result<Meshed> bare = triangulate(pslg);
    ASSERT_TRUE(bare);
    const Status status = check_sweep(pslg, bare->mesh, 1, {}, {});
    EXPECT_TRUE(status) << status.error().message;
  }
}

TEST(SweepCheck, notices_every_defect_that_is_no_missed_bound_and_names_the_sweep) {
  int noticed = 0;
  for (const defects::Defect& defect : defects::all()) {
    Pslg pslg = domains::regions();
    Goal goal{.max_area = 0.01, .conforming = true};
    Mesh mesh = mesh_of(pslg, goal);
    if (is_missed_bound(defect.expected) || !defect.inject(pslg, mesh, goal, 1)) continue;
    const Status status = check_sweep(pslg, mesh, 7, {.columns = 5, .rows = 4}, {.convex_hull = goal.convex_hull});
    ASSERT_FALSE(status) << defect.name;
    EXPECT_EQ(status.error().kind, ErrorKind::internal) << defect.name;
    EXPECT_NE(status.error().message.find("after sweep 7, on a lattice of 5 x 4 cells"), std::string::npos)
        << status.error().message;
    EXPECT_NE(status.error().message.find(name(defect.expected)), std::string::npos) << status.error().message;
    ++noticed;
  }
  EXPECT_GE(noticed, 20);
}

TEST(SweepCheck, ends_a_refinement_in_the_sweep_in_which_the_mesh_goes_wrong) {
  const auto turn = std::find_if(defects::all().begin(), defects::all().end(),
                                 [](const defects::Defect& d) { return d.expected == ViolationKind::not_delaunay; });
  ASSERT_NE(turn, defects::all().end());
  Pslg pslg = domains::pipe();
  Goal goal{.max_area = 0.001};
  std::uint64_t number = 0;
  Options options{.threads = 2, .cells = {4, 4}};
  options.after_sweep = [&](const Mesh& so_far, const Sweep& sweep) {
    Mesh seen = so_far;
    if (++number == 2 && !turn->inject(pslg, seen, goal, 1)) ADD_FAILURE() << "no place for a defect";
    return check_sweep(pslg, seen, number, sweep, {});
  };
  const Result<Meshed> meshed = mesh(pslg, goal, options);
  ASSERT_FALSE(meshed);
  EXPECT_EQ(meshed.error().kind, ErrorKind::internal);
  EXPECT_NE(meshed.error().message.find("after sweep 2"), std::string::npos) << meshed.error().message;
  EXPECT_EQ(number, 2U);
}

TEST(ProgressLine, shows_triangles_done_against_the_estimate) {
  EXPECT_EQ(progress_line(3'210'000, 10.01e6, 4.2),
            "[##########----------------------]  32 %  3.21 of about 10.01 million triangles  4 s");
  EXPECT_EQ(progress_line(500, 2000, 0), "[########------------------------]  25 %  500 of about 2000 triangles  0 s");
}

TEST(ProgressLine, never_claims_to_be_done_and_drops_an_estimate_that_fell_short) {
  EXPECT_EQ(progress_line(2'500'000, 2e6, 61),
            "[###############################-]  99 %  2.50 million triangles  61 s");
}

TEST(ProgressLine, shows_no_bar_without_an_estimate) { EXPECT_EQ(progress_line(123, 0, 1), "123 triangles  1 s"); }

}  // namespace
}  // namespace pardel::cli
