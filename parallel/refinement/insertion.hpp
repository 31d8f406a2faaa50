// The insertion of one point: finds the point's cavity, tests if the insertion is allowed, and performs it.
#pragma once

#include <span>
#include <vector>

#include "../arithmetic/floor.hpp"
#include "../decomposition/lattice.hpp"
#include "../quality/criteria.hpp"
#include "../threads/index_allocator.hpp"
#include "../triangulation/cavity.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// The outcome of an attempt to insert a point.
enum class Outcome : std::uint8_t {
  inserted,
  encroaches,  ///< the constrained edge blocker() has to be split instead, or lies on the border of a patch
  leaves_box,  ///< the insertion needs a larger or another box; if flips are needed, the whole plane
  too_close,   ///< an edge shorter than the floor would result
  refused,     ///< no valid triangulation would result in double precision
};

/// The indices that a task may give to new vertices and triangles.
struct FreeIndices {
  IndexPool vertices, triangles;
  /// True if there are enough indices for one more insertion.
  [[nodiscard]] bool suffice() const { return vertices.left() >= 1 && triangles.left() >= 2; }
};

/// Inserts points into one triangulation, one at a time, each within a box: only triangles with all corners in the box
/// are changed. Every new triangle is exactly positively oriented. No new edge is shorter than the floor at the new
/// point, up to the rounding of squared lengths. Refinement therefore ends, because only finitely many points fit.
class Insertion {
 public:
  Insertion(Triangulation& t, const Criteria& criteria, double min_edge)
      : t_(t), criteria_(criteria), floor_(min_edge) {}

  /// Later insertions take their indices from `free`. Before each insertion, free.suffice() has to be true.
  void start(FreeIndices& free) {
    free_ = &free;
    has_flipped_ = false;
  }

  /// Inserts p, unless p encroaches on a constrained edge of its cavity or lies beyond such an edge. The outcome is
  /// `refused` if p is not in the open circumdisk of `first`. Precondition: all corners of `first` lie in the box.
  Outcome insert_in_face(Point p, TriangleId first, const Box& box);

  /// The outcome that insert_in_face() would have; changes nothing (`inserted`: p can be inserted).
  Outcome try_in_face(Point p, TriangleId first, const Box& box);

  /// Inserts p without another test. Precondition: the last call was try_in_face() for p, which returned `inserted`.
  void insert_tried_in_face(Point p);

  /// Splits the constrained edge e, which is a part of `segment`, at p.
  Outcome split_edge(Point p, EdgeRef e, Index segment, const Box& box);

  /// The outcome that split_edge() would have; changes nothing (`inserted`: e can be split at p).
  Outcome try_on_edge(Point p, EdgeRef e, const Box& box);

  /// After `inserted`: the triangles that are new or changed.
  [[nodiscard]] std::span<const TriangleId> changed() const { return changed_; }
  /// After `inserted`: the measures of changed(), in the same order. Empty if flips were needed.
  [[nodiscard]] std::span<const Measure> measures() const {
    return {measures_.data(), is_measured_ ? changed_.size() : 0};
  }
  /// After `inserted`, if measures() is not empty: the positions in changed() of the triangles that break the bound on
  /// angles or the bound on areas that holds everywhere.
  [[nodiscard]] std::span<const std::size_t> breaking() const { return {breaking_.data(), breaking_count_}; }
  /// After `inserted`, also of try_in_face(), as for breaking(): the squared distance from the point to the nearest of
  /// the vertices that it is, or would be, connected to.
  [[nodiscard]] double squared_closest() const { return squared_closest_; }
  /// After `inserted`: if false, no triangle of changed() has a constrained side.
  [[nodiscard]] bool may_touch_constraint() const { return cavity_.touches_constraint() || cavity_.splits_edge(); }
  /// If the search for the last cavity has thrown NotHeld: the ends of the edges at which the cavity leaves the part
  /// that the process holds. Otherwise there may be none.
  [[nodiscard]] std::vector<VertexId> ends_of_missed_edges() const;
  /// True if an insertion since start() needed flips (see QueuedTriangle).
  [[nodiscard]] bool has_flipped() const { return has_flipped_; }
  /// After `encroaches`: the longest encroached part of a segment, seen from inside the cavity. If there is none, an
  /// edge on the border of a patch.
  [[nodiscard]] EdgeRef blocker() const { return blocker_; }
  /// After insert_in_face() returned `leaves_box`: true if some triangle of p's cavity that does not lie in the box has
  /// at most this circumradius. Precondition: p lies in the box.
  [[nodiscard]] bool left_box_for(Point p, const Box& box, double squared_circumradius) const;

 private:
  /// Measures the triangles that would join p to the edges of the cavity's boundary (the fan). Returns true if all of
  /// them are positively oriented.
  bool measure_fan(Point p);
  /// The longest constrained edge of the boundary on which the point encroaches or beyond which it lies; none() if
  /// there is no such edge. Edges on the border of a patch, which cannot be split, come last.
  [[nodiscard]] EdgeRef longest_encroached() const;
  [[nodiscard]] bool too_close(Point p) const { return squared_closest_ < floor_.squared_at(p); }
  Outcome edge_by_flips(Point p, EdgeRef e, Index segment);
  void commit(Point p, Index origin);
  void finish_by_flips();

  Triangulation& t_;
  const Criteria& criteria_;
  Floor floor_;
  FreeIndices* free_ = nullptr;
  Cavity cavity_;
  bool is_star_ = false;              ///< after try_in_face and try_on_edge: the cavity is star-shaped around the point
  double squared_closest_ = 0;        ///< after measure_fan: distance to the nearest corner of the boundary
  Point tried_{};                     ///< the last point whose cavity was sought,
  TriangleId tried_from_ = no_index;  ///< beginning here
  bool has_flipped_ = false;
  std::span<const TriangleId> changed_;  ///< the cavity's triangles, or flipped_
  std::vector<TriangleId> flipped_;
  bool is_measured_ = false;
  // Scratch memory. The number of boundary edges and breaking_count_ determine how much of it is in use.
  std::vector<Measure> measures_;
  std::vector<std::size_t> breaking_;
  std::size_t breaking_count_ = 0;
  EdgeRef blocker_;
};

}  // namespace pardel::engine
