// The number of triangles that Options::before_refinement lets expect, compared with the meshes.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "../../../parallel/mesher.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../shapes.hpp"

namespace pardel {
namespace {

Pslg strip(double width) {
  Pslg pslg;
  testing::add_polygon(pslg, {{0, 0}, {1, 0}, {1, width}, {0, width}});
  return pslg;
}

LeastSize announced(const Pslg& pslg, const Goal& goal, Options options = {}) {
  LeastSize announced;
  options.before_refinement = [&](const LeastSize& size) -> Status {
    announced = size;
    return Error{ErrorKind::usage, "enough"};
  };
  EXPECT_FALSE(mesh(pslg, goal, options));
  return announced;
}

/// The expected number divided by that of the mesh.
double ratio(const Pslg& pslg, const Goal& goal) {
  const Result<Meshed> made = mesh(pslg, goal);
  EXPECT_TRUE(made);
  return announced(pslg, goal).expected / static_cast<double>(made->mesh.triangles.size());
}

void expect_right_within_factor(double most, const std::string& domain, const Pslg& pslg, const Goal& goal) {
  const double found = ratio(pslg, goal);
  EXPECT_LE(found, most) << domain;
  EXPECT_GE(found, 1 / most) << domain;
}

TEST(ExpectedSize, is_right_within_a_factor_where_the_geometry_and_gradation_determine_sizes) {
  for (const Goal& goal : {Goal{.grading = 0.3}, Goal{.feature_edges = 2}, Goal{.grading = 0.1, .feature_edges = 1}}) {
    for (const char* name : {"comb", "pipe", "key", "coast", "star", "wedge", "radial", "points"})
      expect_right_within_factor(2.2, name, *domains::generate(name, 0, 1), goal);
    for (const double width : {1e-2, 1e-3, 1e-4})
      expect_right_within_factor(2, "strip " + std::to_string(width), strip(width), goal);
    expect_right_within_factor(2.2, "coast of 3000", domains::coast(3000, 2), goal);
  }
}

TEST(ExpectedSize, counts_narrow_gaps_outside_the_domain) {
  for (const double gap : {1e-3, 1e-4}) {
    Pslg pslg;
    testing::add_square(pslg, 1, {0, 0});
    testing::add_square(pslg, 1, {1 + gap, 0});
    expect_right_within_factor(2.5, "gap of " + std::to_string(gap), pslg, {.grading = 0.5});
    expect_right_within_factor(2.5, "gap of " + std::to_string(gap), pslg, {.feature_edges = 1});
  }
}

TEST(ExpectedSize, is_right_within_a_factor_in_narrow_parts) {
  for (const double degrees : {20.7, 30.0}) {
    for (const double width : {1e-4, 3e-5})
      expect_right_within_factor(2, "strip " + std::to_string(width), strip(width), {.min_angle_deg = degrees});
    expect_right_within_factor(2, "comb", domains::comb(8, 1e-4), {.min_angle_deg = degrees});
  }
}

TEST(ExpectedSize, counts_areas_regions_fields_and_sources) {
  expect_right_within_factor(1.5, "areas", domains::key(), {.max_area = 1e-3});
  expect_right_within_factor(1.5, "edges", domains::key(), {.max_edge = 0.05});
  expect_right_within_factor(1.5, "regions", domains::regions(), {.region_caps = true});
  Goal field;
  field.size = [](Point p) { return 0.002 + 0.1 * std::hypot(p.x, p.y); };
  expect_right_within_factor(1.5, "field", domains::square(), field);
  Goal sources{.grading = 0.2};
  sources.sources = {{{0.2, 0.2}, {0.7, 0.3}, 0.005, 0.01}};
  expect_right_within_factor(1.5, "sources", domains::square(), sources);
}

TEST(ExpectedSize, of_a_plate_of_a_billionth_is_enormous_for_any_bound) {
  EXPECT_GT(announced(strip(1e-9), {}).expected, 5e8);
  EXPECT_GT(announced(strip(1e-9), {.grading = 0.3}).expected, 3e9);
  const LeastSize by_features = announced(strip(1e-9), {.feature_edges = 2});
  EXPECT_GT(by_features.expected, 1e10);
  EXPECT_FALSE(by_features.is_of_narrow_parts());
  EXPECT_NE(by_features.message().find("The domain is only 1e-09 wide at "), std::string::npos);
  EXPECT_NE(by_features.message().find(". With these bounds on sizes, the mesh will have about "), std::string::npos);
}

TEST(ExpectedSize, has_no_edges_below_the_shortest_that_is_allowed) {
  const Goal goal{.feature_edges = 2};
  const double made = static_cast<double>(mesh(strip(1e-4), goal, {.min_edge = 1e-4})->mesh.triangles.size());
  const double expected = announced(strip(1e-4), goal, {.min_edge = 1e-4}).expected;
  EXPECT_LT(expected, announced(strip(1e-4), goal).expected / 3);
  EXPECT_LE(expected, 2 * made);
  EXPECT_GE(expected, made / 2);
}

TEST(ExpectedSize, of_small_areas_names_no_narrow_part) {
  const LeastSize size = announced(domains::square(), {.max_area = 1e-8});
  EXPECT_EQ(size.triangles, 0);
  EXPECT_EQ(size.message().find("With these bounds on sizes, the mesh will have about 1"), 0U) << size.message();
}

TEST(ExpectedSize, does_not_depend_on_the_number_of_threads) {
  const Pslg coast = domains::coast(3000, 1);
  const Goal goal{.feature_edges = 3};
  EXPECT_EQ(announced(coast, goal, {.threads = 1}).expected, announced(coast, goal, {.threads = 3}).expected);
}

}  // namespace
}  // namespace pardel
