// Findings: the violations found so far. All are counted; the first few of each kind are kept.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "../model/stoppable.hpp"
#include "../violation.hpp"

namespace pardel::checker {

class Findings {
 public:
  /// Keeps at most `limit` violations of each kind. The search ends if `stop`, which may be null, says so.
  explicit Findings(std::size_t limit, StopSignal* stop = nullptr) : limit_(limit), stop_(stop) {}

  /// Findings that were made elsewhere: counts() and kept().
  Findings(std::size_t limit, std::span<const std::uint64_t> counts, std::vector<Violation> kept);

  /// Counts a violation. True if the list still has room for it; then the caller describes it and calls keep().
  [[nodiscard]] bool admit(ViolationKind kind) { return counts_[index(kind)]++ < limit_; }
  void keep(Violation violation) { kept_.push_back(std::move(violation)); }

  /// Counts a violation and keeps it if the list has room. Use it if the description is cheap or rarely needed.
  void add(ViolationKind kind, std::vector<Index> ids, std::vector<Point> where, Witness witness) {
    if (admit(kind)) keep({kind, std::move(ids), std::move(where), std::move(witness)});
  }

  /// Appends the violations of another list, as if they had been found after the violations of this list.
  void append(Findings other);

  [[nodiscard]] std::uint64_t count(ViolationKind kind) const { return counts_[index(kind)]; }
  /// One entry for each kind.
  [[nodiscard]] std::vector<std::uint64_t> counts() const;
  /// The violations that were kept, in the order of discovery.
  [[nodiscard]] const std::vector<Violation>& kept() const { return kept_; }
  [[nodiscard]] std::size_t limit() const { return limit_; }
  [[nodiscard]] StopSignal* stop() const { return stop_; }

  /// The violations that were kept, sorted by kind; violations of one kind are in the order of discovery.
  [[nodiscard]] std::vector<Violation> sorted() &&;

 private:
  static std::size_t index(ViolationKind kind) { return static_cast<std::size_t>(kind); }

  std::size_t limit_;
  StopSignal* stop_;
  std::array<std::uint64_t, violation_kinds> counts_{};
  std::vector<Violation> kept_;
};

/// Calls check(i, findings), or check(i, findings, share), for all i < n on all threads, as for_each_index() does. The
/// findings of the shares are joined in order, so the result does not depend on the number of threads. Throws Stopped
/// if the search has to end.
template <class Check>
void check_each(std::size_t n, Findings& found, const Check& check) {
  std::vector<Findings> parts(share_count(), Findings(found.limit()));
  for_each_index(n, found.stop(), [&](std::size_t i, std::size_t share) {
    if constexpr (std::is_invocable_v<Check, std::size_t, Findings&, std::size_t>)
      check(i, parts[share], share);
    else
      check(i, parts[share]);
  });
  for (Findings& part : parts) found.append(std::move(part));
}

}  // namespace pardel::checker
