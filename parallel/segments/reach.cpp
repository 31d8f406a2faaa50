#include "reach.hpp"

#include <limits>
#include <utility>

#include "../arithmetic/box.hpp"

namespace pardel::engine {

Reach::Reach(Snapping snapping, std::span<const Point> points, std::span<const Segment> segments)
    : snapping_(std::move(snapping)), of_point_(points.size()), of_segment_(segments.size()), own_(points.size()) {
  if (!snapping_.depends_on_scale()) return;
  constexpr double none = std::numeric_limits<double>::infinity();
  std::ranges::fill(of_point_, none);
  std::ranges::fill(own_, none);
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const auto [a, b, marker] = segments[s];
    of_segment_[s] = Box::around(points[a], points[b]).largest_magnitude();
    for (const Index end : {a, b}) of_point_[end] = std::min(of_point_[end], of_segment_[s]);
  }
  sorted_ = of_segment_;
  std::ranges::sort(sorted_);
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (of_point_[p] < none) continue;
    of_point_[p] = scale_of_place(points[p]);
    own_[p] = Box::around(points[p]).largest_magnitude();
  }
}

double Reach::scale_of_place(Point p) const {
  if (!snapping_.depends_on_scale()) return 0;
  const double own = Box::around(p).largest_magnitude();
  const auto at_least = std::ranges::lower_bound(sorted_, own);
  return at_least == sorted_.end() ? own : *at_least;
}

double Reach::largest() const {
  const std::vector<double>& scales = of_segment_.empty() ? of_point_ : of_segment_;
  return snapping_.largest_up_to(scales.empty() ? 0 : *std::ranges::max_element(scales));
}

}  // namespace pardel::engine
