#include "../../../distributed/subdomain/rings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "../../../parallel/construction/domain_triangulation.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../../../properties/theorems/framework/local_ranks.hpp"
#include "part_of_rank.hpp"

namespace pardel::engine {
namespace {

using Set = std::set<TriangleId>;

/// All triangles that share a corner with one of these.
Set with_one_ring_more(const Triangulation& t, const Set& triangles) {
  std::set<VertexId> corners;
  for (const TriangleId id : triangles) corners.insert(t.slots[id].v.begin(), t.slots[id].v.end());
  Set larger;
  for (TriangleId id = 0; id < t.slots.size(); ++id)
    if (std::ranges::any_of(t.slots[id].v, [&](VertexId v) { return corners.contains(v); })) larger.insert(id);
  return larger;
}

/// The sets of triangles around the first one, on several ranks, until they grow no more.
std::vector<Set> rings_on(int count, const Triangulation& whole, const Rings::Owner& owner) {
  std::vector<Set> found;
  std::mutex mutex;
  properties::on_ranks(count, [&](Ranks& ranks) {
    const PartOfRank part(whole, ranks.rank(), owner);
    std::vector<TriangleId> centre;
    if (owner(whole.slots[0].v[0]) == ranks.rank()) centre.push_back(0);
    Rings rings(part.held, part.t, ranks, owner, centre);
    for (std::size_t ring = 0; !rings.is_complete(); ++ring) {
      rings.grow();
      const std::scoped_lock lock(mutex);
      found.resize(std::max(found.size(), ring + 1));
      const Set here(rings.triangles().begin(), rings.triangles().end());
      EXPECT_EQ(here.size(), rings.triangles().size()) << "a triangle is listed twice";
      for (const TriangleId id : here) EXPECT_TRUE(part.held.holds(id));
      found[ring].insert(here.begin(), here.end());
    }
  });
  // A rank may learn in a ring about a triangle that another rank has known before.
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

void expect_rings(const Pslg& pslg, const std::string& name) {
  SCOPED_TRACE(name);
  const Result<DomainTriangulation> domain = triangulate_domain(pslg, false);
  ASSERT_TRUE(domain) << domain.error().message;
  const Triangulation& t = domain->triangulation;
  std::vector<Set> expected;
  for (Set next = with_one_ring_more(t, {0}); expected.empty() || next != expected.back();) {
    expected.push_back(next);
    next = with_one_ring_more(t, expected.back());
  }
  EXPECT_GT(expected.size(), 2U);
  for (const int count : {1, 2, 5}) {
    EXPECT_TRUE(rings_on(count, t, [&](VertexId v) { return static_cast<int>(v) % count; }) == expected) << count;
    const auto by_place = [&](VertexId v) { return static_cast<int>(std::abs(t.points[v].x) * 7) % count; };
    EXPECT_TRUE(rings_on(count, t, by_place) == expected) << count;
  }
}

TEST(Rings, are_those_of_the_whole_mesh) {
  expect_rings(domains::random_points(500, 3), "points");
  expect_rings(domains::pipe(), "pipe");
  expect_rings(domains::regions(), "regions");
  expect_rings(domains::comb(9, 0.1), "comb");
}

/// The triangles around one vertex are on the rank that owns it. Afterwards, the rings grow from there.
TEST(Rings, grow_around_a_vertex_only_if_they_are_told_so) {
  const Result<DomainTriangulation> domain = triangulate_domain(domains::random_points(500, 3), true);
  ASSERT_TRUE(domain) << domain.error().message;
  const Triangulation& t = domain->triangulation;
  const VertexId v = t.slots[0].v[1];
  Set around_v{0};
  for (TriangleId id = 0; id < t.slots.size(); ++id)
    if (std::ranges::count(t.slots[id].v, v) > 0) around_v.insert(id);
  const auto owner = [](VertexId vertex) { return static_cast<int>(vertex) % 3; };
  std::mutex mutex;
  Set first, second, third;
  properties::on_ranks(3, [&](Ranks& ranks) {
    const PartOfRank part(t, ranks.rank(), owner);
    std::vector<TriangleId> centre;
    if (owner(t.slots[0].v[0]) == ranks.rank()) centre.push_back(0);
    Rings rings(part.held, part.t, ranks, owner, centre);
    const auto add_to = [&](Set& found) {
      const std::scoped_lock lock(mutex);
      found.insert(rings.triangles().begin(), rings.triangles().end());
    };
    rings.grow_around(std::vector{Name{Name::everyone, v}});
    rings.grow();
    add_to(first);
    EXPECT_FALSE(rings.is_complete());
    rings.grow_around(std::vector{Name{Name::everyone, v}});
    rings.grow();
    add_to(second);
    EXPECT_TRUE(rings.is_complete());
    rings.grow_around({});
    rings.grow();
    add_to(third);
  });
  EXPECT_EQ(first, around_v);
  EXPECT_EQ(second, around_v);
  EXPECT_EQ(third, with_one_ring_more(t, around_v));
}

/// Two triangles that have one vertex in common: no cavity reaches from one into the other.
TEST(Rings, do_not_cross_a_vertex_at_which_only_corners_meet) {
  Pslg hourglass;
  hourglass.points = {{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}};
  hourglass.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 2}, {2, 0}};
  const Result<DomainTriangulation> domain = triangulate_domain(hourglass, false);
  ASSERT_TRUE(domain) << domain.error().message;
  ASSERT_EQ(domain->triangulation.slots.size(), 2U);
  for (const int count : {1, 2})
    EXPECT_EQ(rings_on(count, domain->triangulation, [&](VertexId v) { return static_cast<int>(v) % count; }).back(),
              Set{0});
}

}  // namespace
}  // namespace pardel::engine
