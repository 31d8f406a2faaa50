// Runs all cases on several threads. The outcomes do not depend on the number of threads.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "trial.hpp"

namespace pardel::harness {

/// Calls work(0) ... work(count - 1) on `jobs` threads; the calls start in this order. After an error no further call
/// starts. Returns the first error.
[[nodiscard]] Status run_jobs(std::size_t count, int jobs, const std::function<Status(std::size_t)>& work);

/// Runs the mesher on every case and returns the outcomes in the order of the cases. Each case has its own folder below
/// `work`; the folder is removed afterwards unless `keep` is true. After each case, one of the threads calls `done`
/// with the number of finished cases.
[[nodiscard]] Result<std::vector<Outcome>> run_cases(const Trials& trials, std::span<const CaseId> cases, int jobs,
                                                     const std::filesystem::path& work, bool keep,
                                                     const std::function<void(std::size_t)>& done);

}  // namespace pardel::harness
