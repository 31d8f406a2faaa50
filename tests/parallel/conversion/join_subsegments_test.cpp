#include "../../../parallel/conversion/join_subsegments.hpp"

#include <gtest/gtest.h>

namespace pardel::engine {
namespace {

/// Vertices 0 and 1 are the ends of input segment 6, on which vertices 2, 3 and 4 follow each other from 0 to 1.
Mesh split_segment() {
  Mesh mesh;
  mesh.points.resize(5);
  for (int ends = 0; ends < 2; ++ends) mesh.origin.push_back(input_vertex);
  for (int inner = 0; inner < 3; ++inner) mesh.origin.push_back(origin_on_segment(6));
  mesh.constrained_edges = {{3, 4, 6, 1}, {2, 0, 6, 1}, {1, 4, 6, 1}, {2, 3, 6, 1}};
  return mesh;
}

TEST(JoinSubsegments, joins_them_at_vertices_that_were_inserted_on_their_segment) {
  const Mesh mesh = split_segment();
  const JoinedSegments joined = join_subsegments(mesh, mesh.constrained_edges);
  ASSERT_EQ(joined.segments.size(), 1U);
  EXPECT_EQ(joined.segments[0].a, 0U) << "it starts at the end that is found first";
  EXPECT_EQ(joined.segments[0].b, 1U);
  EXPECT_EQ(joined.input_segment, std::vector<Index>{6});
  EXPECT_EQ(joined.segment_marker, std::vector<int>{1});
  for (const Index v : {0, 1}) EXPECT_EQ(joined.origin[v], input_vertex);
  for (const Index v : {2, 3, 4}) EXPECT_EQ(joined.origin[v], origin_on_segment(0));
}

TEST(JoinSubsegments, joins_nothing_without_origins) {
  Mesh mesh = split_segment();
  mesh.origin.clear();
  const JoinedSegments joined = join_subsegments(mesh, mesh.constrained_edges);
  EXPECT_EQ(joined.segments.size(), 4U);
  for (const Index origin : joined.origin) EXPECT_EQ(origin, input_vertex);
}

TEST(JoinSubsegments, keeps_subsegments_apart_where_another_one_ends_or_markers_differ) {
  Mesh mesh = split_segment();
  mesh.points.resize(6);
  mesh.origin.push_back(interior_vertex);
  mesh.constrained_edges.push_back({3, 5, 7, 0});  // ends in the interior of segment 6
  mesh.constrained_edges[2].marker = 2;            // between vertices 4 and 1
  const JoinedSegments joined = join_subsegments(mesh, mesh.constrained_edges);
  EXPECT_EQ(joined.segments.size(), 4U) << "0-3, 3-4, 4-1 and 3-5";
  EXPECT_EQ(joined.origin[2], origin_on_segment(1)) << "the second segment found";
  EXPECT_EQ(joined.origin[3], input_vertex);
  EXPECT_EQ(joined.origin[4], input_vertex);
  EXPECT_EQ(joined.origin[5], interior_vertex);
}

TEST(JoinSubsegments, joins_only_at_a_vertex_that_was_inserted_on_the_segment_of_both) {
  for (const Index first : {5, 6})
    for (const Index second : {5, 6})
      for (const Index origin : {origin_on_segment(5), origin_on_segment(6), origin_on_segment(7), input_vertex,
                                 interior_vertex, hull_vertex}) {
        Mesh mesh;
        mesh.points.resize(3);
        for (const Index of_vertex : {input_vertex, input_vertex, origin}) mesh.origin.push_back(of_vertex);
        mesh.constrained_edges = {{0, 2, first, 1}, {2, 1, second, 1}};
        const std::size_t joined = join_subsegments(mesh, mesh.constrained_edges).segments.size();
        const bool on_both = origin_on_segment(first) == origin && origin_on_segment(second) == origin;
        EXPECT_EQ(joined, on_both ? 1U : 2U) << first << ", " << second << ", " << origin;
      }
}

TEST(JoinSubsegments, joins_subsegments_of_a_hull_edge) {
  Mesh mesh;
  mesh.points.resize(3);
  for (const Index origin : {input_vertex, input_vertex, hull_vertex}) mesh.origin.push_back(origin);
  mesh.constrained_edges = {{0, 2, no_index, 0}, {2, 1, no_index, 0}};
  const JoinedSegments joined = join_subsegments(mesh, mesh.constrained_edges);
  EXPECT_EQ(joined.segments.size(), 1U);
  EXPECT_EQ(joined.input_segment, std::vector<Index>{no_index});
}

TEST(JoinSubsegments, does_not_join_a_closed_ring) {
  Mesh mesh;
  mesh.points.resize(3);
  for (int v = 0; v < 3; ++v) mesh.origin.push_back(origin_on_segment(4));
  mesh.constrained_edges = {{0, 1, 4, 0}, {1, 2, 4, 0}, {2, 0, 4, 0}};
  EXPECT_EQ(join_subsegments(mesh, mesh.constrained_edges).segments.size(), 3U);
}

TEST(JoinSubsegments, keeps_the_origins_of_vertices_inside_faces) {
  Mesh mesh;
  mesh.points.resize(3);
  for (const Index origin : {interior_vertex, input_vertex, interior_vertex}) mesh.origin.push_back(origin);
  const JoinedSegments joined = join_subsegments(mesh, mesh.constrained_edges);
  for (Index v = 0; v < 3; ++v) EXPECT_EQ(joined.origin[v], mesh.origin[v]);
}

}  // namespace
}  // namespace pardel::engine
