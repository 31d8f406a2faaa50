// Work of the mesher as a person at a terminal wants it: it shows how far it is, and Ctrl-C stops it.
#pragma once

#include <functional>

#include "../parallel/mesher.hpp"
#include "interrupt.hpp"
#include "progress_bar.hpp"

namespace pardel::cli {

/// What an interrupted command returns.
[[nodiscard]] Error interrupted();

/// work(options), with options.progress set to draw the bar and to stop at an interrupt.
[[nodiscard]] Result<Meshed> supervise(const Interrupt& interrupt, ShowProgress show, Options options,
                                       const std::function<Result<Meshed>(const Options&)>& work);

}  // namespace pardel::cli
