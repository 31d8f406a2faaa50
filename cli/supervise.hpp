// Runs the mesher with a progress bar, and stops it at Ctrl-C.
#pragma once

#include <functional>

#include "../parallel/mesher.hpp"
#include "interrupt.hpp"
#include "progress_bar.hpp"

namespace pardel::cli {

/// The error that an interrupted command returns.
[[nodiscard]] Error interrupted();

/// Returns work(options). Sets options.progress to a function that updates the bar and cancels the work at an
/// interrupt.
[[nodiscard]] Result<Meshed> supervise(const Interrupt& interrupt, ProgressBar& bar, Options options,
                                       const std::function<Result<Meshed>(const Options&)>& work);

}  // namespace pardel::cli
