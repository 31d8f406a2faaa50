// Ranks that are the processes of an MPI job.
#pragma once

#include "../core/ranks.hpp"

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
  MpiRanks();

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int count() const override { return count_; }
  [[nodiscard]] std::vector<Bytes> exchange(std::vector<Bytes> messages) override;
  void add_up(std::span<std::uint64_t> values) override;

  enum class Step : std::uint64_t { exchange = 1, sum = 2 };
  /// What a rank tells another one before a step.
  struct Announcement {
    std::uint64_t number;  ///< of the step
    Step step;
    std::uint64_t bytes;     ///< of the message, or of the terms of a sum
    std::uint64_t checksum;  ///< of the message; of a sum: 0
    std::uint64_t seal;      ///< of the numbers above
  };

 private:
  [[nodiscard]] std::vector<Announcement> announce(std::vector<Announcement> sent);

  int rank_ = 0;
  int count_ = 1;
  std::uint64_t steps_ = 0;
};

}  // namespace pardel::mpi
