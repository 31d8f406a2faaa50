#include "in_rounds.hpp"

#include <algorithm>
#include <numeric>

#include "../../../core/support/without_repetitions.hpp"
#include "../workers/random.hpp"
#include "ledger.hpp"

namespace pardel::schemes {
namespace {

class Rounds {
 public:
  Rounds(const Problem& problem, const RoundRules& rules, const std::vector<int>& workers, Start start)
      : problem_(problem),
        rules_(rules),
        mesh_(std::move(start.mesh)),
        bounds_(std::move(start.bounds)),
        waiting_(mesh_.faces.size()) {
    std::iota(waiting_.begin(), waiting_.end(), Index{0});
    for (const int count : workers) ledgers_.emplace_back(mesh_, bounds_, count, start.account);
  }

  [[nodiscard]] Result<SharedOutcome> run() {
    for (std::uint64_t round = 0;; ++round) {
      const std::vector<Candidate> candidates = propose(round);
      if (candidates.empty()) break;
      const Chosen chosen = rules_.choose(mesh_, candidates);
      if (rules_.watch) rules_.watch(mesh_, candidates, chosen);
      waste(candidates, chosen);
      for (Ledger& ledger : ledgers_) {
        ledger.end_phase();
        ledger.end_choice(chosen.depth);
      }
      carry_out_all(candidates, chosen);
      for (Ledger& ledger : ledgers_) {
        ledger.end_phase();
        ledger.end_round();
      }
      if (mesh_.points.size() > problem_.most_points) return too_many_points(problem_);
    }
    SharedOutcome outcome;
    for (Ledger& ledger : ledgers_) outcome.accounts.push_back(ledger.close(mesh_));
    compact(mesh_);
    outcome.mesh = std::move(mesh_);
    return outcome;
  }

 private:
  /// Every waiting triangle that is in use asks once. A slot may wait twice, if its triangle was replaced.
  [[nodiscard]] std::vector<Candidate> propose(std::uint64_t round) {
    sort_without_repetitions(waiting_);
    std::vector<Candidate> candidates;
    for (const Index t : waiting_) {
      if (!mesh_.in_use(t)) continue;
      std::uint64_t read = 0;
      auto insertion = rules_.propose(mesh_, t, bounds_, read);
      if (!insertion) continue;
      const std::uint64_t compared = insertion->cavity.triangles.size();
      for (Ledger& ledger : ledgers_) ledger.find(mesh_, *insertion, read + insertion->work() + compared);
      const std::uint64_t priority = random_number(random_number(problem_.seed + round) + candidates.size());
      candidates.push_back({std::move(*insertion), priority});
    }
    return candidates;
  }

  /// The cavities of those that are not chosen have been found for nothing.
  void waste(const std::vector<Candidate>& candidates, const Chosen& chosen) {
    std::vector<bool> is_chosen(candidates.size(), false);
    for (const std::size_t k : chosen.candidates) is_chosen[k] = true;
    std::uint64_t wasted = 0;
    for (std::size_t k = 0; k < candidates.size(); ++k)
      if (!is_chosen[k]) wasted += candidates[k].insertion.work();
    for (Ledger& ledger : ledgers_) ledger.waste(wasted);
  }

  void carry_out_all(const std::vector<Candidate>& candidates, const Chosen& chosen) {
    waiting_.clear();
    changed_.assign(mesh_.faces.size(), false);
    for (const std::size_t k : chosen.candidates) {
      const Insertion& found = candidates[k].insertion;
      const std::optional<Insertion> insertion = is_stale(found) ? again(found) : found;
      if (!insertion) {
        for (Ledger& ledger : ledgers_) ledger.set_back();
        continue;
      }
      const std::vector<Index> made = carry_out(mesh_, *insertion);
      for (Ledger& ledger : ledgers_) ledger.carry_out(mesh_, *insertion, made);
      changed_.resize(mesh_.faces.size(), false);
      for (const Index t : insertion->cavity.triangles) changed_[t] = true;
      for (const Index t : made) changed_[t] = true;
      waiting_.insert(waiting_.end(), made.begin(), made.end());
    }
    // Triangles that are still there ask again.
    for (const Candidate& candidate : candidates) waiting_.push_back(candidate.insertion.triangle);
  }

  /// Has the round changed a triangle of the cavity, or made one beside it whose circumdisk contains the point?
  [[nodiscard]] bool is_stale(const Insertion& insertion) const {
    const auto grows = [&](Side side) {
      const Index beyond = mesh_.faces[side.triangle].n[side.i];
      return beyond != no_index && !is_constrained(mesh_, side) && changed_[beyond] &&
             circumdisk_contains(mesh_, beyond, insertion.point);
    };
    return std::ranges::any_of(insertion.cavity.triangles, [&](Index t) { return changed_[t]; }) ||
           std::ranges::any_of(insertion.cavity.boundary, grows);
  }

  /// The insertion after others of the same round; nothing if its triangle has been replaced.
  [[nodiscard]] std::optional<Insertion> again(const Insertion& before) {
    if (changed_[before.triangle]) return std::nullopt;
    std::uint64_t read = 0;
    std::optional<Insertion> insertion = rules_.propose(mesh_, before.triangle, bounds_, read);
    if (insertion)
      for (Ledger& ledger : ledgers_) ledger.find_again(*insertion, read + insertion->work());
    return insertion;
  }

  const Problem& problem_;
  const RoundRules& rules_;
  LinkedMesh mesh_;
  Bounds bounds_;
  std::vector<Ledger> ledgers_;
  std::vector<Index> waiting_;  ///< triangles that may need work
  std::vector<bool> changed_;   ///< slots whose triangles were replaced in this round
};

}  // namespace

Result<SharedOutcome> refine_in_rounds(const Problem& problem, const RoundRules& rules,
                                       const std::vector<int>& workers) {
  Result<Start> start = start_of(problem);
  if (!start) return start.error();
  return Rounds(problem, rules, workers, std::move(*start)).run();
}

Result<Outcome> refine_in_rounds(const Problem& problem, const RoundRules& rules) {
  Result<SharedOutcome> shared = refine_in_rounds(problem, rules, {problem.workers});
  if (!shared) return shared.error();
  return Outcome{std::move(shared->mesh), shared->accounts.front()};
}

std::vector<std::size_t> by_priority(const std::vector<Candidate>& candidates) {
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t k) { return std::pair(candidates[k].priority, k); });
  return order;
}

}  // namespace pardel::schemes
