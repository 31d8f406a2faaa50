// Which triangles belong to the domain and its regions, in a triangulation that is divided among ranks.
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <vector>

#include "../../core/array.hpp"
#include "../../core/ranks.hpp"
#include "../../parallel/construction/carve.hpp"
#include "../../parallel/threads/threads.hpp"
#include "../delaunay/local_delaunay.hpp"
#include "../delaunay/own_points.hpp"
#include "../delaunay/shared_hull.hpp"

namespace pardel::engine {

/// The result of carve(), for ranks that each have the triangles with an own corner.
class Labels {
 public:
  /// Collective; all ranks pass the same rules. Keeps a reference to the triangulation. Preconditions: the segments at
  /// triangles with an own corner are constrained edges, and these triangles are those of the triangulation of all
  /// points.
  Labels(const LocalDelaunay& delaunay, const OwnPoints& own, const SharedHull& hull, const DomainRules& rules,
         Ranks& ranks, const Threads& threads);

  /// Precondition of both: the slot has a triangle with an own corner, and no ghost.
  [[nodiscard]] bool is_in_domain(TriangleId id) const { return of_slot_[id] != outside; }
  /// The index of the last seed in the same face, or no_index.
  [[nodiscard]] Index region(TriangleId id) const { return of_slot_[id]; }
  /// True if the triangle beyond a constrained side of such a triangle belongs to the domain. Precondition: the side is
  /// no edge of the convex hull.
  [[nodiscard]] bool is_in_domain_beyond(const Slot& slot, unsigned side) const;
  /// False if the domain may be empty, if a hole or a region may lie outside the domain or on a segment, or if several
  /// regions share a face. The same on all ranks. Then the domain may be invalid. True only if it is not.
  [[nodiscard]] bool are_certainly_valid() const { return are_certainly_valid_; }

 private:
  static constexpr Index outside = no_index - 1;
  /// The positions of the ends of a side that has the triangle on its left.
  struct Side {
    std::uint64_t from, to;
    friend auto operator<=>(const Side&, const Side&) = default;  // NOLINT(modernize-use-nullptr)
  };

  [[nodiscard]] Side beyond(const Slot& slot, unsigned side) const {
    return {delaunay_.site(slot.to(side)).position, delaunay_.site(slot.from(side)).position};
  }
  void ask_about_sides(const OwnPoints& own, Ranks& ranks);

  const LocalDelaunay& delaunay_;
  Array<Index> of_slot_;
  std::vector<Side> sides_outside_;  ///< constrained sides of triangles that have no own corner; sorted
  bool are_certainly_valid_ = true;
};

}  // namespace pardel::engine
