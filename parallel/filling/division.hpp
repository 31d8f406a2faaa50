// How a mesh with patches is divided into pieces.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../../core/mesh.hpp"
#include "../patches/find_patches.hpp"
#include "../patches/write_strips.hpp"
#include "../threads/threads.hpp"

namespace pardel::engine {

/// Divides the triangles into pieces of consecutive numbers. The triangles around the patches come first, then those of
/// the patches, strip by strip; no strip is divided.
class Division {
 public:
  /// Makes `pieces` > 0 pieces whose sizes differ by about a strip. `around`: the number of triangles around the
  /// patches.
  Division(std::span<const RegionPatch> patches, std::span<const PlacesOfPatch> places, std::size_t around,
           std::size_t pieces);

  [[nodiscard]] std::size_t pieces() const { return cuts_.size() - 1; }
  /// The first triangle of a piece, and the one after its last.
  [[nodiscard]] std::size_t begin_of(std::size_t piece) const { return cuts_[piece]; }
  [[nodiscard]] std::size_t end_of(std::size_t piece) const { return cuts_[piece + 1]; }
  /// The number of triangles of all pieces.
  [[nodiscard]] std::size_t triangles() const { return cuts_.back(); }
  [[nodiscard]] std::uint32_t piece_of(std::size_t triangle) const;

 private:
  std::vector<std::size_t> cuts_;
};

/// A point of the mesh that belongs to a piece.
struct PointOfPiece {
  Index point = 0;
  std::uint32_t piece = 0;
  friend auto operator<=>(const PointOfPiece&, const PointOfPiece&) = default;  // NOLINT(modernize-use-nullptr)
};

/// The points that belong to several pieces, with each of these pieces, in ascending order. `around`: the triangles
/// around the patches, of which the corners are less than `points_around`. Linear in the triangles around the patches
/// and in the rows at which patches are divided.
[[nodiscard]] std::vector<PointOfPiece> shared_points(std::span<const Triangle> around, std::size_t points_around,
                                                      std::span<const RegionPatch> patches,
                                                      std::span<const PlacesOfPatch> places, const Division& division,
                                                      const Threads& threads);

}  // namespace pardel::engine
