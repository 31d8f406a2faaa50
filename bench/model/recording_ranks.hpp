// Ranks that record what a run does: the processor time between calls, and the bytes to each rank.
#pragma once

#include <numeric>
#include <utility>
#include <vector>

#include "../../core/ranks.hpp"
#include "thread_time.hpp"

namespace pardel::bench {

/// A call of exchange() or add_up() by one rank.
struct RecordedCall {
  bool is_sum = false;
  std::uint64_t bytes = 0;             ///< of a sum
  std::vector<std::uint64_t> to = {};  ///< of an exchange: the bytes of the message to each rank; 0 to itself
  double seconds = 0;                  ///< processor time of this thread since the call before

  [[nodiscard]] std::uint64_t bytes_out() const { return std::accumulate(to.begin(), to.end(), std::uint64_t{0}); }
};

/// Passes all calls on to other Ranks. For runs with one thread per rank.
class RecordingRanks : public Ranks {
 public:
  explicit RecordingRanks(Ranks& ranks) : ranks_(ranks) {}

  [[nodiscard]] int rank() const override { return ranks_.rank(); }
  [[nodiscard]] int count() const override { return ranks_.count(); }
  [[nodiscard]] std::vector<Bytes> exchange(std::vector<Bytes> messages) override {
    RecordedCall call{.seconds = watch_.lap()};
    for (const Bytes& message : messages) call.to.push_back(message.size());
    call.to[static_cast<std::size_t>(rank())] = 0;
    calls_.push_back(std::move(call));
    std::vector<Bytes> arrived = ranks_.exchange(std::move(messages));
    watch_.lap();
    return arrived;
  }
  void add_up(std::span<std::uint64_t> values) override {
    calls_.push_back({.is_sum = true, .bytes = values.size_bytes(), .seconds = watch_.lap()});
    ranks_.add_up(values);
    watch_.lap();
  }

  [[nodiscard]] const std::vector<RecordedCall>& calls() const { return calls_; }
  /// The processor time since the last call.
  [[nodiscard]] double seconds_after() { return watch_.lap(); }

 private:
  Ranks& ranks_;
  ThreadWatch watch_;
  std::vector<RecordedCall> calls_;
};

}  // namespace pardel::bench
