// The parts of Delaunay refinement that do not depend on the order of insertions: the test for bad triangles, their
// split points, the subsegments that have to be split, and the origin of vertices and subsegments.
//
// Source: J. Ruppert, "A Delaunay refinement algorithm for quality 2-dimensional mesh generation", 1995;
// the angle condition after J. R. Shewchuk, "Delaunay refinement algorithms for triangular mesh
// generation", 2002.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "../core/goal.hpp"
#include "../core/result.hpp"
#include "faces.hpp"

namespace pardel::ref {

/// The state of a refinement.
struct Refinement {
  PlainMesh mesh;
  Provenance provenance;               ///< the keys of segment_of_edge are the subsegments
  std::map<Edge, ExactPoint> waiting;  ///< subsegments that must be split, each with its midpoint
  std::optional<Error> failure;        ///< set if refinement cannot continue: a split point is not representable
};

/// Returns an Error of kind `usage` if Ruppert's proof does not cover the input: it has no segments, two segments meet
/// at less than 60 degrees, or the angle bound is above arcsin(1 / (2 sqrt 2)) = 20.7 degrees. Returns the same kind of
/// Error for features that the reference does not support: point attributes, and convex hulls as domains. Otherwise
/// returns nothing.
[[nodiscard]] std::optional<Error> unsupported(const Pslg& pslg, const Goal& goal);

/// The start of refinement: a Delaunay mesh of the domain in which every subsegment is an edge and none is encroached.
/// It is therefore constrained Delaunay, too. The input points come first.
[[nodiscard]] Refinement conforming_delaunay(const Pslg& pslg);

/// Requests a split of the subsegment e at its midpoint. No effect if e is waiting already. Sets `failure` if the
/// midpoint is not representable in doubles.
void request_split(Refinement& state, const Edge& e);

/// Splits waiting subsegments one after the other, also those that become encroached, until no subsegment waits.
void split_waiting(Refinement& state);

/// Records the origin of a vertex that was just inserted. If `split` is given, the vertex splits this subsegment.
void record_origin(Refinement& state, Index vertex, const std::optional<Edge>& split);

/// The subsegments that became encroached when `vertex` was inserted: subsegments upon which the vertex encroaches, and
/// the halves of the subsegment that it split, if any vertex encroaches upon them. If there are none, the insertion has
/// raised no circumradius above the largest one (THEORY.md, T2).
[[nodiscard]] std::vector<Edge> newly_encroached(const Refinement& state, Index vertex);

/// 1/ρ̄², where ρ̄ is the largest ratio of circumradius to shortest edge that the angle bound of the goal allows.
[[nodiscard]] double inverse_squared_ratio(const Goal& goal);

/// Tests triangles against the bounds of a goal and the area caps of regions.
class Criteria {
 public:
  /// `mesh` is any mesh of the domain. It determines which part of the domain each region covers.
  Criteria(const Pslg& pslg, const Goal& goal, const PlainMesh& mesh);

  /// The circumcentre of t, rounded to doubles, if t is bad; nothing otherwise. A triangle is bad if its ratio of
  /// circumradius to shortest edge exceeds 1 / (2 sin(angle bound)), or if it is too large.
  const std::optional<ExactPoint>& split_point(const PlainMesh& mesh, const Corners& t);

 private:
  struct Cap {
    PlainMesh face;
    double max_area;
  };
  [[nodiscard]] double area_cap_at(const ExactPoint& p) const;
  [[nodiscard]] bool is_bad(const PlainMesh& mesh, const Corners& t) const;

  Goal goal_;
  std::vector<Cap> caps_;
  std::map<Corners, std::optional<ExactPoint>> known_;  ///< results so far; vertices never move
};

}  // namespace pardel::ref
