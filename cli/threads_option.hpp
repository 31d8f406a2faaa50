// The option --threads.
#pragma once

#include <omp.h>

#include <CLI/CLI.hpp>
#include <string>

namespace pardel::cli {

/// Adds the option. `result` is what does not depend on the number of threads.
inline CLI::Option* add_threads_option(CLI::App& app, int& threads, const std::string& result) {
  const auto read = [](std::string& text) -> std::string {
    if (text == "all") text = "0";
    return CLI::Range(0, 4096)(text);
  };
  return app
      .add_option("--threads", threads,
                  "Number of threads; 0 or all (default): one per core, or the quota of a container;\n" + result +
                      " does not depend on it")
      ->type_name("N|all")
      ->transform(CLI::Validator(read, ""));
}

/// Makes all steps of the command use this number of threads; 0: as many as the system offers.
inline void use_threads(int threads) {
  if (threads > 0) omp_set_num_threads(threads);
}

}  // namespace pardel::cli
