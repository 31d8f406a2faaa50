// The tiles of a lattice over the domain, and what one tile does in one phase. Tiles of one colour change no triangle
// that another one of them reads, so their order in time changes nothing (Chernikov, Chrisochoides 2004).
#pragma once

#include <vector>

#include "../mesh/triangle.hpp"
#include "../rules/ruppert.hpp"

namespace pardel::schemes {

/// `per_side` by `per_side` square tiles over the bounding box of the domain, numbered row by row.
class TileLattice {
 public:
  static constexpr int colours = 4;

  /// Precondition: the mesh has triangles, and per_side >= 1.
  TileLattice(const LinkedMesh& mesh, int per_side);

  [[nodiscard]] double side() const { return side_; }
  [[nodiscard]] int per_side() const { return per_side_; }
  [[nodiscard]] int count() const { return per_side_ * per_side_; }
  [[nodiscard]] int tile_of(Point p) const;
  /// The tile of its centroid.
  [[nodiscard]] int tile_of(const LinkedMesh& mesh, Index t) const;
  [[nodiscard]] Point centre(int tile) const;
  /// From 0 to 3. Tiles of one colour are no neighbours.
  [[nodiscard]] int colour(int tile) const { return tile % per_side_ % 2 + 2 * (tile / per_side_ % 2); }
  /// The tiles that share a side or a corner with this one, at most eight, in the order of their numbers.
  [[nodiscard]] std::vector<int> neighbours(int tile) const;
  /// Does t lie within half a side of the tile? These zones of two tiles of one colour are disjoint.
  [[nodiscard]] bool reaches(int tile, const LinkedMesh& mesh, Index t) const;

 private:
  Point low_;
  double side_ = 0;
  int per_side_;
};

/// Sorts items by the coordinates of their corners, an order in which their numbers play no part.
void sort_by_place(const LinkedMesh& mesh, std::vector<KnownTriangle>& items);

/// What a level refines, and where bad triangles go.
struct TileRules {
  const Bounds& bounds;
  const TileLattice& lattice;
  double least_radius = 0;      ///< bad triangles whose circumradius is not above this wait for a finer lattice
  std::size_t most_points = 0;  ///< a tile stops when the mesh has more
};

/// What a tile did in one phase.
struct TileReport {
  std::uint64_t work = 0, wasted = 0, insertions = 0;
  struct HandedOn {
    int tile;
    KnownTriangle item;
  };
  std::vector<HandedOn> handed_on;   ///< new bad triangles of other tiles
  std::vector<KnownTriangle> left;   ///< their insertions change triangles out of reach
  std::vector<KnownTriangle> later;  ///< for a finer lattice
};

/// The tile of a bad triangle; -1 if its tile does not reach it.
[[nodiscard]] int tile_for(const LinkedMesh& mesh, Index t, const TileLattice& lattice);
/// Is the circumradius of t above the bound of this level?
[[nodiscard]] bool is_due(const LinkedMesh& mesh, Index t, double least_radius);

/// Ruppert's algorithm for the items of a tile and those that follow from them, in the order of sort_by_place() and
/// then first in, first out. An insertion that reads the circumdisk of a triangle which the tile does not reach, other
/// than across the boundary of its cavity, is left. Precondition: the tile reaches all items.
[[nodiscard]] TileReport work_on_tile(LinkedMesh& mesh, const TileRules& rules, int tile,
                                      std::vector<KnownTriangle> items);

/// The same without tiles, by one worker. Nothing is left.
[[nodiscard]] TileReport work_alone(LinkedMesh& mesh, const TileRules& rules, std::vector<KnownTriangle> items);

/// Numbers the points that are no inputs, and then the triangles, by their places: equal meshes get equal bits.
void number_by_place(LinkedMesh& mesh, std::size_t inputs);

}  // namespace pardel::schemes
