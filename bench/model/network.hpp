// A network with a latency and a bandwidth, and what the functions of MPI take on it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pardel::bench {

/// What one rank sends and receives in an exchange.
struct Traffic {
  std::uint32_t messages_out = 0, messages_in = 0;
  std::uint64_t bytes_out = 0, bytes_in = 0;
};

/// Every rank has a link of its own. Links do not disturb each other.
struct Network {
  double latency = 2e-6;    ///< seconds from the start of a message to its arrival, if it is empty
  double bandwidth = 10e9;  ///< bytes per second of a link, in each direction

  /// MPI_Alltoall with `bytes` for each pair of ranks: in log2(ranks) rounds with half of everything (Bruck et al.
  /// 1997), or in pairs, whatever is faster.
  [[nodiscard]] double all_to_all(int ranks, double bytes) const {
    const double in_rounds = rounds(ranks) * (latency + bytes * ranks / 2 / bandwidth);
    const double in_pairs = (ranks - 1) * (latency + bytes / bandwidth);
    return std::min(in_rounds, in_pairs);
  }
  /// MPI_Allreduce of `bytes`: by recursive doubling, or by a scattered reduction and a collection (Rabenseifner 2004),
  /// whatever is faster. The additions themselves count as nothing.
  [[nodiscard]] double all_reduce(int ranks, double bytes) const {
    const double by_doubling = rounds(ranks) * (latency + bytes / bandwidth);
    const double scattered = 2 * rounds(ranks) * latency + 2 * bytes / bandwidth * (ranks - 1) / ranks;
    return std::min(by_doubling, scattered);
  }
  /// The messages of one rank. They leave, and arrive, one after the other.
  [[nodiscard]] double messages(const Traffic& t) const {
    return latency * std::max(t.messages_out, t.messages_in) +
           static_cast<double>(std::max(t.bytes_out, t.bytes_in)) / bandwidth;
  }

 private:
  [[nodiscard]] static double rounds(int ranks) { return std::ceil(std::log2(ranks)); }
};

}  // namespace pardel::bench
