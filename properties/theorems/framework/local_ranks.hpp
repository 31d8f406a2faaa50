// Ranks that are threads of one process.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "../../../core/ranks.hpp"
#include "../../../core/support/exception_of.hpp"
#include "../../../core/support/stop_signal.hpp"
#include "../../domains/generators/random.hpp"

namespace pardel::properties {

/// What the ranks have in common. If a rank ends while others wait for it, or if ranks call different functions, the
/// functions throw Stopped on all ranks.
class LocalNetwork {
 public:
  explicit LocalNetwork(int count) : count_(count), letters_(count), values_(count) {}

  /// Called by a rank that makes no more calls.
  void leave() {
    const std::scoped_lock lock(mutex_);
    has_left_ = true;
    changed_.notify_all();
  }

 private:
  friend class LocalRanks;

  /// Waits until all ranks have come to this place with the same `what`.
  void meet(const char* what) {
    std::unique_lock lock(mutex_);
    if (waiting_ > 0 && what_ != what) is_broken_ = true;
    what_ = what;
    const std::uint64_t meeting = meetings_;
    if (++waiting_ == count_) {
      waiting_ = 0;
      ++meetings_;
      changed_.notify_all();
    }
    changed_.wait(lock, [&] { return meetings_ != meeting || has_left_ || is_broken_; });
    if (meetings_ != meeting && !is_broken_) return;
    is_broken_ = true;
    changed_.notify_all();
    throw Stopped{{ErrorKind::internal, "the ranks do not do the same"}};
  }

  int count_;
  std::mutex mutex_;
  std::condition_variable changed_;
  int waiting_ = 0;
  std::uint64_t meetings_ = 0;
  const char* what_ = nullptr;
  bool has_left_ = false, is_broken_ = false;
  std::vector<std::vector<Ranks::Bytes>> letters_;  ///< [from][to]
  std::vector<std::vector<std::uint64_t>> values_;  ///< [from]
};

class LocalRanks : public Ranks {
 public:
  /// delays: if not 0, the rank waits for a random time of up to 50 microseconds before it communicates; a seed.
  LocalRanks(LocalNetwork& network, int rank, std::uint64_t delays = 0)
      : network_(network), rank_(rank), delays_(delays), random_(delays + static_cast<std::uint64_t>(rank)) {}

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int count() const override { return network_.count_; }
  [[nodiscard]] std::vector<Bytes> exchange(std::vector<Bytes> messages) override {
    delay();
    network_.letters_[rank_] = std::move(messages);
    network_.meet("exchange");
    std::vector<Bytes> arrived;
    for (auto& from : network_.letters_) arrived.push_back(std::move(from[rank_]));
    network_.meet("after exchange");
    return arrived;
  }
  void add_up(std::span<std::uint64_t> values) override {
    delay();
    network_.values_[rank_].assign(values.begin(), values.end());
    network_.meet("add up");
    std::fill(values.begin(), values.end(), 0);
    for (const std::vector<std::uint64_t>& from : network_.values_)
      for (std::size_t i = 0; i < values.size(); ++i) values[i] += from.at(i);
    network_.meet("after add up");
  }

 private:
  void delay() {
    if (delays_ != 0) std::this_thread::sleep_for(std::chrono::microseconds(random_.below(50)));
  }

  LocalNetwork& network_;
  int rank_;
  std::uint64_t delays_;
  generators::Random random_;
};

/// Calls work(ranks) on each of `count` ranks, at the same time. Then throws the exception of the first rank that threw
/// one.
inline void on_ranks(int count, const std::function<void(Ranks&)>& work, std::uint64_t delays = 0) {
  LocalNetwork network(count);
  std::vector<std::thread> threads;
  threads.reserve(static_cast<std::size_t>(count));
  std::vector<std::exception_ptr> thrown(count);
  for (int rank = 0; rank < count; ++rank)
    threads.emplace_back([&, rank] {
      LocalRanks ranks(network, rank, delays);
      thrown[rank] = exception_of([&] { work(ranks); });
      network.leave();
    });
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& exception : thrown)
    if (exception) std::rethrow_exception(exception);
}

}  // namespace pardel::properties
