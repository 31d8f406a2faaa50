// The mesher's options, with a progress bar.
#pragma once

#include <utility>

#include "../parallel/options.hpp"
#include "progress_bar.hpp"

namespace pardel::cli {

/// The same options, with a function `progress` that updates the bar. The bar must outlive the run.
[[nodiscard]] inline Options with_progress(Options options, ProgressBar& bar) {
  bar.begin("triangulating");
  options.progress = [&bar](const Progress& progress) {
    if (progress.triangles > 0) bar.update(progress.triangles, progress.estimate);
    return true;
  };
  return options;
}

}  // namespace pardel::cli
