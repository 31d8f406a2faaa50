#include "../../../core/support/mesh_edges.hpp"

#include <gtest/gtest.h>

#include "../sample_mesh.hpp"

namespace pardel {
namespace {

TEST(ConstrainedEdgeIndex, finds_an_edge_from_either_end) {
  const Mesh mesh = sample_mesh();
  const ConstrainedEdgeIndex index(mesh);
  for (const ConstrainedEdge& e : mesh.constrained_edges) {
    EXPECT_EQ(index.find(e.a, e.b), &e);
    EXPECT_EQ(index.find(e.b, e.a), &e);
  }
  EXPECT_EQ(index.find(0, 4), nullptr);
  EXPECT_EQ(index.find(5, 0), nullptr);
  EXPECT_EQ(index.find(5, 5), nullptr);
}

TEST(EdgeTable, has_every_edge_once_and_names_it_at_both_its_sides) {
  const Mesh mesh = sample_mesh();
  const EdgeTable table = edge_table(mesh);
  EXPECT_EQ(table.edges.size(), 8u);
  std::vector<int> sides(table.edges.size(), 0);
  for (std::size_t s = 0; s < table.edge_of_side.size(); ++s) {
    const MarkedEdge& edge = table.edges[table.edge_of_side[s]];
    const auto& v = mesh.triangles[s / 3].v;
    EXPECT_EQ(std::minmax({edge.a, edge.b}), std::minmax({v[(s + 1) % 3], v[(s + 2) % 3]}));
    ++sides[table.edge_of_side[s]];
  }
  for (std::size_t e = 0; e < table.edges.size(); ++e) {
    const bool boundary = table.edges[e].a != 4 && table.edges[e].b != 4;
    EXPECT_EQ(sides[e], boundary ? 1 : 2);
  }
}

TEST(EdgeTable, gives_unmarked_boundary_edges_the_marker_1) {
  Mesh mesh = sample_mesh();
  mesh.constrained_edges = {{1, 2, no_index, 5}};
  for (const MarkedEdge& edge : edge_table(mesh).edges) {
    const bool boundary = edge.a != 4 && edge.b != 4;
    const bool marked = std::minmax({edge.a, edge.b}) == std::minmax({Index{1}, Index{2}});
    EXPECT_EQ(edge.marker, marked ? 5 : boundary ? 1 : 0);
  }
}

}  // namespace
}  // namespace pardel
