// The rules of Delaunay refinement that all schemes share: which triangles need work, and which point is inserted for
// one. The schemes differ only in the order, and in who does what at the same time.
//
// Source: J. Ruppert, "A Delaunay refinement algorithm for quality 2-dimensional mesh generation", 1995.
#pragma once

#include <deque>
#include <functional>
#include <optional>

#include "bounds.hpp"

namespace pardel::schemes {

/// An insertion: everything that is known before anything is changed.
struct Insertion {
  Index triangle = no_index;  ///< for which it is
  Point point;
  Side split;     ///< the constrained side that the point splits; none for a circumcentre
  Cavity cavity;  ///< C(point)
  /// How many triangles were read to find it: the cavity, and the triangles across its boundary.
  [[nodiscard]] std::uint64_t work() const { return cavity.triangles.size() + cavity.boundary.size(); }
  [[nodiscard]] bool splits_segment() const { return split.triangle != no_index; }
};

/// A constrained side of t upon which the corner opposite to it encroaches. In a constrained Delaunay mesh every
/// encroached side is found so, from one of its two triangles.
[[nodiscard]] std::optional<Side> encroached_side(const LinkedMesh& mesh, Index t);

/// The longest constrained side of the boundary of p's cavity upon which p encroaches, or beyond which p lies.
[[nodiscard]] std::optional<Side> blocking_side(const LinkedMesh& mesh, const Cavity& cavity, Point p);

/// The circumcentre of a triangle, rounded.
[[nodiscard]] Point circumcentre(const LinkedMesh& mesh, Index t);

/// The insertion that splits a constrained side; nothing if its split point cannot be connected, because the side is
/// almost as short as the distance of two doubles there.
[[nodiscard]] std::optional<Insertion> split_of(const LinkedMesh& mesh, Side side, const SmallAngles& angles);

/// Does t need work? That is, is one of its sides encroached, or does it break a bound?
[[nodiscard]] bool needs_work(const LinkedMesh& mesh, Index t, const Bounds& bounds);

/// What Ruppert's algorithm does for t: it splits an encroached side; or it inserts the circumcentre of a bad triangle;
/// or, if this encroaches upon a segment or lies beyond one, it splits the longest such side of the cavity. Nothing if
/// t needs no work, or if the point cannot be inserted because of rounding. The mesh is not changed. Precondition: the
/// mesh is constrained Delaunay, and t is in use. Time linear in the size of the cavity.
[[nodiscard]] std::optional<Insertion> insertion_for(const LinkedMesh& mesh, Index t, const Bounds& bounds);

/// The same for a triangle that is to go, whether it needs work or not: its circumcentre, or the split that the
/// circumcentre calls for.
[[nodiscard]] std::optional<Insertion> circumcentre_insertion(const LinkedMesh& mesh, Index t, const Bounds& bounds);

/// Carries out an insertion, and returns the new triangles. Precondition: since it was found, no triangle of its cavity
/// has changed.
std::vector<Index> carry_out(LinkedMesh& mesh, const Insertion& insertion);

/// Ruppert's algorithm by one worker on the triangles that wait and on those that it makes, as long as `is_due` holds
/// for them. They are taken in the order in which they were made. Stops when the mesh has `most_points`. Returns its
/// work.
std::uint64_t refine_where(LinkedMesh& mesh, const Bounds& bounds, std::deque<Index> waiting,
                           const std::function<bool(Index)>& is_due, std::size_t most_points);

/// The triangles in use.
[[nodiscard]] std::deque<Index> all_triangles(const LinkedMesh& mesh);

/// The same on all triangles: the standard with which schemes are compared.
std::uint64_t refine_sequentially(LinkedMesh& mesh, const Bounds& bounds, std::size_t most_points);

}  // namespace pardel::schemes
