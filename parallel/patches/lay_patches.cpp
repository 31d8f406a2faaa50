#include "lay_patches.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "../threads/parallel_arrays.hpp"
#include "border_edges.hpp"
#include "write_strips.hpp"

namespace pardel::engine {
namespace {

void write_points(const Patch& patch, const PlacesOfPatch& places, Mesh& mesh, const Threads& threads) {
  parallel_runs(threads, patch.pieces().size(), [&](std::size_t i) {
    const Piece& piece = patch.pieces()[i];
    if (piece.on_border) return;
    const std::size_t first = places.first_inner + piece.first;
    for (std::size_t k = 0; k < piece.count(); ++k)
      mesh.points[first + k] = patch.lattice().at(piece.low + 2 * static_cast<int>(k), piece.row);
  });
}

/// Lengthens the list of origins. The new points are interior ones.
void add_origins(Mesh& mesh, std::size_t points) {
  static_assert(interior_vertex == 0);
  Array<Index> origin = Array<Index>::zeroes(points);
  std::ranges::copy(mesh.origin, origin.begin());
  mesh.origin = std::move(origin);
}

}  // namespace

std::optional<std::vector<Seam>> join_to_patches(Mesh& around, std::span<const RegionPatch> patches, Index first_border,
                                                 const Threads& threads) {
  const auto old = static_cast<Index>(around.triangles.size());
  std::size_t border_points = 0;
  for (const auto& [region, patch] : patches) border_points += patch.border_points();
  std::vector<VertexId> border(border_points);
  std::iota(border.begin(), border.end(), first_border);
  const BorderEdges edges(patches, border);
  std::vector<Seam> seams;
  SparseAsk ask(threads.stop);
  for (Index id = 0; id < old; ++id) {
    ask();
    Triangle& beside = around.triangles[id];
    for (unsigned side = 0; side < 3; ++side) {
      if (beside.n[side] != no_index) continue;
      // The patch sees the edge in the opposite direction.
      const BorderEdge* edge = edges.find(beside.v[previous_corner[side]], beside.v[next_corner[side]]);
      if (edge == nullptr) continue;
      beside.n[side] = old + static_cast<Index>(edge->triangle);
      seams.push_back({beside.n[side], edge->side, id});
    }
  }
  if (seams.size() != edges.all().size()) return {};
  std::fill_n(around.origin.begin() + first_border, border_points, interior_vertex);
  return seams;
}

bool lay_patches(Mesh& mesh, std::span<const RegionPatch> patches, Index first_border, const Threads& threads) {
  const std::optional<std::vector<Seam>> seams = join_to_patches(mesh, patches, first_border, threads);
  if (!seams) return false;
  const std::vector<PlacesOfPatch> places = places_of(patches, first_border, mesh.points.size(), mesh.triangles.size());
  std::size_t points = mesh.points.size(), triangles = mesh.triangles.size();
  for (const auto& [region, patch] : patches) {
    points += patch.inner_points();
    triangles += patch.triangles();
  }
  mesh.points.resize_uninitialised(points);
  add_origins(mesh, points);
  mesh.triangles.resize_uninitialised(triangles);
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const Patch& patch = patches[i].patch;
    write_points(patch, places[i], mesh, threads);
    write_strips(patch, places[i], patch.strips(), {mesh.triangles.span()}, threads);
  }
  for (const Seam& seam : *seams) mesh.triangles[seam.laid].n[seam.side] = seam.around;
  if (!mesh.region.empty()) {
    mesh.region.reserve(triangles);
    for (const auto& [region, patch] : patches) mesh.region.resize(mesh.region.size() + patch.triangles(), region);
  }
  return true;
}

}  // namespace pardel::engine
