#include "../../core/neighbours.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <initializer_list>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

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

TEST(Neighbours, are_found_for_as_many_triangles_as_have_sides_that_an_index_can_number) {
  EXPECT_TRUE(can_be_a_mesh(0));
  EXPECT_TRUE(can_be_a_mesh(max_mesh_triangles));
  EXPECT_FALSE(can_be_a_mesh(max_mesh_triangles + 1));
  EXPECT_LT(3 * max_mesh_triangles, no_index) << "there is one more number, for an edge that has its triangles";
}

/// The last three triangles share an edge, so that one side is surplus. The first triangle has no neighbours.
TEST(Neighbours, do_not_depend_on_those_that_the_triangles_had) {
  auto triangles = triangles_of({{0, 1, 2}, {3, 4, 5}, {4, 3, 6}, {4, 3, 7}});
  for (const Index before : {Index{0}, Index{42}, no_index})
    for (std::size_t t = 0; t < 4; ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        for (Triangle& triangle : triangles) triangle.n = {no_index, no_index, no_index};
        triangles[t].n[i] = before;
        EXPECT_EQ(rebuild_neighbours(triangles, 8), 1U);
        EXPECT_EQ(triangles[0].n, (std::array<Index, 3>{no_index, no_index, no_index}));
        EXPECT_EQ(triangles[1].n, (std::array<Index, 3>{no_index, no_index, 2}));
        EXPECT_EQ(triangles[2].n, (std::array<Index, 3>{no_index, no_index, 1}));
        EXPECT_EQ(triangles[3].n, (std::array<Index, 3>{no_index, no_index, no_index}));
      }
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

/// A grid of squares, each cut into two triangles. Vertices and triangles are numbered at random.
Array<Triangle> shuffled_grid(Index squares, std::mt19937& random) {
  std::vector<Index> number((squares + 1) * (squares + 1));
  std::iota(number.begin(), number.end(), Index{0});
  std::shuffle(number.begin(), number.end(), random);
  const auto at = [&](Index x, Index y) { return number[x + y * (squares + 1)]; };
  std::vector<Triangle> triangles;
  for (Index x = 0; x < squares; ++x)
    for (Index y = 0; y < squares; ++y) {
      triangles.push_back({{at(x, y), at(x + 1, y), at(x + 1, y + 1)}, {}});
      triangles.push_back({{at(x + 1, y + 1), at(x, y + 1), at(x, y)}, {}});
    }
  std::shuffle(triangles.begin(), triangles.end(), random);
  return Array<Triangle>(std::span<const Triangle>(triangles));
}

TEST(Neighbours, of_many_triangles_are_the_same_on_any_number_of_threads) {
  constexpr Index squares = 150;
  constexpr std::size_t points = (squares + 1) * (squares + 1);
  std::mt19937 random(5);
  for (const int defect : {0, 1, 2}) {
    Array<Triangle> triangles = shuffled_grid(squares, random);
    if (defect == 1) std::swap(triangles[7].v[0], triangles[7].v[1]);
    if (defect == 2) triangles.push_back(triangles[9]);
    std::map<std::pair<Index, Index>, std::vector<Index>> at_edge;  // triangles, ascending
    for (Index t = 0; t < triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i)
        at_edge[std::minmax(triangles[t].v[(i + 1) % 3], triangles[t].v[(i + 2) % 3])].push_back(t);
    const int threads = omp_get_max_threads();
    for (const int n : {1, 2, 5}) {
      omp_set_num_threads(n);
      Array<Triangle> joined = triangles;
      EXPECT_EQ(rebuild_neighbours(joined, points), defect == 2 ? 3U : 0U);
      std::size_t wrong = 0;
      for (Index t = 0; t < joined.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
          const auto& same = at_edge[std::minmax(joined[t].v[(i + 1) % 3], joined[t].v[(i + 2) % 3])];
          const Index expected = same.size() < 2 ? no_index
                                 : same[0] == t  ? same[1]
                                 : same[1] == t  ? same[0]
                                                 : no_index;
          wrong += joined[t].n[i] != expected ? 1 : 0;
        }
      EXPECT_EQ(wrong, 0U) << n << " threads, defect " << defect;
    }
    omp_set_num_threads(threads);
  }
}

}  // namespace
}  // namespace pardel
