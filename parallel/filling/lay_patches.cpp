#include "lay_patches.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "../concurrency/parallel_arrays.hpp"
#include "../construction/flood.hpp"
#include "../construction/remove_triangles.hpp"

namespace pardel::engine {
namespace {

/// An edge on the border of a patch, which lies on its left: a side of a triangle of the patch.
struct BorderEdge {
  VertexId from, to;
  EdgeRef side;
  [[nodiscard]] std::pair<VertexId, VertexId> ends() const { return {from, to}; }
};

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

  /// Writes the triangles, and returns the edges of the border. They have no neighbours yet.
  [[nodiscard]] std::vector<BorderEdge> write_triangles(Triangulation& t, const Threads& threads) const {
    std::vector<std::vector<BorderEdge>> of_strip(patch.strips().size());
    parallel_for(threads, of_strip.size(), [&](std::size_t s, int) { write_strip(t, patch.strips()[s], of_strip[s]); });
    std::vector<BorderEdge> all;
    for (const auto& edges : of_strip) all.insert(all.end(), edges.begin(), edges.end());
    return all;
  }

 private:
  [[nodiscard]] EdgeRef ref(std::size_t number, unsigned side) const {
    return {first_triangle + static_cast<TriangleId>(number), side};
  }

  void write_strip(Triangulation& t, const Strip& strip, std::vector<BorderEdge>& open) const {
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
      for (unsigned side = 0; side < 3; ++side)
        if (slot.n[side].none()) open.push_back({slot.from(side), slot.to(side), ref(number, side)});
      left = middle;
      middle = right;
    }
  }
};

/// Joins each edge of a border to the triangle beyond it. Returns the triangles inside the borders that it loses as
/// neighbours: one for each edge that was found. `old`: the number of triangles without those of the patches.
std::vector<TriangleId> join_borders(Triangulation& t, std::size_t old, std::span<const BorderEdge> edges,
                                     SparseAsk& ask) {
  std::vector<bool> is_border(t.points.size());
  for (const BorderEdge& e : edges) is_border[e.from] = true;
  std::vector<TriangleId> inside;
  for (TriangleId id = 0; id < old; ++id) {
    ask();
    for (unsigned side = 0; side < 3; ++side) {
      const VertexId from = t.slots[id].from(side), to = t.slots[id].to(side);
      if (!is_border[from]) continue;
      const auto edge = std::ranges::lower_bound(edges, std::pair(from, to), {}, &BorderEdge::ends);
      if (edge == edges.end() || edge->ends() != std::pair(from, to)) continue;
      t.link(edge->side, t.slots[id].n[side]);
      t.slots[id].n[side] = EdgeRef();
      inside.push_back(id);
    }
  }
  return inside;
}

}  // namespace

bool lay_patches(Triangulation& t, std::span<const RegionPatch> patches, std::span<const VertexId> border,
                 const Threads& threads) {
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
  std::vector<BorderEdge> edges;
  for (const PlacedPatch& patch : placed) {
    patch.write_points(t, threads);
    const std::vector<BorderEdge> open = patch.write_triangles(t, threads);
    edges.insert(edges.end(), open.begin(), open.end());
  }
  if (!t.region.empty()) {
    t.region.reserve(triangles);
    for (const auto& [region, patch] : patches) t.region.resize(t.region.size() + patch.triangles(), region);
  }

  SparseAsk ask(threads.stop);
  std::ranges::sort(edges, {}, &BorderEdge::ends);
  std::vector<TriangleId> beside_borders = join_borders(t, old, edges, ask);
  if (beside_borders.size() != edges.size()) return false;
  constexpr Index kept = 0, removed = 1;
  Array<Index> label(old, kept);
  flood(t, beside_borders, label, removed, ask);
  const Array<TriangleId> inside = indices_where(threads, old, [&](std::size_t id) { return label[id] == removed; });
  remove_triangles(
      t, inside.span(), [&](TriangleId id) { return id < old && label[id] == removed; },
      [&](TriangleId from, TriangleId to) {
        label[to] = kept;
        if (!t.region.empty()) t.region[to] = t.region[from];
      },
      ask);
  if (!t.region.empty()) t.region.resize(t.slots.size());
  return true;
}

}  // namespace pardel::engine
