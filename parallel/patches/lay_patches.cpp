#include "lay_patches.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "../concurrency/parallel_arrays.hpp"

namespace pardel::engine {
namespace {

/// Finds the vertices at places of a row. The places that are asked for ascend.
class RowCursor {
 public:
  RowCursor(std::span<const Piece> pieces, std::span<const VertexId> border, VertexId first_inner)
      : piece_(pieces.begin()), end_(pieces.end()), border_(border), first_inner_(first_inner) {}
  [[nodiscard]] VertexId at(int x) {
    while (piece_ + 1 != end_ && x > piece_->high) ++piece_;
    const std::size_t number = piece_->first + static_cast<std::size_t>(x - piece_->low) / 2;
    return piece_->on_border ? border_[number] : first_inner_ + static_cast<VertexId>(number);
  }

 private:
  std::span<const Piece>::iterator piece_, end_;
  std::span<const VertexId> border_;
  VertexId first_inner_;
};

/// Finds the triangles of strips between two rows. The places that are asked for ascend.
class StripCursor {
 public:
  explicit StripCursor(std::span<const Strip> strips) : strip_(strips.begin()), end_(strips.end()) {}
  /// The number of the triangle at x in its patch, if there is one.
  [[nodiscard]] std::optional<std::size_t> at(int x) {
    while (strip_ != end_ && x > strip_->high) ++strip_;
    if (strip_ == end_ || x < strip_->low) return std::nullopt;
    return strip_->first + static_cast<std::size_t>(x - strip_->low);
  }

 private:
  std::span<const Strip>::iterator strip_, end_;
};

/// A patch, and where its points and triangles are in the triangulation.
struct PlacedPatch {
  const Patch& patch;
  std::span<const VertexId> border;
  VertexId first_inner;
  TriangleId first_triangle;

  void write_points(Triangulation& t, const Threads& threads) const {
    parallel_for(threads, patch.pieces().size(), [&](std::size_t i, int) {
      const Piece& piece = patch.pieces()[i];
      if (piece.on_border) return;
      const std::size_t first = first_inner + piece.first;
      for (std::size_t k = 0; k < piece.count(); ++k) {
        t.points[first + k] = patch.lattice().at(piece.low + 2 * static_cast<int>(k), piece.row);
        t.origin[first + k] = interior_vertex;
      }
    });
  }

  /// Writes the triangles. Sides on the border get no neighbours.
  void write_triangles(Triangulation& t, const Threads& threads) const {
    parallel_for(threads, patch.strips().size(), [&](std::size_t s, int) { write_strip(t, patch.strips()[s]); });
  }

 private:
  [[nodiscard]] EdgeRef ref(std::size_t number, unsigned side) const {
    return {first_triangle + static_cast<TriangleId>(number), side};
  }

  void write_strip(Triangulation& t, const Strip& strip) const {
    const int row = strip.row;
    RowCursor lower(patch.pieces_of(row), border, first_inner), upper(patch.pieces_of(row + 1), border, first_inner);
    StripCursor below(patch.strips_above(row - 1)), above(patch.strips_above(row + 1));
    const auto stands = [&](int x) { return ((x ^ row) & 1) == 0; };
    const auto vertex = [&](int x) { return stands(x) ? lower.at(x) : upper.at(x); };
    VertexId left = vertex(strip.low), middle = vertex(strip.low + 1);
    std::size_t number = strip.first;
    for (int x = strip.low; x <= strip.high; ++x, ++number) {
      const VertexId right = vertex(x + 2);
      const EdgeRef before = x > strip.low ? ref(number - 1, stands(x) ? 2 : 0) : EdgeRef();
      const EdgeRef after = x < strip.high ? ref(number + 1, 1) : EdgeRef();
      Slot slot;
      if (stands(x)) {
        const auto across = below.at(x);
        slot = {{left, right, middle}, {after, before, across ? ref(*across, 0) : EdgeRef()}};
      } else {
        const auto across = above.at(x);
        slot = {{middle, right, left}, {across ? ref(*across, 2) : EdgeRef(), before, after}};
      }
      t.slots[first_triangle + number] = slot;
      left = middle;
      middle = right;
    }
  }
};

/// Joins the triangles before `old`, those around the patches, to the patches. Returns the number of edges joined.
std::size_t join_borders(Triangulation& t, std::size_t old, std::span<const BorderEdge> edges, SparseAsk& ask) {
  std::size_t joined = 0;
  for (TriangleId id = 0; id < old; ++id) {
    ask();
    for (unsigned side = 0; side < 3; ++side) {
      if (!t.on_border_of_patch(EdgeRef(id, side))) continue;
      const std::pair seen_from_patch{t.slots[id].to(side), t.slots[id].from(side)};
      const auto edge = std::ranges::lower_bound(edges, seen_from_patch, {}, &BorderEdge::ends);
      if (edge == edges.end() || edge->ends() != seen_from_patch) continue;
      t.link(EdgeRef(id, side), EdgeRef(static_cast<TriangleId>(old + edge->triangle), edge->side));
      ++joined;
    }
  }
  return joined;
}

}  // namespace

bool lay_patches(Triangulation& t, std::span<const RegionPatch> patches, std::span<const VertexId> border,
                 std::span<const BorderEdge> edges, const Threads& threads) {
  const std::size_t old = t.slots.size();
  std::vector<PlacedPatch> placed;
  std::size_t borders = 0, points = t.points.size(), triangles = old;
  for (const auto& [region, patch] : patches) {
    placed.push_back({patch, border.subspan(borders, patch.border_points()), static_cast<VertexId>(points),
                      static_cast<TriangleId>(triangles)});
    borders += patch.border_points();
    points += patch.inner_points();
    triangles += patch.triangles();
  }
  t.points.resize_uninitialised(points);
  t.origin.resize_uninitialised(points);
  t.slots.resize_uninitialised(triangles);
  for (const PlacedPatch& patch : placed) {
    patch.write_points(t, threads);
    patch.write_triangles(t, threads);
  }
  if (!t.region.empty()) {
    t.region.reserve(triangles);
    for (const auto& [region, patch] : patches) t.region.resize(t.region.size() + patch.triangles(), region);
  }
  SparseAsk ask(threads.stop);
  const bool all_joined = join_borders(t, old, edges, ask) == edges.size();
  for (const VertexId v : border) t.origin[v] = interior_vertex;
  return all_joined;
}

}  // namespace pardel::engine
