#include "../../../parallel/conversion/join_subsegments.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace pardel::engine {
namespace {

/// Vertices 0 and 1 are the ends of a segment, on which vertices 2, 3 and 4 follow each other from 0 to 1.
Mesh split_segment() {
  Mesh mesh;
  for (const Point p : {Point{0, 0}, {8, 4}, {2, 1}, {4, 2}, {6, 3}}) mesh.points.push_back(p);
  mesh.constrained_edges = {{3, 4, 6, 1}, {2, 0, 6, 1}, {1, 4, 6, 1}, {2, 3, 6, 1}};
  return mesh;
}

JoinedSegments joined(const Mesh& mesh) { return join_subsegments(mesh, mesh.constrained_edges); }

TEST(JoinSubsegments, joins_them_where_they_continue_each_other_straight) {
  const JoinedSegments result = joined(split_segment());
  ASSERT_EQ(result.segments.size(), 1U);
  EXPECT_EQ(result.segments[0].a, 0U) << "it starts at the end that is found first";
  EXPECT_EQ(result.segments[0].b, 1U);
  EXPECT_EQ(result.subsegment, std::vector<Index>{1});
  for (const Index v : {0, 1}) EXPECT_EQ(result.origin[v], input_vertex);
  for (const Index v : {2, 3, 4}) EXPECT_EQ(result.origin[v], origin_on_segment(0));
}

TEST(JoinSubsegments, knows_the_subsegment_at_each_place) {
  const Mesh mesh = split_segment();
  const SegmentPieces pieces = joined(mesh).pieces;
  const auto number_at = [&](double t) { return pieces.at(mesh.points, 0, {8 * t, 4 * t}).number; };
  EXPECT_EQ(number_at(0.1), 1U);
  EXPECT_EQ(number_at(0.3), 3U);
  EXPECT_EQ(number_at(0.6), 0U);
  EXPECT_EQ(number_at(0.9), 2U);
  const SegmentPieces::Piece second = pieces.at(mesh.points, 0, {3, 1.5});
  EXPECT_TRUE(second.a == 2 && second.b == 3);
}

TEST(JoinSubsegments, keeps_subsegments_apart_where_another_one_ends) {
  Mesh mesh = split_segment();
  mesh.points.push_back({4, 9});
  mesh.origin.resize(5, input_vertex);
  mesh.origin.push_back(interior_vertex);
  mesh.constrained_edges.push_back({3, 5, 7, 0});
  const JoinedSegments result = joined(mesh);
  EXPECT_EQ(result.segments.size(), 3U) << "0-3, 3-1 and 3-5";
  EXPECT_EQ(result.origin[3], input_vertex);
  EXPECT_EQ(result.origin[5], interior_vertex);
}

TEST(JoinSubsegments, keeps_subsegments_apart_where_they_turn) {
  for (const double off : {1.0, 1e-9, 1e-14}) {
    Mesh mesh = split_segment();
    mesh.points[4].y += off;
    mesh.points[1].y += 2 * off;
    const JoinedSegments result = joined(mesh);
    EXPECT_EQ(result.segments.size(), 2U) << off;
    EXPECT_EQ(result.origin[3], input_vertex) << off;
  }
}

TEST(JoinSubsegments, allows_a_vertex_two_units_off_the_line) {
  constexpr double unit = 0x1p-50;  // the distance of doubles at 4, the y coordinate of vertex 1
  for (const double units : {1.0, -1.5, -2.5, 16.0}) {
    Mesh mesh;
    for (const Point p : {Point{0, 4}, {2, 4 + units * unit}, {4, 4}}) mesh.points.push_back(p);
    mesh.constrained_edges = {{0, 1}, {1, 2}};
    EXPECT_EQ(joined(mesh).segments.size(), std::abs(units) < 2 ? 1U : 2U) << units;
  }
}

TEST(JoinSubsegments, does_not_join_a_path_that_turns_back) {
  Mesh mesh;
  for (const Point p : {Point{0, 0}, {4, 0}, {2, 0}}) mesh.points.push_back(p);
  mesh.constrained_edges = {{0, 1}, {1, 2}};
  EXPECT_EQ(joined(mesh).segments.size(), 2U);
}

TEST(JoinSubsegments, joins_the_sides_of_a_closed_ring) {
  Mesh mesh;
  for (const Point p : {Point{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 1}}) mesh.points.push_back(p);
  for (Index v = 0; v < 5; ++v) mesh.constrained_edges.push_back({v, (v + 1) % 5});
  const JoinedSegments result = joined(mesh);
  EXPECT_EQ(result.segments.size(), 3U);
  for (const Index v : {0, 2, 3}) EXPECT_EQ(result.origin[v], input_vertex);
  for (const Index v : {1, 4}) EXPECT_NE(result.origin[v], input_vertex);
}

TEST(JoinSubsegments, keeps_the_origins_of_vertices_inside_faces) {
  Mesh mesh;
  mesh.points.resize(3);
  for (const Index origin : {interior_vertex, input_vertex, interior_vertex}) mesh.origin.push_back(origin);
  const JoinedSegments result = joined(mesh);
  for (Index v = 0; v < 3; ++v) EXPECT_EQ(result.origin[v], mesh.origin[v]);
}

}  // namespace
}  // namespace pardel::engine
