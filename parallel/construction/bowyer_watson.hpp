// Incremental Delaunay triangulation: inserts single points, restricted to a box (Bowyer 1981, Watson 1981).
#pragma once

#include <span>

#include "../decomposition/lattice.hpp"
#include "../triangulation/cavity.hpp"
#include "../triangulation/triangulation.hpp"
#include "insertion_order.hpp"

namespace pardel::engine {

/// The outcome of an insertion.
enum class Inserted : std::uint8_t {
  yes,
  leaves_box,    ///< nothing was changed; the insertion needs a larger box
  duplicate,     ///< a vertex with these coordinates exists already
  inconsistent,  ///< the data structure is not a Delaunay triangulation; this is an internal error
};

/// Inserts vertices into a Delaunay triangulation with ghosts. It changes only triangles whose three corners lie in the
/// half-open box, and reads only these triangles and their neighbours. Several threads can therefore work on disjoint
/// boxes at the same time, each with its own object. Only the whole plane as a box contains the vertex at infinity.
///
/// Of cocircular vertices, the latest in `order` counts as outside the circle of the others, whenever it is inserted.
/// So the triangulation of the vertices does not depend on the sequence of the calls.
class BowyerWatson {
 public:
  /// `order` has to outlive the object.
  explicit BowyerWatson(Triangulation& t, const InsertionOrder& order = order_of_indices) : t_(t), order_(order) {}

  /// Sets the box, and the triangle at which the next point location starts: a non-ghost triangle whose three corners
  /// lie in the box.
  void start(const Box& box, TriangleId near) {
    box_ = box;
    holds_infinity_ = box.is_whole_plane();
    near_ = near;
  }

  /// Inserts vertex v. Precondition: its coordinates are in Triangulation::points. An insertion adds two triangles,
  /// with the ids `fresh` and fresh + 1.
  [[nodiscard]] Inserted insert(VertexId v, TriangleId fresh);
  /// The triangles, ghosts included, that the last successful insertion has made. Valid until the next insertion.
  [[nodiscard]] std::span<const TriangleId> made() const { return made_; }

  /// Returns the non-ghost triangle that contains p or, if p lies outside the convex hull, a ghost triangle whose hull
  /// edge separates p from the hull; no_index if the walk to it leaves the box. The walk starts at near_. It crosses a
  /// side that separates the triangle from p; in a Delaunay triangulation such a walk meets no triangle twice
  /// (Devillers, Pion and Teillaud 2002).
  [[nodiscard]] TriangleId locate(Point p) const;

 private:
  [[nodiscard]] Walk find_cavity(TriangleId first, VertexId v);
  [[nodiscard]] bool in_box(VertexId v) const {
    return v == ghost ? holds_infinity_ : box_.contains_half_open(t_.points[v]);
  }

  Triangulation& t_;
  const InsertionOrder& order_;
  Box box_;
  bool holds_infinity_ = true;
  TriangleId near_ = 0;
  Cavity cavity_;
  std::span<const TriangleId> made_;
};

/// True if v lies in the disk of a triangle, as the insertion of v decides it. The open disk of a ghost triangle is the
/// open half-plane beyond its hull edge, together with the interior of the edge. v need not be in a triangle.
[[nodiscard]] bool is_in_disk(const Triangulation& t, const Slot& slot, VertexId v, const InsertionOrder& order);

}  // namespace pardel::engine
