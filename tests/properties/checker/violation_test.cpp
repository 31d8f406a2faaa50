// What the checker says about wrong meshes, word for word: the kind, the proof, the ids and the places of every
// violation, in their order. Each mesh is small enough to check each line against its picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "../../../properties/checker/check.hpp"
#include "meshes.hpp"
#include "numbers_in_sentences.hpp"

namespace pardel::checker {
namespace {

using testing::Case;
using testing::no_angle_bound;

/// The messages of all violations, one to a line. Each can also be said with the numbers of files.
std::string said(const Certificate& certificate) {
  std::string text;
  for (const Violation& violation : certificate.violations) text += violation.message() + '\n';
  testing::expect_numbers_of_files(certificate);
  return text;
}
std::string said_about(const Case& c, const Goal& goal = no_angle_bound(), const CheckOptions& options = {}) {
  return said(check(c, goal, options));
}

/// A triangle without neighbours.
Triangle loose(Index a, Index b, Index c) { return {{a, b, c}, {no_index, no_index, no_index}}; }

/// The unit square in two triangles with further vertices, which no input point explains, and a loose triangle.
Case square_and(const std::vector<Point>& points, const Triangle& triangle) {
  Case c = testing::square_in_two();
  c.mesh.points.append(points);
  c.mesh.origin.resize(4 + points.size(), interior_vertex);
  c.mesh.triangles.push_back(triangle);
  return c;
}

/// The square in eight triangles without the triangles of the list. Like many files, the mesh has only points,
/// triangles and neighbours.
Case square_in_eight_without(const std::vector<Index>& missing) {
  Case c = testing::square_in_eight();
  std::vector<std::array<Index, 3>> kept;
  for (Index t = 0; t < 8; ++t)
    if (std::ranges::find(missing, t) == missing.end()) kept.push_back(c.mesh.triangles[t].v);
  const std::vector<Point> points(c.mesh.points.begin(), c.mesh.points.end());
  c.mesh = testing::mesh_of(points, kept);
  c.mesh.origin.clear();
  c.pslg.regions.clear();
  return c;
}
std::string said_about_file(const Case& c) { return said_about(c, no_angle_bound(), {.foreign = true}); }

TEST(Violations, of_triangles_that_turn_clockwise_or_are_flat) {
  Case c = square_in_eight_without({});
  c.mesh.points[6] = {2, 5};
  EXPECT_EQ(said_about_file(c),
            "degenerate_triangle: triangle 4 is not counter-clockwise: twice its signed area is -2 [ids 4 2 5 6] at "
            "(4, 4), (2, 4), (2, 5)\n"
            "degenerate_triangle: triangle 5 is not counter-clockwise: twice its signed area is -2 [ids 5 5 3 6] at "
            "(2, 4), (0, 4), (2, 5)\n"
            "broken_segment: segment 6 from point 4 to 5 is not covered by a chain of mesh edges within the rounding "
            "distance [ids 6] at (2, 0), (2, 4)\n"
            "not_delaunay: edge 6-0 of triangles 0 and 7 is not locally Delaunay: vertex 8 (0, 2) lies inside the "
            "circumcircle, in-circle determinant 60 [ids 6 0 0 7] at (2, 5), (0, 0)\n"
            "not_delaunay: edge 1-6 of triangles 1 and 2 is not locally Delaunay: vertex 7 (4, 2) lies inside the "
            "circumcircle, in-circle determinant 60 [ids 1 6 1 2] at (4, 0), (2, 5)\n"
            "not_delaunay: edge 2-6 of triangles 3 and 4 is not locally Delaunay: vertex 5 (2, 4) lies inside the "
            "circumcircle, in-circle determinant 12 [ids 2 6 3 4] at (4, 4), (2, 5)\n");
}

TEST(Violations, of_a_flat_triangle) {
  Case c = testing::square_in_two();
  c.mesh.points.push_back({0.5, 0});
  c.mesh.triangles.push_back(loose(0, 4, 1));
  c.mesh.constrained_edges.clear();
  c.mesh.origin.clear();
  std::string degenerate;
  for (const Violation& violation : check(c, no_angle_bound(), {.foreign = true}).violations)
    if (violation.kind == ViolationKind::degenerate_triangle) degenerate += violation.message() + '\n';
  EXPECT_EQ(degenerate,
            "degenerate_triangle: triangle 2 is not counter-clockwise: twice its signed area is 0 [ids 2 0 4 1] at "
            "(0, 0), (0.5, 0), (1, 0)\n");
}

TEST(Violations, of_a_triangle_that_is_there_twice) {
  EXPECT_EQ(said_about(square_and({}, loose(0, 1, 2))),
            "duplicate_triangle: triangles 0 and 2 have the same corners [ids 0 2] at (0, 0)\n"
            "non_manifold_edge: edge 0-1 has 2 triangles, more than one on a side [ids 0 2] at (0, 0), (1, 0)\n"
            "non_manifold_edge: edge 0-2 has 3 triangles, more than one on a side [ids 1 0 2] at (0, 0), (1, 1)\n"
            "non_manifold_edge: edge 1-2 has 2 triangles, more than one on a side [ids 0 2] at (1, 0), (1, 1)\n"
            "non_manifold_vertex: vertex 0 has two triangles on the left of its edge to vertex 1 [ids 0 1] at (0, 0)\n"
            "non_manifold_vertex: vertex 1 has two triangles on the left of its edge to vertex 2 [ids 1 2] at (1, 0)\n"
            "non_manifold_vertex: vertex 2 has two triangles on the left of its edge to vertex 0 [ids 2 0] at (1, 1)\n"
            "overlap: boundary edges 0-1 and 0-1 intersect: the ends of each lie on sides 0, 0 and 0, 0 of the other "
            "[ids 0 1 0 1] at (0, 0), (1, 0), (0, 0), (1, 0)\n"
            "overlap: boundary edges 1-2 and 1-2 intersect: the ends of each lie on sides 0, 0 and 0, 0 of the other "
            "[ids 1 2 1 2] at (1, 0), (1, 1), (1, 0), (1, 1)\n"
            "uncovered_domain: edge 2-0 of triangle 2 has no neighbour although it lies inside the domain and on no "
            "segment [ids 2 2 0] at (1, 1), (0, 0)\n"
            "covered_exterior: triangle 0 ends at edge 0-1, which lies on no chain and not inside the domain [ids 0 0 "
            "1] at (0, 0), (1, 0)\n"
            "covered_exterior: triangle 0 ends at edge 1-2, which lies on no chain and not inside the domain [ids 0 1 "
            "2] at (1, 0), (1, 1)\n"
            "area_mismatch: the triangles' areas sum to 1.5, the area within the boundary is 1; the exact difference "
            "rounds to 0.5\n");
  EXPECT_EQ(said_about(square_and({}, loose(2, 3, 0))),
            "duplicate_triangle: triangles 1 and 2 have the same corners [ids 1 2] at (0, 0)\n"
            "non_manifold_edge: edge 0-2 has 3 triangles, more than one on a side [ids 1 2 0] at (0, 0), (1, 1)\n"
            "non_manifold_edge: edge 0-3 has 2 triangles, more than one on a side [ids 1 2] at (0, 0), (0, 1)\n"
            "non_manifold_edge: edge 2-3 has 2 triangles, more than one on a side [ids 1 2] at (1, 1), (0, 1)\n"
            "non_manifold_vertex: vertex 0 has two triangles on the left of its edge to vertex 2 [ids 0 2] at (0, 0)\n"
            "non_manifold_vertex: vertex 2 has two triangles on the left of its edge to vertex 3 [ids 2 3] at (1, 1)\n"
            "non_manifold_vertex: vertex 3 has two triangles on the left of its edge to vertex 0 [ids 3 0] at (0, 1)\n"
            "overlap: boundary edges 2-3 and 2-3 intersect: the ends of each lie on sides 0, 0 and 0, 0 of the other "
            "[ids 2 3 2 3] at (1, 1), (0, 1), (1, 1), (0, 1)\n"
            "overlap: boundary edges 3-0 and 3-0 intersect: the ends of each lie on sides 0, 0 and 0, 0 of the other "
            "[ids 3 0 3 0] at (0, 1), (0, 0), (0, 1), (0, 0)\n"
            "uncovered_domain: edge 0-2 of triangle 2 has no neighbour although it lies inside the domain and on no "
            "segment [ids 2 0 2] at (0, 0), (1, 1)\n"
            "covered_exterior: triangle 1 ends at edge 2-3, which lies on no chain and not inside the domain [ids 1 2 "
            "3] at (1, 1), (0, 1)\n"
            "covered_exterior: triangle 1 ends at edge 3-0, which lies on no chain and not inside the domain [ids 1 3 "
            "0] at (0, 1), (0, 0)\n"
            "area_mismatch: the triangles' areas sum to 1.5, the area within the boundary is 1; the exact difference "
            "rounds to 0.5\n");
}

TEST(Violations, of_a_triangle_inside_another) {
  EXPECT_EQ(said_about(square_and({{0.5, 0.125}, {0.75, 0.125}, {0.75, 0.25}}, loose(4, 5, 6))),
            "overlap: the triangles cover the left of boundary edge 4-5 2 times and its right 1 times [ids 2 4 5] at "
            "(0.5, 0.125), (0.75, 0.125)\n"
            "overlap: the triangles cover the left of boundary edge 5-6 2 times and its right 1 times [ids 2 5 6] at "
            "(0.75, 0.125), (0.75, 0.25)\n"
            "overlap: the triangles cover the left of boundary edge 6-4 2 times and its right 1 times [ids 2 6 4] at "
            "(0.75, 0.25), (0.5, 0.125)\n"
            "area_mismatch: the triangles' areas sum to 1.015625, the area within the boundary is 1; the exact "
            "difference rounds to 0.015625\n");
}

TEST(Violations, of_boundary_edges_that_cross) {
  EXPECT_EQ(said_about(square_and({{0.5, 0.25}, {2, 0.25}, {2, 0.75}}, loose(4, 5, 6))),
            "overlap: boundary edges 1-2 and 4-5 intersect: the ends of each lie on sides 1, -1 and -1, 1 of the "
            "other [ids 1 2 4 5] at (1, 0), (1, 1), (0.5, 0.25), (2, 0.25)\n"
            "overlap: boundary edges 1-2 and 6-4 intersect: the ends of each lie on sides -1, 1 and 1, -1 of the "
            "other [ids 1 2 6 4] at (1, 0), (1, 1), (2, 0.75), (0.5, 0.25)\n"
            "covered_exterior: triangle 2 ends at edge 4-5, which lies on no chain and not inside the domain [ids 2 4 "
            "5] at (0.5, 0.25), (2, 0.25)\n"
            "covered_exterior: triangle 2 ends at edge 5-6, which lies on no chain and not inside the domain [ids 2 5 "
            "6] at (2, 0.25), (2, 0.75)\n"
            "covered_exterior: triangle 2 ends at edge 6-4, which lies on no chain and not inside the domain [ids 2 6 "
            "4] at (2, 0.75), (0.5, 0.25)\n"
            "area_mismatch: the triangles' areas sum to 1.375, the area within the boundary is 1; the exact "
            "difference rounds to 0.375\n");
}

TEST(Violations, of_boundary_edges_on_one_line) {
  EXPECT_EQ(said_about(square_and({{0.5, 0}, {0.5, -1}}, loose(0, 5, 4))),
            "overlap: boundary edges 0-1 and 4-0 intersect: the ends of each lie on sides 0, 0 and 0, 0 of the other "
            "[ids 0 1 4 0] at (0, 0), (1, 0), (0.5, 0), (0, 0)\n"
            "overlap: boundary edges 0-1 and 5-4 intersect: the ends of each lie on sides -1, 0 and 1, -1 of the "
            "other [ids 0 1 5 4] at (0, 0), (1, 0), (0.5, -1), (0.5, 0)\n"
            "covered_exterior: triangle 2 ends at edge 0-5, which lies on no chain and not inside the domain [ids 2 0 "
            "5] at (0, 0), (0.5, -1)\n"
            "covered_exterior: triangle 2 ends at edge 4-0, which lies on no chain and not inside the domain [ids 2 4 "
            "0] at (0.5, 0), (0, 0)\n"
            "covered_exterior: triangle 2 ends at edge 5-4, which lies on no chain and not inside the domain [ids 2 5 "
            "4] at (0.5, -1), (0.5, 0)\n"
            "area_mismatch: the triangles' areas sum to 1.25, the area within the boundary is 1; the exact difference "
            "rounds to 0.25\n")
      << "the shorter edge ends inside";
  EXPECT_EQ(said_about(square_and({{-1, 0}, {-1, -1}}, loose(0, 4, 5))),
            "covered_exterior: triangle 2 ends at edge 0-4, which lies on no chain and not inside the domain [ids 2 0 "
            "4] at (0, 0), (-1, 0)\n"
            "covered_exterior: triangle 2 ends at edge 4-5, which lies on no chain and not inside the domain [ids 2 4 "
            "5] at (-1, 0), (-1, -1)\n"
            "covered_exterior: triangle 2 ends at edge 5-0, which lies on no chain and not inside the domain [ids 2 5 "
            "0] at (-1, -1), (0, 0)\n"
            "area_mismatch: the triangles' areas sum to 1.5, the area within the boundary is 1; the exact difference "
            "rounds to 0.5\n")
      << "away from each other: no overlap";
  EXPECT_EQ(said_about(square_and({{0.25, 0}, {0.75, 0}, {0.5, -1}}, loose(4, 6, 5))),
            "overlap: boundary edges 0-1 and 4-6 intersect: the ends of each lie on sides 0, -1 and -1, 1 of the "
            "other [ids 0 1 4 6] at (0, 0), (1, 0), (0.25, 0), (0.5, -1)\n"
            "overlap: boundary edges 0-1 and 5-4 intersect: the ends of each lie on sides 0, 0 and 0, 0 of the other "
            "[ids 0 1 5 4] at (0, 0), (1, 0), (0.75, 0), (0.25, 0)\n"
            "overlap: boundary edges 0-1 and 6-5 intersect: the ends of each lie on sides -1, 0 and 1, -1 of the "
            "other [ids 0 1 6 5] at (0, 0), (1, 0), (0.5, -1), (0.75, 0)\n"
            "covered_exterior: triangle 2 ends at edge 4-6, which lies on no chain and not inside the domain [ids 2 4 "
            "6] at (0.25, 0), (0.5, -1)\n"
            "covered_exterior: triangle 2 ends at edge 5-4, which lies on no chain and not inside the domain [ids 2 5 "
            "4] at (0.75, 0), (0.25, 0)\n"
            "covered_exterior: triangle 2 ends at edge 6-5, which lies on no chain and not inside the domain [ids 2 6 "
            "5] at (0.5, -1), (0.75, 0)\n"
            "area_mismatch: the triangles' areas sum to 1.25, the area within the boundary is 1; the exact difference "
            "rounds to 0.25\n")
      << "no common end";
}

TEST(Violations, of_a_vertex_with_several_fans) {
  EXPECT_EQ(said_about_file(square_in_eight_without({1, 3, 5, 7})),
            "uncovered_domain: no triangle on the left of edge 1-6 of segment 2, where the domain is [ids 1 6 2] at "
            "(4, 0), (2, 2)\n"
            "uncovered_domain: no triangle on the left of edge 3-6 of segment 5, where the domain is [ids 3 6 5] at "
            "(0, 4), (2, 2)\n"
            "uncovered_domain: no triangle on the right of edge 4-6 of segment 6, where the domain is [ids 4 6 6] at "
            "(2, 0), (2, 2)\n"
            "uncovered_domain: no triangle on the left of edge 6-5 of segment 6, where the domain is [ids 6 5 6] at "
            "(2, 2), (2, 4)\n"
            "uncovered_domain: edge 7-6 of triangle 1 has no neighbour although it lies inside the domain and on no "
            "segment [ids 1 7 6] at (4, 2), (2, 2)\n"
            "uncovered_domain: edge 8-6 of triangle 3 has no neighbour although it lies inside the domain and on no "
            "segment [ids 3 8 6] at (0, 2), (2, 2)\n"
            "covered_exterior: triangle 1 on the right of edge 1-6 of segment 2, outside the domain [ids 1 1 6 2] at "
            "(4, 0), (2, 2)\n"
            "covered_exterior: triangle 3 on the right of edge 3-6 of segment 5, outside the domain [ids 3 3 6 5] at "
            "(0, 4), (2, 2)\n"
            "covered_exterior: triangle 1 ends at edge 1-7, which lies on no chain and not inside the domain [ids 1 1 "
            "7] at (4, 0), (4, 2)\n"
            "covered_exterior: triangle 3 ends at edge 3-8, which lies on no chain and not inside the domain [ids 3 3 "
            "8] at (0, 4), (0, 2)\n"
            "broken_segment: segment 1 from point 4 to 1 is not covered by a chain of mesh edges within the rounding "
            "distance [ids 1] at (2, 0), (4, 0)\n"
            "broken_segment: segment 4 from point 5 to 3 is not covered by a chain of mesh edges within the rounding "
            "distance [ids 4] at (2, 4), (0, 4)\n"
            "chain_off_segment: vertex 6 on segment 2: its squared distance from the segment is 4, more than the "
            "square of 1.7763568394002505e-15 [ids 6 2] at (2, 2)\n"
            "chain_off_segment: vertex 6 on segment 5: its squared distance from the segment is 4, more than the "
            "square of 0 [ids 6 5] at (2, 2)\n")
      << "four fans";
  EXPECT_EQ(said_about(square_and({{0.5, 2}, {1.5, 2}}, loose(2, 5, 4))),
            "covered_exterior: triangle 2 ends at edge 2-5, which lies on no chain and not inside the domain [ids 2 2 "
            "5] at (1, 1), (1.5, 2)\n"
            "covered_exterior: triangle 2 ends at edge 4-2, which lies on no chain and not inside the domain [ids 2 4 "
            "2] at (0.5, 2), (1, 1)\n"
            "covered_exterior: triangle 2 ends at edge 5-4, which lies on no chain and not inside the domain [ids 2 5 "
            "4] at (1.5, 2), (0.5, 2)\n"
            "area_mismatch: the triangles' areas sum to 1.5, the area within the boundary is 1; the exact difference "
            "rounds to 0.5\n")
      << "two fans that touch";
}

TEST(Violations, of_a_closed_fan_and_a_triangle_at_its_vertex) {
  Case c = square_in_eight_without({});
  c.mesh.points.append(std::vector<Point>{{3, 2.25}, {3, 2.5}});
  c.mesh.triangles.push_back(loose(6, 9, 10));
  EXPECT_EQ(said_about_file(c),
            "non_manifold_vertex: vertex 6 has 9 triangles, but a walk around it from its boundary edges reaches 1 "
            "[ids 6] at (2, 2)\n"
            "overlap: the triangles cover the left of boundary edge 6-9 2 times and its right 1 times [ids 8 6 9] at "
            "(2, 2), (3, 2.25)\n"
            "overlap: the triangles cover the left of boundary edge 9-10 2 times and its right 1 times [ids 8 9 10] "
            "at (3, 2.25), (3, 2.5)\n"
            "overlap: the triangles cover the left of boundary edge 10-6 2 times and its right 1 times [ids 8 10 6] "
            "at (3, 2.5), (2, 2)\n"
            "area_mismatch: the triangles' areas sum to 16.125, the area within the boundary is 16; the exact "
            "difference rounds to 0.125\n");
}

TEST(Violations, of_a_closed_fan_and_a_triangle_at_vertex_0) {
  Case c = testing::square_in_two();
  c.pslg.segments.push_back({0, 2, 0});
  c.mesh = testing::mesh_of({{0.5, 0.5}, {0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.75, 0.5}, {0.75, 0.625}},
                            {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {0, 5, 6}});
  c.mesh.origin.clear();
  EXPECT_EQ(said_about_file(c),
            "non_manifold_vertex: vertex 0 has 5 triangles, but a walk around it from its boundary edges reaches 1 "
            "[ids 0] at (0.5, 0.5)\n"
            "overlap: the triangles cover the left of boundary edge 0-5 2 times and its right 1 times [ids 4 0 5] at "
            "(0.5, 0.5), (0.75, 0.5)\n"
            "overlap: the triangles cover the left of boundary edge 5-6 2 times and its right 1 times [ids 4 5 6] at "
            "(0.75, 0.5), (0.75, 0.625)\n"
            "overlap: the triangles cover the left of boundary edge 6-0 2 times and its right 1 times [ids 4 6 0] at "
            "(0.75, 0.625), (0.5, 0.5)\n"
            "area_mismatch: the triangles' areas sum to 1.015625, the area within the boundary is 1; the exact "
            "difference rounds to 0.015625\n")
      << "the chain of segment 4 goes through the fan that is closed";
}

TEST(Violations, of_two_triangles_on_one_side_of_an_edge) {
  EXPECT_EQ(said_about(square_and({{0.25, 0.5}}, loose(0, 1, 4))),
            "non_manifold_edge: edge 0-1 has 2 triangles, more than one on a side [ids 0 2] at (0, 0), (1, 0)\n"
            "non_manifold_vertex: vertex 0 has two triangles on the left of its edge to vertex 1 [ids 0 1] at (0, 0)\n"
            "overlap: boundary edges 0-1 and 0-1 intersect: the ends of each lie on sides 0, 0 and 0, 0 of the other "
            "[ids 0 1 0 1] at (0, 0), (1, 0), (0, 0), (1, 0)\n"
            "uncovered_domain: edge 1-4 of triangle 2 has no neighbour although it lies inside the domain and on no "
            "segment [ids 2 1 4] at (1, 0), (0.25, 0.5)\n"
            "uncovered_domain: edge 4-0 of triangle 2 has no neighbour although it lies inside the domain and on no "
            "segment [ids 2 4 0] at (0.25, 0.5), (0, 0)\n"
            "covered_exterior: triangle 0 ends at edge 0-1, which lies on no chain and not inside the domain [ids 0 0 "
            "1] at (0, 0), (1, 0)\n"
            "area_mismatch: the triangles' areas sum to 1.25, the area within the boundary is 1; the exact difference "
            "rounds to 0.25\n");
}

TEST(Violations, of_neighbours) {
  Case c = testing::square_in_eight();
  c.mesh.triangles[3].n = {no_index, no_index, no_index};
  EXPECT_EQ(said_about(c),
            "wrong_neighbour: triangle 2 lists 3 as its neighbour across edge 7-6, but that triangle does not list it "
            "there [ids 2 3] at (4, 2), (2, 2)\n"
            "wrong_neighbour: triangle 4 lists 3 as its neighbour across edge 6-2, but that triangle does not list it "
            "there [ids 4 3] at (2, 2), (4, 4)\n");
  c = testing::square_in_eight();
  std::swap(c.mesh.triangles[3].n[0], c.mesh.triangles[3].n[1]);
  EXPECT_EQ(said_about(c),
            "wrong_neighbour: triangle 2 lists 3 as its neighbour across edge 7-6, but that triangle does not list it "
            "there [ids 2 3] at (4, 2), (2, 2)\n"
            "wrong_neighbour: triangle 3 lists 2 as its neighbour across edge 2-6, but that triangle does not list it "
            "there [ids 3 2] at (4, 4), (2, 2)\n"
            "wrong_neighbour: triangle 3 lists 4 as its neighbour across edge 6-7, but that triangle does not list it "
            "there [ids 3 4] at (2, 2), (4, 2)\n"
            "wrong_neighbour: triangle 4 lists 3 as its neighbour across edge 6-2, but that triangle does not list it "
            "there [ids 4 3] at (2, 2), (4, 4)\n");
  c = testing::square_in_eight();  // triangles 0 and 2 list each other, but have only vertex 6 in common
  c.mesh.triangles[0].n[0] = 2;
  c.mesh.triangles[2].n[1] = 0;
  EXPECT_EQ(said_about(c),
            "wrong_neighbour: triangle 0 lists 2 as its neighbour across edge 4-6, but that triangle does not list it "
            "there [ids 0 2] at (2, 0), (2, 2)\n"
            "wrong_neighbour: triangle 1 lists 2 as its neighbour across edge 1-6, but that triangle does not list it "
            "there [ids 1 2] at (4, 0), (2, 2)\n"
            "wrong_neighbour: triangle 1 lists 0 as its neighbour across edge 6-4, but that triangle does not list it "
            "there [ids 1 0] at (2, 2), (2, 0)\n"
            "wrong_neighbour: triangle 2 lists 0 as its neighbour across edge 6-1, but that triangle does not list it "
            "there [ids 2 0] at (2, 2), (4, 0)\n");
  c = testing::square_in_two();
  for (Triangle& t : c.mesh.triangles) t.n = {no_index, no_index, no_index};
  EXPECT_EQ(said_about(c),
            "wrong_neighbour: triangles 1 and 0 share edge 0-2 but are not neighbours [ids 1 0] at (0, 0), (1, 1)\n");
}

TEST(Violations, of_a_missing_triangle) {
  EXPECT_EQ(said_about_file(square_in_eight_without({2})),
            "uncovered_domain: edge 1-6 of triangle 1 has no neighbour although it lies inside the domain and on no "
            "segment [ids 1 1 6] at (4, 0), (2, 2)\n"
            "uncovered_domain: edge 6-7 of triangle 2 has no neighbour although it lies inside the domain and on no "
            "segment [ids 2 6 7] at (2, 2), (4, 2)\n"
            "covered_exterior: triangle 2 ends at edge 7-2, which lies on no chain and not inside the domain [ids 2 7 "
            "2] at (4, 2), (4, 4)\n"
            "broken_segment: segment 2 from point 1 to 2 is not covered by a chain of mesh edges within the rounding "
            "distance [ids 2] at (4, 0), (4, 4)\n");
  Case c = testing::square_in_two();
  c.mesh.triangles.clear();
  c.mesh.constrained_edges.clear();
  EXPECT_EQ(said_about_file(c),
            "uncovered_domain: the face of the domain on the left of segment 0 has no triangle at any of its segments "
            "[ids 0] at (0, 0), (1, 0)\n"
            "missing_input_vertex: input point 0 of the domain has no triangle [ids 0] at (0, 0)\n"
            "missing_input_vertex: input point 1 of the domain has no triangle [ids 1] at (1, 0)\n"
            "missing_input_vertex: input point 2 of the domain has no triangle [ids 2] at (1, 1)\n"
            "missing_input_vertex: input point 3 of the domain has no triangle [ids 3] at (0, 1)\n"
            "broken_segment: segment 0 from point 0 to 1 is not covered by a chain of mesh edges within the rounding "
            "distance [ids 0] at (0, 0), (1, 0)\n"
            "broken_segment: segment 1 from point 1 to 2 is not covered by a chain of mesh edges within the rounding "
            "distance [ids 1] at (1, 0), (1, 1)\n"
            "broken_segment: segment 2 from point 2 to 3 is not covered by a chain of mesh edges within the rounding "
            "distance [ids 2] at (1, 1), (0, 1)\n"
            "broken_segment: segment 3 from point 3 to 0 is not covered by a chain of mesh edges within the rounding "
            "distance [ids 3] at (0, 1), (0, 0)\n");
}

TEST(Violations, of_the_exterior_and_of_holes) {
  EXPECT_EQ(said_about(square_and({{2, 0.5}}, loose(1, 4, 2))),
            "wrong_neighbour: triangles 0 and 2 share edge 1-2 but are not neighbours [ids 0 2] at (1, 0), (1, 1)\n"
            "covered_exterior: triangle 2 on the right of edge 1-2 of segment 1, outside the domain [ids 2 1 2 1] at "
            "(1, 0), (1, 1)\n"
            "covered_exterior: triangle 2 ends at edge 1-4, which lies on no chain and not inside the domain [ids 2 1 "
            "4] at (1, 0), (2, 0.5)\n"
            "covered_exterior: triangle 2 ends at edge 4-2, which lies on no chain and not inside the domain [ids 2 4 "
            "2] at (2, 0.5), (1, 1)\n"
            "area_mismatch: the triangles' areas sum to 1.5, the area within the boundary is 1; the exact difference "
            "rounds to 0.5\n");
  Case c = square_in_eight_without({});
  c.pslg.holes = {{1, 2.5}, {1.75, 0.25}, {2.25, 0.5}};
  EXPECT_EQ(said_about_file(c),
            "covered_exterior: triangle 0 ends at edge 0-4, which lies on no chain and not inside the domain [ids 0 0 "
            "4] at (0, 0), (2, 0)\n"
            "covered_exterior: triangle 2 ends at edge 1-7, which lies on no chain and not inside the domain [ids 2 1 "
            "7] at (4, 0), (4, 2)\n"
            "covered_exterior: triangle 4 ends at edge 2-5, which lies on no chain and not inside the domain [ids 4 2 "
            "5] at (4, 4), (2, 4)\n"
            "covered_exterior: triangle 6 ends at edge 3-8, which lies on no chain and not inside the domain [ids 6 3 "
            "8] at (0, 4), (0, 2)\n"
            "covered_exterior: triangle 1 ends at edge 4-1, which lies on no chain and not inside the domain [ids 1 4 "
            "1] at (2, 0), (4, 0)\n"
            "covered_exterior: triangle 5 ends at edge 5-3, which lies on no chain and not inside the domain [ids 5 5 "
            "3] at (2, 4), (0, 4)\n"
            "covered_exterior: triangle 3 ends at edge 7-2, which lies on no chain and not inside the domain [ids 3 7 "
            "2] at (4, 2), (4, 4)\n"
            "covered_exterior: triangle 7 ends at edge 8-0, which lies on no chain and not inside the domain [ids 7 8 "
            "0] at (0, 2), (0, 0)\n"
            "covered_exterior: triangle 0 contains the seed of hole 1 [ids 0 1] at (1.75, 0.25)\n"
            "covered_exterior: triangle 1 contains the seed of hole 2 [ids 1 2] at (2.25, 0.5)\n"
            "covered_exterior: triangle 6 contains the seed of hole 0 [ids 6 0] at (1, 2.5)\n"
            "area_mismatch: the triangles' areas sum to 16, the area within the boundary is 0; the exact difference "
            "rounds to 16\n");
}

TEST(Violations, of_input_points) {
  Case c = testing::square_in_two();
  c.pslg.points[2] = {1, 1.5};
  c.pslg.points.push_back({0.5, 0.25});
  c.mesh.points.append(std::vector<Point>{{0.5, 0.25}, {7, 8}});
  c.mesh.origin.resize(6, input_vertex);
  EXPECT_EQ(said_about(c),
            "missing_input_vertex: input point 2 was moved or renumbered: vertex 2 is (1, 1) [ids 2] at (1, 1.5)\n"
            "missing_input_vertex: input point 4 of the domain has no triangle [ids 4] at (0.5, 0.25)\n"
            "unused_vertex: vertex 5 has no triangle and is not an input point [ids 5] at (7, 8)\n"
            "wrong_origin: vertex 5 is listed as an input point but is in the interior [ids 5] at (7, 8)\n");
  c = testing::square_in_two();
  c.pslg.points.push_back({0.5, 0.25});
  EXPECT_EQ(said_about(c),
            "missing_input_vertex: input point 4 of the domain is not a vertex of the mesh [ids 4] at (0.5, 0.25)\n");
}

TEST(Violations, of_points_that_stand_twice_in_a_file) {
  const std::vector<Point> points{{3, 3}, {0, 0}, {1, 0}, {1, 1}, {0, 1}, {3, 3}};
  Case c = testing::square_in_two();
  c.mesh = testing::mesh_of(points, {{1, 2, 3}, {1, 3, 4}});
  c.mesh.origin.clear();
  c.pslg.points.push_back({3, 3});
  EXPECT_EQ(said_about_file(c), "unused_vertex: vertex 5 has no triangle and is not an input point [ids 5] at (3, 3)\n")
      << "outside the domain, the first is the input point";
  c.mesh = testing::mesh_of({{0, 0}, {1, 0}, {0, 1}, {1, 1}, {1, 1}}, {{0, 1, 4}, {0, 4, 2}});
  c.mesh.origin.clear();
  c.pslg.points.pop_back();
  EXPECT_EQ(said_about_file(c), "unused_vertex: vertex 3 has no triangle and is not an input point [ids 3] at (1, 1)\n")
      << "in the domain, the one with triangles is the input point";
}

TEST(Violations, of_a_point_that_stands_twice_in_a_file_with_triangles_at_both_places) {
  Case c = testing::square_in_two();
  c.mesh = testing::mesh_of({{1, 1}, {0, 0}, {1, 0}, {0, 1}, {1, 1}}, {{1, 2, 0}, {1, 4, 3}});
  c.mesh.origin.clear();
  std::string broken;
  for (const Violation& violation : check(c, no_angle_bound(), {.foreign = true}).violations)
    if (violation.kind == ViolationKind::broken_segment) broken += violation.message() + '\n';
  EXPECT_EQ(broken,
            "broken_segment: segment 2 from point 2 to 3 is not covered by a chain of mesh edges within the rounding "
            "distance [ids 2] at (1, 1), (0, 1)\n")
      << "the first is the input point";
}

TEST(Violations, of_input_that_cannot_be_used_are_the_only_ones) {
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (const std::size_t point : {0, 2, 3}) {
      Case c = testing::square_in_two();
      c.pslg.points[point].x = value;
      const Certificate certificate = check(c);
      ASSERT_EQ(certificate.violations.size(), 1u) << said(certificate);
      EXPECT_EQ(certificate.violations[0].witness.text(),
                "point " + std::to_string(point) + " of the input is not finite");
      EXPECT_EQ(certificate.angle_histogram, std::vector<std::uint64_t>(18, 0)) << "no angle was measured";
    }
}

TEST(Violations, of_chains_off_their_segments) {
  Case c = testing::square_in_eight();
  c.mesh.points[6].x = 2 + 0x1p-30;
  EXPECT_EQ(said_about(c),
            "chain_off_segment: vertex 6 on segment 6: its squared distance from the segment is "
            "1/1152921504606846976, more than the square of 8.881784197001252e-16 [ids 6 6] at (2.0000000009313226, "
            "2)\n"
            "not_delaunay: edge 6-0 of triangles 0 and 7 is not locally Delaunay: vertex 8 (0, 2) lies inside the "
            "circumcircle, in-circle determinant 2147483649/288230376151711744 [ids 6 0 0 7] at (2.0000000009313226, "
            "2), (0, 0)\n"
            "not_delaunay: edge 3-6 of triangles 5 and 6 is not locally Delaunay: vertex 8 (0, 2) lies inside the "
            "circumcircle, in-circle determinant 2147483649/288230376151711744 [ids 3 6 5 6] at (0, 4), "
            "(2.0000000009313226, 2)\n");
  c.mesh.points[6].x = 2.5;
  EXPECT_EQ(said_about(c),
            "chain_off_segment: vertex 6 on segment 6: its squared distance from the segment is 1/4, more than the "
            "square of 8.881784197001252e-16 [ids 6 6] at (2.5, 2)\n"
            "not_delaunay: edge 6-0 of triangles 0 and 7 is not locally Delaunay: vertex 8 (0, 2) lies inside the "
            "circumcircle, in-circle determinant 5 [ids 6 0 0 7] at (2.5, 2), (0, 0)\n"
            "not_delaunay: edge 3-6 of triangles 5 and 6 is not locally Delaunay: vertex 8 (0, 2) lies inside the "
            "circumcircle, in-circle determinant 5 [ids 3 6 5 6] at (0, 4), (2.5, 2)\n")
      << "the chain is listed as constrained";
  c.mesh.constrained_edges.resize(8);
  EXPECT_EQ(said_about(c),
            "broken_segment: segment 6 from point 4 to 5 is not covered by a chain of mesh edges within the rounding "
            "distance [ids 6] at (2, 0), (2, 4)\n"
            "wrong_vertex_marker: vertex 4 has marker 9 instead of 1 or 5 [ids 4] at (2, 0)\n"
            "wrong_vertex_marker: vertex 5 has marker 9 instead of 1 [ids 5] at (2, 4)\n"
            "wrong_vertex_marker: vertex 6 has marker 9 instead of 0 [ids 6] at (2.5, 2)\n"
            "wrong_origin: vertex 6 is listed as on segment 6 but is in the interior [ids 6] at (2.5, 2)\n"
            "not_delaunay: edge 6-0 of triangles 0 and 7 is not locally Delaunay: vertex 8 (0, 2) lies inside the "
            "circumcircle, in-circle determinant 5 [ids 6 0 0 7] at (2.5, 2), (0, 0)\n"
            "not_delaunay: edge 3-6 of triangles 5 and 6 is not locally Delaunay: vertex 8 (0, 2) lies inside the "
            "circumcircle, in-circle determinant 5 [ids 3 6 5 6] at (0, 4), (2.5, 2)\n")
      << "nothing says that there should be a chain";
}

TEST(Violations, of_a_segment_whose_ends_are_no_vertices) {
  Case c = testing::square_in_two();
  c.pslg.points.insert(c.pslg.points.end(), {{0.25, 0.5}, {0.75, 0.5}});
  c.pslg.segments.insert(c.pslg.segments.end(), {{4, 0, 0}, {0, 5, 0}});
  c.mesh.constrained_edges.clear();
  c.mesh.origin.clear();
  EXPECT_EQ(said_about_file(c),
            "missing_input_vertex: input point 4 of the domain is not a vertex of the mesh [ids 4] at (0.25, 0.5)\n"
            "missing_input_vertex: input point 5 of the domain is not a vertex of the mesh [ids 5] at (0.75, 0.5)\n"
            "broken_segment: segment 4 from point 4 to 0 is not covered by a chain of mesh edges within the rounding "
            "distance [ids 4] at (0.25, 0.5), (0, 0)\n"
            "broken_segment: segment 5 from point 0 to 5 is not covered by a chain of mesh edges within the rounding "
            "distance [ids 5] at (0, 0), (0.75, 0.5)\n");
}

TEST(Violations, of_a_bent_chain_whose_edges_are_not_delaunay) {
  // No file says that 0-6 and 6-3 are constrained. They are not locally Delaunay, so they must be.
  Case c;
  c.pslg.points = {{0, 0}, {7, -1}, {9, -1}, {16, 0}, {9, 1}, {7, 1}};
  c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 4, 0}, {4, 5, 0}, {5, 0, 0}, {0, 3, 0}};
  std::vector<Point> points = c.pslg.points;
  points.push_back({8, 0.25});
  c.mesh = testing::mesh_of(points, {{0, 1, 6}, {1, 2, 6}, {2, 3, 6}, {3, 4, 6}, {4, 5, 6}, {5, 0, 6}});
  c.mesh.origin.clear();
  EXPECT_EQ(said_about_file(c),
            "chain_off_segment: vertex 6 on segment 6: its squared distance from the segment is 1/16, more than the "
            "square of 0 [ids 6 6] at (8, 0.25)\n");
}

TEST(Violations, of_one_vertex_of_a_chain) {
  Case c;  // a triangle with two vertices on its lower side, of which one lies below it
  c.pslg.points = {{0, 0}, {3, 0}, {1.5, 3}};
  c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 0, 0}};
  c.mesh = testing::mesh_of({{0, 0}, {3, 0}, {1.5, 3}, {1, 0}, {2, -0x1p-20}}, {{0, 3, 2}, {3, 4, 2}, {4, 1, 2}});
  c.mesh.origin.clear();
  EXPECT_EQ(said_about_file(c),
            "chain_off_segment: vertex 4 on segment 0: its squared distance from the segment is 1/1099511627776, more "
            "than the square of 0 [ids 4 0] at (2, -9.5367431640625e-07)\n");
}

TEST(Violations, of_segments_that_bend_in_files_without_constrained_edges) {
  // The checker takes the edges of the boundary, and those that are not locally Delaunay, for the constrained edges.
  Case c = square_in_eight_without({});
  c.mesh.points[7].x = 4.5;
  c.mesh.points[6].x = 2.5;
  EXPECT_EQ(said_about_file(c),
            "broken_segment: segment 6 from point 4 to 5 is not covered by a chain of mesh edges within the rounding "
            "distance [ids 6] at (2, 0), (2, 4)\n"
            "chain_off_segment: vertex 7 on segment 2: its squared distance from the segment is 1/4, more than the "
            "square of 1.7763568394002505e-15 [ids 7 2] at (4.5, 2)\n"
            "not_delaunay: edge 6-0 of triangles 0 and 7 is not locally Delaunay: vertex 8 (0, 2) lies inside the "
            "circumcircle, in-circle determinant 5 [ids 6 0 0 7] at (2.5, 2), (0, 0)\n"
            "not_delaunay: edge 3-6 of triangles 5 and 6 is not locally Delaunay: vertex 8 (0, 2) lies inside the "
            "circumcircle, in-circle determinant 5 [ids 3 6 5 6] at (0, 4), (2.5, 2)\n");
  c = testing::square_in_two();
  c.pslg.points = {{0, 0}, {8, -1}, {16, 0}, {8, 1}};
  c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}, {0, 2, 0}};
  c.mesh = testing::mesh_of({{0, 0}, {8, -1}, {16, 0}, {8, 1}, {8, 0.5}}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  c.mesh.origin.clear();
  EXPECT_EQ(said_about_file(c),
            "broken_segment: segment 4 from point 0 to 2 is not covered by a chain of mesh edges within the rounding "
            "distance [ids 4] at (0, 0), (16, 0)\n");
}

TEST(Violations, of_the_hull) {
  Case c = testing::square_in_two();
  c.pslg.points.push_back({3, 0.5});
  c.mesh.points.push_back({3, 0.5});
  c.mesh.origin.push_back(input_vertex);
  Goal goal = no_angle_bound();
  goal.convex_hull = true;
  EXPECT_EQ(said_about(c, goal),
            "uncovered_domain: no triangle on the right of edge 1-2 of segment 1, where the domain is [ids 1 2 1] at "
            "(1, 0), (1, 1)\n"
            "uncovered_domain: the face of the domain on the right of segment 1 has no triangle at any of its "
            "segments [ids 1] at (1, 0), (1, 1)\n"
            "missing_input_vertex: input point 4 of the domain has no triangle [ids 4] at (3, 0.5)\n"
            "broken_segment: the hull edge from point 1 to 4 is not covered by a chain of mesh edges within the "
            "rounding distance [ids 1 4] at (1, 0), (3, 0.5)\n"
            "broken_segment: the hull edge from point 4 to 2 is not covered by a chain of mesh edges within the "
            "rounding distance [ids 4 2] at (3, 0.5), (1, 1)\n"
            "wrong_edge_marker: constrained edge 1 (1-2) has marker 1 instead of 0 [ids 1 1 2] at (1, 0), (1, 1)\n");
}

TEST(Violations, of_constrained_edges) {
  Case c = testing::square_in_two();
  c.mesh.constrained_edges = {{1, 0, 2, 7}, {2, 1, no_index, 1}, {2, 3, 2, 1},
                              {3, 2, 2, 1}, {0, 2, no_index, 0}, {1, 3, 0, 1}};
  EXPECT_EQ(said_about(c),
            "wrong_constrained_edge: constrained edge 0 (1-0) lists segment 2 but is part of 0 [ids 0 1 0] at (1, 0), "
            "(0, 0)\n"
            "wrong_constrained_edge: constrained edge 1 (2-1) lists segment none but is part of 1 [ids 1 2 1] at (1, "
            "1), (1, 0)\n"
            "wrong_constrained_edge: constrained edge 3 (3-2) is listed twice [ids 3 3 2] at (0, 1), (1, 1)\n"
            "wrong_constrained_edge: constrained edge 4 (0-2) is listed as constrained but is part of no segment [ids "
            "4 0 2] at (0, 0), (1, 1)\n"
            "wrong_constrained_edge: constrained edge 5 (1-3) is listed as constrained but is no edge of the mesh "
            "[ids 5 1 3] at (1, 0), (0, 1)\n"
            "missing_constrained_edge: edge 0-3 is part of segment 3 but is not listed as constrained [ids 0 3 3] at "
            "(0, 0), (0, 1)\n"
            "wrong_edge_marker: constrained edge 0 (1-0) has marker 7 instead of 1 [ids 0 1 0] at (1, 0), (0, 0)\n");
  EXPECT_EQ(said_about(c, no_angle_bound(), {.foreign = true}),
            "wrong_constrained_edge: constrained edge 0 (1-0) lists segment 2 but is part of 0 [ids 0 1 0] at (1, 0), "
            "(0, 0)\n"
            "wrong_constrained_edge: constrained edge 3 (3-2) is listed twice [ids 3 3 2] at (0, 1), (1, 1)\n"
            "wrong_constrained_edge: constrained edge 4 (0-2) is listed as constrained but is part of no segment [ids "
            "4 0 2] at (0, 0), (1, 1)\n"
            "wrong_constrained_edge: constrained edge 5 (1-3) is listed as constrained but is no edge of the mesh "
            "[ids 5 1 3] at (1, 0), (0, 1)\n"
            "missing_constrained_edge: edge 0-3 is part of segment 3 but is not listed as constrained [ids 0 3 3] at "
            "(0, 0), (0, 1)\n"
            "wrong_edge_marker: constrained edge 0 (1-0) has marker 7 instead of 1 [ids 0 1 0] at (1, 0), (0, 0)\n");
}

TEST(Violations, of_markers_of_vertices) {
  Case c = testing::square_in_eight();
  c.mesh.point_markers.clear();
  c.mesh.point_markers.append(std::vector<int>{5, 8, 7, 7, 7, 7, 7, 0, 1});
  EXPECT_EQ(said_about(c),
            "wrong_vertex_marker: vertex 0 has marker 5 instead of 21 [ids 0] at (0, 0)\n"
            "wrong_vertex_marker: vertex 1 has marker 8 instead of 1 [ids 1] at (4, 0)\n"
            "wrong_vertex_marker: vertex 2 has marker 7 instead of 1 [ids 2] at (4, 4)\n"
            "wrong_vertex_marker: vertex 3 has marker 7 instead of 1 [ids 3] at (0, 4)\n"
            "wrong_vertex_marker: vertex 4 has marker 7 instead of 1 or 5 or 9 [ids 4] at (2, 0)\n"
            "wrong_vertex_marker: vertex 5 has marker 7 instead of 1 or 9 [ids 5] at (2, 4)\n"
            "wrong_vertex_marker: vertex 6 has marker 7 instead of 9 [ids 6] at (2, 2)\n"
            "wrong_vertex_marker: vertex 7 has marker 0 instead of 1 [ids 7] at (4, 2)\n");
}

TEST(Violations, of_markers_from_segments_outside_the_domain) {
  // Other meshers mark the ends of such segments before they remove them.
  Case c = testing::square_in_two();
  c.pslg.points.push_back({3, 0});
  c.mesh.points.push_back({3, 0});
  c.mesh.origin.push_back(input_vertex);
  c.pslg.segments.push_back({1, 4, 6});
  c.mesh.point_markers.append(std::vector<int>{1, 6, 1, 1, 6});
  EXPECT_EQ(said_about_file(c), "");
  EXPECT_EQ(said_about(c), "wrong_vertex_marker: vertex 1 has marker 6 instead of 1 [ids 1] at (1, 0)\n");
  c.pslg.segments.back().marker = 1;
  c.mesh.point_markers[4] = 1;
  c.pslg.segments[0].marker = c.pslg.segments[1].marker = 7;
  c.pslg.has_segment_markers = true;
  c.mesh.constrained_edges[0].marker = c.mesh.constrained_edges[1].marker = 7;
  for (const Index v : {0, 1, 2}) c.mesh.point_markers[v] = v == 1 ? 1 : 7;
  EXPECT_EQ(said_about_file(c), "") << "marker 1 of the segment outside";
}

TEST(Violations, of_origins) {
  Case c = testing::square_in_two();
  c.pslg.segments.clear();
  c.pslg.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  c.mesh.constrained_edges = {{0, 1, no_index, 1}, {1, 2, no_index, 1}, {2, 3, no_index, 1}, {3, 0, no_index, 1}};
  c.mesh.origin.clear();
  c.mesh.origin.append(std::vector<Index>{hull_vertex, interior_vertex, origin_on_segment(3), input_vertex});
  EXPECT_EQ(said_about(c),
            "wrong_origin: vertex 0 is listed as on the hull but is an input point [ids 0] at (0, 0)\n"
            "wrong_origin: vertex 1 is listed as in the interior but is an input point [ids 1] at (1, 0)\n"
            "wrong_origin: vertex 2 is listed as on segment 3 but is an input point [ids 2] at (1, 1)\n");
  c = testing::square_in_eight();
  c.mesh.origin[6] = interior_vertex;
  c.mesh.origin[7] = hull_vertex;
  c.mesh.origin[8] = origin_on_segment(4);
  EXPECT_EQ(said_about(c),
            "wrong_origin: vertex 6 is listed as in the interior but is on segment 6 [ids 6] at (2, 2)\n"
            "wrong_origin: vertex 7 is listed as on the hull but is on segment 2 [ids 7] at (4, 2)\n"
            "wrong_origin: vertex 8 is listed as on segment 4 but is on segment 5 [ids 8] at (0, 2)\n");
}

TEST(Violations, of_regions) {
  Case c = testing::square_in_eight();
  c.mesh.region[2] = 0;
  c.mesh.region[5] = no_index;
  EXPECT_EQ(said_about(c),
            "wrong_region: triangle 2 has the region attribute 7, but its face has 8, that of region 1 [ids 2 "
            "0] at (4, 0), (4, 2), (2, 2)\n"
            "wrong_region: triangle 5 has no region, but its face has 7, that of region 0 [ids 5 none] at (2, "
            "4), (0, 4), (2, 2)\n");
  c.pslg.regions.pop_back();
  EXPECT_EQ(said_about(c),
            "wrong_region: triangle 1 has the region attribute 8, but its face has no region [ids 1 1] at (2, 0), "
            "(4, 0), (2, 2)\n"
            "wrong_region: triangle 2 has the region attribute 7, but its face has no region [ids 2 0] at (4, 0), "
            "(4, 2), (2, 2)\n"
            "wrong_region: triangle 3 has the region attribute 8, but its face has no region [ids 3 1] at (4, 2), "
            "(4, 4), (2, 2)\n"
            "wrong_region: triangle 4 has the region attribute 8, but its face has no region [ids 4 1] at (4, 4), "
            "(2, 4), (2, 2)\n"
            "wrong_region: triangle 5 has no region, but its face has 7, that of region 0 [ids 5 none] at (2, "
            "4), (0, 4), (2, 2)\n")
      << "the right half belongs to no region";
}

TEST(Violations, of_attributes) {
  Case c = testing::square_in_two();
  const double nan = std::nan("");
  c.pslg.attributes_per_point = c.mesh.attributes_per_point = 2;
  c.pslg.point_attributes = {1, 2, 3, nan, nan, 6, 7, 8};
  c.mesh.point_attributes.append(std::vector<double>{1, 2, 3, nan, 5, nan, 7, 9});
  EXPECT_EQ(said_about(c),
            "wrong_attribute: attribute 0 of vertex 2 is 5 instead of nan [ids 2] at (1, 1)\n"
            "wrong_attribute: attribute 1 of vertex 2 is nan instead of 6 [ids 2] at (1, 1)\n"
            "wrong_attribute: attribute 1 of vertex 3 is 9 instead of 8 [ids 3] at (0, 1)\n");
  c.pslg.point_attributes.pop_back();
  EXPECT_EQ(said_about(c), "") << "an input with too few attributes says nothing about vertices";
}

TEST(Violations, of_attributes_that_a_file_has_and_the_input_has_not) {
  Case c = testing::square_in_two();
  c.mesh.attributes_per_point = 1;
  c.mesh.point_attributes.append(std::vector<double>{1, 2, 3, 4});
  EXPECT_EQ(said_about_file(c), "") << "results, say";
  EXPECT_EQ(said_about(c), "wrong_count: attributes of a point: 1 entries instead of 0\n");
  c.pslg.attributes_per_point = 2;
  c.pslg.point_attributes.assign(8, 1);
  EXPECT_EQ(said_about_file(c), "wrong_count: attributes of a point: 1 entries instead of 2\n");
}

TEST(Violations, of_arrays_and_ids) {
  Case c = testing::square_in_eight();
  c.mesh.origin.pop_back();
  c.mesh.region.pop_back();
  c.mesh.point_markers.pop_back();
  c.mesh.attributes_per_point = 1;
  c.mesh.constrained_edges[1].b = 9;
  c.mesh.constrained_edges[2].a = 9;
  c.mesh.constrained_edges[3].segment = 7;
  c.mesh.region[2] = 2;
  c.mesh.triangles[4].n[1] = 8;
  EXPECT_EQ(said_about(c),
            "index_out_of_range: triangle 4 has a neighbour that does not exist [ids 4 8]\n"
            "index_out_of_range: constrained edge 1 refers to a vertex that does not exist [ids 1 4 9]\n"
            "index_out_of_range: constrained edge 2 refers to a vertex that does not exist [ids 2 9 7]\n"
            "index_out_of_range: constrained edge 3 refers to a segment that does not exist [ids 3 7]\n"
            "index_out_of_range: triangle 2 lies in a region that does not exist [ids 2 2]\n"
            "wrong_count: origin of points: 8 entries instead of 9\n"
            "wrong_count: region of triangles: 7 entries instead of 8\n"
            "wrong_count: point markers: 8 entries instead of 9\n"
            "wrong_count: point attributes: 0 entries instead of 9\n"
            "wrong_count: attributes of a point: 1 entries instead of 0\n");
  c = testing::square_in_two();
  c.mesh.triangles[0].v[2] = 4;
  c.mesh.triangles[1].v[2] = 2;
  c.pslg.segments[1].a = 4;
  c.pslg.segments[3].b = 4;
  EXPECT_EQ(said_about(c),
            "index_out_of_range: segment 1 of the input refers to a point that does not exist [ids 1 4 2]\n"
            "index_out_of_range: segment 3 of the input refers to a point that does not exist [ids 3 3 4]\n"
            "index_out_of_range: triangle 0 refers to a vertex that does not exist (there are 4) [ids 0 0 1 4]\n"
            "degenerate_triangle: triangle 1 has two equal corners [ids 1 0 2 2] at (0, 0)\n");
  c = testing::square_in_two();
  const double infinity = std::numeric_limits<double>::infinity();
  c.mesh.points[1].y = infinity;
  c.pslg.points[2].x = -infinity;
  c.pslg.holes = {{0.5, 0.5}, {infinity, 0}};
  c.pslg.regions = {{{0.5, infinity}, 1, 1}};
  EXPECT_EQ(said_about(c),
            "non_finite_coordinate: point 2 of the input is not finite [ids 2] at (-inf, 1)\n"
            "non_finite_coordinate: hole 1 of the input is not finite [ids 1] at (inf, 0)\n"
            "non_finite_coordinate: the seed of region 0 of the input is not finite [ids 0] at (0.5, inf)\n"
            "non_finite_coordinate: vertex 1 is not finite [ids 1] at (1, inf)\n"
            "wrong_count: region of triangles: 0 entries instead of 2\n");
}

TEST(Violations, of_the_delaunay_property) {
  Case c = testing::square_in_two();
  c.pslg.points[2] = c.mesh.points[2] = {2, 2};
  EXPECT_EQ(said_about(c),
            "not_delaunay: edge 2-0 of triangles 0 and 1 is not locally Delaunay: vertex 3 (0, 1) lies inside the "
            "circumcircle, in-circle determinant 4 [ids 2 0 0 1] at (2, 2), (0, 0)\n");
  c.pslg.segments.push_back({0, 2, 0});
  c.mesh.constrained_edges.push_back({0, 2, 4, 0});
  Goal goal = no_angle_bound();
  goal.conforming = true;
  EXPECT_EQ(said_about(c, goal),
            "not_conforming: edge 2-0 of triangles 0 and 1 is not locally Delaunay: vertex 3 (0, 1) lies inside the "
            "circumcircle, in-circle determinant 4 [ids 2 0 0 1] at (2, 2), (0, 0)\n");
}

TEST(Violations, of_bounds) {
  Case c;
  c.pslg.points = {{0, 0}, {4, 0}, {0, 3}};
  c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 0, 0}};
  c.pslg.regions = {{{1, 1}, 7, 5}};
  c.mesh = testing::mesh_of(c.pslg.points, {{1, 2, 0}});
  c.mesh.constrained_edges = {{0, 1, 0, 1}, {1, 2, 1, 1}, {2, 0, 2, 1}};
  c.mesh.region.push_back(0);
  c.mesh.region_attributes = {7};
  Goal goal{.min_angle_deg = 45, .max_area = 5.5, .max_edge = 3.5};
  goal.region_caps = true;
  goal.size = [](Point) { return 4.5; };
  EXPECT_EQ(said_about(c, goal, {.max_circumradius = 2}),
            "large_area: triangle 0 has area 6 > 5.5 [ids 0 1 2 0] at (4, 0), (0, 3), (0, 0)\n"
            "region_area: triangle 0 has area 6 > 5, the cap of region 0 [ids 0 1 2 0] at (4, 0), (0, 3), (0, 0)\n"
            "long_edge: edge 0-1 of triangle 0 has squared length 16, more than the square of 3.5 [ids 0 1 0] at (0, "
            "0), (4, 0)\n"
            "long_edge: edge 1-2 of triangle 0 has squared length 25, more than the square of 3.5 [ids 1 2 0] at (4, "
            "0), (0, 3)\n"
            "size_exceeded: triangle 0 has an edge of length 5 > 4.5, the size at its centroid [ids 0 1 2 0] at (4, "
            "0), (0, 3), (0, 0)\n"
            "large_circumradius: triangle 0 has squared circumradius 25/4, more than the square of 2 [ids 0 1 2 0] at "
            "(4, 0), (0, 3), (0, 0)\n");
  goal = no_angle_bound();
  goal.size = [](Point) -> double { throw std::runtime_error("no data"); };
  EXPECT_EQ(said_about(c, goal),
            "size_exceeded: triangle 0 has an edge of length 5, and the size function threw an exception at its "
            "centroid [ids 0 1 2 0] at (4, 0), (0, 3), (0, 0)\n");
  goal.size = [](Point) { return std::numeric_limits<double>::infinity(); };
  EXPECT_EQ(said_about(c, goal), "");
}

TEST(Violations, of_sizes_name_the_longest_edge_wherever_it_stands) {
  for (const std::array<Index, 3>& corners :
       {std::array<Index, 3>{0, 1, 2}, std::array<Index, 3>{1, 2, 0}, std::array<Index, 3>{2, 0, 1}}) {
    Case c;
    c.pslg.points = {{0, 0}, {4, 0}, {0, 3}};
    c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 0, 0}};
    c.mesh = testing::mesh_of(c.pslg.points, {corners});
    c.mesh.constrained_edges = {{0, 1, 0, 1}, {1, 2, 1, 1}, {2, 0, 2, 1}};
    Goal goal = no_angle_bound();
    goal.size = [](Point) { return 1.0; };
    const Certificate certificate = check(c, goal);
    ASSERT_EQ(certificate.violations.size(), 1u);
    EXPECT_EQ(certificate.violations[0].witness.text(),
              "triangle 0 has an edge of length 5 > 1, the size at its centroid");
  }
}

TEST(Violations, of_surfaces_that_are_no_disks_with_holes) {
  // Two toruses of nine vertices: three by three squares each, joined at opposite sides.
  Case c;
  for (Index k = 0; k < 2; ++k) {
    for (Index v = 0; v < 9; ++v) c.mesh.points.push_back({double(v % 3) + 10 * k, double(v / 3)});
    for (Index j = 0; j < 3; ++j)
      for (Index i = 0; i < 3; ++i) {
        const auto at = [&](Index x, Index y) { return 9 * k + 3 * (y % 3) + x % 3; };
        c.mesh.triangles.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}, {}});
        c.mesh.triangles.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}, {}});
      }
  }
  c.mesh.origin.resize(18, interior_vertex);
  testing::relink(c.mesh);
  const auto surfaces = [](const Case& of, const CheckOptions& options) {
    std::string text;
    for (const Violation& violation : check(of, no_angle_bound(), options).violations)
      if (violation.kind == ViolationKind::euler_characteristic) text += violation.message() + '\n';
    return text;
  };
  const std::string expected =
      "euler_characteristic: the component of triangle 0 has V - E + F = 0 and 0 boundary loops, which do not "
      "sum to 2 [ids 0] at (0, 0)\n"
      "euler_characteristic: the component of triangle 18 has V - E + F = 0 and 0 boundary loops, which do not "
      "sum to 2 [ids 18] at (10, 0)\n";
  EXPECT_EQ(surfaces(c, {}), expected);
  for (Triangle& t : c.mesh.triangles) t.n = {no_index, no_index, no_index};
  EXPECT_EQ(surfaces(c, {.foreign = true}), expected) << "of a file without neighbours";
}

}  // namespace
}  // namespace pardel::checker
