#include "filling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "../arithmetic/floor.hpp"
#include "../patches/border_edges.hpp"
#include "../patches/cut_out.hpp"
#include "../patches/find_patches.hpp"
#include "../patches/lay_patches.hpp"
#include "../triangulation/limits.hpp"

namespace pardel::engine {
namespace {

void append_border_points(const Patch& patch, std::vector<Point>& points) {
  for (const Piece& piece : patch.pieces())
    if (piece.on_border)
      for (int x = piece.low; x <= piece.high; x += 2) points.push_back(patch.lattice().at(x, piece.row));
}

}  // namespace

Error border_missing() { return {ErrorKind::internal, "the border of a patch is not in the triangulation"}; }

double edge_of_patch(double max_area, double max_edge) {
  constexpr double to_spare = 0.9995;  // far more than the rounding of a point
  return to_spare * std::min(2 * std::sqrt(max_area / std::numbers::sqrt3), max_edge);
}

Result<std::optional<Filling>> Filling::make(const Pslg& pslg, bool convex_hull, const DomainTriangulation& coarse,
                                             std::span<const double> edges, std::span<const Clearing> clearings,
                                             const Options& options, const Threads& threads, std::uint64_t pieces) {
  std::vector<double> allowed(edges.begin(), edges.end());
  // Edges from the border of a patch to what is around it can be shorter than those of the patch.
  const double floor = Floor(options.min_edge).least();
  for (double& edge : allowed)
    if (patch_clearance * edge < floor) edge = INFINITY;
  Filling filling;
  filling.patches_ = find_patches(coarse.triangulation, allowed, clearings, threads);
  if (filling.patches_.empty()) return std::optional<Filling>();

  const std::size_t inputs = pslg.points.size();
  Pslg with_borders;
  with_borders.points = pslg.points;
  with_borders.segments = pslg.segments;
  with_borders.holes = pslg.holes;
  with_borders.regions = pslg.regions;
  for (const auto& [region, patch] : filling.patches_) {
    append_border_points(patch, with_borders.points);
    filling.inner_points_ += patch.inner_points();
    filling.triangles_ += patch.triangles();
  }
  const std::uint64_t vertices = with_borders.points.size() + filling.inner_points_;
  if (options.max_vertices > 0 && vertices > options.max_vertices) return std::optional<Filling>();
  const double per_piece = static_cast<double>(filling.triangles_) / static_cast<double>(pieces);
  if (Status fits = check_size(per_piece, options); !fits) return fits.error();
  if (outgrows_memory(with_borders.points.size() + filling.inner_points_ / pieces, options))
    return too_much_memory(options);

  Result<DomainTriangulation> domain = triangulate_domain(with_borders, convex_hull, threads);
  if (!domain) return domain.error();
  std::vector<VertexId> border(with_borders.points.size() - inputs);
  for (VertexId v = 0; v < domain->input_of_vertex.size(); ++v)
    if (const Index input = domain->input_of_vertex[v]; input >= inputs) border[input - inputs] = v;
  if (!cut_out(domain->triangulation, border, BorderEdges(filling.patches_, border), threads)) return border_missing();
  filling.domain_ = std::move(*domain);
  filling.points_ = std::move(with_borders.points);
  filling.first_border_ = static_cast<Index>(inputs);
  return std::optional(std::move(filling));
}

Status Filling::lay(Mesh& mesh, const Threads& threads) const {
  if (mesh.triangles.size() + triangles_ > max_engine_triangles) return too_many_triangles();
  if (!lay_patches(mesh, patches_, first_border_, threads)) return border_missing();
  return Done{};
}

}  // namespace pardel::engine
