// What the engine's tests share: random point sets, and what a right triangulation is, by exact arithmetic.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "../../core/pslg.hpp"
#include "../../parallel/triangulation/insert_constraints.hpp"
#include "../../parallel/triangulation/triangulation.hpp"
#include "../../properties/domains/generators/random.hpp"

namespace pardel::engine::samples {

/// The generators' random numbers, and fractions of them.
class Random : public generators::Random {
 public:
  using generators::Random::Random;
  /// A multiple of 2^-53 in [0, 1).
  double uniform() { return static_cast<double>(next() >> 11U) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// In [0, n).
  Index below(std::size_t n) { return static_cast<Index>(generators::Random::below(n)); }
};

/// A set of distinct points that are not all collinear.
struct Family {
  std::string name;
  std::vector<Point> points;
};
/// Every kind of position that breaks a triangulator, each with about n points.
[[nodiscard]] std::vector<Family> families(std::size_t n, std::uint64_t seed);
[[nodiscard]] std::vector<Point> uniform_points(std::size_t n, std::uint64_t seed);
/// The n * n points of a unit lattice.
[[nodiscard]] std::vector<Point> lattice_points(int n);

/// Random segments that meet at most in common ends and run through no point, short ones and long ones.
[[nodiscard]] std::vector<Constraint> random_constraints(const std::vector<Point>& points, std::size_t tries,
                                                         Random& random);

/// What is wrong with the topology, the orientation or an unconstrained edge (which has to be locally Delaunay),
/// with or without ghosts; empty when nothing is. Linear time.
[[nodiscard]] std::string fault(const Triangulation& t);

/// The constrained Delaunay triangulation of the points and their convex hull, the vertices in the order of the
/// points, without ghosts, ready for refinement: hull edges and the given constraints are lines.
struct Sample {
  Triangulation triangulation;
  std::vector<Constraint> constraints;
};
[[nodiscard]] Sample triangulated(const std::vector<Point>& points, std::vector<Constraint> constraints = {});

/// The triangles as sorted triples of vertices, sorted.
[[nodiscard]] std::vector<std::array<Index, 3>> triples(const Triangulation& t);
/// The side u-v of some triangle, or none().
[[nodiscard]] EdgeRef find_edge(const Triangulation& t, VertexId u, VertexId v);
/// Twice the area of what is not ghost, in floating point: exact for points of a small lattice.
[[nodiscard]] double twice_area(const Triangulation& t);

}  // namespace pardel::engine::samples
