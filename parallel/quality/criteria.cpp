#include "criteria.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../arithmetic/predicates.hpp"

namespace pardel::engine {
namespace {

constexpr double stricter = 1 - 0x1p-40;
constexpr double proven_angle_deg = 20.7;  // the diametral lens is never narrower than for this bound on angles

/// Reduced by far more than the rounding of the points of a patch.
constexpr double squared_cosine_of_120_degrees = 0.2499;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }
double squared(double x) { return x * x; }

/// The sine of 0 <= x <= 2, by its series. std::sin may differ in the last bit between libraries. In glibc it also
/// differs between processors with and without fused multiply-add. The coordinates of new points depend on the sine
/// and must not differ.
double sine(double x) {
  double nested = 1;
  for (int k = 24; k > 0; k -= 2) nested = 1 - x * x / (k * (k + 1)) * nested;
  return x * nested;
}
double cosine(double x) { return 1 - 2 * squared(sine(x / 2)); }

bool any_finite(const std::vector<double>& caps) {
  return std::ranges::any_of(caps, [](double cap) { return cap < INFINITY; });
}

/// If a size changes faster than this, the size at a corner of a triangle seldom decides.
constexpr double most_slope = 0.51;

/// A function fitted to 200,000 random triangles, refined at 5 to 33 degrees with off-centres. Its error is below 10 %.
double shape_factor(double min_angle_deg) { return 1 + squared(min_angle_deg) / (22 * (53.5 - min_angle_deg)); }

}  // namespace

Criteria::Criteria(const Goal& goal, Placement placement, std::vector<double> region_caps,
                   std::function<double(Point)> area_cap)
    : conforming_(goal.conforming),
      searches_(placement == Placement::search),
      squared_sine_(squared(sine(radians(goal.min_angle_deg))) / stricter),
      squared_lens_cosine_(conforming_ ? 0
                                       : squared(cosine(2 * radians(std::max(proven_angle_deg, goal.min_angle_deg))))),
      squared_patch_cosine_(std::min(squared_cosine_of_120_degrees, squared(cosine(2 * radians(goal.min_angle_deg))))),
      twice_max_area_(2 * goal.max_area * stricter),
      squared_max_edge_(squared(goal.max_edge) * stricter),
      triangles_by_shape_(shape_factor(goal.min_angle_deg)),
      twice_region_cap_(std::move(region_caps)),
      size_(local_bound(goal.size, goal.size_slope)),
      area_cap_(local_bound(std::move(area_cap))),
      before_sizes_(goal.size ? goal.before_sizes : nullptr),
      user_test_(goal.user_test),
      looks_around_(size_ && size_.steepness().slope < most_slope),
      has_local_size_(goal.max_edge < INFINITY || size_ || area_cap_ || user_test_ ||
                      (goal.region_caps && any_finite(twice_region_cap_))) {
  if (!goal.region_caps) twice_region_cap_.clear();
  for (double& cap : twice_region_cap_) cap *= 2 * stricter;
  const bool has_bounds = goal.min_angle_deg > 0 || has_size();
  if (!has_bounds) squared_lens_cosine_ = INFINITY;
  if (placement == Placement::circumcentre) return;
  fills_ = has_size();
  // Measured: above 31 degrees, size points for bounds on area make the mesh larger; those for lengths never do.
  fills_areas_ = goal.min_angle_deg <= 31;
  // Measured at 0 to 31 degrees on squares and pipes, and reduced slightly.
  if (fills_areas_) fill_ = 0.71 - 0.005 * std::max(0.0, goal.min_angle_deg - 20);
  if (goal.min_angle_deg > 0) {
    const double c = cosine(radians(goal.min_angle_deg));
    // The reduction covers rounding. It is not larger, because points nearer to the side make the mesh larger.
    constexpr double to_spare = 0.999;
    off_centre_height_ = to_spare * 0.5 * std::sqrt((1 + c) / (1 - c));
  }
}

bool Criteria::too_large_locally(const Measure& m, Point a, Point b, Point c, Index region, LocalHints& hints) const {
  return exceeds_local_bound(m, a, b, c, region, hints) || fails_user_test(a, b, c);
}

bool Criteria::exceeds_local_bound(const Measure& m, Point a, Point b, Point c, Index region, LocalHints& hints) const {
  if (region < twice_region_cap_.size() && m.twice_area > twice_region_cap_[region]) return true;
  const double longest = m.longest_squared();
  if (longest > squared_max_edge_) return true;
  const bool is_around = hints.around.corner == a;
  if (is_around && longest > hints.around.exceeds) return true;
  const bool keeps_size = !size_ || (is_around && longest <= hints.around.keeps);
  if (keeps_size && !area_cap_) return false;
  const Point centroid = centroid_of(a, b, c);
  if (!keeps_size && longest > squared(size_(centroid, hints.size)) * stricter) return true;
  return area_cap_ && m.twice_area > 2 * area_cap_(centroid, hints.area) * stricter;
}

/// The distance from a corner to the centroid is at most two thirds of the longest side. So for a longest side l and
/// the size h at the corner, the size at the centroid differs from h by at most slope * 2/3 l + blur.
SizeAround Criteria::size_around(Point p, LocalHints& hints) const {
  const double size = size_(p, hints.size);
  const auto& [slope, blur] = size_.steepness();
  const double keeps = (size - blur) / (1 + slope * 2 / 3), exceeds = (size + blur) / (1 - slope * 2 / 3);
  return {p, keeps > 0 ? squared(keeps) * squared(stricter) : 0, squared(exceeds) / stricter};
}

Criteria::SizeBounds Criteria::size_bounds(Point centroid, Index region, LocalHints& hints) const {
  SizeBounds bounds{twice_max_area_, squared_max_edge_};
  if (!has_local_size_) return bounds;
  if (region < twice_region_cap_.size()) bounds.twice_area = std::min(bounds.twice_area, twice_region_cap_[region]);
  if (size_) bounds.squared_edge = std::min(bounds.squared_edge, squared(size_(centroid, hints.size)));
  if (area_cap_) bounds.twice_area = std::min(bounds.twice_area, 2 * area_cap_(centroid, hints.area));
  return bounds;
}

double Criteria::filling_height(const SizeBounds& bounds, double twice_area, double squared_shortest) const {
  // A triangle that is much too large is split at its circumcentre. Otherwise it would be filled with points row by row
  // from its shortest side, and each new point would be connected to distant corners. A larger factor gives smaller
  // meshes and takes longer.
  constexpr double much_too_large = 6;
  // A lower point would lie in the diametral circle of the side.
  constexpr double least = 0.5;
  constexpr double filled = 0.99;
  const double twice_equilateral = 0.5 * std::numbers::sqrt3 * bounds.squared_edge;
  if (twice_area > much_too_large * std::min(bounds.twice_area, twice_equilateral)) return INFINITY;
  double height = fills_areas_ ? filled * bounds.twice_area / squared_shortest : INFINITY;
  if (bounds.squared_edge < INFINITY)
    height = std::min(height, std::sqrt(std::max(0.0, filled * bounds.squared_edge / squared_shortest - 0.25)));
  return std::max(height, least);
}

Point Criteria::split_point(Point q, Point r, Point a, Index region, LocalHints& hints) const {
  const double rx = r.x - q.x, ry = r.y - q.y, ax = a.x - q.x, ay = a.y - q.y;
  const Shape shape(q, r, a);
  const double r2 = shape.squared[2], twice_area = shape.twice_area;
  auto [dx, dy] = to_circumcentre({rx, ry}, {ax, ay}, twice_area);
  double height = off_centre_height_;
  if (fills_) height = std::min(height, filling_height(size_bounds(q, r, a, region, hints), twice_area, r2));
  if (height < INFINITY) {
    const double offx = 0.5 * rx - height * ry;
    const double offy = 0.5 * ry + height * rx;
    if (offx * offx + offy * offy < dx * dx + dy * dy) {
      dx = offx;
      dy = offy;
    }
  }
  return {snapped(q.x + dx), snapped(q.y + dy)};
}

double Criteria::triangles_needed(const Shape& s, Index region) const {
  double cap = twice_max_area_;
  if (region < twice_region_cap_.size()) cap = std::min(cap, twice_region_cap_[region]);
  return s.twice_area / cap;
}

double Criteria::twice_area_wanted(Point p, Index region, LocalHints& hints) const {
  const SizeBounds bounds = size_bounds(p, region, hints);
  return fill_ * std::min(bounds.twice_area, 0.6 * bounds.squared_edge);
}

double Criteria::triangles_wanted(const Shape& s, Index region, LocalHints& hints) const {
  const double by_bounds = s.twice_area / twice_area_wanted(s.centroid(), region, hints);
  return user_test_ ? std::max(by_bounds, triangles_by_user_test(s)) : by_bounds;
}

double Criteria::triangles_by_user_test(const Shape& s) const {
  constexpr int most_halvings = 12;
  constexpr double triangles_per_copy = 0.8;  // the test may pass copies of up to four times this area
  const Point centroid = s.centroid();
  double scale = 1;
  for (int halvings = 0; halvings <= most_halvings; ++halvings, scale /= 2) {
    const auto at = [&](unsigned k) {
      return Point{std::lerp(centroid.x, s.p[k].x, scale), std::lerp(centroid.y, s.p[k].y, scale)};
    };
    if (!fails_user_test(at(0), at(1), at(2))) return halvings == 0 ? 0 : triangles_per_copy / (scale * scale);
  }
  return 0;
}

}  // namespace pardel::engine
