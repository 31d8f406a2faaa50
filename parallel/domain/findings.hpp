// The list that collects problems.
#pragma once

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>
#include <vector>

#include "../problem.hpp"

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

}  // namespace pardel::engine
