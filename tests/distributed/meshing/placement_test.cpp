// The mesh does not depend on which rank owns which cells: cells are given to ranks at random, without any order along
// a curve, and messages are delayed.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <utility>
#include <vector>

#include "../../../distributed/divided_input/divided_points.hpp"
#include "../../../distributed/meshing/distribution.hpp"
#include "../../../properties/theorems/framework/local_ranks.hpp"
#include "refined_parts.hpp"

namespace pardel::engine {
namespace {

using samples::Case;

/// A triangle, independent of numbers: its corners in ascending order.
using Place = std::array<std::pair<double, double>, 3>;

Place place_of(const Triangulation& t, TriangleId id) {
  Place corners;
  for (unsigned i = 0; i < 3; ++i) corners[i] = {t.points[t.slots[id].v[i]].x, t.points[t.slots[id].v[i]].y};
  std::ranges::sort(corners);
  return corners;
}

/// How cells get their owners.
enum class Placed { on_any_rank, on_a_rank_of_the_curve_in_another_order };

template <class Parts>
class AtRandom : public Parts {
 public:
  /// `others`: the arguments of Parts.
  template <class... Others>
  AtRandom(Placed placed, std::uint64_t seed, Others&&... others)
      : Parts(std::forward<Others>(others)...), placed_(placed), seed_(seed) {}

 protected:
  [[nodiscard]] Ownership ownership_of(const Tiles& tiles, std::span<const double> work) const override {
    generators::Random random(seed_);
    const Ownership usual = Parts::ownership_of(tiles, work);
    std::vector<int> order(static_cast<std::size_t>(this->ranks())), owner;
    for (std::size_t rank = 0; rank < order.size(); ++rank) order[rank] = static_cast<int>(rank);
    random.shuffle(order);
    for (Index cell = 0; cell < usual.cells(); ++cell)
      owner.push_back(placed_ == Placed::on_any_rank ? random.one_of(order)
                                                     : order[static_cast<std::size_t>(usual.owner(cell))]);
    return {tiles, owner};
  }

 private:
  Placed placed_;
  std::uint64_t seed_;
};

/// Refines, and returns the triangles that belong to this rank.
std::vector<Place> refined(DomainTriangulation& domain, const Case& c, const Options& options, Distribution& parts) {
  const Result<RefineCounts> counts = samples::refine(domain, c, options, parts);
  EXPECT_TRUE(counts) << counts.error().message;
  std::vector<Place> own;
  if (!counts) return own;
  parts.part().for_each_triangle([&](TriangleId id) {
    if (parts.owner_of_triangle(id) == parts.network().rank()) own.push_back(place_of(domain.triangulation, id));
  });
  return own;
}

/// Calls refine(rank) on all ranks. Returns the triangles of all ranks, in ascending order.
template <class Refine>
std::vector<Place> on_all(int count, std::uint64_t seed, const Refine& refine) {
  std::mutex mutex;
  std::vector<Place> all;
  properties::on_ranks(
      count,
      [&](Ranks& ranks) {
        const std::vector<Place> own = refine(ranks);
        const std::scoped_lock lock(mutex);
        all.insert(all.end(), own.begin(), own.end());
      },
      seed);
  std::ranges::sort(all);
  return all;
}

/// All ranks begin with the whole domain.
std::vector<Place> refined_on(int count, const Case& c, const Options& options, Placed placed, std::uint64_t seed) {
  return on_all(count, seed, [&](Ranks& ranks) {
    Result<DomainTriangulation> domain = triangulate_domain(c.pslg, c.goal.convex_hull, 1);
    EXPECT_TRUE(domain);
    AtRandom<Distribution> parts(placed, seed, ranks, domain->triangulation);
    return refined(*domain, c, options, parts);
  });
}

/// Each rank begins with a part of the domain.
std::vector<Place> refined_parts_on(int count, const Case& c, const Options& options, Placed placed,
                                    std::uint64_t seed) {
  return on_all(count, seed, [&](Ranks& ranks) {
    std::vector<Place> own;
    samples::with_part_of_domain(c, ranks, [&](PartOfDomain& part, const CurveDivision& division) {
      AtRandom<DividedPoints> parts(placed, seed, ranks, part, division);
      own = refined(part.domain, c, options, parts);
    });
    return own;
  });
}

std::vector<Place> refined_alone(const Case& c, const Options& options) {
  const Mesh mesh = samples::refined(c, options, {}).mesh;
  std::vector<Place> all;
  for (const Triangle& triangle : mesh.triangles) {
    Place& corners = all.emplace_back();
    for (unsigned i = 0; i < 3; ++i) corners[i] = {mesh.points[triangle.v[i]].x, mesh.points[triangle.v[i]].y};
    std::ranges::sort(corners);
  }
  std::ranges::sort(all);
  return all;
}

class Placements : public testing::TestWithParam<std::size_t> {};

TEST_P(Placements, of_cells_on_ranks_at_random_do_not_change_the_mesh) {
  const Case& c = samples::cases()[GetParam()];
  const std::array<std::pair<Case, Options>, 2> runs = {
      {{c, samples::options_for(c)}, {samples::graded(c), samples::options_for_leaves(c)}}};
  for (const auto& [sample, options] : runs) {
    const std::vector<Place> alone = refined_alone(sample, options);
    for (const Placed placed : {Placed::on_any_rank, Placed::on_a_rank_of_the_curve_in_another_order})
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const int count = 2 + static_cast<int>(seed);
        EXPECT_TRUE(refined_on(count, sample, options, placed, seed) == alone) << count << " ranks, seed " << seed;
      }
  }
}

TEST_P(Placements, of_cells_of_a_divided_domain_at_random_do_not_change_the_mesh) {
  const Case& c = samples::cases()[GetParam()];
  const Options options = samples::options_for(c);
  const std::vector<Place> alone = refined_alone(c, options);
  for (const Placed placed : {Placed::on_any_rank, Placed::on_a_rank_of_the_curve_in_another_order})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const int count = 2 + static_cast<int>(seed);
      EXPECT_TRUE(refined_parts_on(count, c, options, placed, seed) == alone) << count << " ranks, seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Every, Placements, testing::Range(std::size_t{0}, samples::cases().size()),
                         [](const auto& parameter) { return samples::cases()[parameter.param].name; });

}  // namespace
}  // namespace pardel::engine
