// A mesh, its domain and its goal that are multiplied by a power of two get the same verdict: no product of lengths
// underflows or overflows.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "../../../parallel/mesher.hpp"
#include "../../../properties/checker/check.hpp"
#include "../../../properties/domains/domains.hpp"

namespace pardel {
namespace {

Point scaled(Point p, int exponent) { return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)}; }

Pslg scaled(Pslg pslg, int exponent) {
  for (Point& p : pslg.points) p = scaled(p, exponent);
  for (Point& hole : pslg.holes) hole = scaled(hole, exponent);
  for (Region& region : pslg.regions) {
    region.seed = scaled(region.seed, exponent);
    region.max_area = std::ldexp(region.max_area, 2 * exponent);
  }
  return pslg;
}

Mesh scaled(Mesh mesh, int exponent) {
  for (Point& p : mesh.points) p = scaled(p, exponent);
  return mesh;
}

Goal scaled(Goal goal, int exponent) {
  goal.max_area = std::ldexp(goal.max_area, 2 * exponent);
  goal.max_edge = std::ldexp(goal.max_edge, exponent);
  if (goal.size)
    goal.size = [size = goal.size, exponent](Point p) { return std::ldexp(size(scaled(p, -exponent)), exponent); };
  for (SizeSource& source : goal.sources)
    source = {scaled(source.a, exponent), scaled(source.b, exponent), std::ldexp(source.at_a, exponent),
              std::ldexp(source.at_b, exponent)};
  return goal;
}

/// The square with a strip of this width inside.
Pslg square_with_strip(double width) {
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.25, 0.5}, {0.75, 0.5}, {0.75, 0.5 + width}, {0.25, 0.5 + width}};
  for (const Index first : {0U, 4U})
    for (Index i = 0; i < 4; ++i) pslg.segments.push_back({first + i, first + (i + 1) % 4, 0});
  pslg.regions = {{.seed = {0.1, 0.1}, .attribute = 1, .max_area = 0.004},
                  {.seed = {0.5, 0.5 + width / 2}, .attribute = 2, .max_area = 0.0005}};
  return pslg;
}

struct Bound {
  std::string name;
  Goal goal;
};

/// Goals with one bound each, which a coarse mesh misses.
std::vector<Bound> bounds() {
  const auto no_angles = [](Goal goal) {
    goal.min_angle_deg = 0;
    return goal;
  };
  return {{"angle", {.min_angle_deg = 32}},
          {"area", no_angles({.max_area = 0.003})},
          {"edge", no_angles({.max_edge = 0.1})},
          {"regions", no_angles({.region_caps = true})},
          {"sizes", no_angles({.size = [](Point p) { return 0.05 + 0.1 * std::hypot(p.x, p.y); }})},
          {"grading", no_angles({.grading = 0.2})},
          {"sources", no_angles({.grading = 0.2, .sources = {{{0, 0}, {0.5, 0}, 0.01, 0.02}}})},
          {"feature size", no_angles({.feature_edges = 3})},
          {"both", no_angles({.grading = 0.1, .feature_edges = 2})},
          {"conforming", no_angles({.conforming = true})}};
}

using Found = std::vector<std::pair<ViolationKind, std::vector<Index>>>;

Found violations(const Pslg& pslg, const Mesh& mesh, const Goal& goal, double max_circumradius = 0) {
  Found found;
  for (const Violation& violation :
       check(pslg, mesh, goal, {.max_violations = 1'000'000, .max_circumradius = max_circumradius}).violations)
    found.emplace_back(violation.kind, violation.ids);
  return found;
}

constexpr int exponents[] = {-135, -300, 300};

/// Expects the violations of a mesh of this domain at all scales.
void expect_same_at_all_scales(const Pslg& pslg, const Goal& made_for, bool all_bounds_missed) {
  const Result<Meshed> meshed = mesh(pslg, made_for);
  ASSERT_TRUE(meshed) << meshed.error().message;
  for (const auto& [name, goal] : bounds()) {
    const Found expected = violations(pslg, meshed->mesh, goal);
    EXPECT_TRUE(!all_bounds_missed || !expected.empty() || goal.conforming) << name;
    for (const int exponent : exponents)
      EXPECT_EQ(violations(scaled(pslg, exponent), scaled(meshed->mesh, exponent), scaled(goal, exponent)), expected)
          << name << " at 2^" << exponent;
  }
  for (const int exponent : exponents)
    EXPECT_EQ(violations(scaled(pslg, exponent), scaled(meshed->mesh, exponent), {}, std::ldexp(0.1, exponent)),
              violations(pslg, meshed->mesh, {}, 0.1))
        << "circumradius at 2^" << exponent;
}

TEST(Scales, change_no_verdict_on_a_mesh_that_misses_every_bound) {
  expect_same_at_all_scales(square_with_strip(0x1p-5), {}, true);
}

TEST(Scales, change_no_verdict_on_a_mesh_with_a_strip_a_billion_times_narrower_than_the_domain) {
  expect_same_at_all_scales(square_with_strip(0x1p-30), {.min_angle_deg = 0}, false);
}

TEST(Scales, change_no_verdict_on_a_mesh_that_keeps_some_bounds) {
  expect_same_at_all_scales(square_with_strip(0x1p-5), {.feature_edges = 3}, false);
  expect_same_at_all_scales(square_with_strip(0x1p-5), {.region_caps = true, .grading = 0.2}, false);
}

TEST(Scales, change_no_verdict_where_curves_turn) {
  Pslg key = domains::key();
  expect_same_at_all_scales(key, {}, false);
}

}  // namespace
}  // namespace pardel
