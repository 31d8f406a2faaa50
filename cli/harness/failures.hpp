// Writes one small failing case per kind of failure, as .poly and as a picture.
#pragma once

#include <filesystem>
#include <string>

#include "report_card.hpp"
#include "trial.hpp"

namespace pardel::harness {

/// Shrinks the first case of each kind of failure, writes it to `folder` as KIND.poly and KIND.svg, and sets
/// FailureKind::smallest in card.kinds. Runs the mesher at most max_runs times per kind, or max_runs / 10 times if the
/// failure is that the mesher hangs. `work`: a folder for temporary files.
[[nodiscard]] Status write_failures(ReportCard& card, const Trials& trials, std::size_t max_runs, int jobs,
                                    const std::filesystem::path& folder, const std::filesystem::path& work);

}  // namespace pardel::harness
