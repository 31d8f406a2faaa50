// Refinement of an existing mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "../../core/digest.hpp"
#include "../../core/neighbours.hpp"
#include "../../parallel/mesher.hpp"
#include "../../properties/checker/check.hpp"
#include "../../properties/domains/domains.hpp"
#include "samples.hpp"

namespace pardel::engine {
namespace {

using samples::nan;

Mesh coarse_square() {
  Result<Meshed> meshed = mesh(domains::square(), {.max_area = 0.1});
  EXPECT_TRUE(meshed);
  return std::move(meshed->mesh);
}

double area(const Mesh& m, const Triangle& t) {
  const Point a = m.points[t.v[0]], b = m.points[t.v[1]], c = m.points[t.v[2]];
  return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

TEST(RefineMesh, keeps_every_vertex_and_meets_the_finer_goal) {
  const Mesh coarse = coarse_square();
  const Goal goal{.min_angle_deg = 30, .max_area = 0.001};
  const Result<Meshed> fine = refine(coarse, {}, goal);
  ASSERT_TRUE(fine) << fine.error().message;
  EXPECT_TRUE(fine->report.goal_met());
  ASSERT_GT(fine->mesh.points.size(), coarse.points.size());
  for (std::size_t v = 0; v < coarse.points.size(); ++v) EXPECT_EQ(fine->mesh.points[v], coarse.points[v]);
  const Certificate certificate = check(domains::square(), fine->mesh, goal);
  EXPECT_TRUE(certificate.valid) << to_text(certificate);
}

TEST(RefineMesh, applies_a_cap_per_triangle) {
  const Mesh coarse = coarse_square();
  std::vector<double> caps(coarse.triangles.size(), 1.0);
  caps[0] = 1e-4;
  const Result<Meshed> fine = refine(coarse, caps);
  ASSERT_TRUE(fine);
  EXPECT_TRUE(fine->report.goal_met());
  const auto contains = [&](const Triangle& t, Point p) {
    for (int i = 0; i < 3; ++i) {
      const Point a = coarse.points[t.v[i]], b = coarse.points[t.v[(i + 1) % 3]];
      if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < -1e-12) return false;
    }
    return true;
  };
  std::size_t inside = 0;
  for (const Triangle& t : fine->mesh.triangles) {
    const auto& v = t.v;
    const Point a = fine->mesh.points[v[0]], b = fine->mesh.points[v[1]], c = fine->mesh.points[v[2]];
    const Point centre{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
    const auto over = static_cast<std::size_t>(std::find_if(coarse.triangles.begin(), coarse.triangles.end(),
                                                            [&](const Triangle& o) { return contains(o, centre); }) -
                                               coarse.triangles.begin());
    ASSERT_LT(over, caps.size());
    EXPECT_LE(area(fine->mesh, t), caps[over] * (1 + 1e-9));
    inside += over == 0 ? 1 : 0;
  }
  EXPECT_GT(inside, 100U);
  EXPECT_LT(fine->mesh.triangles.size(), 10'000U) << "only that triangle is refined, and a graded ring around it";
}

/// Left and right half of a mesh have different regions, but no constrained edge separates them.
TEST(RefineMesh, takes_regions_that_are_not_faces_from_the_triangle_at_the_centroid) {
  Mesh coarse = coarse_square();
  coarse.region_attributes = {5, 8};
  const auto middle = [](const Mesh& m, const Triangle& t) {
    return (m.points[t.v[0]].x + m.points[t.v[1]].x + m.points[t.v[2]].x) / 3;
  };
  std::array<double, 2> before{}, after{};
  for (const Triangle& t : coarse.triangles) {
    coarse.region.push_back(middle(coarse, t) < 0.5 ? 0 : 1);
    before[coarse.region.back()] += area(coarse, t);
  }
  const Result<Meshed> fine = refine(coarse, {}, {.min_angle_deg = 30, .max_area = 1e-4});
  ASSERT_TRUE(fine);
  ASSERT_EQ(fine->mesh.region.size(), fine->mesh.triangles.size());
  for (std::size_t t = 0; t < fine->mesh.triangles.size(); ++t)
    after[fine->mesh.region[t]] += area(fine->mesh, fine->mesh.triangles[t]);
  for (const int r : {0, 1}) EXPECT_NEAR(after[r], before[r], 0.02) << "only triangles on the border can differ";
}

/// A mesh that satisfies the goal does not change, on any domain. Exempt triangles stay exempt.
TEST(RefineMesh, with_a_goal_that_is_met_changes_nothing) {
  for (const std::string& name : domains::even_names()) {
    for (const Goal& goal : {Goal{}, Goal{.min_angle_deg = 30, .max_area = 0.01}, Goal{.conforming = true}}) {
      SCOPED_TRACE(name + " at " + std::to_string(goal.min_angle_deg) + (goal.conforming ? " conforming" : ""));
      const Result<Meshed> first = mesh(*domains::generate(name, 0, 1), goal);
      ASSERT_TRUE(first);
      Goal again = goal;
      again.region_caps = false;  // a mesh has no area caps
      const Result<Meshed> second = refine(first->mesh, {}, again);
      ASSERT_TRUE(second) << second.error().message;
      EXPECT_EQ(second->mesh.points.size(), first->mesh.points.size());
      EXPECT_EQ(digest(second->mesh), digest(first->mesh));
      EXPECT_EQ(second->report.exempt.size(), first->report.exempt.size());
    }
  }
}

/// A square of four right triangles. Its angles are 45 degrees, its areas 4 and its edges up to 4.
Mesh four_right_triangles() {
  Mesh mesh;
  for (const Point p : {Point{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}}) mesh.points.push_back(p);
  for (const Index i : {0, 1, 2, 3}) mesh.triangles.push_back({{i, (i + 1) % 4, 4}, {}});
  rebuild_neighbours(mesh.triangles, 5);
  return mesh;
}

TEST(RefineMesh, with_a_goal_that_is_met_exactly_changes_nothing) {
  const auto added = [](const Goal& goal, std::span<const double> caps = {}) {
    const Result<Meshed> refined = refine(four_right_triangles(), caps, goal);
    EXPECT_TRUE(refined && refined->report.goal_met());
    return refined->mesh.points.size() - 5;
  };
  const auto below = [](double bound) { return std::nextafter(bound, 0); };
  EXPECT_EQ(added({.max_area = 4}), 0U);
  EXPECT_GT(added({.max_area = below(4)}), 0U);
  EXPECT_EQ(added({.max_edge = 4}), 0U);
  EXPECT_GT(added({.max_edge = below(4)}), 0U);
  EXPECT_EQ(added({}, std::array{4.0, 4.0, 5.0, 4.0}), 0U);
  EXPECT_GT(added({}, std::array{4.0, below(4), 5.0, 4.0}), 0U);
}

/// The vertex in the middle sees the long side at 152 degrees. Only a bound that a triangle breaks is a reason to
/// split.
TEST(RefineMesh, with_a_goal_that_is_met_splits_no_encroached_segment) {
  Mesh mesh;
  for (const Point p : {Point{0, 0}, {8, 0}, {8, 4}, {0, 4}, {4, 1}}) mesh.points.push_back(p);
  for (const Index i : {0, 1, 2, 3}) mesh.triangles.push_back({{i, (i + 1) % 4, 4}, {}});
  rebuild_neighbours(mesh.triangles, 5);
  for (const bool is_met : {true, false}) {
    const Result<Meshed> refined = refine(mesh, {}, {.min_angle_deg = 14, .max_area = is_met ? 12.0 : 11.0});
    ASSERT_TRUE(refined);
    EXPECT_EQ(refined->mesh.points.size() == 5, is_met);
  }
}

TEST(RefineMesh, of_a_mesh_without_origins_changes_nothing_if_the_goal_is_met) {
  for (const std::string& name : domains::even_names()) {
    SCOPED_TRACE(name);
    const Goal goal{.min_angle_deg = 28, .region_caps = false};
    const Result<Meshed> first = mesh(*domains::generate(name, 0, 1), goal);
    ASSERT_TRUE(first);
    Mesh nameless = first->mesh;
    nameless.origin.clear();
    for (ConstrainedEdge& e : nameless.constrained_edges) e.segment = no_index;
    const Result<Meshed> second = refine(nameless, {}, goal);
    ASSERT_TRUE(second) << second.error().message;
    EXPECT_EQ(second->mesh.points, first->mesh.points);
    EXPECT_EQ(digest(second->mesh), digest(first->mesh));
    EXPECT_EQ(second->report.exempt.size(), first->report.exempt.size());
  }
}

TEST(RefineMesh, of_a_triangulation_gives_a_mesh_of_the_domain) {
  for (const std::string& name : domains::even_names()) {
    SCOPED_TRACE(name);
    const Pslg pslg = *domains::generate(name, 0, 1);
    const Result<Meshed> coarse = triangulate(pslg);
    ASSERT_TRUE(coarse);
    const Goal goal{.min_angle_deg = 25, .region_caps = false};
    const Result<Meshed> fine = refine(coarse->mesh, {}, goal);
    ASSERT_TRUE(fine) << fine.error().message;
    EXPECT_TRUE(fine->report.goal_met());
    const Certificate certificate = check(pslg, fine->mesh, goal);
    EXPECT_TRUE(certificate.valid) << to_text(certificate);
  }
}

/// All triangles share the vertex 0 of a polygon of 24 sides in an ellipse. Only many flips make this mesh Delaunay.
TEST(RefineMesh, of_a_mesh_that_is_not_delaunay_gives_one_that_is) {
  constexpr Index sides = 24;
  Pslg pslg;
  Mesh fan;
  for (Index i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.25) / sides;
    pslg.points.push_back({3 * std::cos(angle), std::sin(angle)});
    pslg.segments.push_back({i, (i + 1) % sides});
  }
  for (const Point p : pslg.points) fan.points.push_back(p);
  for (Index i = 1; i + 1 < sides; ++i) fan.triangles.push_back({{0, i, i + 1}, {}});
  rebuild_neighbours(fan.triangles, sides);
  const Goal goal{.min_angle_deg = 0};
  ASSERT_FALSE(check(pslg, fan, goal).valid);
  const Result<Meshed> same_points = refine(fan, {}, goal), finer = refine(fan, {}, {.min_angle_deg = 25});
  ASSERT_TRUE(same_points && finer);
  EXPECT_EQ(same_points->mesh.points.size(), sides);
  for (const Meshed* meshed : {&*same_points, &*finer}) {
    Mesh mesh = meshed->mesh;
    mesh.constrained_edges.clear();  // the fan did not say on which segments its edges lie
    mesh.origin.clear();
    const Certificate certificate = check(pslg, mesh, goal, {.foreign = true});
    EXPECT_TRUE(certificate.valid) << to_text(certificate);
  }
}

TEST(RefineMesh, keeps_markers_regions_and_attributes) {
  Pslg pslg = *domains::generate("regions", 0, 1);
  pslg.attributes_per_point = 1;
  for (const Point p : pslg.points) pslg.point_attributes.push_back(p.x + p.y);
  const Result<Meshed> coarse = mesh(pslg, {.region_caps = false});
  ASSERT_TRUE(coarse);
  const Result<Meshed> fine = refine(coarse->mesh, {}, {.max_area = 0.01});
  ASSERT_TRUE(fine);
  EXPECT_EQ(fine->mesh.region_attributes, coarse->mesh.region_attributes);
  const auto area_by_region = [](const Mesh& m) {
    std::vector<double> sum(m.region_attributes.size() + 1, 0.0);
    for (std::size_t t = 0; t < m.triangles.size(); ++t)
      sum[m.region[t] == no_index ? m.region_attributes.size() : m.region[t]] += area(m, m.triangles[t]);
    return sum;
  };
  const std::vector<double> before = area_by_region(coarse->mesh), after = area_by_region(fine->mesh);
  for (std::size_t r = 0; r < before.size(); ++r) EXPECT_NEAR(before[r], after[r], 1e-9);
  const auto length_by_marker = [](const Mesh& m) {
    std::vector<std::pair<int, double>> sum;
    for (const ConstrainedEdge& e : m.constrained_edges) {
      const double length = std::hypot(m.points[e.a].x - m.points[e.b].x, m.points[e.a].y - m.points[e.b].y);
      const auto at = std::find_if(sum.begin(), sum.end(), [&](const auto& s) { return s.first == e.marker; });
      if (at == sum.end())
        sum.push_back({e.marker, length});
      else
        at->second += length;
    }
    std::sort(sum.begin(), sum.end());
    return sum;
  };
  const auto markers_before = length_by_marker(coarse->mesh), markers_after = length_by_marker(fine->mesh);
  ASSERT_EQ(markers_before.size(), markers_after.size());
  for (std::size_t i = 0; i < markers_before.size(); ++i) {
    EXPECT_EQ(markers_before[i].first, markers_after[i].first);
    EXPECT_NEAR(markers_before[i].second, markers_after[i].second, 1e-9);
  }
  for (std::size_t v = 0; v < fine->mesh.points.size(); ++v)
    EXPECT_NEAR(fine->mesh.point_attributes[v], fine->mesh.points[v].x + fine->mesh.points[v].y, 1e-9);
}

TEST(RefineMesh, refuses_an_invalid_mesh) {
  const Mesh good = coarse_square();
  Mesh empty = good, flipped = good, lost_vertex = good, lost_neighbour = good, lost_edge = good, not_a_number = good;
  empty.triangles.clear();
  std::swap(flipped.triangles[0].v[1], flipped.triangles[0].v[2]);
  lost_vertex.triangles[0].v[0] = 1'000'000;
  lost_neighbour.triangles[0].n[0] = 1'000'000;
  lost_edge.constrained_edges[0].a = 1'000'000;
  not_a_number.points[0].x = nan;
  for (const Mesh& m : {empty, flipped, lost_vertex, lost_neighbour, lost_edge, not_a_number}) {
    const Result<Meshed> fine = refine(m, {});
    ASSERT_FALSE(fine);
    EXPECT_EQ(fine.error().kind, ErrorKind::invalid_input);
  }
}

TEST(RefineMesh, refuses_the_number_after_the_last_triangle_as_a_neighbour) {
  Mesh mesh = coarse_square();
  mesh.triangles[0].n[0] = static_cast<Index>(mesh.triangles.size());
  const Result<Meshed> fine = refine(mesh, {});
  ASSERT_FALSE(fine);
  EXPECT_NE(fine.error().message.find("names a neighbour that does not exist"), std::string::npos);
}

TEST(RefineMesh, refuses_the_number_after_the_last_vertex_as_a_corner) {
  for (const unsigned corner : {0, 1, 2}) {
    Mesh mesh = coarse_square();
    mesh.triangles[1].v[corner] = static_cast<Index>(mesh.points.size());
    const Result<Meshed> fine = refine(mesh, {});
    ASSERT_FALSE(fine);
    EXPECT_EQ(fine.error().kind, ErrorKind::invalid_input);
    const auto& v = mesh.triangles[1].v;
    EXPECT_EQ(fine.error().message, "triangle 1 of the mesh (vertices " + std::to_string(v[0]) + ", " +
                                        std::to_string(v[1]) + ", " + std::to_string(v[2]) +
                                        ") names a vertex that does not exist");
  }
}

TEST(RefineMesh, refuses_the_number_after_the_last_vertex_as_an_end_of_a_constrained_edge) {
  for (const auto end : {&ConstrainedEdge::a, &ConstrainedEdge::b}) {
    Mesh mesh = coarse_square();
    mesh.constrained_edges[0].*end = static_cast<Index>(mesh.points.size());
    const Result<Meshed> fine = refine(mesh, {});
    ASSERT_FALSE(fine);
    EXPECT_NE(fine.error().message.find("names a vertex that does not exist"), std::string::npos);
  }
}

TEST(RefineMesh, refuses_caps_that_do_not_fit) {
  const Mesh coarse = coarse_square();
  std::vector<double> caps(coarse.triangles.size() + 1, 1.0);
  EXPECT_FALSE(refine(coarse, caps));
  caps.resize(coarse.triangles.size());
  for (const double wrong : {0.0, -1.0, nan}) {
    caps[2] = wrong;
    const Result<Meshed> fine = refine(coarse, caps);
    ASSERT_FALSE(fine) << wrong;
    EXPECT_EQ(fine.error().kind, ErrorKind::invalid_input);
  }
}

}  // namespace
}  // namespace pardel::engine
