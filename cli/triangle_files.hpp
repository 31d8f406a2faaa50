// Which files Triangle would read and write for its switches.
#pragma once

#include <string>

#include "../core/formats.hpp"
#include "triangle_switches.hpp"

namespace pardel::cli {

/// "name" becomes "name.1", "name.1" becomes "name.2"; with switch I "name" stays.
[[nodiscard]] std::string next_name(const std::string& name, bool no_iteration);

/// What to write. node_was_read: the points came from a .node file, which switch I must not replace.
[[nodiscard]] TriangleFiles files_to_write(const TriangleSwitches& switches, int base, bool node_was_read);

}  // namespace pardel::cli
