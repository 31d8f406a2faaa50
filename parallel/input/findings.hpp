// The search for problems: the list that collects them, and the whole search as a part of a run.
#pragma once

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>
#include <vector>

#include "../concurrency/threads.hpp"
#include "../validate.hpp"

namespace pardel::engine {

/// Keeps up to `most` problems of each kind.
class Findings {
 public:
  explicit Findings(std::size_t most) : most_(most) {}

  void add(ProblemKind kind, std::vector<Index> ids, Point where) {
    if (count_[static_cast<std::size_t>(kind)]++ < most_) problems_.push_back({kind, std::move(ids), where});
  }
  [[nodiscard]] bool any(ProblemKind kind) const { return count_[static_cast<std::size_t>(kind)] > 0; }
  [[nodiscard]] bool empty() const { return problems_.empty(); }
  /// The problems, sorted by kind, then by ids.
  std::vector<Problem> sorted() && {
    std::ranges::sort(problems_, [](const Problem& p, const Problem& q) {
      return std::tie(p.kind, p.ids) < std::tie(q.kind, q.ids);
    });
    return std::move(problems_);
  }

 private:
  std::size_t most_;
  std::array<std::size_t, static_cast<std::size_t>(ProblemKind::bad_region_cap) + 1> count_{};
  std::vector<Problem> problems_;
};

/// pardel::find_problems() as a part of a run. The threads replace options.threads and options.go_on. Throws Stopped if
/// the run has to end.
[[nodiscard]] std::vector<Problem> find_problems(const Pslg& pslg, const ValidateOptions& options,
                                                 const Threads& threads);

/// The problems of a point set except duplicate points, of which the Delaunay triangulation finds the first one anyway.
/// The search for all of them takes a twentieth of the time of the triangulation. Precondition: is_point_set(pslg).
[[nodiscard]] std::vector<Problem> find_problems_but_duplicates(const Pslg& pslg, const Threads& threads);

}  // namespace pardel::engine
