// Finds the triangle of a subdomain that contains a place.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "../../core/support/doubled_area.hpp"
#include "../../off_the_shelf/subdomain_mesher.hpp"

namespace pardel::bench {

/// A grid over the subdomain with about as many squares as triangles, and the triangles around each square. O(1) per
/// place if the triangles have about the same size. Keeps a reference to the subdomain.
class TriangleFinder {
 public:
  explicit TriangleFinder(const Subdomain& subdomain) : subdomain_(subdomain) {
    if (subdomain.triangles.empty()) return;
    low_ = high_ = subdomain.points[subdomain.triangles[0][0]];
    for (const auto& v : subdomain.triangles) cover(v, low_, high_);
    along_ = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(subdomain.triangles.size()))));
    around_.resize(static_cast<std::size_t>(along_) * static_cast<std::size_t>(along_));
    for (Index t = 0; t < subdomain.triangles.size(); ++t) {
      Point low = subdomain.points[subdomain.triangles[t][0]], high = low;
      cover(subdomain.triangles[t], low, high);
      for (int column = column_of(low); column <= column_of(high); ++column)
        for (int row = row_of(low); row <= row_of(high); ++row) square(column, row).push_back(t);
    }
  }

  /// no_index outside all triangles. A place on an edge is in one of its triangles.
  [[nodiscard]] Index find(Point p) const {
    if (around_.empty()) return no_index;
    for (const Index t : around_[number_of(column_of(p), row_of(p))])
      if (contains(t, p)) return t;
    return no_index;
  }

 private:
  void cover(const std::array<Index, 3>& v, Point& low, Point& high) const {
    for (const Index corner : v) {
      const Point p = subdomain_.points[corner];
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  [[nodiscard]] int step_of(double part) const {
    return static_cast<int>(std::clamp(std::floor(part * along_), 0.0, along_ - 1.0));
  }
  [[nodiscard]] int column_of(Point p) const { return step_of((p.x - low_.x) / (high_.x - low_.x)); }
  [[nodiscard]] int row_of(Point p) const { return step_of((p.y - low_.y) / (high_.y - low_.y)); }
  [[nodiscard]] std::size_t number_of(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(along_) + static_cast<std::size_t>(column);
  }
  std::vector<Index>& square(int column, int row) { return around_[number_of(column, row)]; }
  [[nodiscard]] bool contains(Index triangle, Point p) const {
    const auto& v = subdomain_.triangles[triangle];
    const auto& points = subdomain_.points;
    const auto is_left = [&](Index i, Index j) { return doubled_area(points[i], points[j], p) >= 0; };
    return is_left(v[0], v[1]) && is_left(v[1], v[2]) && is_left(v[2], v[0]);
  }

  const Subdomain& subdomain_;
  Point low_, high_;
  int along_ = 1;
  std::vector<std::vector<Index>> around_;
};

}  // namespace pardel::bench
