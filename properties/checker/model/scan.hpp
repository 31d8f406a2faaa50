// The scan: one pass over all triangles that makes every test of a single triangle, or of two neighbours, with
// coordinates loaded once. It decides by floating-point filters (arithmetic/filter.hpp) and lists the tests that these
// leave open. The stages decide the open tests exactly, and describe violations. So they need not visit the others.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "adjacency.hpp"
#include "measures.hpp"
#include "stoppable.hpp"

namespace pardel::checker {

/// Tests of one triangle. A number of tests is the sum of their values.
enum class Test : std::uint8_t {
  orientation = 1,
  delaunay = 2,  ///< of an edge to a neighbour with a greater number
  angle = 4,
  area = 8,
  edge = 16,
  circumradius = 32,
};

/// The bounds of the tests. The default values mean: no bound.
struct ScanBounds {
  double cosine = 1;  ///< of the smallest angle
  double area = std::numeric_limits<double>::infinity();
  double edge = std::numeric_limits<double>::infinity();
  double circumradius = 0;
  bool boundary = true;  ///< false: the edges without a neighbour are not listed
};

/// A triangle with tests that are still open.
struct OpenTriangle {
  Index triangle;
  std::uint8_t tests;
  [[nodiscard]] bool has(Test test) const { return (tests & static_cast<std::uint8_t>(test)) != 0; }
};

struct Scan {
  bool points_finite = true;        ///< if not, the scan has ended here
  bool corners_usable = true;       ///< all are distinct and in range; if not, the rest has no meaning
  bool neighbours_in_range = true;  ///< if not, the scan took the wrong ones as absent
  /// Each neighbour has the common edge in the other direction, and names the triangle there.
  bool neighbours_reciprocal = true;
  std::vector<OpenTriangle> open;      ///< ascending; without a meaning for edges if neighbours are not reciprocal
  std::vector<BoundaryEdge> boundary;  ///< the edges without a neighbour, sorted as in Adjacency
  Array<Index> start;                  ///< per vertex one of its triangles, any of them, or no_index
  /// The number of triangles that the ray from one of their corners to the right enters there, see first_ray_corner().
  std::uint64_t rays = 0;
  Measures measures;

  /// The triangles for which one of the tests is open, ascending.
  template <class... Tests>
  [[nodiscard]] std::vector<Index> open_for(Tests... tests) const {
    std::vector<Index> result;
    for (const OpenTriangle& entry : open)
      if ((entry.has(tests) || ...)) result.push_back(entry.triangle);
    return result;
  }
};

/// Scans the mesh's points and these triangles, on all threads. Throws Stopped. Memory: 4 bytes per point, and the
/// lists of the result.
[[nodiscard]] Scan scan(std::span<const Point> points, std::span<const Triangle> triangles, const ScanBounds& bounds,
                        StopSignal* stop = nullptr);

/// The total order of points by height. Of two points at one height, the one on the right is lower.
[[nodiscard]] inline bool is_lower(Point p, Point q) { return p.y < q.y || (p.y == q.y && p.x > q.x); }

/// True if the ray from corner a to the right begins between the sides to b and c of the counter-clockwise triangle
/// a, b, c, or on the side to b.
[[nodiscard]] inline bool has_ray_at(Point a, Point b, Point c) { return is_lower(b, a) && is_lower(a, c); }

}  // namespace pardel::checker
