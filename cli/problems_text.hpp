// The problems of a domain as text, and advice on what to do about them.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "../parallel/validate.hpp"

namespace pardel::cli {

/// What most commands call the option that meshes the convex hull.
inline constexpr std::string_view option_of_hull = "--convex-hull";

/// The only problem on one line; or the number of problems, and ten of each kind on lines of their own.
[[nodiscard]] std::string problems_text(std::span<const Problem> problems, const NumbersInMessages& numbers);

/// Names loops that are given twice, and the commands and options that help, each after a line break; empty if there
/// are none. `file`: the name of the domain. `repair_failed`: repair() was tried and cannot help. `hull_option`: what
/// the command calls the option that meshes the convex hull.
[[nodiscard]] std::string advice(const Pslg& pslg, std::span<const Problem> problems, const std::string& file,
                                 bool repair_failed, std::string_view hull_option = option_of_hull);

}  // namespace pardel::cli
