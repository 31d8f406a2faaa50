// Which triangles belong to the domain and its regions, in a triangulation that is divided among ranks.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "../../core/array.hpp"
#include "../../core/ranks.hpp"
#include "../concurrency/threads.hpp"
#include "../construction/carve.hpp"
#include "../given_points/local_delaunay.hpp"
#include "../given_points/own_points.hpp"
#include "../given_points/shared_hull.hpp"

namespace pardel::engine {

/// The result of carve(), for ranks that each have the triangles with an own corner.
class Labels {
 public:
  /// Collective; all ranks pass the same rules. Precondition: the segments are edges, and all triangles with an own
  /// corner are those of the triangulation of all points.
  Labels(const LocalDelaunay& delaunay, const OwnPoints& own, const SharedHull& hull, const DomainRules& rules,
         Ranks& ranks, const Threads& threads);

  /// Precondition of both: the slot has a triangle with an own corner, and no ghost.
  [[nodiscard]] bool is_in_domain(TriangleId id) const { return of_slot_[id] != outside; }
  /// The index of the last seed in the same face, or no_index.
  [[nodiscard]] Index region(TriangleId id) const { return of_slot_[id]; }
  /// True if the triangle on the left of a constrained edge belongs to the domain. The edge is given by the positions
  /// of its ends. For any edge, on any rank.
  [[nodiscard]] bool is_in_domain_beside(std::uint64_t from, std::uint64_t to) const {
    return !std::ranges::binary_search(sides_outside_, std::pair(from, to));
  }

 private:
  static constexpr Index outside = no_index - 1;

  void share_sides_outside(const LocalDelaunay& delaunay, Ranks& ranks);

  Array<Index> of_slot_;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> sides_outside_;  ///< constrained edges; sorted
};

}  // namespace pardel::engine
