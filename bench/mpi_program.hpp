// The main function of a benchmark that mpirun starts.
#pragma once

#include <mpi.h>

namespace pardel::bench {

/// Returns run(argc, argv), in an MPI job.
inline int run_in_job(int argc, char** argv, int (*run)(int argc, char** argv)) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  const int code = run(argc, argv);
  MPI_Finalize();
  return code;
}

}  // namespace pardel::bench
