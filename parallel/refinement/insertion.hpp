// One insertion: is the point's cavity one that may be changed, and if so, change it.
#pragma once

#include <span>
#include <vector>

#include "../concurrency/index_allocator.hpp"
#include "../concurrency/lattice.hpp"
#include "../triangulation/cavity.hpp"
#include "../triangulation/triangulation.hpp"
#include "criteria.hpp"

namespace pardel::engine {

/// What became of an attempt to insert a point.
enum class Outcome : std::uint8_t {
  inserted,
  encroaches,  ///< blocker() is a constrained edge that has to be split instead
  leaves_box,  ///< another task's box, or a larger one, is needed; where flips are needed, one without bounds
  too_close,   ///< an edge below the floor would result
  refused,     ///< no valid triangulation would result in double precision
};

/// The numbers for what a task makes.
struct Supply {
  IndexPool vertices, triangles;
  /// For one more insertion.
  [[nodiscard]] bool suffices() const { return vertices.left() >= 1 && triangles.left() >= 2; }
};

/// Inserts points into one triangulation, one at a time, each within a box: only triangles whose corners
/// all lie in the box are changed. Every triangle made is exactly positively oriented, and no edge made is shorter
/// than `min_edge`: so refinement ends, for only so many points have room (up to rounding of squared lengths).
class Insertion {
 public:
  Insertion(Triangulation& t, const Criteria& criteria, double min_edge)
      : t_(t), criteria_(criteria), squared_floor_(min_edge * min_edge) {}

  /// Numbers come from `supply`, which has to suffice for each insertion.
  void start(Supply& supply) {
    supply_ = &supply;
    has_flipped_ = false;
  }

  /// Inserts p, unless it encroaches on a constrained edge of its cavity or lies beyond one. Refused where p
  /// does not lie in the open circumdisk of `first`. Precondition: the corners of `first` lie in the box.
  Outcome insert_in_face(Point p, TriangleId first, const Box& box);

  /// What insert_in_face would find, with nothing changed (`inserted` then means that it could be).
  Outcome try_in_face(Point p, TriangleId first, const Box& box);

  /// Splits the constrained edge e, a piece of `segment`, at p.
  Outcome split_edge(Point p, EdgeRef e, Index segment, const Box& box);

  /// What split_edge would find, with nothing changed (`inserted` then means that it could be).
  Outcome try_on_edge(Point p, EdgeRef e, const Box& box);

  /// After `inserted`: the triangles that are new or changed.
  [[nodiscard]] std::span<const TriangleId> changed() const { return changed_; }
  /// After `inserted`: their measures, in the same order; empty where flips were needed.
  [[nodiscard]] std::span<const Measure> measures() const {
    return {measures_.data(), is_measured_ ? changed_.size() : 0};
  }
  /// After `inserted`, with measures: which of changed() break a bound that is the same everywhere.
  [[nodiscard]] std::span<const std::size_t> breaking() const { return {breaking_.data(), breaking_count_}; }
  /// After `inserted`: some side of changed() may be constrained.
  [[nodiscard]] bool may_touch_constraint() const { return cavity_.touches_constraint() || cavity_.splits_edge(); }
  /// Some insertion since the start needed flips, which can leave a triangle's slot and first corner as they were and
  /// change the others.
  [[nodiscard]] bool has_flipped() const { return has_flipped_; }
  /// After `encroaches`: the longest of the edges encroached, seen from inside the cavity.
  [[nodiscard]] EdgeRef blocker() const { return blocker_; }
  /// After `leaves_box` in a face: some triangle that p's cavity has beyond the box is no larger than this.
  /// Precondition: p lies in the box.
  [[nodiscard]] bool left_box_for(Point p, const Box& box, double squared_circumradius) const;

 private:
  /// Measures the fan that would be made; false where p does not see every edge of the boundary from its left.
  bool measure_fan(Point p);
  /// Of a boundary edge and p, exactly.
  [[nodiscard]] double orientation_of(std::size_t edge, Point p) const;
  /// Of the constrained edges of the boundary that the point encroaches on or lies beyond; none() if there is none.
  [[nodiscard]] EdgeRef longest_encroached() const;
  [[nodiscard]] bool too_close() const { return squared_closest_ < squared_floor_; }
  Outcome face_by_flips(Point p);
  Outcome edge_by_flips(Point p, EdgeRef e, Index segment);
  void commit(Point p, Index origin);
  void finish_by_flips();

  Triangulation& t_;
  const Criteria& criteria_;
  double squared_floor_;
  Supply* supply_ = nullptr;
  Cavity cavity_;
  bool is_star_ = false;        ///< after try_in_face and try_on_edge
  double squared_closest_ = 0;  ///< after measure_fan: from the point to the nearest corner of the boundary
  bool has_flipped_ = false;
  std::span<const TriangleId> changed_;  ///< the cavity's, or flipped_
  std::vector<TriangleId> flipped_;
  bool is_measured_ = false;
  // Scratch, of which as much is in use as the boundary has edges, and as breaking_count_ says.
  std::vector<Measure> measures_;
  std::vector<std::size_t> breaking_;
  std::size_t breaking_count_ = 0;
  EdgeRef blocker_;
};

}  // namespace pardel::engine
