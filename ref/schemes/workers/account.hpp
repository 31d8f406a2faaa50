// What a run on simulated workers costs. Nothing is timed: work is counted in triangles that are read, so a count is
// the same on every machine. An insertion that is carried out as soon as it is found reads its triangles once. One that
// has to wait, for a choice among several or for its last lock, reads them again when it is carried out.
#pragma once

#include <cstdint>

namespace pardel::schemes {

struct Account {
  std::uint64_t insertions = 0;  ///< of vertices that are in the mesh at the end
  std::uint64_t sequential = 0;  ///< work of one worker while all others wait
  std::uint64_t work = 0;        ///< work of all workers while they work at the same time
  std::uint64_t wasted = 0;      ///< the part of `work` whose result was thrown away
  std::uint64_t critical = 0;    ///< critical path: the work that no number of further workers would save in this run
  std::uint64_t before = 0;      ///< the part of `critical` before workers first work at the same time
  std::uint64_t rounds = 0;      ///< rounds, phases or levels, as the scheme calls them
  std::uint64_t barriers = 0;    ///< points at which all workers wait for the last one
  std::uint64_t set_backs = 0;   ///< insertions that were begun and given up because of another worker
  std::uint64_t messages = 0;    ///< between two workers; what one has for another one in one phase is one message
  std::uint64_t bytes = 0;       ///< of all messages
  std::uint64_t most_held = 0;   ///< triangles that a worker holds at most
  friend bool operator==(const Account&, const Account&) = default;
};

/// What a message has for one triangle: corners, neighbours, segments and region, and coordinates of one new vertex.
inline constexpr std::uint64_t bytes_of_triangle = 56;

/// All work divided by the critical path: the speed-up over one worker that does the same work. 1 without work.
[[nodiscard]] inline double parallelism(const Account& a) {
  return a.critical == 0 ? 1 : static_cast<double>(a.sequential + a.work) / static_cast<double>(a.critical);
}

}  // namespace pardel::schemes
