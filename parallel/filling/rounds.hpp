// How the patches give way from one round of filling (filled_round.hpp) to the next.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "../patches/find_patches.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// The patches that a round tries: they are cut out before its refinement. If triangles are left that cannot be
/// split because of the patches, the next round tries smaller patches. The number of rounds is bounded.
///
/// The patches give way in small disks around these triangles. Measured: with larger disks, or disks that soon grow,
/// new places get stuck as fast as old ones are cleared, because the border becomes longer. If the number of stuck
/// places stays above its minimum for some rounds, the edges of the patches become shorter: by 0.5 %, later by 1 %, 2
/// %, 4 %. Then triangles between a patch and a segment that are slightly too large for the bound become rarer: just
/// these can seldom be split beside a border.
class Rounds {
 public:
  /// `edges`: the lengths of the edges in the patches of each region that keep the goal; infinity: no patch.
  explicit Rounds(std::vector<double> edges) : edges_(std::move(edges)) {}

  [[nodiscard]] std::span<const double> edges() const { return edges_; }
  [[nodiscard]] std::span<const Clearing> clearings() const { return clearings_; }
  /// The number of rounds that have failed.
  [[nodiscard]] std::uint32_t failed() const { return failed_; }

  /// A round has failed: beside patches with `laid` triangles it has made the mesh `t`, and has left the triangles
  /// `stuck`. Returns false if there shall be no further round.
  [[nodiscard]] bool go_on(const Triangulation& t, std::span<const TriangleId> stuck, std::uint64_t laid);

 private:
  void clear(const Triangulation& t, std::span<const TriangleId> stuck);
  void shorten_edges();

  std::vector<double> edges_;
  std::vector<Clearing> clearings_;
  double radius_ = first_radius, shortening_ = first_shortening;
  std::uint32_t failed_ = 0, idle_ = 0;
  std::uint64_t vertices_ = 0;  ///< of all rounds
  std::size_t fewest_ = SIZE_MAX;

  static constexpr double first_radius = 0.9;  ///< in edges
  static constexpr double first_shortening = 0.995;
};

}  // namespace pardel::engine
