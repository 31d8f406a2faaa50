// Rounds of independent points (Spielman, Teng, Üngör).
#include "../../../ref/schemes/rounds.hpp"

#include <cmath>

#include "../../../ref/schemes/independent_cavities.hpp"
#include "../../domains/domains.hpp"
#include "same_triangles.hpp"
#include "some_problem.hpp"

namespace pardel::properties {
namespace {

using schemes::Batch;
using schemes::Candidate;
using schemes::Chosen;
using schemes::LinkedMesh;
using schemes::Priority;
using schemes::RoundChoices;

constexpr const char* spielman_teng_uengoer = "Spielman, Teng, Üngör 2002, section 3";

RoundChoices some_choices() {
  return {*rc::gen::element(Batch::all, Batch::largest_class),
          *rc::gen::element(Priority::random, Priority::largest_first)};
}

template <class Watch>
schemes::Outcome watched(const SchemeCase& c, const RoundChoices& choices, const Watch& watch) {
  schemes::RoundRules rules = schemes::rules_of_rounds(choices);
  rules.watch = watch;
  return required(schemes::refine_in_rounds(c.problem(), rules));
}

bool share_a_triangle(const schemes::Insertion& p, const schemes::Insertion& q) {
  return std::ranges::any_of(p.cavity.triangles,
                             [&](Index t) { return std::ranges::count(q.cavity.triangles, t) > 0; });
}

PARDEL_PROPERTY(Rounds, every_run_is_certified,
                {.statement = "Rounds of centres apart end with a mesh that the checker certifies, whatever takes part "
                              "in a round and in whatever order it is considered.",
                 .source = spielman_teng_uengoer,
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  certify(required(schemes::rounds(c.problem(), some_choices())).mesh, c, exhibit);
}

PARDEL_PROPERTY(Rounds, chosen_centres_are_apart,
                {.statement = "Of every two centres of a round whose cavities share a triangle, the distance is at "
                              "least the smaller of their radii.",
                 .source = spielman_teng_uengoer,
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  bool overlap = false;
  (void)watched(c, some_choices(),
                [&](const LinkedMesh& mesh, const std::vector<Candidate>& all, const Chosen& chosen) {
                  for (const std::size_t p : chosen.candidates)
                    for (const std::size_t q : chosen.candidates) {
                      if (p >= q || !share_a_triangle(all[p].insertion, all[q].insertion)) continue;
                      RC_ASSERT(!schemes::conflict(mesh, all[p].insertion, all[q].insertion));
                      overlap = true;
                    }
                });
  classify(overlap, "cavities of one round overlap", 15);
}

PARDEL_PROPERTY(
    Rounds, every_set_is_maximal,
    {.statement = "With all triangles in each round, every centre that is not chosen conflicts with one that "
                  "is.",
     .source = spielman_teng_uengoer,
     .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  const RoundChoices choices{Batch::all, some_choices().priority};
  bool rejected = false;
  (void)watched(c, choices, [&](const LinkedMesh& mesh, const std::vector<Candidate>& all, const Chosen& chosen) {
    for (std::size_t p = 0; p < all.size(); ++p) {
      if (std::ranges::count(chosen.candidates, p) > 0) continue;
      rejected = true;
      RC_ASSERT(std::ranges::any_of(chosen.candidates, [&](std::size_t q) {
        return schemes::conflict(mesh, all[p].insertion, all[q].insertion);
      }));
    }
  });
  classify(rejected, "a centre has to wait", 30);
}

PARDEL_PROPERTY(Rounds, the_disk_of_each_triangle_is_empty_when_its_turn_comes,
                {.statement = "Inserted one after the other, the largest disk first, no centre lies in the disk of a "
                              "bad triangle that comes later: one worker could have made the same mesh.",
                 .source = "Spielman, Teng, Üngör 2002, section 3 (sequential order)",
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  bool several = false;
  (void)watched(c, some_choices(),
                [&](const LinkedMesh& mesh, const std::vector<Candidate>& all, const Chosen& chosen) {
                  for (std::size_t late = 1; late < chosen.candidates.size(); ++late)
                    for (std::size_t early = 0; early < late; ++early) {
                      const schemes::Insertion& p = all[chosen.candidates[early]].insertion;
                      const schemes::Insertion& q = all[chosen.candidates[late]].insertion;
                      RC_ASSERT(schemes::squared_radius(mesh, p) >= schemes::squared_radius(mesh, q));
                      if (q.splits_segment() || !share_a_triangle(p, q)) continue;
                      const double distance = std::hypot(p.point.x - q.point.x, p.point.y - q.point.y);
                      RC_ASSERT(distance >= (1 - 1e-9) * std::sqrt(schemes::squared_radius(mesh, q)));
                      several = true;
                    }
                });
  classify(several, "a disk that an earlier centre could have entered", 5);
}

PARDEL_PROPERTY(Rounds, the_mesh_does_not_depend_on_workers,
                {.statement = "Any number of workers makes the same mesh.",
                 .source = "ref/schemes/rounds/in_rounds.hpp",
                 .families = scheme_families}) {
  SchemeCase c = some_scheme_case(exhibit);
  const RoundChoices choices = some_choices();
  const schemes::Outcome many = required(schemes::rounds(c.problem(), choices));
  c.workers = 1;
  RC_ASSERT(placed_triangles(required(schemes::rounds(c.problem(), choices)).mesh) == placed_triangles(many.mesh));
}

PARDEL_PROPERTY(
    Rounds, there_are_few_rounds,
    {.statement = "The number of rounds is at most 4 (1 + log2(L/s))², where L is the diameter of the domain "
                  "and s is the shortest edge of the mesh.",
     .source = "Spielman, Teng, Üngör 2002, theorem on the number of iterations; the constant is measured",
     .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  const schemes::Outcome outcome = required(schemes::rounds(c.problem(), some_choices()));
  const auto distance = [](Point p, Point q) { return std::hypot(p.x - q.x, p.y - q.y); };
  double longest = 0, shortest = INFINITY;
  for (const Point p : c.pslg.points) longest = std::max(longest, distance(p, c.pslg.points.front()));
  for (Index t = 0; t < outcome.mesh.faces.size(); ++t)
    for (int i = 0; i < 3; ++i)
      shortest = std::min(shortest, distance(outcome.mesh.corner(t, i), outcome.mesh.corner(t, (i + 1) % 3)));
  const double levels = 1 + std::log2(longest / shortest);
  classify(outcome.account.rounds > 5, "more than five rounds", 20);
  RC_ASSERT(static_cast<double>(outcome.account.rounds) <= 4 * levels * levels);
}

PARDEL_FACT(Rounds, rounds_grow_with_the_logarithm_of_the_mesh,
            {.statement = "With all bad triangles in each round, a square of m triangles needs at most 2.5 log2(m) "
                          "rounds, and 16 times as many triangles at most 12 rounds more.",
             .source = "Spielman, Teng, Üngör 2004: O(log m) rounds; the constants are measured",
             .families = "the square with about 500, 8,000 and 130,000 triangles"}) {
  const Pslg square = domains::square();
  std::uint64_t before = 0;
  for (const double area : {3.2e-3, 2e-4, 1.25e-5}) {
    Goal goal;
    goal.max_area = area;
    const auto outcome = schemes::rounds({square, goal});
    ASSERT_TRUE(outcome);
    const std::uint64_t rounds = outcome->account.rounds;
    const auto triangles = static_cast<double>(outcome->mesh.faces.size());
    EXPECT_LE(static_cast<double>(rounds), 2.5 * std::log2(triangles));
    if (before != 0) {
      EXPECT_LE(rounds, before + 12);
    }
    before = rounds;
    facts.notes.push_back(std::to_string(outcome->mesh.faces.size()) + " triangles in " + std::to_string(rounds) +
                          " rounds");
    ++facts.cases;
  }
}

PARDEL_FACT(Rounds, fewer_rounds_than_with_independent_cavities,
            {.statement = "On the square, rounds of centres apart are at most half as many as rounds of cavities with "
                          "disjoint closures: cavities of one round may overlap. In exchange, insertions are set back.",
             .source = spielman_teng_uengoer,
             .families = "the square with about 16,000 triangles"}) {
  const Pslg square = domains::square();
  Goal goal;
  goal.max_area = 1e-4;
  const auto apart = schemes::rounds({square, goal});
  const auto cavities = schemes::independent_cavities({square, goal});
  ASSERT_TRUE(apart && cavities);
  EXPECT_GT(apart->account.set_backs, 0U);
  EXPECT_LE(2 * apart->account.rounds, cavities->account.rounds);
  facts.notes.push_back(std::to_string(apart->account.rounds) + " rounds against " +
                        std::to_string(cavities->account.rounds) + ", " + std::to_string(apart->account.set_backs) +
                        " insertions set back");
  facts.cases = 1;
}

}  // namespace
}  // namespace pardel::properties
