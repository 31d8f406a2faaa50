#include "statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "../../core/support/doubled_area.hpp"

namespace pardel {
namespace {

struct Vector {
  double x, y;
};
Vector operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
double dot(Vector u, Vector v) { return u.x * v.x + u.y * v.y; }

constexpr double degrees = 180 / std::numbers::pi;

/// The angle in (0, 180) with this cotangent.
double angle_deg(double cotangent) { return std::atan2(1.0, cotangent) * degrees; }

/// What a block of triangles contributes.
struct Extremes {
  // Cotangents are compared instead of angles: the cotangent decreases as the angle grows, and it is dot / cross at
  // each corner, without a trigonometric function.
  double largest_cotangent = -std::numeric_limits<double>::infinity();
  double smallest_cotangent = std::numeric_limits<double>::infinity();
  double largest_squared_radius = 0;
  double doubled_area = 0, lost = 0;  ///< Neumaier's compensated sum

  void add_area(double area2) {
    const double sum = doubled_area + area2;
    lost += std::abs(doubled_area) >= std::abs(area2) ? (doubled_area - sum) + area2 : (area2 - sum) + doubled_area;
    doubled_area = sum;
  }
  void add(Point a, Point b, Point c) {
    const Vector ab = b - a, bc = c - b, ca = a - c;
    const double area2 = pardel::doubled_area(b, c, a);
    const auto [least, most] = std::minmax({-dot(ca, ab), -dot(ab, bc), -dot(bc, ca)});
    const double one = least / area2, other = most / area2;  // in this order unless the triangle is clockwise
    largest_cotangent = std::max({largest_cotangent, one, other});
    smallest_cotangent = std::min({smallest_cotangent, one, other});
    // R = |ab| |bc| |ca| / (4 area), arranged so that nothing overflows.
    largest_squared_radius =
        std::max(largest_squared_radius, (dot(ab, ab) / area2) * (dot(bc, bc) / area2) * dot(ca, ca) / 4);
    add_area(area2);
  }
  void add(const Extremes& block) {
    largest_cotangent = std::max(largest_cotangent, block.largest_cotangent);
    smallest_cotangent = std::min(smallest_cotangent, block.smallest_cotangent);
    largest_squared_radius = std::max(largest_squared_radius, block.largest_squared_radius);
    add_area(block.doubled_area);
    lost += block.lost;
  }
};

}  // namespace

MeshStatistics statistics(const Mesh& mesh) {
  MeshStatistics result{.vertices = mesh.points.size(), .triangles = mesh.triangles.size()};
  if (mesh.triangles.empty()) return result;
  // The blocks do not depend on the number of threads, so neither does the result.
  constexpr std::size_t block = 16'384;
  const std::size_t n = mesh.triangles.size();
  std::vector<Extremes> blocks((n + block - 1) / block);
#pragma omp parallel for schedule(dynamic, 1) if (blocks.size() > 4)
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    Extremes mine;
    for (std::size_t t = k * block; t < std::min(n, (k + 1) * block); ++t) {
      const auto& v = mesh.triangles[t].v;
      mine.add(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]);
    }
    blocks[k] = mine;
  }
  Extremes all;
  for (const Extremes& each : blocks) all.add(each);
  result.min_angle_deg = angle_deg(all.largest_cotangent);
  result.max_angle_deg = angle_deg(all.smallest_cotangent);
  result.max_circumradius = std::sqrt(all.largest_squared_radius);
  result.area = (all.doubled_area + all.lost) / 2;
  return result;
}

}  // namespace pardel
