#include "../../core/digest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "sample_mesh.hpp"

namespace pardel {
namespace {

/// Returns the same mesh with vertices, triangles, corners and edges in another order.
Mesh renumbered(const Mesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Index> to(mesh.points.size());
  std::iota(to.begin(), to.end(), Index{0});
  std::shuffle(to.begin(), to.end(), random);
  Mesh other = mesh;
  for (std::size_t i = 0; i < to.size(); ++i) other.points[to[i]] = mesh.points[i];
  std::vector<Index> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::shuffle(order.begin(), order.end(), random);
  for (std::size_t t = 0; t < order.size(); ++t) {
    Triangle triangle = mesh.triangles[order[t]];
    for (Index& v : triangle.v) v = to[v];
    std::rotate(triangle.v.begin(), triangle.v.begin() + random() % 3, triangle.v.end());
    other.triangles[t] = triangle;
    other.region[t] = mesh.region[order[t]];
  }
  for (ConstrainedEdge& e : other.constrained_edges) {
    e = {to[e.a], to[e.b], e.segment, e.marker};
    if (random() % 2 == 0) std::swap(e.a, e.b);
  }
  std::shuffle(other.constrained_edges.begin(), other.constrained_edges.end(), random);
  return other;
}

TEST(Digest, does_not_depend_on_any_numbering) {
  const Mesh mesh = sample_mesh();
  for (unsigned seed = 0; seed < 50; ++seed) EXPECT_EQ(digest(renumbered(mesh, seed)), digest(mesh));
}

TEST(Digest, is_equal_for_minus_zero_and_zero) {
  Mesh mesh = sample_mesh();
  mesh.points[0] = {-0.0, -0.0};
  EXPECT_EQ(digest(mesh), digest(sample_mesh()));
}

TEST(Digest, changes_with_every_coordinate_attribute_and_marker) {
  std::vector<Mesh> others(10, sample_mesh());
  others[0].points[4].x = std::nextafter(1.0, 2.0);
  std::swap(others[1].triangles[2].v[0], others[1].triangles[2].v[1]);
  others[2].triangles.pop_back();
  others[3].triangles.push_back(others[3].triangles[0]);
  others[3].region.push_back(others[3].region[0]);
  others[4].region[0] = 1;
  others[5].region_attributes[0] = 3;
  others[6].constrained_edges[0].marker = 2;
  others[7].constrained_edges.pop_back();
  others[8].constrained_edges[4] = {0, 4, no_index, 0};
  others[9].constrained_edges.push_back({2, 4, no_index, 0});
  std::set<std::string> digests{to_string(digest(sample_mesh()))};
  for (const Mesh& mesh : others) EXPECT_TRUE(digests.insert(to_string(digest(mesh))).second);
}

TEST(Digest, of_a_mesh_without_regions_is_that_with_region_attribute_zero) {
  Mesh without = sample_mesh();
  without.region.clear();
  without.region_attributes.clear();
  Mesh none = without;
  none.region.resize(4, no_index);
  Mesh zero = without;
  zero.region.resize(4, 0);
  zero.region_attributes = {0};
  EXPECT_EQ(digest(without), digest(none));
  EXPECT_EQ(digest(without), digest(zero));
}

TEST(Digest, is_the_sum_over_single_triangles) {
  Mesh mesh;
  mesh.region_attributes = {2.5};
  for (Index i = 0; i < 13; ++i) {
    mesh.points.push_back({i * 0.5, i % 3 * 1.0});
    mesh.triangles.push_back({{i, i * 5 % 13, i * 7 % 13}, {}});
    mesh.region.push_back(i % 2 == 0 ? 0 : no_index);
  }
  Mesh first = mesh, single = mesh;
  first.triangles.clear();
  Digest sum;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    EXPECT_EQ(digest(first), sum) << t << " triangles";
    first.triangles.push_back(mesh.triangles[t]);
    single.triangles = Array<Triangle>(1, mesh.triangles[t]);
    single.region = Array<Index>(1, mesh.region[t]);
    const Digest one = digest(single);
    sum.low += one.low;
    sum.high += one.high + (sum.low < one.low ? 1 : 0);
  }
  EXPECT_EQ(digest(mesh), sum);
}

TEST(Digest, of_many_triangles_by_many_threads_is_the_sum_of_its_parts) {
  // All threads sum 300,000 triangles; one thread sums 10,000 triangles, 30 times. The sums must agree.
  Mesh part = sample_mesh();
  part.constrained_edges.clear();
  part.triangles.resize(10'000, part.triangles[0]);
  part.region.resize(10'000, 0);
  Mesh whole = part;
  for (int i = 1; i < 30; ++i) {
    whole.triangles.append(part.triangles.span());
    whole.region.append(part.region.span());
  }
  const Digest one = digest(part);
  Digest sum;
  for (int i = 0; i < 30; ++i) {
    sum.low += one.low;
    sum.high += one.high + (sum.low < one.low ? 1 : 0);
  }
  EXPECT_EQ(digest(whole), sum);
}

TEST(Digest, is_written_as_32_hexadecimal_digits) {
  EXPECT_EQ(to_string(Digest{0x0123456789abcdef, 0xfedcba9876543210}), "0123456789abcdeffedcba9876543210");
  EXPECT_EQ(to_string(Digest{}), std::string(32, '0'));
}

TEST(Digest, is_the_same_on_every_machine_and_in_every_version) {
  EXPECT_EQ(to_string(digest(sample_mesh())), "1811a4624fff9366172a00e932f4bf55");
}

}  // namespace
}  // namespace pardel
