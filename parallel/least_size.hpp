// A lower bound on the number of triangles that the narrow parts of a domain require.
#pragma once

#include <string>

#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "validate.hpp"

namespace pardel {

/// A bound on the smallest angle needs small triangles where two segments run close to each other: a triangle that
/// stands on an edge of one of them, and whose angles at the edge are at least θ, is at least as high as half of the
/// edge times tan θ. It cannot be higher than the distance to the other segment. So along a length L at a distance g
/// there are at least L tan θ / 2g edges on each of the segments, each with a triangle of its own.
struct LeastSize {
  double triangles = 0;  ///< the sum over all such parts of the domain; 0: there are none
  Point where;           ///< a place in the part that requires most of them
  double width = 0;      ///< the distance of the two segments there
  /// The number of triangles to expect: usually `most_likely` times as many in such parts, or what all bounds of the
  /// goal let expect if it is more (only in Options::before_refinement). Measured: right within a factor of two.
  double expected = 0;

  static constexpr double most_likely = 2.2;  ///< measured: 1.6 to 2.9

  /// True if the narrow parts, and not the bounds on size, determine what is expected.
  [[nodiscard]] bool is_of_narrow_parts() const { return expected <= most_likely * triangles; }
  /// True if message() names the narrow part.
  [[nodiscard]] bool names_narrow_part() const { return is_of_narrow_parts() || triangles >= 1e6; }
  /// One or two sentences.
  [[nodiscard]] std::string message() const;
};

/// The bound for a goal with this smallest angle, in degrees, from 0 to 45. Segments with a common end do not count,
/// because small angles of the input are exempt; parts do not count if they are narrower than the floor there
/// (Options::min_edge), because they are not refined, or if more than 64 triangles of the constrained Delaunay
/// triangulation lie between the segments. So the bound can be much too small, but the mesh is hardly ever smaller.
/// Errors: those of triangulate(). Time: that of triangulate() and O(n). `threads`: 0 or less for as many as OpenMP
/// offers; the result does not depend on it.
[[nodiscard]] Result<LeastSize> least_size(const ValidPslg& domain, double min_angle_deg, double min_edge = 0,
                                           int threads = 0);

}  // namespace pardel
