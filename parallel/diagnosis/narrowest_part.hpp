// The width of the narrowest connected part of a domain.
#pragma once

#include "../construction/domain_triangulation.hpp"

namespace pardel::engine {

/// The width of a part is twice its area divided by its perimeter, which is the width of a long strip, and half of the
/// side of a square. Infinity for a domain without triangles. O(n).
[[nodiscard]] double narrowest_part(const DomainTriangulation& domain);

}  // namespace pardel::engine
