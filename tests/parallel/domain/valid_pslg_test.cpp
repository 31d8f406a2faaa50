// Tests ValidPslg: the content that validate() returns, and the mesh that the mesher makes of it.
#include <gtest/gtest.h>

#include <vector>

#include "../../../core/digest.hpp"
#include "../../../parallel/mesher.hpp"
#include "../../../parallel/repair.hpp"
#include "../../../parallel/sizes.hpp"
#include "../../../parallel/validate.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../shapes.hpp"

namespace pardel {
namespace {

using testing::points_only;
using testing::square;

Pslg open_square() {
  Pslg pslg = square(4);
  pslg.segments.pop_back();
  return pslg;
}

TEST(ValidPslg, takes_a_valid_pslg_without_copying_its_points) {
  Pslg pslg = square(4);
  const Point* points = pslg.points.data();
  Result<ValidPslg, std::vector<Problem>> domain = validate(std::move(pslg));
  ASSERT_TRUE(domain);
  EXPECT_EQ(domain->pslg().points.data(), points);
  EXPECT_EQ(domain->pslg(), square(4));
  const Pslg back = std::move(domain).value().pslg();
  EXPECT_EQ(back.points.data(), points);
}

TEST(ValidPslg, of_points_alone_is_their_convex_hull) {
  const Pslg points = points_only({{0, 0}, {1, 0}, {0, 1}});
  EXPECT_TRUE(validate(points)->convex_hull());
  EXPECT_TRUE(validate(Pslg(points))->convex_hull());
  const Pslg outline = square(4);
  EXPECT_FALSE(validate(outline)->convex_hull());
  EXPECT_TRUE(validate(outline, {.convex_hull = true})->convex_hull());
  EXPECT_TRUE(validate(outline).value().with_convex_hull().convex_hull());
}

TEST(ValidPslg, leaves_an_invalid_pslg_as_it_is_and_gives_its_problems) {
  Pslg pslg = open_square();
  const Result<ValidPslg, std::vector<Problem>> domain = validate(std::move(pslg));
  ASSERT_FALSE(domain);
  ASSERT_EQ(domain.error().size(), 1);
  EXPECT_EQ(domain.error()[0].kind, ProblemKind::unclosed_outline);
  EXPECT_EQ(pslg, open_square());  // NOLINT(bugprone-use-after-move): validate() promises it
}

TEST(ValidPslg, is_a_copy_of_a_pslg_that_the_caller_keeps) {
  const Pslg pslg = square(4);
  const Result<ValidPslg, std::vector<Problem>> domain = validate(pslg);
  ASSERT_TRUE(domain);
  EXPECT_EQ(domain->pslg(), pslg);
  EXPECT_NE(domain->pslg().points.data(), pslg.points.data());
}

TEST(ValidPslg, remembers_that_its_outline_is_the_convex_hull) {
  EXPECT_FALSE(validate(square(4))->convex_hull());
  EXPECT_TRUE(validate(open_square(), {.convex_hull = true})->convex_hull());
  EXPECT_TRUE(validate(points_only({{0, 0}, {1, 0}, {0, 1}}))->convex_hull());
}

TEST(ValidPslg, gives_the_mesh_of_the_plain_pslg) {
  const Pslg pslg = square(4);
  const Goal goal{.min_angle_deg = 30, .max_area = 0.1};
  const Result<Meshed> of_plain = mesh(pslg, goal), of_valid = mesh(*validate(pslg), goal);
  ASSERT_TRUE(of_plain && of_valid);
  EXPECT_EQ(digest(of_plain->mesh), digest(of_valid->mesh));
  EXPECT_GT(of_plain->report.validate_seconds, 0);
  EXPECT_EQ(of_valid->report.validate_seconds, 0);
}

TEST(ValidPslg, is_meshed_to_its_convex_hull_where_it_or_the_goal_says_so) {
  const Pslg open = open_square();
  const Result<Meshed> expected = mesh(open, {.max_area = 0.1, .convex_hull = true});
  const Result<Meshed> by_domain = mesh(*validate(open, {.convex_hull = true}), {.max_area = 0.1});
  ASSERT_TRUE(expected && by_domain);
  EXPECT_EQ(digest(expected->mesh), digest(by_domain->mesh));

  const Pslg key = *domains::generate("key", 0, 1);
  const Result<Meshed> of_plain = mesh(key, {.convex_hull = true}),
                       by_goal = mesh(*validate(key), {.convex_hull = true});
  ASSERT_TRUE(of_plain && by_goal);
  EXPECT_EQ(digest(of_plain->mesh), digest(by_goal->mesh));
}

// mesh() relies on this if only the goal selects the convex hull.
TEST(ValidPslg, is_valid_with_its_convex_hull_as_outline_too) {
  for (const std::string& name : domains::names()) {
    const Result<Pslg> pslg = domains::generate(name, 0, 1);
    ASSERT_TRUE(pslg) << name;
    if (validate(*pslg)) {
      EXPECT_TRUE(validate(*pslg, {.convex_hull = true})) << name;
    }
  }
}

TEST(ValidPslg, comes_from_repair_without_another_validation) {
  Pslg pslg = square(4);
  pslg.points.push_back({2, 0});
  pslg.first_id = {1};
  const Result<Repaired> repaired = repair(pslg);
  ASSERT_TRUE(repaired);
  EXPECT_EQ(repaired->domain.pslg().segments.size(), 5);
  EXPECT_EQ(repaired->domain.pslg().first_id.value, 1);
  EXPECT_TRUE(mesh(repaired->domain));
}

TEST(ValidPslg, gives_the_triangulation_and_the_sizes_of_the_plain_pslg) {
  const Pslg pslg = square(4);
  const ValidPslg domain = *validate(pslg);
  EXPECT_EQ(digest(triangulate(domain)->mesh), digest(triangulate(pslg)->mesh));
  const std::vector<double> sizes = {1, 2, 3, 4};
  const auto of_valid = interpolated_size(domain, sizes), of_plain = interpolated_size(pslg, sizes);
  ASSERT_TRUE(of_valid && of_plain);
  EXPECT_EQ((*of_valid)({1, 2}), (*of_plain)({1, 2}));
  EXPECT_FALSE(interpolated_size(domain, std::vector<double>{1, 2}));
}

TEST(Problems, are_numbered_from_the_first_id_of_the_pslg) {
  Pslg pslg = square(1);
  pslg.points.push_back({1, 1});
  EXPECT_EQ(mesh(pslg).error().message, "Points 2 and 4 are both at (1, 1).");
  pslg.first_id = {1};
  EXPECT_EQ(mesh(pslg).error().message, "Points 3 and 5 are both at (1, 1).");
  EXPECT_EQ(messages(find_problems(pslg), pslg.first_id.value), mesh(pslg).error().message);
}

TEST(CheckGoal, refuses_a_goal_out_of_range_and_accepts_the_default) {
  EXPECT_TRUE(check_goal({}));
  EXPECT_TRUE(check_goal({.min_angle_deg = largest_min_angle_deg}));
  EXPECT_EQ(check_goal({.min_angle_deg = 34}).error().kind, ErrorKind::usage);
  EXPECT_EQ(check_goal({}, {.min_edge = -1}).error().kind, ErrorKind::usage);
}

}  // namespace
}  // namespace pardel
