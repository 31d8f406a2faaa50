// Findings: the violations met so far. All are counted, the first few of each kind are kept.
#pragma once

#include <omp.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "../check.hpp"

namespace pardel::checker {

inline constexpr std::size_t violation_kinds = static_cast<std::size_t>(ViolationKind::wrong_attribute) + 1;

class Findings {
 public:
  /// Keeps at most `limit` violations of each kind.
  explicit Findings(std::size_t limit) : limit_(limit) {}

  /// Counts a violation and says whether its story is still wanted; then keep() follows.
  [[nodiscard]] bool wants(ViolationKind kind) { return counts_[index(kind)]++ < limit_; }
  void keep(Violation violation) { kept_.push_back(std::move(violation)); }

  /// For rare violations: counts, and keeps within the limit.
  void add(ViolationKind kind, std::vector<Index> ids, std::vector<Point> where, std::string witness) {
    if (wants(kind)) keep({kind, std::move(ids), std::move(where), std::move(witness)});
  }

  /// Appends what another has found, as if it had been found after this.
  void append(Findings other);

  [[nodiscard]] std::uint64_t count(ViolationKind kind) const { return counts_[index(kind)]; }
  /// By kind.
  [[nodiscard]] std::vector<std::uint64_t> counts() const;
  [[nodiscard]] std::size_t limit() const { return limit_; }

  /// The violations kept, by kind, and within a kind in the order of discovery.
  [[nodiscard]] std::vector<Violation> sorted() &&;

 private:
  static std::size_t index(ViolationKind kind) { return static_cast<std::size_t>(kind); }

  std::size_t limit_;
  std::array<std::uint64_t, violation_kinds> counts_{};
  std::vector<Violation> kept_;
};

/// Loops shorter than this are not worth waking other threads for.
inline constexpr std::size_t worth_threads = 1 << 13;

/// judge(i, findings) for all i < n on all threads. Each thread takes one run of consecutive indices and
/// the runs are joined in order, so that the findings do not depend on the number of threads.
template <class Judge>
void judge_all(std::size_t n, Findings& found, const Judge& judge) {
  std::vector<Findings> parts(static_cast<std::size_t>(omp_get_max_threads()), Findings(found.limit()));
#pragma omp parallel if (n >= worth_threads)
  {
    Findings& mine = parts[static_cast<std::size_t>(omp_get_thread_num())];
#pragma omp for schedule(static)
    for (std::size_t i = 0; i < n; ++i) judge(i, mine);
  }
  for (Findings& part : parts) found.append(std::move(part));
}

}  // namespace pardel::checker
