// The attributes of points that are divided among ranks.
#pragma once

#include <cstdint>
#include <vector>

#include "../../core/part_of_points.hpp"
#include "../../core/ranks.hpp"

namespace pardel::engine {

/// They stay with the rank that has read them, which others find by the number of the point. So they need not travel
/// with the points, and no rank searches for a number.
class ReadAttributes {
 public:
  /// Takes the attributes from the points. Collective. Precondition: there are as many as the points need.
  ReadAttributes(PartOfPoints& read, Ranks& ranks);

  [[nodiscard]] std::size_t per_point() const { return per_point_; }
  /// The attributes of the points with these numbers, point by point. Collective.
  [[nodiscard]] std::vector<double> of(const std::vector<std::uint64_t>& numbers, Ranks& ranks) const;

 private:
  std::size_t per_point_;
  std::vector<double> values_;
  std::vector<std::uint64_t> first_;  ///< for each rank, the number of the first point that it has read
};

}  // namespace pardel::engine
