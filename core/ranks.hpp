// Ranks: the processes that make one mesh together, and the two ways in which they communicate.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pardel {

/// The view of one process (rank) on all processes of a run. `mpi/` implements it with MPI; the tests implement it with
/// threads of one process. The member functions that communicate are collective: all ranks call the same ones in the
/// same order, from the thread that started the run. They may throw; the exception then ends the run on this rank.
class Ranks {
 public:
  using Bytes = std::vector<std::byte>;

  Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  virtual ~Ranks() = default;

  /// The number of this rank, 0 to count() - 1.
  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int count() const = 0;

  /// Sends messages[r] to rank r, for all r. Returns the messages for this rank; element r came from rank r.
  /// Precondition: messages.size() == count().
  [[nodiscard]] virtual std::vector<Bytes> exchange(std::vector<Bytes> messages) = 0;

  /// Replaces each value by the sum of this value over all ranks, modulo 2^64. All ranks pass equally many values.
  virtual void add_up(std::span<std::uint64_t> values) = 0;
};

}  // namespace pardel
