// Goal: the bounds that a mesh must satisfy, in addition to conforming to its Pslg. The mesher refines until they hold;
// the checker verifies them. For a goal without bounds (on angles, areas, edges or sizes) the mesher inserts no point,
// unless the goal is conforming: then it splits segments until all edges are Delaunay, and inserts no other point.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "pslg.hpp"
#include "size_source.hpp"

namespace pardel {

/// The most edges across narrow places that a goal may ask for, and the least limit on gradation.
inline constexpr double most_feature_edges = 1e6, least_grading = 1e-12;

/// A test of the user: true if the triangle with these corners and this area must be refined.
using UserTest = std::function<bool(const std::array<Point, 3>& corners, double area)>;

struct Goal {
  /// The least angle of a triangle, in degrees, from 0 (no bound) to 33, or to 45 if Options::max_vertices is set. The
  /// default is the proven bound of Ruppert's algorithm: arcsin(1 / (2 sqrt 2)) = 20.7 degrees, a ratio of circumradius
  /// to shortest edge of at most sqrt 2.
  double min_angle_deg = 20.7;
  /// The largest area of a triangle, in squared units of the coordinates, > 0.
  double max_area = std::numeric_limits<double>::infinity();
  /// The longest edge, in units of the coordinates, > 0.
  double max_edge = std::numeric_limits<double>::infinity();
  /// True: the triangles of a region have at most the area Region::max_area. False: Region::max_area is ignored.
  bool region_caps = false;
  /// Sizing: returns the longest edge allowed near a point, > 0; infinity means no bound there. A triangle is too large
  /// if its longest edge exceeds size(centroid). Empty: no such bound. The function must be pure and callable from
  /// several threads at once. If it throws an Error (result.hpp), the mesher returns this error. If it
  /// throws anything else, or returns a number that is not positive, the mesher returns a `usage` error that names the
  /// point. The error is the same for any number of threads.
  std::function<double(Point)> size{};
  /// Announces places about which `size` will be asked soon, a few at a time: for a `size` that is computed faster for
  /// many places at once, and that keeps the values until then. `size` is also asked about other places, and not about
  /// all that were announced. Called by the thread that will ask. Its exceptions end the run as those of `size` do.
  /// Ignored without `size`. Empty: nothing is announced.
  std::function<void(std::span<const Point>)> before_sizes{};
  /// A promise about `size`: its values at two points differ by at most this number times their distance, up to
  /// rounding; infinity: nothing is promised. A number up to 0.5 makes graded meshes faster and changes no triangle,
  /// because the size at a new vertex then decides about most of its triangles. If `size` breaks the promise, triangles
  /// may be too large, and the checker reports them. The sizes of interpolated_size() need no promise.
  double size_slope = std::numeric_limits<double>::infinity();
  /// The limit on gradation: the wanted length grows by at most this number per unit of distance, > 0; infinity: no
  /// limit. It grows from the `sources`, from each segment of the domain, on which it is at most the length of the
  /// segment, and from narrow places, as feature_edges says with 1 edge if feature_edges is 0. A triangle is too large
  /// if its longest edge exceeds the least of all these lengths at its centroid. Distances are straight, also across
  /// holes. At least 1e-12. Not for refine(), which has no segments of a domain.
  double grading = std::numeric_limits<double>::infinity();
  /// Where lengths are prescribed, for `grading`. `size` itself does not count: a function cannot be limited before
  /// all its values are known. size_sources() (raster.hpp, mesher.hpp) makes the sources of a field of sizes.
  std::vector<SizeSource> sources{};
  /// How many edges lie across narrow places of the domain, from 0 to 1e6; 0: no such bound. On a feature (a segment or
  /// a corner) the wanted length is the distance to the nearest feature that is apart from it, divided by this number.
  /// At a vertex where a polyline turns it is the radius of the turn, divided by this number. Away from there it grows
  /// by the reciprocal of this number per unit of distance, or by `grading` if that is less. docs/sizes.md has the
  /// definitions. Not for refine().
  double feature_edges = 0;
  /// True for a triangle that must be refined, in addition to the other bounds; empty: no such test. It must be a pure
  /// function of its arguments: then the mesh does not depend on the number of threads. The corners are in
  /// counter-clockwise order from the lexicographically least one (the least x, and of these the least y). The area is
  /// computed from the corners in this order, and not negative. user_test.hpp asks so, for the mesher and the checker.
  /// The test is also asked about reduced copies of triangles, from which the mesher estimates how many triangles there
  /// will be. If it throws, the mesher returns an error as for `size`, which names the corners.
  ///
  /// A test that is true for every triangle, however small, is refined down to the floor (Options::min_edge), which
  /// takes too many triangles in nearly all domains. Set Options::max_vertices or min_edge if a test may be of this
  /// kind. Report::exempt lists the triangles for which the test is still true, with the reasons, and
  /// Report::fail_user_test counts them. A triangle is also split where small input angles would excuse its angles.
  UserTest user_test{};
  /// False: the test is asked by one thread at a time, and the run has one thread. True: the test has no state, and all
  /// threads ask it. The mesh is the same.
  bool user_test_is_free_of_state = false;
  /// True: the mesh must be Delaunay, that is, every edge is locally Delaunay, constrained edges too. False: the mesh
  /// must be constrained Delaunay.
  bool conforming = false;
  /// True: the domain is the convex hull of the points. A Pslg without segments always has this domain.
  bool convex_hull = false;
};

}  // namespace pardel
