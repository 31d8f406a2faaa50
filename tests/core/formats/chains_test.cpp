#include "../../../core/formats/chains.hpp"

#include <gtest/gtest.h>

namespace pardel::files {
namespace {

std::vector<EdgeEnds> edges_of(const std::vector<Chain>& chains) {
  std::vector<EdgeEnds> edges;
  for (const Chain& chain : chains)
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) edges.push_back({chain[i], chain[i + 1]});
  return edges;
}

TEST(Chains, keep_the_direction_of_their_edges_in_any_order) {
  const std::vector<EdgeEnds> edges = {{2, 3}, {0, 1}, {1, 2}};
  EXPECT_EQ(chains_of(edges), (std::vector<Chain>{{0, 1, 2, 3}}));
}

TEST(Chains, join_edges_of_different_directions) {
  const std::vector<EdgeEnds> edges = {{1, 0}, {1, 2}, {3, 2}};
  EXPECT_EQ(chains_of(edges), (std::vector<Chain>{{3, 2, 1, 0}}));
}

TEST(Chains, that_are_closed_repeat_their_first_vertex) {
  const std::vector<EdgeEnds> edges = {{7, 8}, {9, 7}, {8, 9}};
  EXPECT_EQ(chains_of(edges), (std::vector<Chain>{{7, 8, 9, 7}}));
}

TEST(Chains, end_where_three_edges_meet_and_at_an_edge_from_a_vertex_to_itself) {
  const std::vector<EdgeEnds> star = {{0, 1}, {0, 2}, {0, 3}}, tail = {{4, 5}, {5, 5}};
  EXPECT_EQ(chains_of(star), (std::vector<Chain>{{0, 1}, {0, 2}, {0, 3}}));
  EXPECT_EQ(chains_of(tail), (std::vector<Chain>{{4, 5}, {5, 5}}));
}

TEST(Chains, of_chains_are_the_same_chains) {
  const std::vector<EdgeEnds> edges = {{5, 4}, {0, 1}, {2, 1}, {3, 1}, {6, 7}, {7, 8}, {8, 6}, {4, 6}, {9, 9}};
  const std::vector<Chain> chains = chains_of(edges);
  EXPECT_EQ(edges_of(chains).size(), edges.size());
  EXPECT_EQ(chains_of(edges_of(chains)), chains);
}

}  // namespace
}  // namespace pardel::files
