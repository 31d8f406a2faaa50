// Ranks that are the processes of an MPI job.
#pragma once

#include "../core/ranks.hpp"

namespace pardel::mpi {

/// All processes of the job (MPI_COMM_WORLD). Uses functions of MPI 3.1 only. Precondition: MPI is initialised, at
/// least with MPI_THREAD_FUNNELED, and the thread that makes the object makes all calls.
///
/// Each message carries the number of the exchange, its length and a checksum. A message that does not match means that
/// the ranks no longer do the same; it throws Stopped with an internal error.
class MpiRanks : public Ranks {
 public:
  MpiRanks();

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int count() const override { return count_; }
  [[nodiscard]] std::vector<Bytes> exchange(std::vector<Bytes> messages) override;
  void add_up(std::span<std::uint64_t> values) override;

 private:
  int rank_ = 0;
  int count_ = 1;
  std::uint64_t exchanges_ = 0;
};

}  // namespace pardel::mpi
