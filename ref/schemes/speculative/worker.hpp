// What a worker of speculative insertion knows.
#pragma once

#include <deque>
#include <optional>

#include "expansion.hpp"

namespace pardel::schemes {

/// Stands for "no worker has the lock".
inline constexpr int no_worker = -1;

/// A bad triangle in a queue.
struct SpeculativeTask {
  Index triangle = no_index;
  std::uint64_t ready = 0;  ///< the clock of the worker that made it
  std::uint64_t age = 0;    ///< insertions are numbered in the order in which they begin; 0 before that
};

/// An insertion that has begun.
struct SpeculativeAttempt {
  SpeculativeTask task;
  Expansion expansion;
  Side split;                ///< the constrained side to be split; none for a circumcentre
  Index next = no_index;     ///< the triangle of the next step; no_index while it writes
  bool has_read = false;     ///< the triangle for which it is
  std::uint64_t steps = 0;   ///< since it began, or since it was given up for the split of a segment
  std::uint64_t writes = 0;  ///< steps that remain until the mesh changes
  Cavity cavity;             ///< while it writes
};

struct SpeculativeWorker {
  std::deque<SpeculativeTask> queue;
  std::optional<SpeculativeAttempt> attempt;
  std::vector<Index> held;  ///< triangles on which it has locks
  std::uint64_t clock = 0;
};

/// What is known of a place in the array of faces.
struct LockMark {
  int holder = no_worker;
  int owner = 0;            ///< the worker in whose part the triangle is
  std::uint64_t freed = 0;  ///< the clock of the last worker that released it
};

}  // namespace pardel::schemes
