// Runs all cases on several threads. The outcomes do not depend on the number of threads.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "trial.hpp"

namespace pardel::harness {

/// Calls task(0) ... task(count - 1) on `threads` threads; the calls start in this order. After an error no further
/// call starts. Returns the first error.
[[nodiscard]] Status run_tasks(std::size_t count, int threads, const std::function<Status(std::size_t)>& task);

/// Runs the mesher on every case, on `threads` threads, and returns the outcomes in the order of the cases. Each case
/// has its own folder in `folder`. That folder is removed after the case unless `keep` is true. After each case, one of
/// the threads calls `done` with the number of finished cases.
[[nodiscard]] Result<std::vector<Outcome>> run_cases(const Trials& trials, std::span<const CaseId> cases, int threads,
                                                     const std::filesystem::path& folder, bool keep,
                                                     const std::function<void(std::size_t)>& done);

}  // namespace pardel::harness
