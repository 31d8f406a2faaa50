#include "coverage.hpp"

#include "../../core/raster.hpp"
#include "../threads/parallel_arrays.hpp"
#include "local_bound.hpp"

namespace pardel::engine {
namespace {

/// The field on a background, if the function is one.
const PointValues* values_on_background(const std::function<double(Point)>& size) {
  const auto* target = size.target<OnBackground<PointValues>>();
  return target == nullptr ? nullptr : target->field.get();
}

}  // namespace

bool ends_somewhere(const std::function<double(Point)>& size) {
  const PointValues* values = values_on_background(size);
  return values != nullptr ? values->limited : size.target<RasterSize>() != nullptr;
}

void require_coverage(const std::function<double(Point)>& size, std::span<const Point> points, const Threads& threads) {
  if (!ends_somewhere(size)) return;
  const PointValues* values = values_on_background(size);
  parallel_blocks(threads, points.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    LocationHint hint;
    for (const Point p : points.subspan(first, last - first)) (void)(values != nullptr ? values->at(p, hint) : size(p));
  });
}

}  // namespace pardel::engine
