// All cases, on several threads, with outcomes that do not depend on how many.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "trial.hpp"

namespace pardel::harness {

/// Calls work(0) ... work(count - 1) on `jobs` threads, in this order but at the same time. Ends early at the first
/// error and returns it.
[[nodiscard]] Status run_jobs(std::size_t count, int jobs, const std::function<Status(std::size_t)>& work);

/// Outcomes in the order of the cases. Each works in a folder of its own below `work`, which stays if `keep`.
/// `done` is told after each case how many are done, from any thread.
[[nodiscard]] Result<std::vector<Outcome>> run_cases(const Trials& trials, std::span<const CaseId> cases, int jobs,
                                                     const std::filesystem::path& work, bool keep,
                                                     const std::function<void(std::size_t)>& done);

}  // namespace pardel::harness
