// The folder of failures: of each kind one small case, as .poly and as a picture.
#pragma once

#include <filesystem>
#include <string>

#include "card.hpp"
#include "trial.hpp"

namespace pardel::harness {

/// Shrinks the first case of each kind of failure and writes KIND.poly and KIND.svg to `folder`; says so in
/// card.kinds. At most max_runs runs of the mesher per kind, a tenth of that where each takes the whole time limit.
/// `work`: a folder for files that do not last.
[[nodiscard]] Status write_failures(Card& card, const Trials& trials, std::size_t max_runs, int jobs,
                                    const std::filesystem::path& folder, const std::filesystem::path& work);

}  // namespace pardel::harness
