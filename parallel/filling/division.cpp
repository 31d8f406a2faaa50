#include "division.hpp"

#include <algorithm>
#include <utility>

#include "../threads/parallel_for.hpp"

namespace pardel::engine {
namespace {

/// The number from which a piece may start: `wanted`, or the end of the strip that contains it.
std::size_t place_of_cut(std::span<const RegionPatch> patches, std::span<const PlacesOfPatch> places,
                         std::size_t wanted) {
  for (std::size_t i = patches.size(); i-- > 0;) {
    if (wanted < places[i].first_triangle) continue;
    const std::span<const Strip> strips = patches[i].patch.strips();
    const auto next = std::ranges::lower_bound(strips, wanted - places[i].first_triangle, {}, &Strip::first);
    return places[i].first_triangle + (next == strips.end() ? patches[i].patch.triangles() : next->first);
  }
  return wanted;
}

/// Collects the points that belong to several pieces.
class Sharing {
 public:
  Sharing(std::size_t points_around, const Division& division)
      : first_piece_(points_around, none), division_(division) {}

  /// A point around the patches belongs to the piece of this triangle.
  void add(Index point, std::size_t triangle) {
    const std::uint32_t piece = division_.piece_of(triangle);
    std::uint32_t& first = first_piece_[point];
    if (first == none) first = piece;
    add(point, first, piece);
  }
  void add(Index point, std::uint32_t a, std::uint32_t b) {
    if (a == b) return;
    shared_.push_back({point, a});
    shared_.push_back({point, b});
  }
  [[nodiscard]] std::vector<PointOfPiece> take() {
    std::ranges::sort(shared_);
    shared_.erase(std::unique(shared_.begin(), shared_.end()), shared_.end());
    return std::move(shared_);
  }

 private:
  static constexpr std::uint32_t none = UINT32_MAX;
  std::vector<std::uint32_t> first_piece_;  ///< per point around the patches
  const Division& division_;
  std::vector<PointOfPiece> shared_;
};

/// The rows in which inner points of the patch can belong to several pieces: those at the strips with which pieces
/// start. Ascending.
std::vector<int> rows_at_cuts(const Patch& patch, const PlacesOfPatch& places, const Division& division) {
  std::vector<int> rows;
  for (std::size_t piece = 1; piece < division.pieces(); ++piece) {
    const std::size_t cut = division.begin_of(piece);
    if (cut <= places.first_triangle || cut >= places.first_triangle + patch.triangles()) continue;
    const auto strip = std::ranges::lower_bound(patch.strips(), cut - places.first_triangle, {}, &Strip::first);
    rows.push_back(strip->row);
    rows.push_back(strip->row + 1);
  }
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

}  // namespace

Division::Division(std::span<const RegionPatch> patches, std::span<const PlacesOfPatch> places, std::size_t around,
                   std::size_t pieces) {
  std::size_t triangles = around;
  for (const auto& [region, patch] : patches) triangles += patch.triangles();
  for (std::size_t piece = 0; piece < pieces; ++piece)
    cuts_.push_back(place_of_cut(patches, places, triangles / pieces * piece + triangles % pieces * piece / pieces));
  cuts_.push_back(triangles);
}

std::uint32_t Division::piece_of(std::size_t triangle) const {
  return static_cast<std::uint32_t>(std::ranges::upper_bound(cuts_, triangle) - cuts_.begin() - 1);
}

std::vector<PointOfPiece> shared_points(std::span<const Triangle> around, std::size_t points_around,
                                        std::span<const RegionPatch> patches, std::span<const PlacesOfPatch> places,
                                        const Division& division, const Threads& threads) {
  Sharing sharing(points_around, division);
  SparseAsk ask(threads.stop);
  for (std::size_t id = 0; id < around.size(); ++id) {
    ask();
    for (const Index v : around[id].v) sharing.add(v, id);
  }
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const Patch& patch = patches[i].patch;
    for (const Piece& points : patch.pieces()) {
      if (!points.on_border) continue;
      ask();
      auto point = static_cast<Index>(places[i].first_border + points.first);
      for (int x = points.low; x <= points.high; x += 2, ++point)
        patch.for_each_triangle_at(
            x, points.row, [&](std::size_t triangle) { sharing.add(point, places[i].first_triangle + triangle); });
    }
    for (const int row : rows_at_cuts(patch, places[i], division))
      for (const Piece& points : patch.pieces_of(row)) {
        if (points.on_border) continue;
        ask();
        auto point = static_cast<Index>(places[i].first_inner + points.first);
        for (int x = points.low; x <= points.high; x += 2, ++point) {
          std::uint32_t first = UINT32_MAX;
          patch.for_each_triangle_at(x, row, [&](std::size_t triangle) {
            const std::uint32_t piece = division.piece_of(places[i].first_triangle + triangle);
            if (first == UINT32_MAX) first = piece;
            sharing.add(point, first, piece);
          });
        }
      }
  }
  return sharing.take();
}

}  // namespace pardel::engine
