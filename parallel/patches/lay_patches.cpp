#include "lay_patches.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "../concurrency/parallel_arrays.hpp"

namespace pardel::engine {
namespace {

/// Finds the points at places of a row. The places that are asked for ascend.
class RowCursor {
 public:
  RowCursor(std::span<const Piece> pieces, Index first_border, Index first_inner)
      : piece_(pieces.begin()), end_(pieces.end()), first_border_(first_border), first_inner_(first_inner) {}
  [[nodiscard]] Index at(int x) {
    while (piece_ + 1 != end_ && x > piece_->high) ++piece_;
    const std::size_t number = piece_->first + static_cast<std::size_t>(x - piece_->low) / 2;
    return (piece_->on_border ? first_border_ : first_inner_) + static_cast<Index>(number);
  }

 private:
  std::span<const Piece>::iterator piece_, end_;
  Index first_border_, first_inner_;
};

/// Finds the triangles of strips between two rows. The places that are asked for ascend.
class StripCursor {
 public:
  /// The triangles of the patch are numbered from `first_triangle`.
  StripCursor(std::span<const Strip> strips, Index first_triangle)
      : strip_(strips.begin()), end_(strips.end()), first_triangle_(first_triangle) {}
  /// The triangle at x, or no_index if there is none.
  [[nodiscard]] Index at(int x) {
    while (strip_ != end_ && x > strip_->high) ++strip_;
    if (strip_ == end_ || x < strip_->low) return no_index;
    return first_triangle_ + static_cast<Index>(strip_->first) + static_cast<Index>(x - strip_->low);
  }

 private:
  std::span<const Strip>::iterator strip_, end_;
  Index first_triangle_;
};

/// A patch, and where its points and triangles are in the mesh.
struct PlacedPatch {
  const Patch& patch;
  Index first_border;
  Index first_inner;
  Index first_triangle;

  void write_points(Mesh& mesh, const Threads& threads) const {
    parallel_for(threads, patch.pieces().size(), [&](std::size_t i, int) {
      const Piece& piece = patch.pieces()[i];
      if (piece.on_border) return;
      const std::size_t first = first_inner + piece.first;
      for (std::size_t k = 0; k < piece.count(); ++k) {
        mesh.points[first + k] = patch.lattice().at(piece.low + 2 * static_cast<int>(k), piece.row);
        mesh.origin[first + k] = interior_vertex;
      }
    });
  }

  /// Writes the triangles. Sides on the border get no neighbours.
  void write_triangles(Mesh& mesh, const Threads& threads) const {
    parallel_for(threads, patch.strips().size(), [&](std::size_t s, int) { write_strip(mesh, patch.strips()[s]); });
  }

 private:
  void write_strip(Mesh& mesh, const Strip& strip) const {
    const int row = strip.row;
    RowCursor lower(patch.pieces_of(row), first_border, first_inner);
    RowCursor upper(patch.pieces_of(row + 1), first_border, first_inner);
    StripCursor below(patch.strips_above(row - 1), first_triangle), above(patch.strips_above(row + 1), first_triangle);
    const auto stands = [&](int x) { return ((x ^ row) & 1) == 0; };
    const auto point = [&](int x) { return stands(x) ? lower.at(x) : upper.at(x); };
    Index left = point(strip.low), middle = point(strip.low + 1);
    Index id = first_triangle + static_cast<Index>(strip.first);
    for (int x = strip.low; x <= strip.high; ++x, ++id) {
      const Index right = point(x + 2);
      const Index before = x > strip.low ? id - 1 : no_index;
      const Index after = x < strip.high ? id + 1 : no_index;
      if (stands(x))
        mesh.triangles[id] = {{left, right, middle}, {after, before, below.at(x)}};
      else
        mesh.triangles[id] = {{middle, right, left}, {above.at(x), before, after}};
      left = middle;
      middle = right;
    }
  }
};

/// Joins the triangles before `old`, those around the patches, to the patches. Returns the number of edges joined.
std::size_t join_borders(Mesh& mesh, std::size_t old, std::span<const BorderEdge> edges, SparseAsk& ask) {
  std::size_t joined = 0;
  for (Index id = 0; id < old; ++id) {
    ask();
    for (unsigned side = 0; side < 3; ++side) {
      Triangle& beside = mesh.triangles[id];
      if (beside.n[side] != no_index) continue;
      const std::pair seen_from_patch{beside.v[previous_corner[side]], beside.v[next_corner[side]]};
      const auto edge = std::ranges::lower_bound(edges, seen_from_patch, {}, &BorderEdge::ends);
      if (edge == edges.end() || edge->ends() != seen_from_patch) continue;
      const Index laid = static_cast<Index>(old + edge->triangle);
      beside.n[side] = laid;
      mesh.triangles[laid].n[edge->side] = id;
      ++joined;
    }
  }
  return joined;
}

}  // namespace

bool lay_patches(Mesh& mesh, std::span<const RegionPatch> patches, Index first_border, const Threads& threads) {
  const std::size_t old = mesh.triangles.size();
  std::vector<PlacedPatch> placed;
  std::size_t border_end = first_border, points = mesh.points.size(), triangles = old;
  for (const auto& [region, patch] : patches) {
    placed.push_back(
        {patch, static_cast<Index>(border_end), static_cast<Index>(points), static_cast<Index>(triangles)});
    border_end += patch.border_points();
    points += patch.inner_points();
    triangles += patch.triangles();
  }
  mesh.points.resize_uninitialised(points);
  mesh.origin.resize_uninitialised(points);
  mesh.triangles.resize_uninitialised(triangles);
  for (const PlacedPatch& patch : placed) {
    patch.write_points(mesh, threads);
    patch.write_triangles(mesh, threads);
  }
  if (!mesh.region.empty()) {
    mesh.region.reserve(triangles);
    for (const auto& [region, patch] : patches) mesh.region.resize(mesh.region.size() + patch.triangles(), region);
  }
  std::vector<VertexId> border(border_end - first_border);
  std::iota(border.begin(), border.end(), first_border);
  std::ranges::fill(mesh.origin.span().subspan(first_border, border.size()), interior_vertex);
  const std::vector<BorderEdge> edges = border_edges(patches, border);
  SparseAsk ask(threads.stop);
  return join_borders(mesh, old, edges, ask) == edges.size();
}

}  // namespace pardel::engine
