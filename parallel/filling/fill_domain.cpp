#include "fill_domain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../scheduling/limits.hpp"
#include "find_patches.hpp"
#include "lay_patches.hpp"

namespace pardel::engine {
namespace {

void append_border_points(const Patch& patch, std::vector<Point>& points) {
  for (const Piece& piece : patch.pieces())
    if (piece.on_border)
      for (int x = piece.low; x <= piece.high; x += 2) points.push_back(patch.lattice().at(x, piece.row));
}

}  // namespace

double edge_of_patch(double max_area, double max_edge) {
  constexpr double to_spare = 0.9995;  // far more than the rounding of a point
  return to_spare * std::min(2 * std::sqrt(max_area / std::numbers::sqrt3), max_edge);
}

Result<std::optional<Filling>> fill_domain(const Pslg& pslg, bool convex_hull, const DomainTriangulation& coarse,
                                           std::span<const double> edges, const Options& options,
                                           const Threads& threads) {
  const std::vector<RegionPatch> patches = find_patches(coarse.triangulation, edges, threads);
  if (patches.empty()) return std::optional<Filling>();

  Filling filling;
  std::uint64_t vertices = pslg.points.size();
  for (const auto& [region, patch] : patches) {
    vertices += patch.border_points() + patch.inner_points();
    filling.triangles += patch.triangles();
  }
  if (options.max_vertices > 0 && vertices > options.max_vertices) return std::optional<Filling>();
  if (outgrows_memory(vertices, options)) return too_much_memory(options);
  if (Status fits = check_size(static_cast<double>(filling.triangles), options); !fits) return fits.error();

  Pslg with_borders;
  with_borders.points = pslg.points;
  with_borders.segments = pslg.segments;
  with_borders.holes = pslg.holes;
  with_borders.regions = pslg.regions;
  for (const auto& [region, patch] : patches) append_border_points(patch, with_borders.points);
  Result<DomainTriangulation> domain = triangulate_domain(with_borders, convex_hull, threads);
  if (!domain) return domain.error();
  Triangulation& t = domain->triangulation;
  const std::size_t inputs = pslg.points.size();
  std::vector<VertexId> border(with_borders.points.size() - inputs);
  for (VertexId v = 0; v < t.points.size(); ++v)
    if (const Index input = domain->input_of_vertex[v]; input >= inputs) {
      border[input - inputs] = v;
      t.origin[v] = interior_vertex;
    }
  domain->settled_from = static_cast<TriangleId>(t.slots.size());
  if (!lay_patches(t, patches, border, threads))
    return Error{ErrorKind::internal, "the border of a patch is not in the triangulation"};
  filling.domain = std::move(*domain);
  filling.points = std::move(with_borders.points);
  return std::optional(std::move(filling));
}

}  // namespace pardel::engine
