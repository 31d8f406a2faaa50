// Incremental Delaunay triangulation: one point after the other, within a box (Bowyer 1981, Watson 1981).
#pragma once

#include "../concurrency/lattice.hpp"
#include "cavity.hpp"
#include "triangulation.hpp"

namespace pardel::engine {

/// What became of a point.
enum class Inserted : std::uint8_t {
  yes,
  leaves_box,    ///< nothing was changed; a larger box is needed
  duplicate,     ///< it is a vertex already
  inconsistent,  ///< the triangulation is none: a mistake of this program
};

/// Inserts vertices into a Delaunay triangulation with ghosts. Only triangles whose corners all lie in the box are
/// changed, and only they and their neighbours are looked at: so several of these may work at once on boxes that are
/// disjoint. The point at infinity lies in no box but that of everything. A thread has one of its own.
class BowyerWatson {
 public:
  explicit BowyerWatson(Triangulation& t) : t_(t) {}

  /// `near`: where to look first; a triangle whose corners all lie in the box, and no ghost.
  void start(const Box& box, TriangleId near) {
    box_ = box;
    holds_infinity_ = box.is_everything();
    near_ = near;
  }

  /// Inserts v, whose point the triangulation has already, with `fresh` and fresh + 1 for the two triangles that are
  /// more afterwards.
  [[nodiscard]] Inserted insert(VertexId v, TriangleId fresh);

 private:
  [[nodiscard]] bool in_box(VertexId v) const { return v == ghost ? holds_infinity_ : box_.contains(t_.points[v]); }

  Triangulation& t_;
  Box box_;
  bool holds_infinity_ = true;
  TriangleId near_ = 0;
  Cavity cavity_;
};

}  // namespace pardel::engine
