// Data beside the geometry of a domain: markers, attributes, numbers. A mesher may lose or mix them up without harm to
// a single triangle.
#pragma once

#include <cstdint>

#include "../../../core/pslg.hpp"
#include "switches.hpp"

namespace pardel::generators {

enum class Decoration : std::uint8_t {
  own_markers,        ///< points have markers from 0 to 5, half of them 0
  negative_markers,   ///< some points and some segments have negative markers
  huge_markers,       ///< some points and some segments have the least or the greatest number as their marker
  segment_markers,    ///< segments have markers from 0 to 3
  one_attribute,      ///< points have an attribute that is not linear in the coordinates
  three_attributes,   ///< points have three further attributes of different magnitudes and signs, one of them -0
  region_attributes,  ///< regions have the attributes 0, -1, 0.5 or 1e300; some have the same
  numbers_from_one,   ///< messages count from 1
};
/// The name of the enumerator, for example "own_markers".
[[nodiscard]] const char* name(Decoration decoration);

using Decorations = Switches<Decoration, 8>;

/// The domain with these decorations. The data of a point, a segment or a region depend on the seed and on the
/// coordinates only, so they stay when other points are removed. Data that the domain has are replaced by decorations
/// of the same kind.
[[nodiscard]] Pslg decorated(Pslg pslg, const Decorations& decorations);

}  // namespace pardel::generators
