// The order in which the points of a Delaunay triangulation count as inserted.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// The biased randomized insertion order (Amenta, Choi and Rote, "Incremental constructions con BRIO", 2003). The last
/// round holds nearly all points, and each round before it about a sixteenth of the next one. A hash of the position of
/// a point along the Hilbert curve selects its round. In a round, points are in the order of their positions. So the
/// order depends on the points alone, not on their order in the input or on their scale.
class InsertionOrder {
 public:
  static constexpr std::size_t rounds = 8;

  /// Vertex v has the position v on the curve.
  InsertionOrder() = default;
  /// The vertices below `own` have consecutive positions, from `first` on; append() tells those of the others.
  InsertionOrder(std::uint64_t first, Index own) : first_(first), own_(own) {}
  /// The position of the next vertex, in the order of vertices.
  void append(std::uint64_t position) { others_.push_back(position); }

  [[nodiscard]] std::uint64_t position(VertexId v) const { return v < own_ ? first_ + v : others_[v - own_]; }
  [[nodiscard]] static std::size_t round_of(std::uint64_t position) {
    const auto level = static_cast<std::size_t>(std::countr_zero(random_bits(position + 1)) / 4);
    return rounds - 1 - std::min(rounds - 1, level);
  }
  /// The time of an insertion: a number that is greater for vertices that come later. Precondition: fewer than 2^61
  /// points.
  [[nodiscard]] std::uint64_t time(VertexId v) const { return time_of(position(v)); }
  [[nodiscard]] static std::uint64_t time_of(std::uint64_t position) { return time_of(round_of(position), position); }
  /// `round`: that of the position.
  [[nodiscard]] static std::uint64_t time_of(std::size_t round, std::uint64_t position) {
    return std::uint64_t{round} << 61U | position;
  }

 private:
  /// A bijection whose output bits serve as random bits. Do not replace it by `mixed` (core/support/hash.hpp): it
  /// determines the order of insertion, and therefore the numbering of every mesh.
  static std::uint64_t random_bits(std::uint64_t h) {
    h = (h ^ h >> 32U) * 0xd6e8feb86659fd93U;
    h = (h ^ h >> 32U) * 0xd6e8feb86659fd93U;
    return h ^ h >> 32U;
  }

  std::uint64_t first_ = 0;
  Index own_ = no_index;
  std::vector<std::uint64_t> others_;
};

/// The order if each vertex has its index as its position.
inline const InsertionOrder order_of_indices;

/// Does a fourth vertex lie in the circumdisk of a triangle if no four vertices are cocircular? If four are, the latest
/// of them counts as outside the circle of the other three, as if its height on the paraboloid were increased by an
/// amount that is tiny, but large compared with those of all earlier vertices (THEORY_OF_RANKS.md, GivenPoints).
/// `v`: the corners, counter-clockwise, none of them the ghost. Precondition: the four are cocircular. False if the
/// fourth vertex has the place of a corner. Exact.
[[nodiscard]] bool counts_as_inside(const Triangulation& t, const std::array<VertexId, 3>& v, VertexId fourth,
                                    const InsertionOrder& order);

}  // namespace pardel::engine
