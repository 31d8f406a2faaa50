// Locator: finds the triangles of a mesh in which points lie, and interpolates values given at the vertices.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "../core/mesh.hpp"
#include "../core/result.hpp"

namespace pardel {

namespace engine {
class SearchTree;
}

struct LocatorOptions {
  /// The largest number of threads; 0 or less: as many as OpenMP offers. No result depends on it.
  int threads = 0;
  /// Called in the calling thread from time to time, about every 4 ms. Return false to end the work at once; it then
  /// returns an error (cancelled).
  std::function<bool()> go_on{};
};

/// Locates points in a mesh. The mesh may be any set of triangles, Delaunay or not, with holes, cracks and several
/// components; it need not even be conforming. Its neighbours are not used. Immutable: several threads may use it at
/// the same time. It keeps a view on the points and triangles of the mesh, which must outlive it and must not change.
///
///     const Result<Locator> locator = Locator::over(mesh);
///     if (locator && locator->triangle_at({0.5, 0.5}) != no_index) ...
class Locator {
 public:
  /// Prepares the location of points in a mesh. Errors: invalid_input if a corner is not a point of the mesh, if its
  /// coordinates are not finite or too small or large for exact arithmetic (as validate() has it), or if a triangle is
  /// clockwise; resources; cancelled. A flat triangle contains no point. O(n) time on typical input, on all threads,
  /// and about 20 bytes per triangle.
  [[nodiscard]] static Result<Locator> over(const Mesh& mesh, const LocatorOptions& options = {});

  /// The triangle that contains the point, in its interior or on its boundary; no_index if there is none. Of several,
  /// which have the point on a common edge or vertex, the one with the smallest index. Exact: there is no tolerance. A
  /// point with a coordinate that is not finite lies in no triangle; a coordinate below 2^-140 in magnitude counts as
  /// 0. O(1) on typical input.
  [[nodiscard]] Index triangle_at(Point p) const;

  /// triangle_at() of many points, on all threads. Precondition: `result` has as many elements as `points`. Errors:
  /// cancelled.
  [[nodiscard]] Status triangles_at(std::span<const Point> points, std::span<Index> result,
                                    const LocatorOptions& options = {}) const;

  /// The barycentric coordinates of a point in triangle_at(point): not negative, with the sum 1 up to rounding. On an
  /// edge, the one of the opposite corner is 0; at a vertex, only one is not.
  [[nodiscard]] std::array<double, 3> weights_at(Index triangle, Point p) const;

  /// Interpolates values at the vertices linearly in each triangle. `values`: `columns` numbers per point of the mesh.
  /// `result`: as many per point of `points`; `outside` where there is no triangle. At a vertex the result is its value
  /// exactly, and on an edge it depends on the values at its ends alone. It lies between the values at the corners.
  /// Values that are equal at the corners are reproduced exactly, a linear function up to rounding. Errors: cancelled.
  [[nodiscard]] Status interpolate(std::span<const double> values, std::size_t columns, std::span<const Point> points,
                                   std::span<double> result, double outside = std::numeric_limits<double>::quiet_NaN(),
                                   const LocatorOptions& options = {}) const;

 private:
  explicit Locator(std::shared_ptr<const engine::SearchTree> tree) : tree_(std::move(tree)) {}

  std::shared_ptr<const engine::SearchTree> tree_;
};

}  // namespace pardel
