#include "coverage.hpp"

#include "../../core/raster.hpp"
#include "../concurrency/parallel_arrays.hpp"
#include "local_bound.hpp"

namespace pardel::engine {

void require_coverage(const std::function<double(Point)>& size, std::span<const Point> points, const Threads& threads) {
  const auto* on_background = size.target<OnBackground<PointValues>>();
  const bool is_limited = on_background != nullptr && on_background->field->limited;
  if (!is_limited && size.target<RasterSize>() == nullptr) return;
  const LocalBound bound = local_bound(size);
  parallel_blocks(threads, points.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    LocationHint hint;
    for (std::size_t i = first; i < last; ++i) (void)bound(points[i], hint);
  });
}

}  // namespace pardel::engine
