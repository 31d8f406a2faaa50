#include "in_rounds.hpp"

#include <algorithm>
#include <numeric>

#include "../workers/random.hpp"
#include "../workers/territory.hpp"

namespace pardel::schemes {
namespace {

class Rounds {
 public:
  Rounds(const Problem& problem, const RoundRules& rules, Start start)
      : problem_(problem),
        rules_(rules),
        mesh_(std::move(start.mesh)),
        bounds_(std::move(start.bounds)),
        account_(start.account),
        territory_(mesh_, bounds_, problem.workers),
        waiting_(mesh_.faces.size()) {
    std::iota(waiting_.begin(), waiting_.end(), Index{0});
  }

  [[nodiscard]] Result<Outcome> run() {
    for (;;) {
      Phase finding(problem_.workers);
      const std::vector<Candidate> candidates = propose(finding);
      if (candidates.empty()) break;
      const Chosen chosen = rules_.choose(mesh_, candidates, finding);
      if (rules_.watch) rules_.watch(mesh_, candidates, chosen);
      waste(candidates, chosen, finding);
      finding.end(account_);
      account_.barriers += chosen.depth;
      carry_out_all(candidates, chosen);
      ++account_.rounds;
      if (mesh_.points.size() > problem_.most_points) return too_many_points(problem_);
    }
    account_.most_held = most_owned(mesh_, territory_);
    compact(mesh_);
    return Outcome{std::move(mesh_), account_};
  }

 private:
  /// Every waiting triangle that is in use asks once. A slot may wait twice, if its triangle was replaced.
  [[nodiscard]] std::vector<Candidate> propose(Phase& phase) {
    std::ranges::sort(waiting_);
    waiting_.erase(std::unique(waiting_.begin(), waiting_.end()), waiting_.end());
    std::vector<Candidate> candidates;
    for (const Index t : waiting_) {
      if (!mesh_.in_use(t)) continue;
      std::uint64_t read = 0;
      auto insertion = rules_.propose(mesh_, t, bounds_, read);
      if (!insertion) continue;
      const int worker = territory_.owner(insertion->point);
      phase.work(worker, read + insertion->work());
      const std::uint64_t priority = mixed(mixed(problem_.seed + account_.rounds) + candidates.size());
      candidates.push_back({std::move(*insertion), worker, priority});
      fetch(candidates.back(), phase);
    }
    return candidates;
  }

  /// The owners of the cavity's triangles send them.
  void fetch(const Candidate& candidate, Phase& phase) const {
    for (const Index t : candidate.insertion.cavity.triangles)
      phase.send(territory_.owner(mesh_, t), candidate.worker, bytes_of_triangle);
  }

  /// The cavities of those that are not chosen have been found for nothing.
  static void waste(const std::vector<Candidate>& candidates, const Chosen& chosen, Phase& phase) {
    std::vector<bool> is_chosen(candidates.size(), false);
    for (const std::size_t k : chosen.candidates) is_chosen[k] = true;
    for (std::size_t k = 0; k < candidates.size(); ++k)
      if (!is_chosen[k]) phase.declare_wasted(candidates[k].insertion.work());
  }

  void carry_out_all(const std::vector<Candidate>& candidates, const Chosen& chosen) {
    Phase phase(problem_.workers);
    waiting_.clear();
    changed_.assign(mesh_.faces.size(), false);
    for (const std::size_t k : chosen.candidates) {
      const Candidate& candidate = candidates[k];
      std::optional<Insertion> insertion =
          is_stale(candidate.insertion) ? again(candidate, phase) : candidate.insertion;
      if (!insertion) {
        ++account_.set_backs;
        continue;
      }
      phase.work(candidate.worker, insertion->work());
      const std::vector<Index> made = carry_out(mesh_, *insertion);
      changed_.resize(mesh_.faces.size(), false);
      for (const Index t : insertion->cavity.triangles) changed_[t] = true;
      for (const Index t : made) {
        changed_[t] = true;
        phase.send(candidate.worker, territory_.owner(mesh_, t), bytes_of_triangle);
      }
      waiting_.insert(waiting_.end(), made.begin(), made.end());
      ++account_.insertions;
    }
    // Triangles that are still there ask again.
    for (const Candidate& candidate : candidates) waiting_.push_back(candidate.insertion.triangle);
    phase.end(account_);
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
  [[nodiscard]] std::optional<Insertion> again(const Candidate& candidate, Phase& phase) const {
    if (changed_[candidate.insertion.triangle]) return std::nullopt;
    std::uint64_t read = 0;
    auto insertion = rules_.propose(mesh_, candidate.insertion.triangle, bounds_, read);
    if (insertion) phase.work(candidate.worker, read + insertion->work());
    return insertion;
  }

  const Problem& problem_;
  const RoundRules& rules_;
  LinkedMesh mesh_;
  Bounds bounds_;
  Account account_;
  Territory territory_;
  std::vector<Index> waiting_;  ///< triangles that may need work
  std::vector<bool> changed_;   ///< slots whose triangles were replaced in this round
};

}  // namespace

Result<Outcome> refine_in_rounds(const Problem& problem, const RoundRules& rules) {
  Result<Start> start = start_of(problem);
  if (!start) return start.error();
  return Rounds(problem, rules, std::move(*start)).run();
}

std::vector<std::size_t> by_priority(const std::vector<Candidate>& candidates) {
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t k) { return std::pair(candidates[k].priority, k); });
  return order;
}

}  // namespace pardel::schemes
