// What ranks discard: work in gathered submeshes that were too small.
#include <set>
#include <string>
#include <utility>

#include "../../../distributed/delaunay/triangulated_points.hpp"
#include "../../../distributed/divided_input/divided_points.hpp"
#include "../../../distributed/divided_input/part_of_domain.hpp"
#include "../../../parallel/scheduling/progress_monitor.hpp"
#include "../../../parallel/scheduling/refine_by_sweeps.hpp"
#include "../../domains/dealt_domain.hpp"
#include "../../domains/domains.hpp"
#include "../framework/local_ranks.hpp"
#include "meshing.hpp"

namespace pardel::properties {
namespace {

/// Counts what is inserted into the submeshes that the first rank gathers.
class CountedSubmeshes : public engine::DividedPoints {
 public:
  using DividedPoints::DividedPoints;

  [[nodiscard]] engine::Waiting refine_coarse(const CoarseWork& work) override {
    CoarseWork watched = work;
    watched.refine_submesh = [&](const GatheredSubmesh& submesh, std::vector<engine::TriangleId>& changed) {
      const std::size_t before = begin_attempt(submesh);
      engine::Waiting waiting = work.refine_submesh(submesh, changed);
      end_attempt(submesh, changed, before);
      return waiting;
    };
    engine::Waiting waiting = DividedPoints::refine_coarse(watched);
    inserted_ = 0;  // into the last submesh, which was large enough
    is_first_ = true;
    return waiting;
  }
  void refine_rest(const RestOfWork& work) override {
    RestOfWork watched = work;
    watched.refine_submesh = [&](const GatheredSubmesh& submesh) {
      const std::size_t before = begin_attempt(submesh);
      std::vector<engine::TriangleId> changed = work.refine_submesh(submesh);
      end_attempt(submesh, changed, before);
      return changed;
    };
    DividedPoints::refine_rest(watched);
  }

  std::uint64_t too_small = 0;  ///< submeshes
  std::uint64_t discarded = 0;  ///< vertices that were inserted into them

 private:
  [[nodiscard]] std::size_t begin_attempt(const GatheredSubmesh& submesh) {
    if (!std::exchange(is_first_, false)) ++too_small;
    discarded += inserted_;
    return submesh.t.points.size();
  }
  /// Every new vertex is a corner of a changed triangle.
  void end_attempt(const GatheredSubmesh& submesh, const std::vector<engine::TriangleId>& changed, std::size_t before) {
    std::set<engine::VertexId> fresh;
    for (const engine::TriangleId id : changed)
      for (const engine::VertexId v : submesh.t.slots[id].v)
        if (v >= before) fresh.insert(v);
    inserted_ = fresh.size();
  }

  bool is_first_ = true;
  std::uint64_t inserted_ = 0;
};

struct Discards {
  std::uint64_t inserted, counted;  ///< by the run
  std::uint64_t too_small, seen;    ///< by the test
};

/// Refines on ranks of which each begins with an equal part of the points and segments.
Discards discards_of(const Problem& problem, const Options& options, int count) {
  Discards found{};
  on_ranks(count, [&](Ranks& ranks) {
    PartOfPslg input = domains::equal_part(problem.pslg, ranks);
    input.points.attributes_per_point = 0;
    input.points.point_attributes.clear();
    engine::ProgressMonitor progress(options);
    auto points = engine::triangulated(std::move(input.points), ranks, progress.threads());
    if (!points) throw Stopped{points.error()};
    auto part = engine::part_of_domain(**points, {input.segments, input.rest}, problem.goal.convex_hull, ranks,
                                       progress.threads());
    if (!part) throw Stopped{part.error()};
    std::vector<double> caps;
    for (const Region& region : input.rest.regions) caps.push_back(region.max_area);
    const engine::Criteria criteria(problem.goal, options.placement, caps);
    const engine::CurveDivision division = (*points)->division;
    CountedSubmeshes watched(ranks, *part, division);
    const auto counts = engine::refine_by_sweeps(part->domain.triangulation, part->domain.segments, criteria, options,
                                                 progress, {}, {}, watched);
    if (!counts) throw Stopped{counts.error()};
    if (ranks.rank() == 0)
      found =
          Discards{counts->inserted + counts->segment_splits, counts->discarded, watched.too_small, watched.discarded};
  });
  return found;
}

/// A domain with a bound on areas.
Problem with_area_bound(Pslg pslg, double max_area) {
  Problem problem{std::move(pslg), {}};
  problem.goal.max_area = max_area;
  return problem;
}

PARDEL_FACT(Ranks, discard_only_what_was_inserted_into_submeshes_that_were_too_small,
            {.statement = "Ranks that begin with parts of a domain discard what was inserted into gathered submeshes "
                          "that were too small, and nothing else. The counts of a run have each of these vertices. On "
                          "coasts they are fewer than those that stay.",
             .source = "[CC], no set-backs; properties/THEORY_OF_RANKS.md, Ranks (e)",
             .families = "coasts of 500 to 2,000 points; a square, a pipe, a key and random points; two to four ranks; "
                         "up to some ten thousand triangles"}) {
  int with_discards = 0;
  std::uint64_t inserted = 0, discarded = 0;
  for (const std::uint64_t points : {500U, 1000U, 2000U})
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U})
      for (const int ranks : {2, 3, 4}) {
        const Problem coast = with_area_bound(domains::coast(points, seed), 1e-3);
        const Discards found = discards_of(coast, {.threads = 1, .triangles_per_tile = 100}, ranks);
        ++facts.cases;
        EXPECT_EQ(found.counted, found.seen) << points << " points, seed " << seed;
        EXPECT_LT(found.counted, found.inserted) << points << " points, seed " << seed;
        with_discards += found.seen > 0 ? 1 : 0;
        inserted += found.inserted;
        discarded += found.counted;
      }
  EXPECT_GE(with_discards, 9);
  facts.notes.push_back("Coasts: " + std::to_string(discarded) + " vertices discarded, " + std::to_string(inserted) +
                        " inserted; " + std::to_string(with_discards) + " of 36 runs discard some.");
  const std::pair<const char*, Problem> others[] = {
      {"square", with_area_bound(domains::square(), 5e-5)},
      {"pipe", with_area_bound(domains::pipe(), 1e-4)},
      {"key", with_area_bound(domains::key(), 3e-4)},
      {"random points", with_area_bound(domains::random_points(5000, 1), INFINITY)},
      {"larger coast", with_area_bound(domains::coast(2000, 1), 1e-4)}};
  for (const auto& [name, problem] : others) {
    const Discards found = discards_of(problem, {.threads = 1, .triangles_per_tile = 500}, 4);
    ++facts.cases;
    EXPECT_EQ(found.counted, found.seen) << name;
    facts.notes.push_back(std::string(name) + ": " + std::to_string(found.counted) + " discarded, " +
                          std::to_string(found.inserted) + " inserted, " + std::to_string(found.too_small) +
                          " submeshes too small.");
  }
}

}  // namespace
}  // namespace pardel::properties
