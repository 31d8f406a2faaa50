// The contract between pardel and a sequential mesher that refines parts of a mesh. Whoever implements
// SubdomainMesher::refine() can mesh on all cores (mesh_with_mesher.hpp). docs/off-the-shelf.md explains how.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "../core/goal.hpp"
#include "../core/pslg.hpp"

namespace pardel {

/// An edge that the refined subdomain must still contain: whole, or in pieces if it may be split. The subdomain lies to
/// the left of a-b and, if the edge is inside it, to the right as well. Edges on the border of the subdomain are
/// listed, and edges inside it that belong to segments of the domain.
struct SubdomainEdge {
  Index a = 0, b = 0;         ///< points of the subdomain
  bool inside = false;        ///< false: no triangle of the subdomain lies to the right
  bool may_be_split = false;  ///< false: the edge is frozen
};

/// A cell of a lattice or quadtree: a half-open rectangle.
struct SubdomainCell {
  Point low, high;
  [[nodiscard]] bool contains(Point p) const { return p.x >= low.x && p.x < high.x && p.y >= low.y && p.y < high.y; }
};

/// A part of a mesh that has to be refined: plain values that no other task changes.
struct Subdomain {
  std::vector<Point> points;
  /// The corners, counter-clockwise. The triangles are constrained Delaunay. They need not be connected.
  std::vector<std::array<Index, 3>> triangles;
  std::vector<SubdomainEdge> edges;
  /// The largest area in the region of a triangle, one number > 0 per triangle; empty: goal.max_area holds everywhere.
  std::vector<double> max_areas;
  /// Only min_angle_deg, max_area, max_edge and size count.
  Goal goal;
  /// If given, new points have to lie in this cell: the rule of the paper's lattice. Everything that would need a point
  /// elsewhere stays as it is.
  std::optional<SubdomainCell> cell;
  /// No new edge may be shorter. In the mesh, edges that cross frozen borders can be somewhat shorter. New points must
  /// also keep a distance of 2^-39 times their larger coordinate, from other points and from edges that stay.
  double min_edge = 0;
  std::size_t most_new_points = 0;  ///< the most points that may be inserted
  double seconds = 0;               ///< the time in which the answer has to come
};

/// The answer of a mesher.
struct RefinedSubdomain {
  enum class Ending : std::uint8_t {
    finished,  ///< no triangle is left that the mesher can split
    limit,     ///< most_new_points or the time was used up; the triangles are right
    failed,    ///< there are no triangles; `why` says why
    // The same, for programs that run in another process:
    crashed,     ///< it ended by a signal or with an exit code that means no success
    timed_out,   ///< it did not answer in time
    unreadable,  ///< its answer cannot be read
  };
  Ending ending = Ending::finished;
  std::string why;
  /// First the points of the subdomain, bit for bit and in their order, then new ones.
  std::vector<Point> points;
  /// For each new point, the edge of Subdomain::edges that it splits; no_index for a point inside a face.
  std::vector<Index> edge_of_new_point;
  std::vector<std::array<Index, 3>> triangles;  ///< counter-clockwise; all points are corners
};

/// What a mesher can do. Schemes that need more than a mesher can do are refused with a `usage` error.
struct MesherAbilities {
  bool obeys_cell = false;          ///< keeps the rule of Subdomain::cell
  bool keeps_frozen_edges = false;  ///< false: it may only be used with cells, where no frozen edge is ever split
  bool splits_segments = false;     ///< false: segments are split before, and all edges are frozen
  /// Ends by itself where segments meet at small angles. Otherwise it does not get the triangles at such angles that
  /// miss the goal.
  bool exempts_small_angles = false;
  bool is_thread_safe = false;  ///< false: one task at a time (in_processes.hpp runs them in processes)
};

/// A sequential mesher. It is not trusted: every answer is verified before it becomes a part of the mesh.
class SubdomainMesher {
 public:
  SubdomainMesher() = default;
  SubdomainMesher(const SubdomainMesher&) = delete;
  SubdomainMesher& operator=(const SubdomainMesher&) = delete;
  virtual ~SubdomainMesher() = default;

  [[nodiscard]] virtual MesherAbilities abilities() const = 0;
  /// Refines a subdomain. The answer may depend on the subdomain alone; then the mesh is the same on any number of
  /// threads. Called from several threads at once if the mesher is thread-safe. An exception counts as an answer that
  /// failed.
  [[nodiscard]] virtual RefinedSubdomain refine(const Subdomain& subdomain) = 0;
};

}  // namespace pardel
