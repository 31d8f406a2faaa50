// The bounds of a subdomain, for libraries that ask about a triangle: whether it is bad, and whether its circumcentre
// may be inserted.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "../../core/support/doubled_area.hpp"
#include "../../off_the_shelf/subdomain_mesher.hpp"
#include "triangle_finder.hpp"

namespace pardel::bench {

/// Keeps a reference to the subdomain.
class Bounds {
 public:
  explicit Bounds(const Subdomain& subdomain) : subdomain_(subdomain) {
    const double sine = std::sin(subdomain.goal.min_angle_deg * (std::numbers::pi / 180));
    squared_sine_ = sine * sine;
    const auto& caps = subdomain.max_areas;
    if (std::ranges::adjacent_find(caps, std::ranges::not_equal_to()) != caps.end()) finder_.emplace(subdomain);
  }

  /// How good a triangle is.
  struct Quality {
    double size = 0;          ///< above 1: too large; its area, or its squared longest edge, in units of the bound
    double squared_sine = 1;  ///< of the smallest angle
  };
  [[nodiscard]] Quality quality(Point a, Point b, Point c) const {
    const double area = doubled_area(a, b, c) / 2;
    std::array<double, 3> lengths{squared(b, c), squared(c, a), squared(a, b)};
    std::ranges::sort(lengths);
    const Point centroid{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
    const double edge = max_edge_at(centroid);
    // The smallest angle lies between the longest edges.
    return {std::max(area / max_area_at(centroid), lengths[2] / (edge * edge)),
            4 * area * area / (lengths[1] * lengths[2])};
  }
  [[nodiscard]] bool is_too_large(const Quality& q) const { return q.size > 1; }
  [[nodiscard]] bool is_thin(const Quality& q) const { return q.squared_sine < squared_sine_; }

  /// The longest edge at a place.
  [[nodiscard]] double max_edge_at(Point p) const {
    const Goal& goal = subdomain_.goal;
    return goal.size ? std::min(goal.max_edge, goal.size(p)) : goal.max_edge;
  }

  /// The largest area at a place.
  [[nodiscard]] double max_area_at(Point p) const {
    const auto& caps = subdomain_.max_areas;
    if (caps.empty()) return subdomain_.goal.max_area;
    if (!finder_) return caps.front();
    const Index triangle = finder_->find(p);
    return triangle == no_index ? subdomain_.goal.max_area : caps[triangle];
  }

  /// True if the circumcentre of a triangle with this corner may become a point: it lies in the cell, and the circle is
  /// large enough for a mesh in doubles.
  [[nodiscard]] bool may_insert(Point centre, Point corner) const {
    constexpr double resolution = 0x1p-40;
    const double floor = std::max(subdomain_.min_edge, resolution * std::max(std::abs(centre.x), std::abs(centre.y)));
    return (!subdomain_.cell || subdomain_.cell->contains(centre)) && squared(centre, corner) > 4 * floor * floor;
  }

 private:
  static double squared(Point a, Point b) { return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y); }

  const Subdomain& subdomain_;
  double squared_sine_;
  std::optional<TriangleFinder> finder_;  ///< if not all caps are the same
};

}  // namespace pardel::bench
