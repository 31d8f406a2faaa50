// The option --snap of the commands that repair a domain.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <optional>
#include <string>

namespace pardel::cli {

/// Adds the option. It needs `repair`.
inline void add_snap_option(CLI::App& app, std::optional<double>& snap, CLI::Option* repair) {
  const auto check = [](const std::string& text) -> std::string {
    double value = 0;
    if (CLI::detail::lexical_cast(text, value) && value >= 0 && std::isfinite(value)) return {};
    return fmt::format("'{}' is not a distance: a finite number, zero or greater", text);
  };
  app.add_option(
         "--snap", snap,
         "Close gaps smaller than this (default: 3.6e-12 of the largest coordinate of the segments at the gap,\n"
         "and up to 9.3e-10 if it is much narrower than these segments; 0: merge equal points only)")
      ->check(check)
      ->type_name("LENGTH")
      ->needs(repair);
}

}  // namespace pardel::cli
