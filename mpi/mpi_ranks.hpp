// Ranks that are the processes of an MPI job.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../core/ranks.hpp"

namespace pardel {
struct Announcement;
}

namespace pardel::mpi {

/// Throws Stopped with an internal error if a function of MPI returns an error. Without MpiRanks, MPI would end the job
/// with an exit status of its own.
void check(int code);

/// All processes of the job (MPI_COMM_WORLD). Uses functions of MPI 3.1 only. Precondition: MPI is initialised, at
/// least with MPI_THREAD_FUNNELED, and the thread that makes the object makes all calls.
///
/// Before each step the ranks tell each other what they are about to do: the number of the step, whether it is an
/// exchange or a sum, the lengths of messages and their checksums. What does not match means that the ranks no longer
/// do the same; it throws Stopped with an internal error, before anybody waits for a message that does not come. From
/// the first object on, functions on MPI_COMM_WORLD return errors; check() their results.
class MpiRanks : public Ranks {
 public:
  /// Longer messages travel in parts, because MPI counts the bytes of a message with an int. `bytes_per_part`: from 1
  /// to 2^31 - 1, the same on all ranks. A message has at most 32,768 parts, because their numbers are tags of MPI.
  explicit MpiRanks(std::size_t bytes_per_part = std::size_t{1} << 30U);

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int count() const override { return count_; }
  [[nodiscard]] std::vector<Bytes> exchange(std::vector<Bytes> messages) override;
  void add_up(std::span<std::uint64_t> values) override;

 private:
  [[nodiscard]] std::vector<Announcement> announce(std::vector<Announcement> sent);

  std::size_t bytes_per_part_;
  int rank_ = 0;
  int count_ = 1;
  std::uint64_t steps_ = 0;
};

}  // namespace pardel::mpi
