// The triangles around given ones, in a mesh that is divided among ranks.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "../../core/ranks.hpp"
#include "subdomain.hpp"

namespace pardel::engine {

/// A set of triangles that grows by rings. A ring has all triangles that share a corner with a triangle of the set. So
/// the set grows far where triangles are large, and little where they are small. Triangles that have only a vertex in
/// common, and no chain of neighbours around it, do not reach each other, because no cavity contains both.
class Rings {
 public:
  /// The rank that owns a vertex. It holds all triangles around the vertex, and all ranks name the same owner.
  using Owner = std::function<int(VertexId)>;

  /// Begins with the triangles in `centre`, on all ranks. The mesh must not change.
  Rings(const Subdomain& part, const Triangulation& t, Ranks& ranks, Owner owner, std::span<const TriangleId> centre);

  /// Adds a ring. Collective. O(new triangles) on each rank.
  void grow();
  /// The next grow() adds a ring around these vertices of the set only; around all of the set if the list is empty.
  /// Later calls go on from there.
  void grow_around(std::span<const Name> vertices);
  /// The triangles that have been found on this rank. The lists of all ranks together have all triangles; some are in
  /// several lists.
  [[nodiscard]] const std::vector<TriangleId>& triangles() const { return triangles_; }
  /// True if no rank has found a triangle in the last ring. If it was a ring around all vertices, the set has all
  /// triangles that are connected with its first ones. The same on all ranks.
  [[nodiscard]] bool is_complete() const { return is_complete_; }

 private:
  struct Corner {
    TriangleId triangle;
    unsigned number;
  };
  struct TravellingCorner;

  void add(TriangleId id);
  void walk_around(Corner c);
  /// Marks the corner. Returns false if it was marked before.
  [[nodiscard]] bool mark(Corner c);

  const Subdomain& part_;
  const Triangulation& t_;
  Ranks& ranks_;
  Owner owner_;
  std::vector<TriangleId> triangles_;
  std::vector<Corner> next_;  ///< the corners around which the next ring grows
  bool is_complete_ = false;
  /// Of each triangle: which corners are marked (bits 0 to 2), and whether it is in the list (bit 3).
  SparseArray<unsigned char> marks_;
};

}  // namespace pardel::engine
