// Drawings of unit squares in GeoJSON, of which the covered areas are known.
#pragma once

#include <map>
#include <string>

#include "../core/pslg.hpp"
#include "../properties/domains/generators/random.hpp"

namespace pardel::fuzz {

struct DrawnCells {
  std::string text;                  ///< a FeatureCollection
  std::map<double, double> area_of;  ///< the area by the attribute of its region
};

/// A frame around squares, each a material, a hole or nothing. The sides of the frame may have a vertex at each square,
/// or overlap the sides of the squares, so that the drawing has to be repaired.
[[nodiscard]] DrawnCells any_cells(generators::Random& random);

/// Compares the areas of the regions of the domain with those of the drawing. Returns what differs; "" if nothing does.
[[nodiscard]] std::string difference(const Pslg& domain, const DrawnCells& cells);

}  // namespace pardel::fuzz
