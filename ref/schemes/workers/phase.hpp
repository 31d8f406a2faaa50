// The work and the messages of simulated workers between two barriers.
#pragma once

#include <algorithm>
#include <numeric>
#include <unordered_set>
#include <vector>

#include "account.hpp"

namespace pardel::schemes {

class Phase {
 public:
  explicit Phase(int workers) : work_(static_cast<std::size_t>(workers), 0) {}

  void work(int worker, std::uint64_t amount) { work_[static_cast<std::size_t>(worker)] += amount; }
  /// Work whose result is thrown away. It also counts as work.
  void waste(int worker, std::uint64_t amount) {
    work(worker, amount);
    wasted_ += amount;
  }
  /// This much of the work has turned out to be for nothing.
  void declare_wasted(std::uint64_t amount) { wasted_ += amount; }
  /// All bytes from one worker to another one are one message. No effect if both are the same worker.
  void send(int from, int to, std::uint64_t bytes) {
    if (from == to) return;
    pairs_.insert(static_cast<std::uint64_t>(from) * work_.size() + static_cast<std::uint64_t>(to));
    bytes_ += bytes;
  }

  /// The end of the phase: all workers wait for the last one.
  void end(Account& account) const {
    if (account.work == 0) account.before = account.critical;
    account.work += std::accumulate(work_.begin(), work_.end(), std::uint64_t{0});
    account.critical += *std::ranges::max_element(work_);
    account.wasted += wasted_;
    account.messages += pairs_.size();
    account.bytes += bytes_;
    ++account.barriers;
  }

 private:
  std::vector<std::uint64_t> work_;
  std::uint64_t wasted_ = 0, bytes_ = 0;
  std::unordered_set<std::uint64_t> pairs_;
};

}  // namespace pardel::schemes
