// CGAL's Mesh_2 as a mesher of subdomains. It is under the GPL, and so is every program that contains it; nothing that
// is installed does. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "../../off_the_shelf/subdomain_mesher.hpp"

namespace pardel::bench {

/// Mesh_2 splits every constrained edge upon which a point encroaches, on either side, from the start, and whatever its
/// criteria say. So that it keeps frozen edges, it gets the part of the subdomain whose frozen edges have no such point
/// (triangles at the others stay as they are), and the criteria accept triangles whose circumcentre would be such a
/// point. They also accept triangles whose circumcentre is outside the cell. So it serves all schemes.
[[nodiscard]] std::unique_ptr<SubdomainMesher> cgal_mesh_2();

/// The same with segments that may be split, if they lie in the cell. Where two segments meet, or a segment
/// and a frozen edge, a split of the one may still make Mesh_2 split the other: such an answer is a breach.
[[nodiscard]] std::unique_ptr<SubdomainMesher> cgal_mesh_2_with_segments();

}  // namespace pardel::bench
