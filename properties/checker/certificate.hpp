// The certificate: the verdict of the checker, with the violations and measurements that it found.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "../../core/digest.hpp"
#include "../../core/goal.hpp"
#include "violation.hpp"

namespace pardel {

/// An extreme value over all triangles, and the place where it is attained. If several triangles attain the value, the
/// first of them is kept.
struct Extreme {
  double value = 0;
  Index triangle = no_index;  ///< no_index: the mesh has no triangles, or they could not be measured
  Point where;                ///< the corner of an angle, the midpoint of an edge, else the centroid
};

/// A triangle that the checker accepts although it has angles below the bound, because small input angles make each of
/// them unavoidable. The checker uses only coordinates for this decision (Miller, Pav, Walkington 2003). Such an angle
/// is nestled: it lies between two segments; or it is opposite a seditious edge, which joins the insides of two
/// segments at equal distances from their common end, and is at least arctan(sin θ / (2 - cos θ)), where θ is their
/// angle.
struct Justified {
  Index triangle = no_index;
  Index apex = no_index;       ///< the input point at which two segments meet at the small angle
  double input_angle_deg = 0;  ///< the angle of these segments, in degrees
  double angle_deg = 0;        ///< the smallest angle of the triangle, in degrees
};

/// Lengths and radii are in the unit of the coordinates, areas in the square of this unit, angles in degrees. Measured
/// values are computed in doubles, except that `area` is the exact sum, rounded once. The verdict does not depend on
/// measured values.
struct Certificate {
  Goal goal;                        ///< the goal that the mesh was checked against
  std::vector<double> region_caps;  ///< by region: the area cap that was checked; empty without region_caps
  bool valid = false;               ///< true if no violation was found
  bool cancelled = false;  ///< CheckOptions::go_on ended the check: `valid` is false, and violations may be missing
  /// Of a foreign mesh: what was not compared because the mesh or the domain lacks it, for example "regions of
  /// triangles: the mesh has none".
  std::vector<std::string> not_checked{};
  std::vector<Violation> violations;            ///< sorted by kind; violations of one kind in the order of discovery
  std::vector<std::uint64_t> violation_counts;  ///< by kind; the vector has violation_kinds entries
  std::vector<Justified> justified;             ///< sorted by triangle
  std::uint64_t vertices = 0, triangles = 0, constrained_edges = 0;
  Extreme min_angle_deg, max_angle_deg, max_area, max_edge, min_edge, max_circumradius, max_radius_edge_ratio;
  double area = 0;
  /// Triangles whose longest edge is longer than the shortest by at most one part in a million. A mesh with a filled
  /// interior consists mostly of these, and a refined mesh has nearly none.
  std::uint64_t equilateral = 0;
  /// Triangles for which floating-point filters left a test open, so that it was decided in exact arithmetic.
  std::uint64_t decided_exactly = 0;
  std::vector<std::uint64_t> angle_histogram;  ///< 18 bins of 10 degrees over all angles
  /// A program whose ranks have checked the mesh together sets their number. 0: the entry is left out.
  int ranks = 0;
  Digest digest;  ///< of the mesh; all zero if the arrays of the mesh are unusable
};

/// Plain text for people, several lines. All numbers count from 0.
[[nodiscard]] std::string to_text(const Certificate& certificate);
/// The same without the list of violations, with the numbers of files.
[[nodiscard]] std::string summary_text(const Certificate& certificate, const NumbersInWitnesses& numbers = {});

/// JSON, schema pardel.certificate/1. All numbers count from 0. An infinite bound, and an index that is no_index, is
/// written as null.
[[nodiscard]] std::string to_json(const Certificate& certificate);

}  // namespace pardel
