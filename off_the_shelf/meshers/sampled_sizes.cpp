#include "sampled_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../../core/support/hash.hpp"
#include "../../parallel/arithmetic/box.hpp"

namespace pardel::engine {
namespace {

Point centroid(const std::vector<Point>& points, const std::array<Index, 3>& v) {
  const Point &a = points[v[0]], &b = points[v[1]], &c = points[v[2]];
  return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
}

double twice_area(Point a, Point b, Point c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

Box box_of(const std::vector<Point>& points, const std::array<Index, 3>& v) {
  Box box = empty_box;
  for (const Index corner : v) box.cover(Box::around(points[corner]));
  return box;
}

}  // namespace

std::vector<double> sample_sizes(const Subdomain& subdomain) {
  Box box = empty_box;
  for (const Point p : subdomain.points) box.cover(Box::around(p));
  const double diagonal = std::hypot(box.max_x - box.min_x, box.max_y - box.min_y);
  const auto size_at = [&](Point p) { return std::min(subdomain.goal.size(p), diagonal); };
  std::vector<double> values;
  values.reserve(subdomain.points.size() + subdomain.triangles.size());
  for (const Point p : subdomain.points) values.push_back(size_at(p));
  for (const auto& v : subdomain.triangles) values.push_back(size_at(centroid(subdomain.points, v)));
  return values;
}

SampledSizes::SampledSizes(std::vector<Point> points, std::vector<std::array<Index, 3>> triangles,
                           std::vector<double> values)
    : points_(std::move(points)), triangles_(std::move(triangles)), values_(std::move(values)) {
  Box all = empty_box;
  for (const Point p : points_) all.cover(Box::around(p));
  low_ = {all.min_x, all.min_y};
  for (Index t = 0; t < triangles_.size(); ++t) {
    // The squares are as large as the triangle, so it meets at most four.
    const Box box = box_of(points_, triangles_[t]);
    const int level = std::ilogb(box.extent()) + 1;
    levels_.push_back(level);
    const Square first = square_around({box.min_x, box.min_y}, level);
    const Square last = square_around({box.max_x, box.max_y}, level);
    for (std::int64_t column = first.column; column <= last.column; ++column)
      for (std::int64_t row = first.row; row <= last.row; ++row) known_.emplace_back(key_of({level, column, row}), t);
  }
  std::ranges::sort(levels_);
  levels_.erase(std::unique(levels_.begin(), levels_.end()), levels_.end());
  std::ranges::sort(known_);
}

double SampledSizes::at(Point p) const {
  double best = -std::numeric_limits<double>::infinity(), value = std::numeric_limits<double>::infinity();
  for (const int level : levels_) {
    const std::uint64_t key = key_of(square_around(p, level));
    for (auto next = std::ranges::lower_bound(known_, std::pair(key, Index{0}));
         next != known_.end() && next->first == key; ++next) {
      const auto [inside, here] = in_triangle(next->second, p);
      if (inside > best) {
        best = inside;
        value = here;
      }
    }
  }
  return value;
}

std::uint64_t SampledSizes::key_of(const Square& square) {
  // Squares with the same key only cost time.
  return mixed(static_cast<std::uint64_t>(square.column) +
               0x9e3779b97f4a7c15U * mixed(static_cast<std::uint64_t>(square.row)) +
               static_cast<std::uint64_t>(square.level));
}

SampledSizes::Square SampledSizes::square_around(Point p, int level) const {
  constexpr double most = 0x1p53;
  const auto number = [&](double distance) {
    return static_cast<std::int64_t>(std::floor(std::clamp(std::ldexp(distance, -level), -most, most)));
  };
  return {level, number(p.x - low_.x), number(p.y - low_.y)};
}

std::pair<double, double> SampledSizes::in_triangle(Index triangle, Point p) const {
  const auto& v = triangles_[triangle];
  const std::array<Point, 3> c{points_[v[0]], points_[v[1]], points_[v[2]]};
  const double whole = twice_area(c[0], c[1], c[2]);
  std::array<double, 3> part{};
  double least = std::numeric_limits<double>::infinity(), linear = 0, mean = 0;
  for (unsigned i = 0; i < 3; ++i) {
    part[i] = twice_area(p, c[(i + 1) % 3], c[(i + 2) % 3]) / whole;
    least = std::min(least, part[i]);
    // Outside, the value on the border goes on.
    linear += std::clamp(part[i], 0.0, 1.0) * values_[v[i]];
    mean += values_[v[i]] / 3;
  }
  const double at_centroid = values_[points_.size() + triangle];
  return {least, linear + 3 * std::max(0.0, least) * (at_centroid - mean)};
}

}  // namespace pardel::engine
