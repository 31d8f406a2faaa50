// The MPI job: how it starts, agrees, and ends.
#pragma once

#include <string>

#include "../cli/exit_code.hpp"
#include "../core/result.hpp"
#include "mpi_ranks.hpp"

namespace pardel::mpi {

/// Initialises MPI, and finalises it at the end.
class Job {
 public:
  Job();
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;
  ~Job();

  [[nodiscard]] MpiRanks& ranks() { return ranks_; }
  [[nodiscard]] bool is_first() const { return ranks_.rank() == 0; }
  [[nodiscard]] int count() const { return ranks_.count(); }
  /// The processors of this machine, or those of its quota, divided by the number of ranks on it; not more than those
  /// to which this process is bound; at least 1.
  [[nodiscard]] int threads_per_rank() const { return threads_per_rank_; }
  /// The number of ranks on this machine.
  [[nodiscard]] std::uint64_t ranks_here() const { return ranks_here_; }

  /// Collective. Done if all ranks pass Done. Otherwise the error of the first rank that failed; its message names the
  /// rank, unless all ranks failed.
  [[nodiscard]] Status agree(const Status& here);

  /// Ends all ranks, because this one cannot go on and the others wait for it. Prints the error.
  [[noreturn]] void abort(const Error& error);

 private:
  struct Started {
    Started();
  };
  Started started_;
  MpiRanks ranks_;
  int threads_per_rank_ = 1;
  std::uint64_t ranks_here_ = 1;
};

}  // namespace pardel::mpi
