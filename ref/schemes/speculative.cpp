#include "speculative.hpp"

#include "workers/random.hpp"

namespace pardel::schemes {
namespace {

/// Draws worker numbers.
class RandomWorkers {
 public:
  RandomWorkers(std::uint64_t seed, int workers)
      : seed_(random_number(seed)), workers_(static_cast<std::uint64_t>(workers)) {}
  int next() { return static_cast<int>(random_number(seed_ + drawn_++) % workers_); }

 private:
  std::uint64_t seed_, workers_, drawn_ = 0;
};

/// Prefers steps that achieve nothing. A worker that has waited for `patience` steps per worker has its turn all the
/// same: without this, no rule would help against a worker that tries again for ever.
class Adversary {
 public:
  explicit Adversary(int workers) : served_(static_cast<std::size_t>(workers), 0) {}

  int next(const Speculation& run) {
    ++now_;
    int chosen = -1;
    for (int w = 0; w < static_cast<int>(served_.size()); ++w) {
      if (run.is_idle(w)) {
        served_[static_cast<std::size_t>(w)] = now_;  // it does not wait
      } else if (chosen < 0 || preferred(run, w, chosen)) {
        chosen = w;
      }
    }
    served_[static_cast<std::size_t>(chosen)] = now_;
    return chosen;
  }

 private:
  static constexpr std::uint64_t patience = 32;

  [[nodiscard]] bool preferred(const Speculation& run, int w, int other) const {
    const std::uint64_t since_w = served_[static_cast<std::size_t>(w)];
    const std::uint64_t since_other = served_[static_cast<std::size_t>(other)];
    const auto is_late = [&](std::uint64_t since) { return now_ - since > patience * served_.size(); };
    if (is_late(since_w) || is_late(since_other)) return since_w < since_other;
    const bool gives_up = run.would_set_back(w) == w;
    if (gives_up != (run.would_set_back(other) == other)) return gives_up;
    if (gives_up) return since_w < since_other;
    return run.held(w).size() < run.held(other).size();
  }

  std::vector<std::uint64_t> served_;  ///< when each had its last step
  std::uint64_t now_ = 0;
};

/// Gives steps until all workers are idle. Returns whether they are.
template <class Next>
bool run_until_idle(Speculation& run, const Problem& problem, std::uint64_t most_steps, Next&& next) {
  while (!run.is_over() && run.counts().steps < most_steps && run.points() <= problem.most_points) {
    const int w = next();
    if (!run.is_idle(w)) run.step(w);
  }
  return run.is_over();
}

}  // namespace

Result<Outcome> speculative(const Problem& problem, const SpeculativeOptions& options) {
  Result<Start> start = start_of(problem);
  if (!start) return start.error();
  Speculation run(std::move(start).value(), problem, options.precedence, options.locked);
  const auto with = [&](auto next) { return run_until_idle(run, problem, options.most_steps, next); };
  switch (options.schedule) {
    case Schedule::round_robin:
      with([last = -1, &problem]() mutable { return last = (last + 1) % problem.workers; });
      break;
    case Schedule::random:
      with([random = RandomWorkers(problem.seed, problem.workers)]() mutable { return random.next(); });
      break;
    case Schedule::adversary:
      with([&run, adversary = Adversary(problem.workers)]() mutable { return adversary.next(run); });
      break;
  }
  if (run.points() > problem.most_points) return too_many_points(problem);
  if (!run.is_over())
    return Error{ErrorKind::resources,
                 "The workers have not finished after " + std::to_string(options.most_steps) + " steps."};
  return std::move(run).outcome();
}

}  // namespace pardel::schemes
