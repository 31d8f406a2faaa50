// The files that Triangle reads and writes for its switches.
#pragma once

#include <string>

#include "../core/formats.hpp"
#include "triangle_switches.hpp"

namespace pardel::cli {

/// The stem of the output for the input stem `name`: "name.1" for "name", "name.2" for "name.1"; with switch I `name`.
[[nodiscard]] std::string next_name(const std::string& name, bool no_iteration);

/// `base`: the number of the first vertex in the files, 0 or 1. `node_was_read`: the points were read from a .node
/// file; with switch I this file is not written again.
[[nodiscard]] TriangleFiles files_to_write(const TriangleSwitches& switches, int base, bool node_was_read);

}  // namespace pardel::cli
