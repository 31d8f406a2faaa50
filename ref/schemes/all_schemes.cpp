#include "all_schemes.hpp"

#include "decoupling.hpp"
#include "given_points.hpp"
#include "independent_cavities.hpp"
#include "kadow.hpp"
#include "lattice.hpp"
#include "load_balancing.hpp"
#include "quadtree.hpp"
#include "region_boxes.hpp"
#include "rounds.hpp"
#include "sinks.hpp"
#include "speculative.hpp"

namespace pardel::schemes {
namespace {

/// Ruppert's algorithm on the first worker, while all others wait.
Result<Outcome> one_worker(const Problem& problem) {
  Result<Start> start = start_of(problem);
  if (!start) return start.error();
  auto& [mesh, bounds, account] = *start;
  const std::size_t inputs = mesh.points.size();
  const std::uint64_t work = refine_sequentially(mesh, bounds, problem.most_points);
  if (mesh.points.size() >= problem.most_points) return too_many_points(problem);
  account.insertions = mesh.points.size() - inputs;
  compact(mesh);
  account.sequential += work;
  account.critical = account.before = account.sequential;
  account.most_held = mesh.faces.size();
  return Outcome{std::move(mesh), account};
}

/// Runs a scheme whose mesh depends on the number of workers.
template <class Run>
Result<std::vector<Outcome>> each(const Problem& problem, const std::vector<int>& workers, const Run& run) {
  std::vector<Outcome> outcomes;
  for (const int count : workers) {
    Problem one = problem;
    one.workers = count;
    Result<Outcome> outcome = run(one);
    if (!outcome) return outcome.error();
    outcomes.push_back(std::move(*outcome));
  }
  return outcomes;
}

Result<std::vector<Outcome>> all_rounds(const Problem& problem, const std::vector<int>& workers,
                                        const RoundRules& rules) {
  Result<SharedOutcome> shared = refine_in_rounds(problem, rules, workers);
  if (!shared) return shared.error();
  std::vector<Outcome> outcomes;
  for (const Account& account : shared->accounts) outcomes.push_back({{}, account});
  outcomes.front().mesh = std::move(shared->mesh);
  return outcomes;
}

}  // namespace

const std::vector<Scheme>& all_schemes() {
  using Workers = std::vector<int>;
  static const std::vector<Scheme> schemes = {
      {"one-worker", "one worker (Ruppert)", [](const Problem& p, const Workers& w) { return each(p, w, one_worker); }},
      {"closures", "independent cavities, disjoint closures",
       [](const Problem& p, const Workers& w) {
         return all_rounds(p, w, rules_of_independent_cavities(Independence::closures));
       }},
      {"exact", "independent cavities, exact condition",
       [](const Problem& p, const Workers& w) {
         return all_rounds(p, w, rules_of_independent_cavities(Independence::exact));
       }},
      {"sinks", "sinks",
       [](const Problem& p, const Workers& w) { return all_rounds(p, w, rules_of_sinks(Independence::closures)); }},
      {"rounds", "rounds of centres apart",
       [](const Problem& p, const Workers& w) { return all_rounds(p, w, rules_of_rounds({})); }},
      {"rounds-by-class", "rounds of the largest disks",
       [](const Problem& p, const Workers& w) {
         return all_rounds(p, w, rules_of_rounds({.batch = Batch::largest_class}));
       }},
      {"speculative", "speculative insertion",
       [](const Problem& p, const Workers& w) {
         return each(p, w, [](const Problem& one) { return speculative(one); });
       }},
      {"decoupling", "decoupling",
       [](const Problem& p, const Workers& w) {
         return each(p, w, [](const Problem& one) { return decoupling(one); });
       }},
      {"lattice", "lattice of cells 4 r wide",
       [](const Problem& p, const Workers& w) { return each(p, w, [](const Problem& one) { return lattice(one); }); }},
      {"lattice-2r", "lattice of cells 2 r wide",
       [](const Problem& p, const Workers& w) {
         return each(p, w, [](const Problem& one) { return lattice(one, {.side = CellSide::two_radii}); });
       }},
      {"quadtree", "quadtree",
       [](const Problem& p, const Workers& w) { return each(p, w, [](const Problem& one) { return quadtree(one); }); }},
      {"boxes", "tasks that own boxes",
       [](const Problem& p, const Workers& w) {
         return each(p, w, [](const Problem& one) { return region_boxes(one); });
       }},
      {"load-balancing", "tiles that migrate",
       [](const Problem& p, const Workers& w) {
         return each(p, w, [](const Problem& one) { return load_balancing(one); });
       }},
      {"kadow", "projected parts (Kadow, Walkington)",
       [](const Problem& p, const Workers& w) { return each(p, w, [](const Problem& one) { return kadow(one); }); }},
      {"given-points", "divide and conquer of given points",
       [](const Problem& p, const Workers& w) {
         return each(p, w, [](const Problem& one) { return triangulate_given_points(one); });
       },
       false},
  };
  return schemes;
}

}  // namespace pardel::schemes
