#include "../../core/neighbours.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <random>

#include "sample_mesh.hpp"

namespace pardel {
namespace {

Array<Triangle> triangles_of(std::initializer_list<std::array<Index, 3>> corners) {
  Array<Triangle> triangles;
  for (const auto& v : corners) triangles.push_back({v, {42, 42, 42}});
  return triangles;
}

TEST(Neighbours, are_opposite_the_corner_that_is_not_shared) {
  Array<Triangle> triangles = sample_mesh().triangles;
  for (Triangle& t : triangles) t.n = {7, 7, 7};
  EXPECT_EQ(rebuild_neighbours(triangles, 6), 0u);
  EXPECT_EQ(triangles, sample_mesh().triangles);
}

TEST(Neighbours, of_a_third_triangle_at_an_edge_are_none) {
  auto triangles = triangles_of({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  EXPECT_EQ(rebuild_neighbours(triangles, 5), 1u);
  EXPECT_EQ(triangles[0].n[2], 1u);
  EXPECT_EQ(triangles[1].n[2], 0u);
  EXPECT_EQ(triangles[2].n[2], no_index);
}

TEST(Neighbours, of_a_triangle_are_never_itself) {
  auto triangles = triangles_of({{0, 0, 0}, {1, 1, 0}});
  rebuild_neighbours(triangles, 2);
  for (const Index n : triangles[0].n) EXPECT_NE(n, 0u);
  for (const Index n : triangles[1].n) EXPECT_NE(n, 1u);
}

TEST(Neighbours, of_no_triangles_are_nothing) {
  Array<Triangle> none;
  EXPECT_EQ(rebuild_neighbours(none, 0), 0u);
  EXPECT_EQ(rebuild_neighbours(none, 3), 0u);
}

TEST(Neighbours, agree_with_comparing_all_pairs_of_sides) {
  std::mt19937 random(17);
  for (int round = 0; round < 200; ++round) {
    Array<Triangle> triangles;
    for (int t = 0; t < 12; ++t) {
      std::array<Index, 3> v{};
      do {
        for (Index& corner : v) corner = static_cast<Index>(random() % 7);
      } while (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]);
      triangles.push_back({v, {}});
    }
    const std::size_t surplus = rebuild_neighbours(triangles, 7);
    const auto side = [&](std::size_t s) {
      const auto& v = triangles[s / 3].v;
      return std::minmax({v[(s + 1) % 3], v[(s + 2) % 3]});
    };
    std::size_t expected_surplus = 0;
    for (std::size_t s = 0; s < 36; ++s) {
      std::vector<std::size_t> same;
      for (std::size_t other = 0; other < 36; ++other) {
        if (side(other) == side(s)) same.push_back(other);
      }
      Index expected = no_index;
      if (same.size() >= 2 && s == same[0]) expected = static_cast<Index>(same[1] / 3);
      if (same.size() >= 2 && s == same[1]) expected = static_cast<Index>(same[0] / 3);
      if (same.size() > 2 && s != same[0] && s != same[1]) ++expected_surplus;
      EXPECT_EQ(triangles[s / 3].n[s % 3], expected);
    }
    EXPECT_EQ(surplus, expected_surplus);
  }
}

}  // namespace
}  // namespace pardel
