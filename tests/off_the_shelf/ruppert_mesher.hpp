// The reference's sequential algorithm (ref/) as a mesher of subdomains: slow, exact, and independent of the engine.
#pragma once

#include <memory>

#include "../../off_the_shelf/subdomain_mesher.hpp"

namespace pardel {

/// Ruppert's algorithm with three more rules, with which it can serve every scheme:
/// - It inserts a circumcentre only if the centre lies in the cell.
/// - It splits a segment only if it may be split, its midpoint lies in the cell and is representable in doubles, and
///   the midpoint encroaches upon no frozen edge.
/// - A triangle whose circumcentre encroaches upon an edge stays as it is if no such edge can be split.
/// For parts of some hundred triangles: its time is cubic.
[[nodiscard]] std::unique_ptr<SubdomainMesher> ruppert_mesher();

}  // namespace pardel
