#include "kadow.hpp"

#include <algorithm>
#include <numeric>

#include "kadow/parted_mesh.hpp"
#include "workers/random.hpp"

namespace pardel::schemes {
namespace {

/// The workers in the order in which a round simulates them.
std::vector<int> order_of_workers(int workers, std::uint64_t& random) {
  std::vector<int> order(static_cast<std::size_t>(workers));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[random_number(random++) % k]);
  return order;
}

/// A triangle that is set back, and what its request tells the dedicated processor.
struct Request {
  Index triangle;
  std::uint64_t read;
};

class Refinement {
 public:
  Refinement(PartedStart start, const Problem& problem, const KadowOptions& options)
      : problem_(problem), options_(options), bounds_(start.bounds), random_(problem.seed) {
    run_.outcome.account = start.account;
    run_.held_at_start = start.account.most_held;
    parted_ = parted_mesh(std::move(start));
    requests_.resize(parted_.held.size());
  }

  Result<KadowRun> run() && {
    while (std::ranges::any_of(parted_.waiting, [](const auto& list) { return !list.empty(); })) {
      run_.parts_divided +=
          divide_large_parts(parted_, options_.division, options_.least_to_divide, run_.outcome.account);
      let_workers_work();
      let_dedicated_processor_work();
      ++run_.outcome.account.rounds;
      note_held();
      if (parted_.mesh.points.size() > problem_.most_points) return too_many_points(problem_);
    }
    run_.outcome.account.insertions += run_.by_dedicated + run_.by_workers;
    for (Index t = 0; t < parted_.mesh.faces.size(); ++t)
      if (parted_.mesh.in_use(t)) run_.owner.push_back(parted_.owner[t]);
    compact(parted_.mesh);
    run_.outcome.mesh = std::move(parted_.mesh);
    return std::move(run_);
  }

 private:
  void let_workers_work() {
    Phase phase(problem_.workers);
    for (const int worker : order_of_workers(problem_.workers, random_)) work(worker, phase);
    phase.end(run_.outcome.account);
  }

  void work(int worker, Phase& phase) {
    std::deque<Index>& waiting = parted_.waiting[static_cast<std::size_t>(worker)];
    for (std::size_t inserted = 0; inserted < options_.per_round && !waiting.empty();) {
      const Index t = waiting.front();
      waiting.pop_front();
      // The dedicated processor may have given the place of the triangle to one of another worker, where it waits.
      if (!parted_.mesh.in_use(t) || parted_.owner[t] != worker) continue;
      const std::optional<Insertion> insertion = insertion_for(parted_.mesh, t, bounds_);
      if (!insertion) continue;
      if (is_local(parted_, *insertion, worker)) {
        phase.work(worker, insertion->work());
        carry_out(parted_, *insertion);
        ++run_.by_workers;
        ++inserted;
      } else {
        const std::uint64_t read = read_before_interface(parted_, *insertion, worker);
        phase.waste(worker, read);
        requests_[static_cast<std::size_t>(worker)].push_back({t, read});
      }
    }
  }

  /// One request after the other, worker by worker. A request that an earlier one has settled needs nothing.
  void let_dedicated_processor_work() {
    Account& account = run_.outcome.account;
    bool has_work = false;
    for (std::vector<Request>& requests : requests_) {
      if (requests.empty()) continue;
      has_work = true;
      ++account.messages;
      account.set_backs += requests.size();
      for (const auto& [t, read] : requests) {
        account.bytes += read * bytes_of_triangle;
        if (parted_.mesh.in_use(t)) settle(t, account);
      }
      requests.clear();
    }
    if (has_work) ++account.barriers;
  }

  void settle(Index t, Account& account) {
    const std::optional<Insertion> insertion = insertion_for(parted_.mesh, t, bounds_);
    if (!insertion) return;
    account.sequential += insertion->work();
    account.critical += insertion->work();
    run_.destroyed += interfaces_inside(parted_, insertion->cavity);
    // All owners must agree: each is told the new triangles.
    account.messages += owners_of(parted_, insertion->cavity).size();
    account.bytes += insertion->cavity.boundary.size() * bytes_of_triangle;
    carry_out(parted_, *insertion);
    ++run_.by_dedicated;
  }

  void note_held() {
    std::uint64_t& most = run_.outcome.account.most_held;
    most = std::max(most, *std::ranges::max_element(parted_.held));
  }

  const Problem& problem_;
  const KadowOptions& options_;
  Bounds bounds_;
  std::uint64_t random_;
  PartedMesh parted_;
  std::vector<std::vector<Request>> requests_;  ///< of each worker
  KadowRun run_;
};

}  // namespace

Result<KadowRun> kadow_in_detail(const Problem& problem, const KadowOptions& options) {
  Result<PartedStart> start = parted_start(problem, options.division);
  if (!start) return start.error();
  return Refinement(std::move(start).value(), problem, options).run();
}

Result<Outcome> kadow(const Problem& problem, const KadowOptions& options) {
  Result<KadowRun> run = kadow_in_detail(problem, options);
  if (!run) return run.error();
  return std::move(run->outcome);
}

}  // namespace pardel::schemes
