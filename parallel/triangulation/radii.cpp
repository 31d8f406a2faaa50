#include "radii.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "../threads/parallel_for.hpp"
#include "triangle_shape.hpp"

namespace pardel::engine {

double radius_bound(double ratio, double area) { return 2 * ratio * std::sqrt(ratio * area); }

double sharp_radius_bound(double ratio, double area) {
  const double squared_cotangent = 4 * ratio * ratio - 1;
  return 2 * ratio * ratio * std::sqrt(area) / std::sqrt(std::sqrt(squared_cotangent));
}

Radii largest_radii(const Triangulation& t, const IndexAllocator& triangles, const Threads& threads) {
  const std::vector<IndexRange>& holes = triangles.holes();
  std::vector<Radii> largest(block_count(triangles.end()));
  parallel_blocks(threads, triangles.end(), [&](std::size_t first, std::size_t last, std::size_t block) {
    Radii squared;
    double twice_area = 0;
    auto hole = std::partition_point(holes.begin(), holes.end(), [&](IndexRange h) { return h.end <= first; });
    for (std::size_t id = first; id < last; ++id) {
      if (hole != holes.end() && id >= hole->begin) {
        id = (hole++)->end - 1U;
        continue;
      }
      const Shape s(t, t.slots[id]);
      const double radius = s.squared_circumradius();
      squared.radius = std::max(squared.radius, radius);
      squared.ratio = std::max(squared.ratio, radius / s.shortest_squared());
      twice_area = std::max(twice_area, s.twice_area);
    }
    largest[block] = {std::sqrt(squared.radius), std::sqrt(squared.ratio), twice_area / 2};
  });
  Radii all;
  for (const Radii& block : largest)
    all = {std::max(all.radius, block.radius), std::max(all.ratio, block.ratio), std::max(all.area, block.area)};
  return all;
}

}  // namespace pardel::engine
