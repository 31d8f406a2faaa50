// The judgement of a mesh notices what is wrong with a mesh, and what is wrong with its report.
#include "../../fuzz/judgement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../../cli/centroid.hpp"
#include "../../properties/domains/domains.hpp"

namespace pardel::fuzz {
namespace {

/// A square with some triangles that miss the goal, because there is a limit on vertices.
class Judgement : public testing::Test {
 protected:
  Judgement() : meshed_(std::move(mesh(pslg_, goal_, options_)).value()) {}

  [[nodiscard]] std::string fault(bool may_miss = false) const {
    return fault_of(meshed_, {.pslg = pslg_, .goal = goal_, .options = options_, .may_miss = may_miss});
  }

  Pslg pslg_ = domains::square();
  Goal goal_{.min_angle_deg = 25, .max_area = 0.01};
  Options options_{.threads = 1, .max_vertices = 40};
  Meshed meshed_;
};

TEST_F(Judgement, finds_nothing_wrong_with_a_mesh_of_the_mesher) {
  ASSERT_GT(meshed_.report.exempt.size(), 2U);
  EXPECT_EQ(fault(), "");
}

TEST_F(Judgement, misses_a_triangle_that_the_report_does_not_list) {
  meshed_.report.exempt.pop_back();
  EXPECT_TRUE(fault().starts_with("not in the report: ")) << fault();
}

TEST_F(Judgement, sees_that_a_triangle_is_listed_twice_or_does_not_exist) {
  meshed_.report.exempt.push_back(meshed_.report.exempt.back());
  EXPECT_EQ(fault(), "the report lists a triangle twice");
  meshed_.report.exempt.back().triangle = static_cast<Index>(meshed_.mesh.triangles.size());
  EXPECT_EQ(fault(), "the report lists a triangle that does not exist");
}

TEST_F(Judgement, sees_that_a_listed_triangle_keeps_all_bounds) {
  std::vector<bool> listed(meshed_.mesh.triangles.size(), false);
  for (const Exemption& e : meshed_.report.exempt) listed[e.triangle] = true;
  const auto good = static_cast<Index>(std::find(listed.begin(), listed.end(), false) - listed.begin());
  ASSERT_LT(good, listed.size());
  meshed_.report.exempt.push_back({good, ExemptReason::budget});
  EXPECT_TRUE(fault().starts_with("listed, but keeps all bounds: budget triangle " + std::to_string(good))) << fault();
}

TEST_F(Judgement, allows_a_listed_triangle_whose_wanted_length_depends_on_the_rounding_of_its_centroid) {
  std::vector<bool> listed(meshed_.mesh.triangles.size(), false);
  for (const Exemption& e : meshed_.report.exempt) listed[e.triangle] = true;
  const auto good = static_cast<Index>(std::find(listed.begin(), listed.end(), false) - listed.begin());
  ASSERT_LT(good, listed.size());
  meshed_.report.exempt.push_back({good, ExemptReason::budget});
  const Point centre = cli::centroid(meshed_.mesh, meshed_.mesh.triangles[good]);
  const auto fault_if_short_from = [&](Point corner) {
    return fault_of(meshed_, {.pslg = pslg_, .goal = goal_, .options = options_, .longest_edge = [corner](Point p) {
                                return p.x >= corner.x && p.y >= corner.y ? 1e-3 : 1e3;
                              }});
  };
  const Point next{std::nextafter(centre.x, 2), std::nextafter(centre.y, 2)};
  EXPECT_EQ(fault_if_short_from(next), "");
  EXPECT_TRUE(fault_if_short_from({std::nextafter(next.x, 2), next.y}).starts_with("listed, but keeps all bounds: "));
  EXPECT_TRUE(fault_if_short_from({next.x, std::nextafter(next.y, 2)}).starts_with("listed, but keeps all bounds: "));
}

TEST_F(Judgement, sees_that_a_reason_cannot_be_true) {
  for (Exemption& e : meshed_.report.exempt) e.reason = ExemptReason::kept_segment;
  EXPECT_TRUE(fault(true).starts_with("every segment may be split: ")) << fault(true);
  for (Exemption& e : meshed_.report.exempt) e.reason = ExemptReason::budget;
  options_.max_vertices = 0;
  EXPECT_TRUE(fault().starts_with("there is no limit: ")) << fault();
}

TEST_F(Judgement, sees_that_no_length_is_short_enough_to_be_a_reason) {
  for (const ExemptReason reason : {ExemptReason::min_edge, ExemptReason::precision}) {
    for (Exemption& e : meshed_.report.exempt) e.reason = reason;
    options_.min_edge = 0;
    EXPECT_TRUE(fault(true).starts_with("no triangle is so narrow that lengths are a reason: ")) << fault(true);
    options_.min_edge = 0.1;
    EXPECT_TRUE(fault(true).starts_with("an edge is shorter than allowed: ")) << fault(true);
  }
}

TEST_F(Judgement, does_not_believe_that_a_small_angle_of_the_domain_is_the_reason) {
  goal_ = {.min_angle_deg = 30};
  options_ = {.threads = 1, .max_vertices = 5};
  pslg_.points.push_back({0.5, 0.01});
  meshed_ = std::move(mesh(pslg_, goal_, options_)).value();
  ASSERT_FALSE(meshed_.report.exempt.empty());
  EXPECT_EQ(fault(), "");
  for (Exemption& e : meshed_.report.exempt) e.reason = ExemptReason::nestled;
  EXPECT_NE(fault(true), "");
}

TEST_F(Judgement, accepts_a_missed_bound_only_where_the_case_allows_it) {
  options_.no_boundary_splits = true;
  for (Exemption& e : meshed_.report.exempt) e.reason = ExemptReason::kept_segment;
  EXPECT_EQ(fault(true), "");
  EXPECT_NE(fault(false), "");
}

TEST_F(Judgement, finds_a_damaged_mesh) {
  Point& moved = meshed_.mesh.points[meshed_.mesh.points.size() - 1];
  moved.x += 0.3;
  EXPECT_NE(fault(true), "");
}

TEST_F(Judgement, counts_the_vertices) {
  options_.max_vertices = 39;
  EXPECT_EQ(fault(), "more vertices than allowed: 40");
  options_.max_vertices = 40;
  ++meshed_.report.inserted;
  EXPECT_EQ(fault(), "the report counts 37 new vertices, not 36");
}

TEST_F(Judgement, measures_new_edges_against_the_floor) {
  options_.min_edge = 0.5;
  EXPECT_TRUE(fault(true).starts_with("an edge is shorter than allowed: ")) << fault(true);
}

TEST_F(Judgement, sees_a_split_segment_that_may_not_be_split) {
  options_.no_segment_splits = true;
  EXPECT_TRUE(fault(true).starts_with("a segment was split at vertex ")) << fault(true);
}

TEST_F(Judgement, judges_a_mesh_that_is_refined_again) {
  EXPECT_EQ(fault_of_refining(meshed_.mesh, goal_, options_, false), "");
  Mesh torn = meshed_.mesh;
  torn.triangles.resize(torn.triangles.size() - 1);
  EXPECT_NE(fault_of_refining(torn, goal_, options_, false), "");
}

}  // namespace
}  // namespace pardel::fuzz
