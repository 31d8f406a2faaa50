// Runs programs on the ranks of an MPI job in a temporary folder. All ranks run on this machine.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "../cli/program.hpp"

namespace pardel::testing {

/// Sets the environment of jobs that this process starts. `folder`: where they may make a folder of their own.
inline void prepare_for_jobs(const std::filesystem::path& folder) {
  // Open MPI does not start as root unless it is told to.
  setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
  setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
  // All jobs of a user share one folder by default. One that ends removes it while another one expects it to be there.
  setenv("OMPI_MCA_orte_tmpdir_base", (folder / "session").c_str(), 1);
  // Ranks and threads that wait leave the processors to others. Else jobs take many times as long on a busy machine.
  setenv("OMPI_MCA_mpi_yield_when_idle", "1", 1);
  setenv("OMP_WAIT_POLICY", "passive", 1);
}

class MpiWorkshop : public Workshop {
 protected:
  MpiWorkshop() { prepare_for_jobs(folder_); }
  Ran on_ranks(int ranks, const std::string& program, const std::vector<std::string>& arguments) const {
    std::vector<std::string> all{"--oversubscribe", "--bind-to", "none", "-n", std::to_string(ranks), program};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run(PARDEL_MPIRUN, all);
  }
};

}  // namespace pardel::testing
