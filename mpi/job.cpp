#include "job.hpp"

#include <mpi.h>
#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <string>
#include <thread>

#include "../core/support/agree.hpp"
#include "../core/support/short_lived.hpp"

namespace pardel::mpi {

Job::Started::Started() {
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  if (provided < MPI_THREAD_FUNNELED) {
    cli::report({ErrorKind::resources, "this MPI library does not support threads (MPI_THREAD_FUNNELED)"},
                "pardel-mpi");
    MPI_Abort(MPI_COMM_WORLD, static_cast<int>(cli::ExitCode::failure));
  }
}

Job::Job() {
  MPI_Comm here = MPI_COMM_NULL;
  check(MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here));
  int ranks_here = 1;
  MPI_Comm_size(here, &ranks_here);
  MPI_Comm_free(&here);
  // omp_get_num_procs() counts the processors to which this process is bound, omp_get_max_threads() keeps to a quota.
  const auto processors = static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
  const int share = std::min(omp_get_num_procs(), std::max(1, processors / ranks_here));
  const bool has_quota = omp_get_max_threads() < omp_get_num_procs();
  threads_per_rank_ = has_quota ? std::min(share, std::max(1, omp_get_max_threads() / ranks_here)) : share;
  ranks_here_ = static_cast<std::uint64_t>(ranks_here);
}

/// When the first rank has ended with an error that all ranks have, mpirun sends SIGTERM to the ranks that are still
/// ending. They keep the exit status of the error. (InterruptWatch leaves out signals that the process ignores.)
Job::~Job() {
  std::signal(SIGTERM, SIG_IGN);
  MPI_Finalize();
}

Status Job::agree(const Status& here) { return pardel::agree(here, ranks_); }

void Job::abort(const Error& error) {
  (void)leave_nothing_behind();  // no destructor runs
  // If all ranks have the same error, the first one ends the others before they print it, too.
  if (!is_first()) std::this_thread::sleep_for(std::chrono::milliseconds(500));
  const cli::ExitCode code =
      cli::report({error.kind, "rank " + std::to_string(ranks_.rank()) + ": " + error.message}, "pardel-mpi");
  // Some launchers end their processes at once, and lose what has not reached them yet.
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  MPI_Abort(MPI_COMM_WORLD, static_cast<int>(code));
  std::_Exit(static_cast<int>(code));
}

}  // namespace pardel::mpi
