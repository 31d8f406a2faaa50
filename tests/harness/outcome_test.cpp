#include "../../cli/harness/outcome.hpp"

#include <gtest/gtest.h>

#include <array>

namespace pardel::harness {
namespace {

/// A flat rhombus. Its two meshes: cut along the longer diagonal, and along the shorter one.
const Pslg rhombus = [] {
  Pslg pslg;
  pslg.points = {{0, 0}, {4, -1}, {8, 0}, {4, 1}};
  pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}};
  return pslg;
}();

Mesh mesh_of(const std::vector<std::array<Index, 3>>& triangles) {
  Mesh mesh;
  for (const Point& p : rhombus.points) mesh.points.push_back(p);
  for (const auto& v : triangles) mesh.triangles.push_back({.v = v});
  return mesh;
}
const Mesh along = mesh_of({{0, 1, 2}, {0, 2, 3}});
const Mesh across = mesh_of({{0, 1, 3}, {1, 2, 3}});

using Kinds = std::vector<std::string>;

Kinds kinds(const Outcome& outcome) {
  Kinds all;
  for (const Finding& finding : outcome.findings) all.push_back(finding.kind);
  return all;
}

TEST(Outcome, a_mesh_of_points_and_triangles_only_can_be_valid) {
  EXPECT_EQ(judge(rhombus, across, {.min_angle_deg = 0}, true).verdict, Verdict::valid);
}

TEST(Outcome, a_mesh_that_is_not_delaunay_is_wrong_unless_any_triangulation_is_accepted) {
  const Outcome strict = judge(rhombus, along, {.min_angle_deg = 0}, true);
  EXPECT_EQ(strict.verdict, Verdict::wrong);
  EXPECT_EQ(kinds(strict), Kinds{"not_delaunay"});
  EXPECT_NE(strict.findings[0].message, "");
  EXPECT_EQ(judge(rhombus, along, {.min_angle_deg = 0}, false).verdict, Verdict::valid);
}

TEST(Outcome, a_missed_bound_differs_from_a_wrong_mesh) {
  const Goal small = {.min_angle_deg = 0, .max_area = 1};
  const Outcome missed = judge(rhombus, across, small, true);
  EXPECT_EQ(missed.verdict, Verdict::missed);
  EXPECT_EQ(kinds(missed), Kinds{"large_area"});
  const Outcome wrong = judge(rhombus, along, small, true);
  EXPECT_EQ(wrong.verdict, Verdict::wrong);
  EXPECT_EQ(kinds(wrong), Kinds{"not_delaunay"});
  EXPECT_EQ(judge(rhombus, along, small, false).verdict, Verdict::missed);
}

TEST(Outcome, a_small_input_angle_excuses_a_small_angle) {
  EXPECT_EQ(judge(rhombus, across, {.min_angle_deg = 30}, true).verdict, Verdict::valid);
}

TEST(Outcome, a_vertex_may_have_the_marker_of_a_segment_outside_the_domain) {
  Pslg with_tail = rhombus;
  with_tail.points.push_back({4, -3});
  with_tail.segments.push_back({1, 4, 7});
  Mesh mesh = across;
  for (const int marker : {1, 7, 1, 1}) mesh.point_markers.push_back(marker);
  EXPECT_EQ(judge(with_tail, mesh, {.min_angle_deg = 0}, true).verdict, Verdict::valid);
  mesh.point_markers[1] = 8;
  EXPECT_EQ(kinds(judge(with_tail, mesh, {.min_angle_deg = 0}, true)), Kinds{"wrong_vertex_marker"});
}

TEST(Outcome, a_mesh_that_lacks_a_triangle_is_wrong) {
  const Outcome outcome = judge(rhombus, mesh_of({{0, 1, 3}}), {}, true);
  EXPECT_EQ(outcome.verdict, Verdict::wrong);
  EXPECT_NE(kinds(outcome), Kinds{});
}

}  // namespace
}  // namespace pardel::harness
