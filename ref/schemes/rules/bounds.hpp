// The bounds of a goal, as tests of one triangle.
#pragma once

#include <optional>

#include "../../../core/goal.hpp"
#include "../../../core/result.hpp"
#include "small_angles.hpp"

namespace pardel::schemes {

/// An Error of kind `usage` if the schemes do not support the problem: point attributes, segments inside a convex hull,
/// limits on gradation and on features. Nothing otherwise.
[[nodiscard]] std::optional<Error> unsupported(const Pslg& pslg, const Goal& goal);

/// Tests triangles. The bounds are stricter than those of the goal by a relative 2^-40, so a triangle that passes in
/// floating point also passes an exact comparison.
class Bounds {
 public:
  /// Copies what it needs. `mesh`: the triangulation of the domain before its refinement.
  Bounds(const Pslg& pslg, const Goal& goal, const LinkedMesh& mesh);

  /// Has t an angle below the bound that no small angle of the domain justifies?
  [[nodiscard]] bool is_thin(const LinkedMesh& mesh, Index t) const;
  /// Does t exceed a bound on areas or lengths?
  [[nodiscard]] bool is_large(const LinkedMesh& mesh, Index t) const;
  /// The area that a triangle at this place may have: that of the goal, or of an equilateral triangle whose edges have
  /// the wanted length; infinity if the goal has no such bound. For estimates of work.
  [[nodiscard]] double wanted_area(Point p, Index region) const;

  [[nodiscard]] const SmallAngles& small_angles() const { return small_angles_; }

 private:
  [[nodiscard]] double area_cap(Index region) const;

  Goal goal_;
  std::vector<double> caps_;  ///< of regions
  double squared_sine_;       ///< of the bound on angles
  SmallAngles small_angles_;
};

}  // namespace pardel::schemes
