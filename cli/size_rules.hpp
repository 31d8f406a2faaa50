// The places with edge lengths that --sources names.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "../core/goal.hpp"
#include "../core/result.hpp"
#include "../core/size_rules.hpp"
#include "../parallel/validate.hpp"

namespace pardel::cli {

/// Adds the lengths to Goal::sources, and those in regions also to Goal::size. `name` names their file in messages.
/// Error: `invalid_input` with the line of a rule, if it has one, whose marker or region the domain does not have.
[[nodiscard]] Status add_rules(const SizeRules& rules, const std::string& name, const ValidPslg& domain, Goal& goal);

/// Adds the sources to Goal::sources, and the lengths of `size` to Goal::size; an empty function has none.
void add_lengths(const std::function<double(Point)>& size, std::span<const SizeSource> sources, Goal& goal);

}  // namespace pardel::cli
