// Gmsh as a mesher of subdomains, called through its library. It is under the GPL, and so is every program that
// contains it; nothing that is installed does. SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>

#include "../../off_the_shelf/subdomain_mesher.hpp"

namespace pardel::bench {

/// Gmsh's 2D Delaunay algorithm. A subdomain becomes plane surfaces whose border lines are not divided; the other edges
/// and points are embedded. So it keeps frozen edges. It has no bound on angles, takes sizes as means, and cannot stop
/// at a number of points. It has global variables: use it in_processes().
[[nodiscard]] std::unique_ptr<SubdomainMesher> gmsh_library();

}  // namespace pardel::bench
