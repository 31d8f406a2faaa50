// A mesh that is imported and exported again keeps its content.
#include <gtest/gtest.h>

#include <algorithm>

#include "../../../core/neighbours.hpp"
#include "../../../parallel/conversion/export_mesh.hpp"
#include "../../../parallel/conversion/import_mesh.hpp"
#include "../../../parallel/mesher.hpp"
#include "../shapes.hpp"

namespace pardel::engine {
namespace {

/// A refined square with markers, regions and attributes.
const Mesh& refined_square() {
  static const Mesh mesh = [] {
    Pslg pslg = testing::square(4);
    pslg.segments[1].marker = 7;
    pslg.segments.push_back({0, 2, 9});
    pslg.regions = {{{3, 1}, 1.5, 0.3}, {{1, 3}, 2.5, 0.2}};
    pslg.point_markers = {0, 3, 0, 0};
    return std::move(pardel::mesh(pslg, {.min_angle_deg = 25, .region_caps = true}).value().mesh);
  }();
  return mesh;
}

Mesh exported(DomainTriangulation&& domain, const Mesh& mesh) {
  return export_mesh(std::move(domain), mesh.region_attributes, {mesh.points.span(), 0, {}, mesh.point_markers.span()},
                     {});
}

TEST(ImportMesh, followed_by_export_gives_the_same_mesh) {
  const Mesh& mesh = refined_square();
  Result<DomainTriangulation> domain = import_mesh(mesh);
  ASSERT_TRUE(domain) << domain.error().message;
  EXPECT_EQ(domain->segments.size(), 5U) << "subsegments are joined";
  const Mesh again = exported(std::move(domain).value(), mesh);
  EXPECT_EQ(again.points, mesh.points);
  EXPECT_EQ(again.triangles, mesh.triangles);
  EXPECT_EQ(again.origin, mesh.origin);
  EXPECT_EQ(again.region, mesh.region);
  EXPECT_EQ(again.point_markers, mesh.point_markers);
  ASSERT_EQ(again.constrained_edges.size(), mesh.constrained_edges.size());
  for (const ConstrainedEdge& e : mesh.constrained_edges)
    EXPECT_TRUE(std::ranges::any_of(again.constrained_edges,
                                    [&](const ConstrainedEdge& other) {
                                      return std::minmax(e.a, e.b) == std::minmax(other.a, other.b) &&
                                             e.segment == other.segment && e.marker == other.marker;
                                    }))
        << e.a << '-' << e.b;
}

TEST(ImportMesh, finds_the_segments_without_origins_too) {
  Mesh mesh = refined_square();
  mesh.origin.clear();
  Result<DomainTriangulation> domain = import_mesh(mesh);
  ASSERT_TRUE(domain);
  EXPECT_EQ(domain->segments.size(), 5U);
  for (const Index origin : exported(std::move(domain).value(), mesh).origin) EXPECT_EQ(origin, input_vertex);
}

/// Two sides of a square are in one segment for the refinement, and remain two of different names and markers.
TEST(ImportMesh, keeps_the_names_and_markers_of_subsegments_that_are_joined) {
  Pslg pslg = testing::square(4);
  pslg.points.push_back({2, 0});
  pslg.segments[0] = {0, 4, 5};
  pslg.segments.push_back({4, 1, 6});
  const Mesh coarse = std::move(triangulate(pslg).value().mesh);
  const Mesh fine = std::move(refine(coarse, {}, {.max_area = 0.1}).value().mesh);
  std::size_t pieces = 0;
  for (const ConstrainedEdge& e : fine.constrained_edges) {
    const double middle = 0.5 * (fine.points[e.a].x + fine.points[e.b].x);
    if (fine.points[e.a].y != 0 || fine.points[e.b].y != 0) continue;
    ++pieces;
    EXPECT_EQ(e.segment, middle < 2 ? 0U : 4U);
    EXPECT_EQ(e.marker, middle < 2 ? 5 : 6);
  }
  EXPECT_GT(pieces, 5U);
  for (Index v = 5; v < fine.points.size(); ++v) {
    if (fine.points[v].y != 0) continue;
    EXPECT_EQ(fine.origin[v], origin_on_segment(fine.points[v].x < 2 ? 0 : 4));
  }
  EXPECT_EQ(fine.origin[4], input_vertex);
}

TEST(ImportMesh, of_a_constrained_edge_that_is_listed_twice_takes_the_last) {
  Mesh mesh = refined_square();
  ConstrainedEdge again = mesh.constrained_edges[0];
  std::swap(again.a, again.b);
  again.marker = 77;
  mesh.constrained_edges.push_back(again);
  mesh.origin.clear();
  const Result<DomainTriangulation> domain = import_mesh(mesh);
  ASSERT_TRUE(domain);
  EXPECT_EQ(std::ranges::count(domain->subsegments, 77, &ConstrainedEdge::marker), 1);
}

TEST(ImportMesh, rejects_a_mesh_that_is_not_a_manifold_of_positive_triangles) {
  const auto rejects = [](const char* text, const auto& damage) {
    Mesh mesh = refined_square();
    damage(mesh);
    const Result<DomainTriangulation> domain = import_mesh(mesh);
    ASSERT_FALSE(domain) << text;
    EXPECT_EQ(domain.error().kind, ErrorKind::invalid_input);
    EXPECT_NE(domain.error().message.find(text), std::string::npos) << domain.error().message;
  };
  rejects("has no triangles", [](Mesh& mesh) { mesh.triangles.clear(); });
  rejects("names a vertex that does not exist", [](Mesh& mesh) { mesh.triangles[3].v[1] = 1'000'000; });
  rejects("names a vertex that does not exist", [](Mesh& mesh) { mesh.constrained_edges[0].a = 1'000'000; });
  rejects("names a neighbour that does not exist", [](Mesh& mesh) {
    for (Index& n : mesh.triangles[0].n) n = 1'000'000;
  });
  rejects("is not positively oriented", [](Mesh& mesh) { std::swap(mesh.triangles[2].v[0], mesh.triangles[2].v[1]); });
  rejects("has a neighbour that does not agree",
          [](Mesh& mesh) { std::swap(mesh.triangles[0].n[0], mesh.triangles[0].n[1]); });
  rejects("both lie on the same side of the edge", [](Mesh& mesh) {
    mesh.triangles.push_back(mesh.triangles[0]);
    rebuild_neighbours(mesh.triangles, mesh.points.size());
  });
  rejects("overlaps triangle", [](Mesh& mesh) {  // without neighbours
    mesh.triangles.push_back({mesh.triangles[0].v, {no_index, no_index, no_index}});
  });
}

/// Two triangles with every numbering of corners and triangles. The points 0 and 2 are too far apart.
TEST(ImportMesh, flips_an_edge_that_is_not_delaunay_wherever_it_is_listed) {
  for (unsigned first = 0; first < 3; ++first)
    for (unsigned second = 0; second < 3; ++second) {
      Mesh mesh;
      for (const Point p : {Point{0, 0}, {4, -1}, {8, 0}, {4, 1}}) mesh.points.push_back(p);
      mesh.triangles.push_back({{0, 1, 2}, {}});
      mesh.triangles.push_back({{0, 2, 3}, {}});
      std::rotate(mesh.triangles[0].v.begin(), mesh.triangles[0].v.begin() + first, mesh.triangles[0].v.end());
      std::rotate(mesh.triangles[1].v.begin(), mesh.triangles[1].v.begin() + second, mesh.triangles[1].v.end());
      rebuild_neighbours(mesh.triangles, mesh.points.size());
      const Result<DomainTriangulation> domain = import_mesh(mesh);
      ASSERT_TRUE(domain) << domain.error().message;
      for (const Slot& slot : domain->triangulation.slots)
        EXPECT_TRUE(std::ranges::count(slot.v, 1U) == 1 && std::ranges::count(slot.v, 3U) == 1);
    }
}

TEST(ImportMesh, refuses_flat_triangles_and_wrong_neighbours) {
  Mesh mesh;
  for (const Point p : {Point{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 0}}) mesh.points.push_back(p);
  mesh.triangles.push_back({{0, 4, 1}, {no_index, no_index, no_index}});
  EXPECT_FALSE(import_mesh(mesh)) << "flat";
  mesh.triangles = {};
  mesh.triangles.push_back({{0, 1, 2}, {no_index, 1, no_index}});
  mesh.triangles.push_back({{0, 2, 3}, {no_index, no_index, 0}});
  EXPECT_TRUE(import_mesh(mesh));
  for (const Index other : {0U, 1U, 2U})
    for (unsigned side = 0; side < 3; ++side) {
      Mesh wrong = mesh;
      if (wrong.triangles[1].n[side] == other) continue;
      wrong.triangles[1].n[side] = other;
      EXPECT_FALSE(import_mesh(wrong)) << side << " to " << other;
    }
}

}  // namespace
}  // namespace pardel::engine
