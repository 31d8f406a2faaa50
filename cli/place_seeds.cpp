#include "place_seeds.hpp"

#include <algorithm>
#include <utility>

#include "drawn_faces.hpp"

namespace pardel::cli {

Pslg place_seeds(DrawnDomain domain) {
  Pslg& pslg = domain.pslg;
  if (domain.polygons.empty()) return std::move(pslg);
  const bool only_holes = std::ranges::all_of(domain.polygons, &DrawnPolygon::is_hole);
  for (const DrawnFace& face : drawn_faces(domain)) {
    const DrawnPolygon* material = nullptr;
    bool is_hole = false;
    for (const DrawnPolygon* polygon : face.polygons) {
      is_hole = is_hole || polygon->is_hole;
      if (!polygon->is_hole) material = polygon;
    }
    is_hole = is_hole || (material == nullptr && !only_holes);
    if (is_hole && !face.is_open) pslg.holes.push_back(face.seed);
    if (is_hole || material == nullptr || (!material->attribute && !material->max_area)) continue;
    pslg.regions.push_back(
        {face.seed, material->attribute.value_or(0), material->max_area.value_or(Region{}.max_area)});
  }
  return std::move(pslg);
}

}  // namespace pardel::cli
