// check_sweep() on meshes with defects. The program cannot be made to produce such meshes.
#include <gtest/gtest.h>

#include <algorithm>

#include "../../cli/paranoid.hpp"
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

TEST(SweepCheck, checks_no_bounds) {
  for (const Pslg& pslg : {domains::cracks(), domains::regions()}) {
    const Result<Meshed> bare = triangulate(pslg);
    ASSERT_TRUE(bare);
    const Status status = check_sweep(pslg, bare->mesh, 1, {}, {});
    EXPECT_TRUE(status) << status.error().message;
  }
}

TEST(SweepCheck, reports_every_defect_except_missed_bounds_and_names_the_sweep) {
  int reported = 0;
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
    ++reported;
  }
  EXPECT_GE(reported, 20);
}

TEST(SweepCheck, stops_the_refinement_after_the_sweep_with_the_first_violation) {
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

}  // namespace
}  // namespace pardel::cli
