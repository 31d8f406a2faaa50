#include "criteria.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../core/mutants.hpp"
#include "predicates.hpp"

namespace pardel {
namespace {

constexpr double stricter = 1 - 0x1p-40;
constexpr double proven_angle_deg = 20.7;  // the lens is never narrower than this bound asks for

double radians(double degrees) { return degrees * std::numbers::pi / 180; }
double squared(double x) { return x * x; }

/// By the series, for 0 <= x <= 2. std::sin may differ in the last bit from one library to the next, and glibc's does
/// from one processor to the next (those with fused multiply-add); what depends on this must not, and points do.
double sine(double x) {
  double nested = 1;
  for (int k = 24; k > 0; k -= 2) nested = 1 - x * x / (k * (k + 1)) * nested;
  return x * nested;
}
double cosine(double x) { return 1 - 2 * squared(sine(x / 2)); }

/// Fitted to 200,000 random triangles refined at 5 to 33 degrees, with off-centres: within a tenth.
double shape_factor(double min_angle_deg) { return 1 + squared(min_angle_deg) / (22 * (53.5 - min_angle_deg)); }

}  // namespace

Criteria::Criteria(const Goal& goal, Placement placement, std::vector<double> region_caps,
                   std::function<double(Point)> area_cap)
    : squared_sine_(squared(sine(radians(goal.min_angle_deg))) / stricter),
      squared_lens_cosine_(goal.conforming && !mutated("conforming_ignored")
                               ? 0
                               : squared(cosine(2 * radians(std::max(proven_angle_deg, goal.min_angle_deg))))),
      twice_max_area_(2 * goal.max_area * (mutated("area_bound_loosened") ? 1.01 : stricter)),
      squared_max_edge_(squared(goal.max_edge) * stricter),
      triangles_by_shape_(shape_factor(goal.min_angle_deg)),
      off_centre_height_(0),
      twice_region_cap_(std::move(region_caps)),
      size_(goal.size),
      area_cap_(std::move(area_cap)),
      has_local_size_(goal.max_edge < INFINITY || size_ || area_cap_ ||
                      (goal.region_caps && !twice_region_cap_.empty())) {
  if (!goal.region_caps) twice_region_cap_.clear();
  for (double& cap : twice_region_cap_) cap *= 2 * stricter;
  if (placement == Placement::off_centre && goal.min_angle_deg > 0) {
    const double c = cosine(radians(goal.min_angle_deg));
    // The hair to spare is for rounding alone: at 0.95, Triangle's choice, meshes at 30 degrees get 2 % larger.
    constexpr double to_spare = 0.999;
    off_centre_height_ = to_spare * 0.5 * std::sqrt((1 + c) / (1 - c));
    if (mutated("off_centre_too_far")) off_centre_height_ *= 1.25;
  }
}

bool Criteria::too_large_locally(const Shape& s, Index region) const {
  if (region < twice_region_cap_.size() && s.twice_area > twice_region_cap_[region] && !mutated("region_cap_ignored"))
    return true;
  const double longest = s.longest_squared();
  if (longest > squared_max_edge_ && !mutated("max_edge_ignored")) return true;
  if (size_ && longest > squared(size_(s.centroid())) * stricter && !mutated("sizing_function_ignored")) return true;
  return area_cap_ && s.twice_area > 2 * area_cap_(s.centroid()) * stricter;
}

Point Criteria::split_point(const Shape& s) const {
  const unsigned o = s.shortest_side();  // the apex; the shortest side runs from q to r
  const Point q = s.p[next_corner[o]], r = s.p[previous_corner[o]], a = s.p[o];
  const double rx = r.x - q.x, ry = r.y - q.y, ax = a.x - q.x, ay = a.y - q.y;
  const double a2 = ax * ax + ay * ay, r2 = rx * rx + ry * ry;
  const double scale = 0.5 / (rx * ay - ry * ax);
  double dx = (r2 * ay - a2 * ry) * scale;
  double dy = (a2 * rx - r2 * ax) * scale;
  if (off_centre_height_ > 0) {
    const double offx = 0.5 * rx - off_centre_height_ * ry;
    const double offy = 0.5 * ry + off_centre_height_ * rx;
    if (offx * offx + offy * offy < dx * dx + dy * dy || mutated("off_centre_beyond_the_circumcentre")) {
      dx = offx;
      dy = offy;
    }
  }
  if (mutated("split_point_on_the_wrong_side")) return {snapped(q.x - dx), snapped(q.y - dy)};
  return {snapped(q.x + dx), snapped(q.y + dy)};
}

double Criteria::triangles_needed(const Shape& s, Index region) const {
  double cap = twice_max_area_;
  if (region < twice_region_cap_.size()) cap = std::min(cap, twice_region_cap_[region]);
  return s.twice_area / cap;
}

double Criteria::triangles_wanted(const Shape& s, Index region) const {
  // A good mesh fills about 62 % of each triangle's cap.
  constexpr double fill = 0.62;
  double cap = s.twice_area / triangles_needed(s, region);
  double edge2 = squared_max_edge_;
  if (size_) edge2 = std::min(edge2, squared(size_(s.centroid())));
  if (area_cap_) cap = std::min(cap, 2 * area_cap_(s.centroid()));
  cap = std::min(cap, 0.6 * edge2);
  return s.twice_area / (fill * cap);
}

}  // namespace pardel
