#include "limits.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "../../core/support/amount_of_memory.hpp"
#include "../../core/support/shortest.hpp"
#include "triangulation.hpp"

namespace pardel::engine {
namespace {

/// The bytes that the mesh takes for one triangle and half a vertex. Markers that are zero take none. The process needs
/// more.
constexpr double bytes_per_triangle = sizeof(Triangle) + 0.5 * (sizeof(Point) + sizeof(Index));
/// The bytes that the process takes at its peak for one vertex and two triangles, measured with large meshes.
constexpr double peak_bytes_per_vertex = 2 * 40;

double allowed_memory(const Options& options) { return static_cast<double>(options.max_memory); }

}  // namespace

Status check_size(double needed, const Options& options) {
  double triangles = needed;
  if (options.max_vertices > 0) triangles = std::min(triangles, 2.0 * static_cast<double>(options.max_vertices));
  if (triangles > max_engine_triangles) return too_many_triangles();
  const double bytes = triangles * bytes_per_triangle;
  if (options.max_memory == 0 || bytes <= allowed_memory(options)) return Done{};
  return Error{ErrorKind::resources, "the mesh will have more than " + shortest(std::round(triangles / 1e4) / 100) +
                                         " million triangles, which take at least " + amount_of_memory(bytes) +
                                         " of memory; there are " + amount_of_memory(allowed_memory(options))};
}

bool outgrows_memory(std::uint64_t vertices, const Options& options) {
  return options.max_memory > 0 && peak_bytes_per_vertex * static_cast<double>(vertices) > allowed_memory(options);
}

Error too_many_triangles() {
  return {ErrorKind::resources, "the mesh needs more triangles than can be numbered (2^29 - 1)"};
}

Error too_much_memory(const Options& options) {
  return {ErrorKind::resources,
          "the mesh has outgrown the memory that it may use, " + amount_of_memory(allowed_memory(options))};
}

}  // namespace pardel::engine
