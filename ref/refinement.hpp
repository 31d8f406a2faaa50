// What Delaunay refinement is made of, whoever decides about the order: which triangles are poor, where their split
// points go, which subsegments have to be split, and where everything comes from.
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

/// A mesh on its way.
struct Refinement {
  PlainMesh mesh;
  Provenance provenance;               ///< its keys are the subsegments
  std::map<Edge, ExactPoint> waiting;  ///< subsegments that must be split, each with its midpoint
  std::optional<Error> failure;        ///< why it cannot go on: a split point that is no double
};

/// Why Ruppert's proof does not cover this, or nothing: an Error of kind `usage` where there are no segments, where
/// two of them meet at less than 60 degrees, where the angle bound is above arcsin(1 / (2 sqrt 2)) = 20.7 degrees,
/// and for what the reference does not carry: point attributes, hulls as domains.
[[nodiscard]] std::optional<Error> refused(const Pslg& pslg, const Goal& goal);

/// Where refinement starts: a Delaunay mesh of the domain in which every subsegment is an edge and none is
/// encroached, so that it is constrained Delaunay as well. The input's points come first.
[[nodiscard]] Refinement conforming_delaunay(const Pslg& pslg);

/// Says that e must be split; nothing happens where it is known already.
void demand_split(Refinement& state, const Edge& e);

/// Splits whatever waits and becomes encroached by that, until no subsegment waits: one after the other.
void split_waiting(Refinement& state);

/// Notes where the vertex comes from, which has just been inserted: it splits the subsegment `split`, if given.
void account_for(Refinement& state, Index vertex, const std::optional<Edge>& split);

/// What can be encroached since that vertex was inserted: any subsegment, by the vertex, and a half of the subsegment
/// that it split, by any other.
[[nodiscard]] std::vector<Edge> encroached_since(const Refinement& state, Index vertex);

/// What a triangle must be like: the goal's bounds and the area caps of the regions.
class Criteria {
 public:
  /// The mesh, of any resolution, tells the faces of the domain from each other.
  Criteria(const Pslg& pslg, const Goal& goal, const PlainMesh& mesh);

  /// Where a poor triangle wants a vertex: its circumcentre, rounded to doubles. Nothing for a good one. A triangle
  /// is poor whose ratio of circumradius to shortest edge is above 1 / (2 sin(angle bound)), or that is too large.
  const std::optional<ExactPoint>& split_point(const PlainMesh& mesh, const Corners& t);

 private:
  struct Cap {
    PlainMesh face;
    double max_area;
  };
  [[nodiscard]] double area_cap_at(const ExactPoint& p) const;
  [[nodiscard]] bool is_poor(const PlainMesh& mesh, const Corners& t) const;

  Goal goal_;
  std::vector<Cap> caps_;
  std::map<Corners, std::optional<ExactPoint>> known_;  ///< triangles never change
};

}  // namespace pardel::ref
