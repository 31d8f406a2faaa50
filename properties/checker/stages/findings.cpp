#include "findings.hpp"

#include <algorithm>
#include <iterator>

namespace pardel::checker {

Findings::Findings(std::size_t limit, std::span<const std::uint64_t> counts, std::vector<Violation> kept)
    : Findings(limit) {
  std::copy_n(counts.begin(), std::min(counts.size(), counts_.size()), counts_.begin());
  kept_ = std::move(kept);
}

void Findings::append(Findings other) {
  for (Violation& violation : other.kept_) {
    // A violation is kept if fewer than limit_ violations of its kind come before it.
    const std::size_t kind = index(violation.kind);
    if (counts_[kind] >= limit_) continue;
    ++counts_[kind];
    --other.counts_[kind];
    kept_.push_back(std::move(violation));
  }
  for (std::size_t kind = 0; kind < violation_kinds; ++kind) counts_[kind] += other.counts_[kind];
}

std::vector<std::uint64_t> Findings::counts() const { return {counts_.begin(), counts_.end()}; }

std::vector<Violation> Findings::sorted() && {
  std::stable_sort(kept_.begin(), kept_.end(), [](const Violation& a, const Violation& b) { return a.kind < b.kind; });
  return std::move(kept_);
}

}  // namespace pardel::checker
