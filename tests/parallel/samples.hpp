// Point sets for the tests of the engine, and functions that test a triangulation exactly.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "../../core/pslg.hpp"
#include "../../parallel/construction/insert_constraints.hpp"
#include "../../parallel/triangulation/triangulation.hpp"
#include "../../properties/domains/generators/random.hpp"

namespace pardel::engine::samples {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The random numbers of the generators; below() returns an Index.
class Random : public generators::Random {
 public:
  using generators::Random::Random;
  /// A random number from 0 to n - 1.
  Index below(std::size_t n) { return static_cast<Index>(generators::Random::below(n)); }
};

/// A set of distinct points that are not all collinear.
struct Family {
  std::string name;
  std::vector<Point> points;
};
/// Point sets in difficult positions (cocircular, nearly collinear, clustered, far from the origin, tiny, huge) and in
/// general position, most of them with about n points.
[[nodiscard]] std::vector<Family> families(std::size_t n, std::uint64_t seed);
[[nodiscard]] std::vector<Point> uniform_points(std::size_t n, std::uint64_t seed);
/// The n * n points of a unit lattice.
[[nodiscard]] std::vector<Point> lattice_points(int n);

/// Random segments, short and long, that meet only in common ends and pass through no other point. Makes `tries`
/// attempts.
[[nodiscard]] std::vector<Constraint> random_constraints(const std::vector<Point>& points, std::size_t tries,
                                                         Random& random);

/// Describes an error in the topology, the orientation or the local Delaunay property of unconstrained edges; empty if
/// there is none. The triangulation may have ghosts. Linear time.
[[nodiscard]] std::string fault(const Triangulation& t);

/// The Delaunay triangulation of the points, with ghosts and with the vertices in the order of the points.
[[nodiscard]] Triangulation delaunay_of(const std::vector<Point>& points);

/// The constrained Delaunay triangulation of the convex hull of the points, without ghosts and with the vertices in the
/// order of the points, ready for refinement. `constraints` holds the given constraints and the edges of the hull.
struct Sample {
  Triangulation triangulation;
  std::vector<Constraint> constraints;
};
[[nodiscard]] Sample triangulated(const std::vector<Point>& points, std::vector<Constraint> constraints = {});

/// The triangles as sorted triples of vertices, sorted.
[[nodiscard]] std::vector<std::array<Index, 3>> triples(const Triangulation& t);
/// The edge u-v as a side of the triangle on its left; if there is none, of the triangle on its right; else none().
[[nodiscard]] EdgeRef find_edge(const Triangulation& t, VertexId u, VertexId v);
/// Twice the area of all non-ghost triangles, in floating point. Exact for points of a small lattice.
[[nodiscard]] double twice_area(const Triangulation& t);

}  // namespace pardel::engine::samples
