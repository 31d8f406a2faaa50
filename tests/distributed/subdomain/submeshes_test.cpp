#include "../../../distributed/subdomain/submeshes.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <set>
#include <vector>

#include "../../../parallel/construction/domain_triangulation.hpp"
#include "../../../parallel/triangulation/held.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../../../properties/theorems/framework/local_ranks.hpp"
#include "part_of_rank.hpp"

namespace pardel::engine {
namespace {

using Refine = Communicator::RefineSubmesh;

const Triangulation& mesh_of_points() {
  static const Result<DomainTriangulation> domain = triangulate_domain(domains::random_points(2000, 3), true);
  return domain.value().triangulation;
}

std::vector<TriangleId> triangles_of(const Triangulation& submesh) {
  std::vector<TriangleId> triangles;
  for (TriangleId id = 0; id < submesh.slots.size(); ++id)
    if (is_held(submesh, id)) triangles.push_back(id);
  return triangles;
}

struct Outcome {
  int finished = 0;   ///< how many times `finish` was called, on all ranks
  int not_held = 0;   ///< the number of ranks that could not do it
  int different = 0;  ///< the number of ranks whose part of the mesh is not what it was
};

/// Two ranks do a piece of work in submeshes of mesh_of_points(), around its first triangle.
Outcome work_on_two_ranks(const Refine& refine) {
  const Triangulation& whole = mesh_of_points();
  const auto owner = [](VertexId v) { return static_cast<int>(v) % 2; };
  const auto holds = [&](int rank, const Slot& slot) {
    return std::ranges::any_of(slot.v, [&](VertexId v) { return owner(v) == rank; });
  };
  Outcome outcome;
  std::mutex mutex;
  properties::on_ranks(2, [&](Ranks& ranks) {
    PartOfRank part(whole, ranks.rank(), owner);
    std::vector<TriangleId> centre;
    if (owner(whole.slots[0].v[0]) == ranks.rank()) centre.push_back(0);
    Rings rings(part.held, part.t, ranks, owner, centre);
    const std::vector<Name> names{{Name::everyone, 0}};
    bool has_finished = false, is_held_by_both = true;
    const SubmeshWork work{
        Name::rank(2), names, refine,
        [&](int rank, const Triangulation& t, TriangleId id) { return holds(rank, t.slots[id]); },
        [&](const Subdomain&, const Triangulation&, std::span<const VertexId>) { has_finished = true; }};
    try {
      work_in_submeshes(work, part.held, part.t, rings, ranks);
    } catch (const NotHeld&) {
      is_held_by_both = false;
    }
    bool is_different = false;
    for (TriangleId id = 0; id < whole.slots.size(); ++id)
      is_different = is_different || part.held.has(id) != holds(ranks.rank(), whole.slots[id]) ||
                     (part.held.has(id) && part.t.slots[id].v != whole.slots[id].v);
    const std::scoped_lock lock(mutex);
    outcome.finished += has_finished ? 1 : 0;
    outcome.not_held += is_held_by_both ? 0 : 1;
    outcome.different += is_different ? 1 : 0;
  });
  return outcome;
}

TEST(GatheredSubmeshes, grow_if_the_work_needs_a_triangle_at_an_unknown_place) {
  std::vector<std::size_t> sizes;
  const Outcome outcome =
      work_on_two_ranks([&](const Communicator::GatheredSubmesh& submesh) -> std::vector<TriangleId> {
        sizes.push_back(triangles_of(submesh.t).size());
        if (sizes.size() < 4) throw NotHeld{};
        return {};
      });
  EXPECT_EQ(outcome.finished, 1);
  EXPECT_EQ(outcome.not_held, 0);
  EXPECT_EQ(outcome.different, 0);
  ASSERT_EQ(sizes.size(), 4U);
  for (std::size_t i = 1; i < sizes.size(); ++i) EXPECT_GT(sizes[i], sizes[i - 1]);
  EXPECT_LT(sizes.back(), mesh_of_points().slots.size()) << "the last submesh was the whole mesh";
}

TEST(GatheredSubmeshes, forget_what_an_attempt_changed_before_it_needed_more) {
  int attempts = 0;
  const Outcome outcome =
      work_on_two_ranks([&](const Communicator::GatheredSubmesh& submesh) -> std::vector<TriangleId> {
        const TriangleId first = submesh.first.at(0).id();
        const VertexId corner = submesh.t.slots[first].v[0];
        EXPECT_EQ(submesh.t.origin[corner], input_vertex);
        submesh.t.origin[corner] = origin_on_segment(7);
        submesh.t.slots[first].n.fill({});
        if (++attempts < 3) throw NotHeld{};
        return {};
      });
  EXPECT_EQ(attempts, 3);
  EXPECT_EQ(outcome.finished, 1);
  EXPECT_EQ(outcome.different, 0);
}

TEST(GatheredSubmeshes, of_the_whole_mesh_are_the_last_attempt_and_then_all_ranks_fail) {
  std::size_t last = 0;
  const Outcome outcome =
      work_on_two_ranks([&](const Communicator::GatheredSubmesh& submesh) -> std::vector<TriangleId> {
        last = triangles_of(submesh.t).size();
        throw NotHeld{};
      });
  EXPECT_EQ(outcome.finished, 0);
  EXPECT_EQ(outcome.not_held, 2);
  EXPECT_EQ(outcome.different, 0);
  EXPECT_EQ(last, mesh_of_points().slots.size());
}

/// The triangle across a side of a changed one might have to change, too. The walk over a cavity does not notice that
/// it is missing if the side is constrained.
TEST(GatheredSubmeshes, get_the_triangles_around_a_changed_one_at_their_border) {
  std::optional<std::array<Point, 3>> at_border;
  std::size_t attempts = 0;
  const Outcome outcome =
      work_on_two_ranks([&](const Communicator::GatheredSubmesh& submesh) -> std::vector<TriangleId> {
        const Triangulation& t = submesh.t;
        const auto corners = [&](TriangleId id) {
          const auto& v = t.slots[id].v;
          return std::array{t.points[v[0]], t.points[v[1]], t.points[v[2]]};
        };
        const auto is_at_border = [&](TriangleId id) {
          return std::ranges::any_of(t.slots[id].n,
                                     [&](EdgeRef across) { return !across.none() && !is_held(t, across.triangle()); });
        };
        const std::vector<TriangleId> triangles = triangles_of(t);
        ++attempts;
        if (!at_border) {
          const auto first = std::ranges::find_if(triangles, is_at_border);
          at_border = corners(*first);
          return {*first};
        }
        const auto same = std::ranges::find_if(triangles, [&](TriangleId id) { return corners(id) == *at_border; });
        EXPECT_TRUE(same != triangles.end());
        EXPECT_FALSE(is_at_border(*same));
        return {*same};
      });
  EXPECT_EQ(attempts, 2U);
  EXPECT_EQ(outcome.finished, 1);
  EXPECT_EQ(outcome.not_held, 0);
  EXPECT_EQ(outcome.different, 0);
}

}  // namespace
}  // namespace pardel::engine
