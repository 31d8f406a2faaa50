// Independent cavities (Edelsbrunner and Guoy), and this project's exact condition.
#include "../../../ref/schemes/independent_cavities.hpp"

#include "../../domains/domains.hpp"
#include "same_triangles.hpp"
#include "some_problem.hpp"

namespace pardel::properties {
namespace {

using schemes::Candidate;
using schemes::Chosen;
using schemes::Independence;
using schemes::LinkedMesh;

constexpr const char* edelsbrunner_guoy = "Edelsbrunner, Guoy 2001, section 6";

Independence some_independence() { return *rc::gen::element(Independence::closures, Independence::exact); }

/// Runs the rounds and calls watch(mesh, candidates, chosen) in each.
template <class Watch>
schemes::Outcome watched(const SchemeCase& c, Independence when, const Watch& watch) {
  schemes::RoundRules rules = schemes::rules_of_independent_cavities(when);
  rules.watch = watch;
  return required(schemes::refine_in_rounds(c.problem(), rules));
}

PARDEL_PROPERTY(IndependentCavities, every_run_is_certified,
                {.statement = "Rounds of maximal sets of insertions whose cavities have disjoint closures, or that are "
                              "independent by the exact condition, end with a mesh that the checker certifies.",
                 .source = edelsbrunner_guoy,
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  const schemes::Outcome outcome = required(schemes::independent_cavities(c.problem(), some_independence()));
  classify(outcome.account.rounds > 3, "more than three rounds", 30);
  certify(outcome.mesh, c, exhibit);
}

PARDEL_PROPERTY(
    IndependentCavities, chosen_cavities_do_not_meet,
    {.statement = "Every two insertions of a round are independent: their cavities have no vertex in common, "
                  "or the exact condition holds.",
     .source = "properties/THEORY.md, T1-closures and T1-iff",
     .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  const Independence when = some_independence();
  std::size_t most = 0;
  (void)watched(c, when, [&](const LinkedMesh& mesh, const std::vector<Candidate>& all, const Chosen& chosen) {
    most = std::max(most, chosen.candidates.size());
    for (const std::size_t p : chosen.candidates)
      for (const std::size_t q : chosen.candidates)
        if (p < q) RC_ASSERT(schemes::are_independent(mesh, all[p].insertion, all[q].insertion, when));
  });
  classify(most > 2, "a round with more than two insertions", 30);
}

PARDEL_PROPERTY(IndependentCavities, every_set_is_maximal,
                {.statement = "Every insertion that is not chosen meets one that is.",
                 .source = edelsbrunner_guoy,
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  const Independence when = some_independence();
  std::size_t rejected = 0;
  (void)watched(c, when, [&](const LinkedMesh& mesh, const std::vector<Candidate>& all, const Chosen& chosen) {
    for (std::size_t p = 0; p < all.size(); ++p) {
      const auto meets = [&](std::size_t q) {
        return p == q || !schemes::are_independent(mesh, all[p].insertion, all[q].insertion, when);
      };
      RC_ASSERT(std::ranges::any_of(chosen.candidates, meets));
    }
    rejected += all.size() - chosen.candidates.size();
  });
  classify(rejected > 0, "an insertion has to wait", 40);
}

PARDEL_PROPERTY(
    IndependentCavities, disjoint_closures_imply_the_exact_condition,
    {.statement = "Insertions whose cavities have disjoint closures are independent by the exact condition.",
     .source = "properties/THEORY.md, T1-closures",
     .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  bool apart = false, only_exactly = false;
  (void)watched(c, Independence::exact, [&](const LinkedMesh& mesh, const std::vector<Candidate>& all, const Chosen&) {
    for (std::size_t p = 0; p < all.size(); ++p)
      for (std::size_t q = 0; q < p; ++q) {
        const bool by_closures =
            schemes::are_independent(mesh, all[p].insertion, all[q].insertion, Independence::closures);
        const bool exactly = schemes::are_independent(mesh, all[p].insertion, all[q].insertion, Independence::exact);
        RC_ASSERT(exactly || !by_closures);
        apart = apart || by_closures;
        only_exactly = only_exactly || (exactly && !by_closures);
      }
  });
  classify(apart, "disjoint closures", 40);
  classify(only_exactly, "independent although the closures meet", 30);
}

PARDEL_PROPERTY(IndependentCavities, the_order_within_a_round_changes_nothing,
                {.statement = "The insertions of a round, with the cavities that were found before it, give the "
                              "same constrained Delaunay triangles in any order.",
                 .source = "properties/THEORY.md, T1-iff",
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  bool several = false;
  (void)watched(c, some_independence(),
                [&](const LinkedMesh& mesh, const std::vector<Candidate>& all, const Chosen& chosen) {
                  LinkedMesh forward = mesh, backward = mesh;
                  for (const std::size_t k : chosen.candidates) schemes::carry_out(forward, all[k].insertion);
                  for (auto k = chosen.candidates.rbegin(); k != chosen.candidates.rend(); ++k)
                    schemes::carry_out(backward, all[*k].insertion);
                  RC_ASSERT(placed_triangles(forward) == placed_triangles(backward));
                  RC_ASSERT(is_locally_delaunay(forward));
                  several = several || chosen.candidates.size() > 1;
                });
  classify(several, "a round with several insertions", 50);
}

PARDEL_PROPERTY(IndependentCavities, the_mesh_does_not_depend_on_workers,
                {.statement = "Any number of workers makes the same mesh with the same work.",
                 .source = "ref/schemes/rounds/in_rounds.hpp",
                 .families = scheme_families}) {
  SchemeCase c = some_scheme_case(exhibit);
  const Independence when = some_independence();
  const schemes::Outcome many = required(schemes::independent_cavities(c.problem(), when));
  classify(c.workers > 1, "several workers", 70);
  c.workers = 1;
  const schemes::Outcome one = required(schemes::independent_cavities(c.problem(), when));
  RC_ASSERT(placed_triangles(one.mesh) == placed_triangles(many.mesh));
  RC_ASSERT(one.account.work == many.account.work && one.account.wasted == many.account.wasted);
  RC_ASSERT(one.account.messages == 0U && one.account.bytes == 0U);
  RC_ASSERT(one.account.critical == one.account.sequential + one.account.work);
}

PARDEL_PROPERTY(IndependentCavities, all_cavities_are_paid_for,
                {.statement = "Each round finds the cavities of all candidates. What was found for those that are not "
                              "chosen is wasted. No insertion is set back.",
                 .source = "[CC], on independent cavities; ref/schemes/workers/account.hpp",
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  std::uint64_t found = 0, chosen_work = 0, compared = 0, insertions = 0;
  const schemes::Outcome outcome =
      watched(c, some_independence(), [&](const LinkedMesh&, const std::vector<Candidate>& all, const Chosen& chosen) {
        for (const Candidate& k : all) {
          found += k.insertion.work();
          compared += k.insertion.cavity.triangles.size();
        }
        for (const std::size_t k : chosen.candidates) chosen_work += all[k].insertion.work();
        insertions += chosen.candidates.size();
      });
  classify(found > chosen_work, "something is wasted", 40);
  RC_ASSERT(outcome.account.work == found + compared + chosen_work);
  RC_ASSERT(outcome.account.wasted == found - chosen_work);
  RC_ASSERT(outcome.account.insertions == insertions);
  RC_ASSERT(outcome.mesh.points.size() == c.pslg.points.size() + insertions);
  RC_ASSERT(outcome.account.set_backs == 0U);
}

PARDEL_FACT(IndependentCavities, the_exact_condition_needs_fewer_rounds,
            {.statement = "On the square, the pipe and the key, the exact condition needs at most 0.7 times as many "
                          "rounds as disjoint closures, and admits larger sets in the first rounds.",
             .source = "properties/THEORY.md, T1-iff",
             .families = "square, pipe, key"}) {
  Goal goal;
  goal.max_area = 1e-3;
  for (const Pslg& pslg : {domains::square(), domains::pipe(), domains::key()}) {
    const schemes::Problem problem{pslg, goal};
    const auto by_closures = schemes::independent_cavities(problem, Independence::closures);
    const auto exactly = schemes::independent_cavities(problem, Independence::exact);
    ASSERT_TRUE(by_closures && exactly);
    EXPECT_LE(static_cast<double>(exactly->account.rounds), 0.7 * static_cast<double>(by_closures->account.rounds));
    EXPECT_LT(exactly->account.wasted, by_closures->account.wasted);
    facts.notes.push_back(std::to_string(by_closures->account.rounds) + " rounds with disjoint closures, " +
                          std::to_string(exactly->account.rounds) + " with the exact condition");
    ++facts.cases;
  }
}

PARDEL_FACT(IndependentCavities, cavities_that_share_a_vertex_may_be_independent,
            {.statement = "Two cavities have one vertex in common and are independent: disjoint closures are "
                          "sufficient, not necessary.",
             .source = "properties/THEORY.md, T1-iff",
             .families = "stored witness"}) {
  // Two bow-ties: acute triangles that meet in the origin only, with flat ones above and below.
  Pslg pslg;
  pslg.points = {{0, 0}, {-4, 2}, {-4, -2}, {4, -2}, {4, 2}};
  pslg.segments = {{1, 2, 0}, {2, 3, 0}, {3, 4, 0}, {4, 1, 0}};
  const Goal goal{.min_angle_deg = 0};
  const auto start = schemes::start_of({pslg, goal});
  ASSERT_TRUE(start);
  std::vector<schemes::Insertion> left_and_right;
  for (Index t = 0; t < start->mesh.faces.size(); ++t) {
    const Point centre = schemes::circumcentre(start->mesh, t);
    if (centre.y == 0) left_and_right.push_back({t, centre, {}, schemes::cavity_of(start->mesh, centre, {t})});
  }
  ASSERT_EQ(left_and_right.size(), 2U);
  EXPECT_FALSE(schemes::are_independent(start->mesh, left_and_right[0], left_and_right[1], Independence::closures));
  EXPECT_TRUE(schemes::are_independent(start->mesh, left_and_right[0], left_and_right[1], Independence::exact));
  facts.cases = 1;
}

}  // namespace
}  // namespace pardel::properties
