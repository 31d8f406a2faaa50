#include "all_schemes.hpp"

#include "independent_cavities.hpp"
#include "rounds.hpp"
#include "sinks.hpp"

namespace pardel::schemes {
namespace {

/// Ruppert's algorithm on the first worker, while all others wait.
Result<Outcome> one_worker(const Problem& problem) {
  Result<Start> start = start_of(problem);
  if (!start) return start.error();
  auto& [mesh, bounds, account] = *start;
  std::uint64_t work = 0;
  account.insertions = refine_sequentially(mesh, bounds, problem.most_points, &work);
  if (mesh.points.size() >= problem.most_points) return too_many_points(problem);
  compact(mesh);
  account.sequential += work;
  account.critical = account.before = account.sequential;
  account.most_held = mesh.faces.size();
  return Outcome{std::move(mesh), account};
}

}  // namespace

const std::vector<Scheme>& all_schemes() {
  static const std::vector<Scheme> schemes = {
      {"one-worker", "one worker (Ruppert)", one_worker},
      {"closures", "independent cavities, disjoint closures",
       [](const Problem& p) { return independent_cavities(p, Independence::closures); }},
      {"exact", "independent cavities, exact condition",
       [](const Problem& p) { return independent_cavities(p, Independence::exact); }},
      {"sinks", "sinks", [](const Problem& p) { return sinks(p); }},
      {"rounds", "rounds of centres apart", [](const Problem& p) { return rounds(p); }},
      {"rounds-by-class", "rounds of the largest disks",
       [](const Problem& p) { return rounds(p, {.batch = Batch::largest_class}); }},
  };
  return schemes;
}

}  // namespace pardel::schemes
