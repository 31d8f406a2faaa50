// The option --progress.
#pragma once

#include <CLI/App.hpp>

#include "choice.hpp"
#include "names.hpp"
#include "progress_bar.hpp"

namespace pardel::cli {

inline void add_progress_option(CLI::App& app, ShowProgress& show) {
  app.add_option("--progress", show,
                 "Show the current step and its progress: auto (default; on a terminal), always or never")
      ->transform(choice(show_progress_names))
      ->type_name("WHEN");
}

}  // namespace pardel::cli
