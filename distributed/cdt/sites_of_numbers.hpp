// Where the points are that ranks know by their numbers.
#pragma once

#include <cstdint>
#include <vector>

#include "../../core/array.hpp"
#include "../../core/ranks.hpp"
#include "../delaunay/triangulated_points.hpp"

namespace pardel::engine {

/// A list of the places of all points, in the order of their numbers. Each rank keeps an equal part of it, whatever the
/// ranks have read.
class SitesOfNumbers {
 public:
  /// Collective.
  SitesOfNumbers(const TriangulatedPoints& points, Ranks& ranks);

  /// The rank that keeps the place of a point.
  [[nodiscard]] int keeper_of(std::uint64_t number) const { return static_cast<int>(number / share_); }
  /// Collective. The sites of the points with these numbers. Precondition: there are such points.
  [[nodiscard]] std::vector<Site> find(const std::vector<Index>& numbers) const;

 private:
  [[nodiscard]] bool keeps(std::uint64_t number) const { return number >= first_ && number - first_ < sites_.size(); }

  Ranks& ranks_;
  std::uint64_t share_, first_;  ///< numbers per rank; the first one here
  Array<Site> sites_;
};

}  // namespace pardel::engine
