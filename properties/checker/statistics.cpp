#include "statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pardel {
namespace {

struct Vector {
  double x, y;
};
Vector operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
double dot(Vector u, Vector v) { return u.x * v.x + u.y * v.y; }
double cross(Vector u, Vector v) { return u.x * v.y - u.y * v.x; }

constexpr double degrees = 180 / std::numbers::pi;

/// The angle in (0, 180) with this cotangent.
double angle_deg(double cotangent) { return std::atan2(1.0, cotangent) * degrees; }

}  // namespace

MeshStatistics statistics(const Mesh& mesh) {
  MeshStatistics result{.vertices = mesh.points.size(), .triangles = mesh.triangles.size()};
  if (mesh.triangles.empty()) return result;
  // Cotangents are compared instead of angles: the cotangent decreases as the angle grows, and it is dot / cross at
  // each corner, without a trigonometric function.
  double largest_cotangent = -std::numeric_limits<double>::infinity();
  double smallest_cotangent = std::numeric_limits<double>::infinity();
  double largest_squared_radius = 0;
  double doubled_area = 0, lost = 0;  // Neumaier's compensated sum
  for (const Triangle& t : mesh.triangles) {
    const Point a = mesh.points[t.v[0]], b = mesh.points[t.v[1]], c = mesh.points[t.v[2]];
    const Vector ab = b - a, bc = c - b, ca = a - c;
    const double area2 = cross(ab, bc);
    for (const double product : {-dot(ca, ab), -dot(ab, bc), -dot(bc, ca)}) {
      largest_cotangent = std::max(largest_cotangent, product / area2);
      smallest_cotangent = std::min(smallest_cotangent, product / area2);
    }
    // R = |ab| |bc| |ca| / (4 area), arranged so that nothing overflows.
    largest_squared_radius =
        std::max(largest_squared_radius, (dot(ab, ab) / area2) * (dot(bc, bc) / area2) * dot(ca, ca) / 4);
    const double sum = doubled_area + area2;
    lost += std::abs(doubled_area) >= std::abs(area2) ? (doubled_area - sum) + area2 : (area2 - sum) + doubled_area;
    doubled_area = sum;
  }
  result.min_angle_deg = angle_deg(largest_cotangent);
  result.max_angle_deg = angle_deg(smallest_cotangent);
  result.max_circumradius = std::sqrt(largest_squared_radius);
  result.area = (doubled_area + lost) / 2;
  return result;
}

}  // namespace pardel
