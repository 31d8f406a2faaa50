#include "bounds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../mesh/triangle.hpp"

namespace pardel::schemes {
namespace {

constexpr double stricter = 1 - 0x1p-40;

double squared(double x) { return x * x; }
double squared_distance(Point p, Point q) { return squared(p.x - q.x) + squared(p.y - q.y); }

/// The square of the longest edge of an equilateral triangle of area 1.
const double squared_edge_of_unit_area = 4 / std::numbers::sqrt3;

}  // namespace

std::optional<Error> unsupported(const Pslg& pslg, const Goal& goal) {
  const auto usage = [](const char* why) { return Error{ErrorKind::usage, why}; };
  if (pslg.attributes_per_point != 0) return usage("The schemes carry no point attributes.");
  if (goal.convex_hull && !pslg.segments.empty()) return usage("The schemes mesh outlines, or hulls without segments.");
  if (std::isfinite(goal.grading) || goal.feature_edges > 0 || !goal.sources.empty())
    return usage("The schemes know no limits on gradation and no bounds on features.");
  if (goal.user_test) return usage("The schemes know no tests of the user.");
  return std::nullopt;
}

Bounds::Bounds(const Pslg& pslg, const Goal& goal, const LinkedMesh& mesh)
    : goal_(goal),
      squared_sine_(squared(std::sin(goal.min_angle_deg * std::numbers::pi / 180)) / stricter),
      small_angles_(mesh) {
  if (goal.region_caps)
    for (const Region& region : pslg.regions) caps_.push_back(region.max_area);
}

bool Bounds::is_thin(const LinkedMesh& mesh, Index t) const {
  const Point a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
  const std::array<double, 3> opposite = {squared_distance(b, c), squared_distance(c, a), squared_distance(a, b)};
  const double squared_area = squared(twice_area(a, b, c));
  for (int k = 0; k < 3; ++k) {
    // The sine of the angle at corner k is twice the area divided by the product of the two sides there. The angle is
    // acute if the sum of their squares is above that of the third side.
    const double left = opposite[(k + 1) % 3], right = opposite[(k + 2) % 3];
    const bool is_acute = left + right > opposite[k];
    if (is_acute && squared_area < squared_sine_ * left * right && !small_angles_.justify(mesh, t, k)) return true;
  }
  return false;
}

bool Bounds::is_large(const LinkedMesh& mesh, Index t) const {
  const Point a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
  const double max_area = std::min(goal_.max_area, area_cap(mesh.faces[t].region));
  if (twice_area(a, b, c) > 2 * max_area * stricter) return true;
  double edge = goal_.max_edge;
  if (goal_.size) edge = std::min(edge, goal_.size(centroid(a, b, c)));
  if (!std::isfinite(edge)) return false;
  const double longest = std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
  return longest > squared(edge) * stricter;
}

double Bounds::area_cap(Index region) const { return region < caps_.size() ? caps_[region] : INFINITY; }

double Bounds::wanted_area(Point p, Index region) const {
  double edge = goal_.max_edge;
  if (goal_.size) edge = std::min(edge, goal_.size(p));
  return std::min({goal_.max_area, area_cap(region), squared(edge) / squared_edge_of_unit_area});
}

}  // namespace pardel::schemes
