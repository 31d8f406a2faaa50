// Points of the plane divided among ranks along a space-filling curve.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "../../core/ranks.hpp"
#include "../../parallel/decomposition/hilbert_order.hpp"

namespace pardel::engine {

/// A closed disk that contains the circumdisk of a triangle, in spite of rounding; or the whole plane.
struct Disk {
  Point centre;
  double radius = INFINITY;

  /// The whole plane if the triangle is so flat that rounding leaves no useful bound.
  [[nodiscard]] static Disk around(Point a, Point b, Point c);
  [[nodiscard]] bool is_whole_plane() const { return radius == INFINITY; }
  [[nodiscard]] Box bounds() const {
    return {centre.x - radius, centre.y - radius, centre.x + radius, centre.y + radius};
  }
  /// False only if the disk contains no point of the closed box.
  [[nodiscard]] bool may_meet(const Box& box) const;
  /// The side of squares that are small compared with the disk.
  [[nodiscard]] double resolution() const { return radius / 8; }
};

/// The closed half-plane on the left of the line from a to b.
struct HalfPlane {
  Point a, b;
  /// False only if the half-plane contains no point of the closed box.
  [[nodiscard]] bool may_meet(const Box& box) const;
  [[nodiscard]] static double resolution() { return 0; }
};

/// The smallest box that contains the boxes of all ranks. Collective.
[[nodiscard]] Box bounds_of_all(const Box& own, Ranks& ranks);

/// A rank owns the points in the cells of a range of keys (CurveGrid). The ranges of the ranks follow one another.
class CurveDivision {
 public:
  /// `first_key`: for each rank, ascending, from 0 on.
  CurveDivision(const CurveGrid& grid, std::vector<std::uint32_t> first_key)
      : grid_(grid), first_key_(std::move(first_key)) {}

  [[nodiscard]] const CurveGrid& grid() const { return grid_; }
  [[nodiscard]] int owner(Point p) const { return owner(grid_.key(p)); }

  /// True only if all points in the disk belong to the rank. Fast; false for some disks for which it is true.
  [[nodiscard]] bool certainly_owns(int rank, const Disk& disk) const;
  /// The ranks but `self`, in ascending order, that may own a point of the area, which has the functions may_meet(box)
  /// and resolution(). Squares smaller than the resolution count as parts of the area if they meet it. No quadrant is
  /// examined whose owners have been found elsewhere; otherwise, all cells along a border would be.
  template <class Area>
  [[nodiscard]] std::vector<int> others_in(const Area& area, int self) const {
    std::vector<int> found;
    find_owners(area, self, {}, found);
    std::ranges::sort(found);
    return found;
  }

 private:
  [[nodiscard]] int owner(std::uint32_t key) const {
    return static_cast<int>(std::ranges::upper_bound(first_key_, key) - first_key_.begin()) - 1;
  }
  template <class Area>
  void find_owners(const Area& area, int self, const CurveGrid::Quadrant& quadrant, std::vector<int>& found) const;

  CurveGrid grid_;
  std::vector<std::uint32_t> first_key_;
};

template <class Area>
void CurveDivision::find_owners(const Area& area, int self, const CurveGrid::Quadrant& quadrant,
                                std::vector<int>& found) const {
  const int first = owner(CurveGrid::first_key(quadrant)), last = owner(CurveGrid::last_key(quadrant));
  const auto is_known = [&](int rank) { return rank == self || std::ranges::find(found, rank) != found.end(); };
  int unknown = first;
  while (unknown <= last && is_known(unknown)) ++unknown;
  if (unknown > last) return;
  const Box square = grid_.square(quadrant);
  if (!area.may_meet(square)) return;
  if (first == last || square.extent() < area.resolution()) {
    for (int rank = unknown; rank <= last; ++rank)
      if (!is_known(rank)) found.push_back(rank);
    return;
  }
  for (unsigned i = 0; i < 4; ++i) find_owners(area, self, quadrant.part(i), found);
}

/// The division in which ranks own about equally many points. Collective. `points`: those that this rank has read.
[[nodiscard]] CurveDivision divide_along_curve(std::span<const Point> points, Ranks& ranks);

}  // namespace pardel::engine
