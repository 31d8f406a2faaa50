// Where the points are that ranks know by their numbers.
#pragma once

#include <cstdint>
#include <vector>

#include "../../core/array.hpp"
#include "../../core/ranks.hpp"
#include "../given_points/triangulated_points.hpp"

namespace pardel::engine {

/// The ranks that have read the points keep a list of the places to which the points went.
class SitesOfNumbers {
 public:
  /// Collective. `first_read`: for each rank, the number of the first point that it has read; last, the number of all
  /// points.
  SitesOfNumbers(const TriangulatedPoints& points, std::vector<std::uint64_t> first_read, Ranks& ranks);

  /// The rank that has read a point.
  [[nodiscard]] int reader_of(std::uint64_t number) const;
  /// Collective. The sites of the points with these numbers. Precondition: there are such points.
  [[nodiscard]] std::vector<Site> find(const std::vector<Index>& numbers) const;

 private:
  std::vector<std::uint64_t> first_read_;
  Ranks& ranks_;
  Array<Site> sites_;  ///< of the points that this rank has read
};

}  // namespace pardel::engine
